// The page of a leg: what it plots of the foot is what an analysis of the mechanism says of that point, and what the
// program says of the gait. COGNATE: the program.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { problemToml } from "../../app/report/page/toml.js";
import { assertFits, launch, open, withoutPlots } from "./browser.mjs";

const LEG = `kind = "leg"
[target]
duty = 0.55
stride = 1.0
height_min = 0.3
[mechanism]
type = "klann"
[solve]
starts = 6
`;

let browser, folder;
before(async () => { browser = await launch(); folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-leg-")); });
after(() => { fs.rmSync(folder, { recursive: true }); return browser?.close(); });

function run(command, name, text) {
  const file = path.join(folder, `${name}.toml`);
  fs.writeFileSync(file, text);
  assert.equal(spawnSync(process.env.COGNATE, [command, "--quiet", "--out", folder, file], { encoding: "utf8" }).stderr, "");
  return JSON.parse(fs.readFileSync(path.join(folder, `${name}.result.json`), "utf8"));
}

const plain = (text) => { const [digits, power] = text.replaceAll("−", "-").split("×10"); return Number(digits) * 10 ** Number([...(power ?? "⁰")].map((c) => { const at = "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c); return at < 0 ? "-" : at; }).join("")); };

// The numbers of the plots as tables, by their titles.
async function plotted(page) {
  await page.locator("#plots .as-table").evaluateAll((buttons) => buttons.forEach((button) => button.click()));
  const tables = await page.locator("#plots .plot").evaluateAll((plots) => plots.map((plot) => [plot.querySelector("h3").textContent, [...plot.querySelectorAll("tbody tr")].map((row) => [...row.cells].map((cell) => cell.textContent))]));
  return Object.fromEntries(tables.map(([title, rows]) => [title, rows.map((row) => row.map(plain))]));
}

test("height, path and speed of the foot are those of its mechanism, its stance that of its gait", { skip: withoutPlots }, async () => {
  const { designs: [{ mechanism, metrics, crank_deg: [from, to] }] } = run("solve", "leg", LEG);
  const foot = mechanism.point.at(-1).name;
  const { type, ...tables } = mechanism;
  const analysis = run("analyze", "motion", problemToml({ kind: "analysis", mechanism: { type, ...tables }, drive: { start_deg: 0, end_deg: 360, steps: 360, speed: 1 } }));
  const column = (name) => analysis.analysis.columns.find((one) => one.name === name).values;
  const [x, y, vx] = [`${foot}_x`, `${foot}_y`, `${foot}_vx_per_s`].map(column);
  const ground = Math.min(...y), mean = metrics.stride / (2 * Math.PI * metrics.duty);
  const span = (to - from + 360) % 360, sense = Math.sign(x[Math.round(from + span) % 360] - x[Math.round(from)]);
  const stands = (deg) => (((deg - from) % 360) + 360) % 360 <= span;

  const { page, faults, close } = await open(browser, path.join(folder, "leg.report.html"), { motion: "reduce" });
  await assertFits(page);
  const { "Foot above the ground, units": heights, "Path of the foot: height over distance, units": places, "Speed of the foot along the ground (1: its mean in stance)": speeds } = await plotted(page);
  assert.ok(heights.length > 30 && speeds.length === heights.length && places.length > 30);
  for (const [deg, height] of heights) {
    assert.ok(Math.abs(height - (y[Math.round(deg)] - ground)) < 2e-3 * metrics.step_height || deg % 1, `height at ${deg}`);
    if (stands(deg)) assert.ok(height < metrics.flatness * metrics.stride * 1.02, `stance at ${deg}`);
  }
  for (const [deg, speed] of speeds) {
    if (deg % 1 === 0) assert.ok(Math.abs(speed - (sense * vx[deg]) / mean) < 0.02, `speed at ${deg}: ${speed} and ${(sense * vx[deg]) / mean}`);
    if (stands(deg)) assert.ok(speed > metrics.foot_speed_min - 0.02 && speed < metrics.foot_speed_max + 0.02, `speed in stance at ${deg}`);
  }
  const along = places.map(([at]) => at);
  assert.ok(Math.abs(Math.max(...along) - Math.max(...x)) < 2e-3 && Math.abs(Math.min(...along) - Math.min(...x)) < 2e-3);

  // In the picture the foot stands on the ground, over its stride.
  const [line, stance] = await page.locator("#picture .straight, #picture .stretch").evaluateAll((paths) => paths.map((one) => { const { x: left, y: top, width, height } = one.getBBox(); return { left, top, width, height }; }));
  const scale = stance.width / metrics.stride;
  assert.ok(stance.height < 1.1 * metrics.flatness * metrics.stride * scale + 0.2 && Math.abs(stance.top + stance.height - line.top) < 1, "the stance is on the ground");
  assert.ok(line.left < stance.left && line.left + line.width > stance.left + stance.width);
  assert.match(await page.locator("#qualities-list").innerText(), new RegExp(`Minimum transmission angle at C\\n${Math.trunc(metrics.transmission_C_min_deg)}`));

  // Each part of the chain stands in a row of its own name.
  const dimensions = await page.locator("#dimensions-list").evaluate((list) => Object.fromEntries([...list.querySelectorAll("dt")].map((name) => [name.textContent, name.nextElementSibling.textContent])));
  const links = [[`Crank ${mechanism.crank.at}–${mechanism.crank.pin}`, mechanism.crank.length],
    ...mechanism.dyad.flatMap(({ joins: [one, other], lengths, new: made }) => [[`Link ${one}–${made}`, lengths[0]], [`Link ${made}–${other}`, lengths[1]]])];
  for (const [name, length] of links) assert.ok(Math.abs(plain(dimensions[name] ?? "") - length) < 1e-6 * length, `${name}: ${dimensions[name]} and ${length}`);
  for (const { name, at } of mechanism.pivot) assert.deepEqual(dimensions[`Pivot ${name}`].split(", ").map((x) => plain(x).toFixed(4)), at.map((x) => x.toFixed(4)));
  assert.deepEqual(faults, []);
  await close();
});

test("in Chinese no name of a leg's page is left in English", async () => {
  const { page, close } = await open(browser, path.join(folder, "leg.report.html"), { motion: "reduce", size: "phone", hash: "#zh" });
  await assertFits(page);
  const names = await page.locator("dt, th, h2, h3").allInnerTexts();
  assert.deepEqual(names.filter((name) => /[a-z]{3}/.test(name.replace(/γmin/g, ""))), []);
  await close();
});
