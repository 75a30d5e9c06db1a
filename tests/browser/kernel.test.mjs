// The kernel in the report pages against the program: the same linkages, the same numbers.
// KERNEL: the module in base64; CASES: what the program says.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { Kernel } from "../../app/report/page/kernel.js";

const cases = JSON.parse(fs.readFileSync(process.env.CASES, "utf8"));
const kernel = await Kernel.load(fs.readFileSync(process.env.KERNEL, "utf8"));

const TOLERANCE = 1e-9;
const near = (a, b, what) => assert.ok(a === b || Math.abs(a - b) <= TOLERANCE, `${what}: ${a} and ${b}`);
const nearAngle = (a, b, what) => near(Math.sin((a - b) / 2), 0, what);
const eachNear = (a, b, what) => { assert.equal(a.length, b.length, what); a.forEach((x, i) => near(x, b[i], what)); };

test("class, transmission, time ratio and defects are the program's", () => {
  const seen = new Set();
  for (const [i, c] of cases.entries()) {
    assert.ok(kernel.take(c.mechanism));
    const facts = kernel.facts(c.cranks, [], c.sequence);
    assert.equal(facts.class, c.class);
    assert.equal(facts.rotates, c.rotates);
    for (const key of ["least", "greatest", "acute"]) near(facts[key], c[key], `${key} of case ${i}`);
    near(facts.timeRatio, c.time_ratio, `time ratio of case ${i}`);
    assert.deepEqual(facts.defects, c.defects, `case ${i}`);
    seen.add(`${c.class} ${c.defects.length > 0}`);
  }
  assert.equal(seen.size, 10, "every class, with defects and without");
});

test("positions are the program's", () => {
  let [closed, open] = [0, 0];
  for (const [i, c] of cases.entries()) {
    kernel.take(c.mechanism);
    kernel.poses(c.cranks).forEach((pose, k) => {
      const wanted = c.poses[k];
      assert.equal(pose === null, wanted === null, `case ${i}`);
      if (pose === null) { open += 1; return; }
      closed += 1;
      for (const key of ["b", "c", "p"]) eachNear(pose[key], wanted[key], `${key} of case ${i}`);
      nearAngle(pose.rocker, wanted.rocker, `rocker of case ${i}`);
      near(pose.transmission, wanted.transmission, `transmission of case ${i}`);
    });
  }
  assert.ok(closed > 3000 && open > 1000);
});

test("the motion drawn is the program's", () => {
  assert.ok(cases.length > 100, `${cases.length} cases`);
  for (const [i, c] of cases.entries()) {
    kernel.take(c.mechanism);
    const { crank_deg: cranks, rocker_deg: rockers } = kernel.motion(c.cranks, 31);
    const degrees = (list) => list.map((angle) => (angle * 180) / Math.PI);
    eachNear(cranks, degrees(c.motion.crank), `crank of case ${i}`);
    // At the ends of a range the rocker moves as the square root of the crank.
    rockers.forEach((rocker, k) => assert.ok(Math.abs(rocker - degrees(c.motion.rocker)[k]) < 1e-4, `rocker of case ${i}`));
  }
});

// Distances to a target along the whole turn, finely; none may be below what the kernel calls nearest.
test("the nearest place of the curve is nearest", () => {
  for (const c of cases.slice(0, 100)) {
    kernel.take(c.mechanism);
    const target = { at: [0.3, 0.7], crank: 0, prescribed: false };
    const { near: [local], anywhere: [least] } = kernel.nearest([target]);
    const distance = (pose) => (pose ? Math.hypot(pose.p[0] - 0.3, pose.p[1] - 0.7) : Infinity);
    const all = kernel.poses(Array.from({ length: 3600 }, (_, k) => (k * Math.PI) / 1800)).map(distance);
    const [found, downhill, start] = kernel.poses([least, local, 0]).map(distance);
    assert.ok(found <= Math.min(...all) + 2e-2);
    assert.ok(downhill <= start);
    const [before, after] = kernel.poses([least - 1e-4, least + 1e-4]).map(distance);
    assert.ok(found <= before + 1e-12 && found <= after + 1e-12);
  }
});

test("what is no linkage is refused", () => {
  const { mechanism } = cases[0];
  for (const wrong of [{ crank: 0 }, { crank: -1 }, { rocker: Number.NaN }, { coupler: 1e9 }, { fixed_pivots: [[1, 2], [1, 2]] }]) {
    assert.equal(kernel.take({ ...mechanism, ...wrong }), false);
  }
  assert.equal(kernel.take(mechanism), true);
});
