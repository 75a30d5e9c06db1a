// The searches for slider-cranks and for straight lines in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it;
// COGNATE: the program.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { seldom as test, some } from "./thinned.mjs";
import { harmonicStroke, randomNumbers } from "../bench/report/drawings.mjs";
import { kindOf, leadingQuestion, liveQuestion, problemOf, questionsOf } from "../../app/report/page/sketch/question.js";
import { placedOn } from "../../app/report/page/sketch/ruled.js";
import { problemToml } from "../../app/report/page/toml.js";
import { couplerPose, leastTransmission, sliderOf, sliderPose } from "./closures.mjs";
import { answer } from "./sketch_kernel.mjs";

const RADIANS = Math.PI / 180, FINE = 3600;
const LIMITS = { class: "any", least: 30, reach: 3, region: null, obstacle: null, angles: null, ranges: null };
const asked = (state, starts, known = []) => answer({ ...problemOf(state, { starts, designs: 8 }), ...(known.length ? { known } : {}) });
const turn = (count) => Array.from({ length: count }, (_, i) => (2 * Math.PI * i) / count);
const rms = (values) => Math.hypot(...values) / Math.sqrt(values.length);

function byProgram(problem) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-sliders-")), file = path.join(folder, "sketch.toml");
  fs.writeFileSync(file, problemToml(problem));
  try {
    return JSON.parse(execFileSync(process.env.COGNATE, ["solve", "--json", file], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] }));
  } finally { fs.rmSync(folder, { recursive: true }); }
}

// What is said of each slider-crank, by a circle that meets its guide.
function checkSliders({ points, least, reach, region }, designs) {
  const size = Math.hypot(...[0, 1].map((k) => Math.max(...points.map((p) => p[k])) - Math.min(...points.map((p) => p[k]))));
  for (const { mechanism, crank_deg: cranks, rms: said, max, class: name, transmission_acute_min_deg: angle } of designs) {
    const slider = sliderOf(mechanism), far = points.map((p, i) => { const { at } = sliderPose(slider, cranks[i] * RADIANS); return Math.hypot(at[0] - p[0], at[1] - p[1]); });
    assert.ok(Math.abs(rms(far) - said) < 1e-9 * size && Math.abs(Math.max(...far) - max) < 1e-9 * size, `${far} against ${said}, ${max}`);
    const over = Math.min(...turn(FINE).map((at) => sliderPose(slider, at)?.transmission ?? NaN));
    assert.ok(angle >= least - 1e-6 && Math.abs(over - angle) < 1e-3, `${over} against ${angle}`);
    assert.ok(Math.max(mechanism.crank, mechanism.coupler) <= reach * size * 1.001 && name === "slider-crank");
    if (region) assert.ok(mechanism.pivot.every((x, k) => x >= region[0][k] - 1e-6 && x <= region[1][k] + 1e-6), `${mechanism.pivot}`);
  }
}

function planted(random) {
  const crank = 8 + 10 * random(), offset = 12 * (random() - 0.5), coupler = (crank + Math.abs(offset)) * (1.4 + random());
  const slider = { a: [20 * random(), 20 * random()], crank, coupler, offset, direction: 360 * random(), u: coupler * random(), v: 15 * (random() - 0.5), ahead: random() < 0.5 ? 1 : -1 };
  return turn(18).map((at) => sliderPose(slider, at).at);
}

test("curves of slider-cranks are found to rounding", () => {
  const random = randomNumbers();
  for (const i of some([0, 1, 2, 3, 4, 5])) {
    const state = { ...LIMITS, least: 15, reach: 5, slides: true, closed: true, points: planted(random) }, { designs } = asked(state, 500);
    checkSliders(state, designs);
    assert.ok(designs[0].rms < 1e-6, `${designs[0].rms} of ${i}`);
  }
});

test("a slider-crank follows by itself a point that is moved", () => {
  for (const i of some([0, 1, 2, 3])) {
    const state = stroke(i), [before] = asked(state, 200).designs, moved = { ...state, points: state.points.with(3, state.points[3].map((x) => x + 0.4)) };
    const { problem, known } = leadingQuestion(moved, { entry: before }), { designs } = answer({ ...problem, known });
    checkSliders(moved, designs);
    const stayed = rms(moved.points.map((p, k) => { const { at } = sliderPose(sliderOf(before.mechanism), before.crank_deg[k] * RADIANS); return Math.hypot(at[0] - p[0], at[1] - p[1]); }));
    assert.ok(designs.length === 1 && designs[0].rms < stayed, `${designs[0]?.rms} against ${stayed}`);
    assert.deepEqual(answer(problem).designs, []);
  }
});

const stroke = (i) => ({ ...LIMITS, slides: true, closed: i % 2 === 0, points: harmonicStroke(randomNumbers(77 + 1299709 * i), i % 2 === 0, 60, 16) });

for (const limits of [{}, { least: 50 }, { reach: 1.5 }, { region: [[-20, -60], [60, -10]] }]) {
  test(`limits of slider-cranks are met: ${JSON.stringify(limits)}`, () => {
    const state = { ...stroke(1), ...limits }, { designs } = asked(state, 250);
    assert.ok(designs.length > 0);
    checkSliders(state, designs);
  });
}

test("of most strokes the program finds no slider-crank that is better by a hundredth", () => {
  const ratios = [0, 1, 2, 3, 4, 5].map(stroke).map((state) => {
    const { designs } = asked(state, 2500), result = byProgram(problemOf(state, { designs: 3 }));
    checkSliders(state, designs);
    return Math.min(...designs.map((one) => one.rms)) / result.designs[0].error.rms;
  });
  assert.ok(ratios.filter((ratio) => ratio <= 1.01).length >= 5, `${ratios}`);
});

test("a search for slider-cranks that begins with a design ends with none worse", () => {
  const row = ({ mechanism: m, crank_deg: cranks }) => [...m.pivot, m.crank, m.direction_deg, m.offset, m.coupler, ...m.coupler_point, m.assembly === "open" ? 1 : 0, ...cranks];
  const found = asked(stroke(3), 500).designs, again = asked(stroke(3), 1, found.map(row)).designs;
  assert.ok(found[0].rms > 1e-3 && again[0].rms <= found[0].rms * (1 + 1e-6), `${again[0].rms} after ${found[0].rms}`);
});

test("both kinds are searched for in turns, four-bars first, each from its own designs", () => {
  const both = { ...stroke(1), both: true }, fourBars = { ...both, slides: false, both: false }, sliders = { ...both, both: false };
  const entries = [fourBars, sliders].map((state) => asked(state, 60).designs[0]), candidates = entries.map((entry) => ({ entry }));
  const ofKind = ({ problem, known }) => [problem.mechanism?.type ?? "four-bar", problem.solve.starts, known.map((row) => row.length - both.points.length)];
  // The first question is that of four-bars alone, which begins with as many numbers.
  const [first, second, ...later] = questionsOf(both, candidates);
  assert.deepEqual(first, { ...questionsOf(fourBars, candidates)[0], last: false });
  assert.deepEqual([first, second].map(ofKind), [["four-bar", 60, [11]], ["slider-crank", 60, [9]]]);
  assert.deepEqual(later.map((question) => ofKind(question).slice(0, 2)), [500, 500, 2500, 2500].map((starts, i) => [i % 2 ? "slider-crank" : "four-bar", starts]));
  assert.deepEqual([first, second, ...later].map(({ first: begins, last }) => [begins, last]), Array.from({ length: 6 }, (_, i) => [i === 0, i === 5]));
  // While a hand drags both are asked at once, the design that leads alone.
  const live = liveQuestion(both, candidates);
  assert.deepEqual([live, ...live.others].map(ofKind), [["four-bar", 1, [11]], ["slider-crank", 1, [9]]]);
  for (const [i, kind] of ["four-bar", "slider-crank"].entries()) {
    const leading = leadingQuestion(both, candidates[i]);
    assert.equal(leading.problem.mechanism?.type ?? "four-bar", kind);
    assert.equal(answer({ ...leading.problem, known: leading.known }).designs.length, 1);
    assert.deepEqual(problemOf(kindOf(both, entries[i]), {}), problemOf([fourBars, sliders][i], {}));
  }
});

const LINE = { ...LIMITS, straight: true, points: [[-20, 5], [35, 25]] };
const LENGTH = Math.hypot(55, 20), NORMAL = [-20 / LENGTH, 55 / LENGTH], ALONG = [55 / LENGTH, 20 / LENGTH];
const barOf = ({ fixed_pivots: [a, d], crank, coupler, rocker, coupler_point: [u, v], assembly }) => ({ a, d, crank, coupler, rocker, u, v, side: assembly === "open" ? 1 : -1 });

// What is said of each four-bar that draws the line, by circles that meet: its point goes from end to end, no farther from the line than its deviation.
function checkLine({ least, reach, class: name }, entries) {
  for (const entry of entries.map((one) => placedOn(one, LINE.points))) {
    const bar = barOf(entry.mechanism), [from, , to] = entry.crank_deg, places = Array.from({ length: FINE + 1 }, (_, i) => couplerPose(bar, (from + ((to - from) * i) / FINE) * RADIANS).at);
    const [along, across] = [ALONG, NORMAL].map((axis) => places.map((p) => (p[0] + 20) * axis[0] + (p[1] - 5) * axis[1]));
    assert.ok(Math.abs(Math.min(...along)) < 1e-4 && Math.abs(Math.max(...along) - LENGTH) < 1e-4, `${Math.min(...along)} to ${Math.max(...along)}`);
    const far = Math.max(...across.map(Math.abs));
    assert.ok(Math.abs(far - entry.rms) <= 0.01 * entry.rms + 1e-8, `${far} against ${entry.rms}`);
    assert.ok(entry.transmission_acute_min_deg >= least - 1e-6 && Math.abs(leastTransmission(bar, [from, to]) - entry.transmission_acute_min_deg) < 0.01);
    const { crank, coupler, rocker, a, d, u, v } = bar, links = [crank, coupler, rocker, Math.hypot(d[0] - a[0], d[1] - a[1])];
    assert.ok(Math.max(...links, Math.hypot(u, v), Math.hypot(u - coupler, v)) <= reach * LENGTH * (1 + 1e-5), `${links}`);
    assert.ok(Math.max(...links) <= 10.001 * Math.min(...links) && (name === "any" || entry.class === name), `${links}, ${entry.class}`);
  }
}

for (const limits of [{}, { class: "crank-rocker" }, { class: "crank-rocker", least: 40, reach: 2 }, { class: "double-rocker", reach: 1.5 }]) {
  test(`straight lines are as straight as is said, within limits: ${JSON.stringify(limits)}`, () => {
    const state = { ...LINE, ...limits }, { designs } = asked(state, 40);
    assert.ok(designs.length > 0);
    checkLine(state, designs);
    const best = byProgram(problemOf(state, { starts: 40, designs: 3 })).designs[0].metrics.deviation;
    assert.ok(designs[0].rms <= (limits.class ? 1.01 : 3) * best, `${designs[0].rms} against ${best}`);
  });
}

test("a search for lines that begins with a design ends with none worse", () => {
  const row = ({ mechanism: m, crank_deg: cranks }) => [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point, m.assembly === "open" ? 1 : 0, 0, ...cranks];
  const found = asked(LINE, 20).designs, again = asked(LINE, 1, found.map(row)).designs;
  assert.ok(again[0].rms <= found[0].rms * (1 + 1e-3), `${again[0].rms} after ${found[0].rms}`);
});

test("what is no question about slider-cranks and lines is refused in a sentence", () => {
  const slider = problemOf(stroke(0), { starts: 5 }), line = problemOf(LINE, { starts: 5 });
  const wrong = [{ ...slider, target: {} }, { ...slider, target: { points: [[0, 0], [1, 1]] } }, { ...slider, constraints: { class: "crank-rocker" } }, { ...slider, known: [[1, 2, 3]] },
    { ...slider, mechanism: { type: "slider-crank", crank: 2 } }, { ...slider, bounds: { length: [3, 1] } }, { ...line, target: {} }, { ...line, target: { length: -1 } }, { ...line, target: { length: 3, points: [] } },
    { ...line, constraints: { size_over_length_max: 0 } }, { ...line, known: [[1, 2]] }, { ...line, bounds: { crank: [1, 2] } }];
  for (const question of wrong) {
    const { faults } = answer(question);
    assert.ok(faults?.length > 0 && faults.every((fault) => /\w+ .*\w/.test(fault)), `${JSON.stringify(question)}: ${faults}`);
  }
  // Points at one place have no size.
  const { designs } = answer({ ...slider, target: { ...slider.target, points: [[1, 1], [1, 1], [1, 1]] } });
  assert.deepEqual(designs, []);
});
