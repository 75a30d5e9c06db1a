// What random hands do to the page of `cognate sketch --mechanism` in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/stress/building_hands.mjs build/release/app/cognate [ACTIONS] [SEED]
// Links, pivots, sliders, points, loads, drags, keys, fields, choices, examples, undoing: none waits for the one before. Every hundred the page must say
// in a sentence how the mechanism moves or why it does not, what moves must hold together, and its address must open as the same mechanism; messages
// of the console, and a page that does not answer, end the run with 1.
import { gapOf } from "../browser/rigidity.mjs";
import { act, hands, PATIENCE, through } from "./hands.mjs";

const [program, actions = "1000", seed = "1"] = process.argv.slice(2);
const { random, pick } = hands(seed);
const TOOLS = ["move", "link", "pivot", "slider", "point", "drive", "load"];
const KEYS = ["v", "l", "f", "s", "p", "d", "o", "z", "y", " ", "Enter", "Delete", "Tab", "ArrowLeft", "Shift+ArrowUp", "Control+z", "Control+Shift+z", "Escape", "+", "-", "0"];

// A place of the sheet, mostly near a joint, in pixels.
async function somewhere(page, at) {
  const pins = await page.locator("[data-pin]").evaluateAll((all) => all.filter((one) => !one.hasAttribute("hidden")).map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));
  return pins.length && random() < 0.65 ? pick(pins).map((x) => x + 6 * (random() - 0.5)) : at([0.1 + 0.8 * random(), 0.1 + 0.8 * random()]);
}

async function drawn(page, at, tool) {
  await page.locator(`.build-tool[data-tool=${tool}]`).click();
  await through(page, [await somewhere(page, at), await somewhere(page, at), await somewhere(page, at)]);
}

// Changes a random field beside the sheet as typing does.
const typed = (page) => page.evaluate(([share, value]) => {
  const fields = [...document.querySelectorAll("#lists :is(input, select):not(:disabled)")], field = fields[Math.floor(share * fields.length)];
  if (!field) return;
  if (["checkbox", "radio"].includes(field.type)) { field.click(); return; }
  if (field.localName === "select") field.selectedIndex = Math.floor(value * field.options.length);
  else if (value > 0.95) field.value = "";
  else field.value = field.type === "text" ? value.toString(36).slice(2, 5) : (40 * value - 20).toFixed(1);
  field.dispatchEvent(new Event("change", { bubbles: true }));
}, [random(), random()]);

const DOES = {
  ...Object.fromEntries(TOOLS.map((tool) => [tool, (page, at) => drawn(page, at, tool)])),
  link2: (page, at) => drawn(page, at, "link"),
  pivot2: async (page, at) => { await page.keyboard.press("f"); await page.mouse.click(...await somewhere(page, at)); },
  click: async (page, at) => page.mouse.click(...await somewhere(page, at)),
  drag: (page, at) => drawn(page, at, "move"),
  key: (page) => page.keyboard.press(pick(KEYS)),
  typed,
  away: (page) => page.evaluate((share) => { const all = [...document.querySelectorAll(".build-away")]; all[Math.floor(share * all.length)]?.click(); }, random()),
  example: (page) => page.evaluate((share) => { const all = document.querySelectorAll("[data-example]"); if (share < 0.8) all[Math.floor((share / 0.8) * all.length)].click(); }, random()),
  step: (page) => page.evaluate((id) => document.getElementById(id).click(), pick(["undo", "undo", "undo", "redo"])),
  goes: (page) => page.evaluate((share) => {
    const slider = document.getElementById("drive");
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, random()),
};

const GAP = 0.5;   // pixels: between its samples a motion is interpolated
let rested = 0, moving = 0;
async function rests(page) {
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.getElementById("state").textContent !== "" && document.getElementById("state").ariaBusy !== "true", null, { timeout: PATIENCE });
  rested += 1;
  if (await page.locator("#state.sound").count()) {
    moving += 1;
    const gap = await gapOf(page);
    if (!(gap < GAP)) throw new Error(`a gap of ${gap} pixels on ${page.url()}`);
  }
  // The address opens as the same mechanism.
  const rows = () => page.evaluate(() => [...document.querySelectorAll("#lists tbody tr")].map((row) => [row.dataset.row, ...[...row.querySelectorAll("input, select")].map(({ value, checked }) => `${value} ${checked}`)].join()).sort().join(";"));
  const before = await rows();
  await page.reload();
  await page.locator(".build-tool").first().waitFor();
  const again = await rows();
  if (before !== again) throw new Error(`${before} is opened as ${again}`);
}

const { said, faults } = await act({ program, options: ["--mechanism"], actions, pick, does: DOES, rests });
console.log(`${said}; at rest ${rested} times, of which ${moving} with a mechanism that moves`);
if (faults.length) console.log(faults.join("\n"));
process.exitCode = faults.length ? 1 : 0;
