// Tolerances, robust designs and rasters in their pages: the figures of the program's result, and mechanisms that move
// within their tolerances as the loop equations say.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { assertFits, assertInked, hasCurves, launch, LOOKS, open, visit, withoutPlots } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const still = { motion: "reduce" };
const NAMES = ["library-toleranced-rocker", "toleranced-ellipse", "toleranced-roller", "toleranced-slider-crank", "toleranced-square"];
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const resultOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result);
const judgedOf = ({ designs: [{ tolerance }] }) => tolerance.quantities.find(({ judged }) => judged);
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} and ${b}`);
const toNumber = (text) => Number(text.replace("−", "-"));

// The four-bar of `m` at a crank angle in degrees: its joints, coupler point, and the rocker's angle.
function fourBar({ fixed_pivots: [a, d], crank, coupler, rocker, assembly, coupler_point: point }, deg) {
  const angle = (deg * Math.PI) / 180;
  const b = [a[0] + crank * Math.cos(angle), a[1] + crank * Math.sin(angle)];
  const [x, y] = [d[0] - b[0], d[1] - b[1]];
  const far = Math.hypot(x, y);
  const foot = (coupler ** 2 - rocker ** 2 + far ** 2) / (2 * far);
  const high = Math.sqrt(coupler ** 2 - foot ** 2) * (assembly === "crossed" ? -1 : 1);
  const c = [b[0] + (foot * x - high * y) / far, b[1] + (foot * y + high * x) / far];
  const [u, v] = [(c[0] - b[0]) / coupler, (c[1] - b[1]) / coupler];
  return { b, c, p: point && [b[0] + u * point[0] - v * point[1], b[1] + v * point[0] + u * point[1]], rocker: (Math.atan2(c[1] - d[1], c[0] - d[0]) * 180) / Math.PI };
}

// `m` with the dimensions at the values that the sliders have.
function changed(m, by) {
  const [[ax, ay], [dx, dy]] = m.fixed_pivots;
  const length = Math.hypot(dx - ax, dy - ay);
  const frame = by.frame ?? 0;
  return { ...m, crank: m.crank + (by.crank ?? 0), coupler: m.coupler + (by.coupler ?? 0), rocker: m.rocker + (by.rocker ?? 0),
    fixed_pivots: [[ax + (by["A.x"] ?? 0), ay + (by["A.y"] ?? 0)], [dx + (by["D.x"] ?? 0) + (frame * (dx - ax)) / length, dy + (by["D.y"] ?? 0) + (frame * (dy - ay)) / length]],
    ...(m.coupler_point ? { coupler_point: [m.coupler_point[0] + (by["coupler_point.u"] ?? 0), m.coupler_point[1] + (by["coupler_point.v"] ?? 0)] } : {}) };
}

const setSlider = (page, name, value) => page.locator(`[data-dimension="${name}"][type=range]`).evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const sliders = (page) => page.locator(".slider-grid input").evaluateAll((all) => Object.fromEntries(all.map((input) => [input.dataset.dimension, input.valueAsNumber])));

// The rows of the table of deviations: the drive, and the last column, the dimensions as set.
async function deviations(page) {
  await page.locator("#tolerances .changed-line, #tolerances.set").first().waitFor();
  const button = page.locator("#tolerances .as-table");
  await button.click();
  const rows = await page.locator("#tolerances .of-plot tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  await button.click();
  return rows.map((row) => ({ drive: toNumber(row[0]), low: toNumber(row[1]), high: toNumber(row[2]), set: toNumber(row.at(-1)) }));
}

for (const { size, scheme } of LOOKS) {
  for (const name of some(NAMES)) {
    test(`${name} fits a ${size} in ${scheme} colours`, () => visit(browser, name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      await assertInked(page, 300);
      assert.doesNotMatch(await page.locator("#tolerances").innerHTML(), /NaN|undefined/);
    }));
  }
}

for (const name of some(NAMES)) {
  test(`${name}: bars, histogram and figures are those of the result`, () => visit(browser, name, still, async (page) => {
    const result = await resultOf(page);
    const quantity = judgedOf(result);
    const { dimensions, assembled } = result.designs[0].tolerance;
    const bars = await page.locator(".contribution").evaluateAll((all) => all.map((row) => ({ dimension: row.dataset.dimension, share: Number(row.dataset.share), width: row.querySelector(".bar").getBoundingClientRect().width / row.querySelector(".track").clientWidth, text: row.textContent })));
    assert.equal(bars.length, dimensions.length);
    // First order: |∂q/∂x| times half the width of the tolerance.
    const most = Math.max(...quantity.contributions.map(({ amount }) => amount));
    quantity.contributions.forEach(({ dimension, sensitivity, amount }, i) => {
      const { plus, minus } = dimensions.find((one) => one.name === dimension);
      assert.equal(bars[i].dimension, dimension);
      near(amount, (Math.abs(sensitivity) * (plus + minus)) / 2, 1e-9, dimension);
      near(bars[i].width, amount / most, 0.02, dimension);
    });
    near(bars.reduce((sum, { share }) => sum + share, 0), 1, 1e-9, "shares");
    const bins = await page.locator("#tolerance-histogram .bin").evaluateAll((all) => all.map((bin) => [Number(bin.dataset.count), Number(bin.getAttribute("height"))]));
    assert.deepEqual(bins.map(([count]) => count), quantity.histogram.counts);
    const total = bins.reduce((sum, [count]) => sum + count, 0);
    assert.ok(total <= assembled && total >= 0.999 * assembled);
    const [tallest] = [...bins].sort((p, q) => q[0] - p[0]);
    for (const [count, height] of bins) near(height / tallest[1], count / tallest[0], 0.01, "bin");
    const marks = await page.locator("#tolerance-histogram .mark-line:not(.limit)").evaluateAll((all) => all.map((line) => Number(line.dataset.at)));
    assert.deepEqual(marks, quantity.quantiles.filter(({ share }) => [0.5, 0.9, 0.99].includes(share)).map(({ error }) => error));
    assert.equal(await page.locator("#facts, #qualities").filter({ hasText: /Tolerance/ }).count(), 0);
  }));
}

test("an analysed linkage moves within its tolerances as its loop closes", { skip: withoutPlots }, () => visit(browser, "library-toleranced-rocker", still, async (page) => {
  const result = await resultOf(page);
  const { mechanism } = result.designs[0];
  await setSlider(page, "crank", 0.07);
  await setSlider(page, "coupler", -0.03);
  const rows = await deviations(page);
  assert.equal(rows.length, 37);
  for (const { drive, low, high, set } of rows) {
    const exact = fourBar(changed(mechanism, { crank: 0.07, coupler: -0.03 }), drive).rocker - fourBar(mechanism, drive).rocker;
    near(set, exact, 2e-4, `at ${drive}`);
    assert.ok(set >= low && set <= high);
  }
}));

test("the worst case of an analysis is reached by its corner, and drawn where it is", { skip: withoutPlots }, () => visit(browser, "library-toleranced-rocker", still, async (page) => {
  const result = await resultOf(page);
  const quantity = judgedOf(result);
  const { mechanism } = result.designs[0];
  await page.locator("[data-set=worst]").click();
  await page.locator("#tolerances.set").waitFor();
  assert.equal(await page.locator("#drive").evaluate((input) => Number(input.value)), quantity.linear_at);
  const by = await sliders(page);
  const [before, now] = [mechanism, changed(mechanism, by)].map((m) => fourBar(m, quantity.exact_at));
  near(Math.abs(now.rocker - before.rocker), Math.max(-quantity.exact[0], quantity.exact[1]), 0.005, "deviation at the corner");
  // The joint C in the picture: as designed, and as set, its displacement magnified.
  const times = Number(/×([\d,]+)/.exec(await page.locator(".tolerance-sliders p").textContent())[1].replace(",", ""));
  const [c, drawn, scale] = await page.evaluate(() => {
    const pin = document.querySelector('.layer-pins [data-name="C"]').getBoundingClientRect();
    const frame = document.querySelector("#picture svg").getBoundingClientRect();
    const points = [...document.querySelector(".changed-line").getAttribute("d").matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
    const [a, d] = ["A", "D"].map((name) => document.querySelector(`.layer-pins [data-name="${name}"]`)?.getBoundingClientRect());
    return [[pin.x + pin.width / 2 - frame.x, pin.y + pin.height / 2 - frame.y], points, a && d ? Math.hypot(d.x - a.x, d.y - a.y) : null];
  });
  const perUnit = scale === null ? null : scale / 110;
  const wanted = perUnit && [c[0] + times * perUnit * (now.c[0] - before.c[0]), c[1] - times * perUnit * (now.c[1] - before.c[1])];
  if (wanted) assert.ok(drawn.some((p) => Math.hypot(p[0] - wanted[0], p[1] - wanted[1]) < 2.5), `${wanted} among ${JSON.stringify(drawn)}`);
  await page.locator("[data-set=nominal]").click();
  await page.locator("#tolerances:not(.set)").waitFor();
  assert.deepEqual(new Set(Object.values(await sliders(page))), new Set([0]));
}));

test("a path moves within its tolerances: its error along the normal", { skip: withoutPlots }, () => visit(browser, "toleranced-ellipse", still, async (page) => {
  const result = await resultOf(page);
  const { mechanism } = result.designs[0];
  const by = { coupler: 0.1, "coupler_point.u": -0.06, "A.x": 0.03 };
  for (const [name, value] of Object.entries(by)) await setSlider(page, name, value);
  for (const { drive, low, high, set } of await deviations(page)) {
    const [p, ahead, moved] = [fourBar(mechanism, drive).p, fourBar(mechanism, drive + 1e-4).p, fourBar(changed(mechanism, by), drive).p];
    const [u, v] = [ahead[0] - p[0], ahead[1] - p[1]];
    near(set, (u * (moved[1] - p[1]) - v * (moved[0] - p[0])) / Math.hypot(u, v), 2e-4, `at ${drive}`);
    assert.ok(set >= low && set <= high);
  }
  assert.ok(await page.locator(".whisker").count() >= 10);
}));

// The slider-crank of a chain at a crank angle in degrees: its slider's way along the guide, and its point on the rod.
function sliderCrank({ crank, dyad: [{ lengths: [rod], slide, assembly }], point: [point] = [{ at: [0, 0] }], pivot: [{ at: a }] }, deg) {
  const angle = (deg * Math.PI) / 180, along = (slide.direction_deg * Math.PI) / 180;
  const [c, s] = [Math.cos(along), Math.sin(along)];
  const through = slide.through === "A" ? a : slide.through;
  const b = [a[0] + crank.length * Math.cos(angle), a[1] + crank.length * Math.sin(angle)];
  // From B to the guide: `high` across it, `far` along it.
  const [x, y] = [b[0] - through[0], b[1] - through[1]];
  const high = slide.offset - (c * y - s * x);
  const far = Math.sqrt(rod ** 2 - high ** 2) * (assembly === "open" ? 1 : -1);
  const [u, v] = [(far * c - high * s) / rod, (far * s + high * c) / rod];
  return { way: c * x + s * y + far, p: [b[0] + u * point.at[0] - v * point.at[1], b[1] + v * point.at[0] + u * point.at[1]] };
}

// `m` with its dimensions changed, by the names that results give them.
function changedChain(m, by) {
  const [dyad] = m.dyad;
  return { ...m, crank: { ...m.crank, length: m.crank.length + (by.crank ?? 0) }, dyad: [{ ...dyad, lengths: [dyad.lengths[0] + (by.BC ?? 0)], slide: { ...dyad.slide, offset: dyad.slide.offset + (by["slider-C"] ?? 0) } }],
    ...(m.point ? { point: [{ ...m.point[0], at: [m.point[0].at[0] + (by["P.u"] ?? 0), m.point[0].at[1] + (by["P.v"] ?? 0)] }] } : {}) };
}

test("a chain that was found moves within its tolerances: its point along the normal of its path", { skip: withoutPlots }, () => visit(browser, "toleranced-slider-crank", still, async (page) => {
  const { mechanism } = (await resultOf(page)).designs[0];
  const by = { crank: 0.004, BC: -0.003, "slider-C": 0.005, "P.u": -0.004, "P.v": 0.002 };
  assert.deepEqual(new Set(Object.keys(await sliders(page))), new Set(Object.keys(by)));
  for (const [name, value] of Object.entries(by)) await setSlider(page, name, value);
  const rows = await deviations(page);
  assert.ok(rows.length > 30);
  for (const { drive, low, high, set } of rows) {
    const [p, before, ahead, moved] = [...[0, -1e-3, 1e-3].map((turn) => sliderCrank(mechanism, drive + turn).p), sliderCrank(changedChain(mechanism, by), drive).p];
    const [u, v] = [ahead[0] - before[0], ahead[1] - before[1]];
    near(set, 1000 * (u * (moved[1] - p[1]) - v * (moved[0] - p[0])) / Math.hypot(u, v), 0.01, `at ${drive}`);
    assert.ok(set >= low && set <= high);
  }
}));

test("a slider that was found moves within its tolerances along its guide", { skip: withoutPlots }, () => visit(browser, "toleranced-square", still, async (page) => {
  const { mechanism } = (await resultOf(page)).designs[0];
  const by = { crank: 0.2, BC: -0.3, "slider-C": 0.1 };
  for (const [name, value] of Object.entries(by)) await setSlider(page, name, value);
  for (const { drive, low, high, set } of await deviations(page)) {
    near(set, sliderCrank(changedChain(mechanism, by), drive).way - sliderCrank(mechanism, drive).way, 1e-3, `at ${drive}`);
    assert.ok(set >= low && set <= high);
  }
}));

test("a body that was guided is as far from its poses as they say, once its crank is changed", { skip: withoutPlots }, () => visit(browser, "toleranced-tray", still, async (page) => {
  const result = await resultOf(page);
  const { problem, designs: [{ mechanism, tolerance }] } = result;
  const { nominal } = judgedOf(result).positions;
  const asChain = (m) => ({ crank: { length: m.crank }, pivot: [{ at: m.pivot }], point: m.point, dyad: [{ lengths: [m.coupler], assembly: m.assembly, slide: { through: "A", direction_deg: m.direction_deg, offset: m.offset } }] });
  await setSlider(page, "crank", 0.1);
  const rows = await deviations(page);
  assert.equal(rows.length, tolerance.crank_deg.length);
  for (const { drive, set } of rows) {
    const k = tolerance.crank_deg.findIndex((deg) => Math.abs(deg - drive) < 1e-3);
    const far = (m) => { const [[x, y], [u, v]] = [sliderCrank(asChain(m), tolerance.crank_deg[k]).p, problem.target.poses[k]]; return Math.hypot(x - u, y - v); };
    near(far(mechanism), nominal[k], 1e-9, "nominal");
    near(set, far({ ...mechanism, crank: mechanism.crank + 0.1 }), 2e-3, `at ${drive}`);
  }
}));

test("a cam's follower is off as its sensitivities say, and at the worst corner by the worst case", { skip: withoutPlots }, () => visit(browser, "toleranced-roller", still, async (page) => {
  const quantity = judgedOf(await resultOf(page));
  const at = async () => (await deviations(page)).reduce((best, row) => (Math.abs(row.drive - quantity.linear_at) < Math.abs(best.drive - quantity.linear_at) ? row : best)).set;
  for (const { dimension, sensitivity } of quantity.contributions) {
    const change = dimension === "roller_radius" ? -0.02 : 0.02;
    await setSlider(page, dimension, change);
    near(await at(), sensitivity * change, 2e-4, dimension);
    await page.locator("[data-set=nominal]").click();
    await page.locator("#tolerances:not(.set)").waitFor();
  }
  await page.locator("[data-set=worst]").click();
  await page.locator("#tolerances.set").waitFor();
  near(Math.abs(await at()), Math.max(-quantity.exact[0], quantity.exact[1]), 5e-4, "worst corner");
}));

test("an analysis with tolerances is edited, and its tolerances are of the original", () => visit(browser, "library-toleranced-rocker", still, async (page) => {
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
  await page.locator('[data-field="crank"]').fill("45");
  await page.locator('[data-field="crank"]').press("Tab");
  assert.equal(await page.locator("#tolerances").evaluate((card) => card.classList.contains("of-original")), true);
  await page.locator('[data-edit="copy"]').click();
  assert.match(await page.locator("#edit-toml").inputValue(), /\[tolerance\]/);
}));

test("the raster stands beside the optimum without one and that rounded", () => visit(browser, "ellipse-on-half-units", still, async (page) => {
  const { facts } = await resultOf(page);
  const bars = await page.locator("#raster-bars .contribution").evaluateAll((all) => all.map((row) => [Number(row.dataset.error), parseFloat(row.querySelector(".bar").style.width)]));
  assert.deepEqual(bars.map(([error]) => error), [facts.continuous_error, facts.raster_error, facts.rounded_error]);
  assert.ok(bars[0][1] < bars[1][1] && bars[1][1] < bars[2][1]);
  const text = await page.locator("#raster-list").textContent();
  assert.ok(text.includes(`${Number((100 * (facts.raster_error - facts.raster_bound) / facts.raster_error).toPrecision(3))} %`), text);
  assert.ok(text.includes(`(${Number((100 * facts.raster_covered / facts.raster_combinations).toPrecision(3))} %)`), text);
  assert.equal(await page.locator("#findings").filter({ hasText: /raster/i }).count(), 0);
  if (!await page.locator(".edit-toggle").isVisible()) return;
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
  for (const id of ["raster", "choice", "findings", "work"]) assert.equal(await page.locator(`#${id}`).evaluate((card) => card.classList.contains("of-original")), true, id);
}));

test("cams and quick returns on a raster say what it costs", async () => {
  for (const [name, measure, unit] of [["oscillating-roller-on-raster", "size", " mm"], ["crank-rocker-on-millimetres", "error_deg", "°"]]) {
    await visit(browser, name, still, async (page) => {
      const { facts } = await resultOf(page);
      const rows = await page.locator("#raster-bars .contribution").evaluateAll((all) => all.map((row) => [Number(row.dataset.error), row.querySelector(".number").textContent]));
      assert.deepEqual(rows.map(([value]) => value), ["continuous", "raster", "rounded"].map((of) => facts[`${of}_${measure}`]));
      assert.ok(rows[1][1].endsWith(unit), rows[1][1]);
      assert.equal(facts.raster_proven, true);
    });
  }
});

// A front as a robust search writes it: the designs of a result again, each with other figures.
test("the front of a robust search chooses its designs", async () => {
  const text = fs.readFileSync(path.join(process.env.REPORTS, "toleranced-ellipse.html"), "utf8");
  const [whole, json] = /<script type="application\/json" id="data">(.*?)<\/script>/s.exec(text);
  const data = JSON.parse(json);
  const figures = [[0.4, 0.6], [0.3, 0.7], [0.27, 0.9]];
  const [first, drawn] = [data.result.designs[0], data.designs[0]];
  data.result.problem.solve.robust = 0.99;
  data.result.designs = figures.map(([nominal_error, quantile]) => ({ ...first, metrics: { ...first.metrics, nominal_error, quantile } }));
  data.designs = figures.map(() => drawn);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-front-"));
  const file = path.join(folder, "robust.html");
  fs.writeFileSync(file, text.replace(whole, () => whole.replace(json, () => JSON.stringify(data).replaceAll("<", "\\u003c"))));
  const { page, faults, close } = await open(browser, file, still);
  try {
    assert.deepEqual(await page.locator("#front .axis").allTextContents(), ["Nominal error, mm", "Quantile of the error, mm"]);
    const points = await page.locator(".front-point").evaluateAll((all) => all.map((point) => [Number(point.getAttribute("cx")), Number(point.getAttribute("cy"))]));
    near((points[0][0] - points[1][0]) / (points[1][0] - points[2][0]), 0.1 / 0.03, 0.05, "places along the first axis");
    near((points[2][1] - points[1][1]) / (points[1][1] - points[0][1]), 2, 0.05, "places along the second");
    await page.locator('.front-point[data-design="2"]').click();
    assert.equal(await page.locator("#design-2").isChecked(), true);
    assert.deepEqual(faults, []);
  } finally {
    await close();
    fs.rmSync(folder, { recursive: true });
  }
});
