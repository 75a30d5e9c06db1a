// The pages of gears as a reader meets them: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import path from "node:path";
import { after, before } from "node:test";
import { assertFits, assertInked, launch, LOOKS, visit as visitReport, withoutPlots } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const PAIRS = ["pair", "lost", "overlap", "helical", "bevel", "search"];
const NAMES = [...PAIRS, "gear", "undercut", "worm"];
const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `gear-${name}`, options, steps);

const driveTo = (page, value) => page.locator("#drive").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const drive = (page) => page.locator("#drive").evaluate((input) => Number(input.value));
const nearMesh = (page) => page.locator("[data-look=mesh]").click();
const wrapped = (deg) => deg - 360 * Math.round(deg / 360);

// The angle on the screen, clockwise in degrees, by which the element that `selector` names is turned.
const turned = (page, selector) => page.locator(selector).first().evaluate((part) => {
  const { a, b } = part.getScreenCTM();
  return (Math.atan2(b, a) * 180) / Math.PI;
});

// How far `points` of the screen are from the outline that `selector` names, and whether they are
// inside it; only its edges in the picture are looked at.
const placesAt = (page, selector, points) => page.evaluate(([name, list]) => {
  const part = document.querySelector(name);
  const { left, right, top, bottom } = document.getElementById("picture").getBoundingClientRect();
  const matrix = part.getScreenCTM();
  const numbers = part.getAttribute("d").match(/-?[\d.]+/g).map(Number);
  const corners = Array.from({ length: numbers.length / 2 }, (_, i) => new DOMPoint(numbers[2 * i], numbers[2 * i + 1]).matrixTransform(matrix));
  const isNear = ({ x, y }) => x > left - 40 && x < right + 40 && y > top - 40 && y < bottom + 40;
  const edges = corners.map((q, i) => [corners.at(i - 1), q]).filter(([p, q]) => isNear(p) || isNear(q));
  const toEdge = ([x, y], [p, q]) => {
    const [u, v] = [q.x - p.x, q.y - p.y];
    const t = Math.min(1, Math.max(0, ((x - p.x) * u + (y - p.y) * v) / (u * u + v * v || 1)));
    return Math.hypot(x - p.x - t * u, y - p.y - t * v);
  };
  const back = matrix.inverse();
  return list.map((p) => ({ away: Math.min(...edges.map((edge) => toEdge(p, edge))), inside: part.isPointInFill(new DOMPoint(...p).matrixTransform(back)) }));
}, [selector, points]);

// Corners of a drawn outline that are seen in the picture.
const seen = (page, selector) => page.evaluate((name) => {
  const part = document.querySelector(name);
  const { left, right, top, bottom } = document.getElementById("picture").getBoundingClientRect();
  const numbers = part.getAttribute("d").match(/-?[\d.]+/g).map(Number);
  return Array.from({ length: numbers.length / 2 }, (_, i) => new DOMPoint(numbers[2 * i], numbers[2 * i + 1]).matrixTransform(part.getScreenCTM()))
    .filter(({ x, y }) => x > left && x < right && y > top && y < bottom).map(({ x, y }) => [x, y]);
}, selector);

// How deep, in pixels, what is drawn as `first` reaches into `second`.
async function overlap(page, first = ".gear.pinion", second = ".gear.wheel") {
  const points = await seen(page, first);
  assert.ok(points.length > 30);
  return Math.max(0, ...(await placesAt(page, second, points)).filter(({ inside }) => inside).map(({ away }) => away));
}

const dots = (page) => page.locator(".gear-contact:not([hidden])").evaluateAll((list) => list.map((dot) => {
  const p = new DOMPoint(Number(dot.getAttribute("cx")), Number(dot.getAttribute("cy"))).matrixTransform(dot.getScreenCTM());
  return [p.x, p.y];
}));

for (const { size, scheme } of LOOKS) {
  for (const name of some(size === "desktop" ? NAMES : ["pair", "undercut", "worm"])) {
    test(`${name} fits a ${size} in ${scheme} colours, with all that it can show`, () => visit(name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      await page.locator('[data-layer][aria-pressed="false"]:visible').evaluateAll((buttons) => buttons.forEach((button) => button.click()));
      const most = await page.locator("#drive").evaluate((input) => Number(input.max));
      for (const share of [0, 0.2, 0.7]) await driveTo(page, share * most);
      await assertFits(page);
      assert.doesNotMatch(await page.locator("#picture").innerHTML(), /NaN|undefined|Infinity/);
      if (name !== "worm") await assertInked(page);
      assert.ok(statSync(path.join(process.env.REPORTS, `gear-${name}.html`)).size < 1.5e6);
    }));
  }
}

for (const name of some(["pair", "helical", "bevel", "lost"])) {
  test(`teeth of ${name} touch where the page says, and nowhere run into one another`, () => visit(name, still, async (page) => {
    await nearMesh(page);
    for (const deg of [1, 11, 130]) {
      await driveTo(page, deg);
      const points = await dots(page);
      for (const gear of [".gear.pinion", ".gear.wheel"]) for (const { away } of await placesAt(page, gear, points)) assert.ok(away < 0.5, `${away} pixels from ${gear} at ${deg}°`);
      const deep = await overlap(page);
      assert.ok(deep < 0.5, `${deep} pixels at ${deg}°`);
    }
  }));
}

test("teeth that overlap are seen to", () => visit("overlap", still, async (page) => {
  await nearMesh(page);
  const { width } = await page.locator("#picture").boundingBox();
  await driveTo(page, 8);
  assert.ok(await overlap(page) > 0.005 * width);
  assert.match(await page.locator("#notes").textContent(), /overlap/);
}));

test("the wheel turns by the ratio of teeth, the other way", () => visit("pair", still, async (page) => {
  const angles = async () => [await turned(page, ".gear.pinion"), await turned(page, ".gear.wheel")];
  await driveTo(page, 10);
  const [pinion, wheel] = await angles();
  await driveTo(page, 50);
  const [further, opposite] = await angles();
  assert.ok(Math.abs(wrapped(further - pinion) + 40) < 0.01);
  assert.ok(Math.abs(wrapped(opposite - wheel) - 10) < 0.01);
}));

// 1.691 pairs on average: two over 69.1 % of a pitch of 18°, else one.
test("as many pairs are in contact as the contact ratio says", () => visit("pair", still, async (page) => {
  const mean = await page.locator("#drive").evaluate((input) => {
    let sum = 0;
    for (let i = 0; i < 200; ++i) {
      input.value = (18 * (i + 0.5)) / 200;
      input.dispatchEvent(new Event("input"));
      sum += document.querySelectorAll(".gear-contact:not([hidden])").length;
    }
    return sum / 200;
  });
  assert.ok(Math.abs(mean - 1.691) < 0.0051, String(mean));
}));

test("contact is lost between teeth that are too far apart", () => visit("lost", still, async (page) => {
  await driveTo(page, 16);
  assert.deepEqual(await dots(page), []);
  assert.match(await page.locator("#drive-value").textContent(), /0 pairs/);
  assert.match(await page.locator("#notes").textContent(), /cannot drive continuously/);
  await nearMesh(page);
  assert.ok(await page.locator(".contact-path.lost").isVisible());
}));

for (const name of ["gear", "undercut"]) {
  test(`the rack touches ${name} where it is cut, and cuts nothing of it away`, () => visit(name, still, async (page) => {
    for (const held of ["frame", "gear"]) {
      await page.locator(`[data-held=${held}]`).click();
      let touched = 0;
      for (const deg of [-3, 2]) {
        await driveTo(page, deg);
        const points = await dots(page);
        touched += points.length;
        for (const part of [".gear-outline", ".rack"]) for (const { away } of await placesAt(page, part, points)) assert.ok(away < 0.6, `${away} pixels from ${part} at ${deg}°, ${held}`);
        const deep = await overlap(page, ".gear-outline", ".rack");
        assert.ok(deep < 0.6, `${deep} pixels at ${deg}°`);
      }
      assert.ok(touched >= 4);
    }
  }));
}

for (const name of ["gear", "undercut"]) {
  test(`the tooth of ${name} is as thick over the radius as its facts say of the tip`, { skip: withoutPlots }, () => visit(name, still, async (page) => {
    const facts = await page.locator("#facts-list").textContent();
    const tip = Number(/Tip thickness\s*([\d.]+)/.exec(facts)[1]);
    const [, least] = /From ([\d.]+) to/.exec(await page.locator(".plot").first().textContent());
    assert.ok(Math.abs(Number(least) - tip) < 1e-3 * tip, `${least} for ${tip}`);
  }));
}

test("a gear is cut while the rack rolls", () => visit("gear", still, async (page) => {
  const left = () => page.locator(".rack-cut[hidden]").count();
  assert.ok(await left() > 100);
  await driveTo(page, await page.locator("#drive").evaluate((input) => Number(input.max) * 0.99));
  assert.ok(await left() < 3);
}));

test("the wheel of a worm of two threads turns once in twenty turns", () => visit("worm", still, async (page) => {
  await driveTo(page, 20);
  const before = await turned(page, ".gear.wheel");
  await driveTo(page, 220);
  assert.ok(Math.abs(wrapped((await turned(page, ".gear.wheel")) - before) + 10) < 0.01);
  await nearMesh(page);
  const deep = await overlap(page);
  assert.ok(deep < 0.5, String(deep));
}));

test("gears are turned by hand and by keys, and turn by themselves", () => visit("pair", {}, async (page) => {
  await page.waitForFunction(() => Number(document.getElementById("drive").value) > 1);
  await page.locator("#play").click();
  const stopped = await drive(page);
  await page.locator("#title").click();
  await page.keyboard.press("ArrowRight");
  assert.ok(Math.abs((await drive(page)) - stopped - 0.9) < 1e-6);
  await driveTo(page, 100);
  const box = await page.locator(".world > .handle").first().boundingBox();
  const [x, y, r] = [box.x + box.width / 2, box.y + box.height / 2, 0.3 * box.width];
  await page.mouse.move(x - r, y);
  await page.mouse.down();
  await page.mouse.move(x - r * Math.cos(0.5), y + r * Math.sin(0.5), { steps: 5 });
  await page.mouse.up();
  assert.ok(Math.abs((await drive(page)) - 100 - 0.5 * 180 / Math.PI) < 0.6, String(await drive(page)));
}));

test("another design is chosen", () => visit("search", still, async (page) => {
  const buttons = page.locator("#designs button");
  assert.ok(await buttons.count() > 1);
  const teeth = page.locator("#gears-rows tr").first();
  const before = await teeth.textContent();
  await buttons.nth(1).click();
  assert.notEqual(await teeth.textContent(), before);
  assert.equal(await buttons.nth(1).getAttribute("aria-pressed"), "true");
}));
