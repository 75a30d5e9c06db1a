// How the page of `cognate sketch` follows a hand in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/bench/report/hands.mjs build/release/app/cognate [DRAWINGS [KIND]]
// Of random strokes and of capitals and signs, for four-bars, for slider-cranks and for both, of poses, of functions and of straight lines: from the end of the drawing to
// the first designs, the time between frames until the search ends, and from a step of a drag to the first design that follows it, the one
// chosen (those of a line without a search). KIND: strokes, letters, sliders, both, poses, functions or lines alone. Median, 95 % and worst; on a machine that does other
// work besides only the first figure means something.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { launch, open } from "../../browser/browser.mjs";
import { drawnFunctionStroke, drawnLetterStroke, drawnLine, drawnPoses, drawnStroke } from "./drawings.mjs";

const [program, drawings = "100", only] = process.argv.slice(2);
const DRAGS = 10;

// In the page: when designs came last, and the times between frames while something is searched for.
function watch() {
  const seen = { designs: null, released: null, frames: [], steps: [], step: null };
  const now = () => performance.now();
  new MutationObserver(() => {
    if (!document.querySelector(".design-card")) return;
    seen.designs ??= now();
    if (seen.step !== null) { seen.steps.push(now() - seen.step); seen.step = null; }
  }).observe(document.getElementById("designs"), { childList: true, subtree: true, attributes: true });
  addEventListener("pointerup", () => { seen.released = now(); seen.designs = null; seen.step = null; }, true);
  addEventListener("pointermove", (event) => { if (event.target.dataset.target) seen.step ??= now(); }, true);
  let last = now();
  const look = (time) => {
    if (/…$/.test(document.getElementById("state").textContent)) seen.frames.push(time - last);
    last = time;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  window.seen = seen;
}

const ends = (page) => page.waitForFunction(() => /\.$/.test(document.getElementById("state").textContent), null, { timeout: 120000 });

// One drawing: `strokes`, each a list of places by shares of the sheet. Milliseconds until there are designs.
async function drawn(page, strokes) {
  await page.keyboard.press("x");
  const box = await page.locator("#sheet").boundingBox();
  for (const stroke of strokes) {
    const [first, ...rest] = stroke.map(([x, y]) => [box.x + x * box.width, box.y + y * box.height]);
    await page.mouse.move(...first);
    await page.mouse.down();
    for (const place of rest) await page.mouse.move(...place);
    await page.mouse.up();
  }
  await page.waitForFunction(() => window.seen.designs !== null || /\.$/.test(document.getElementById("state").textContent), null, { timeout: 120000 });
  const waited = await page.evaluate(() => window.seen.designs - window.seen.released);
  await ends(page);
  return waited;
}

async function dragged(page, i) {
  const box = await page.locator(`[data-target="${i}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= DRAGS; ++k) {
    await page.mouse.move(x + 2 * k, y + k);
    await page.waitForFunction(() => window.seen.step === null, null, { timeout: 5000 }).catch(() => {});
  }
  await page.mouse.up();
}

const at = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];
const text = (values) => `${at(values, 0.5).toFixed(0)} / ${at(values, 0.95).toFixed(0)} / ${Math.max(...values).toFixed(0)}`;

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-hands-"));
const file = path.join(folder, "sketch.html");
execFileSync(program, ["sketch", "--out", file]);
const browser = await launch();
console.log("| drawings | first designs, ms (median / 95 % / worst) | between frames while searching, ms | a step of a drag, ms |\n|---|---|---|---|");
const KINDS = [["strokes", ["#of-curve"], drawnStroke], ["letters", ["#of-curve"], drawnLetterStroke], ["sliders", ["#of-curve", "#by-slider"], drawnStroke], ["both", ["#of-curve", "#by-both"], drawnStroke], ["poses", ["#of-poses"], drawnPoses], ["functions", ["#of-function"], drawnFunctionStroke], ["lines", ["#of-line"], drawnLine]];
for (const [name, buttons, drawing] of KINDS.filter(([one]) => !only || one === only)) {
  const { page, faults, close } = await open(browser, file);
  for (const button of buttons) await page.locator(button).click();
  await page.evaluate(watch);
  const first = [];
  for (let i = 0; i < Number(drawings); ++i) {
    first.push(await drawn(page, drawing(i)));
    if (i % 5 === 0) await dragged(page, 1);
  }
  const { frames, steps } = await page.evaluate(() => window.seen);
  console.log(`| ${drawings} ${name} | ${text(first)} | ${text(frames)} | ${text(steps)} |`);
  if (faults.length) console.log(faults.join("\n"));
  await close();
}
await browser.close();
fs.rmSync(folder, { recursive: true });
