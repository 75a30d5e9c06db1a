// Editing a design in its report: what the page says of a linkage is what the program says of it.
// COGNATE: the program.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { launch, visit as visitReport } from "./browser.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const visit = (name, steps) => visitReport(browser, name, { motion: "reduce" }, steps);
const value = (page, row, column = "now") => page.locator(`#edit-values tr[data-row="${row}"] td`).nth(column === "now" ? 2 : 1)
  .evaluate((cell) => JSON.parse(cell.dataset.value));
const result = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result);
const field = (page, key) => page.locator(`[data-field="${key}"]`);
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} and ${b}`);

async function edit(page) {
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
}

async function type(page, key, number) {
  await field(page, key).fill(String(number));
  await field(page, key).press("Tab");
}

async function drag(page, joint, by) {
  const box = await page.locator(`[data-joint="${joint}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by[0], y + by[1], { steps: 5 });
  await page.mouse.up();
}

// The result of `cognate analyze` on the text of a file.
function analysed(text) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-edit-"));
  try {
    const file = path.join(folder, "edited.toml");
    fs.writeFileSync(file, text);
    execFileSync(process.env.COGNATE, ["check", file], { stdio: "pipe" });
    return JSON.parse(execFileSync(process.env.COGNATE, ["analyze", "--json", "--out", folder, file], { maxBuffer: 1 << 28 }));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

// Copies the linkage, has the program analyse it, and compares what both say.
async function copied(page) {
  await page.locator('[data-edit="copy"]').click();
  const { designs: [design] } = analysed(await page.locator("#edit-toml").inputValue());
  assert.equal(await value(page, "class"), design.metrics.class);
  for (const [row, key] of [["least", "min"], ["greatest", "max"]]) {
    near((await value(page, row)) * 180 / Math.PI, design.metrics.transmission_angle_deg[key], 1e-8, `${row} transmission angle`);
  }
  return design;
}

for (const name of ["ellipse", "log10-refined", "three-angle-pairs"]) {
  test(`unchanged, ${name} has the errors and metrics of the result`, () => visit(name, async (page) => {
    await edit(page);
    const { designs: [{ error, metrics, constraints }] } = await result(page);
    near(await value(page, "error.sum"), error.sum_of_squares, 1e-9 * (1 + error.sum_of_squares), "sum of squares");
    near(await value(page, "error.rms"), error.rms, 1e-9, "root mean square");
    near(await value(page, "error.max"), error.max, 1e-9, "largest");
    near((await value(page, "least")) * 180 / Math.PI, metrics.transmission_angle_deg.min, 1e-9, "least transmission angle");
    near((await value(page, "greatest")) * 180 / Math.PI, metrics.transmission_angle_deg.max, 1e-9, "greatest transmission angle");
    assert.equal(await value(page, "class"), metrics.class);
    assert.deepEqual(await value(page, "defects"), metrics.defects);
    assert.equal(await page.locator("#edit-checks .mark.no").count(), constraints.filter((c) => !c.satisfied).length);
    assert.equal(await page.locator("#edit-checks tr").count(), constraints.length);
  }));
}

test("a dragged linkage, copied as TOML, is to the program what it is to the page", () => visit("ellipse", async (page) => {
  await edit(page);
  for (const [joint, by] of [["P", [20, -15]], ["B", [3, 2]], ["D", [-6, 5]], ["C", [4, -3]], ["A", [2, 3]]]) await drag(page, joint, by);
  assert.ok(await value(page, "error.max") > 1);
  const { mechanism, metrics } = await copied(page);
  const [a, d] = mechanism.fixed_pivots;
  for (const [key, number] of Object.entries({ crank: mechanism.crank, coupler: mechanism.coupler, rocker: mechanism.rocker, a_x: a[0], a_y: a[1], d_x: d[0], d_y: d[1],
    point_u: mechanism.coupler_point[0], point_v: mechanism.coupler_point[1] })) near(Number(await field(page, key).inputValue()), number, 0, key);
  near(await value(page, "time_ratio"), metrics.time_ratio, 1e-9, "time ratio");
}));

test("so is one that is used over a part of its turn", () => visit("log10-refined", async (page) => {
  await edit(page);
  await drag(page, "C", [10, 8]);
  await copied(page);
}));

test("changes can be taken back and made again, from the keyboard too", () => visit("ellipse", async (page) => {
  await edit(page);
  const crank = Number(await field(page, "crank").inputValue());
  await type(page, "crank", crank * 1.5);
  const changed = await value(page, "error.max");
  assert.ok(changed > await value(page, "error.max", "before"));
  await page.locator('[data-joint="P"]').focus();
  await page.keyboard.press("Shift+ArrowUp");
  assert.notEqual(await value(page, "error.max"), changed);
  await page.locator('[data-edit="undo"]').click();
  assert.equal(await value(page, "error.max"), changed);
  await page.locator('[data-edit="undo"]').click();
  assert.equal(Number(await field(page, "crank").inputValue()), crank);
  await page.locator('[data-edit="redo"]').click();
  assert.equal(await value(page, "error.max"), changed);
  await page.locator('[data-edit="reset"]').click();
  assert.equal(Number(await field(page, "crank").inputValue()), crank);
  await page.locator(".edit-toggle").click();
  assert.equal(await page.locator("#edit, .edit-layer").count(), 0);
}));

test("links that cannot be assembled are named, and the picture stays", () => visit("ellipse", async (page) => {
  await edit(page);
  const picture = () => page.locator("#picture > svg").first().evaluate((root) => root.innerHTML);
  const shown = await picture();
  const error = await value(page, "error.max");
  await type(page, "crank", 1e5);
  assert.match(await page.locator(".edit-status").textContent(), /Crank.*100\s?000|Crank.*1×10|Crank.*100000/);
  for (const wrong of ["0", "-3", ""]) await type(page, "rocker", wrong);
  assert.match(await page.locator(".edit-status").textContent(), /above 0/);
  assert.equal(await picture(), shown);
  assert.equal(await value(page, "error.max"), error);
  assert.doesNotMatch(await page.locator("main").innerText(), /NaN|Infinity|undefined/);
}));

test("the start angles of a function generator are dimensions too", () => visit("log10-refined", async (page) => {
  await edit(page);
  const before_ = await value(page, "error.max");
  const output = Number(await field(page, "output").inputValue());
  await type(page, "output", output + 2);
  near(await value(page, "error.max"), before_ + (2 * Math.PI) / 180, 2 * before_, "largest error");
}));

test("what is no four-bar is not edited", () => visit("exact-motion", async (page) => {
  assert.ok(await page.locator(".edit-toggle").isVisible());
  await page.locator("#design-1").check();
  assert.ok(await page.locator(".edit-toggle").isHidden());
}));

// The facts of the page's data, which are the program's, beside those of the kernel.
const factsOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent).facts);

async function hasFacts(page, facts, column) {
  const rows = await page.locator("#edit-values tr").evaluateAll((all) => all.map((row) => row.dataset.row));
  assert.ok(rows.length >= 4);
  for (const name of rows) {
    const [shown, { value: wanted }] = [await value(page, name, column), facts.find((fact) => fact.name === name)];
    if (typeof shown === "number") near(shown, wanted, 1e-8 * (1 + Math.abs(wanted)), name); else assert.equal(shown, wanted, name);
  }
}

for (const [name, joint] of [["library-slider-crank-offset", "C"], ["library-coupler-curve", "P"], ["library-guide-bar-rotating", "B"], ["library-oscillating-block", "D"], ["library-four-bar-forces", "B"],
  ["library-scotch-yoke", "A"]]) {
  test(`${name}: facts unchanged and changed are the program's`, () => visit(name, async (page) => {
    await edit(page);
    await hasFacts(page, await factsOf(page), "before");
    await drag(page, joint, [6, 5]);
    assert.ok(await page.locator("#edit-values tr.changed, [data-edit=undo]:enabled").count() > 0);
    await page.locator('[data-edit="copy"]').click();
    const { designs: [{ metrics }] } = analysed(await page.locator("#edit-toml").inputValue());
    const flat = (table, above) => Object.entries(table).flatMap(([key, part]) => (part !== null && typeof part === "object" && !Array.isArray(part) ? flat(part, `${above}${key}.`) : [{ name: above + key, value: part }]));
    await hasFacts(page, flat(metrics, ""), "now");
  }));
}

test("an analysed mechanism that cannot be assembled is refused, and comes back as it was", () => visit("library-slider-crank-offset", async (page) => {
  await edit(page);
  const link = () => page.locator('[data-body="2"] path').first().getAttribute("d");
  const shown = await link();
  await type(page, "coupler", 1e-3);
  assert.match(await page.locator(".edit-status").textContent(), /cannot be assembled/);
  assert.equal(await link(), shown);
  await type(page, "coupler", 500);
  assert.notEqual(await link(), shown);
  await page.locator(".edit-toggle").click();
  assert.equal(await link(), shown);
  assert.equal(await page.locator("#edit, .edit-layer").count(), 0);
}));

test("chains are not edited, and their pages bear no kernel", () => visit("library-shaper", async (page) => {
  assert.equal(await page.locator(".edit-toggle").count(), 0);
  assert.match(await page.locator("#kernel").textContent(), /^$/);
}));
