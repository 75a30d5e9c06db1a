// The page of a machine as a reader meets it: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { LOOKS, assertFits, assertInked, launch, visit as visitReport, withoutPlots } from "./browser.mjs";

const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `machine-${name}`, options, steps);

const timeTo = (page, value) => page.locator("#drive").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const time = (page) => page.locator("#drive").evaluate((input) => Number(input.value));

// The angle of the crank as it is drawn, counter-clockwise in degrees.
const crank = (page) => page.locator('.body[data-body="1"]').first().evaluate((part) => {
  const { a, b } = part.getCTM();
  return (-Math.atan2(b, a) * 180) / Math.PI;
});
const wrapped = (deg) => deg - 360 * Math.round(deg / 360);

for (const { size, scheme } of LOOKS) {
  test(`every motion fits a ${size} in ${scheme} colours`, () => visit("compressor", { size, scheme, ...still }, async (page) => {
    for (const task of ["start", "steady", "stop"]) {
      await page.locator(`[data-task=${task}]`).click();
      assert.equal(await page.locator('#tasks [aria-pressed="true"]').getAttribute("data-task"), task);
      for (const at of [0, 0.03, 0.1]) await timeTo(page, at);
      await assertFits(page);
      assert.doesNotMatch(await page.locator("#main").innerHTML(), /NaN|undefined|Infinity/);
      await assertInked(page);
    }
  }));
}

// J dω/dt = a − b ω from rest: ω = (a/b)(1 − exp(−b t/J)), and its integral.
test("the drive turns as the machine runs up", () => visit("run-up", still, async (page) => {
  await page.locator("[data-task=start]").click();
  const [speed, constant] = [25400 / 264, 10 / 264];
  for (const t of [0.01, 0.05, 0.11, 0.2]) {
    await timeTo(page, t);
    const turned = speed * (t - constant * (1 - Math.exp(-t / constant)));
    const left = wrapped((await crank(page)) - (turned * 180) / Math.PI);
    assert.ok(Math.abs(left) < 0.3, `${left}° at ${t} s`);
  }
}));

// Where the speed is least the crank turns least in a given time.
test("a press slows down while it works", () => visit("press", still, async (page) => {
  const turnedFrom = async (from) => {
    await timeTo(page, from);
    const before = await crank(page);
    await timeTo(page, from + 0.02);
    return wrapped((await crank(page)) - before);
  };
  const whole = Number(await page.locator("#drive").getAttribute("max"));
  const ways = [];
  for (let i = 0; i < 20; ++i) ways.push(await turnedFrom(((whole - 0.02) * i) / 19));
  const [least, greatest] = [Math.min(...ways), Math.max(...ways)];
  assert.ok(Math.abs((2 * (greatest - least)) / (greatest + least) - 0.1) < 0.015, `${least} to ${greatest}`);
}));

test("facts set the exact flywheel beside the approximate one", () => visit("press", still, async (page) => {
  const facts = await page.locator("#facts-list").textContent();
  assert.match(facts, /Flywheel, exact2\d\d\.\d+ kg·m²/);
  assert.match(facts, /Flywheel by the approximate formula3\d\d\.\d+ kg·m²/);
  assert.match(facts, /Minimum speed[\d.]+ rad\/s at [\d.]+°/);
}));

test("a motion plays slower than it is, stops, and is moved by keys", () => visit("motor-line-table-loads", {}, async (page) => {
  await page.waitForFunction(() => Number(document.getElementById("drive").value) > 0.05);
  await page.locator("#play").click();
  const stopped = await time(page);
  await page.waitForTimeout(200);
  assert.equal(await time(page), stopped);
  assert.match(await page.locator("#pace").textContent(), /^Shown at 0\.3\d+ times its real speed$/);
  await page.locator("#title").click();
  await page.keyboard.press("Shift+ArrowRight");
  const period = Number(await page.locator("#drive").getAttribute("max"));
  const step = (await time(page)) - stopped;
  assert.ok(Math.abs((step + (step < 0 ? period : 0)) / period - 1 / 36) < 1e-6);
}));

test("a plot is picked at an angle, and the machine goes there", { skip: withoutPlots }, () => visit("press", still, async (page) => {
  const plot = page.locator("#plots .u-over").first();
  await plot.click({ position: { x: 0.25 * (await plot.boundingBox()).width, y: 40 } });
  assert.ok(Math.abs(wrapped((await crank(page)) - 90)) < 1.5, String(await crank(page)));
}));

test("a machine that stalls says so and has no curves", () => visit("stall", still, async (page) => {
  assert.match(await page.locator("#notes-list").textContent(), /stalls/);
  assert.ok(await page.locator("#player").isHidden());
  assert.equal(await page.locator("#curves").isVisible(), false);
  assert.match(await page.locator("#status").textContent(), /No solution/);
  await assertFits(page);
}));

test("the page speaks Chinese", () => visit("flywheel-of-table-loads", { ...still, locale: "zh-CN" }, async (page) => {
  assert.match(await page.locator("#facts-list").textContent(), /飞轮转动惯量（精确值）63\d/);
  assert.equal(await page.locator("#curves-title").textContent(), "稳定运转");
  await assertFits(page);
}));
