// What random hands do to the page of `cognate sketch` in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/stress/sketch_hands.mjs build/release/app/cognate [ACTIONS] [SEED]
// Strokes, clicks, poses, typed functions, drags, turns, keys, limits, points of the front, undoing: none waits for the one before. Every hundred the page must
// come to rest with designs or a sentence; messages of the console, and a page that does not answer, end the run with 1.
import { drawnPoses, drawnStroke } from "../bench/report/drawings.mjs";
import { act, hands, PATIENCE, through } from "./hands.mjs";

const [program, actions = "1000", seed = "1"] = process.argv.slice(2);
const { random, pick } = hands(seed);

const KEYS = ["1", "2", "3", "c", "x", "p", "r", "o", "z", "y", " ", "Enter", "Delete", "Tab", "ArrowLeft", "Shift+ArrowUp", "Control+z", "Control+Shift+z", "Escape"];

// Each takes the page and a function from shares of the sheet to pixels.
const DOES = {
  stroke: (page, at) => through(page, drawnStroke(Math.floor(1e6 * random()))[0].map(at)),
  short: (page, at) => { const p = [random(), random()]; return through(page, [p, p.map((x) => x + 0.02 * (random() - 0.5))].map(at)); },
  click: (page, at) => page.mouse.click(...at([random(), random()])),
  poses: async (page, at) => { for (const stroke of drawnPoses(Math.floor(1e6 * random()))) await through(page, stroke.map(at)); },
  drag: (page) => dragged(page, "[data-target]"),
  turn: (page) => dragged(page, "[data-turn]"),
  key: (page) => page.keyboard.press(pick(KEYS)),
  limit: (page) => page.evaluate(([id, share]) => {
    const slider = document.getElementById(id);
    slider.value = Number(slider.min) + share * (slider.max - slider.min);
    for (const name of ["input", "change"]) slider.dispatchEvent(new Event(name, { bubbles: true }));
  }, [pick(["least", "reach"]), random()]),
  class: (page, _, share = random()) => page.evaluate((x) => {
    const choice = document.getElementById("class");
    choice.selectedIndex = Math.floor(x * choice.options.length);
    choice.dispatchEvent(new Event("change", { bubbles: true }));
  }, share),
  kind: (page) => page.evaluate((id) => document.getElementById(id).click(), pick(["of-curve", "of-poses", "of-function"])),
  typed: (page) => page.evaluate(([text, from, to]) => {
    if (!document.getElementById("typed").checkVisibility()) return;
    Object.entries({ expression: text, "domain-from": from, "domain-to": to }).forEach(([id, value]) => { document.getElementById(id).value = value; });
    document.getElementById("plot").click();
  }, [pick(["x", "x^2", "log10(x)", "sin(3*x)", "1/x", "sqrt(x", "abs(x - 1)", "0"]), pick([-1, 0, 1]), pick([1, 2])]),
  range: (page) => page.evaluate(([id, value]) => {
    const field = document.getElementById(id);
    if (!field.checkVisibility()) return;
    field.value = value;
    field.dispatchEvent(new Event("change", { bubbles: true }));
  }, [pick(["input-range", "output-range"]), pick(["60", "180", "-45", "360", "0", "", "500"])]),
  front: (page) => page.evaluate(([share, acts]) => {
    const points = [...document.querySelectorAll(".front-point")], one = points[Math.floor(share * points.length)];
    one?.focus();
    if (acts) one?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
  }, [random(), random() < 0.5]),
  step: (page) => page.evaluate((id) => document.getElementById(id).click(), pick(["undo", "undo", "redo", "clear"])),
};

async function dragged(page, selector) {
  const boxes = await page.locator(selector).evaluateAll((all) => all.map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));
  if (!boxes.length) return;
  const [x, y] = pick(boxes);
  await through(page, Array.from({ length: 12 }, (_, k) => [x + 8 * k * (random() - 0.5), y + 8 * k * (random() - 0.5)]));
}

// No search goes on, nor that of the front.
const rests = (page) => page.waitForFunction(() => !/…$/.test(document.getElementById("state").textContent)
  && (document.getElementById("front").hidden || !/^(Follows|Searching)/.test(document.getElementById("front-note").textContent)), null, { timeout: PATIENCE });

let rested = 0, designs = 0;
const { said, faults } = await act({ program, actions, pick, does: DOES, rests: async (page) => {
  await rests(page);
  rested += 1;
  await DOES.front(page);
  designs += await page.locator(".design-card").count();
} });
console.log(`${said}; at rest ${rested} times, with ${designs} designs`);
if (faults.length) console.log(faults.join("\n"));
process.exitCode = faults.length ? 1 : 0;
