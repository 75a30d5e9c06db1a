// Pictures of a report, whole at desktop and phone width in light and dark, and its head down to the
// curves, as the documentation shows it: report.png, of an analysis (with its force arrows)
// analysis.png, of a cam cam.png, of a study study.png. node screenshots.mjs REPORT.html OUTDIR
// [DRIVE], DRIVE in degrees or length. In docs/pictures, report.png is of path/ten-point-ellipse.toml,
// analysis.png of analysis/shaper.toml, cam.png of cam/smallest-cam.toml, study.png of
// study/crank-rocker-map.toml, synthesis.png of motion/four-poses.toml with DRIVE 100 and under its
// new name.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { SIZES, launch, open } from "./browser.mjs";

const [report, folder, drive = "60"] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node screenshots.mjs REPORT.html OUTDIR [DRIVE]");
  process.exit(2);
}

const PICTURE = { width: 1280, height: 1000 };

// The page from its top to the foot of its curves, of a study to that of its scatter plot.
async function head(page, file) {
  await page.setViewportSize(PICTURE);
  await page.waitForTimeout(200);
  const curves = await page.locator("#curves, #scatter").boundingBox();
  if (curves) await page.screenshot({ path: file, fullPage: true, clip: { x: 0, y: 0, width: PICTURE.width, height: Math.ceil(curves.y + curves.height + 8) } });
}

mkdirSync(folder, { recursive: true });
const browser = await launch();
for (const size of Object.keys(SIZES)) {
  for (const scheme of ["light", "dark"]) {
    const { page, faults, close } = await open(browser, report, { size, scheme, motion: "reduce" });
    const slider = page.locator("#crank, #drive");
    if (await slider.isVisible()) await slider.evaluate((input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, drive);
    const forces = page.locator("[data-layer=reactions]");
    if (await forces.isVisible()) await forces.click();
    await page.waitForTimeout(100);
    await page.screenshot({ path: path.join(folder, `${size}-${scheme}.png`), fullPage: true });
    if (size === "desktop" && scheme === "light") {
      const kind = await page.locator("#scatter").count() ? "study" : await page.locator(".cam-body").count() ? "cam" : await page.locator("#drive").count() ? "analysis" : "report";
      await head(page, path.join(folder, `${kind}.png`));
    }
    for (const fault of faults) console.error(fault);
    await close();
  }
}
await browser.close();
