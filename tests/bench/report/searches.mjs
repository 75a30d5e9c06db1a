// What the measurements of the page of `cognate sketch` have in common: drawings, its search, and the program's.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { gunzipSync } from "node:zlib";
import { encoded } from "../../../app/report/page/encoded.js";
import { problemToml } from "../../../app/report/page/toml.js";
import { strokeTargets } from "../../../app/report/page/sketch/stroke.js";
import { drawnLetterStroke, harmonicStroke, randomNumbers } from "./drawings.mjs";
import { drawnFunction } from "./functions.mjs";

const POINTS = 24, SIZE = 100;
const random = randomNumbers();

// The states of the page with its limits at their defaults.
const state = { class: "any", least: 30, reach: 3, region: null };
const curve = (i) => ({ ...state, angles: null, points: harmonicStroke(random, i % 2 === 0, SIZE, POINTS) });

function poses(i) {
  const points = harmonicStroke(random, i % 2 === 0, SIZE, 6 + (i % 10));
  let direction = 360 * random();
  return { ...state, points, angles: points.map(() => Math.round(direction += 60 * (random() - 0.3))) };
}

// As the page makes targets of strokes on its sheet.
const letters = (i) => ({ ...state, angles: null, ...strokeTargets(drawnLetterStroke(i)[0].map(([x, y]) => [120 * (x - 0.5), 84 * (0.5 - y)])) });

const functions = (i) => drawnFunction(random, i, state);

const sliders = (i) => ({ ...curve(i), closed: i % 2 === 0, slides: true });

// Lines differ by what limits them: all else is a matter of scale.
function lines(i) {
  const limits = { class: ["any", "crank-rocker", "double-rocker", "triple-rocker"][i % 4], least: 20 + Math.round(30 * random()), reach: 1.5 + Math.round(25 * random()) / 10 };
  return { ...state, ...limits, angles: null, straight: true, points: [[-SIZE / 4, 0], [SIZE / 4, SIZE / 10]] };
}

// Their pivots stand in a box on either side of the line.
function boxedLines(i) {
  const side = i % 2 === 0 ? 1 : -1, [left, width, gap, height] = [-SIZE * (0.2 + 0.4 * random()), SIZE * (0.5 + 0.4 * random()), SIZE * 0.2 * random(), SIZE * (0.35 + 0.35 * random())];
  const across = [side * gap, side * (gap + height)].sort((p, q) => p - q);
  return { ...lines(i), class: i % 3 === 0 ? "crank-rocker" : "any", region: [[left, across[0]], [left + width, across[1]]] };
}

export const DRAWINGS = [["curves", curve], ["letters", letters], ["poses", poses], ["functions", functions], ["slider-cranks", sliders], ["lines", lines], ["boxed-lines", boxedLines]];

// The search in the page of a build in the folder `build`.
export async function searchOf(build) {
  const base64 = fs.readFileSync(path.join(build, "app/report/sketch_kernel.base64"), "utf8");
  const { instance } = await WebAssembly.instantiate(gunzipSync(Buffer.from(base64, "base64")));
  const calls = instance.exports;
  calls._initialize?.();
  return (problem) => {
    const numbers = [];
    const text = new TextEncoder().encode(encoded(problem, numbers));
    const at = calls.room(text.length);
    new Float64Array(calls.memory.buffer, calls.numbers(), numbers.length).set(numbers);
    new Uint8Array(calls.memory.buffer, at, text.length).set(text);
    const length = calls.sketch(1);
    return JSON.parse(new TextDecoder().decode(new Uint8Array(calls.memory.buffer, calls.text(), length)));
  };
}

// Seconds of processor time, so that what else the machine does counts little.
export function timed(work) {
  const start = process.cpuUsage();
  const value = work();
  const { user, system } = process.cpuUsage(start);
  return { value, seconds: (user + system) / 1e6 };
}

// Error and seconds of the search of the program in `build`; that of functions is in degrees, as in the page.
export function byProgram(build, problem) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-sketch-")), file = path.join(folder, "sketch.toml");
  fs.writeFileSync(file, problemToml(problem));
  try {
    const result = JSON.parse(execFileSync(path.join(build, "app/cognate"), ["solve", "--json", "--threads", "1", file], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] }));
    const unit = problem.kind === "function-generation" ? 180 / Math.PI : 1;
    const [{ error, metrics }] = result.designs;
    return { error: problem.kind === "straight-line" ? metrics.deviation : unit * error.rms, seconds: result.work.seconds };
  } catch { return { error: Infinity, seconds: NaN }; } finally { fs.rmSync(folder, { recursive: true }); }
}

const sorted = (values) => [...values].sort((a, b) => a - b);
export const median = (values) => sorted(values)[values.length >> 1];
