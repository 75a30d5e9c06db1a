// The page of `cognate sketch`: slider-cranks trace a curve that is drawn.
import assert from "node:assert/strict";
import { assertFits, distance, inTurn as test, some } from "./browser.mjs";
import { sliderPose } from "./closures.mjs";
import { answered, draw, facts, offered, settled, targets, visit } from "./sketching.mjs";

const RADIANS = Math.PI / 180;
const drop = (t) => [0.5 + 0.16 * Math.cos(t) + 0.04 * Math.cos(2 * t), 0.45 - 0.17 * Math.sin(t + 0.4)];
const isPressed = (page, id) => page.locator(`#${id}`).getAttribute("aria-pressed").then((value) => value === "true");

// Of the address: the points, and the slider-crank as closures.mjs has it.
function designIn(page) {
  const parts = Object.fromEntries(page.url().split("#")[1].split("&").map((part) => part.split("=")));
  const [numbers, assembly, name, turns] = (parts.d ?? "").split(";"), [direction, ...cranks] = (turns ?? "").split(",").map(Number);
  const [ax, ay, crank, coupler, offset, u, v, rms, max] = numbers.split(",").map(Number);
  return { points: parts.p.split(";").map((p) => p.split(",").map(Number)), drawn: parts.o, slider: { a: [ax, ay], crank, coupler, offset, direction, u, v, ahead: assembly === "open" ? 1 : -1 }, name, cranks, rms, max };
}

const misses = ({ points, slider, cranks }) => points.map((p, i) => distance(p, sliderPose(slider, cranks[i] * RADIANS).at));

test("chosen by a click, slider-cranks are found that pass the points within the error, with their files", () => visit({}, async (page) => {
  await page.locator("#by-slider").click();
  await draw(page, drop);
  await settled(page);
  assert.ok(await isPressed(page, "by-slider") && !await isPressed(page, "by-four-bar"));
  const design = designIn(page), far = misses(design), errors = await facts(page, "rms");
  assert.ok(design.name === "slider-crank" && design.drawn === "closed,stroke,slider");
  assert.ok(Math.abs(Math.hypot(...far) / Math.sqrt(far.length) - design.rms) < 1e-6 && Math.abs(Math.max(...far) - design.max) < 1e-6, `${far} against ${design.rms}`);
  assert.ok(Math.abs(errors[0] - design.rms) < 1e-9 && design.rms < 1);
  for (const least of await facts(page, "least")) assert.ok(least >= 30 - 1e-6);
  // Its slider stands on a guide, and goes as far as the circle about the crank's pin says.
  const places = Array.from({ length: 3600 }, (_, i) => sliderPose(design.slider, (2 * Math.PI * i) / 3600).c), [stroke] = await facts(page, "stroke");
  const along = places.map(([x, y]) => x * Math.cos(design.slider.direction * RADIANS) + y * Math.sin(design.slider.direction * RADIANS));
  assert.ok(Math.abs(Math.max(...along) - Math.min(...along) - stroke) < 0.01 * stroke, `${stroke}`);
  assert.equal(await page.locator("#linkage .guide-face").count(), 1);
  assert.deepEqual(await page.locator("#linkage [data-pin]").evaluateAll((all) => all.map((one) => one.dataset.pin)), ["A", "B", "C"]);
  // Limits that slider-cranks do not have are not offered.
  assert.ok(!await page.locator("#class").isVisible() && !await page.locator("#obstacle").isVisible() && await page.locator("#region").isVisible());
  await page.locator("[data-take=copy_problem]").click();
  const file = await page.locator("#taken").inputValue(), result = await answered("solve", file);
  assert.match(file, /type = "slider-crank"/);
  assert.ok(result.status === "solved" && errors[0] <= 1.01 * result.designs[0].error.rms, `${errors[0]} against ${result.designs[0].error.rms}`);
  await page.locator("[data-take=copy_design]").click();
  const [analysed] = (await answered("analyze", await page.locator("#taken").inputValue())).designs;
  assert.equal(analysed.mechanism.type, "slider-crank");
  assert.ok(Math.abs(analysed.metrics.transmission_angle_deg.acute_min - (await facts(page, "least"))[0]) < 0.01);
}));

test("M changes the mechanism under a drawing, and every step can be undone", () => visit({}, async (page) => {
  await draw(page, drop);
  await settled(page);
  await page.locator("#class").selectOption("crank-rocker");
  await offered(page);
  const count = await targets(page);
  await page.keyboard.press("Escape");
  await page.locator("#sheet").focus();
  await page.keyboard.press("m");
  await offered(page);
  assert.ok(await isPressed(page, "by-slider") && await targets(page) === count);
  assert.equal((await facts(page, "class"))[0], "slider-crank");
  assert.equal(await page.locator("#class").inputValue(), "any");
  await page.keyboard.press("o");
  assert.doesNotMatch(await page.locator("#state").textContent(), /box/);
  await page.keyboard.press("Control+z");
  await offered(page);
  assert.ok(await isPressed(page, "by-four-bar"));
  assert.deepEqual([await page.locator("#class").inputValue(), (await facts(page, "class"))[0]], ["crank-rocker", "crank-rocker"]);
  await page.keyboard.press("Control+Shift+z");
  await offered(page);
  assert.equal((await facts(page, "class"))[0], "slider-crank");
  // Poses and functions are for four-bars.
  await page.locator("#of-poses").click();
  assert.ok(!await page.locator("#by-slider").isVisible() && await isPressed(page, "by-four-bar"));
  await page.keyboard.press("m");
  assert.ok(await isPressed(page, "by-four-bar"));
}));

test("the address holds a slider-crank, and one that holds none is read without it", () => visit({}, async (page) => {
  await page.locator("#by-slider").click();
  await draw(page, drop, [0.4, 3.8]);
  await settled(page);
  const kept = designIn(page), hash = `#${page.url().split("#")[1]}`;
  await visit({ hash }, async (again) => {
    assert.deepEqual(await facts(again, "rms"), [kept.rms]);
    await settled(again);
    assert.deepEqual(designIn(again), kept);
  });
  for (const bad of [hash.replace(";slider-crank;", ";crank-rocker;"), hash.replace(/d=[^,]*,/, "d=NaN,"), hash.replace(",slider&", "&")]) {
    await visit({ hash: bad }, async (again) => {
      assert.equal(await targets(again), kept.points.length);
      await offered(again);
    });
  }
}));

test("while a point is dragged slider-cranks follow", () => visit({}, async (page) => {
  await page.locator("#by-slider").click();
  await draw(page, drop);
  await offered(page);
  const before = await facts(page, "rms"), at = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 30, at.y - 15);
  await page.waitForFunction((rms) => { const card = document.querySelector("[data-fact=rms]"); return card && card.dataset.value !== String(rms); }, before[0]);
  const followed = await facts(page, "rms");
  await page.mouse.up();
  await settled(page);
  assert.ok((await facts(page, "rms"))[0] <= followed[0] * (1 + 1e-9));
  const design = designIn(page);
  assert.ok(Math.max(...misses(design)) <= design.max + 1e-6);
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "phone", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`slider-cranks fit: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await page.locator("#by-slider").click();
    await draw(page, drop);
    await page.waitForFunction(() => document.querySelector("[data-fact=stroke]"));
    await assertFits(page);
  }));
}
