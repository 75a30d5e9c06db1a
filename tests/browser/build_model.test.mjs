// Mechanisms that are built by hand, without their page: random edits, and what each edit does.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { addLink, addPoint, addSlider, mergeJoints, moveJoint, moveLink, putPivot, removeJoint, removeLink, removeLoad, removeSlider, rename, setCentre, setDegrees, setDriven, setInertia, setLoad, setMass, setRate, setTorque, setWeighs, setWindow } from "../../app/report/page/build/edits.js";
import { evenMass } from "../../app/report/page/build/even_mass.js";
import { EXAMPLES } from "../../app/report/page/build/examples.js";
import { hullOf, spotAt } from "../../app/report/page/build/hits.js";
import { directionOf, driverOf, EMPTY, isSound, jointsOn, linksOfLoad, loadNames, mobilityOf, MOST, pinOf } from "../../app/report/page/build/model.js";
import { TOOLS } from "../../app/report/page/build/tools.js";
import { randomNumbers } from "../bench/report/drawings.mjs";

// What the module of words asks of a page.
const words = readFileSync(new URL("../../app/report/page/words/en.json", import.meta.url), "utf8");
Object.assign(globalThis, { location: { hash: "#en" }, navigator: { languages: [] },
  document: { getElementById: () => ({ textContent: `{"en":${words}}` }), documentElement: { dataset: {} }, querySelectorAll: () => [] } });
const { problemOfState } = await import("../../app/report/page/build/chain.js");

const RUNS = process.env.WHOLE ? 2000 : 200, EDITS = 60;

function frozen(value) {
  if (value !== null && typeof value === "object") { Object.values(value).forEach(frozen); Object.freeze(value); }
  return value;
}

// What holds of every state, said apart from the model.
function assertWhole(state, what) {
  const links = state.links.map(({ name }) => name), names = [...links, ...state.joints.map(({ name }) => name), ...state.sliders.map(({ name }) => name)];
  assert.equal(new Set(names).size, names.length, `${what}: names`);
  assert.ok(!names.includes("frame"), what);
  for (const { at, of } of state.joints) {
    assert.ok(at.length === 2 && at.every(Number.isFinite), what);
    assert.ok(of.length > 0 && new Set(of).size === of.length && of.every((name) => name === "frame" || links.includes(name)), `${what}: ${of}`);
  }
  for (const { block, on, along } of state.sliders) {
    assert.ok(links.includes(block) && block !== on && (on === "frame" || links.includes(on)), what);
    assert.ok(state.joints.some(({ of }) => of.includes(block)), what);
    for (const name of along ?? []) assert.ok(state.joints.some((joint) => joint.name === name && joint.of.includes(on)), `${what}: along ${along}`);
  }
  for (const name of links) {
    const held = state.joints.filter(({ of }) => of.includes(name)).length + state.sliders.filter(({ block, on }) => block === name || on === name).length;
    assert.ok(held > 1, `${what}: ${name} hangs on nothing`);
  }
  assert.ok(state.driven === null || links.includes(state.driven), what);
  for (const { on, force, torque, window } of state.loads) {
    const joint = state.joints.find(({ name }) => name === on);
    assert.ok(force ? joint : links.includes(on) && Number.isFinite(torque), `${what}: load on ${on}`);
    if (window) assert.ok(force ? joint.of.includes(window.link) : window.link === on, `${what}: window of ${window.link} on ${on}`);
  }
  assert.equal(new Set(loadNames(state)).size, state.loads.length, what);
  for (const [key, most] of Object.entries(MOST)) assert.ok(state[key].length <= most, what);
  const driver = driverOf(state);
  assert.ok(driver === null || links.includes(driver), what);
  assert.ok(Number.isInteger(mobilityOf(state)) && state.sliders.every((slider) => Number.isFinite(directionOf(state, slider)) && pinOf(state, slider)), what);
  assert.ok(isSound(state), what);
}

// Every name that a problem mentions is one of its own.
function assertNamed({ mechanism: { joint }, link = [], load = [] }, what) {
  const joints = joint.map(({ name }) => name), links = joint.flatMap(({ of }) => of);
  assert.equal(new Set(joints).size, joints.length, what);
  for (const { name, between } of link) assert.ok(between ? between.every((one) => joints.includes(one)) && between[0] !== between[1] : links.includes(name), `${what}: ${name ?? between}`);
  for (const { on } of load) assert.ok([on].flat().every((one) => joints.includes(one) || links.includes(one)), `${what}: ${on}`);
}

function randomWindow(state, name, random) {
  const pick = (list) => list[Math.floor(random() * list.length)], load = state.loads[loadNames(state).indexOf(name)];
  const when = pick(["always", "advance", "return", [-20, 140]]);
  return random() < 0.2 ? null : { link: pick(linksOfLoad(state, load)), when, stroke: random() < 0.4 ? [0.1, 0.8] : null };
}

// One random edit, as [its name, the state after it or null].
function randomEdit(state, random) {
  const pick = (list) => list[Math.floor(random() * list.length)];
  const place = () => [Math.round(120 * random() - 60), Math.round(84 * random() - 42)];
  const spot = () => spotAt(state, random() < 0.6 && state.joints.length ? pick(state.joints).at.map((x) => x + 2 * (random() - 0.5)) : place(), 3);
  const joint = pick(state.joints)?.name, other = pick(state.joints)?.name, link = pick(state.links)?.name, slider = pick(state.sliders)?.name, load = pick(loadNames(state)), { force } = state.loads[loadNames(state).indexOf(load)] ?? {};
  const edits = {
    drag: () => { const { drag } = pick(Object.values(TOOLS)); return drag?.(state, spot(), spot()) ?? null; },
    click: () => { const { click } = pick(Object.values(TOOLS)); return click?.(state, spot()) ?? null; },
    link: () => addLink(state, spot(), spot()),
    slider: () => addSlider(state, spot(), spot(), 360 * random()),
    pivot: () => putPivot(state, spot()),
    ...(joint && { move: () => moveJoint(state, joint, place()), merge: () => mergeJoints(state, joint, other), load: () => setLoad(state, joint, [Math.round(20 * random() - 10), 5]), name: () => rename(state, joint, pick(["A", "Q", "frame", "", "L1", "ä b", "x'1"])) }),
    ...(joint && random() < 0.5 && { remove: () => removeJoint(state, joint) }),
    ...(link && { point: () => addPoint(state, link, place()), shift: () => moveLink(state, link, place()), mass: () => setMass(state, link, 3 * random() - 1), centre: () => setCentre(state, link, random() < 0.3 ? null : place()), inertia: () => setInertia(state, link, random() < 0.3 ? null : random() - 0.2), torque: () => setTorque(state, link, Math.round(6 * random() - 3)), drive: () => setDriven(state, link), rename: () => rename(state, link, pick(["bar", "A", "link.1"])) }),
    ...(link && random() < 0.3 && { away: () => removeLink(state, link) }),
    ...(slider && { turn: () => setDegrees(state, slider, 360 * random()), free: () => removeSlider(state, slider) }),
    ...(load && { unload: () => removeLoad(state, load), size: () => (force ? setLoad(state, load, [3, Math.round(2 * random())]) : setTorque(state, load, 5)), window: () => setWindow(state, load, randomWindow(state, load, random)) }),
    rate: () => setRate(state, { speed: 40 * random() - 20 }),
    weigh: () => setWeighs(state, random() < 0.5),
  };
  const name = pick(Object.keys(edits));
  return [name, edits[name]()];
}

test("random edits never fail, change no state, and make only whole ones", () => {
  const counts = {};
  let largest = 0, mechanisms = 0;
  for (let run = 0; run < RUNS; ++run) {
    const random = randomNumbers(123456789 + 7919 * run);
    for (let i = 0; i < 20; ++i) random();
    let state = frozen(run % 3 ? EMPTY : Object.values(EXAMPLES)[run % 4]);
    const done = [];
    for (let i = 0; i < EDITS; ++i) {
      const [name, next] = randomEdit(state, random);
      done.push(name);
      const what = `run ${run}: ${done.join(" ")}`;
      if (next === null) continue;
      counts[name] = (counts[name] ?? 0) + 1;
      assertWhole(next, what);
      state = frozen(next);
      if (i === EDITS - 1) assertNamed(problemOfState(state), what);
      largest = Math.max(largest, state.joints.length);
      mechanisms += mobilityOf(state) === 1 && driverOf(state) !== null;
    }
  }
  for (const name of ["drag", "click", "link", "slider", "pivot", "merge", "remove", "away", "rename", "free", "unload", "torque", "window", "centre"]) assert.ok(counts[name] > RUNS / 20, `${name} ${counts[name]}`);
  assert.ok(largest > 15 && mechanisms > RUNS, `${largest} joints, ${mechanisms} mechanisms`);
});

test("nothing grows beyond what a page holds", () => {
  let state = EMPTY;
  for (let i = 0; i < 100; ++i) state = addLink(state, { at: [i, 0] }, { at: [i, 10] }) ?? state;
  assert.equal(state.joints.length, MOST.joints);
  assert.equal(addPoint(state, "L1", [0, 0]), null);
  assert.equal(putPivot(state, { at: [1, 1] }), null);
});

// A four-bar as a hand draws it.
const fourBar = () => [[{ at: [0, 0] }, { at: [0, 10] }], [{ joint: "B" }, { at: [30, 20] }], [{ joint: "C" }, { at: [30, 0] }]].reduce((state, [from, to]) => addLink(state, from, to), EMPTY);

test("three links and two pivots are a four-bar, and the first link drives", () => {
  const open = fourBar();
  assert.equal(mobilityOf(open), 9 - 4);
  assert.equal(driverOf(open), null);
  const closed = putPivot(putPivot(open, { joint: "A" }), { joint: "D" });
  assert.equal(mobilityOf(closed), 1);
  assert.equal(driverOf(closed), "L1");
  assert.equal(driverOf(setDriven(closed, "L3")), "L3");
  assert.equal(setDriven(closed, "L2"), null);
  assert.equal(mobilityOf(putPivot(closed, { joint: "A" })), 3);
});

test("a link that begins on another makes it ternary, and a link between joints of one body is none", () => {
  const more = addLink(fourBar(), { link: "L2", at: [15, 15] }, { at: [15, 40] });
  assert.deepEqual(more.joints.at(-2), { name: "E", at: [15, 15], of: ["L2", "L4"] });
  assert.equal(jointsOn(more, "L2").length, 3);
  assert.equal(addLink(more, { joint: "B" }, { joint: "C" }), null);
  assert.equal(addLink(more, { joint: "A" }, { joint: "A" }), null);
});

test("what hangs on a joint or a link goes with it", () => {
  const loaded = setLoad(addPoint(fourBar(), "L2", [10, 30]), "E", [0, -5]);
  const without = removeLink(loaded, "L2");
  assert.deepEqual([without.links.length, without.joints.map(({ name }) => name), without.loads], [2, ["A", "B", "C", "D"], []]);
  // A link with one joint left is none.
  assert.deepEqual(removeJoint(fourBar(), "D").links.map(({ name }) => name), ["L1", "L2"]);
  assert.deepEqual(removeJoint(removeJoint(removeJoint(fourBar(), "D"), "C"), "B"), EMPTY);
});

test("a slider on the frame takes the place of a pivot, and a pivot that of a slider", () => {
  const slides = addSlider(putPivot(fourBar(), { joint: "D" }), { joint: "D" }, { at: [50, 0] }, 0);
  assert.deepEqual(slides.sliders, [{ name: "G1", block: "S1", on: "frame", degrees: 0, along: null }]);
  assert.deepEqual(slides.joints.find(({ name }) => name === "D").of, ["L3", "S1"]);
  const again = addSlider(slides, { joint: "D" }, { at: [30, 50] }, 90);
  assert.deepEqual(again.sliders.map(({ degrees, block }) => [degrees, block]), [[90, "S1"]]);
  const fixed = putPivot(again, { joint: "D" });
  assert.deepEqual([fixed.sliders, fixed.joints.find(({ name }) => name === "D").of], [[], ["L3", "frame"]]);
});

test("a block on a link keeps to its line, which follows the joints and outlasts them", () => {
  const bar = [[{ at: [0, 0] }, { at: [0, 12] }], [{ at: [0, -32] }, { at: [1, 26] }]].reduce((state, [from, to]) => addLink(state, from, to), EMPTY);
  const ends = [["L1", "A"], ["L2", "C"]].reduce((state, [, joint]) => putPivot(state, { joint }), bar);
  const slides = addSlider(ends, { joint: "B" }, { link: "L2", at: [0.5, 5] }, 0);
  // The bar's free end has turned until its line runs through the block's pin.
  assert.deepEqual(slides.sliders[0].along, ["C", "D"]);
  assert.ok(Math.abs(slides.joints.find(({ name }) => name === "D").at[0]) < 1e-12);
  assert.equal(mobilityOf(slides), 1);
  assert.ok(Math.abs(directionOf(moveJoint(slides, "D", [58, 26]), slides.sliders[0]) - 45) < 1e-12);
  const left = removeJoint(moveJoint(slides, "D", [58, 26]), "D");
  assert.deepEqual([left.sliders[0].along, left.links.length], [null, 3]);
  assert.ok(Math.abs(left.sliders[0].degrees - 45) < 1e-12);
});

test("pins let go on one another become one, but not those of a link", () => {
  const apart = addLink(fourBar(), { at: [40, 40] }, { at: [50, 50] });
  const joined = mergeJoints(apart, "E", "C");
  assert.deepEqual(joined.joints.find(({ name }) => name === "C").of, ["L2", "L3", "L4"]);
  assert.equal(mergeJoints(joined, "F", "C"), null);
});

test("names are changed everywhere, each once", () => {
  const state = rename(rename(setLoad(EXAMPLES.quick_return, "D", [1, 2]), "D", "tip"), "L2", "bar");
  assertWhole(state, "renamed");
  assert.deepEqual([state.sliders[0].on, state.sliders[0].along, state.loads[0].on], ["bar", ["C", "tip"], "tip"]);
  for (const name of ["A", "frame", "", "a b", "x".repeat(41), "S1"]) assert.equal(rename(state, "bar", name), null);
});

test("hulls turn to the left and leave inner points out", () => {
  assert.deepEqual(hullOf([[0, 0], [4, 0], [4, 4], [2, 1], [0, 4], [2, 0]]), [[0, 0], [4, 0], [4, 4], [0, 4]]);
  assert.deepEqual(hullOf([[1, 1], [0, 0], [2, 2]]), [[0, 0], [2, 2]]);
});

test("mass is spread evenly over rods and plates", () => {
  assert.deepEqual(evenMass([[1, 2], [7, 10]]), { centre: [4, 6], square: 100 / 12 });
  // A rectangle of 6 by 3 far from the origin: (6² + 3²)/12 about its middle.
  const { centre, square } = evenMass([[100, 50], [106, 50], [106, 53], [100, 53]]);
  assert.deepEqual(centre, [103, 51.5]);
  assert.ok(Math.abs(square - 45 / 12) < 1e-10);
  // An equilateral triangle of side a: a²/12.
  const triangle = evenMass([[0, 0], [2, 0], [1, Math.sqrt(3)]]);
  assert.ok(Math.abs(triangle.square - 4 / 12) < 1e-12 && Math.abs(triangle.centre[1] - Math.sqrt(3) / 3) < 1e-12);
});

test("examples are whole mechanisms", () => {
  for (const [name, state] of Object.entries(EXAMPLES)) {
    assertWhole(state, name);
    assert.equal(mobilityOf(state), 1, name);
    assert.equal(driverOf(state), "L1", name);
  }
});

test("loads on one part have names of their own, and are changed by them", () => {
  const two = { ...fourBar(), loads: [{ on: "C", force: [1, 0] }, { on: "C", force: [0, 2], window: { link: "L3", when: "advance", stroke: null } }, { on: "L2", torque: 3 }] };
  assert.deepEqual(loadNames(two), ["C", "C#2", "L2"]);
  assert.deepEqual(setLoad(two, "C#2", [5, 5]).loads[1], { on: "C", force: [5, 5], window: two.loads[1].window });
  assert.deepEqual(removeLoad(two, "C").loads.map(({ force, torque }) => force ?? torque), [[0, 2], 3]);
  assert.deepEqual(setTorque(two, "L2", 0).loads.length, 2);
  // A window ends with the link that it follows, a torque with its own.
  const without = removeLink(rename(two, "L3", "rocker"), "rocker");
  assert.deepEqual(without.loads[1], { on: "C", force: [0, 2] });
  assert.deepEqual(removeLink(two, "L2").loads.map(({ on }) => on), ["C", "C"]);
});

test("a force in a window is written on the link that it follows", () => {
  const closed = putPivot(putPivot(fourBar(), { joint: "A" }), { joint: "D" }), window = { link: "L3", when: "return", stroke: [0.2, 0.5] };
  const { load: [load] } = problemOfState({ ...closed, loads: [{ on: "C", force: [1, 2], window }] });
  assert.deepEqual(load, { on: ["C", "D"], at: [0, 0], force: [1, 2], when: "return", stroke: [0.2, 0.5] });
  // The centre of mass of the coupler, from B towards C.
  const { link: [link], drive } = problemOfState({ ...setInertia(setCentre(setMass(closed, "L2", 2), "L2", [20, 5]), "L2", 3e-4), speed: 7 });
  assert.deepEqual([link.between, link.mass, link.inertia, drive], [["B", "C"], 2, 3e-4, { speed: 7 }]);
  assert.ok(Math.abs(link.centre[0] - (20 * 30 + (5 - 10) * 10) / Math.hypot(30, 10)) < 1e-9 && Math.abs(link.centre[1] - (30 * -5 - 10 * 20) / Math.hypot(30, 10)) < 1e-9, `${link.centre}`);
});
