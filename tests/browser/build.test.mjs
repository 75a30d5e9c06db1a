// The page of `cognate sketch --mechanism`: links, pivots, sliders and forces put by hand make a mechanism that moves.
import assert from "node:assert/strict";
import fs from "node:fs";
import { analysed, choose, click, drag, drawLinks, driveOf, factsOf, file, fix, jointsOf, linksOf, moving, pinsAt, saidOf, sheetOf, typedIn, visit } from "./building.mjs";
import { assertFits, distance, goesToAndFro, moves } from "./browser.mjs";
import { seldom as test, some } from "./thinned.mjs";
import { couplerPose } from "./closures.mjs";
import { gapOf } from "./rigidity.mjs";

const RADIANS = Math.PI / 180;
const NEAR = 0.02;   // mm: pins are drawn to a hundredth of a pixel, and between samples they are interpolated

// A crank-rocker as a hand draws it, its coupler point last.
const CRANK_ROCKER = { links: [[[-30, -20], [-22, -8]], [[-22, -8], [20, 20]], [[20, 20], [24, -20]]], pivots: [[-30, -20], [24, -20]], point: [-6, 28] };

async function buildFourBar(page) {
  await drawLinks(page, CRANK_ROCKER.links);
  await fix(page, CRANK_ROCKER.pivots);
  await choose(page, "point");
  await drag(page, [-1, 6], CRANK_ROCKER.point);
  await moving(page);
}

// The linkage by its joints, as closures.mjs has it, from P in the coupler's axes.
function barOf({ A, B, C, D, E }) {
  const [a, b, c, d, p] = [A, B, C, D, E].map(({ at }) => at), coupler = distance(b, c), e = c.map((x, k) => (x - b[k]) / coupler), w = p.map((x, k) => x - b[k]);
  const side = Math.sign((d[0] - b[0]) * (c[1] - b[1]) - (d[1] - b[1]) * (c[0] - b[0]));
  return { a, d, crank: distance(a, b), coupler, rocker: distance(c, d), u: e[0] * w[0] + e[1] * w[1], v: e[0] * w[1] - e[1] * w[0], side };
}

// Where circles about p and q meet, on the side on which `near` is.
function meeting(p, q, r, s, near) {
  const base = distance(p, q), along = (r * r - s * s + base * base) / (2 * base), height = Math.sqrt(r * r - along * along), e = q.map((x, k) => (x - p[k]) / base);
  const side = Math.sign(e[0] * (near[1] - p[1]) - e[1] * (near[0] - p[0]));
  return [p[0] + along * e[0] - side * height * e[1], p[1] + along * e[1] + side * height * e[0]];
}

const assertNear = (p, q, what) => assert.ok(distance(p, q) < NEAR, `${what}: ${p} is not ${q}`);

test("a quick return is built by a block that slides on a bar", () => visit({}, async (page) => {
  await drawLinks(page, [[[0, 0], [0, 12]], [[0, -32], [2, 26]]]);
  await fix(page, [[0, 0], [0, -32]]);
  await choose(page, "slider");
  await drag(page, [0, 12], [0.7, -10]);
  await drawLinks(page, [[[0, 26], [32, 30]]]);
  await choose(page, "slider");
  await drag(page, [32, 30], [50, 30]);
  await moving(page);
  const joints = await jointsOf(page), { C, D, E } = joints, [length, rod] = [distance(C.at, D.at), distance(D.at, E.at)], [from] = await driveOf(page);
  assert.equal(await page.locator("#sliders-rows tr").count(), 2);
  for (let drive = from; drive < from + 360; drive += 29) {
    const [b, d, e] = await pinsAt(page, drive, ["B", "D", "E"]), angle = drive * RADIANS;
    assertNear(b, [12 * Math.cos(angle), 12 * Math.sin(angle)], "B");
    const bar = Math.atan2(12 * Math.sin(angle) + 32, 12 * Math.cos(angle)), tip = [length * Math.cos(bar), length * Math.sin(bar) - 32];
    assertNear(d, tip, `D at ${drive}`);
    assertNear(e, [tip[0] + Math.sqrt(rod * rod - (30 - tip[1]) ** 2), 30], `E at ${drive}`);
  }
}));

test("a four-bar is built with the mouse, and its point traces the curve of that linkage", () => visit({}, async (page) => {
  assert.ok(fs.statSync(file).size < 2e6);
  assert.equal(await saidOf(page), "Draw a first link.");
  await buildFourBar(page);
  const joints = await jointsOf(page), bar = barOf(joints);
  assert.deepEqual(Object.keys(joints), ["A", "B", "C", "D", "E"]);
  assert.deepEqual(joints.A, { at: [-30, -20], fixed: true });
  assert.deepEqual(await linksOf(page), { L1: "A–B", L2: "B–C–E", L3: "C–D" });
  assert.equal(await saidOf(page), "Mobility 1: the drive turns fully.");
  const [from, to] = await driveOf(page);
  assert.ok(Math.abs(to - from - 360) < 1e-9 && Math.abs(from - Math.atan2(12, 8) / RADIANS) < 1e-9);
  for (let i = 0; i < 24; ++i) {
    const drive = from + 15.2 * i, [point] = await pinsAt(page, drive, ["E"]);
    assertNear(point, couplerPose(bar, drive * RADIANS).at, `P at ${drive}`);
  }
  const { plane } = await sheetOf(page);
  const path = (await page.locator("[data-path=E]").getAttribute("d")).match(/[\d.]+ [\d.]+/g).map((pair) => plane(pair.split(" ").map(Number)));
  assert.ok(path.length > 300);
  path.forEach((p, i) => { if (i % 17 === 0) assertNear(p, couplerPose(bar, (from + (360 * i) / (path.length - 1)) * RADIANS).at, `sample ${i}`); });
}));

test("a slider-crank is built by a slider in the direction of the drag", () => visit({}, async (page) => {
  await drawLinks(page, [[[-40, 0], [-32, 12]], [[-32, 12], [14, 6]]]);
  await fix(page, [[-40, 0]]);
  assert.match(await saidOf(page), /^Mobility 2/);
  await choose(page, "slider");
  await drag(page, [14, 6], [40, 7]);
  await moving(page);
  const { A, B, C } = await jointsOf(page), [r, l] = [distance(A.at, B.at), distance(B.at, C.at)], [from] = await driveOf(page);
  for (let drive = from; drive < from + 360; drive += 31) {
    const [x, y] = [r * Math.cos(drive * RADIANS) - 40, r * Math.sin(drive * RADIANS)];
    assertNear((await pinsAt(page, drive, ["C"]))[0], [x + Math.sqrt(l * l - (y - 6) ** 2), 6], `C at ${drive}`);
  }
  // A click with the same tool takes it away, and the mobility comes back.
  await pinsAt(page, from, []);
  await click(page, [14, 6]);
  assert.match(await saidOf(page), /^Mobility 2/);
}));

test("a six-bar has a ternary link where a link begins on another", () => visit({}, async (page) => {
  await buildFourBar(page);
  await drawLinks(page, [[[22, 0], [44, 10]], [[44, 10], [46, -20]]]);
  await fix(page, [[46, -20]]);
  await moving(page);
  const links = await linksOf(page), joints = await jointsOf(page), [from] = await driveOf(page);
  assert.equal(links.L3, "C–D–F");
  const bar = barOf(joints), { C, D, F, G, H } = joints;
  for (let drive = from; drive < from + 360; drive += 37) {
    const [b, c] = [couplerPose({ ...bar, u: 0, v: 0 }, drive * RADIANS).at, couplerPose({ ...bar, u: bar.coupler, v: 0 }, drive * RADIANS).at];
    const [pin, f, g] = await pinsAt(page, drive, ["C", "F", "G"]);
    assert.ok(distance(b, c) > 0);
    assertNear(pin, c, "C");
    const share = distance(D.at, F.at) / distance(D.at, C.at), on = D.at.map((x, k) => x + share * (c[k] - x));
    assertNear(f, on, `F at ${drive}`);
    assertNear(g, meeting(on, H.at, distance(F.at, G.at), distance(G.at, H.at), g), `G at ${drive}`);
  }
}));

test("a rocker goes to and fro within its range about the position drawn", () => visit({ motion: "no-preference" }, async (page) => {
  await drawLinks(page, [[[-20, -20], [-20, 10]], [[-20, 10], [10, 12]], [[10, 12], [20, -20]]]);
  await fix(page, [[-20, -20], [20, -20]]);
  await moving(page);
  const { A, B, C, D } = await jointsOf(page), [from, to] = await driveOf(page);
  // At the ends coupler and rocker are in one line.
  const [base, crank, reach] = [distance(A.at, D.at), distance(A.at, B.at), distance(B.at, C.at) + distance(C.at, D.at)];
  const limit = Math.acos((base ** 2 + crank ** 2 - reach ** 2) / (2 * base * crank)) / RADIANS;
  assert.ok(Math.abs(to - limit) < 0.01 && from < 90 && to > 90, `${from} to ${to}, not ${limit}`);
  assert.match(await saidOf(page), /to and fro between/);
  await page.locator("#speed").fill("3");
  await goesToAndFro(page, "#drive");
}));

test("a slider drives over the way that the links allow", () => visit({}, async (page) => {
  await page.locator("[data-example=slider_crank]").click();
  await moving(page);
  await page.locator('[data-cell="link.S1.drives"]').check();
  await page.waitForFunction(() => document.getElementById("state").textContent.includes("slider goes"));
  const { A, B, C } = await jointsOf(page), [r, l] = [distance(A.at, B.at), distance(B.at, C.at)], [from, to] = await driveOf(page);
  assert.ok(Math.abs(from - (l - r - (C.at[0] - A.at[0]))) < 0.01 && Math.abs(to - (l + r - (C.at[0] - A.at[0]))) < 0.01, `${from} to ${to}`);
  for (let i = 1; i < 10; ++i) {
    const way = from + (i * (to - from)) / 10, [b, c] = await pinsAt(page, way, ["B", "C"]);
    assertNear(c, [C.at[0] + way, C.at[1]], "C");
    assertNear(b, meeting(A.at, c, r, l, B.at), `B at ${way}`);
  }
  await assertSameFacts(page);
}));

test("by Tab one goes on from a field that was changed", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await page.locator('[data-cell="joint.B.x"]').focus();
  for (const key of ["Control+a", "-", "1", "6", "Tab", "Control+a", "-", "4", "Tab"]) await page.keyboard.press(key);
  assert.deepEqual((await jointsOf(page)).B.at, [-16, -4]);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.cell), "joint.B.fixed");
  await page.locator('[data-cell="joint.B.name"]').fill("crank.pin");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.activeElement.dataset.cell === "joint.crank.pin.name");
}));

test("arrows move what is selected", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await click(page, [20, 18]);
  for (const key of ["ArrowUp", "Shift+ArrowLeft"]) await page.keyboard.press(key);
  assert.deepEqual((await jointsOf(page)).C.at, [15, 19]);
  await moving(page);
  // A link goes with its joints.
  await page.locator('[data-cell="link.L3.name"]').focus();
  await page.locator("#sheet").focus();
  await page.keyboard.press("ArrowRight");
  const { C, D } = await jointsOf(page);
  assert.deepEqual([C.at, D.at], [[16, 19], [23, -15]]);
  // With nothing selected the cross moves.
  await page.keyboard.press("Escape");
  await page.keyboard.press("ArrowRight");
  assert.deepEqual((await jointsOf(page)).C.at, [16, 19]);
  assert.ok(await page.locator(".sketch-cross").isVisible());
}));

test("what has begun is cancelled by Escape", () => visit({}, async (page) => {
  await choose(page, "link");
  await click(page, [-30, 0]);
  await page.keyboard.press("Escape");
  await click(page, [20, 0]);
  await click(page, [20, 20]);
  const joints = await jointsOf(page);
  assert.deepEqual(Object.values(joints).map(({ at }) => at), [[20, 0], [20, 20]]);
}));

test("joints are dragged, joined and removed, and every step is undone and made again", () => visit({}, async (page) => {
  await buildFourBar(page);
  const before = await jointsOf(page);
  await choose(page, "move");
  await drag(page, [20, 20], [14, 26]);
  assert.deepEqual((await jointsOf(page)).C.at, [14, 26]);
  await moving(page);
  // A link that is let go on a pin joins it.
  await drawLinks(page, [[[40, 30], [50, 10]]]);
  assert.match(await saidOf(page), /L4 is not joined/);
  await choose(page, "move");
  await drag(page, [40, 30], [14, 26]);
  assert.deepEqual(await linksOf(page), { L1: "A–B", L2: "B–C–E", L3: "C–D", L4: "C–G" });
  assert.equal(Object.keys(await jointsOf(page)).length, 6);
  await click(page, [50, 10]);
  await page.keyboard.press("Delete");
  assert.equal(Object.keys(await linksOf(page)).length, 3);
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
  await page.locator("#undo").click();
  assert.deepEqual(await jointsOf(page), before);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Control+Shift+z");
  assert.ok(await page.locator("#redo").isDisabled());
  await moving(page);
  await page.locator("#clear").click();
  assert.deepEqual(await jointsOf(page), {});
  assert.ok(await page.locator("#begin").isVisible());
}));

test("a four-bar is built by keys alone", () => visit({}, async (page) => {
  await page.locator("#sheet").focus();
  // The cross begins in the middle, and goes by the same way with each arrow.
  const go = async (x, y) => {
    for (const [count, keys] of [[x, ["ArrowLeft", "ArrowRight"]], [y, ["ArrowDown", "ArrowUp"]]]) for (let i = 0; i < Math.abs(count); ++i) await page.keyboard.press(`Shift+${keys[Number(count > 0)]}`);
  };
  await page.keyboard.press("l");
  await go(-4, -2);
  await page.keyboard.press("Enter");
  await go(1, 2);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await go(6, 2);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await go(1, -4);
  await page.keyboard.press("Enter");
  assert.deepEqual(await linksOf(page), { L1: "A–B", L2: "B–C", L3: "C–D" });
  await page.keyboard.press("f");
  await page.keyboard.press("Enter");
  await page.locator("[data-joint=A]").focus();
  await page.keyboard.press("Enter");
  await moving(page);
  // A pin by its handle, and by its fields; another name, and another drive.
  await page.locator("[data-joint=B]").focus();
  const { B } = await jointsOf(page);
  await page.keyboard.press("ArrowUp");
  assert.deepEqual((await jointsOf(page)).B.at, [B.at[0], B.at[1] + 1]);
  await page.locator('[data-cell="joint.C.x"]').fill("12.5");
  await page.keyboard.press("Tab");
  assert.equal((await jointsOf(page)).C.at[0], 12.5);
  await page.locator('[data-cell="link.L2.name"]').fill("coupler");
  await page.keyboard.press("Enter");
  await page.locator('[data-cell="link.L3.drives"]').focus();
  await page.keyboard.press("Space");
  await moving(page);
  assert.ok(await page.locator('[data-cell="link.L3.drives"]').isChecked());
  await page.locator('[data-cell="link.L3.name"]').fill("no name");
  await page.keyboard.press("Enter");
  assert.match(await saidOf(page), /^This cannot be/);
  assert.deepEqual(Object.keys(await linksOf(page)), ["L1", "coupler", "L3"]);
}));

test("a finger builds as the mouse does", () => visit({ size: "phone" }, async (page) => {
  await choose(page, "link");
  const session = await page.context().newCDPSession(page), { at } = await sheetOf(page);
  const touch = (type, place) => session.send("Input.dispatchTouchEvent", { type, touchPoints: place ? [{ x: at(place)[0], y: at(place)[1] }] : [] });
  for (const [from, to] of CRANK_ROCKER.links) {
    await touch("touchStart", from);
    await touch("touchMove", from.map((x, k) => (x + to[k]) / 2));
    await touch("touchMove", to);
    await touch("touchEnd");
  }
  await choose(page, "pivot");
  for (const pin of CRANK_ROCKER.pivots) await page.touchscreen.tap(...at(pin));
  await moving(page);
  assert.deepEqual(Object.values(await jointsOf(page)).map(({ fixed }) => fixed), [true, false, false, true]);
}));

test("it moves by itself, and what is grabbed goes back to where it is drawn", () => visit({ motion: "no-preference" }, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moves(page, "[data-pin=B]");
  const { at } = await sheetOf(page), { B } = await jointsOf(page);
  await page.mouse.move(...at([-50, -38]));
  await page.mouse.down();
  const pin = await page.locator("[data-pin=B]").boundingBox();
  assert.ok(distance([pin.x + pin.width / 2, pin.y + pin.height / 2], at(B.at)) < 1);
  await page.mouse.up();
  await moves(page, "[data-pin=B]");
}));

test("while a pin is dragged the curves follow", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  const { at } = await sheetOf(page), path = () => page.locator("[data-path=P]").getAttribute("d"), first = await path();
  await page.mouse.move(...at([20, 18]));
  await page.mouse.down();
  await page.mouse.move(...at([24, 20]));
  await page.mouse.move(...at([28, 22]));
  await page.waitForFunction((before) => document.querySelector("[data-path=P]").getAttribute("d") !== before, first);
  await page.mouse.up();
  assert.deepEqual((await jointsOf(page)).C.at, [28, 22]);
}));

// The facts of the page beside what the program says of its file.
async function assertSameFacts(page) {
  await page.locator("[data-take=copy_problem]").click();
  const { status, designs: [{ metrics }] } = await analysed(await page.locator("#taken").inputValue());
  assert.equal(status, "solved");
  const flat = (value, path) => (value !== null && typeof value === "object" ? Object.entries(value).flatMap(([key, part]) => flat(part, [...path, key])) : [[path.join("."), value]]);
  const known = flat(metrics, []).filter(([, value]) => typeof value === "number" && !Number.isInteger(value)).map(([, value]) => value);
  const shown = Object.entries(await factsOf(page)).filter(([, value]) => typeof value === "number" && !Number.isInteger(value));
  assert.ok(shown.length >= 2, JSON.stringify(shown));
  for (const [name, value] of shown) assert.ok(known.some((other) => Math.abs(other - value) <= 1e-6 * Math.max(1, Math.abs(value))), `${name} ${value} is none of ${known}`);
  return metrics;
}

for (const example of some(["six_bar", "slider_crank", "four_bar", "quick_return"])) {
  test(`the file of the example ${example} gives the same facts`, () => visit({}, async (page) => {
    await page.locator(`[data-example=${example}]`).click();
    await moving(page);
    assert.equal(await saidOf(page), "Mobility 1: the drive turns fully.");
    // It begins where it is drawn, and holds together.
    const joints = await jointsOf(page), names = Object.keys(joints);
    (await pinsAt(page, (await driveOf(page))[0], names)).forEach((place, i) => assertNear(place, joints[names[i]].at, names[i]));
    assert.ok(await gapOf(page) < 0.1);
    await assertSameFacts(page);
  }));
}

test("forces and masses give a torque, which the file has, too", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await choose(page, "load");
  await drag(page, [-6, 26], [-6, 16]);
  assert.equal(await page.locator('[data-cell="load.P.y"]').inputValue(), "-100");
  await typedIn(page, "link.L2.mass", "2");
  await page.locator("#weighs").check();
  await moving(page);
  const { torque_N_m: torque } = await assertSameFacts(page);
  assert.ok(torque.abs_max > 0.1);
  // The tip of the arrow is dragged, and removed.
  await choose(page, "move");
  await drag(page, [-6, 16], [4, 26]);
  assert.equal(await page.locator('[data-cell="load.P.x"]').inputValue(), "100");
  await page.locator('[data-cell="load.P.away"]').click();
  assert.equal(await page.locator("#loads-rows tr").count(), 0);
}));

test("a range that is not a whole turn is in the file", () => visit({}, async (page) => {
  await drawLinks(page, [[[-20, -20], [-20, 10]], [[-20, 10], [10, 12]], [[10, 12], [20, -20]]]);
  await fix(page, [[-20, -20], [20, -20]]);
  await moving(page);
  await assertSameFacts(page);
}));

const LIBRARY = new URL("../../problems/library/analysis/", import.meta.url).pathname;
for (const name of some(["jansen-leg", "stephenson-six-bar", "fixed-block", "shaper", "toggle-press", "klann-leg", "scotch-yoke", "double-rocker", "slotter", "tangent-generator", "oscillating-block", "pump-jack"])) {
  test(`the page begins with the mechanism of ${name}`, () => visit({ problem: `${LIBRARY}${name}.toml` }, async (page) => {
    await moving(page);
    const joints = await jointsOf(page), names = Object.keys(joints), [from, to] = await driveOf(page);
    const drawn = await pinsAt(page, from, names);
    assert.ok(names.length > 1 && drawn.flat().every(Number.isFinite));
    // That of a tangent generator runs to infinity, and its lever is measured otherwise as a chain.
    const isBounded = name !== "tangent-generator";
    if (isBounded) assert.ok(await gapOf(page) < 0.5);
    // It fills the sheet.
    const [width, height] = [0, 1].map((k) => Math.max(...drawn.map((p) => p[k])) - Math.min(...drawn.map((p) => p[k])));
    if (isBounded) assert.ok(Math.max(width, height) > 15 && Math.max(width, height) < 200, `${width} by ${height}`);
    await page.locator("[data-take=copy_problem]").click();
    const [own, original] = [await analysed(await page.locator("#taken").inputValue()), await analysed(fs.readFileSync(`${LIBRARY}${name}.toml`, "utf8"))].map(({ designs: [{ metrics }] }) => metrics);
    assert.deepEqual(own.topology, original.topology);
    // A file may move it through a part of its range.
    for (const key of ["min", "max"]) if (isBounded && to - from > 359.9 && original.transmission_angle_deg) assert.ok(Math.abs(own.transmission_angle_deg[key] - original.transmission_angle_deg[key]) < 0.02);
  }));
}

test("the address holds the mechanism", () => visit({}, async (page) => {
  await page.locator("[data-example=quick_return]").click();
  await moving(page);
  await page.locator('[data-cell="link.L2.name"]').fill("bar");
  await page.keyboard.press("Enter");
  await page.locator('[data-cell="link.bar.name"]').waitFor();
  await choose(page, "load");
  await drag(page, [0, 26], [10, 26]);
  const all = async (one) => [await jointsOf(one), await linksOf(one), await one.locator("#loads-rows tr").count(), await one.locator("#sliders-rows tr").count()];
  const before = await all(page);
  await visit({ hash: `#${page.url().split("#")[1]}` }, async (again) => {
    await moving(again);
    assert.deepEqual(await all(again), before);
  });
  await page.locator("#language").selectOption("zh");
  await page.waitForFunction(() => document.documentElement.lang === "zh-Hans" && document.querySelector("#joints-rows tr"));
  assert.deepEqual((await all(page))[0], before[0]);
}));

const BAD = ["#j=A,0,0", "#j=A,x,0,frame", "#j=A,0,0,frame;A,1,1,frame", "#j=A,0,0,L1", "#l=L1", "#j=A,1e9,0,frame", "#j=%E0,0,0,frame", "#j=__proto__,0,0,frame", "#j=A,0,0,frame~L1;B,1,1,L1&l=L1,-1", "#%",
  "#j=A,0,0,frame~L1;B,1,1,L1&l=L1&s=G,L1,L1,0", "#j=A,0,0,frame~L1;B,1,1,L1&l=L1&d=L2", "#j=A,0,0,frame~L1;B,1,1,L1&l=L1&f=C,1,1", `#j=${Array.from({ length: 61 }, (_, i) => `P${i},${i},0,frame`).join(";")}`];
for (const hash of some(BAD)) {
  test(`a damaged address does no harm: ${hash.slice(0, 40)}`, () => visit({ hash }, async (page) => {
    if (hash.includes("=") && !hash.includes("__proto__")) assert.equal(await saidOf(page), "The address holds no mechanism that this page could read.");
    await buildFourBar(page);
  }));
}

test("what is missing is said in a sentence", () => visit({}, async (page) => {
  await drawLinks(page, CRANK_ROCKER.links);
  assert.equal(await saidOf(page), "Nothing is fixed yet: fix pins to the frame.");
  await fix(page, CRANK_ROCKER.pivots.slice(0, 1));
  assert.match(await saidOf(page), /^Mobility 3/);
  await fix(page, [...CRANK_ROCKER.pivots.slice(1), [20, 20]]);
  assert.match(await saidOf(page), /^Mobility −1/);
  await page.locator("#undo").click();
  await moving(page);
  // Two pins at one place are no link: the kernel says so.
  await page.locator('[data-cell="joint.B.x"]').fill("-30");
  await page.locator('[data-cell="joint.B.y"]').fill("-20");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.getElementById("state").className === "wrong");
  assert.match(await saidOf(page), /^[A-Z\p{Script=Han}].+/u);
  assert.ok(await page.locator("#facts").isHidden());
}));

test("pictures and films are saved", () => visit({}, async (page) => {
  await page.locator("[data-example=six_bar]").click();
  await moving(page);
  const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("[data-save=picture]").click()]);
  assert.match(fs.readFileSync(await saved.path(), "utf8"), /^<svg .*<\/svg>\s*$/s);
  const [problem] = await Promise.all([page.waitForEvent("download"), page.locator("[data-take=save_problem]").click()]);
  assert.match(fs.readFileSync(await problem.path(), "utf8"), /\[\[mechanism\.joint\]\]/);
}));

for (const options of some([{ size: "phone", scheme: "dark" }, { size: "laptop" }, { size: "desktop" }, { size: "phone", locale: "zh-CN" }])) {
  test(`it fits: ${JSON.stringify(options)}`, () => visit(options, async (page) => {
    await assertFits(page);
    await page.locator("[data-example=quick_return]").click();
    await moving(page);
    await choose(page, "load");
    await assertFits(page);
    if (options.locale) assert.doesNotMatch((await page.locator("main").innerText()).replaceAll("Delete", ""), /[A-Za-z]{5}/);
  }));
}

test("a drag that Escape ends does nothing more", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  const { at } = await sheetOf(page), before = await jointsOf(page), [x, y] = before.C.at;
  for (const tool of ["move", "link", "slider", "load", "point"]) {
    await choose(page, tool);
    await page.mouse.move(...at([x, y]));
    await page.mouse.down();
    await page.mouse.move(...at([x + 4, y + 3]), { steps: 3 });
    await page.keyboard.press("Escape");
    await page.mouse.move(...at([x + 9, y - 5]), { steps: 3 });
    await page.mouse.up();
  }
  assert.deepEqual(await jointsOf(page), before);
}));

test("a crank that nearly turns fully goes to and fro", () => {
  const hash = "#j=A,0,0,frame~crank;B,-0.08726535498373997,9.999619230641713,crank~c;C,23.36419864531998,18.661393658838204,c~r;D,40,0,r~frame&l=crank;c;r";
  return visit({ hash }, async (page) => {
    await moving(page);
    const [from, to] = await driveOf(page);
    assert.ok(Math.abs(from + 179.714) < 0.01 && Math.abs(to - 179.714) < 0.01, `${from} to ${to}`);
  });
});

test("what the page cannot keep it refuses, and it reads what it writes", () => visit({}, async (page) => {
  await page.locator("[data-example=four_bar]").click();
  await moving(page);
  await page.locator('[data-cell="joint.B.x"]').fill("1e7");
  await page.keyboard.press("Tab");
  assert.notEqual(await page.locator('[data-cell="joint.B.x"]').inputValue(), "1e7");
  await typedIn(page, "link.L2.mass", "1e22");
  await page.reload();
  await moving(page);
  assert.equal(Number(await page.locator('[data-cell="link.L2.mass"]').inputValue()), 1e22);
}));

test("forces at points of a file are on the page", () => {
  const problem = `${process.env.TMPDIR ?? "/tmp"}/forces-${process.pid}.toml`;
  fs.writeFileSync(problem, `kind = "analysis"\nlength_unit = "mm"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [40, 0]]\ncrank = 10\ncoupler = 35\nrocker = 30\n
    load = [{on = "C", force = [10, 0]}, {on = "C", force = [-4, 3]}]\n`);
  return visit({ problem }, async (page) => {
    await moving(page);
    assert.deepEqual(await Promise.all(["x", "y"].map((axis) => page.locator(`[data-cell="load.C.${axis}"]`).inputValue())), ["6", "3"]);
    await page.locator("[data-take=copy_problem]").click();
    const [own, original] = (await Promise.all([page.locator("#taken").inputValue(), fs.readFileSync(problem, "utf8")].map(async (text) => analysed(await text)))).map(({ designs: [{ metrics }] }) => metrics.torque_N_m);
    assert.ok(Math.abs(own.abs_max - original.abs_max) < 1e-6 * original.abs_max, `${own.abs_max} is not ${original.abs_max}`);
  });
});

test("what began at a pin ends with it", () => visit({}, async (page) => {
  await drawLinks(page, [[[-30, -20], [-22, -8]], [[0, 0], [8, 6]]]);
  await choose(page, "link");
  await click(page, [8, 6]);
  await page.keyboard.press("z");
  await click(page, [20, -20]);
  assert.deepEqual(Object.keys(await jointsOf(page)), ["A", "B"]);
  await click(page, [30, -20]);
  assert.deepEqual(Object.keys(await jointsOf(page)), ["A", "B", "C", "D"]);
}));

test("an address without a mechanism gives way to that of the one shown", () => visit({}, async (page) => {
  await buildFourBar(page);
  const address = page.url();
  for (const hash of ["#j=A,0", "#"]) {
    await page.evaluate((to) => { location.hash = to; }, hash);
    await page.waitForFunction((to) => location.href === to, address);
    if (hash !== "#") assert.equal(await saidOf(page), "The address holds no mechanism that this page could read.");
  }
  await page.reload();
  await moving(page);
  assert.equal(Object.keys(await jointsOf(page)).length, 5);
}));
