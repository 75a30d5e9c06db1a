// The page of `cognate sketch --mechanism` in a browser. COGNATE: the program.
import { execFile, execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { promisify } from "node:util";
import { BUILD_SHEET } from "../../app/report/page/build/sheet.js";
import { View } from "../../app/report/page/view.js";
import { launch, visitFile } from "./browser.mjs";

let browser, folder;
export let file;
before(async () => {
  browser = await launch();
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-building-"));
  file = path.join(folder, "mechanism.html");
  execFileSync(process.env.COGNATE, ["sketch", "--mechanism", "--out", file]);
});
after(async () => { await browser?.close(); fs.rmSync(folder, { recursive: true }); });

// `problem`: a file with which the page is written.
export async function visit({ problem, ...options }, steps) {
  await visitFile(browser, problem ? written(problem) : file, { motion: "reduce", ...options }, async (page) => {
    await page.locator(".build-tool[aria-checked=true]").waitFor();
    await steps(page);
  });
}

function written(problem) {
  const given = path.join(folder, `${path.basename(problem, ".toml")}.html`);
  execFileSync(process.env.COGNATE, ["sketch", problem, "--out", given]);
  return given;
}

// What the program makes of a file: its result. Several may be asked for at once.
let files = 0;
export async function analysed(text) {
  const name = path.join(folder, `built-${++files}.toml`);
  fs.writeFileSync(name, text);
  const { stdout } = await promisify(execFile)(process.env.COGNATE, ["analyze", "--json", name], { maxBuffer: 1 << 28 });
  return JSON.parse(stdout);
}

// How the sheet lies in the window, as long as nobody has zoomed.
export async function sheetOf(page) {
  const { x, y, width, height } = await page.locator("#picture").evaluate((one) => { const { left, top } = one.getBoundingClientRect(); return { x: left, y: top, width: one.clientWidth, height: one.clientHeight }; });
  const view = new View(BUILD_SHEET, width, height);
  return { at: (place) => view.screen(place).map((part, k) => part + [x, y][k]), plane: (pixels) => view.plane(pixels), scale: view.scale };
}

export const choose = (page, tool) => page.locator(`[data-tool=${tool}]`).click();

// Drags with the mouse from place to place of the sheet, and clicks there.
export async function drag(page, from, to) {
  const { at } = await sheetOf(page);
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at(from.map((x, k) => (x + to[k]) / 2)));
  await page.mouse.move(...at(to));
  await page.mouse.up();
}

export const click = async (page, place) => page.mouse.click(...(await sheetOf(page)).at(place));

export async function drawLinks(page, links) {
  await choose(page, "link");
  for (const [from, to] of links) await drag(page, from, to);
}

export async function fix(page, pins) {
  await choose(page, "pivot");
  for (const pin of pins) await click(page, pin);
}

// The joints in the list beside the sheet: of each name its place, and whether it is fixed.
export const jointsOf = (page) => page.locator("#joints-rows tr").evaluateAll((rows) => Object.fromEntries(rows.map((row) => {
  const [name, x, y, fixed] = [...row.querySelectorAll("input")];
  return [name.value, { at: [Number(x.value), Number(y.value)], fixed: fixed.checked }];
})));

// The links with their joints, as "A–B".
export const linksOf = (page) => page.locator("#links-rows tr").evaluateAll((rows) => Object.fromEntries(rows.map((row) => [row.querySelector("input").value, row.cells[1].textContent])));

export const saidOf = (page) => page.locator("#state").textContent();

// Until the mechanism moves.
export const moving = (page) => page.waitForFunction(() => document.getElementById("state").className === "sound", null, { timeout: 10000 });

// Puts the drive at a coordinate, and says where pins are on the sheet then.
export async function pinsAt(page, drive, names) {
  await page.locator("#drive").evaluate((slider, value) => { slider.value = value; slider.dispatchEvent(new Event("input")); }, drive);
  const { plane } = await sheetOf(page);
  const pins = await page.locator("[data-pin]").evaluateAll((all) => all.map((one) => [one.dataset.pin, Number(one.getAttribute("cx")), Number(one.getAttribute("cy"))]));
  return names.map((name) => { const [, x, y] = pins.find(([pin]) => pin === name); return plane([x, y]); });
}

// Types another value into a field of the lists, and leaves it.
export async function typedIn(page, cell, value) {
  await page.locator("#forces").evaluate((one) => { one.open = true; });
  await page.locator(`[data-cell="${cell}"]`).fill(value);
  await page.keyboard.press("Enter");
}

// The limits of the drive.
export const driveOf = (page) => page.locator("#drive").evaluate((slider) => [Number(slider.min), Number(slider.max)]);

// Values behind the texts of the facts, by the names that the page gives them.
export const factsOf = (page) => page.locator("#facts-list").evaluate((list) => {
  const names = [...list.querySelectorAll("dt")], values = [...list.querySelectorAll("dd")];
  return Object.fromEntries(names.map((name, i) => [name.textContent, values[i].title ? Number(values[i].title) : values[i].textContent]));
});
