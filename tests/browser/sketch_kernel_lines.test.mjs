// The search for straight lines in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it.
import assert from "node:assert/strict";
import { seldom as test, some } from "./thinned.mjs";
import { Candidate } from "../../app/report/page/sketch/candidate.js";
import { leadingQuestion, problemOf } from "../../app/report/page/sketch/question.js";
import { couplerPose } from "./closures.mjs";
import { answer } from "./sketch_kernel.mjs";

const RADIANS = Math.PI / 180, FINE = 2000;
const LINE = { class: "any", least: 30, reach: 3, even: 100, region: null, obstacle: null, straight: true, angles: null, ranges: null, points: [[-20, 5], [18, -7]] };
// Above the line, below it, beside its ends, and a strip.
const REGIONS = [[[-30, 10], [30, 42]], [[-30, -42], [30, -15]], [[25, -30], [60, 30]], [[-60, -12], [60, -10]]];

const barOf = ({ fixed_pivots: [a, d], crank, coupler, rocker, coupler_point: [u, v], assembly }) => ({ a, d, crank, coupler, rocker, u, v, side: assembly === "open" ? 1 : -1 });

// The point goes from end to end as straight as is said, and the pivots stand in the region.
function check({ points: [p, q], region }, { mechanism, crank_deg: [from, , to], rms }) {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]), e = [0, 1].map((k) => (q[k] - p[k]) / length), bar = barOf(mechanism);
  const places = Array.from({ length: FINE + 1 }, (_, i) => couplerPose(bar, (from + ((to - from) * i) / FINE) * RADIANS).at.map((x, k) => x - p[k]));
  const along = places.map(([x, y]) => x * e[0] + y * e[1]), across = places.map(([x, y]) => Math.abs(y * e[0] - x * e[1]));
  const ends = [along[0], along.at(-1)].sort((a, b) => a - b);
  assert.ok(Math.abs(ends[0]) < 1e-4 && Math.abs(ends[1] - length) < 1e-4, `${ends} of ${length}`);
  assert.ok(Math.abs(Math.max(...across) - rms) <= 0.01 * rms + 1e-8, `${Math.max(...across)} against ${rms}`);
  for (const pivot of mechanism.fixed_pivots) for (const k of [0, 1]) assert.ok(pivot[k] >= region[0][k] - 1e-6 && pivot[k] <= region[1][k] + 1e-6, `${pivot} in ${JSON.stringify(region)}`);
}

test("pivots of a line stand in each region, and designs that are known stay", () => {
  for (const region of some(REGIONS)) {
    const state = { ...LINE, region }, { designs } = answer(problemOf(state, { starts: 120, designs: 4 }));
    assert.ok(designs?.length > 0, JSON.stringify(region));
    for (const design of designs) check(state, design);
    // From the best of them alone, as while a hand drags.
    const { problem, known } = leadingQuestion(state, new Candidate(designs[0])), { designs: [again] } = answer({ ...problem, known });
    check(state, again);
    assert.ok(again.rms <= designs[0].rms * (1 + 1e-3), `${again.rms} after ${designs[0].rms}`);
  }
});

test("an end that is moved a little takes the design along, within its region", () => {
  const state = { ...LINE, region: REGIONS[1] }, [design] = answer(problemOf(state, { starts: 120, designs: 4 })).designs;
  const moved = { ...state, points: [LINE.points[0], [19, -5]] }, { problem, known } = leadingQuestion(moved, new Candidate(design));
  const [followed] = answer({ ...problem, known }).designs;
  check(moved, followed);
});

test("what is no line is refused in words", () => {
  const problem = problemOf(LINE, { starts: 5, designs: 1 });
  for (const target of [{}, { ends: [[0, 0]] }, { ends: [[1, 1], [1, 1]] }, { ends: [[0, 0], [3, 4]], length: 6 }, { length: 3 }]) {
    const { faults } = answer({ ...problem, target });
    assert.ok(faults?.length > 0 && faults.every((fault) => /\w+ .*\w/.test(fault)), `${JSON.stringify(target)}: ${faults}`);
  }
});
