// What the kernel compiled to WebAssembly costs a report page, beside the small script that draws the
// linkage of a study. Usage: node kernel.mjs BUILD [CASES.json]
// BUILD: the folder of the build; CASES: what kernel_cases prints, to measure errors by.
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { angleAt } from "../../../app/report/page/design/linkage.js";
import { Kernel } from "../../../app/report/page/kernel.js";
import { Closure } from "../../../app/report/page/study/closure.js";

const [build, cases] = process.argv.slice(2);
const base64 = fs.readFileSync(path.join(build, "app/report/kernel.base64"), "utf8");

// The median of `count` times in microseconds.
async function microseconds(count, work) {
  const times = [];
  for (let i = 0; i < count; i += 1) {
    const start = performance.now();
    await work();
    times.push(1000 * (performance.now() - start));
  }
  return times.sort((a, b) => a - b)[count >> 1];
}

const linkage = { fixed_pivots: [[0, 0], [4, 0.5]], crank: 1, coupler: 3.4, rocker: 2.6, assembly: "open", coupler_point: [1.6, 1.3] };
const cranks = Array.from({ length: 361 }, (_, i) => (i * Math.PI) / 180);
const kernel = await Kernel.load(base64);

function byScript() {
  const closure = new Closure(linkage);
  return cranks.map((crank) => {
    const pose = closure.at(crank - closure.frameAngle);
    return { ...pose, transmission: angleAt(pose.c, pose.b, closure.d) };
  });
}

function byKernel() {
  kernel.take(linkage);
  return kernel.poses(cranks);
}

const row = (name, text) => console.log(`${name.padEnd(58)} ${text}`);
const module_ = Buffer.from(base64, "base64");
row("kernel, bytes of WebAssembly (gzipped)", `${module_.length} (${gzipSync(module_).length})`);
row("kernel, bytes in the page", `${base64.length}`);
row("closure script, bytes", `${fs.statSync(new URL("../../../app/report/page/study/closure.js", import.meta.url)).size}`);
row("loading the kernel when Edit is pressed, µs", (await microseconds(51, () => Kernel.load(base64))).toFixed(0));
row("361 positions with transmission angles: kernel, µs", (await microseconds(2001, byKernel)).toFixed(1));
row("361 positions with transmission angles: script, µs", (await microseconds(2001, byScript)).toFixed(1));
row("class, transmission, time ratio, defects: kernel, µs", (await microseconds(2001, () => { kernel.take(linkage); return kernel.facts(cranks.slice(0, 10), [], "one_sense"); })).toFixed(1));
row("nearest places of ten targets: kernel, µs", (await microseconds(501, () => {
  kernel.take(linkage);
  return kernel.nearest(cranks.slice(0, 10).map((crank) => ({ at: [1 + Math.cos(crank), 2], crank, prescribed: false })));
})).toFixed(1));
if (cases) {
  let [far, farScript] = [0, 0];
  for (const c of JSON.parse(fs.readFileSync(cases, "utf8"))) {
    kernel.take(c.mechanism);
    const closure = new Closure(c.mechanism);
    kernel.poses(c.cranks).forEach((pose, i) => {
      if (!pose || !c.poses[i]) return;
      const away = (p) => Math.hypot(p[0] - c.poses[i].c[0], p[1] - c.poses[i].c[1]);
      far = Math.max(far, away(pose.c));
      farScript = Math.max(farScript, away(closure.at(c.cranks[i] - closure.frameAngle)?.c ?? [Infinity, 0]));
    });
  }
  row("farthest from the program's C, links up to 4 long: kernel", far.toExponential(1));
  row("farthest from the program's C, links up to 4 long: script", farScript.toExponential(1));
}
