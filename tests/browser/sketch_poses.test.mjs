// The page of `cognate sketch`: poses are put, turned and moved, and linkages guide a body through them.
import assert from "node:assert/strict";
import { assertFits, distance } from "./browser.mjs";
import { rarely as test, some, wholeOnly } from "./thinned.mjs";
import { couplerPose } from "./closures.mjs";
import { addressOf, answered, facts, offered, put, settled, SIX, targets, visit } from "./sketching.mjs";

const RADIANS = Math.PI / 180;
// By shares of the picture: where the body is, and how far the hand goes from there in its direction.
const FOUR = [[0.2, 0.6, 0.1, 0], [0.35, 0.4, 0.08, -0.04], [0.55, 0.3, 0.05, -0.08], [0.75, 0.35, 0, -0.1]];

// How far the body of the design is from its poses, and by which angle, at the crank angles of the address.
function misses(design) {
  return design.points.map(([x, y, degrees], i) => {
    const { at, direction } = couplerPose(design, design.cranks[i] * RADIANS);
    const turned = direction / RADIANS + design.body - degrees;
    return { away: distance(at, [x, y]), turned: Math.abs(turned - 360 * Math.round(turned / 360)) };
  });
}

// The root mean squared distance of the poses from their mean place: what a radian counts.
function weightOf(points) {
  const mean = [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  return Math.sqrt(points.reduce((sum, p) => sum + distance(p, mean) ** 2, 0) / points.length);
}

for (const [name, poses] of some([["two", FOUR.slice(0, 2)], ["four", FOUR], ["three", FOUR.slice(1)], ["six", SIX]])) {
  test(`through ${name} poses designs are found whose bodies come as near as is said`, () => visit({}, async (page) => {
    await put(page, poses);
    await settled(page);
    assert.equal(await targets(page), poses.length);
    const design = addressOf(page), missed = misses(design);
    const [error] = await facts(page, "rms"), [turned] = await facts(page, "angle");
    const weight = weightOf(design.points), each = missed.map((one) => Math.hypot(one.away, weight * one.turned * RADIANS));
    assert.ok(Math.abs(Math.hypot(...each) / Math.sqrt(each.length) - error) < 1e-6, `${each} against ${error}`);
    assert.ok(Math.abs(Math.max(...missed.map((one) => one.turned)) - turned) < 1e-5);
    if (poses.length < 5) assert.ok(error < 1e-9, `${error}`);
    for (const least of await facts(page, "least")) assert.ok(least >= 30 - 1e-6);
    await page.locator("[data-take=copy_problem]").click();
    const result = await answered("solve", await page.locator("#taken").inputValue());
    assert.equal(result.status, "solved", JSON.stringify(result).slice(0, 1000));
    await page.locator("[data-take=copy_design]").click();
    assert.equal((await answered("analyze", await page.locator("#taken").inputValue())).designs.length, 1);
    if (poses.length > 5) assert.ok(error <= 1.01 * result.designs[0].error.rms);
  }));
}

test("a pose is moved and turned by hand and by keys, and every step undone", () => visit({}, async (page) => {
  await put(page, SIX);
  await offered(page);
  const drawn = addressOf(page).points;
  await page.locator('[data-turn="1"]').focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("ArrowRight");
  await offered(page);
  assert.equal(addressOf(page).points[1][2], drawn[1][2] + 9);
  const tip = await page.locator('[data-turn="4"]').boundingBox();
  await page.mouse.move(tip.x + tip.width / 2, tip.y + tip.height / 2);
  await page.mouse.down();
  await page.mouse.move(tip.x + 60, tip.y + 20, { steps: 6 });
  await page.mouse.up();
  const at = await page.locator('[data-target="0"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x - 10, at.y + 20, { steps: 6 });
  await page.mouse.up();
  await offered(page);
  const moved = addressOf(page);
  assert.notEqual(moved.points[4][2], drawn[4][2]);
  assert.notDeepEqual(moved.points[0].slice(0, 2), drawn[0].slice(0, 2));
  assert.ok(Math.max(...misses(moved).map((one) => one.away)) <= moved.max + 1e-6);
  await page.locator('[data-target="5"]').focus();
  await page.keyboard.press("Delete");
  assert.equal(await targets(page), 5);
  assert.equal(await page.locator("[data-turn]").count(), 5);
  for (let i = 0; i < 5; ++i) await page.keyboard.press("Control+z");
  await offered(page);
  assert.deepEqual(addressOf(page).points, drawn);
}));

test("while a pose is dragged the designs follow", () => visit({}, async (page) => {
  await put(page, SIX);
  await offered(page);
  const before = await facts(page, "rms"), at = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 20, at.y - 15);
  await page.waitForFunction((rms) => { const card = document.querySelector("[data-fact=rms]"); return card && card.dataset.value !== String(rms); }, before[0]);
  const followed = await facts(page, "rms");
  await page.mouse.up();
  await settled(page);
  // What follows is a design, which a whole search does not fall behind.
  assert.ok((await facts(page, "rms"))[0] <= followed[0] * (1 + 1e-9));
}));

test("a design that was chosen follows a drag, also while a search still runs", () => visit({}, async (page) => {
  await put(page, SIX);
  await settled(page);
  await page.locator("#design-1").check();
  const chosen = (await facts(page, "rms"))[1];
  const at = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 40, at.y - 30);
  await page.waitForFunction((rms) => [...document.querySelectorAll("[data-fact=rms]")].every((one) => one.dataset.value !== String(rms)), chosen);
  await page.mouse.up();
  // The drop has begun a search anew: the next drag does not wait for its end.
  await page.waitForFunction(() => /searching/.test(document.getElementById("state").textContent));
  const again = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(again.x + again.width / 2, again.y + again.height / 2);
  await page.mouse.down();
  await page.mouse.move(again.x - 20, again.y + 10);
  await page.waitForFunction(() => /^[0-9]+ designs? after [^;]*\.$/.test(document.getElementById("state").textContent));
  await page.mouse.up();
  await offered(page);
  const design = addressOf(page);
  assert.ok(Math.max(...misses(design).map((one) => one.away)) <= design.max + 1e-6);
}));

test("of one pose in an address there is no design, whatever was searched for before", () => visit({}, async (page) => {
  await put(page, FOUR);
  await page.evaluate(() => { location.hash = "#p=5,5,-350"; });
  await page.waitForFunction(() => document.querySelectorAll("[data-turn]").length === 1);
  assert.equal(await page.locator("[data-turn]").getAttribute("aria-valuenow"), "10");
  await page.waitForTimeout(1500);
  assert.equal(await page.locator(".design-card").count(), 0);
  assert.equal(await page.locator("#state").textContent(), "At least 2 poses are needed.");
  assert.ok(await page.locator("[data-take=copy_design]").isDisabled());
}));

test("a place can be dragged where the tip of another pose lies on it, and a tip takes its pose away", () => visit({}, async (page) => {
  await put(page, [[0.5, 0.5, 0.1, 0]]);
  const tip = await page.locator('[data-turn="0"]').boundingBox();
  await page.evaluate((hash) => { location.hash = hash; }, await page.evaluate(([x, y]) => {
    const first = document.querySelector("[data-target]").getBoundingClientRect();
    // Units of the sheet per pixel, by the first pose, which stands at its middle but for rounding.
    const scale = Number(document.querySelector(".scale-line").getBBox().width);
    const units = Number(document.querySelector(".scale-text").textContent.match(/[0-9.]+/)[0]) / scale;
    const [px, py] = location.hash.match(/p=([-0-9.]+),([-0-9.]+)/).slice(1).map(Number);
    return `#p=${px},${py},0;${px + (x - first.x - first.width / 2) * units},${py - (y - first.y - first.height / 2) * units},90&o=open,points`;
  }, [tip.x + tip.width / 2, tip.y + tip.height / 2]));
  await page.waitForFunction(() => document.querySelectorAll("[data-turn]").length === 2);
  const other = await page.locator('[data-target="1"]').boundingBox();
  assert.ok(Math.abs(other.x + other.width / 2 - tip.x - tip.width / 2) < 2);
  await page.mouse.move(other.x + other.width / 2, other.y + other.height / 2);
  await page.mouse.down();
  await page.mouse.move(other.x + 60, other.y - 40, { steps: 4 });
  await page.mouse.up();
  const { points } = addressOf(page);
  assert.deepEqual(points.map((p) => p[2]), [0, 90]);
  assert.ok(points[1][0] > points[0][0] + 5);
  await page.locator('[data-turn="1"]').focus();
  await page.keyboard.press("Delete");
  assert.equal(await targets(page), 1);
}));

test("what a limit costs is said, and that is what the search finds without it", () => visit({}, async (page) => {
  await put(page, SIX);
  await page.locator("#class").selectOption("double-crank");
  await settled(page);
  const within = (await facts(page, "rms"))[0];
  await page.waitForFunction(() => /[0-9]/.test(document.getElementById("cost-of-class").textContent), null, { timeout: 60000 });
  const [said] = (await page.locator("#cost-of-class").textContent()).match(/[0-9.]+/);
  await page.locator("#class").selectOption("any");
  assert.equal(await page.locator("#cost-of-class").textContent(), "");
  await settled(page);
  const without = (await facts(page, "rms"))[0];
  assert.ok(without < 0.9 * within && Math.abs(without - Number(said)) <= 0.02 * without, `${without} of ${within}, said ${said}`);
}));

wholeOnly("the address holds poses and their design", () => visit({}, async (page) => {
  await put(page, FOUR);
  await settled(page);
  const design = addressOf(page);
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    await settled(again);
    assert.deepEqual(addressOf(again), design);
    assert.equal(await again.locator("#of-poses").getAttribute("aria-pressed"), "true");
    assert.ok(await again.locator("#body").getAttribute("d"));
  });
}));

test("poses at one place, and one pose put twice, end in designs or in a sentence", () => visit({}, async (page) => {
  await put(page, [[0.5, 0.5, 0.1, 0], [0.5, 0.5, 0, -0.1], [0.5, 0.5, -0.1, 0]]);
  await page.waitForFunction(() => /[a-z]{5}.*\.$/.test(document.getElementById("state").textContent));
  await page.locator("#clear").click();
  await put(page, [[0.5, 0.5, 0.1, 0], [0.5, 0.5, 0.1, 0]]);
  await page.waitForFunction(() => /[a-z]{5}.*\.$/.test(document.getElementById("state").textContent));
  // From poses to a curve and back nothing stays but the limits.
  await page.locator("#least").fill("45");
  await page.locator("#of-curve").click();
  assert.equal(await targets(page), 0);
  assert.ok(await page.locator("#closed").isVisible());
  assert.equal(await page.locator("#least").inputValue(), "45");
  await page.keyboard.press("p");
  assert.ok(await page.locator("#closed").isHidden());
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "phone", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`poses fit: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await put(page, FOUR);
    await page.waitForFunction(() => document.querySelectorAll(".design-card").length === 3);
    await assertFits(page);
    if (options.locale) assert.doesNotMatch(await page.locator("main").innerText(), /[A-Za-z]{5}/);
  }));
}
