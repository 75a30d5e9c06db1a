// How long a hand waits for linkages in the page of `cognate sketch`, and their errors against those that the program
// finds by default. Usage: node sketch.mjs BUILD [CURVES]
// BUILD: the folder of the build. Strokes are random sums of three harmonics, half of them open, with the tremor of a
// hand; each is searched with 60 starts and with 500, as the page does, and solved by the program on one thread.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { gunzipSync } from "node:zlib";
import { encoded } from "../../../app/report/page/encoded.js";
import { problemToml } from "../../../app/report/page/toml.js";

const [build, curves = "100"] = process.argv.slice(2);
const QUICK = 60, LONG = 500, POINTS = 24, TREMOR = 0.004, NEAR = 1.01;

// Numbers in [0, 1), the same in every run (Marsaglia's xorshift).
let state = 2463534242;
function random() {
  state ^= state << 13; state ^= state >>> 17; state ^= state << 5;
  return (state >>> 0) / 2 ** 32;
}

function stroke(closed) {
  const waves = [1, 2, 3].map((k) => ({ k, x: [random() - 0.5, random() - 0.5], y: [random() - 0.5, random() - 0.5], size: 100 / k ** 2.5 }));
  const span = closed ? 2 * Math.PI : Math.PI * (0.4 + 0.8 * random());
  const count = closed ? POINTS : POINTS - 1;
  const at = (t, key) => waves.reduce((sum, wave) => sum + wave.size * (wave[key][0] * Math.cos(wave.k * t) + wave[key][1] * Math.sin(wave.k * t)), 0);
  return Array.from({ length: POINTS }, (_, i) => ["x", "y"].map((key) => at((span * i) / count, key) + 100 * TREMOR * (random() - 0.5)));
}

// The problem of the page with its limits at their defaults.
function problemOf(points, solve) {
  const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
  const [low, high] = [[Math.min(...xs), Math.min(...ys)], [Math.max(...xs), Math.max(...ys)]];
  const size = Math.hypot(high[0] - low[0], high[1] - low[1]);
  const within = [-1, 1].map((side) => [0, 1].map((axis) => (low[axis] + high[axis]) / 2 + side * 1.5 * size));
  return { kind: "path-generation", target: { points, timing: "free", order: "cyclic" },
    bounds: { length: [0.02 * size, 3 * size], pivot_a: within, pivot_d: within }, constraints: { transmission_angle_deg: [30, 150] }, solve };
}

async function kernelOf(base64) {
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
function timed(work) {
  const start = process.cpuUsage();
  const value = work();
  const { user, system } = process.cpuUsage(start);
  return { value, seconds: (user + system) / 1e6 };
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-sketch-"));
// Error and seconds of the program's search.
function byProgram(problem) {
  const file = path.join(folder, "sketch.toml");
  fs.writeFileSync(file, problemToml(problem));
  try {
    const result = JSON.parse(execFileSync(path.join(build, "app/cognate"), ["solve", "--json", "--threads", "1", file], { maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"] }));
    return { error: result.designs[0].error.rms, seconds: result.work.seconds };
  } catch { return { error: Infinity, seconds: NaN }; }
}

const best = ({ designs = [] }) => Math.min(Infinity, ...designs.map(({ rms }) => rms));
const sorted = (values) => [...values].sort((a, b) => a - b);
const median = (values) => sorted(values)[values.length >> 1];

const solve = await kernelOf(fs.readFileSync(path.join(build, "app/report/sketch_kernel.base64"), "utf8"));
const quick = [], long = [], ratios = [], shares = [];
for (let i = 0; i < Number(curves); i += 1) {
  const drawing = stroke(i % 2 === 0);
  const first = timed(() => solve(problemOf(drawing, { starts: QUICK })));
  const second = timed(() => solve(problemOf(drawing, { starts: LONG })));
  quick.push(first.seconds);
  long.push(second.seconds);
  const { error, seconds } = byProgram(problemOf(drawing, {}));
  shares.push(first.seconds / seconds);
  ratios.push(Math.min(best(first.value), best(second.value)) / error);
}
fs.rmSync(folder, { recursive: true });
const near = ratios.filter((ratio) => ratio <= NEAR).length;
console.log(`${quick.length} curves`);
console.log(`${QUICK} starts: median ${median(quick).toFixed(2)} s, worst ${Math.max(...quick).toFixed(2)} s of one core`);
console.log(`${LONG} starts: median ${median(long).toFixed(2)} s, worst ${Math.max(...long).toFixed(2)} s`);
console.log(`first answer in ${median(shares).toFixed(3)} of the time of the program's default search (median)`);
console.log(`error within 1 % of the program's: ${near} of ${ratios.length}; ratios: median ${median(ratios).toFixed(3)}, worst ${Math.max(...ratios).toFixed(2)}`);
console.log(sorted(ratios).slice(-8).map((r) => r.toFixed(3)).join(" "));
