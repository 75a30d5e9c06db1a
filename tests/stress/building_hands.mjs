// What random hands do to the page of `cognate sketch --mechanism` in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/stress/building_hands.mjs build/release/app/cognate [ACTIONS [SEED]]
// Links, pivots, sliders, points, loads, drags, keys, fields, choices, examples, addresses, zoom, windows, undoing: none waits for the one before. Every hundred acts
// the page is opened anew, every five hundred it must say in a sentence how the mechanism moves or why it does not, what moves must hold together, its address must
// open as the same mechanism, and so must its file, which the program must take. Messages of the console, words such as NaN, and a page that does not
// answer end the run with 1 and the line that has it again.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { gapOf } from "../browser/rigidity.mjs";
import { act, asked, clicked, hands, through } from "./hands.mjs";

const run = asked(), hand = hands(run.seed), { random, pick } = hand;
const TOOLS = ["move", "link", "pivot", "slider", "point", "drive", "load"];
const KEYS = ["v", "l", "f", "s", "p", "d", "o", "z", "y", " ", "Enter", "Delete", "Tab", "ArrowLeft", "Shift+ArrowUp", "Control+z", "Control+Shift+z", "Escape", "+", "-", "0", "?"];
const WINDOWS = [{ width: 360, height: 640 }, { width: 1440, height: 1000 }, { width: 844, height: 390 }];

// A place of the sheet, mostly near a joint, in pixels.
async function somewhere(page, at) {
  const pins = await page.locator("[data-pin]").evaluateAll((all) => all.filter((one) => !one.hasAttribute("hidden")).map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));
  return pins.length && random() < 0.65 ? pick(pins).map((x) => x + 6 * (random() - 0.5)) : at([0.1 + 0.8 * random(), 0.1 + 0.8 * random()]);
}

async function drawn(page, at, tool) {
  await page.evaluate((name) => document.querySelector(`.build-tool[data-tool=${name}]`).click(), tool);
  await through(page, [await somewhere(page, at), await somewhere(page, at), await somewhere(page, at)]);
}

// A mechanism in the address with a part changed: joints on one place, far away, of links that are none, or damaged.
function changedAddress(hash) {
  const numbers = [0, 1e-9, 1e3, 1e9, 1e300, -7, "", "x"], parts = hash.slice(1).split("&");
  const change = (part) => part.replaceAll(/-?\d+(\.\d+)?/g, (number) => (random() < 0.1 ? pick(numbers) : number));
  return `#${pick([parts.map(change), parts.toSpliced(Math.floor(random() * parts.length), 1), parts.map((part) => part.replaceAll(/,-?\d+(\.\d+)?/g, ",0")), [...parts, pick(["zh", "d=L9", "g=0,0", "v=0", "v=1e9,1", "l=,,", "j=%"])]]).join("&")}`;
}

// Changes a random field beside the sheet as typing does.
const typed = (page) => page.evaluate(([share, value, extreme]) => {
  const fields = [...document.querySelectorAll("#lists :is(input, select):not(:disabled)")], field = fields[Math.floor(share * fields.length)];
  if (!field) return;
  if (["checkbox", "radio"].includes(field.type)) { field.click(); return; }
  if (field.localName === "select") field.selectedIndex = Math.floor(value * field.options.length);
  else if (value > 0.95) field.value = "";
  else if (value > 0.9) field.value = String(extreme);
  else field.value = field.type === "text" ? value.toString(36).slice(2, 5) : (40 * value - 20).toFixed(1);
  field.dispatchEvent(new Event("change", { bubbles: true }));
}, [random(), random(), pick([0, -1, 1e-9, 1e4, 1e9, 1e300])]);

const DOES = {
  ...Object.fromEntries(TOOLS.map((tool) => [tool, (page, at) => drawn(page, at, tool)])),
  link2: (page, at) => drawn(page, at, "link"),
  pivot2: async (page, at) => { await page.keyboard.press("f"); await clicked(page, await somewhere(page, at)); },
  click: async (page, at) => clicked(page, await somewhere(page, at)),
  onto: async (page, at) => { const [from, to] = [await somewhere(page, at), await somewhere(page, at)]; await through(page, [from, to, to]); },
  wander: async (page, at) => { const [x, y] = await somewhere(page, at); await through(page, Array.from({ length: 20 }, () => [x + 60 * (random() - 0.5), y + 60 * (random() - 0.5)])); },
  drag: (page, at) => drawn(page, at, "move"),
  key: (page) => page.keyboard.press(pick(KEYS)),
  typed,
  away: (page) => page.evaluate((share) => { const all = [...document.querySelectorAll(".build-away")]; all[Math.floor(share * all.length)]?.click(); }, random()),
  example: (page) => page.evaluate((share) => { const all = document.querySelectorAll("[data-example]"); if (share < 0.8) all[Math.floor((share / 0.8) * all.length)].click(); }, random()),
  step: (page) => page.evaluate((id) => document.getElementById(id).click(), pick(["undo", "undo", "undo", "redo"])),
  steps: (page) => page.evaluate((id) => { for (let i = 0; i < 10; ++i) document.getElementById(id).click(); }, pick(["undo", "redo"])),
  address: (page) => page.evaluate((hash) => { location.hash = hash; }, changedAddress(new URL(page.url()).hash)),
  reload: async (page) => { await page.reload(); await ready(page); },
  keys: async (page) => { await page.evaluate(() => document.getElementById("sheet").focus()); for (let i = 0; i < 6; ++i) await page.keyboard.press(pick(["Enter", "ArrowLeft", "ArrowUp", "Shift+ArrowRight", "Tab", "Delete"])); },
  zoom: async (page, at) => {
    await page.mouse.move(...at([random(), random()]));
    await page.keyboard.down("Control");
    for (let i = 0; i < 8; ++i) await page.mouse.wheel(0, pick([-240, 240]));
    await page.keyboard.up("Control");
  },
  window: (page) => page.setViewportSize(pick(WINDOWS)),
  part: (page) => page.evaluate((share) => {
    const choice = document.getElementById("curve-part");
    choice.selectedIndex = Math.floor(share * choice.options.length);
    choice.dispatchEvent(new Event("change", { bubbles: true }));
  }, random()),
  take: (page) => page.locator("[data-take=copy_problem]").evaluate((button) => { if (!button.disabled) button.click(); }),
  goes: (page) => page.evaluate((share) => {
    const slider = document.getElementById("drive");
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, random()),
};

const ready = (page) => page.locator(".build-tool").first().waitFor();

// What stands in the lists beside the sheet.
const rowsOf = (page) => page.evaluate(() => [...document.querySelectorAll("#lists tbody tr")].map((row) => [row.dataset.row, ...[...row.querySelectorAll("input, select")].map(({ value, checked }) => `${value} ${checked}`)].join()).sort());

function assertSame(before, again, way) {
  const others = before.filter((row, i) => row !== again[i]);
  if (before.length !== again.length || others.length) throw new Error(`by its ${way} ${others.join("; ")} of ${before.length} rows is opened as ${again.filter((row, i) => row !== before[i]).join("; ")} of ${again.length}`);
}

// The file of a mechanism that moves is one that the program takes.
async function assertTaken(page) {
  const text = await page.locator("[data-take=copy_problem]").evaluate((button) => { button.click(); return document.getElementById("taken").value; });
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-built-")), file = path.join(folder, "built.toml"), out = path.join(folder, "built.html");
  fs.writeFileSync(file, text);
  execFileSync(run.program, ["analyze", "--quiet", "--json", file], { stdio: ["ignore", "ignore", "pipe"], maxBuffer: 1 << 28 });
  execFileSync(run.program, ["sketch", file, "--out", out], { stdio: ["ignore", "ignore", "pipe"] });
  const again = await page.context().newPage();
  await again.goto(pathToFileURL(out).href);
  await ready(again);
  const rows = await rowsOf(again);
  await again.close();
  fs.rmSync(folder, { recursive: true });
  return rows;
}

const GAP = 0.5;   // pixels: between its samples a motion is interpolated
let rested = 0, moving = 0;
async function rests(page) {
  await page.setViewportSize(WINDOWS[1]);
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.getElementById("state").textContent !== "" && document.getElementById("state").ariaBusy !== "true");
  rested += 1;
  const before = await rowsOf(page);
  if (await page.locator("#state.sound").count()) {
    moving += 1;
    const gap = await gapOf(page);
    if (!(gap < GAP)) throw new Error(`a gap of ${gap} pixels on ${page.url()}`);
    assertSame(before, await assertTaken(page), "file");
  }
  await page.reload();
  await ready(page);
  assertSame(before, await rowsOf(page), "address");
}

const { said, faults } = await act(run, { options: ["--mechanism"], hand, does: DOES, rests, ready });
console.log(`${said}; at rest ${rested} times, of which ${moving} with a mechanism that moves`);
if (faults.length) console.log(faults.join("\n"));
process.exitCode = faults.length ? 1 : 0;
