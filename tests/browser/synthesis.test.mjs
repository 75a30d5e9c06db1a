// The pages of exact syntheses: designs of every type, poses, curves and families.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { reported } from "./told.mjs";
import { LOOKS, assertFits, assertInked, distance, hasCurves, launch, open, visit as visitReport, withoutPlots } from "./browser.mjs";
import { some } from "./thinned.mjs";

const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `exact-${name}`, options, steps);

const crankTo = (page, value) => page.locator("#crank").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const choose = (page, index) => page.locator(`#design-${index}`).check();
const fact = (page, list, name) => page.locator(`#${list}-list dt`, { hasText: name }).locator("+ dd").first().textContent();
const placed = (page, selector) => page.locator(selector).evaluateAll((all) => all.map((g) => {
  const { e, f, a, b } = g.transform.baseVal.consolidate().matrix;
  return [e, f, Math.atan2(-b, a) * 180 / Math.PI];
}));

for (const { size, scheme } of LOOKS) {
  for (const name of some(["motion", "quick-return", "straight-line", "nine-points"])) {
    test(`${name} fits a ${size} in ${scheme} colours, with any design chosen`, () => visit(name, { size, scheme, ...still }, async (page) => {
      const count = Math.min(4, await page.locator("#designs tbody").count());
      for (let i = 0; i < count; ++i) {
        await choose(page, i);
        await assertFits(page);
        assert.doesNotMatch(await page.locator("#picture").innerHTML(), /NaN|undefined/);
        await assertInked(page, 300);
      }
    }));
  }
}

// The body's own axes and those of each pose were computed by different code.
test("the guided body's axes lie on those of each pose when the crank is there", () => visit("motion", still, async (page) => {
  const poses = await placed(page, ".pose:not(.guided)");
  assert.equal(poses.length, 4);
  for (const [i, crank] of [0.4, 1.2, 2.1, 3.0].entries()) {
    await crankTo(page, crank * 180 / Math.PI);
    const [guided] = await placed(page, ".pose.guided");
    assert.ok(distance(guided, poses[i]) < 0.3, `${guided} ${poses[i]}`);
    assert.ok(Math.abs(guided[2] - poses[i][2]) < 0.3);
  }
}));

test("each type of mechanism is drawn with its own parts, and moves", () => visit("motion", still, async (page) => {
  assert.equal(await page.locator(".link-body.rocker").count(), 1);
  for (const index of [1, 2, 3]) {
    await choose(page, index);
    assert.equal(await page.locator("#picture > svg[role=img]").count(), 1);
    assert.ok(await page.locator(".block").count() > 0);
    const before = await page.locator(".layer-bodies").innerHTML();
    await page.locator("#title").click();
    await page.keyboard.press("Shift+ArrowRight");
    assert.notEqual(await page.locator(".layer-bodies").innerHTML(), before);
  }
  assert.equal(await fact(page, "dimensions", "Mechanism"), "Elliptic-trammel");
  await choose(page, 0);
  assert.equal(await page.locator(".layer-bodies").count(), 0);
}));

test("a slider is dragged along its guide", () => visit("motion", still, async (page) => {
  await choose(page, 1);
  const [picture, b] = [await page.locator("#picture").boundingBox(), await page.locator('.layer-pins [data-name="B"]').boundingBox()];
  const crank = () => page.locator("#crank-value").textContent();
  const before = await crank();
  await page.mouse.move(b.x + b.width / 2, b.y + b.height / 2);
  await page.mouse.down();
  await page.mouse.move(picture.x + b.x - picture.x - 20, b.y - 40, { steps: 4 });
  await page.mouse.up();
  assert.notEqual(await crank(), before);
}));

test("curves of the synthesis are shown and hidden by their buttons", () => visit("motion", still, async (page) => {
  const names = await page.locator("#loci button").allTextContents();
  assert.deepEqual(names, ["Centre-point curve", "Circle-point curve", "Poles"]);
  assert.equal(await page.locator(".synthesis-locus").count(), 3);
  assert.equal(await page.locator(".locus-point").count(), 3);
  await page.locator("#loci button").first().click();
  assert.equal(await page.locator('[data-locus="0"]').count(), 0);
  await choose(page, 1);
  assert.equal(await page.locator(".synthesis-locus").count(), 2);
  await page.locator("#loci button").first().focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator('[data-locus="0"]').count(), 1);
}));

test("what the synthesis reports of itself is shown", () => visit("motion", still, async (page) => {
  assert.equal(await fact(page, "findings", "Real dyads"), "12");
  assert.match(await page.locator("#notes").textContent(), /unbounded/);
  await choose(page, 1);
  assert.equal(await fact(page, "qualities", "Maximum pressure angle"), "28.5°");
  assert.equal(await fact(page, "qualities", "Class"), "crank turns fully");
}));

test("a family is plotted, and chooses designs", { skip: withoutPlots }, () => visit("quick-return", still, async (page) => {
  assert.equal(await page.locator("#families-title").textContent(), "Family: crank pivot on its circle");
  assert.match(await page.locator("#designs").textContent(), /mirror image of 1/);
  assert.deepEqual(await page.locator("#families-plots h3").allTextContents(), ["Minimum transmission angle, °", "Crank", "Frame"]);
  const plot = page.locator("#families-plots .u-over").first();
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  await page.mouse.click(box.x + 0.7 * box.width, box.y + box.height / 2);
  assert.equal(await page.locator("#design-1").isChecked(), true);
  await page.mouse.click(box.x + 0.2 * box.width, box.y + box.height / 2);
  assert.equal(await page.locator("#design-0").isChecked(), true);
}));

test("a quick return has no errors to magnify", () => visit("quick-return", still, async (page) => {
  assert.equal(await page.locator("#magnify-label").isVisible(), false);
  assert.doesNotMatch(await page.locator("#qualities").textContent(), /Sum of squares/);
}));

test("the straight stretch is marked on the curve", () => visit("straight-line", still, async (page) => {
  const [stretch, curve] = await page.evaluate(() => [".stretch", ".path"].map((name) => document.querySelector(name).getTotalLength()));
  assert.ok(stretch > 50 && stretch < 0.9 * curve, `${stretch} ${curve}`);
  assert.match(await page.locator("body").textContent(), /straight to 0\.1 % over 2\.125/);
  assert.match(await page.locator("#qualities").textContent(), /Straight length at 0\.1 %/);
  if (hasCurves) assert.match(await page.locator(".plot h3").nth(1).textContent(), /Deviation from the straight line/);
}));

test("two hundred designs make a page below 1.5 MB", () => visit("nine-points", still, async (page) => {
  assert.ok(statSync(path.join(process.env.REPORTS, "exact-nine-points.html")).size < 1.5e6);
  assert.equal(await page.locator("#designs tbody").count(), 200);
  await choose(page, 199);
  assert.equal(await page.locator("#stage-title").textContent(), "Linkage of design 200");
}));

test("a synthesis prints in light colours", () => visit("motion", { ...still, scheme: "dark" }, async (page) => {
  assert.ok((await page.pdf({ format: "A4" })).length > 20000);
}));

// Columns of the plot that have the colour of a custom property, as [first, last].
const columnsOf = (page, nth, name) => page.evaluate(([n, property]) => {
  const canvas = document.querySelectorAll("#plots canvas")[n];
  const probe = document.createElement("canvas").getContext("2d");
  probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(property).trim();
  probe.fillRect(0, 0, 1, 1);
  const [r, g, b] = probe.getImageData(0, 0, 1, 1).data;
  const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const has = Array.from({ length: width }, (_, x) => { for (let y = 0; y < height; ++y) { const i = 4 * (y * width + x); if (data[i] === r && data[i + 1] === g && data[i + 2] === b) return true; } return false; });
  return has.reduce((groups, on, x) => { if (on) { if (has[x - 1]) groups.at(-1)[1] = x; else groups.push([x, x]); } return groups; }, []);
}, [nth, name]);

// Chebyshev's spacing: x = 3/2 − cos((2k − 1)π/6)/2.
test("precision points stand on the plot of the structural error", { skip: withoutPlots }, () => visitReport(browser, "log10", still, async (page) => {
  const wanted = [1, 2, 3].map((k) => 1.5 - 0.5 * Math.cos(((2 * k - 1) * Math.PI) / 6));
  const note = await page.locator("#plots .plot p").nth(1).textContent();
  const printed = /x = ([\d., ]+)$/.exec(note)[1].split(", ").map(Number);
  assert.equal(printed.length, 3, note);
  printed.forEach((x, k) => assert.ok(Math.abs(x - wanted[k]) < 5e-4, note));
  const rings = await columnsOf(page, 1, "--target");
  const groups = rings.reduce((all, [from, to]) => { if (all.length && from - all.at(-1)[1] < 12) all.at(-1)[1] = to; else all.push([from, to]); return all; }, []);
  const [first, second, third] = groups.map(([from, to]) => (from + to) / 2);
  assert.equal(groups.length, 3, JSON.stringify(rings));
  assert.ok(Math.abs((second - first) / (third - second) - (wanted[1] - wanted[0]) / (wanted[2] - wanted[1])) < 0.05, JSON.stringify(groups));
}));

test("an edited design has no precision points", { skip: withoutPlots }, () => visitReport(browser, "log10", still, async (page) => {
  if (!await page.locator(".edit-toggle").isVisible()) return;
  await page.locator(".edit-toggle").click();
  await page.locator('[data-field="coupler"]').fill("2.2");
  await page.locator('[data-field="coupler"]').press("Tab");
  assert.doesNotMatch(await page.locator("#plots .plot p").nth(1).textContent(), /precision points/);
}));

test("the structural error of an exact slider-crank is that of its closure, and vanishes at Chebyshev's points", async () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), "cognate-slider-"));
  const text = readFileSync(new URL("../../problems/library/function/slider-crank-square.toml", import.meta.url), "utf8");
  const { page, faults, close } = await open(browser, reported(folder, "square", text), still);
  const { result: { designs }, designs: drawn } = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
  // The third has links so long that angles of seven digits say nothing.
  for (const [i, { mechanism: { crank, coupler, offset, assembly }, metrics, error }] of designs.slice(0, 2).entries()) {
    const { x, crank_deg: degrees, error: errors } = drawn[i].trace;
    assert.equal(errors.length, 201);
    degrees.forEach((deg, k) => {
      const angle = deg * Math.PI / 180;
      const along = crank * Math.cos(angle) + (assembly === "open" ? 1 : -1) * Math.sqrt(coupler ** 2 - (crank * Math.sin(angle) - offset) ** 2);
      assert.ok(Math.abs(along - metrics.output_start - 100 * x[k] ** 2 - errors[k]) < 2e-6 * (crank + coupler), `design ${i + 1} at ${deg}`);
    });
    assert.ok(Math.abs(Math.max(...errors.map(Math.abs)) - error.max) < 0.01 * error.max);
  }
  if (hasCurves) {
    const note = await page.locator("#plots p", { hasText: "precision points" }).textContent();
    for (let k = 1; k <= 5; ++k) assert.ok(note.includes(String(Number((0.5 - 0.5 * Math.cos((2 * k - 1) * Math.PI / 10)).toPrecision(4)))), `${k} in ${note}`);
  }
  assert.deepEqual(faults, []);
  await close();
  rmSync(folder, { recursive: true });
});
