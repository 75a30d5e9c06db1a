// Editing a design in its report: what the page says of a linkage is what the program says of it.
// COGNATE: the program.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { launch, visit as visitReport } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";
import { drag, edit, field, type } from "./edits.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const visit = (name, steps) => visitReport(browser, name, { motion: "reduce" }, steps);
const value = (page, row, column = "now") => page.locator(`#edit-values tr[data-row="${row}"] td`).nth(column === "now" ? 2 : 1)
  .evaluate((cell) => JSON.parse(cell.dataset.value));
const result = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result);
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a} and ${b}`);

// The result of the program on the text of a file.
function answered(text, command = "analyze") {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-edit-"));
  try {
    const file = path.join(folder, "edited.toml");
    fs.writeFileSync(file, text);
    execFileSync(process.env.COGNATE, ["check", file], { stdio: "pipe" });
    // A design that misses a constraint is an answer too, with a status of its own.
    return JSON.parse(spawnSync(process.env.COGNATE, [command, "--json", "--out", folder, file], { maxBuffer: 1 << 28 }).stdout);
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

// Copies the design with its targets, has the program solve it again, and compares what both say.
async function copied(page) {
  await page.locator('[data-edit="copy"]').click();
  const { problem, designs: [design] } = answered(await page.locator("#edit-toml").inputValue(), "solve");
  const { problem: before } = await result(page);
  assert.deepEqual([problem.kind, problem.target.points, problem.target.function, problem.constraints], [before.kind, before.target.points, before.target.function, before.constraints]);
  assert.equal(await value(page, "class"), design.metrics.class);
  for (const [row, key] of [["error.sum", "sum_of_squares"], ["error.rms", "rms"], ["error.max", "max"]]) {
    near(await value(page, row), design.error[key], 1e-7 * (1 + design.error[key]), row);
  }
  for (const [row, key] of [["least", "min"], ["greatest", "max"]]) {
    near((await value(page, row)) * 180 / Math.PI, design.metrics.transmission_angle_deg[key], 1e-8, `${row} transmission angle`);
  }
  return design;
}

for (const name of some(["ellipse", "log10-refined", "three-angle-pairs"])) {
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
  for (const [joint, by] of [["P", [8, -6]], ["B", [3, 2]], ["D", [6, -5]], ["C", [4, -3]], ["A", [2, 3]]]) await drag(page, joint, by);
  assert.ok(await value(page, "error.max") > 0.3);
  const { mechanism, metrics } = await copied(page);
  const [a, d] = mechanism.fixed_pivots;
  for (const [key, number] of Object.entries({ crank: mechanism.crank, coupler: mechanism.coupler, rocker: mechanism.rocker, a_x: a[0], a_y: a[1], d_x: d[0], d_y: d[1],
    point_u: mechanism.coupler_point[0], point_v: mechanism.coupler_point[1] })) near(Number(await field(page, key).inputValue()), number, 0, key);
  near(await value(page, "time_ratio"), metrics.time_ratio, 1e-9, "time ratio");
  // The cards follow; what cannot says so.
  assert.match(await page.locator("#qualities-list").textContent(), new RegExp(`Time ratio${String(metrics.time_ratio).slice(0, 5)}`));
  assert.ok(await page.locator("#work.of-original").isVisible());
  await page.locator(".edit-toggle").click();
  assert.equal(await page.locator(".of-original").count(), 0);
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

test("of poses four-bars alone are edited", () => visit("exact-motion", async (page) => {
  const toggle = page.locator(".edit-toggle", { hasText: "Edit" });
  assert.ok(await toggle.isEnabled());
  await page.locator("#design-1").check();
  assert.ok(await toggle.isHidden());
  await page.locator("#design-0").check();
  assert.ok(await toggle.isVisible());
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

const flat = (table, above) => Object.entries(table).flatMap(([key, part]) => (part !== null && typeof part === "object" && !Array.isArray(part) ? flat(part, `${above}${key}.`) : [{ name: above + key, value: part }]));

for (const [name, joint] of some([["library-slider-crank-offset", "C"], ["library-coupler-curve", "P"], ["library-guide-bar-rotating", "B"], ["library-oscillating-block", "D"], ["library-four-bar-forces", "B"],
  ["library-scotch-yoke", "A"]])) {
  test(`${name}: facts unchanged and changed are the program's`, () => visit(name, async (page) => {
    await edit(page);
    await hasFacts(page, await factsOf(page), "before");
    await drag(page, joint, [6, 5]);
    assert.ok(await page.locator("#edit-values tr.changed, [data-edit=undo]:enabled").count() > 0);
    await page.locator('[data-edit="copy"]').click();
    const { designs: [{ metrics }] } = answered(await page.locator("#edit-toml").inputValue());
    await hasFacts(page, flat(metrics, ""), "now");
  }));
}

test("an analysed mechanism that cannot be assembled is refused, and comes back as it was", () => visit("library-slider-crank-offset", async (page) => {
  await edit(page);
  const link = () => page.locator('[data-body="2"] path').first().getAttribute("d");
  const shown = await link();
  await type(page, "coupler", 1e-3);
  assert.match(await page.locator(".edit-status").textContent(), /assembled/);
  assert.equal(await link(), shown);
  await type(page, "coupler", 500);
  assert.notEqual(await link(), shown);
  await page.locator(".edit-toggle").click();
  assert.equal(await link(), shown);
  assert.equal(await page.locator("#edit, .edit-layer").count(), 0);
}));

// Of the table of values: each column's extremes, and where the drive stands each value.
const columnsShown = (page) => page.locator("#values-rows tr").evaluateAll((rows) => rows.map((row) => [row.cells[0].textContent, row.cells[2].textContent, row.cells[3].textContent, row.cells[4].textContent]));
const plain = (text) => { const [digits, power] = text.replaceAll("−", "-").split("×10"); return Number(digits) * 10 ** Number([...(power ?? "⁰")].map((c) => { const at = "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c); return at < 0 ? "-" : at; }).join("")); };

// Loads, masses and dimensions changed: the page's facts, key positions, table, plots' summaries and notes against the program.
for (const [name, joint, fields] of [["library-four-bar-forces", "C", { "load.0.torque": -140, "link.1.mass": 4.5, crank: 0.42, "drive.speed": 12 }], ["library-shaper", "D", { "load.0.force.0": 4000, "crank.length": 0.13, "dyad.1.lengths.0": 0.17 }]]) {
  test(`${name}: every figure of an edited analysis is the program's`, () => visit(name, async (page) => {
    await edit(page);
    await page.locator(".edit details").evaluateAll((all) => all.forEach((part) => { part.open = true; }));
    for (const [key, number] of Object.entries(fields)) await type(page, key, number);
    await drag(page, joint, [4, 3]);
    assert.equal(await page.locator("main.dragging").count(), 0);
    await page.locator('[data-edit="copy"]').click();
    const answer = answered(await page.locator("#edit-toml").inputValue());
    await hasFacts(page, flat(answer.designs[0].metrics, ""), "now");
    // Defects are those of a design, and an analysis has none; residuals are of the computation.
    assert.equal(await page.locator("#edit-values tr").count(), flat(answer.designs[0].metrics, "").filter((one) => !/^defects$|_residual$/.test(one.name)).length);
    await page.locator("#all-parts").click();
    await page.locator("#drive").evaluate((input) => { input.value = 120; input.dispatchEvent(new Event("input")); });
    const shown = await columnsShown(page);
    const { columns, landmarks } = answer.analysis;
    assert.equal(shown.length, columns.length - 1);
    const row = 120;
    for (const [column, now, least, greatest] of shown) {
      const { values } = columns.find((one) => one.name === column);
      const size = Math.max(...values.map(Math.abs));
      // What is left by rounding is shown as no motion.
      if (size < 1e-12) continue;
      near(plain(now), values[row], 5e-6 * size, `${column} now`);
      near(plain(least), Math.min(...values), 5e-5 * size, `minimum of ${column}`);
      near(plain(greatest), Math.max(...values), 5e-5 * size, `maximum of ${column}`);
    }
    assert.equal(await page.locator("#landmarks-rows tr").count(), landmarks.length);
    const places = await page.locator("#landmarks-rows tr").evaluateAll((rows) => rows.map((row) => Number(row.cells[2].textContent.replace("°", "").replace("−", "-"))));
    places.forEach((place, i) => near(Math.sin(((place - (landmarks[i].crank_deg ?? landmarks[i].drive)) * Math.PI) / 360), 0, 1e-4, `key position ${i}`));
    const notes = await page.locator("#notes-list li:not(.warning)").allTextContents();
    assert.deepEqual(notes, answer.notes);
    assert.ok(await page.locator("#work.of-original").isVisible());
  }));
}

test("what is too large to be edited says so, and its page contains no kernel", () => visit("analysis-hundred-links", async (page) => {
  assert.ok(await page.locator(".edit-toggle").isDisabled());
  assert.match(await page.locator(".edit-toggle").getAttribute("title"), /too large/);
  assert.match(await page.locator("#kernel").textContent(), /^$/);
}));

test("handles follow a number that is typed", () => visit("library-slider-crank-offset", async (page) => {
  await edit(page);
  const middle = async (selector) => { const { x, y, width, height } = await page.locator(selector).first().boundingBox(); return [x + width / 2, y + height / 2]; };
  const before = await middle('.edit-handle[data-joint="B"]');
  await type(page, "crank", 1.3 * Number(await field(page, "crank").inputValue()));
  for (const joint of ["B", "C"]) {
    const [handle, pin] = [await middle(`.edit-handle[data-joint="${joint}"]`), await middle(`.layer-pins [data-name="${joint}"]`)];
    near(Math.hypot(handle[0] - pin[0], handle[1] - pin[1]), 0, 1.5, `handle and pin ${joint}`);
  }
  assert.notDeepEqual(await middle('.edit-handle[data-joint="B"]'), before);
}));
