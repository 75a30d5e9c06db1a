// What random hands do to the page of `cognate sketch` in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/stress/sketch_hands.mjs build/release/app/cognate [ACTIONS [SEED]]
// Curves for four-bars, slider-cranks and both, poses, functions and lines, drawn, clicked, typed, dragged, turned, taken out of files and addresses, as large and as
// small as can be; limits, boxes, points of the front, zoom, undoing, windows: none waits for the one before. Every hundred acts the page is opened anew, every five
// hundred it must come to rest with designs or a sentence, the program must take its files, and its address must open as the same sketch. Messages of the console,
// words such as NaN, and a page that does not answer end the run with 1 and the line that has it again.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { drawnFunctionStroke, drawnPoses, drawnStroke } from "../bench/report/drawings.mjs";
import { act, asked, clicked, hands, through } from "./hands.mjs";

const run = asked(), hand = hands(run.seed), { random, pick } = hand;

const KEYS = ["1", "2", "3", "c", "x", "p", "r", "o", "m", "z", "y", "w", "a", "s", "d", "f", "+", "-", "0", " ", "Enter", "Delete", "Tab", "ArrowLeft", "Shift+ArrowUp", "Control+z", "Control+Shift+z", "Escape"];
const KINDS = ["of-curve", "of-poses", "of-function", "of-line", "by-four-bar", "by-slider", "by-both"];
const EXPRESSIONS = ["x", "x^2", "log10(x)", "sin(3*x)", "1/x", "sqrt(x", "abs(x - 1)", "0", "", "1e308*x", "x^x", "(((((x)))))", "ü", "x".repeat(5000)];

// Coordinates as addresses may have them.
const far = () => pick([1, 1e-9, 1e3, 1e9, 1e150, 1e300]) * (random() - 0.5);
const listOf = (count, make) => Array.from({ length: count }, make);
const rowsOf = (width) => {
  const rows = listOf(1 + Math.floor(30 * random() ** 3), () => listOf(width, far));
  return pick([rows, rows.map(() => rows[0]), rows.map((row, i) => row.map((x) => (120 * i * x) / (Math.abs(x) + 1e-300))), listOf(5, () => listOf(width, () => Math.round(60 * (random() - 0.5))))]);
};
const addressOf = () => {
  const rows = rowsOf(pick([2, 2, 2, 3])), inputs = rows.map(([x]) => 90 * Math.abs(Math.sin(x))).sort((a, b) => a - b);
  const drawn = { pairs: `p=${inputs.map((x) => `${x},${60 * random()}`).join(";")}&f=90,60`, points: `p=${rows.map((row) => row.join(",")).join(";")}` };
  const parts = [pick([drawn.points, drawn.points, drawn.pairs]), `o=${pick(["open", "closed"])},${pick(["stroke", "points"])}${pick(["", ",slider", ",both", ",line"])}`,
    `l=${pick(["any", "crank-rocker", "triple-rocker", "none"])},${pick([0, 30, 70, 1000, -5, "x"])},${pick([1, 3, 10, 1e9, 0, ""])}`, pick(["", "b=-20,-20,20,20", "c=-5,-5,5,5", "b=0,0,0,0", "c=1,2", `b=${listOf(4, far).join(",")}`]), pick(["", "zh", "d=1,2,3", "f=1", "d=;;;", "%"])];
  return `#${parts.filter((part) => part && random() < 0.9).join("&")}`;
};

const SHAPES = ['<path d="M0 0C5 9 9 5 9 0z"/>', '<circle r="4"/>', '<polyline points="0,0 9,0"/>', '<path d="M0 0"/>', '<path d="M0,0 L1e30,1e30"/>', '<ellipse rx="1e-9" ry="1"/>', '<g transform="scale(0)"><circle r="3"/></g>', "", "<"];

// Clicks what may be hidden, as a keyboard does not.
const press = (page, id) => page.evaluate((name) => document.getElementById(name).click(), id);
const entered = (page, id, value, names = ["change"]) => page.evaluate(([name, text, events]) => {
  const field = document.getElementById(name);
  if (!field.checkVisibility()) return;
  field.value = text;
  for (const event of events) field.dispatchEvent(new Event(event, { bubbles: true }));
}, [id, value, names]);

// Each takes the page and a function from shares of the sheet to pixels.
const DOES = {
  stroke: (page, at) => through(page, drawnStroke(Math.floor(1e6 * random()))[0].map(at)),
  short: (page, at) => { const p = [random(), random()]; return through(page, [p, p.map((x) => x + 0.02 * (random() - 0.5))].map(at)); },
  across: (page, at) => through(page, [[0.02 + 0.96 * random(), random()], [random(), random()], [random(), random()]].map(at)),
  click: (page, at) => clicked(page, at([random(), random()])),
  clicks: async (page, at) => { const place = at([random(), random()]); for (let i = 0; i < 3; ++i) await clicked(page, place); },
  poses: async (page, at) => { await press(page, "of-poses"); for (const stroke of drawnPoses(Math.floor(1e6 * random()))) await through(page, stroke.map(at)); },
  function: async (page, at) => { await press(page, "of-function"); await through(page, drawnFunctionStroke(Math.floor(1e6 * random()))[0].map(at)); },
  line: async (page, at) => { await press(page, "of-line"); await through(page, [[random(), random()], [random(), random()]].map(at)); },
  drag: (page) => dragged(page, "[data-target]"),
  heap: (page) => heaped(page),
  turn: (page) => dragged(page, "[data-turn]"),
  key: (page) => page.keyboard.press(pick(KEYS)),
  keys: async (page) => { await page.evaluate(() => document.getElementById("sheet").focus()); for (let i = 0; i < 6; ++i) await page.keyboard.press(pick(["Enter", "ArrowLeft", "ArrowUp", "Shift+ArrowRight", "Tab", "Delete"])); },
  limit: (page) => page.evaluate(([id, share]) => {
    const slider = document.getElementById(id);
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    for (const name of ["input", "change"]) slider.dispatchEvent(new Event(name, { bubbles: true }));
  }, [pick(["least", "reach", "even"]), random()]),
  class: (page) => page.evaluate((share) => {
    const choice = document.getElementById("class");
    if (!choice.checkVisibility()) return;
    choice.selectedIndex = Math.floor(share * choice.options.length);
    choice.dispatchEvent(new Event("change", { bubbles: true }));
  }, random()),
  box: async (page, at) => { await page.keyboard.press(pick(["r", "o"])); await through(page, [[random(), random()], [random(), random()]].map(at)); },
  kind: (page) => press(page, pick(KINDS)),
  typed: async (page) => {
    await entered(page, "expression", pick(EXPRESSIONS));
    await entered(page, "domain-from", pick(["-1", "0", "1", "-1e300"]));
    await entered(page, "domain-to", pick(["1", "2", "1e300", ""]));
    await page.evaluate(() => { const plot = document.getElementById("plot"); if (plot.checkVisibility()) plot.click(); });
  },
  range: (page) => entered(page, pick(["input-range", "output-range"]), pick(["60", "180", "-45", "360", "0", "", "500", "1e-9"])),
  front: (page) => frontPoint(page, random() < 0.5),
  step: (page) => press(page, pick(["undo", "undo", "redo", "clear"])),
  steps: async (page) => { const sense = pick(["undo", "redo"]); for (let i = 0; i < 10; ++i) await press(page, sense); },
  address: (page) => page.evaluate((hash) => { location.hash = hash; }, addressOf()),
  back: (page) => page.evaluate((hash) => { location.hash = hash; history.back(); }, `${addressOf()}&z=${random()}`),
  reload: async (page) => { await page.reload(); await ready(page); },
  file: (page) => page.locator("#bring-file").setInputFiles({ name: pick(["a.svg", "a.svg", "a.png"]), mimeType: "", buffer: Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg">${pick(SHAPES)}</svg>`) }),
  zoom: async (page, at) => {
    await page.mouse.move(...at([random(), random()]));
    await page.keyboard.down("Control");
    for (let i = 0; i < 8; ++i) await page.mouse.wheel(0, pick([-240, 240]));
    await page.keyboard.up("Control");
  },
  zoomed: async (page) => { const key = pick(["+", "-", "0"]); for (let i = 0; i < 12; ++i) await page.keyboard.press(key); },
  window: (page) => page.setViewportSize(pick([{ width: 360, height: 640 }, { width: 1440, height: 1000 }, { width: 844, height: 390 }])),
  goes: (page) => entered(page, "drive", String(360 * random()), ["input"]),
  take: (page) => page.evaluate((name) => { const button = document.querySelector(`[data-take=${name}]`); if (!button.disabled) button.click(); }, pick(["copy_problem", "copy_design", "copy_link"])),
  card: (page) => page.evaluate((share) => { const cards = document.querySelectorAll(".design-card input"); cards[Math.floor(share * cards.length)]?.click(); }, random()),
};

const middlesOf = (page, selector) => page.locator(selector).evaluateAll((all) => all.map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));

async function dragged(page, selector) {
  const places = await middlesOf(page, selector);
  if (!places.length) return;
  const [x, y] = pick(places);
  await through(page, listOf(12, (_, k) => [x + 8 * k * (random() - 0.5), y + 8 * k * (random() - 0.5)]));
}

// All targets on one of them.
async function heaped(page) {
  const places = (await middlesOf(page, "[data-target]")).slice(0, 8), onto = pick(places);
  for (const place of places) if (place !== onto) await through(page, [place, onto]);
}

const frontPoint = (page, takes) => page.evaluate(([share, acts]) => {
  const points = [...document.querySelectorAll(".front-point")], one = points[Math.floor(share * points.length)];
  one?.focus();
  if (acts) one?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
}, [random(), takes]);

const ready = (page) => page.locator("#of-curve[aria-pressed]").waitFor();

// No search goes on, nor that of the front.
const searched = (page) => page.waitForFunction(() => !/…$/.test(document.getElementById("state").textContent)
  && (document.getElementById("front").hidden || !/^(Follows|Searching)/.test(document.getElementById("front-note").textContent)));

// What the page gives away as a file is one that the program takes.
async function assertTakes(page, name, command) {
  const text = await page.evaluate((take) => {
    const button = document.querySelector(`[data-take=${take}]`);
    if (button.disabled) return null;
    button.click();
    return document.getElementById("taken").value;
  }, name);
  if (text === null) return;
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "cognate-hands-")), `${name}.toml`);
  fs.writeFileSync(file, text);
  execFileSync(run.program, [...command, file], { stdio: ["ignore", "ignore", "pipe"] });
  fs.rmSync(path.dirname(file), { recursive: true });
}

// What the page shows of its sketch, and what its address says of that.
const sketched = async (page) => [new URL(page.url()).hash.replace(/&d=.*/, ""), ...await page.evaluate(() => [...document.querySelectorAll(".segments [aria-pressed]")].map((one) => one.getAttribute("aria-pressed"))
  .concat(document.querySelectorAll(".sketch-spot").length, ["class", "least", "reach"].map((id) => document.getElementById(id).value), ["pivot-region", "kept-clear"].map((id) => document.getElementById(id).hasAttribute("hidden"))))].join(" ");

let rested = 0, designs = 0;
async function rests(page) {
  await page.keyboard.press("Escape");
  await page.setViewportSize({ width: 1440, height: 1000 });
  await searched(page);
  rested += 1;
  designs += await page.locator(".design-card").count();
  await frontPoint(page, false);
  await assertTakes(page, "copy_problem", ["check"]);
  await assertTakes(page, "copy_design", ["analyze", "--quiet", "--json"]);
  const before = await sketched(page), isDrawn = /#.*p=/.test(page.url());
  await page.reload();
  await ready(page);
  const again = await sketched(page);
  if (isDrawn && before !== again) throw new Error(`${before} is opened as ${again}`);
}

const { said, faults } = await act(run, { options: [], hand, does: DOES, rests, ready });
console.log(`${said}; at rest ${rested} times, with ${designs} designs`);
if (faults.length) console.log(faults.join("\n"));
process.exitCode = faults.length ? 1 : 0;
