// Pictures of a report for a person to look at, whole, at the widths of a desk, a laptop and a phone, in both languages, of the
// phone in dark colours. node screenshots.mjs REPORT.html OUTDIR [DRIVE], DRIVE in degrees or length. Those of the
// documentation are made by pictures.mjs.
import { mkdirSync } from "node:fs";
import path from "node:path";
import { launch, open } from "./browser.mjs";

const [report, folder, drive = "60"] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node screenshots.mjs REPORT.html OUTDIR [DRIVE]");
  process.exit(2);
}

const LOOKED_AT = [{ name: "1440x900", width: 1440, height: 900 }, { name: "1280x720", width: 1280, height: 720 }, { name: "390x844", width: 390, height: 844, size: "phone", scheme: "dark" }];
mkdirSync(folder, { recursive: true });
const browser = await launch();
for (const { name, width, height, size, scheme } of LOOKED_AT) {
  for (const locale of ["en-GB", "zh-CN"]) {
    const { page, faults, close } = await open(browser, report, { size, scheme, locale, motion: "reduce" });
    await page.setViewportSize({ width, height });
    const slider = page.locator("#crank, #drive").first();
    if (await slider.isVisible()) await slider.evaluate((input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, drive);
    const forces = page.locator("[data-layer=reactions]");
    if (await forces.isVisible()) await forces.click();
    await page.waitForTimeout(100);
    await page.screenshot({ path: path.join(folder, `${name}-${locale.slice(0, 2)}.png`), fullPage: true });
    for (const fault of faults) console.error(fault);
    await close();
  }
}
await browser.close();
