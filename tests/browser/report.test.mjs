// The report page as a reader meets it: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { assertFits, assertInked, distance, goesToAndFro, hasCurves, launch, LOOKS, moves, visit as visitReport, withoutPlots } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const visit = (name, options, steps) => visitReport(browser, name, options, steps);

const still = { motion: "reduce" };
const pin = (page) => page.locator("#pin-b").evaluate((c) => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))]);
const fact = (page, list, name) => page.locator(`#${list}-list dt`, { hasText: name }).locator("+ dd").first().textContent();
const errorLength = (page) => page.locator("path.error").evaluateAll((lines) => Math.max(...lines.map((l) => l.getTotalLength())));

for (const { size, scheme } of LOOKS) {
  for (const name of some(["ellipse", "log10-refined", "three-angle-pairs", "hundred", "hostile", "nothing"])) {
    test(`${name} fits a ${size} in ${scheme} colours`, () => visit(name, { size, scheme }, async (page) => {
      await assertFits(page);
      if (name === "nothing") return;
      const page_ = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      assert.equal(page_ === "rgb(245, 246, 248)", scheme === "light");
      await assertInked(page);
    }));
  }
}

test("the crank turns by itself, stops, and goes on", () => visit("ellipse", {}, async (page) => {
  await moves(page, "#pin-b");
  await page.locator("#play").click();
  const stopped = await pin(page);
  await page.waitForTimeout(400);
  assert.equal(distance(stopped, await pin(page)), 0);
  assert.equal(await page.locator("#play").getAttribute("aria-label"), "Play");
  await page.locator("body").press("Space");
  await moves(page, "#pin-b");
}));

test("with reduced motion the page does not play by itself", () => visit("ellipse", still, async (page) => {
  const start = await pin(page);
  await page.waitForTimeout(300);
  assert.deepEqual(await pin(page), start);
}));

test("slider, arrow keys and crank pin turn the crank", () => visit("ellipse", still, async (page) => {
  const crank = async () => Number.parseFloat(await page.locator("#crank-value").textContent());
  const slider = await page.locator("#crank").boundingBox();
  await page.mouse.move(slider.x + 5, slider.y + slider.height / 2);
  await page.mouse.down();
  await page.mouse.move(slider.x + slider.width / 2, slider.y + slider.height / 2);
  await page.mouse.up();
  assert.ok(Math.abs(await crank() - 180) < 3);
  await page.locator("#title").click();
  await page.keyboard.press("Shift+ArrowRight");
  const turned = await crank();
  assert.ok(turned > 186 && turned < 194);

  const [picture, b] = [await page.locator("#picture").boundingBox(), await pin(page)];
  await page.mouse.move(picture.x + b[0], picture.y + b[1]);
  await page.mouse.down();
  await page.mouse.move(picture.x + b[0] + 300, picture.y + b[1]);
  await page.mouse.up();
  assert.ok(distance(b, await pin(page)) > 5);
  assert.ok(Math.abs(await crank() - turned) > 20);
}));

test("a click on a curve turns the crank, in all curves", { skip: withoutPlots }, () => visit("ellipse", still, async (page) => {
  const crank = async () => Number.parseFloat(await page.locator("#crank-value").textContent());
  await page.locator("#curves").scrollIntoViewIfNeeded();
  const plot = await page.locator(".plot .u-over").last().boundingBox();
  await page.mouse.click(plot.x + plot.width / 4, plot.y + plot.height / 2);
  assert.ok(Math.abs(await crank() - 90) < 2);
  const cursors = await page.locator(".u-cursor-x").evaluateAll((lines) => lines.map((l) => new DOMMatrix(getComputedStyle(l).transform).m41 / l.parentElement.clientWidth));
  assert.ok(cursors.length > 0);
  for (const share of cursors) assert.ok(Math.abs(share - 0.25) < 0.01);
}));

test("the links keep their lengths through the cycle", () => visit("ellipse", still, async (page) => {
  const lengths = new Set();
  for (const crank of [0, 77, 190, 301]) {
    await page.locator("#crank").evaluate((input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, crank);
    const [a, b, c, d] = await page.locator("circle.pin").evaluateAll((pins) => {
      const all = pins.map((p) => [Number(p.getAttribute("cx")), Number(p.getAttribute("cy"))]);
      return [all[0], all[2], all[3], all[1]];
    });
    const frame = distance(a, d);
    lengths.add([distance(a, b), distance(b, c), distance(c, d)].map((l) => (80 * l / frame).toFixed(0)).join(" "));
  }
  assert.deepEqual([...lengths], ["8 51 42"]);
}));

test("the errors grow with the magnification", () => visit("ellipse", still, async (page) => {
  const set = (step) => page.locator("#magnify").evaluate((input, value) => { input.value = value; input.dispatchEvent(new Event("input")); }, step);
  await set(6);
  const hundredfold = await errorLength(page);
  await set(9);
  assert.equal(await page.locator("#magnify-value").textContent(), "×1,000");
  const ratio = await errorLength(page) / hundredfold;
  assert.ok(Math.abs(ratio - 10) < 0.3, `${ratio}`);
}));

test("the table switches by click and by key", () => visit("ellipse", still, async (page) => {
  assert.equal(await fact(page, "dimensions", "Crank"), "8.045683");
  assert.match(await fact(page, "qualities", "Sum of squares"), /^4\.0199\d*×10⁻⁴$/);
  await page.locator("#designs tbody").nth(1).locator(".origin").click();
  assert.equal(await fact(page, "dimensions", "Crank"), "8.2");
  assert.equal(await page.locator("#stage-title").textContent(), "Linkage of design 2");
  const plots = await page.locator("#plots .plot").evaluateAll((all) => all.map((p) => [p.clientWidth, p.querySelector(".u-wrap")?.clientWidth]));
  if (hasCurves) for (const [room, taken] of plots) assert.ok(taken <= room, `a plot of ${taken} pixels where there are ${room}`);
  await page.keyboard.press("ArrowUp");
  assert.equal(await fact(page, "dimensions", "Crank"), "8.045683");
  assert.equal(await page.locator("#design-0").isChecked(), true);
}));

test("constraints show what is missed", () => visit("ellipse", still, async (page) => {
  const row = page.locator("#checks tr.missed");
  assert.equal(await row.count(), 1);
  assert.match((await row.textContent()).replace(/\s+/g, " "), /^Transmission.angle.*142\.\d+°?45 … 135°?✗ no/);
}));

test("a hundred designs scroll within their table", () => visit("hundred", still, async (page) => {
  const frame = page.locator("#designs-frame");
  assert.ok(await frame.evaluate((f) => f.scrollHeight > 2 * f.clientHeight));
  await page.locator("#design-0").focus();
  await page.keyboard.press("ArrowUp");
  assert.equal(await page.locator("#design-99").isChecked(), true);
  assert.ok(await frame.evaluate((f) => f.scrollTop > 100));
}));

test("a crank that does not turn fully goes to and fro", () => visit("hundred", {}, async (page) => {
  await page.locator("#design-4").check();
  const [from, to] = await page.locator("#crank").evaluate((input) => [Number(input.min), Number(input.max)]);
  assert.ok(to - from < 359);
  await page.locator("#speed").evaluate((input) => { input.value = 3; input.dispatchEvent(new Event("input")); });
  await goesToAndFro(page, "#crank");
}));

test("the framing leads from the curve to the whole linkage", () => visit("ellipse", still, async (page) => {
  const width = () => page.locator("path.path").evaluate((p) => p.getBBox().width);
  await page.locator("[data-framing=whole]").click();
  const whole = await width();
  await page.locator("[data-framing=curve]").click();
  assert.ok(await width() > 2 * whole);
  assert.equal(await page.locator("[data-framing=curve]").getAttribute("aria-pressed"), "true");
}));

test("text of the user's stays text", () => visit("hostile", still, async (page) => {
  assert.match(await page.title(), /^<\/script>/);
  assert.match(await page.locator("h1").textContent(), /<\/script>.*\u2028 & <b>$/);
  assert.equal(await page.locator("img").count(), 0);
}));

test("no design: the page says so", () => visit("nothing", still, async (page) => {
  assert.equal(await page.locator("#status").textContent(), "No solution");
  assert.match(await page.locator("#notes").textContent(), /The bounds leave no crank-rocker/);
  assert.equal(await page.locator("#stage").isVisible(), false);
}));

test("a function generator shows the desired function, and its error", () => visit("log10-refined", still, async (page) => {
  assert.match(await page.locator("#readout").textContent(), /error/);
  assert.ok(await page.locator("path.wanted").evaluate((p) => p.getTotalLength() > 20));
  if (hasCurves) assert.match(await page.locator(".plot h3").nth(1).textContent(), /Structural error/);
}));

test("a closed target is drawn where the coupler curve follows it", () => visit("drop-of-any-size", still, async (page) => {
  assert.equal(await page.locator("circle.target").count(), 0);
  const apart = await page.evaluate(() => {
    const points = (selector) => {
      const line = document.querySelector(selector);
      return Array.from({ length: 400 }, (_, i) => line.getPointAtLength((line.getTotalLength() * i) / 400));
    };
    const [wanted, traced] = [points("path.outline"), points("path.path")];
    const size = Math.max(...wanted.map((p) => p.x)) - Math.min(...wanted.map((p) => p.x));
    return Math.max(...wanted.map((p) => Math.min(...traced.map((q) => Math.hypot(p.x - q.x, p.y - q.y))))) / size;
  });
  assert.ok(apart < 0.03, `${apart} of its width apart`);
}));

test("a report prints in light colours", () => visit("ellipse", { ...still, scheme: "dark" }, async (page) => {
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 20000);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).color), "rgb(27, 34, 48)");
}));
