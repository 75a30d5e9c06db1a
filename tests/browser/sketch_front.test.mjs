// The page of `cognate sketch`: the front of error against transmission angle.
import assert from "node:assert/strict";
import { assertFits } from "./browser.mjs";
import { rarely as test, some } from "./thinned.mjs";
import { couplerPose, leastTransmission } from "./closures.mjs";
import { addressOf, answered, draw, facts, hold, holding, letGo, offered, put, settled, SIX, visit } from "./sketching.mjs";

const heart = (t) => [0.45 + 0.14 * Math.cos(t) + 0.05 * Math.cos(2 * t), 0.45 - 0.17 * Math.sin(t) - 0.05 * Math.sin(2 * t)];
const PATIENCE = { timeout: 240000 };

const noteIs = (page, words) => page.waitForFunction((text) => new RegExp(text).test(document.getElementById("front-note").textContent), words, PATIENCE);
const ended = (page) => noteIs(page, "^The least error");
const points = (page) => page.locator(".front-point").evaluateAll((all) => all.map(({ dataset }) => ({ level: Number(dataset.level), angle: Number(dataset.angle), error: Number(dataset.error) })));
const pointAt = (page, level) => page.locator(`.front-point[data-level="${level}"]`);
const limit = (page) => page.locator("#least").inputValue();
const hasFocus = (mark) => mark.evaluate((one) => one === document.activeElement);
const chosenFact = (page, name) => page.locator(`.design-card:has(:checked) [data-fact=${name}]`).evaluate((one) => JSON.parse(one.dataset.value));

function assertRises(front) {
  assert.ok(front.length >= 2, `${front.length} points`);
  front.forEach(({ angle, error }, i) => assert.ok(i === 0 || (angle > front[i - 1].angle && error > front[i - 1].error), JSON.stringify(front)));
}

test("a point of the front is looked at and taken by keys, kept in the address, and undone", () => visit({ prepare: holding }, async (page) => {
  await draw(page, heart);
  await ended(page);
  const front = await points(page);
  assertRises(front);
  assert.equal(await page.locator("#front .axis").count(), 2);
  // Of the points the Tab key reaches one: that of the design chosen, which is the best for the limit.
  const at = page.locator(".front-point[tabindex='0']");
  assert.equal(await at.count(), 1);
  assert.equal(await at.getAttribute("aria-pressed"), "true");
  assert.equal(Number(await at.getAttribute("data-error")), await chosenFact(page, "rms"));
  await at.focus();
  assert.equal(await page.locator(".looked-at").count(), 0);
  await page.keyboard.press("End");
  assert.equal(await page.locator(".looked-at").count(), 1);
  await page.keyboard.press("ArrowLeft");
  const { level, angle, error } = front.at(-2);
  const read = await page.locator("#front-reading").textContent();
  assert.match(read, new RegExp(`^${angle.toFixed(1)}°, RMS error ${Number(error.toPrecision(3))} `));
  // What stands at once does not depend on how soon the next search answers.
  await hold(page);
  const mark = await pointAt(page, level).elementHandle();
  await page.keyboard.press("Enter");
  assert.equal(await limit(page), String(level));
  assert.equal(await page.locator(".looked-at").count(), 0);
  assert.ok(await hasFocus(mark));
  assert.deepEqual([await chosenFact(page, "rms"), await chosenFact(page, "least")], [error, angle]);
  assert.ok(page.url().includes(`&l=any,${level},3`));
  const taken = addressOf(page);
  assert.ok(Math.abs(taken.rms - error) < 1e-9 && leastTransmission(taken, taken.cranks) > level - 1e-3);
  // The front is still there; and the search for the new limit finds nothing better, which takes long.
  assert.equal((await points(page)).length, front.length);
  if (process.env.WHOLE) {
    await letGo(page);
    await settled(page);
    assert.ok(await hasFocus(mark));
    assert.deepEqual(addressOf(page), taken);
    assert.ok((await facts(page, "rms"))[0] >= 0.999 * error);
    await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
      await settled(again);
      assert.deepEqual(addressOf(again), taken);
    });
  }
  await hold(page);
  await page.keyboard.press("Control+z");
  assert.equal(await limit(page), "30");
  assert.equal((await points(page)).length, front.length);
  await page.keyboard.press("Control+Shift+z");
  await letGo(page);
  await offered(page);
  assert.equal(await limit(page), String(level));
  assert.ok(await chosenFact(page, "rms") <= error * (1 + 1e-6));
}));

test("where a point with the focus is beaten, the focus and the linkage looked at are those of the next", () => visit({ prepare: holding }, async (page) => {
  await draw(page, heart);
  await ended(page);
  const front = await points(page), [before, beaten, next] = front.slice(-3);
  await pointAt(page, beaten.level).focus();
  await hold(page);
  await page.evaluate(() => {
    const slider = document.getElementById("least");
    slider.value = 10;
    slider.dispatchEvent(new Event("change", { bubbles: true }));
  });
  // The design of the next point, said to miss by less than this one.
  await page.evaluate(({ angle, error, less }) => {
    const [{ worker, message }] = window.held, entry = window.told.flatMap(({ answer }) => answer?.designs ?? []).find((one) => one.transmission_acute_min_deg === angle && one.rms === error);
    worker.onmessage({ data: { id: message.id, answer: { designs: [{ ...entry, rms: less }] } } });
  }, { ...next, less: (before.error + beaten.error) / 2 });
  assert.deepEqual((await points(page)).map(({ level }) => level), [...front.slice(0, -2), next].map(({ level }) => level));
  assert.ok(await hasFocus(await pointAt(page, next.level).elementHandle()));
  assert.equal(await page.locator(".front-point[tabindex='0']").getAttribute("data-level"), String(next.level));
  assert.equal(await page.locator(".looked-at").count(), 1);
  assert.ok((await page.locator("#front-reading").textContent()).startsWith(`${next.angle.toFixed(1)}°, `));
  await page.keyboard.press("ArrowLeft");
  assert.ok(await hasFocus(await pointAt(page, before.level).elementHandle()));
}));

// How far the targets are missed, as the errors of the page count it.
function errorOf(design) {
  const mean = [0, 1].map((k) => design.points.reduce((sum, p) => sum + p[k], 0) / design.points.length);
  const weight = Math.hypot(...design.points.map((p) => Math.hypot(p[0] - mean[0], p[1] - mean[1]))) / Math.sqrt(design.points.length);
  const each = design.points.map(([x, y, degrees], i) => {
    const { at, direction } = couplerPose(design, (design.cranks[i] * Math.PI) / 180);
    const turned = degrees === undefined ? 0 : direction + ((design.body - degrees) * Math.PI) / 180;
    return Math.hypot(at[0] - x, at[1] - y, weight * Math.atan2(Math.sin(turned), Math.cos(turned)));
  });
  return Math.hypot(...each) / Math.sqrt(each.length);
}

for (const [name, drawn] of [["poses", (page) => put(page, SIX)], ["a curve", (page) => draw(page, heart, [0.3, 3.9])]]) {
  test(`each point of the front of ${name} is what it says, and the program finds hardly better`, () => visit({}, async (page) => {
    await drawn(page);
    await ended(page);
    const front = await points(page), better = [];
    assertRises(front);
    for (const { level, angle, error } of front) {
      await pointAt(page, level).click();
      const design = addressOf(page);
      assert.ok(Math.abs(leastTransmission(design, design.cranks) - angle) < 1e-3, `${leastTransmission(design, design.cranks)} against ${angle}`);
      assert.ok(Math.abs(errorOf(design) - error) < 1e-5 * error + 1e-6, `${errorOf(design)} against ${error}`);
      await page.locator("[data-take=copy_problem]").click();
      const result = await answered("solve", await page.locator("#taken").inputValue());
      const [{ error: { rms } }] = result.designs;
      assert.deepEqual(result.problem.constraints.transmission_angle_deg, [level, 180 - level]);
      if (result.status === "solved" && rms < 0.99 * error) better.push(`${rms} against ${error} from ${level}`);
      await page.locator("[data-take=copy_design]").click();
      const { designs: [{ metrics }] } = await answered("analyze", await page.locator("#taken").inputValue());
      assert.equal(metrics.class, await chosenFact(page, "class"));
    }
    assert.ok(better.length <= 1, better.join("; "));
  }));
}

test("a point of the front that has the focus goes with its kind of drawing", () => visit({}, async (page) => {
  await draw(page, heart);
  await page.waitForFunction(() => document.querySelectorAll(".front-point").length > 1, null, PATIENCE);
  for (const kind of ["of-function", "of-line", "of-function"]) {
    const front = page.locator(".front-point:not([aria-pressed='true'])");
    await front.first().focus();
    assert.equal(await page.locator(".looked-at").count(), 1);
    await page.evaluate((id) => document.getElementById(id).click(), kind);
    assert.equal(await page.locator(`#${kind}`).getAttribute("aria-pressed"), "true");
    assert.equal(await page.locator(".looked-at").count(), 0);
    assert.ok(await page.locator("#hint").isVisible());
    // Back to the curve, with its front.
    await page.keyboard.press("Control+z");
    await page.waitForFunction(() => document.querySelectorAll(".front-point").length > 1, null, PATIENCE);
  }
}));

test("a front goes with its drawing, and comes anew for the next", () => visit({}, async (page) => {
  await draw(page, heart);
  await ended(page);
  const before = await points(page);
  const at = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 40, at.y - 30, { steps: 4 });
  assert.ok(await page.locator("#front").isHidden());
  await page.mouse.up();
  await noteIs(page, "^Follows the search");
  assert.ok(await page.locator("#front-plot").isHidden());
  await ended(page);
  const after = await points(page);
  assertRises(after);
  assert.notDeepEqual(after, before);
  // A limit ends the search at once; what was found for the front stays.
  await page.locator("#class").selectOption("crank-rocker");
  await settled(page);
  await page.waitForFunction(() => document.querySelectorAll(".front-point").length > 1, null, PATIENCE);
  await page.locator("#least").fill("40");
  assert.ok((await page.locator(".front-point").count()) > 1);
  await page.waitForFunction(() => /searching/i.test(document.getElementById("state").textContent));
}));

test("where one design is the best, or there is none, the page says so", () => visit({}, async (page) => {
  await put(page, SIX.slice(0, 3));
  await noteIs(page, "^One design has the least error, 0 ");
  assert.ok(await page.locator("#front-plot").isHidden());
  await page.locator("#least").fill("70");
  await offered(page);
  assert.ok((await facts(page, "least"))[0] >= 70 - 1e-6);
  // A box in which there is no room for a frame as long as links must be.
  await visit({ hash: "#p=-30,0;-25,8;-18,9;-12,2;-20,-8&o=closed,points&l=any,30,1&b=50,30,50.1,30.1" }, async (other) => {
    await noteIs(other, "^Within the other limits there is no design with a transmission angle of 10° or more");
    assert.ok(await other.locator("#front-plot").isHidden());
    await other.locator("#clear").click();
    assert.ok(await other.locator("#front").isHidden());
  });
}));

for (const options of some([{ size: "phone", scheme: "dark", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`the front fits, and is taken by touch: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await draw(page, heart);
    await page.waitForFunction(() => document.querySelectorAll(".front-point").length > 1, null, PATIENCE);
    await assertFits(page);
    if (options.locale) assert.doesNotMatch(await page.locator("main").innerText(), /[A-Za-z]{5}/);
    await page.locator("#front-plot").scrollIntoViewIfNeeded();
    // All at once: the front may go on meanwhile, and has other marks then.
    const { level, mark } = await page.evaluate(() => { const last = [...document.querySelectorAll(".front-point")].at(-1); return { level: last.dataset.level, mark: last.getBoundingClientRect().toJSON() }; });
    if (options.size === "phone") await page.touchscreen.tap(mark.x + mark.width / 2, mark.y + mark.height / 2); else await page.mouse.click(mark.x + 4, mark.y + 4);
    assert.equal(await limit(page), level);
  }));
}
