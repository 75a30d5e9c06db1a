// The search in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it.
import assert from "node:assert/strict";
import { seldom as test, some, wholeOnly } from "./thinned.mjs";
import { Candidate } from "../../app/report/page/sketch/candidate.js";
import { Front } from "../../app/report/page/sketch/front.js";
import { leadingQuestion, problemOf } from "../../app/report/page/sketch/question.js";
import { clearanceOf, couplerPose, leastTransmission } from "./closures.mjs";
import { answer } from "./sketch_kernel.mjs";

const POSES = [[0, 0, 0], [10, 5, 20], [22, 8, 50], [30, 2, 80], [35, -8, 100], [36, -20, 140]];
const state = (poses) => ({ class: "any", least: 30, reach: 3, region: null, points: poses.map(([x, y]) => [x, y]), angles: poses.map((pose) => pose[2]) });
const known = ({ mechanism: m, body_angle_deg: body = 0, crank_deg: cranks }) => [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point, m.assembly === "open" ? 1 : 0, body, ...cranks];

const CURVE = [[0, 0], [10, 10], [25, 12], [35, 5], [30, -8], [15, -10], [4, -9], [-3, -4], [5, 3], [14, 14], [31, 11], [36, -3]];

test("a search that begins with a design ends with none worse", () => {
  for (const drawing of some([state(POSES), { ...state(POSES), points: CURVE, angles: null }])) {
    const found = answer(problemOf(drawing, { starts: 200, designs: 8 })).designs;
    const again = answer({ ...problemOf(drawing, { starts: 1, designs: 8 }), known: found.map(known) }).designs;
    assert.ok(found[0].rms > 1e-3);
    assert.ok(again[0].rms <= found[0].rms * (1 + 1e-6), `${again[0].rms} after ${found[0].rms}`);
    const one = answer(problemOf(drawing, { starts: 1, designs: 8 })).designs[0];
    assert.ok(!one || one.rms > found[0].rms * 1.01);
  }
});

// The front of a drawing as the page searches for it, and how many questions that took.
function frontOf(drawing) {
  const front = new Front();
  front.follow(drawing);
  let asked = 0;
  for (; !front.ended; asked += 1) {
    const { problem, known } = front.question;
    front.take((answer(known.length ? { ...problem, known } : problem).designs ?? []).map((entry) => new Candidate(entry)));
  }
  return { front, asked };
}

const barOf = ({ fixed_pivots: [a, d], crank, coupler, rocker, coupler_point: [u, v], assembly }) => ({ a, d, crank, coupler, rocker, u, v, side: assembly === "open" ? 1 : -1 });

// The root mean square error of a design at the angles of its crank; a radian of a body counts as in the files.
function errorOf({ points, angles }, { mechanism, crank_deg: cranks, body_angle_deg: body }) {
  const mean = [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  const weight = Math.hypot(...points.map((p) => Math.hypot(p[0] - mean[0], p[1] - mean[1]))) / Math.sqrt(points.length);
  const misses = points.map((p, i) => {
    const { at, direction } = couplerPose(barOf(mechanism), (cranks[i] * Math.PI) / 180);
    const turned = angles ? direction + ((body - angles[i]) * Math.PI) / 180 : 0;
    return Math.hypot(at[0] - p[0], at[1] - p[1], weight * Math.atan2(Math.sin(turned), Math.cos(turned)));
  });
  return Math.hypot(...misses) / Math.sqrt(misses.length);
}

for (const [name, drawing] of [["poses", state(POSES)], ["a curve", { ...state(POSES), points: CURVE, angles: null }]]) {
  test(`a design of ${name} follows by itself a target that is moved`, () => {
    const [before] = answer(problemOf(drawing, { starts: 200, designs: 8 })).designs;
    const moved = { ...drawing, points: drawing.points.with(2, [drawing.points[2][0] + 0.5, drawing.points[2][1] - 0.4]) };
    const { problem, known: row } = leadingQuestion(moved, { entry: before }), { designs } = answer({ ...problem, known: row });
    assert.equal(designs.length, 1);
    const [after] = designs, own = errorOf(moved, after), stayed = errorOf(moved, before);
    assert.ok(Math.abs(own - after.rms) < 1e-6 * own && own < stayed, `${own}, said to be ${after.rms}, against ${stayed}`);
    assert.ok(leastTransmission(barOf(after.mechanism), after.crank_deg) >= 30 - 1e-3);
    const far = ({ mechanism: m }) => [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point];
    far(after).forEach((x, i) => assert.ok(Math.abs(x - far(before)[i]) < 8, `${far(after)} against ${far(before)}`));
    assert.deepEqual(answer(problem).designs, []);
  });

  wholeOnly(`the front of ${name} rises, and circles that meet measure its designs alike`, () => {
    const { front: { points }, asked } = frontOf(drawing);
    assert.ok(points.length >= 5 && asked < 30, `${points.length} points after ${asked}`);
    points.forEach(({ candidate: { entry }, level, angle, error }, i) => {
      assert.ok(i === 0 || (angle > points[i - 1].angle && error > points[i - 1].error), `${angle}: ${error}`);
      assert.ok(angle >= level - 1e-6 && error === entry.rms);
      const measured = leastTransmission(barOf(entry.mechanism), entry.crank_deg);
      assert.ok(Math.abs(measured - angle) < 1e-3, `${measured} against ${angle}`);
      assert.ok(Math.abs(errorOf(drawing, entry) - error) < 1e-6 * error);
    });
    // No search for one bound alone, of twice as many starts, finds much better.
    for (const level of [20, 50]) {
      const { error } = points.find((point) => point.level >= level);
      const alone = answer(problemOf({ ...drawing, least: level }, { starts: 1000, designs: 8 })).designs[0].rms;
      assert.ok(error <= 1.01 * alone, `${error} against ${alone} from ${level}`);
    }
  });
}

test("a front goes on where only its bound changes, else begins anew", () => {
  const { front } = frontOf({ ...state(POSES.slice(0, 3)) });
  const [only, ...others] = front.points;
  assert.ok(only.error === 0 && only.level === 70 && others.length === 0);
  front.follow({ ...state(POSES.slice(0, 3)), least: 50 });
  assert.ok(front.ended && front.within(50).every(({ entry }) => entry.transmission_acute_min_deg >= 50 - 1e-6) && front.within(50).includes(only.candidate));
  for (const other of [{ class: "double-crank" }, { reach: 5 }, { region: [[0, 0], [9, 9]] }, { angles: [0, 20, 51] }]) {
    front.follow({ ...state(POSES.slice(0, 3)), ...other });
    assert.ok(!front.ended && front.points.length === 0, JSON.stringify(other));
  }
});

for (const [name, drawing, obstacle] of [["poses", state(POSES), [[5, 15], [25, 40]]], ["a curve", { ...state(POSES), points: CURVE, angles: null }, [[-10, -30], [40, -14]]]]) {
  wholeOnly(`joints and the point of the designs for ${name} stay out of a box over the whole turn`, () => {
    const free = { ...drawing, class: "crank-rocker", least: 10 };
    const designs = (kept) => answer(problemOf({ ...free, obstacle: kept }, { starts: 200, designs: 8 })).designs;
    const far = designs(obstacle).map(({ mechanism }) => clearanceOf(barOf(mechanism), obstacle));
    assert.ok(far.length > 0 && far.every((distance) => distance > -1e-4), `${far}`);
    // Without the limit some would come into it.
    assert.ok(designs(null).some(({ mechanism }) => clearanceOf(barOf(mechanism), obstacle) < -1));
  });
}

test("a box is refused beside a class whose crank does not turn fully", () => {
  const { faults } = answer(problemOf({ ...state(POSES), obstacle: [[0, 0], [9, 9]] }, { starts: 5 }));
  assert.ok(faults.some((fault) => /full turn of the crank/.test(fault)), `${faults}`);
});

test("what is no question is refused in a sentence", () => {
  const poses = { kind: "motion-generation", target: { poses: POSES }, solve: { starts: 5 } };
  const row = [0, 0, 40, 0, 10, 30, 30, 5, 5, 1, 0];
  const wrong = [{}, { kind: "cam" }, { kind: 3 }, { kind: "motion-generation" }, { kind: "motion-generation", target: {} }, { kind: "path-generation" },
    { kind: "path-generation", target: { points: [[0, 0], [1, 1]] } }, { ...poses, target: { poses: POSES.slice(0, 1) } }, { ...poses, target: { poses: [[0, 0], [1, 1]] } },
    { ...poses, target: { poses: POSES, angle_weight: -1 } }, { ...poses, target: { poses: [...POSES, [NaN, 0, 0]] } }, { ...poses, known: [[1, 2, 3]] }, { ...poses, known: [[...row, 0]] },
    { ...poses, known: [[...row, 0, 10, 20, 30, 40, NaN]] }, { ...poses, limits: 3 }, { ...poses, known_alone: 1 }];
  for (const question of wrong) {
    const { faults } = answer(question);
    assert.ok(faults?.length > 0 && faults.every((fault) => /\w+ .*\w/.test(fault)), `${JSON.stringify(question)}: ${faults}`);
  }
  // What lengths of no linkage cannot begin is left out or refused.
  for (const length of [0, -3, 1e300]) {
    const bad = [...row, 0, 10, 20, 30, 40, 50];
    bad[4] = length;
    const { faults, designs } = answer({ ...poses, known: [bad] });
    assert.ok(faults?.length > 0 || designs.every(({ rms }) => Number.isFinite(rms)), `${length}`);
  }
});
