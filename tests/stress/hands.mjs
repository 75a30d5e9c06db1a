// What random hands of all pages have in common.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { randomNumbers } from "../bench/report/drawings.mjs";
import { launch, open } from "../browser/browser.mjs";

const REST = 100;

// Numbers in [0, 1) for a seed, and one of a list by them.
export function hands(seed) {
  const random = randomNumbers(2654435769 ^ (Number(seed) * 40503));
  for (let i = 0; i < 20; ++i) random();
  return { random, pick: (list) => list[Math.floor(random() * list.length)] };
}

// The mouse from place to place, in pixels, its button held.
export async function through(page, places) {
  await page.mouse.move(...places[0]);
  await page.mouse.down();
  for (const place of places.slice(1)) await page.mouse.move(...place);
  await page.mouse.up();
}

export const PATIENCE = 120000;

// Opens the page that `program sketch` writes with `options`, and lets `does[name](page, at)` act on it, `at` from shares of the sheet to
// pixels, in an order of `pick`; every hundred `rests(page)` must come true. Returns how often each did something, and the
// messages of the console.
export async function act({ program, options = [], actions, pick, does, rests }) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-sketch-"));
  const file = path.join(folder, "sketch.html");
  execFileSync(program, ["sketch", ...options, "--out", file]);
  const browser = await launch();
  const { page, faults } = await open(browser, file);
  const done = {};
  for (let i = 1; i <= Number(actions) && !faults.length; ++i) {
    const box = await page.locator("#sheet").boundingBox({ timeout: PATIENCE });
    const name = pick(Object.keys(does));
    done[name] = (done[name] ?? 0) + 1;
    await does[name](page, ([x, y]) => [box.x + x * box.width, box.y + y * box.height]);
    if (i % REST) continue;
    await rests(page);
    console.error(`${i} of ${actions}`);
  }
  if (faults.length) faults.push(`on ${page.url()}`);
  await browser.close();
  fs.rmSync(folder, { recursive: true });
  return { said: Object.entries(done).map(([name, count]) => `${count} ${name}`).join(", "), faults };
}
