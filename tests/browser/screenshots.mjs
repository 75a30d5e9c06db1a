// Pictures of a report for a person to look at, whole at desktop and phone width in light and dark.
// node screenshots.mjs REPORT.html OUTDIR [DRIVE], DRIVE in degrees or length. Those of the
// documentation are made by pictures.mjs.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { SIZES, launch, open } from "./browser.mjs";

const [report, folder, drive = "60"] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node screenshots.mjs REPORT.html OUTDIR [DRIVE]");
  process.exit(2);
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
    for (const fault of faults) console.error(fault);
    await close();
  }
}
await browser.close();
