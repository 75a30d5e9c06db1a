// Editing cams, gears, trains and machines in their reports: everything that an edited page says and draws is what the program's own
// report of the copied file says and draws. COGNATE: the program.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { launch, open } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";
import { reported as reportedIn, sameTold, textsOf } from "./told.mjs";

const LIBRARY = new URL("../../problems/library/", import.meta.url).pathname;
let browser, folder;
before(async () => { browser = await launch(); folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-numbers-")); });
after(() => { fs.rmSync(folder, { recursive: true }); return browser?.close(); });

const reported = (...text) => reportedIn(folder, ...text);

const commandOf = (text) => (/^kind = "(gear|machine)"$/m.test(text) ? "analyze" : "solve");

// Of extremes that come twice either place may be named.
// What a page says in its cards and tables, and the numbers of its picture. What is of the original is not looked at.
const CARDS = ["dimensions", "facts", "members", "segments", "constraints", "table", "notes", "section", "curves", "tasks", "problem"];
const told = async (page) => ({ ...await textsOf(page, CARDS), ...await page.evaluate(() => ({
  file: document.getElementById("problem-file").textContent,
  picture: [...document.querySelectorAll("#picture > svg path:not(.edit-ghost), #picture > svg circle, #picture > svg text")].map((part) => part.getAttribute("d") ?? part.getAttribute("r") ?? part.textContent).join(" "),
  ink: [...document.querySelectorAll("#plots canvas")].map((canvas) => canvas.toDataURL().length > 2000).join(" "),
})) });

// `unlike`: what two pages need not have alike.
async function edited(name, text, fields, unlike = []) {
  const command = commandOf(text);
  const first = await open(browser, reported(name, text, command), { motion: "reduce" });
  const { page } = first;
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
  const before_ = await told(page);
  await page.locator(".edit-toggle").click();
  await page.locator(".edit-toggle").click();
  await page.locator(".edit details").evaluateAll((all) => all.forEach((part) => { part.open = true; }));
  for (const [key, value] of Object.entries(fields)) {
    const field = page.locator(`[data-field="${key}"]`);
    await field.fill(String(value));
    await field.press("Tab");
    assert.equal(await page.locator(".edit-status").textContent(), "", `${name}: ${key}`);
  }
  assert.ok(await page.locator("#edit-values tr.changed").count() > 0, name);
  assert.match(await page.locator(".summary").getAttribute("class"), /of-original/);
  await page.locator('[data-edit="copy"]').click();
  const copy = await page.locator("#edit-toml").inputValue();
  const shown = await told(page);
  assert.notEqual(shown.facts, before_.facts, name);

  const second = await open(browser, reported(`${name}-edited`, copy, command), { motion: "reduce" });
  const wanted = await told(second.page);
  // Of a file the program fills in defaults, and derives what is given in two ways.
  for (const key of Object.keys(wanted).filter((id) => !["problem", "file", ...unlike].includes(id))) sameTold(shown[key] ?? "", wanted[key], `${name}, ${key}`);
  await second.close();

  // As it was found again.
  await page.locator(".edit-toggle").click();
  assert.equal(await page.locator(".of-original, .edit-ghost").count(), 0);
  assert.deepEqual([...first.faults, ...second.faults], []);
  await first.close();
}

const library = (file) => fs.readFileSync(path.join(LIBRARY, `${file}.toml`), "utf8");

// Each cam with lengths, angles and rises changed, whether its file gave them or they were found.
const MOTION = `
[[motion]]
law = "cycloidal"
over_deg = 110
rise = 20
[[motion]]
law = "dwell"
over_deg = 70
[[motion]]
law = "3-4-5"
over_deg = 100
rise = -20
[[motion]]
law = "dwell"
over_deg = 80
`;
const CONJUGATE = `kind = "cam"
[follower]
type = "translating-roller"
closure = "conjugate"
breadth = 110
[mechanism]
base_radius = 45
offset = 4
roller_radius = 9
${MOTION}`;

for (const [file, fields] of some([
  ["cam/translating-roller", { base_radius: 55, offset: -6.5, roller_radius: 12.25, "motion.0.over_deg": 120, "motion.0.rise": 45 }],
  ["cam/oscillating-smallest", { base_radius: 43, centre_distance: 95, "motion.2.rise_deg": -17, "motion.1.over_deg": 41.5, "constraints.pressure_angle_deg_max": 28 }],
  ["cam/universal-law", { roller_radius: 7, "motion.0.over_deg": 115, base_radius: 40 }],
  ["cam/valve", { base_radius: 0.033, "drive.speed": 220, "follower.mass": 0.15 }],
  ["cam/oscillating-roller-on-raster", { base_radius: 36 }],
  ["cam/toleranced-roller", { base_radius: 41, "motion.0.rise": 22 }],
  ["conjugate", { base_radius: 48, "motion.0.rise": 18 }],
])) test(`${file}: an edited cam is the program's`, () => edited(path.basename(file), file === "conjugate" ? CONJUGATE : library(file), fields));

for (const [file, fields] of some([
  ["gear/helical", { teeth: 19, helix_deg: 15, profile_shift: 0.1, "rack.pressure_angle_deg": 22 }],
  ["gear-pair/enumerated-teeth", { "teeth.0": 21, "profile_shift.1": 0.1 }],
  ["gear-pair/standard", { "teeth.0": 23, "profile_shift.0": 0.3, centre_distance: 262 }],
  ["gear-pair/helix-from-distance", { helix_deg: 14, module: 2.5, backlash: 0.12 }],
  ["gear-pair/internal", { "teeth.1": 66, centre_distance: 48.9 }],
  ["gear-pair/rack", { pinion_shift: 0.1, backlash: 0.3 }],
  ["gear-pair/bevel", { "teeth.0": 20, "profile_shift.1": -0.1 }],
  ["gear-pair/worm", { starts: 2, diameter_quotient: 9, friction: 0.05 }],
])) test(`${file}: edited gears are the program's`, () => edited(path.basename(file), library(file), fields));

// A gear that meshes twice is one; of a gearbox each state follows; a train that was found has its teeth as given.
for (const [file, fields] of some([
  ["gear-train/planetary", { "mesh.0.teeth.0": 27, "mesh.1.teeth.1": 87, "mesh.0.efficiency": 0.97, "input.0.torque": 25, "planet.0.inertia": 0.001 }],
  ["gear-train/simpson", { "mesh.0.teeth.0": 30, "mesh.0.teeth.1": 18, "mesh.1.teeth.1": 66, "input.0.speed": 150 }],
  ["gear-train/planetary-search", { "mesh.0.teeth.0": 25 }],
])) test(`${file}: an edited train is the program's`, () => edited(path.basename(file), library(file), fields));

// Of Simpson's gearbox the first state is (1 + k + k₂)/k, where k is of the first set and k₂ of the second; the reverse −k₂.
test("the states of an edited gearbox are chosen, and stay edited", async () => {
  const { page, faults, close } = await open(browser, reported("states", library("gear-train/simpson")), { motion: "reduce" });
  await page.locator(".edit-toggle").click();
  const field = page.locator('[data-field="mesh.1.teeth.1"]');
  await field.fill("66");
  await field.press("Tab");
  const ratio = () => page.locator('#edit-values [data-row="ratio"] td').evaluateAll((cells) => cells.slice(1).map((cell) => JSON.parse(cell.dataset.value)));
  const [was, is, second] = [62 / 28, 66 / 28, 62 / 28];
  for (const [state, of] of [[0, (k) => (1 + k + second) / k], [3, () => -second]]) {
    await page.locator("#designs button").nth(state).click();
    const [before_, now] = await ratio();
    assert.ok(Math.abs(before_ - of(was)) < 1e-6 && Math.abs(now - of(is)) < 1e-6, `${before_} and ${now}`);
    assert.ok(await page.locator("#edit").isVisible());
    assert.equal(await page.locator('#designs [aria-pressed="true"]').count(), 1);
  }
  // The front planet is one gear in two meshes.
  await page.locator('[data-field="mesh.0.teeth.1"]').fill("18");
  await page.locator('[data-field="mesh.0.teeth.1"]').press("Tab");
  await page.locator('[data-edit="copy"]').click();
  const copy = await page.locator("#edit-toml").inputValue();
  assert.deepEqual([...copy.matchAll(/^teeth = (.*)$/gm)].map(([, teeth]) => teeth), ["[28, 18]", "[18, 66]", "[28, 17]", "[17, 62]"]);
  assert.deepEqual(faults, []);
  await close();
});

// Expressions, tables, a motor's line, a train of gears, a flywheel that is found, starts and stops. The picture of an edited
// mechanism stays in its frame.
const machine = (name) => library(`machine/${name}`).replace("../gear-train", `${LIBRARY}gear-train`);
for (const [name, fields] of some([
  ["press", { "flywheel.fluctuation": 0.08, crank: 0.11, "motor.line.stall_torque": 950 }],
  ["compressor", { "brake.torque": 30, "link.2.mass": 1.8, "flywheel.inertia": 1.4 }],
  ["planetary-press", { "motor.inertia": 0.04, "motor.train.mesh.0.efficiency": 0.95 }],
])) test(`${name}: an edited machine is the program's`, () => edited(name, machine(name), fields, ["picture"]));

test("a machine that stalls is edited until it runs", async () => {
  const { page, faults, close } = await open(browser, reported("stalled", library("machine/stall"), "analyze"), { motion: "reduce" });
  const notes = () => page.locator("#notes-list").textContent();
  assert.match(await notes(), /stalls/);
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
  await page.locator(".edit details").evaluateAll((all) => all.forEach((part) => { part.open = true; }));
  const field = page.locator('[data-field="motor.line.stall_torque"]');
  await field.fill("9000");
  await field.press("Tab");
  assert.doesNotMatch(await notes(), /stalls/);
  assert.ok(await page.locator("#player").isVisible());
  await page.locator('[data-edit="undo"]').click();
  assert.match(await notes(), /stalls/);
  assert.ok(await page.locator("#player").isHidden());
  assert.deepEqual(faults, []);
  await close();
});

test("what the program would refuse is refused in its words, and the page stays as it is", async () => {
  const { page, faults, close } = await open(browser, reported("refused", library("cam/translating-roller")), { motion: "reduce" });
  await page.locator(".edit-toggle").click();
  const field = page.locator('[data-field="base_radius"]');
  await field.waitFor();
  const shown = await told(page);
  for (const [value, words] of [[-3, /base_radius/], [9, /roller_radius|offset/], ["", /number/]]) {
    await field.fill(String(value));
    await field.press("Tab");
    assert.match(await page.locator(".edit-status").textContent(), words);
    assert.deepEqual(await told(page), shown);
    assert.equal(await field.inputValue(), "40");
  }
  // A slider is one change, which goes back and forth.
  await page.locator('[data-slider="base_radius"]').evaluate((slider) => {
    for (const value of [50, 60, 70]) { slider.value = value; slider.dispatchEvent(new Event("input")); }
    slider.dispatchEvent(new Event("change"));
  });
  assert.equal(await field.inputValue(), "70");
  await page.locator('[data-edit="undo"]').click();
  assert.equal(await field.inputValue(), "40");
  assert.deepEqual((await told(page)).facts, shown.facts);
  await page.locator('[data-edit="redo"]').click();
  assert.equal(await field.inputValue(), "70");
  assert.deepEqual(faults, []);
  await close();
});
