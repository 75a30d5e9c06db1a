// The system's Chromium, and pages opened from disk in it.
import { createRequire } from "node:module";
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import path from "node:path";

// Packages are installed in the build tree: BROWSER_PACKAGES names the folder of node_modules.
const base = process.env.BROWSER_PACKAGES ?? path.dirname(new URL(import.meta.url).pathname);
const { chromium } = createRequire(path.join(base, "package.json"))("playwright-core");

export const SIZES = { desktop: { width: 1440, height: 1000 }, phone: { width: 390, height: 844 }, laptop: { width: 1280, height: 720 } };

// Of the sizes a desktop and a phone show every layout. Layout does not depend on colours: two of the four pairs show all of either.
export const LOOKS = [{ size: "desktop", scheme: "light" }, { size: "phone", scheme: "dark" }];

export function launch() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium-headless-shell",
    args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync"],
  });
}

// A page of its own context; `faults` collects errors of what is opened in it and requests that leave that.
async function newPage(browser, { size = "desktop", scheme = "light", motion = "no-preference", locale = "en-GB" }) {
  const context = await browser.newContext({ viewport: SIZES[size], colorScheme: scheme, reducedMotion: motion, locale,
    hasTouch: size === "phone", deviceScaleFactor: size === "phone" ? 2 : 1 });
  const opened = { page: await context.newPage(), viewport: SIZES[size], faults: [], url: "", close: () => context.close() };
  const { page, faults } = opened;
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(String(error.stack ?? error)));
  page.on("request", (request) => { if (request.url() !== opened.url && !/^(data|blob):/.test(request.url())) faults.push(`request ${request.url()}`); });
  return opened;
}

async function goTo(opened, file, hash = "") {
  opened.url = pathToFileURL(path.resolve(file)).href;
  await opened.page.goto(opened.url + hash);
}

// Opens `file`. `prepare(page)` comes before that, `hash` stands behind the address.
export async function open(browser, file, { prepare, hash, ...options } = {}) {
  const opened = await newPage(browser, options);
  await prepare?.(opened.page);
  await goTo(opened, file, hash);
  return opened;
}

// A new context costs as much as loading a report: those without preparation are kept, one for each set of options.
const kept = new Map();

// While one is visited it is nobody else's.
async function keptPage(browser, options) {
  if (!kept.has(browser)) kept.set(browser, new Map());
  const pages = kept.get(browser), key = JSON.stringify(options);
  const opened = pages.get(key) ?? await newPage(browser, options);
  pages.delete(key);
  return { opened, keep: () => pages.has(key) ? opened.close() : pages.set(key, opened) };
}

// Leaves nothing that the next visit could find: no page, no memory of it, no pointer over it.
async function empty({ page, viewport }) {
  await page.evaluate(() => localStorage.clear());
  await page.goto("about:blank");
  await page.setViewportSize(viewport);
  await page.mouse.move(0, 0);
}

// Runs `steps` on `file` as if never opened before, and fails on any message of the console or request.
export async function visitFile(browser, file, { prepare, hash, ...look }, steps) {
  const { opened, keep } = prepare ? { opened: await open(browser, file, { prepare, hash, ...look }) } : await keptPage(browser, look);
  try {
    if (!prepare) await goTo(opened, file, hash);
    await steps(opened.page);
    assert.deepEqual(opened.faults, []);
    if (!prepare) await empty(opened);
    await (keep ?? opened.close)();
  } catch (error) {
    await opened.close();
    throw error;
  }
}

// The report `name` in the folder REPORTS.
export const visit = (browser, name, options = {}, steps) => visitFile(browser, path.join(process.env.REPORTS, `${name}.html`), options, steps);

// Waits until the circle that `selector` names has moved by more than a pixel, however slow the
// machine.
export const moves = (page, selector) => page.evaluate((name) => new Promise((resolve) => {
  const at = () => ["cx", "cy"].map((key) => Number(document.querySelector(name).getAttribute(key)));
  const [x, y] = at();
  const look = () => Math.hypot(at()[0] - x, at()[1] - y) > 1 ? resolve() : requestAnimationFrame(look);
  look();
}), selector);

// Waits until the number that `selector`'s input holds has both grown and fallen.
export const goesToAndFro = (page, selector) => page.evaluate((name) => new Promise((resolve) => {
  let last = Number(document.querySelector(name).value);
  const seen = new Set();
  const look = () => {
    const now = Number(document.querySelector(name).value);
    seen.add(Math.sign(now - last));
    last = now;
    if (seen.has(1) && seen.has(-1)) resolve();
    else requestAnimationFrame(look);
  };
  look();
}), selector);

// Fails where the page is wider than the window, or a part of it wider than its room.
export async function assertFits(page) {
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `the page is ${overflow} pixels too wide`);
  const clipped = await page.evaluate(() => [...document.querySelectorAll(".card, .table-frame, .plot")].filter((c) => c.scrollWidth > c.clientWidth + 1).map((c) => c.id || c.className));
  assert.deepEqual(clipped, []);
}

// Pixels of each plot that are not those of its background.
export const inkOf = (page) => page.locator("#plots canvas").evaluateAll((canvases) => canvases.map((canvas) => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let ink = 0;
  for (let i = 3; i < data.length; i += 4) ink += data[i] > 0;
  return ink;
}));

/// Whether the pages are built with the library of plots; without it there is none to look at.
export const hasCurves = process.env.HAS_CURVES !== "0";
export const withoutPlots = !hasCurves && "built without plots";

/// That there are plots, where they can be, and something is drawn in each.
export const assertInked = async (page, least = 500) => {
  const inks = await inkOf(page);
  assert.equal(inks.length > 0, hasCurves, `${inks.length} plots`);
  for (const ink of inks) assert.ok(ink > least, `${ink} pixels of ink`);
};

export const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
