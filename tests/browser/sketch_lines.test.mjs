// The page of `cognate sketch`: a straight line is drawn, and four-bars go along it.
import assert from "node:assert/strict";
import { assertFits } from "./browser.mjs";
import { rarely as test, some } from "./thinned.mjs";
import { couplerPose, leastTransmission } from "./closures.mjs";
import { addressOf, answered, draw, facts, offered, settled, targets, visit } from "./sketching.mjs";

const RADIANS = Math.PI / 180, FINE = 3600;
const rule = (t) => [0.35 + 0.3 * t, 0.5 - 0.12 * t + 0.03 * Math.sin(9 * t)];
const straight = [0, 1];

// Where the point of the design goes along the line from its first end, and how far it is from it, over the crank's angles of the address.
function onLine({ points: [p, q], cranks, ...bar }) {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]), e = [(q[0] - p[0]) / length, (q[1] - p[1]) / length], [from, to] = [cranks[0], cranks.at(-1)];
  const places = Array.from({ length: FINE + 1 }, (_, i) => couplerPose(bar, (from + ((to - from) * i) / FINE) * RADIANS).at).map((at) => [at[0] - p[0], at[1] - p[1]]);
  const along = places.map(([x, y]) => x * e[0] + y * e[1]), across = places.map(([x, y]) => Math.abs(y * e[0] - x * e[1]));
  return { length, from: Math.min(...along), to: Math.max(...along), far: Math.max(...across) };
}

function assertOnLine(design) {
  const { length, from, to, far } = onLine(design);
  assert.ok(Math.abs(from) < 1e-4 && Math.abs(to - length) < 1e-4, `${from} to ${to} of ${length}`);
  assert.ok(Math.abs(far - design.rms) <= 0.01 * design.rms + 1e-8, `${far} against ${design.rms}`);
}

const rulesA = async (page) => { await page.locator("#of-line").click(); await draw(page, rule, straight); };

test("of a stroke its ends count, and designs go from one to the other as straight as is said, with their files", () => visit({}, async (page) => {
  await rulesA(page);
  await settled(page);
  assert.equal(await targets(page), 2);
  const design = addressOf(page), [deviation] = await facts(page, "rms"), [least] = await facts(page, "least"), [turned] = await facts(page, "turn");
  assertOnLine(design);
  assert.ok(Math.abs(deviation - design.rms) < 1e-9 && deviation < 0.05);
  assert.ok(least >= 30 - 1e-6 && Math.abs(leastTransmission(design, [design.cranks[0], design.cranks.at(-1)]) - least) < 0.01);
  assert.ok(Math.abs(turned - (design.cranks.at(-1) - design.cranks[0])) < 1e-6);
  assert.ok(await page.locator("#region").isVisible() && !await page.locator("#obstacle").isVisible() && !await page.locator("#closed").isVisible() && !await page.locator("#by-slider").isVisible());
  await page.locator("[data-take=copy_problem]").click();
  const file = await page.locator("#taken").inputValue();
  assert.match(file, /kind = "straight-line"/);
  const { status, designs: [best] } = await answered("solve", file.replace(/starts = \d+/, "starts = 40"));
  assert.equal(status, "solved");
  assert.ok(deviation <= 3 * best.metrics.deviation && Math.abs(best.metrics.straight_length - onLine(design).length) < 1e-4, `${deviation} against ${best.metrics.deviation}`);
  await page.locator("[data-take=copy_design]").click();
  assert.equal((await answered("analyze", await page.locator("#taken").inputValue())).designs.length, 1);
}));

test("by keys a line has two ends; a third click begins anew, and all is undone", () => visit({}, async (page) => {
  for (let i = 0; i < 3; ++i) await page.keyboard.press("p");
  assert.equal(await page.locator("#of-line").getAttribute("aria-pressed"), "true");
  await page.locator("#sheet").focus();
  await page.keyboard.press("Enter");
  assert.match(await page.locator("#state").textContent(), /other end/);
  // The same place once more is no line.
  await page.keyboard.press("Enter");
  assert.equal(await targets(page), 1);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Enter");
  await offered(page);
  const first = addressOf(page).points;
  assert.equal(first.length, 2);
  await page.keyboard.press("Enter");
  assert.equal(await targets(page), 1);
  await page.keyboard.press("Control+z");
  await offered(page);
  assert.deepEqual(addressOf(page).points, first);
  assertOnLine(addressOf(page));
}));

test("while an end is dragged the same designs follow", () => visit({}, async (page) => {
  await rulesA(page);
  await settled(page);
  const before = addressOf(page), [error] = await facts(page, "rms"), at = await page.locator('[data-target="1"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y + 90, { steps: 3 });
  const [followed] = await facts(page, "rms");
  assert.notEqual(followed, error);
  await page.mouse.up();
  await offered(page);
  const after = addressOf(page), length = ({ points: [p, q] }) => Math.hypot(q[0] - p[0], q[1] - p[1]);
  assert.ok(Math.abs(followed / error - length(after) / length(before)) < 1e-6);
  assertOnLine(after);
  assert.ok(after.rms <= followed * (1 + 1e-3));
}));

test("the speed along the line varies within its limit, which the address and the file hold", () => visit({}, async (page) => {
  await rulesA(page);
  await page.locator("#even").evaluate((slider) => { slider.value = 30; for (const name of ["input", "change"]) slider.dispatchEvent(new Event(name)); });
  await settled(page);
  const speeds = await facts(page, "speed"), design = addressOf(page);
  assert.ok(speeds.length > 0 && speeds.every((one) => one <= 0.3 + 1e-6), `${speeds}`);
  // The same of the positions alone: of equal steps of the crank those along the line.
  const [from, to] = [design.cranks[0], design.cranks.at(-1)], places = Array.from({ length: FINE + 1 }, (_, i) => couplerPose(design, (from + ((to - from) * i) / FINE) * RADIANS).at);
  const [p, q] = design.points, length = Math.hypot(q[0] - p[0], q[1] - p[1]), along = places.map(([x, y]) => ((x - p[0]) * (q[0] - p[0]) + (y - p[1]) * (q[1] - p[1])) / length);
  const steps = along.slice(1).map((at, i) => Math.abs(at - along[i])), mean = Math.abs(along.at(-1) - along[0]) / FINE, variation = (Math.max(...steps) - Math.min(...steps)) / mean;
  assert.ok(variation <= 0.3 + 1e-3 && speeds.some((one) => Math.abs(one - variation) < 1e-3), `${variation} of ${speeds}`);
  await page.locator("[data-take=copy_problem]").click();
  assert.match(await page.locator("#taken").inputValue(), /speed_variation_max = 0\.3/);
  await page.reload();
  assert.equal(await page.locator("#even").inputValue(), "30");
  await page.locator("#of-curve").click();
  assert.equal(await page.locator("#even").isVisible(), false);
}));

// Draws a box by shares of the picture.
async function box(page, from, to) {
  const { x, y, width, height } = await page.locator("#sheet").boundingBox(), at = ([u, v]) => [x + u * width, y + v * height];
  await page.locator("#region").click();
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at(to), { steps: 4 });
  await page.mouse.up();
}

const regionOf = (page) => page.url().match(/&b=([^&]+)/)[1].split(",").map(Number);

function assertInside(pivots, [x0, y0, x1, y1]) {
  for (const [x, y] of pivots) assert.ok(x >= x0 - 1e-5 && x <= x1 + 1e-5 && y >= y0 - 1e-5 && y <= y1 + 1e-5, `${[x, y]} in ${[x0, y0, x1, y1]}`);
}

// A design of a result as one of the address, for a line.
const asDrawn = ({ mechanism: { fixed_pivots: [a, d], crank, coupler, rocker, coupler_point: [u, v], assembly }, metrics }, points) =>
  ({ points, a, d, crank, coupler, rocker, u, v, side: assembly === "crossed" ? -1 : 1, rms: metrics.deviation, cranks: [metrics.crank_from_deg, metrics.crank_to_deg] });

// Above the line, and below it.
for (const [name, from, to] of [["above", [0.3, 0.05], [0.75, 0.4]], ["below", [0.3, 0.55], [0.75, 0.95]]]) {
  test(`fixed pivots stand in a box ${name} the line, also those of the file`, () => visit({}, async (page) => {
    await rulesA(page);
    await offered(page);
    await box(page, from, to);
    await settled(page);
    const region = regionOf(page), design = addressOf(page);
    assertInside([design.a, design.d], region);
    assertOnLine(design);
    await page.locator("[data-take=copy_problem]").click();
    const file = await page.locator("#taken").inputValue();
    assert.match(file, /ends = \[\[/);
    assert.match(file, /pivot_region = \[\[/);
    const { status, designs: [best] } = await answered("solve", file.replace(/starts = \d+/, "starts = 120")), own = asDrawn(best, design.points);
    assert.equal(status, "solved");
    assertInside([own.a, own.d], region);
    assertOnLine(own);
    assert.ok(design.rms <= 2 * own.rms && own.rms <= 2 * design.rms, `${design.rms} against ${own.rms}`);
    // A step back takes the box away; the address brings it back.
    const kept = page.url().split("#")[1];
    await page.locator("#undo").click();
    assert.ok(!page.url().includes("&b="));
    await visit({ hash: `#${kept}` }, async (again) => {
      await offered(again);
      assert.deepEqual(regionOf(again), region);
      assertInside([addressOf(again).a, addressOf(again).d], region);
    });
  }));
}

test("an end that is dragged beside a box is searched for anew, and the pivots stay in it", () => visit({}, async (page) => {
  await rulesA(page);
  await box(page, [0.3, 0.55], [0.75, 0.95]);
  await settled(page);
  const at = await page.locator('[data-target="1"]').boundingBox();
  await page.mouse.move(at.x + at.width / 2, at.y + at.height / 2);
  await page.mouse.down();
  await page.mouse.move(at.x + 40, at.y - 30, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const design = addressOf(page);
  assertOnLine(design);
  assertInside([design.a, design.d], regionOf(page));
  // A curve keeps the box, a line drawn after it too; no box is kept clear beside lines.
  const region = regionOf(page);
  for (const id of ["of-curve", "of-line"]) await page.locator(`#${id}`).click();
  await rulesA(page);
  await offered(page);
  assert.deepEqual(regionOf(page), region);
  await page.keyboard.press("o");
  assert.equal(await page.locator("#obstacle").getAttribute("aria-pressed"), "false");
}));

test("the address holds line and design", () => visit({}, async (page) => {
  await rulesA(page);
  await page.locator("#class").selectOption("crank-rocker");
  await settled(page);
  const kept = addressOf(page);
  assert.deepEqual([...new Set(await facts(page, "class"))], ["crank-rocker"]);
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    assert.equal(await again.locator("#of-line").getAttribute("aria-pressed"), "true");
    const [error] = await facts(again, "rms");
    assert.ok(Math.abs(error - kept.rms) < 1e-6 * kept.rms, `${error} against ${kept.rms}`);
    await settled(again);
    assert.deepEqual(addressOf(again).points, kept.points);
    assertOnLine(addressOf(again));
  });
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "phone", locale: "zh-CN" }, { size: "laptop" }])) {
  test(`lines fit: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await rulesA(page);
    await page.waitForFunction(() => document.querySelector("[data-fact=turn]"));
    await assertFits(page);
  }));
}
