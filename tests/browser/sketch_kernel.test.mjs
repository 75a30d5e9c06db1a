// The search in the page of `cognate sketch` without a page. KERNEL: its module, as the page holds it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";
import { encoded } from "../../app/report/page/encoded.js";
import { problemOf } from "../../app/report/page/sketch/question.js";

const { instance: { exports: calls } } = await WebAssembly.instantiate(gunzipSync(Buffer.from(readFileSync(process.env.KERNEL, "utf8"), "base64")));
calls._initialize?.();

function answer(question) {
  const numbers = [], text = new TextEncoder().encode(encoded(question, numbers)), at = calls.room(text.length);
  new Float64Array(calls.memory.buffer, calls.numbers(), numbers.length).set(numbers);
  new Uint8Array(calls.memory.buffer, at, text.length).set(text);
  const length = calls.sketch(1);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(calls.memory.buffer, calls.text(), length)));
}

const POSES = [[0, 0, 0], [10, 5, 20], [22, 8, 50], [30, 2, 80], [35, -8, 100], [36, -20, 140]];
const state = (poses) => ({ class: "any", least: 30, reach: 3, points: poses.map(([x, y]) => [x, y]), angles: poses.map((pose) => pose[2]) });
const known = ({ mechanism: m, body_angle_deg: body = 0, crank_deg: cranks }) => [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point, m.assembly === "open" ? 1 : 0, body, ...cranks];

test("a search that begins with a design ends with none worse", () => {
  const points = [[0, 0], [10, 10], [25, 12], [35, 5], [30, -8], [15, -10], [4, -9], [-3, -4], [5, 3], [14, 14], [31, 11], [36, -3]];
  for (const drawing of [state(POSES), { ...state(POSES), points, angles: null }]) {
    const found = answer(problemOf(drawing, { starts: 200, designs: 8 })).designs;
    const again = answer({ ...problemOf(drawing, { starts: 1, designs: 8 }), known: found.map(known) }).designs;
    assert.ok(found[0].rms > 1e-3);
    assert.ok(again[0].rms <= found[0].rms * (1 + 1e-6), `${again[0].rms} after ${found[0].rms}`);
    const one = answer(problemOf(drawing, { starts: 1, designs: 8 })).designs[0];
    assert.ok(!one || one.rms > found[0].rms * 1.01);
  }
});

test("what is no question is refused in a sentence", () => {
  const poses = { kind: "motion-generation", target: { poses: POSES }, solve: { starts: 5 } };
  const row = [0, 0, 40, 0, 10, 30, 30, 5, 5, 1, 0];
  const wrong = [{}, { kind: "cam" }, { kind: 3 }, { kind: "motion-generation" }, { kind: "motion-generation", target: {} }, { kind: "path-generation" },
    { kind: "path-generation", target: { points: [[0, 0], [1, 1]] } }, { ...poses, target: { poses: POSES.slice(0, 1) } }, { ...poses, target: { poses: [[0, 0], [1, 1]] } },
    { ...poses, target: { poses: POSES, angle_weight: -1 } }, { ...poses, target: { poses: [...POSES, [NaN, 0, 0]] } }, { ...poses, known: [[1, 2, 3]] }, { ...poses, known: [[...row, 0]] },
    { ...poses, known: [[...row, 0, 10, 20, 30, 40, NaN]] }, { ...poses, limits: 3 }];
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
