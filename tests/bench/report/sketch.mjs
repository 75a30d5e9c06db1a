// How long a hand waits for linkages in the page of `cognate sketch`, and their errors against those that the program
// finds by default. Usage: node sketch.mjs BUILD [DRAWINGS]
// BUILD: the folder of the build. Strokes are random sums of three harmonics, half of them open, with the tremor of a
// hand; poses, six to fifteen, lie on such with a direction that turns. Each is searched for as the page does, and solved
// by the program on one thread.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { gunzipSync } from "node:zlib";
import { encoded } from "../../../app/report/page/encoded.js";
import { problemOf, startsOf } from "../../../app/report/page/sketch/question.js";
import { problemToml } from "../../../app/report/page/toml.js";
import { harmonicStroke, randomNumbers } from "./drawings.mjs";

const [build, drawings = "100"] = process.argv.slice(2);
const POINTS = 24, SIZE = 100, NEAR = 1.01, DESIGNS = 8;
const random = randomNumbers();

// The states of the page with its limits at their defaults.
const state = { class: "any", least: 30, reach: 3 };
const curve = (i) => ({ ...state, angles: null, points: harmonicStroke(random, i % 2 === 0, SIZE, POINTS) });

function poses(i) {
  const points = harmonicStroke(random, i % 2 === 0, SIZE, 6 + (i % 10));
  let direction = 360 * random();
  return { ...state, points, angles: points.map(() => Math.round(direction += 60 * (random() - 0.3))) };
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
for (const [name, drawing] of [["curves", curve], ["poses", poses]]) {
  const rounds = startsOf(drawing(0)).map((starts) => ({ starts, seconds: [] }));
  const ratios = [], firsts = [], shares = [];
  for (let i = 0; i < Number(drawings); i += 1) {
    const drawn = drawing(i);
    const found = rounds.map(({ starts, seconds }) => {
      const { value, seconds: own } = timed(() => solve(problemOf(drawn, { starts, designs: DESIGNS })));
      seconds.push(own);
      return best(value);
    });
    const { error, seconds } = byProgram(problemOf(drawn, {}));
    shares.push(rounds[0].seconds.at(-1) / seconds);
    firsts.push(found[0] / error);
    ratios.push(Math.min(...found) / error);
  }
  console.log(`${ratios.length} ${name}`);
  for (const { starts, seconds } of rounds) console.log(`  ${starts} starts: median ${median(seconds).toFixed(2)} s, worst ${Math.max(...seconds).toFixed(2)} s of one core`);
  console.log(`  first answer in ${median(shares).toFixed(3)} of the time of the program's default search (median)`);
  for (const [which, all] of [["first", firsts], ["last", ratios]]) {
    console.log(`  ${which} error within 1 % of the program's: ${all.filter((ratio) => ratio <= NEAR).length} of ${all.length}; ratios: median ${median(all).toFixed(3)}, worst ${Math.max(...all).toFixed(2)}`);
  }
}
fs.rmSync(folder, { recursive: true });
