// The page of a cam as a reader meets it: in Chromium, from disk, at desktop and phone width.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { assertFits, assertInked, launch, LOOKS, visit as visitReport } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const ROLLERS = ["translating-roller", "oscillating-roller", "groove", "conjugate"];
const NAMES = [...ROLLERS, "translating-flat", "translating-knife", "oscillating-flat", "oscillating-knife", "constant-breadth"];
const still = { motion: "reduce" };
let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());
const visit = (name, options, steps) => visitReport(browser, `cam-${name}`, options, steps);

const driveTo = (page, value) => page.locator("#drive").evaluate((input, v) => { input.value = v; input.dispatchEvent(new Event("input")); }, value);
const drive = (page) => page.locator("#drive").evaluate((input) => Number(input.value));

// The angle on the screen, clockwise in degrees, by which the element that `selector` names is turned.
const turned = (page, selector) => page.locator(selector).first().evaluate((part) => {
  const { a, b } = part.getScreenCTM();
  return (Math.atan2(b, a) * 180) / Math.PI;
});
const wrapped = (deg) => deg - 360 * Math.round(deg / 360);

// Pixels between the drawn profile and the middle of the first roller, less the roller's radius.
const gap = (page) => page.evaluate(() => {
  const profile = document.querySelector(".slot") ?? document.querySelector(".cam.first");
  const circle = document.querySelector(".roller circle");
  const at = (part, x, y) => new DOMPoint(x, y).matrixTransform(part.getScreenCTM());
  const middle = at(circle, 0, 0);
  const scale = Math.hypot(circle.getScreenCTM().a, circle.getScreenCTM().b);
  const length = profile.getTotalLength();
  let least = Infinity;
  for (let i = 0; i <= 1500; ++i) {
    const p = profile.getPointAtLength((length * i) / 1500);
    const q = at(profile, p.x, p.y);
    least = Math.min(least, Math.hypot(q.x - middle.x, q.y - middle.y));
  }
  return least - scale * Number(circle.getAttribute("r"));
});

for (const { size, scheme } of LOOKS) {
  for (const name of some(size === "desktop" ? NAMES : ["translating-roller", "oscillating-flat", "conjugate"])) {
    test(`${name} fits a ${size} in ${scheme} colours, with all that it can show`, () => visit(name, { size, scheme, ...still }, async (page) => {
      await assertFits(page);
      await page.locator('[data-layer][aria-pressed="false"]:visible').evaluateAll((buttons) => buttons.forEach((button) => button.click()));
      for (const deg of [0, 75, 180, 300]) await driveTo(page, deg);
      await assertFits(page);
      assert.doesNotMatch(await page.locator("#picture").innerHTML(), /NaN|undefined|Infinity/);
      await assertInked(page);
    }));
  }
}

for (const name of some(ROLLERS)) {
  test(`the roller of ${name} touches the cam wherever it stands`, () => visit(name, still, async (page) => {
    for (const held of ["frame", "cam"]) {
      await page.locator(`[data-held=${held}]`).click();
      for (const deg of [0, 50, 98, 240]) {
        await driveTo(page, deg);
        const left = await gap(page);
        assert.ok(Math.abs(left) < 0.6, `${left} pixels at ${deg}°, the ${held} held`);
      }
    }
  }));
}

test("the edge on the arm touches the cam wherever it stands", () => visit("oscillating-knife", still, async (page) => {
  for (const held of ["frame", "cam"]) {
    await page.locator(`[data-held=${held}]`).click();
    for (const deg of [0, 50, 98, 240]) {
      await driveTo(page, deg);
      const left = await page.evaluate(() => {
        const at = (part, p) => new DOMPoint(p.x, p.y).matrixTransform(part.getScreenCTM());
        const [profile, edge] = [document.querySelector(".cam.first"), document.querySelector(".edge")];
        const tip = at(edge, edge.getPointAtLength(0));
        const length = profile.getTotalLength();
        let least = Infinity;
        for (let i = 0; i <= 1500; ++i) {
          const q = at(profile, profile.getPointAtLength((length * i) / 1500));
          least = Math.min(least, Math.hypot(q.x - tip.x, q.y - tip.y));
        }
        return least;
      });
      assert.ok(left < 0.8, `${left} pixels at ${deg}°, the ${held} held`);
    }
  }
}));

test("the wedge is as wide as the pressure angle", () => visit("translating-roller", still, async (page) => {
  await driveTo(page, 50);
  const angle = await page.locator(".wedge").first().evaluate((part) => {
    const [x0, y0, x1, y1, ...rest] = part.getAttribute("d").match(/-?[\d.]+/g).map(Number);
    const [x2, y2] = rest.slice(-2);
    return ((Math.atan2(y1 - y0, x1 - x0) - Math.atan2(y2 - y0, x2 - x0)) * 180) / Math.PI;
  });
  assert.ok(Math.abs(Math.abs(angle) - 38.71) < 0.1, String(angle));
  assert.match(await page.locator(".angle-name").textContent(), /38\.7°/);
  assert.ok(await page.locator(".wedge.missed").count() > 0);
}));

// In the lower dwell the profile is an arc of radius 30 about the shaft, and the roller's is 10.
test("the roller rolls without sliding", () => visit("translating-roller", still, async (page) => {
  await driveTo(page, 270);
  const before = await turned(page, ".roller");
  await driveTo(page, 290);
  assert.ok(Math.abs(wrapped((await turned(page, ".roller")) - before) - 60) < 0.5);
}));

test("a cam turns the way its problem says", async () => {
  for (const [name, sense] of [["translating-roller", -1], ["groove", 1]]) {
    await visit(name, still, async (page) => {
      await driveTo(page, 40);
      const before = await turned(page, ".cam-body");
      await driveTo(page, 70);
      assert.ok(Math.abs(wrapped((await turned(page, ".cam-body")) - before) - 30 * sense) < 0.1);
    });
  }
});

test("a cam that is held stands still, and the follower goes round it", () => visit("oscillating-flat", still, async (page) => {
  await page.locator("[data-held=cam]").click();
  const before = await turned(page, ".cam-body");
  await driveTo(page, 120);
  assert.ok(Math.abs(wrapped((await turned(page, ".cam-body")) - before)) < 0.01);
}));

test("the cam can be turned by hand", () => visit("translating-flat", still, async (page) => {
  const box = await page.locator(".world > .handle").boundingBox();
  const [x, y, r] = [box.x + box.width / 2, box.y + box.height / 2, 0.3 * box.width];
  await page.mouse.move(x + r, y);
  await page.mouse.down();
  await page.mouse.move(x + r * Math.cos(0.4), y - r * Math.sin(0.4), { steps: 4 });
  await page.mouse.move(x + r * Math.cos(1), y - r * Math.sin(1), { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await drive(page)) - 180 / Math.PI) < 0.5, String(await drive(page)));
}));

test("the cam turns by itself, stops, and is moved by keys", () => visit("conjugate", {}, async (page) => {
  await page.waitForFunction(() => Number(document.getElementById("drive").value) > 3);
  await page.locator("#play").click();
  const stopped = await drive(page);
  await page.waitForTimeout(300);
  assert.equal(await drive(page), stopped);
  await page.locator("#title").click();
  await page.keyboard.press("Shift+ArrowRight");
  assert.ok(Math.abs((await drive(page)) - stopped - 10) < 1e-6);
}));

test("a segment's button goes to its beginning", () => visit("translating-roller", still, async (page) => {
  await page.locator("#segments-rows button", { hasText: "Harmonic" }).click();
  assert.equal(await drive(page), 160);
  assert.match(await page.locator("#segments-rows").textContent(), /acceleration jumps from 0 to −120/);
}));

test("another design is chosen, and derivatives are shown by time", () => visit("translating-roller", still, async (page) => {
  await page.locator("#designs button").nth(1).click();
  assert.match(await page.locator("#dimensions-list").textContent(), /Prime-circle radius70Base-circle radius60/);
  const speed = page.locator("#values-rows tr", { hasText: "Velocity" }).locator("td").nth(4);
  const byAngle = Number(await speed.textContent());
  await page.locator("[data-rate=time]").click();
  assert.ok(Math.abs(Number(await speed.textContent()) - 30 * byAngle) < 0.1);
}));
