// The pages of gear trains as a reader meets them: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertFits, launch, LOOKS, visit as visitReport } from "./browser.mjs";
import { some } from "./thinned.mjs";

const NAMES = ["planetary", "simpson", "ferguson", "differential", "clock", "coaxial"];
const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `train-${name}`, options, steps);

const driveTo = (page, value) => page.locator("#drive").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);

// By how much the part that `selector` names is turned in the picture, counter-clockwise in degrees,
// and where it stands.
const stance = (page, selector) => page.locator(selector).first().evaluate((part) => {
  const { a, b, e, f } = part.getScreenCTM();
  return { deg: -(Math.atan2(b, a) * 180) / Math.PI, x: e, y: f };
});
const wrapped = (deg) => deg - 360 * Math.round(deg / 360);

for (const { size, scheme } of LOOKS) {
  for (const name of some(NAMES)) {
    test(`${name} fits a ${size} in ${scheme} colours`, () => visit(name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      for (const deg of [0, 77, 300]) await driveTo(page, deg);
      assert.doesNotMatch(await page.locator("#picture").innerHTML(), /NaN|undefined|Infinity/);
      assert.ok(await page.locator("#members-rows tr").count() >= 2);
    }));
  }
}

test("a planetary train turns as its ratio says", () => visit("planetary", still, async (page) => {
  const parts = [".planet-gear", ".carrier-arm"];
  await driveTo(page, 0);
  const before = await Promise.all(parts.map((part) => stance(page, part)));
  await driveTo(page, 90);
  const [planet, arm] = await Promise.all(parts.map((part) => stance(page, part)));
  // 2/9 and −2/5 of the sun's angle.
  assert.ok(Math.abs(wrapped(arm.deg - before[1].deg - 20)) < 0.01);
  assert.ok(Math.abs(wrapped(planet.deg - before[0].deg + 36)) < 0.01);
  assert.ok(Math.abs(Math.atan2(arm.y - planet.y, planet.x - arm.x) * 180 / Math.PI - 20) < 0.1);
}));

test("each state of a gearbox has its own figures", () => visit("simpson", still, async (page) => {
  const ratio = () => page.locator("#facts-list").textContent();
  assert.match(await ratio(), /76\/31/);
  await page.locator("#designs button").nth(3).click();
  assert.match(await ratio(), /−31\/14/);
  assert.equal(await page.locator('#designs button[aria-pressed="true"]').count(), 1);
}));
