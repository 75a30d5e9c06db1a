// The search for generators of functions in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it.
import assert from "node:assert/strict";
import { seldom as test, some } from "./thinned.mjs";
import { randomNumbers } from "../bench/report/drawings.mjs";
import { generatedFunction } from "../bench/report/functions.mjs";
import { leadingQuestion, problemOf } from "../../app/report/page/sketch/question.js";
import { leastTransmission, rockerAngle } from "./closures.mjs";
import { answer } from "./sketch_kernel.mjs";

const LIMITS = { class: "any", least: 30, reach: 3 };
const barOf = ({ fixed_pivots: [a, d], crank, coupler, rocker, assembly }) => ({ a, d, crank, coupler, rocker, side: assembly === "open" ? 1 : -1 });
const asked = (state, starts = 128) => answer(problemOf(state, { starts, designs: 8 }));
const known = ({ mechanism: m, input_start_deg: input, output_start_deg: output }) => [m.crank, m.coupler, m.rocker, m.fixed_pivots[1][0], m.assembly === "open" ? 1 : 0, input, output];

// What is said of each design, by circles that meet.
function check({ points, least, reach, class: name }, designs) {
  for (const { mechanism, input_start_deg: input, output_start_deg: output, rms, max, class: said, transmission_acute_min_deg: angle, crank_deg: cranks } of designs) {
    const bar = barOf(mechanism), lengths = [bar.crank, bar.coupler, bar.rocker, bar.d[0] - bar.a[0]];
    const misses = points.map(([at, wanted]) => rockerAngle(bar, input + at) - output - wanted).map((miss) => miss - 360 * Math.round(miss / 360));
    assert.ok(Math.abs(Math.hypot(...misses) / Math.sqrt(misses.length) - rms) < 1e-9 && Math.abs(Math.max(...misses.map(Math.abs)) - max) < 1e-9, `${misses} against ${rms}, ${max}`);
    assert.ok(angle >= least - 1e-6 && Math.abs(leastTransmission(bar, cranks) - angle) < 1e-3, `${angle}`);
    assert.ok(Math.max(...lengths) / Math.min(...lengths) <= reach * (1 + 1e-6) && (name === "any" || said === name), `${lengths}, ${said}`);
  }
}

test("planted four-bars are found to rounding, and with noise as near as the noise", () => {
  const random = randomNumbers();
  for (const _ of some(Array(12).fill(0))) {
    for (const tremor of [0, 0.5]) {
      const state = { ...LIMITS, angles: null, ...generatedFunction(random, LIMITS, tremor) }, { designs } = asked(state);
      check(state, designs);
      assert.ok(designs[0].rms <= (tremor ? tremor / 2 : 1e-9), `${designs[0].rms} of ${JSON.stringify(state)}`);
    }
  }
});

const QUADRANT = { ...LIMITS, angles: null, ranges: [90, 60], points: Array.from({ length: 19 }, (_, i) => [5 * i, 60 * Math.sin((5 * i * Math.PI) / 180)]) };

for (const limits of [{}, { least: 50 }, { reach: 1.8 }, { class: "crank-rocker" }, { class: "double-crank", least: 0 }, { class: "triple-rocker", least: 40, reach: 5 }]) {
  test(`limits of functions are met: ${JSON.stringify(limits)}`, () => {
    const state = { ...QUADRANT, ...limits }, { designs } = asked(state);
    assert.ok(designs.length > 0);
    check(state, designs);
    assert.ok(designs[0].rms >= asked({ ...QUADRANT, least: 0, reach: 10 }).designs[0].rms * (1 - 1e-9));
  });
}

test("a search for functions that begins with designs ends with none worse", () => {
  const { designs } = asked(QUADRANT);
  const again = answer({ ...problemOf(QUADRANT, { starts: 1, designs: 8 }), known: designs.map(known) }).designs;
  assert.ok(again[0].rms <= designs[0].rms * (1 + 1e-6), `${again[0].rms} after ${designs[0].rms}`);
});

test("a generator follows by itself a pair that is moved", () => {
  const [before] = asked(QUADRANT).designs, moved = { ...QUADRANT, points: QUADRANT.points.with(4, [QUADRANT.points[4][0], QUADRANT.points[4][1] + 1]) };
  const { problem, known: row } = leadingQuestion(moved, { entry: before }), { designs } = answer({ ...problem, known: row });
  check(moved, designs);
  assert.ok(designs.length === 1 && designs[0].rms > before.rms, `${designs.length}`);
  const all = answer({ ...problemOf(moved, { starts: 128, designs: 8 }), known: row }).designs[0].rms;
  assert.ok(designs[0].rms < 1.5 * all, `${designs[0].rms} against ${all}`);
  assert.deepEqual(answer(problem).designs, []);
});

test("an expression has its values at equal steps", () => {
  const { values } = answer({ kind: "function-values", function: "x > 1 ? log10(x)^2 : sin(x) - atan2(1, x)", domain: [0, 3], samples: 7 });
  const expected = Array.from({ length: 7 }, (_, i) => i / 2).map((x) => (x > 1 ? Math.log10(x) ** 2 : Math.sin(x) - Math.atan2(1, x)));
  values.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-14, `${value} against ${expected[i]}`));
  assert.equal(values.length, 7);
});

test("what is no question about functions is refused in a sentence", () => {
  const values = { kind: "function-values", function: "x", domain: [0, 1], samples: 5 }, pairs = problemOf(QUADRANT, { starts: 5 });
  const wrong = [{ ...values, function: "y" }, { ...values, function: "sin(x" }, { ...values, function: "" }, { ...values, function: 3 }, { ...values, function: "1/x" }, { ...values, function: "sqrt(x - 0.5)" },
    { ...values, domain: [1, 1] }, { ...values, domain: [2, 1] }, { ...values, domain: [0, NaN] }, { ...values, domain: undefined }, { ...values, samples: 1 }, { ...values, samples: 1e6 }, { ...values, more: 1 },
    { ...pairs, target: {} }, { ...pairs, target: { pairs_deg: [[0, 0], [1, 1]] } }, { ...pairs, target: { pairs_deg: [[0, 0], [1, 1], [2, NaN]] } }, { ...pairs, target: { pairs_deg: [[0, 0], [1, 1], [2]] } },
    { ...pairs, known: [[1, 2, 3]] }, { ...pairs, known: [[1, 1, 1, 1, 1, 0, NaN]] }, { ...pairs, mechanism: { crank: 2 } }, { ...pairs, bounds: { crank: [1, 2] } }];
  for (const question of wrong) {
    const { faults } = answer(question);
    assert.ok(faults?.length > 0 && faults.every((fault) => /\w+ .*\w/.test(fault)), `${JSON.stringify(question)}: ${faults}`);
  }
  for (const length of [0, -3, 1e300]) {
    const { faults, designs } = answer({ ...pairs, known: [[1, length, 1, 1, 1, 0, 0]] });
    assert.ok(faults?.length > 0 || designs.every(({ rms }) => Number.isFinite(rms)), `${length}`);
  }
});
