// The page of `cognate sketch`: slider-cranks trace a curve that is drawn.
import assert from "node:assert/strict";
import { assertFits, distance } from "./browser.mjs";
import { rarely as test, some, wholeOnly } from "./thinned.mjs";
import { couplerPose, sliderPose } from "./closures.mjs";
import { addressOf, answered, draw, facts, offered, settled, targets, visit } from "./sketching.mjs";

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

// Points that a slider-crank and a crank-rocker pass, each by a curve that the other cannot trace.
const SLIDER = { a: [-12, -8], crank: 9, offset: 3, coupler: 24, direction: 20, u: 14, v: 7, ahead: 1 };
const BAR = { a: [-20, -10], d: [10, -12], crank: 9, coupler: 24, rocker: 20, u: 16, v: 14, side: 1 };
const pointsOf = (at) => Array.from({ length: 16 }, (_, i) => at((2 * Math.PI * i) / 16).at);
// A curve for which slider-cranks are better than four-bars; one for which they are so for the greatest transmission angles alone.
const DROP = [[32.6, 10.7], [24.6, 19.1], [12.9, 22], [0.7, 22.2], [-11, 19.1], [-18.6, 10], [-19.6, -2], [-18.4, -14], [-6.9, -14.4], [4.6, -10.5], [15.6, -5.5], [26, 1]];
const LOBE = [[-12.7, 27.2], [-0.7, 29.3], [11.4, 27.8], [19.7, 25.3], [22.8, 22.1], [22, 15.5], [18.3, 3.2], [13.2, -13.3], [6.9, -28.1], [0.3, -36.7], [-6.3, -37.3], [-12.1, -31.4], [-17.2, -21.2], [-21.6, -8], [-23.6, 6.2], [-21.1, 19.3]];
const hashOf = (points, drawn = "closed,points,both", limits = "any,30,3") => `#p=${points.map((p) => p.join(",")).join(";")}&o=${drawn}&l=${limits}`;
const classes = (page) => facts(page, "class");

for (const [name, points, isSlider] of [["slider-crank", pointsOf((at) => sliderPose(SLIDER, at)), true], ["crank-rocker", pointsOf((at) => couplerPose(BAR, at)), false]]) {
  test(`of both kinds the one that traces the curve of a ${name} is found, and the file asks for it`, () => visit({ hash: hashOf(points) }, async (page) => {
    await settled(page);
    assert.ok(await isPressed(page, "by-both"));
    assert.deepEqual([(await classes(page))[0] === "slider-crank", (await facts(page, "rms"))[0] < 1e-5], [isSlider, true], `${await classes(page)}: ${await facts(page, "rms")}`);
    await page.locator("[data-take=copy_problem]").click();
    const file = await page.locator("#taken").inputValue(), result = await answered("solve", file);
    assert.equal(/type = "slider-crank"/.test(file), isSlider);
    assert.ok(result.status === "solved" && result.designs[0].error.rms < 1e-5);
  }));
}

test("the best of both kinds come together, each with its own file, and stay in the address", () => visit({ hash: hashOf(DROP) }, async (page) => {
  await settled(page);
  const kinds = await classes(page), errors = await facts(page, "rms"), hash = `#${page.url().split("#")[1]}`;
  // As good as by each kind alone, and no better.
  for (const drawn of ["closed,points", "closed,points,slider"]) {
    await visit({ hash: hashOf(DROP, drawn) }, async (alone) => {
      await settled(alone);
      const [best] = await facts(alone, "rms"), own = errors.filter((_, i) => (kinds[i] === "slider-crank") === drawn.endsWith("slider"));
      assert.ok(own.length > 0 && Math.abs(own[0] - best) <= 1e-3 * best, `${own} against ${best} of ${drawn}`);
    });
  }
  for (const [i, kind] of kinds.entries()) {
    await page.locator(`#design-${i}`).check();
    for (const [take, command] of [["copy_problem", "check"], ["copy_design", "analyze"]]) {
      await page.locator(`[data-take=${take}]`).click();
      const file = await page.locator("#taken").inputValue();
      assert.equal(/type = "slider-crank"/.test(file), kind === "slider-crank", file);
      assert.ok(await answered(command, file));
    }
    const chosen = page.url().split("#")[1];
    await visit({ hash: `#${chosen}` }, async (again) => {
      assert.deepEqual([await classes(again), await isPressed(again, "by-both")], [[kind], true]);
      assert.ok(Math.abs((await facts(again, "rms"))[0] - errors[i]) <= 1e-9);
      await settled(again);
      assert.equal(again.url().split("#")[1], chosen);
    });
  }
  // A four-bar in the address of slider-cranks is none of theirs.
  await visit({ hash: hash.replace(",both&", ",slider&") }, async (again) => {
    await settled(again);
    for (const kind of await classes(again)) assert.equal(kind, "slider-crank");
  });
}));

test("M goes on to both kinds, four-bars stay where they alone are searched for again, and every step is undone", () => visit({}, async (page) => {
  await draw(page, drop);
  await settled(page);
  await page.locator("#class").selectOption("crank-rocker");
  await settled(page);
  await page.locator("#sheet").focus();
  for (const pressed of ["by-slider", "by-both"]) {
    await page.keyboard.press("m");
    assert.ok(await isPressed(page, pressed));
    assert.ok(!await page.locator("#class").isVisible() && !await page.locator("#obstacle").isVisible() && await page.locator("#region").isVisible());
  }
  await settled(page);
  const kinds = await classes(page);
  assert.ok(kinds.includes("slider-crank") && kinds.some((kind) => kind !== "slider-crank"), `${kinds}`);
  await page.keyboard.press("m");
  assert.ok(await isPressed(page, "by-four-bar"));
  assert.ok(!(await classes(page)).includes("slider-crank"));
  for (const pressed of ["by-both", "by-slider", "by-four-bar"]) {
    await page.keyboard.press("Control+z");
    assert.ok(await isPressed(page, pressed));
  }
  assert.equal(await page.locator("#class").inputValue(), "crank-rocker");
}));

wholeOnly("while a point is dragged both kinds follow, and all pass the points within the error", () => visit({ hash: hashOf(DROP) }, async (page) => {
  await settled(page);
  const before = await facts(page, "rms"), at = await page.locator('[data-target="2"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + at.width / 2 + 12, at.y + at.height / 2 - 6);
  await page.waitForFunction((all) => { const now = [...document.querySelectorAll("[data-fact=rms]")].map((one) => one.dataset.value); return now.length > 1 && now.every((value) => !all.includes(Number(value))); }, before);
  assert.ok((await classes(page)).includes("slider-crank") && new Set(await classes(page)).size > 1, `${await classes(page)}`);
  await page.mouse.up();
  await settled(page);
  for (const [i, kind] of (await classes(page)).entries()) {
    await page.locator(`#design-${i}`).check();
    const design = kind === "slider-crank" ? designIn(page) : addressOf(page);
    const far = kind === "slider-crank" ? misses(design) : design.points.map((p, k) => distance(p, couplerPose(design, design.cranks[k] * RADIANS).at));
    assert.ok(Math.max(...far) <= design.max + 1e-6, `${far} of a ${kind}`);
  }
}));

test("the front has points of both kinds, and one that is taken brings its kind", () => visit({ hash: hashOf(LOBE, "closed,points,both", "any,20,5") }, async (page) => {
  await page.waitForFunction(() => /^The least error/.test(document.getElementById("front-note").textContent), null, { timeout: 240000 });
  const labels = await page.locator(".front-point").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
  assert.deepEqual(new Set(labels.map((label) => label.endsWith("Slider-crank"))), new Set([true, false]), labels.join("; "));
  assert.ok(!page.url().includes("slider-crank"));
  await page.locator('.front-point[aria-label$="Slider-crank"]').last().click();
  assert.equal(await page.locator(".design-card:has(:checked) [data-fact=class]").textContent(), "Slider-crank");
  assert.match(page.url(), /,both&l=any,70,5&d=.*;slider-crank;/);
  await page.locator("[data-take=copy_problem]").click();
  assert.match(await page.locator("#taken").inputValue(), /type = "slider-crank"/);
  await page.locator("#undo").click();
  await offered(page);
  assert.ok(await isPressed(page, "by-both") && !page.url().includes("slider-crank"));
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "phone", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`slider-cranks fit: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await page.locator(options.size === "phone" ? "#by-both" : "#by-slider").click();
    await draw(page, drop);
    await page.waitForFunction(() => document.querySelector("[data-fact=stroke]"));
    await assertFits(page);
  }));
}
