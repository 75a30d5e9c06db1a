// How soon a report stands and how smoothly it moves in headless Chromium:
//   BROWSER_PACKAGES=$PWD/build/release/tests/browser/npm node tests/bench/report/frames.mjs REPORT.html...
// For each report its size, the time from the beginning of the navigation until the page has run
// its scripts and what the page's thread computed for it, the time between frames while it plays for
// two seconds (median and 95 %), and what the thread computes for a frame. On a busy machine only
// the thread's own times measure the page.
import { statSync } from "node:fs";
import path from "node:path";
import { launch, open } from "../../browser/browser.mjs";

const SECONDS = 2;

// The times between frames, and what one step of the motion takes by itself.
const measure = (seconds) => new Promise((resolve) => {
  const between = [];
  let last = performance.now();
  const end = last + 1000 * seconds;
  const look = (now) => {
    between.push(now - last);
    last = now;
    if (now < end) requestAnimationFrame(look); else resolve(between.slice(1));
  };
  requestAnimationFrame(look);
});

const at = (values, share) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];
const text = (values) => `${at(values, 0.5).toFixed(1)} / ${at(values, 0.95).toFixed(1)}`;

const browser = await launch();
console.log("| report | kB | stands after, ms | computed for it, ms | between frames, ms (median / 95 %) | computed for a frame, ms |\n|---|---|---|---|---|---|");
for (const file of process.argv.slice(2)) {
  const { page, close } = await open(browser, file);
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const computed = async () => 1000 * (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const before = await computed();
  await page.reload();
  const stands = await page.evaluate(() => performance.getEntriesByType("navigation")[0].loadEventEnd);
  const loaded = await computed();
  const frames = await page.evaluate(measure, SECONDS);
  const played = await computed();
  console.log(`| ${path.basename(file, ".html")} | ${(statSync(file).size / 1000).toFixed(0)} | ${stands.toFixed(0)} | ${(loaded - before).toFixed(0)} | ${text(frames)} | ${((played - loaded) / frames.length).toFixed(1)} |`);
  await close();
}
await browser.close();
