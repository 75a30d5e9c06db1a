// What is taken along of the pages for CAD, read by another program. PYTHON: an interpreter, perhaps with ezdxf.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { distance } from "./browser.mjs";
import { moving, visit as visitBuilt } from "./building.mjs";
import { couplerPose, sliderPose } from "./closures.mjs";
import { wholeOnly } from "./thinned.mjs";
import { addressOf, draw, offered, settled, visit } from "./sketching.mjs";

const RADIANS = Math.PI / 180;
const READER = path.join(path.dirname(fileURLToPath(import.meta.url)), "read_dxf.py");
const ellipse = (t) => [0.5 + 0.15 * Math.cos(t), 0.45 - 0.2 * Math.sin(t)];

// The drawing that the page saves, by its layers; null where nothing reads it.
async function savedDrawing(page) {
  const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("[data-save=drawing]").click()]);
  assert.match(saved.suggestedFilename(), /\.dxf$/);
  const drawing = JSON.parse(execFileSync(process.env.PYTHON, [READER, await saved.path()], { encoding: "utf8" }));
  if (!drawing) return null;
  assert.deepEqual(drawing.faults, []);
  return drawing.shapes.reduce((layers, one) => ({ ...layers, [one.layer]: [...(layers[one.layer] ?? []), one] }), {});
}

// The greatest distance of `places` from the lines of an outline.
function farthest(places, { points, closed }) {
  const ends = points.map((p, i) => [p, points[(i + 1) % points.length]]).slice(0, closed ? undefined : -1);
  const toLine = (at, [p, q]) => {
    const way = [q[0] - p[0], q[1] - p[1]], long = way[0] ** 2 + way[1] ** 2, share = Math.max(0, Math.min(1, ((at[0] - p[0]) * way[0] + (at[1] - p[1]) * way[1]) / (long || 1)));
    return Math.hypot(p[0] + share * way[0] - at[0], p[1] + share * way[1] - at[1]);
  };
  return Math.max(...places.map((at) => Math.min(...ends.map((line) => toLine(at, line)))));
}

const named = ({ LABELS, JOINTS, POINTS = [] }, name) => {
  const { at } = LABELS.find(({ text }) => text === name);
  return [...JOINTS, ...POINTS].map((one) => one.at).toSorted((p, q) => distance(p, at) - distance(q, at))[0];
};

test("a four-bar that is drawn for", () => visit({}, async (page) => {
  await draw(page, ellipse);
  await offered(page);
  // A longer search may answer meanwhile.
  let address, drawing;
  do {
    address = page.url();
    drawing = await savedDrawing(page);
  } while (page.url() !== address);
  const design = addressOf(page);
  if (!drawing) return;
  const [a, b, c, d] = ["A", "B", "C", "D"].map((name) => named(drawing, name));
  for (const [p, q, length] of [[a, b, design.crank], [b, c, design.coupler], [c, d, design.rocker], [a, design.a, 0], [d, design.d, 0]]) assert.ok(Math.abs(distance(p, q) - length) < 1e-5, `${p} ${q}`);
  assert.deepEqual(drawing.TARGET.map(({ at }) => at.map((x) => Number(x.toFixed(6)))), design.points.map((at) => at.map((x) => Number(x.toFixed(6)))));
  const [curve] = drawing.PATHS, exact = Array.from({ length: 997 }, (_, i) => couplerPose(design, (2 * Math.PI * i) / 997).at);
  assert.ok(curve.closed && farthest(exact, curve) < 1e-3, `${farthest(exact, curve)}`);
  assert.equal(drawing.FRAME.length, 2);
}));

wholeOnly("a slider-crank that is drawn for", () => visit({}, async (page) => {
  await page.locator("#by-slider").click();
  await draw(page, ellipse);
  await settled(page);
  const [numbers, assembly, , turns] = decodeURIComponent(page.url()).match(/[#&]d=([^&]*)/)[1].split(";"), [ax, ay, crank, coupler, offset, u, v] = numbers.split(",").map(Number), [direction] = turns.split(",").map(Number);
  const slider = { a: [ax, ay], crank, coupler, offset, direction, u, v, ahead: assembly === "open" ? 1 : -1 }, drawing = await savedDrawing(page);
  if (!drawing) return;
  const exact = Array.from({ length: 997 }, (_, i) => sliderPose(slider, (2 * Math.PI * i) / 997)), [guide] = drawing.GUIDES;
  assert.ok(farthest(exact.map(({ at }) => at), drawing.PATHS[0]) < 1e-3);
  assert.ok(farthest(exact.map(({ c }) => c), guide) < 1e-5, "the slider stays on its guide");
  const way = guide.points[1].map((x, k) => x - guide.points[0][k]);
  assert.ok(Math.abs(Math.sin(Math.atan2(way[1], way[0]) - direction * RADIANS)) < 1e-6);
  assert.equal(drawing.FRAME.length, 1);
}));

wholeOnly("a linkage for a function is drawn without its diagram", () => visit({}, async (page) => {
  await page.locator("#of-function").click();
  await page.locator("#plot").click();
  await settled(page);
  const drawing = await savedDrawing(page);
  if (!drawing) return;
  assert.deepEqual(Object.keys(drawing).toSorted(), ["FRAME", "JOINTS", "LABELS", "LINKS"]);
  assert.equal(drawing.JOINTS.length, 4);
}));

test("a mechanism that is built", () => visitBuilt({}, async (page) => {
  await page.locator("[data-example=quick_return]").click();
  await moving(page);
  const drawing = await savedDrawing(page);
  if (!drawing) return;
  const names = drawing.LABELS.map(({ text }) => text).toSorted();
  const joints = await page.locator("#lists [data-row^='joint.'] input[type=text]").evaluateAll((all) => all.map(({ value }) => value));
  assert.deepEqual(names, joints.toSorted());
  assert.equal(drawing.JOINTS.length + (drawing.POINTS?.length ?? 0), names.length);
  assert.ok(drawing.LINKS.length >= 4 && drawing.GUIDES.length >= 1 && drawing.PATHS.length >= 2);
  // Every joint that moves is on its path.
  const moved = names.map((name) => named(drawing, name)).filter((at) => drawing.PATHS.some((curve) => farthest([at], curve) < 0.05));
  assert.ok(moved.length >= 3, `${moved.length}`);
}));

test("there is nothing to draw before a design is found", () => visit({}, async (page) => {
  await page.locator("[data-save=drawing]").click();
  assert.equal(await page.locator(".design-card").count(), 0);
}));
