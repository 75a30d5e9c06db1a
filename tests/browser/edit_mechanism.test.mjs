// Editing designs that are no four-bars in their reports: every figure of an edited page is what the program says of the copied
// file. COGNATE: the program.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { assertFits, launch, open } from "./browser.mjs";
import { some } from "./thinned.mjs";
import { drag, edit, field, type } from "./edits.mjs";
import { reported, sameTold, textsOf } from "./told.mjs";

const LIBRARY = new URL("../../problems/library/", import.meta.url).pathname;
const CARDS = ["dimensions", "qualities", "constraints", "curves"];
let browser, folder;
before(async () => { browser = await launch(); folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-mechanisms-")); });
after(() => { fs.rmSync(folder, { recursive: true }); return browser?.close(); });

// A worked problem with few starts: its designs need not be good ones.
function quick(file, starts = process.env.WHOLE ? 256 : 48) {
  const text = fs.readFileSync(path.join(LIBRARY, `${file}.toml`), "utf8").replace(/^(starts|designs) = .*\n/gm, "");
  return /^\[solve\]$/m.test(text) ? text.replace(/^\[solve\]$/m, `[solve]\nstarts = ${starts}`) : `${text}\n[solve]\nstarts = ${starts}\n`;
}

const MECHANISMS = {
  "six-bar path": ["chain/watt-path", { "crank.length": 1.02, "point.0.at.0": 1.01 }, "C"],
  "slider-crank path": ["chain/slider-crank-path", { "dyad.0.lengths.0": 1.03, "dyad.0.slide.direction_deg": 1.05 }, "C"],
  "timed arc of a six-bar": ["chain/timed-arc", { "pivot.1.at.0": 1.01 }, "P"],
  "six-bar with given dimensions": ["chain/partly-fixed", { "dyad.1.lengths.1": 0.98 }, "P"],
  "six-bar function": ["chain-function/six-bar-logarithm", { "dyad.1.lengths.0": 1.01, "point.0.at.0": 1.005 }, "C"],
  "function of a slider": ["chain-function/ram-at-constant-speed", { "crank.length": 1.02, "dyad.1.slide.offset": 1.1 }, "C"],
  "minimax function of a slider-crank": ["chain-function/slider-crank-square", { "crank.length": 1.01, "dyad.0.lengths.0": 0.99 }, "C"],
  "six-bar with a dwell": ["dwell/six-bar-dwell", { "dyad.0.lengths.1": 1.01 }, "F"],
  "leg with its flattest stance": ["leg/klann", { "crank.length": 1.01, "point.1.at.0": 1.01 }, "E"],
  "leg with its longest stance": ["leg/longest-stance", { "dyad.0.lengths.1": 1.005 }, "C"],
};

const status = (page) => page.locator(".edit-status").textContent();

async function scale(page, factors) {
  for (const [key, factor] of Object.entries(factors)) {
    await type(page, key, factor * Number(await field(page, key).inputValue()));
    assert.equal(await status(page), "", key);
  }
}

async function opened(name, file, options, steps) {
  const { page, faults, close } = await open(browser, reported(folder, name.replaceAll(" ", "-"), quick(file)), { motion: "reduce", ...options });
  await steps(page);
  assert.doesNotMatch(await page.locator("main").innerText(), /NaN|Infinity|undefined/);
  assert.deepEqual(faults, []);
  await close();
}

// What the cards say with the crank at 100°, but for what the structure is called.
async function toldBy(page) {
  await page.locator("#crank").evaluate((slider) => { slider.value = 100; slider.dispatchEvent(new Event("input")); });
  const texts = await textsOf(page, CARDS);
  return { ...texts, qualities: texts.qualities.replace(/Topology \S+/, ""), readout: await page.locator("#readout").textContent() };
}

const copyOf = async (page) => { await page.locator('[data-edit="copy"]').click(); return page.locator("#edit-toml").inputValue(); };

// The one design that the program finds in a file.
function solved(text) {
  const file = path.join(folder, "copied.toml");
  fs.writeFileSync(file, text);
  execFileSync(process.env.COGNATE, ["check", file], { stdio: "pipe" });
  const { designs } = JSON.parse(spawnSync(process.env.COGNATE, ["solve", "--json", "--out", folder, file], { maxBuffer: 1 << 28 }).stdout);
  assert.equal(designs.length, 1);
  return designs[0];
}

// The designs of a file that was reported.
const designsOf = (name) => JSON.parse(fs.readFileSync(path.join(folder, `${name.replaceAll(" ", "-")}.result.json`))).designs;

const flat = (table, above = "") => Object.entries(table).flatMap(([key, part]) => (part !== null && typeof part === "object" && !Array.isArray(part) ? flat(part, `${above}${key}.`) : [[above + key, part]]));

// Rows of the panel as they are now, or were before, by their names.
const NOW = 2, BEFORE = 1;
const rowsOf = (page, cell = NOW) => page.locator("#edit-values tr").evaluateAll((rows, which) => rows.map((row) => [row.dataset.row, JSON.parse(row.cells[which].dataset.value)]), cell);

// What is minimised, the mean or the largest error, is not greater than that of the design found: where the crank is, is found anew.
function assertNotWorse(rows, { error }) {
  const shown = Object.fromEntries(rows);
  const isKept = ([key, value]) => shown[key] <= value * (1 + 1e-6) + 1e-9;
  assert.ok([["error.rms", error.rms_deg ?? error.rms], ["error.max", error.max_deg ?? error.max]].some(isKept), JSON.stringify([shown, error]));
}

function sameRows(rows, { error, metrics }) {
  const wanted = new Map([...flat(metrics), ["error.max", error.max_deg ?? error.max], ["error.rms", error.rms_deg ?? error.rms], ["error.sum", error.sum_of_squares]]);
  assert.ok(rows.length >= 6);
  for (const [name, value] of rows) {
    if (typeof value === "number") assert.ok(Math.abs(value - wanted.get(name)) <= 1e-8 * (1 + Math.abs(wanted.get(name))), `${name}: ${value} and ${wanted.get(name)}`);
    else assert.deepEqual(value, wanted.get(name), name);
  }
  for (const name of wanted.keys()) assert.ok(rows.some(([key]) => key === name) || /^(topology|change_point|time_ratio)$/.test(name), `${name} is not shown`);
}

for (const [name, [file, factors, joint]] of some(Object.entries(MECHANISMS))) {
  test(`${name}: every figure of an edited design is the program's, and comes back`, () => opened(name, file, {}, async (page) => {
    await edit(page);
    assertNotWorse(await rowsOf(page, BEFORE), designsOf(name)[0]);
    const first = await toldBy(page), rows = await rowsOf(page);
    await scale(page, factors);
    await drag(page, joint, [5, 4]);
    assert.equal(await status(page), "");
    assert.match(await page.locator(".summary").getAttribute("class"), /of-original/);
    const copy = await copyOf(page);
    const design = solved(copy);
    sameRows(await rowsOf(page), design);
    assert.notDeepEqual(await rowsOf(page), rows);
    assert.equal(await page.locator("#edit-checks tr").count(), design.constraints.length);
    assert.equal(await page.locator("#edit-checks .mark.no").count(), design.constraints.filter((check) => !check.satisfied).length);

    const shown = await toldBy(page);
    const second = await open(browser, reported(folder, "copied", copy), { motion: "reduce" });
    const wanted = await toldBy(second.page);
    for (const part of Object.keys(wanted)) sameTold(shown[part], wanted[part], `${name}, ${part}`, 1e-5);
    await second.close();

    const undo = page.locator('[data-edit="undo"]');
    let steps = 0;
    for (; await undo.isEnabled(); steps += 1) await undo.click();
    assert.equal(steps, Object.keys(factors).length + 1);
    assert.deepEqual(await toldBy(page), first);
    assert.deepEqual(await rowsOf(page), rows);
    await page.locator(".edit-toggle").click();
    assert.equal(await page.locator(".of-original, .edit-ghost, #edit").count(), 0);
  }));
}

test("dimensions with which a mechanism cannot be assembled are refused, and the page stays as it is", () => opened("unassembled", "chain/watt-path", {}, async (page) => {
  await edit(page);
  const first = await textsOf(page, CARDS), rows = await rowsOf(page);
  const length = await field(page, "crank.length").inputValue();
  for (const [value, words] of [[1e4, /cannot be assembled/], [-2, /crank/], ["", /number/]]) {
    await type(page, "crank.length", value);
    assert.match(await status(page), words);
    assert.deepEqual(await textsOf(page, CARDS), first);
    assert.deepEqual(await rowsOf(page), rows);
    assert.equal(await field(page, "crank.length").inputValue(), length);
  }
}));

for (const [size, locale] of [["laptop", "en-GB"], ["phone", "zh-CN"]]) {
  test(`an edited mechanism fits on a ${size}`, () => opened(`fits ${size}`, "chain/slider-crank-path", { size, locale }, async (page) => {
    await edit(page);
    await scale(page, { "crank.length": 1.01 });
    await assertFits(page);
  }));
}

test("what a file specifies is checked of an edited design, also where its synthesis met it", async () => {
  const text = fs.readFileSync(path.join(LIBRARY, "quick-return/crank-rocker-best.toml"), "utf8");
  const { page, close } = await open(browser, reported(folder, "specified", text), { motion: "reduce" });
  await edit(page);
  const missed = () => page.locator("#edit-checks tr.missed td:first-child").allTextContents();
  assert.deepEqual(await missed(), []);
  await scale(page, { coupler: 1.02 });
  assert.deepEqual((await missed()).sort(), ["Swing", "Time ratio"]);
  await close();
});

test("where a page cannot evaluate what is designed, no button offers it", () => opened("raster", "motion/slider-crank", {}, async (page) => {
  assert.ok(await page.locator(".edit-toggle").isHidden());
}));
