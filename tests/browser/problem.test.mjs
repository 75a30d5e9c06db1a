// The card "Problem" of every report: what was asked, in words, and the file itself, which the program
// reads as the same problem. COGNATE: the program.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { launch, open, visit as visitReport } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const LIBRARY = new URL("../../problems/library/", import.meta.url).pathname;
let browser, folder;
before(async () => {
  browser = await launch();
  folder = mkdtempSync(path.join(tmpdir(), "cognate-problem-"));
});
after(() => {
  rmSync(folder, { recursive: true });
  return browser?.close();
});

const visit = (name, options, steps) => visitReport(browser, name, { motion: "reduce", ...options }, steps);
const rows = (page) => page.evaluate(() => Object.fromEntries([...document.querySelectorAll("#problem-list dt")].map((dt) => [dt.textContent, dt.nextElementSibling.textContent.replaceAll("\u00a0", " ")])));
const written = (page) => page.evaluate(() => [document.getElementById("problem-file").textContent, JSON.parse(document.getElementById("data").textContent).result.problem]);

// What samples made in C++ leave to the reader is filled in.
function assertHolds(read, problem, where) {
  if (problem === null || typeof problem !== "object") return assert.equal(read, problem, where);
  for (const [key, value] of Object.entries(problem)) assertHolds(read?.[key], value, `${where}.${key}`);
  if (Array.isArray(problem)) assert.equal(read.length, problem.length, where);
}

async function assertIsProblem(page, name) {
  const [text, problem] = await written(page);
  const file = path.join(folder, `${name}.toml`);
  writeFileSync(file, text);
  const { valid, ...read } = JSON.parse(execFileSync(process.env.COGNATE, ["check", "--json", file], { encoding: "utf8" }));
  assertHolds(read.problem ?? read, problem, name);
  assert.equal(await page.locator("#problem-file").isVisible(), false);
  await page.locator("#problem summary").click();
  assert.equal(await page.locator("#problem-file").isVisible(), true);
}

// Of each kind, among them a chain, expressions, tables and names that users made up.
for (const name of some(["ellipse", "log10-refined", "three-angle-pairs", "exact-motion", "gear-gear", "gear-pair",
  "gear-worm", "library-shaper", "library-four-bar-forces", "machine-compressor", "machine-torque-table", "machine-run-up", "hostile"])) {
  test(`${name}: the file is the problem`, () => visit(name, {}, (page) => assertIsProblem(page, name)));
}

test("the card says whose error is to be least", async () => {
  const file = path.join(folder, "slider-crank-robust.toml");
  writeFileSync(file, readFileSync(path.join(LIBRARY, "chain", "slider-crank-robust.toml"), "utf8").replace("starts = 64", "starts = 1"));
  execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, file]);
  const { page, faults, close } = await open(browser, path.join(folder, "slider-crank-robust.report.html"), { motion: "reduce" });
  assert.equal((await rows(page)).Robust, "0.9");
  await assertIsProblem(page, "slider-crank-robust");
  assert.deepEqual(faults, []);
  await close();
});

test("limits over the cycle have their units", async () => {
  const limits = "torque_ripple_max = 900\npeak_torque_max = 900\nrms_torque_max = 900\nmotor_power_max = 9000\nspeed_fluctuation_max = 1.9\n";
  const file = path.join(folder, "limited.toml");
  writeFileSync(file, readFileSync(path.join(LIBRARY, "function", "logarithm-small-flywheel.toml"), "utf8").replace("[constraints]\n", `[constraints]\n${limits}`).replace("[flywheel]\n", "[flywheel]\ninertia = 6\n").replace("starts = 32", "starts = 2"));
  execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, file]);
  const { page, faults, close } = await open(browser, path.join(folder, "limited.report.html"), { motion: "reduce" });
  const { Constraints } = await rows(page);
  for (const limit of ["torque ripple 900 N·m;", "rms torque 900 N·m;", "power 9000 W", "fluctuation 1.9;", "6 kg·m²"]) assert.ok(`${Constraints};`.includes(limit), `${limit} in ${Constraints}`);
  assert.deepEqual(faults, []);
  await close();
});

test("the bounds of a dyad are those of its links", async () => {
  const file = path.join(folder, "bounded.toml");
  writeFileSync(file, `${readFileSync(path.join(LIBRARY, "chain", "watt-path.toml"), "utf8")}\n[solve]\nstarts = 16\n`);
  execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, file]);
  const { page, faults, close } = await open(browser, path.join(folder, "bounded.report.html"), { motion: "reduce" });
  const bounds = (await rows(page)).Bounds;
  assert.match(bounds, /A x −12 … 12, y −12 … 12;/);
  assert.match(bounds, /B 0.2 … 12; BC 0.2 … 12; CD 0.2 … 12;/);
  assert.doesNotMatch(bounds, /[^−]12 … 12|0.2 … 0.2/);
  assert.deepEqual(faults, []);
  await close();
});

test("a design with a three-pin link is shown by the distances of its pins, and not edited", async () => {
  const file = path.join(folder, "plate.toml");
  writeFileSync(file, `${readFileSync(path.join(LIBRARY, "chain", "three-pin-path.toml"), "utf8")}\n[solve]\nstarts = 16\n`);
  execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, file]);
  const { page, faults, close } = await open(browser, path.join(folder, "plate.report.html"), { motion: "reduce" });
  const { at, direction_deg: turned, joint } = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result.designs[0].mechanism.dyad[0]);
  const shown = await page.evaluate(() => Object.fromEntries([...document.querySelectorAll("#dimensions dt")].map((dt) => [dt.textContent, Number(dt.nextElementSibling.textContent)])));
  const pins = joint.slice(3).map(({ at: [, own] }) => own);
  for (const [name, i, j] of [["CEF C–E", 0, 1], ["CEF C–F", 0, 2], ["CEF E–F", 1, 2]]) {
    assert.ok(Math.abs(shown[name] - Math.hypot(pins[i][0] - pins[j][0], pins[i][1] - pins[j][1])) < 1e-5, name);
  }
  // Drawn with the crank at angle 0, where G stands, from which GF holds F.
  const [g, plate] = [at[2], at[3]], angle = turned[3] * Math.PI / 180;
  const f = [plate[0] + Math.cos(angle) * pins[2][0] - Math.sin(angle) * pins[2][1], plate[1] + Math.sin(angle) * pins[2][0] + Math.cos(angle) * pins[2][1]];
  assert.ok(Math.abs(shown["Link G–F"] - Math.hypot(f[0] - g[0], f[1] - g[1])) < 1e-5);
  assert.ok(await page.locator(".edit-toggle").isHidden());
  assert.deepEqual(faults, []);
  await close();
});

test("a front of the largest error is drawn by that", async () => {
  const file = path.join(folder, "square.toml"), text = readFileSync(path.join(LIBRARY, "chain-function", "slider-crank-square.toml"), "utf8");
  writeFileSync(file, `${text.split("\n[solve]")[0]}\n[solve]\nobjectives = ["error", "size"]\nstarts = 24\ndesigns = 3\n`);
  execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, file]);
  const { page, faults, close } = await open(browser, path.join(folder, "square.report.html"), { motion: "reduce" });
  const designs = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent).result.designs);
  const labels = await page.locator("#front-plot .front-point").evaluateAll((marks) => marks.map((mark) => mark.getAttribute("aria-label")));
  assert.equal(labels.length, designs.length);
  assert.ok(designs.length > 1);
  for (const [i, { error }] of designs.entries()) {
    const shown = labels[i].match(/[0-9.]+(?:e-[0-9]+)?/g).map(Number);
    assert.ok(shown.some((value) => Math.abs(value / error.max - 1) < 1e-3), `${labels[i]} without ${error.max}`);
  }
  assert.deepEqual(faults, []);
  await close();
});

// Those of which no sample is a whole problem.
for (const [kind, name] of some([["cam", "valve"], ["cam", "oscillating-roller"], ["quick-return", "crank-rocker-best"], ["straight-line", "chebyshev-classical"], ["path", "poses-and-points"]])) {
  test(`${kind}/${name}: the file is the problem`, async () => {
    execFileSync(process.env.COGNATE, ["solve", "--quiet", "--out", folder, path.join(LIBRARY, kind, `${name}.toml`)]);
    const { page, faults, close } = await open(browser, path.join(folder, `${name}.report.html`), { motion: "reduce" });
    await assertIsProblem(page, name);
    assert.deepEqual(faults, []);
    await close();
  });
}

test("a machine is described by its masses, loads and motor", () => visit("machine-press", {}, async (page) => {
  const card = await rows(page);
  assert.equal(card["Kind"], "Machine dynamics");
  assert.equal(card["Link 2"], "name coupler; mass 18 kg; centre (0.2, 0); inertia 0.4 kg·m²");
  assert.equal(card["Load"], "on slider; force (−40000, 0) N; when advance; stroke 0.7 … 1");
  assert.match(card["Motor"], /^line stall torque 900 N·m; no load speed 157.08 rad\/s; ratio 20;/);
  assert.equal(card["Gravity"], "(9.80665, 0) units/s²");
  assert.equal(card["Flywheel"], "fluctuation 0.1");
}));

test("a path is described by its points, bounds and limits", () => visit("ellipse", {}, async (page) => {
  const card = await rows(page);
  assert.match(card["Target"], /^points \(20, 10\), \(17.66, 15.142\), \(11.736, 17.878\), \(5, 16.928\) … \(10\); timing free; /);
  assert.equal(card["Bounds"], "crank 5 … 80; coupler 5 … 80; rocker 5 … 80; frame 5 … 80");
  assert.match(card["Constraints"], /^class crank-rocker; transmission angle 45 … 135°; no branch defect;/);
  assert.equal(card["Lengths in"], undefined);
}));

test("the card is translated into Chinese", () => visit("machine-press", { locale: "zh-CN" }, async (page) => {
  const card = await rows(page);
  assert.equal(card["载荷"], "位于 滑块；力 (−40000, 0) N；作用时间 工作行程；行程 0.7 … 1");
  assert.equal(card["飞轮"], "速度不均匀系数 0.1");
}));
