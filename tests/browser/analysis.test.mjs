// The page of an analysis as a reader meets it: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { readFileSync, readdirSync, statSync } from "node:fs";
import path from "node:path";
import { after, before } from "node:test";
import { assertFits, assertInked, distance, goesToAndFro, hasCurves, launch, LOOKS, moves, visit as visitReport, withoutPlots } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const NAMES = ["four-bar", "four-bar-gaps", "slider-crank", "guide-bar", "guide-bar-offset", "oscillating-block", "scotch-yoke",
  "elliptic-trammel", "tangent-generator", "oldham-coupling", "driven-by-slider", "shaper", "hundred-links"];
const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `analysis-${name}`, options, steps);

const driveTo = (page, value) => page.locator("#drive").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const drive = (page) => page.locator("#drive").evaluate((input) => Number(input.value));
const range = (page) => page.locator("#drive").evaluate((input) => [Number(input.min), Number(input.max)]);
const pin = (page, name) => page.locator(`.layer-pins [data-name="${name}"]`).first().evaluate((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]);
const toggle = (page, layer) => page.locator(`[data-layer=${layer}]`).click();

// Where the point (u, v) of a body's axes is on the screen, by the place of its drawing alone.
const onBody = (page, body, u, v) => page.evaluate(([i, x, y]) => {
  const { bodies } = JSON.parse(document.getElementById("data").textContent).mechanism;
  const groups = [...document.querySelectorAll(`[data-body="${i}"]`)];
  const bar = document.querySelector(".scale-line").getBBox().width;
  const text = document.querySelector(".scale-text").textContent;
  const scale = bar / Number.parseFloat(text);
  const matrix = groups[0].transform.baseVal.consolidate().matrix;
  return bodies[i] && [matrix.a * x * scale - matrix.c * y * scale + matrix.e, matrix.b * x * scale - matrix.d * y * scale + matrix.f];
}, [body, u, v]);

for (const { size, scheme } of LOOKS) {
  for (const name of some(size === "desktop" ? NAMES : ["four-bar", "shaper", "hundred-links"])) {
    test(`${name} fits a ${size} in ${scheme} colours`, () => visit(name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      assert.ok(await page.locator(".layer-bodies .body").count() > 0);
      await assertInked(page);
    }));
  }
}

const LIBRARY = readdirSync(process.env.REPORTS).filter((file) => file.startsWith("library-")).map((file) => file.replace(".html", ""));

test("every analysis of the library opens, moves and shows its arrows", async () => {
  assert.ok(LIBRARY.length > 10);
  for (const name of some(LIBRARY)) {
    await visitReport(browser, name, still, async (page) => {
      await assertFits(page);
      await page.locator('.segments button[aria-pressed="false"]:visible').evaluateAll((buttons) => buttons.forEach((button) => button.click()));
      const before = await page.locator(".layer-bodies").innerHTML();
      await page.locator("#title").click();
      await page.keyboard.press("Shift+ArrowRight");
      assert.notEqual(await page.locator(".layer-bodies").innerHTML(), before, name);
      assert.doesNotMatch(await page.locator("#picture").innerHTML(), /NaN|undefined/, name);
    });
  }
});

test("a landmark's button goes there, where the output stands still", () => visit("slider-crank", still, async (page) => {
  await page.locator("#landmarks-rows button", { hasText: "Limit position" }).first().click();
  const speed = await page.locator("#values-rows tr", { hasText: "C_vx" }).first().locator(".now").textContent();
  const number = (text) => { const [m, e] = text.replaceAll("−", "-").split("×10"); return Number(m) * 10 ** Number([...(e ?? "0")].map((c) => "⁰¹²³⁴⁵⁶⁷⁸⁹".includes(c) ? "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c) : c === "⁻" ? "-" : c).join("")); };
  assert.ok(Math.abs(number(speed)) < 0.005, speed);
}));

test("the facts have names of their own", () => visit("four-bar", still, async (page) => {
  const names = await page.locator("#facts-list dt").allTextContents();
  assert.ok(names.includes("Minimum transmission angle, acute"), names.join("; "));
  assert.deepEqual(names.filter((name) => /\w\.\w|_/.test(name)), []);
}));

test("the mechanism moves by itself, stops, and goes on", () => visit("four-bar", {}, async (page) => {
  const c = '.layer-pins [data-name="C"]';
  await moves(page, c);
  await page.locator("#play").click();
  const stopped = await pin(page, "C");
  await page.waitForTimeout(400);
  assert.equal(distance(stopped, await pin(page, "C")), 0);
  await page.locator("body").press("Space");
  await moves(page, c);
}));

test("with reduced motion the page does not play by itself", () => visit("four-bar", still, async (page) => {
  const start = await pin(page, "B");
  await page.waitForTimeout(300);
  assert.deepEqual(await pin(page, "B"), start);
}));

test("slider, keys and joints move the mechanism and its curves together", () => visit("slider-crank", still, async (page) => {
  await driveTo(page, 180);
  const [b, a] = [await pin(page, "B"), await pin(page, "A")];
  assert.ok(b[0] < a[0] && Math.abs(b[1] - a[1]) < 0.1);
  await page.locator("#title").click();
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowLeft");
  assert.ok(Math.abs(await drive(page) - 189) < 1e-6);

  const picture = await page.locator("#picture").boundingBox();
  const from = await pin(page, "B");
  await page.mouse.move(picture.x + from[0], picture.y + from[1]);
  await page.mouse.down();
  await page.mouse.move(picture.x + a[0] - 100, picture.y + a[1] + 100, { steps: 5 });
  await page.mouse.up();
  assert.ok(Math.abs(await drive(page) - 225) < 2, `${await drive(page)}`);

}));

test("a click on a curve moves the mechanism, in all curves", { skip: withoutPlots }, () => visit("slider-crank", still, async (page) => {
  const a = await pin(page, "A");
  await page.locator("#curves").scrollIntoViewIfNeeded();
  const plot = await page.locator(".plot .u-over").first().boundingBox();
  await page.mouse.click(plot.x + plot.width / 4, plot.y + plot.height / 2);
  assert.ok(Math.abs(await drive(page) - 90) < 2);
  const cursors = await page.locator(".u-cursor-x").evaluateAll((lines) => lines.map((l) => new DOMMatrix(getComputedStyle(l).transform).m41 / l.parentElement.clientWidth));
  assert.ok(cursors.length > 3);
  for (const share of cursors) assert.ok(Math.abs(share - 0.25) < 0.01);
  const top = await pin(page, "B");
  assert.ok(Math.abs(top[0] - a[0]) < 3 && top[1] < a[1]);
}));

// Bars are drawn in the axes of their own bodies; that joints hold them together is seen only here.
test("links keep their lengths, and two links meet in their joint", () => visit("four-bar", still, async (page) => {
  const lengths = new Set();
  const frame = distance(await pin(page, "A"), await pin(page, "D"));
  for (const at of [0, 33.3, 77.75, 190.1, 301.25, 359.9]) {
    await driveTo(page, at);
    const [a, b, c, d] = [await pin(page, "A"), await pin(page, "B"), await pin(page, "C"), await pin(page, "D")];
    lengths.add([distance(a, b), distance(b, c), distance(c, d)].map((l) => (l / frame * Math.hypot(4, 0.5)).toFixed(2)).join(" "));
    const [byCoupler, byRocker] = [await onBody(page, 2, 3.4, 0), await onBody(page, 3, 2.6, 0)];
    assert.ok(distance(byCoupler, byRocker) < 0.3, `${byCoupler} ${byRocker}`);
    assert.ok(distance(byRocker, c) < 0.3);
  }
  assert.deepEqual([...lengths], ["1.00 3.40 2.60"]);
}));

test("a slider stays on its guide", () => visit("slider-crank", still, async (page) => {
  const rail = await page.locator(".guide-axis").boundingBox();
  const picture = await page.locator("#picture").boundingBox();
  for (const at of [10, 100, 222, 333]) {
    await driveTo(page, at);
    const c = await pin(page, "C");
    assert.ok(Math.abs(picture.y + c[1] - rail.y) < 1, `${c} ${rail.y}`);
    assert.ok(picture.x + c[0] > rail.x && picture.x + c[0] < rail.x + rail.width);
  }
}));

test("arrows of velocity, acceleration and force come and go", () => visit("shaper", still, async (page) => {
  await driveTo(page, 90);
  const drawn = (kind) => page.locator(`.arrow.${kind}:not([hidden]) path:last-child`).evaluateAll((arrows) => arrows.map((a) => a.getTotalLength()));
  for (const layer of ["velocity", "acceleration", "reactions"]) {
    assert.deepEqual(await drawn(layer), []);
    await toggle(page, layer);
    assert.ok(Math.max(...await drawn(layer)) > 20, layer);
    assert.equal(await page.locator(`[data-layer=${layer}]`).getAttribute("aria-pressed"), "true");
    await toggle(page, layer);
    assert.deepEqual(await drawn(layer), []);
  }
}));

// The tip of the velocity's arrow goes where the joint goes.
test("the arrow of a crank pin's velocity is perpendicular to the crank", () => visit("four-bar", still, async (page) => {
  await toggle(page, "velocity");
  await driveTo(page, 40);
  const [a, b] = [await pin(page, "A"), await pin(page, "B")];
  const tips = await page.locator(".arrow.velocity path:last-child").evaluateAll((arrows) => arrows.map((arrow) => arrow.getAttribute("d").match(/-?[\d.]+/g).map(Number).slice(0, 4)));
  const [x0, y0, x1, y1] = tips.find(([x, y]) => distance([x, y], b) < 0.5);
  const cosine = ((b[0] - a[0]) * (x1 - x0) + (b[1] - a[1]) * (y1 - y0)) / distance(a, b) / distance([x0, y0], [x1, y1]);
  assert.ok(Math.abs(cosine) < 0.01, `${cosine}`);
}));

test("where the mechanism does not close there is a gap, and the page says so", () => visit("four-bar-gaps", still, async (page) => {
  await driveTo(page, 180);
  assert.equal(await page.locator("#open").isVisible(), true);
  assert.equal(await page.locator('[data-body="2"]').first().isVisible(), false);
  assert.equal(await page.locator('[data-body="1"]').first().isVisible(), true);
  await driveTo(page, 60);
  assert.equal(await page.locator("#open").isVisible(), false);
  assert.equal(await page.locator('[data-body="2"]').first().isVisible(), true);
  const paths = await page.locator(".layer-paths path").evaluateAll((all) => all.map((p) => p.getAttribute("d").match(/M/g).length));
  assert.ok(Math.max(...paths) >= 2);
}));

test("a driving slider goes to and fro", () => visit("driven-by-slider", {}, async (page) => {
  await page.locator("#speed").evaluate((input) => { input.value = 3; input.dispatchEvent(new Event("input")); });
  await goesToAndFro(page, "#drive");
  assert.deepEqual(await range(page), [0.03, 0.25]);
}));

test("parts are chosen for curves, loci and values alike", () => visit("shaper", still, async (page) => {
  const rows = page.locator("#values-rows tr");
  const before = await rows.count();
  await page.locator('[data-part="bar"]').click();
  assert.ok(await rows.count() > before);
  assert.equal(await page.locator('[data-part="bar"]').getAttribute("aria-pressed"), "true");
  if (hasCurves) assert.match(await page.locator("#plots").textContent(), /bar ω/);
  await page.locator("#all-parts").click();
  const columns = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).table.columns.length);
  assert.equal(await rows.count(), columns - 1);
  assert.ok(await page.locator(".locus").count() >= 3);
}));

test("the values are those of the table where a row stands", () => visit("slider-crank", still, async (page) => {
  await driveTo(page, 90);
  const shown = await page.locator("#values-rows tr", { hasText: "C_x" }).first().locator(".now").textContent();
  const expected = Math.sqrt(0.33 ** 2 - (0.1 - 0.03) ** 2);
  assert.ok(Math.abs(Number(shown) - expected) < 1e-6, `${shown} ${expected}`);
}));

test("hodographs have equal axes", () => visit("four-bar", still, async (page) => {
  // The crank pin's hodograph is a circle.
  const box = await page.locator(".locus-line").first().evaluate((p) => { const { width, height } = p.getBBox(); return [width, height]; });
  assert.ok(box[0] > 50 && Math.abs(box[0] - box[1]) < 0.5, `${box}`);
}));

test("the table is saved as CSV, gaps as empty cells", () => visit("four-bar-gaps", still, async (page) => {
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#save-table").click()]);
  const lines = readFileSync(await download.path(), "utf8").trimEnd().split("\n");
  assert.equal(lines.length, 362);
  assert.match(lines[0], /^crank_deg,/);
  assert.match(lines[181], /^180,/);
  assert.match(lines[181], /,,/);
}));

test("a hundred links make a page below 1.12 MB", () => visit("hundred-links", still, async (page) => {
  assert.ok(statSync(path.join(process.env.REPORTS, "analysis-hundred-links.html")).size < 1.12e6);
  await driveTo(page, 123.4);
  assert.equal(await page.locator(".layer-bodies .body").count(), 99);
  assert.match(await page.locator("#save-table").textContent(), /rows drawn/);
}));

test("an analysis prints in light colours", () => visit("shaper", { ...still, scheme: "dark" }, async (page) => {
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 20000);
}));

// Weights are mass times gravity, on their bodies; the arrows have one scale, which the bar at the foot gives.
test("loads, weights and the torque of the drive are drawn to scale, and say what they are", () => visitReport(browser, "library-four-bar-forces", still, async (page) => {
  const { problem: { link, load, gravity }, analysis } = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result);
  await page.locator('[data-extra="loads"]').click();
  await driveTo(page, 60);
  const arrows = await page.locator(".loads .arrow").evaluateAll((all) => all.map((arrow) => ({ kind: arrow.classList[1], title: arrow.querySelector("title").textContent, d: arrow.querySelector("path:not(.halo)").getAttribute("d"), hit: arrow.querySelector(".halo") !== null })));
  const [text, line] = [await page.locator(".loads .scale-text").textContent(), await page.locator(".loads .scale-line").getAttribute("d")];
  const [, from, to] = /M([\d.]+) [\d.]+v4H([\d.]+)/.exec(line);
  const perNewton = (Number(to) - Number(from)) / parseFloat(text);
  const weights = arrows.filter(({ kind }) => kind === "weight");
  assert.equal(weights.length, link.length);
  for (const { name, mass } of link) {
    const force = mass * Math.hypot(...gravity);
    const arrow = weights.find(({ title }) => title.includes(` ${name}:`));
    assert.ok(arrow.title.startsWith(`Weight on ${name}: ${force} N`), arrow.title);
    const [, x0, y0, x1, y1] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/.exec(arrow.d).map(Number);
    assert.ok(Math.abs(y1 - y0 - perNewton * force) < 0.5 && Math.abs(x1 - x0) < 0.5, `${name}: ${y1 - y0} px of ${perNewton * force}`);
  }
  assert.equal(arrows.find(({ kind }) => kind === "load").title, `Load on ${load[0].on}: ${String(load[0].torque).replace("-", "−")} N·m`);
  const torque = analysis.columns.find(({ quantity }) => quantity === "torque").values[60];
  assert.equal(arrows.find(({ kind }) => kind === "drive").title, `Drive on crank: ${Number(torque.toPrecision(5))} N·m`.replace("-", "−"));
  assert.ok(arrows.every(({ hit }) => hit));
}));
