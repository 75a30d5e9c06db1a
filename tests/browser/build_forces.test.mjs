// The page of built mechanisms: masses, loads and the speed of its drive, its analysis in a worker, and the fingers on its sheet.
import assert from "node:assert/strict";
import fs from "node:fs";
import { analysed, choose, click, jointsOf, linksOf, moving, pinsAt, saidOf, sheetOf, typedIn, visit } from "./building.mjs";
import { distance, moves } from "./browser.mjs";
import { inTurn as test, some } from "./thinned.mjs";

const LIBRARY = new URL("../../problems/library/analysis/", import.meta.url).pathname;

// Torques and forces of a result by their paths; not residuals, and not where they are.
function forcesOf({ designs: [{ metrics }] }) {
  const flat = (value, path) => (value !== null && typeof value === "object" ? Object.entries(value).flatMap(([key, part]) => flat(part, [...path, key])) : [[path.join("."), value]]);
  return Object.fromEntries(flat(metrics, []).filter(([key, value]) => /torque|reaction|_N\b|power_W|_J\b/.test(key) && !/residual|_deg|_at\b/.test(key) && typeof value === "number"));
}

function assertSame(own, original) {
  for (const [key, value] of Object.entries(original)) assert.ok(Math.abs(own[key] - value) <= 1e-6 * Math.max(1, Math.abs(value)), `${key}: ${own[key]} is not ${value}`);
}

const copied = async (page) => { await page.locator("[data-take=copy_problem]").click(); return page.locator("#taken").inputValue(); };

for (const name of some(["four-bar-forces", "pump-jack", "shaper", "slider-crank-forces", "jaw-crusher", "guide-bar-forces", "toggle-press", "slotter"])) {
  test(`masses, loads and speed of ${name} are those of its file`, () => visit({ problem: `${LIBRARY}${name}.toml` }, async (page) => {
    await moving(page);
    assert.ok(await page.locator("#notes").isHidden());
    const [own, original] = [await analysed(await copied(page)), await analysed(fs.readFileSync(`${LIBRARY}${name}.toml`, "utf8"))].map(forcesOf);
    assert.ok(Object.keys(original).filter((key) => key.startsWith("torque")).length >= 4, Object.keys(original).join());
    assertSame(own, original);
    // The address holds all of it, too.
    await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
      await moving(again);
      assertSame(forcesOf(await analysed(await copied(again))), original);
    });
  }));
}

const torqueOf = async (page) => forcesOf(await analysed(await copied(page)));

test("the torque of masses grows with the square of the drive's speed", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await typedIn(page, "link.L2.mass", "3");
  await moving(page);
  const slow = await torqueOf(page);
  await typedIn(page, "drive.speed", "5");
  await moving(page);
  const fast = await torqueOf(page);
  assert.ok(slow["torque_N_m.abs_max"] > 0 && Math.abs(fast["torque_N_m.abs_max"] / slow["torque_N_m.abs_max"] - 25) < 1e-6, `${fast["torque_N_m.abs_max"]} and ${slow["torque_N_m.abs_max"]}`);
  // A centre of mass at the pin of the crank, without inertia of its own: as a mass at the crank's end.
  const { A, B } = await jointsOf(page);
  for (const [cell, value] of [["centre.x", B.at[0]], ["centre.y", B.at[1]], ["inertia", "0"]]) await typedIn(page, `link.L2.${cell}`, String(value));
  await page.locator("#weighs").check();
  await moving(page);
  const { "torque_N_m.abs_max": torque } = await torqueOf(page), arm = distance(A.at, B.at) / 1000;
  assert.ok(Math.abs(torque - 3 * 9.80665 * arm) < 1e-6 * torque, `${torque} is not ${3 * 9.80665 * arm}`);
  // Emptied, they are those of a mass that is spread evenly again.
  for (const cell of ["centre.x", "inertia"]) await typedIn(page, `link.L2.${cell}`, "");
  assert.equal(await page.locator('[data-cell="link.L2.centre.y"]').inputValue(), "");
}));

test("a click with the tool of loads puts a torque on a link, and it acts when one says", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await choose(page, "load");
  const middle = ["A", "B"], joints = await jointsOf(page), place = [0, 1].map((k) => (joints[middle[0]].at[k] + joints[middle[1]].at[k]) / 2);
  await click(page, place);
  await moving(page);
  assert.equal(await page.locator('[data-cell="load.L1.torque"]').inputValue(), "1");
  // What turns the crank with 1 N m is held by −1 N m.
  assert.ok(Math.abs((await torqueOf(page))["torque_N_m.min"] + 1) < 1e-9);
  await typedIn(page, "load.L1.torque", "-8");
  await page.locator('[data-cell="load.L1.acts"]').selectOption("angles");
  await typedIn(page, "load.L1.when.0", "30");
  await typedIn(page, "load.L1.when.1", "90");
  await moving(page);
  const between = await torqueOf(page);
  assert.ok(Math.abs(between["torque_N_m.max"] - 8) < 1e-9 && Math.abs(between["torque_N_m.min"]) < 1e-9 && Math.abs(between["torque_N_m.rms"] - 8 * Math.sqrt(60 / 360)) < 1e-4, JSON.stringify(between));
  // A crank always advances.
  await page.locator('[data-cell="load.L1.acts"]').selectOption("return L1");
  await moving(page);
  assert.equal((await torqueOf(page))["torque_N_m.abs_max"], 0);
  await page.reload();
  await moving(page);
  assert.equal(await page.locator('[data-cell="load.L1.acts"]').inputValue(), "return L1");
  await typedIn(page, "load.L1.torque", "0");
  assert.equal(await page.locator("#torques-rows tr").count(), 0);
}));

test("a torque is selected by a click on its arc, or by keys; a click with the tool of loads turns it round", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await choose(page, "load");
  const { A, B } = await jointsOf(page), middle = A.at.map((x, k) => (x + B.at[k]) / 2);
  await click(page, middle);
  await moving(page);
  await choose(page, "move");
  // On the arc as it is drawn, where it is farthest from the pins.
  const onArc = async () => page.locator("[data-load=L1] path:last-child").evaluate((arc) => {
    const places = Array.from({ length: 33 }, (_, i) => arc.getPointAtLength((0.02 + 0.02 * i) * arc.getTotalLength()).matrixTransform(arc.getScreenCTM())).map(({ x, y }) => [x, y]);
    const pins = ["A", "B"].map((name) => document.querySelector(`[data-pin=${name}]`).getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]);
    const room = (at) => Math.min(...pins.map((pin) => Math.hypot(at[0] - pin[0], at[1] - pin[1])));
    return places.reduce((best, at) => (room(at) > room(best) ? at : best));
  });
  const isChosen = () => page.locator('[data-part="load.L1"]').evaluate((row) => row.classList.contains("chosen"));
  await page.keyboard.press("Escape");
  assert.equal(await isChosen(), false);
  await page.mouse.click(...await onArc());
  assert.ok(await isChosen());
  // Inside the arc the link is selected.
  await click(page, middle);
  assert.equal(await isChosen(), false);
  assert.ok(await page.locator('[data-row="link.L1"]').evaluate((row) => row.classList.contains("chosen")));
  await choose(page, "load");
  await page.mouse.click(...await onArc());
  await moving(page);
  assert.equal(await page.locator('[data-cell="load.L1.torque"]').inputValue(), "-1");
  // A drag that begins on it makes no force, and with the tool that moves it takes the link along.
  await page.keyboard.press("v");
  const [x, y] = await onArc();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 20, { steps: 3 });
  await page.mouse.up();
  const after = await jointsOf(page);
  assert.ok(distance(after.B.at, B.at) > 1 && await page.locator("#torques-rows tr").count() === 1);
  const handle = page.locator("[data-load-handle=L1]");
  assert.match(await handle.getAttribute("aria-label"), /^Torque on L1/);
  await handle.focus();
  assert.ok(await isChosen());
  await page.keyboard.press("Delete");
  assert.equal(await page.locator("#torques-rows tr").count(), 0);
  assert.ok("L1" in await linksOf(page));
}));

// Workers whose questions wait until the page is told to go on, and are counted; and how many of them have been ended.
const held = () => {
  const post = Worker.prototype.postMessage, end = Worker.prototype.terminate;
  const waiting = [];
  Object.assign(window, { asked: 0, ended: 0, isHeld: false, goOn: () => { window.isHeld = false; for (const one of waiting.splice(0)) one(); } });
  Worker.prototype.postMessage = function postMessage(data) {
    const go = () => post.call(this, data);
    if (data.problem) window.asked += 1;
    if (data.problem && window.isHeld) waiting.push(go); else go();
  };
  Worker.prototype.terminate = function terminate() { window.ended += 1; end.call(this); };
};

test("while a mechanism is analysed it moves, and the next edit ends the analysis", () => visit({ motion: "no-preference", prepare: (page) => page.addInitScript(held) }, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  const counts = () => page.evaluate(() => [window.asked, window.ended]), [asked, ended] = await counts();
  const facts = await page.locator("#facts-list").innerText();
  await page.evaluate(() => { window.isHeld = true; });
  await typedIn(page, "joint.C.y", "22");
  await page.waitForFunction((n) => window.asked > n, asked);
  await moves(page, "[data-pin=B]");
  await moves(page, "[data-pin=P]");
  // What was measured before is dimmed.
  assert.equal(await page.locator("#facts.waits[aria-busy=true]").count(), 1);
  assert.equal(await page.locator("#facts-list").innerText(), facts);
  assert.equal(await page.locator("#state[aria-busy=true]").count(), 1);
  await typedIn(page, "joint.C.y", "25");
  await page.waitForFunction((n) => window.asked > n, asked + 1);
  assert.deepEqual(await counts(), [asked + 2, ended + 1]);
  const before = Number(await page.locator("#drive").inputValue());
  await page.evaluate(() => window.goOn());
  await moving(page);
  assert.equal(await page.locator(".waits").count(), 0);
  assert.notEqual(await page.locator("#facts-list").innerText(), facts);
  // It goes on from where it was, not from the beginning.
  assert.ok(Number.isFinite(before) && (await jointsOf(page)).C.at[1] === 25);
}));

async function fingers(page) {
  const session = await page.context().newCDPSession(page);
  return (type, places) => session.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
}

const pinPixels = (page, name) => page.locator(`[data-pin="${name}"]`).evaluate((pin) => ["cx", "cy"].map((key) => Number(pin.getAttribute(key))));
const frames = (page) => page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));

test("two fingers zoom and move the view, and build nothing", () => visit({ size: "phone" }, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await pinsAt(page, (await page.locator("#drive").evaluate(({ min }) => Number(min))), []);
  await choose(page, "link");
  const { at } = await sheetOf(page), touch = await fingers(page), [mx, my] = at([0, 0]), before = await jointsOf(page);
  const [a, d] = [await pinPixels(page, "A"), await pinPixels(page, "D")];
  await touch("touchStart", [[mx - 40, my]]);
  await touch("touchMove", [[mx - 40, my + 8]]);
  await touch("touchStart", [[mx - 40, my + 8], [mx + 40, my]]);
  for (let i = 1; i <= 8; ++i) await touch("touchMove", [[mx - 40 - 5 * i, my + 8], [mx + 40 + 5 * i, my]]);
  await touch("touchEnd", []);
  await frames(page);
  const [a2, d2] = [await pinPixels(page, "A"), await pinPixels(page, "D")], ratio = distance(a2, d2) / distance(a, d);
  const wanted = Math.hypot(160, 8) / Math.hypot(80, 8);
  assert.ok(Math.abs(ratio - wanted) < 0.02, `${ratio} is not ${wanted}`);
  // Both fingers by the same way: the view moves with them.
  await touch("touchStart", [[mx - 40, my], [mx + 40, my]]);
  for (let i = 1; i <= 6; ++i) await touch("touchMove", [[mx - 40 + 5 * i, my - 4 * i], [mx + 40 + 5 * i, my - 4 * i]]);
  await touch("touchEnd", []);
  await frames(page);
  const a3 = await pinPixels(page, "A"), way = a3.map((x, k) => x - a2[k]);
  assert.ok(Math.abs(way[0] - 30) < 1 && Math.abs(way[1] + 24) < 1, `by ${way}`);
  assert.deepEqual(await jointsOf(page), before);
  // One finger builds again.
  await choose(page, "pivot");
  const [bx, by] = await pinPixels(page, "B"), { x, y } = await page.locator("#picture").boundingBox();
  await page.touchscreen.tap(x + bx, y + by);
  assert.ok((await jointsOf(page)).B.fixed);
}));

test("the wheel with Ctrl zooms about the pointer", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  const { at } = await sheetOf(page), [c, d] = [await pinPixels(page, "A"), await pinPixels(page, "D")];
  await page.mouse.move(...at([-25, -15]));
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -200);
  await page.keyboard.up("Control");
  await frames(page);
  const [c2, d2] = [await pinPixels(page, "A"), await pinPixels(page, "D")];
  assert.ok(distance(c2, d2) > 1.2 * distance(c, d) && distance(c, c2) < 1);
}));

test("a field of a number that is emptied keeps its number and says so", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  for (const cell of ["joint.B.x", "drive.speed", "link.L2.mass"]) {
    const value = await page.locator(`[data-cell="${cell}"]`).inputValue();
    await typedIn(page, cell, "");
    assert.equal(await saidOf(page), "This field takes a number; what was there stays.", cell);
    assert.equal(await page.locator(`[data-cell="${cell}"]`).inputValue(), value);
  }
}));

for (const problem of ["pump-jack", "shaper"]) {
  test(`at 360 pixels no field of ${problem} is clipped`, () => visit({ problem: `${LIBRARY}${problem}.toml`, size: "phone" }, async (page) => {
    await page.setViewportSize({ width: 360, height: 740 });
    await moving(page);
    const clipped = await page.locator("#lists input:not([type=checkbox], [type=radio])").evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => `${one.dataset.cell} ${one.value || one.placeholder}`));
    assert.deepEqual(clipped, []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }));
}
