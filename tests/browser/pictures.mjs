// The pictures of reports in docs/pictures: solves the library problems concerned and photographs the
// head of each report, down to its curves. cmake --build --preset release --target docs-pictures, or
//   node pictures.mjs PROGRAM LIBRARY OUTDIR [NAME...]
// PNGs become a third as large where pngquant is installed.
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { launch, open } from "./browser.mjs";
import { solidsPicture } from "./solids_picture.mjs";

const [program, library, folder, ...wanted] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node pictures.mjs PROGRAM LIBRARY OUTDIR [NAME...]");
  process.exit(2);
}

// A drop, drawn by hand on the page of `cognate sketch`.
const DROP = Array.from({ length: 61 }, (_, i) => (i * Math.PI) / 30).map((t) => [0.44 + 0.1 * Math.sin(t), 0.5 - 0.17 * Math.cos(t) + 0.04 * Math.cos(2 * t)]);

// Poses likewise: where the body is, and whereto it points.
const POSES = [[[0.22, 0.62], [0.3, 0.62]], [[0.33, 0.42], [0.4, 0.38]], [[0.52, 0.3], [0.56, 0.22]], [[0.7, 0.36], [0.7, 0.26]]];

// A function likewise, through its diagram.
const FUNCTION = Array.from({ length: 61 }, (_, i) => i / 60).map((t) => [0.16 + 0.367 * t, 0.645 - 0.6 * (0.04 + 0.92 * (1.25 * t - 0.25 * t * t * t))]);

// A straight line, from end to end.
const LINE = [[0.3, 0.7], [0.72, 0.7]];

// `options` of the command. `choose`: a list and a word of it, before the strokes. `draw`: strokes, in shares of the sheet, after a click on `begin`. `click`: a choice about the picture. `press`: the extra layers of the picture. `drive`: where the mechanism stands, in degrees or length. `show`: how far down the picture goes.
const PICTURES = [
  { name: "sketch", command: "sketch", file: "sketch", draw: [DROP], drive: 150, show: "#stage" },
  { name: "sketch-front", command: "sketch", file: "sketch", draw: [DROP], only: "#front" },
  { name: "sketch-poses", command: "sketch", file: "sketch", begin: "#of-poses", draw: POSES, drive: 80, show: "#stage" },
  { name: "sketch-function", command: "sketch", file: "sketch", begin: "#of-function", draw: [FUNCTION], drive: 105, show: "#stage" },
  { name: "sketch-slider-crank", command: "sketch", file: "sketch", begin: "#by-slider", draw: [DROP], drive: 60, show: "#stage" },
  { name: "sketch-both", command: "sketch", file: "sketch", begin: "#by-both", draw: [DROP], drive: 60, show: "#stage" },
  { name: "sketch-line", command: "sketch", file: "sketch", begin: "#of-line", draw: [LINE], choose: ["#class", "crank-rocker"], drive: 60, show: "#stage" },
  { name: "build", command: "sketch", file: "mechanism", options: ["--mechanism"], begin: "[data-example=quick_return]", drive: 148, show: "#stage" },
  { name: "report", command: "solve", file: "path/ten-point-ellipse" },
  { name: "report-dark", command: "solve", file: "path/ten-point-ellipse", scheme: "dark" },
  { name: "report-zh", command: "solve", file: "path/ten-point-ellipse", locale: "zh-CN" },
  { name: "magnifier", command: "solve", file: "path/ten-point-ellipse", drive: 125, press: ["velocity", "lens", "cognate3"], only: "#stage" },
  { name: "function", command: "solve", file: "function/log10-refined", drive: 90 },
  { name: "synthesis", command: "solve", file: "motion/four-poses", drive: 100 },
  { name: "straight-line", command: "solve", file: "straight-line/search-hoeken", drive: 180 },
  { name: "analysis", command: "analyze", file: "analysis/shaper" },
  { name: "cam", command: "solve", file: "cam/smallest-cam" },
  { name: "machine", command: "analyze", file: "machine/press", drive: 0.7 },
  { name: "gears", command: "analyze", file: "gear-pair/standard", drive: 4, click: "[data-look=mesh]", only: "#stage" },
  { name: "gear-rack", command: "analyze", file: "gear/undercut-9", drive: 12, only: "#stage" },
  { name: "train", command: "analyze", file: "gear-train/planetary", drive: 20, only: "#stage" },
  { name: "tolerances", command: "analyze", file: "analysis/toleranced-rocker", only: "#tolerances" },
  { name: "study", command: "sweep", file: "study/crank-rocker-map", show: "#scatter" },
  { name: "atlas", command: "sweep", file: "study/atlas", only: "#atlas" },
];
const SIZE = { width: 1280, height: 1000 };

async function setDrive(page, value) {
  const slider = page.locator("#crank, #drive").first();
  if (!await slider.count() || !await slider.isVisible()) return;
  await slider.evaluate((input, to) => {
    input.value = to;
    input.dispatchEvent(new Event("input"));
  }, value);
}

// Draws the arrows of forces where the page has a switch for them.
async function showForces(page) {
  const forces = page.locator("[data-layer=reactions]").first();
  if (await forces.count() && await forces.isVisible()) await forces.click();
}

async function drawStrokes(page, strokes) {
  const sheet = await page.locator("#picture").boundingBox();
  const at = ([x, y]) => [sheet.x + x * sheet.width, sheet.y + y * sheet.height];
  for (const stroke of strokes) {
    await page.mouse.move(...at(stroke[0]));
    await page.mouse.down();
    for (const point of stroke) await page.mouse.move(...at(point));
    await page.mouse.up();
  }
  await page.mouse.move(0, 0);
  // Until the longest search and the front have ended.
  await page.waitForFunction(() => document.querySelectorAll(".design-card").length === 3 && /^The least error/.test(document.getElementById("front-note").textContent), undefined, { timeout: 240000 });
}

// Writes the page of a picture into `folder`.
function writePage({ command, file, options = [] }, folder) {
  const page = path.join(folder, `${path.basename(file)}.report.html`);
  const what = command === "sketch" ? [...options, "--out", page] : [path.join(library, `${file}.toml`), "--out", folder];
  // A report is written, too, where a problem cannot be met.
  if (!existsSync(page)) spawnSync(program, [command, ...what, "--quiet"], { stdio: "inherit" });
  return page;
}

async function photograph(page, { only, show = "#curves" }, file) {
  if (only) {
    const part = page.locator(only).first();
    await part.scrollIntoViewIfNeeded();
    await page.waitForTimeout(300);
    const { x, y, width, height } = await part.evaluate((element) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      return { x: left + scrollX, y: top + scrollY, width, height };
    });
    await page.screenshot({ path: file, fullPage: true, clip: { x, y, width, height: Math.min(height, SIZE.height) } });
    return;
  }
  const foot = page.locator(show).first();
  const box = await foot.count() ? await foot.boundingBox() : null;
  const height = box ? Math.ceil(box.y + box.height + 8) : SIZE.height;
  await page.screenshot({ path: file, fullPage: true, clip: { x: 0, y: 0, width: SIZE.width, height } });
}

const scratch = mkdtempSync(path.join(tmpdir(), "cognate-pictures-"));
mkdirSync(folder, { recursive: true });
const browser = await launch();
let faulty = false;
for (const picture of PICTURES.filter(({ name }) => !wanted.length || wanted.includes(name))) {
  const { name, locale, scheme = "light", drive = 60 } = picture;
  const { page, faults, close } = await open(browser, writePage(picture, scratch), { scheme, locale, motion: "reduce" });
  await page.setViewportSize(SIZE);
  if (picture.begin) await page.locator(picture.begin).click();
  if (picture.choose) await page.locator(picture.choose[0]).selectOption(picture.choose[1]);
  if (picture.draw) await drawStrokes(page, picture.draw);
  await setDrive(page, drive);
  await showForces(page);
  if (picture.click) await page.locator(picture.click).click();
  for (const extra of picture.press ?? []) await page.locator(`[data-extra=${extra}]`).click();
  await page.waitForTimeout(300);
  const target = path.join(folder, `${name}.png`);
  await photograph(page, picture, target);
  await close();
  spawnSync("pngquant", ["--force", "--skip-if-larger", "--output", target, "--", target]);
  console.log(target);
  for (const fault of faults) {
    console.error(`${name}: ${fault}`);
    faulty = true;
  }
}
await browser.close();

// The links of that linkage as parts to be cut.
if (!wanted.length || wanted.includes("parts")) {
  execFileSync(program, ["solve", path.join(library, "path/ten-point-ellipse.toml"), "--out", scratch, "--quiet"]);
  execFileSync(program, ["export", path.join(scratch, "ten-point-ellipse.result.json"), "--format", "svg",
    "--parts", "--hole", "3", "--width", "8", "--thickness", "3", "--out", scratch, "--quiet"]);
  copyFileSync(path.join(scratch, "ten-point-ellipse.parts.svg"), path.join(folder, "parts.svg"));
}
// Those of Jansen's leg, packed on a sheet, with engraved names.
if (!wanted.length || wanted.includes("sheet")) {
  execFileSync(program, ["analyze", path.join(library, "analysis/jansen-leg.toml"), "--out", scratch, "--quiet"]);
  execFileSync(program, ["export", path.join(scratch, "jansen-leg.result.json"), "--format", "svg", "--parts", "--hole", "2",
    "--width", "6", "--kerf", "0.2", "--labels", "stroke", "--sheet", "120x90", "--gap", "2", "--out", scratch, "--quiet"]);
  copyFileSync(path.join(scratch, "jansen-leg.parts.svg"), path.join(folder, "sheet.svg"));
}
// Those of a shaper, its sliders with blocks.
if (!wanted.length || wanted.includes("blocks")) {
  execFileSync(program, ["analyze", path.join(library, "analysis/shaper.toml"), "--out", scratch, "--quiet"]);
  execFileSync(program, ["export", path.join(scratch, "shaper.result.json"), "--format", "svg", "--parts", "--hole", "0.01",
    "--width", "0.05", "--thickness", "0.02", "--clearance", "0.001", "--block", "0.05x0.025", "--out", scratch, "--quiet"]);
  copyFileSync(path.join(scratch, "shaper.parts.svg"), path.join(folder, "blocks.svg"));
}
// Klann's leg as solids.
if (!wanted.length || wanted.includes("solids")) {
  execFileSync(program, ["analyze", path.join(library, "analysis/klann-leg.toml"), "--out", scratch, "--quiet"]);
  const made = execFileSync(program, ["export", path.join(scratch, "klann-leg.result.json"), "--format", "stl", "--length-unit", "cm",
    "--parts", "--hole", "0.1", "--width", "0.2", "--thickness", "0.05", "--position", "30", "--chord-tolerance", "0.002",
    "--out", scratch, "--json"], { encoding: "utf8" });
  writeFileSync(path.join(folder, "solids.svg"), solidsPicture(JSON.parse(made), 10));
}
rmSync(scratch, { recursive: true });
process.exit(faulty ? 1 : 0);
