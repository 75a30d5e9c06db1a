// The page of `cognate sketch` in a browser. COGNATE: the program, which also answers in the place of the search where
// the build had no compiler for WebAssembly.
import { execFile, execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";
import { promisify } from "node:util";
import { gzipSync } from "node:zlib";
import { problemToml } from "../../app/report/page/toml.js";
import { launch, visitFile } from "./browser.mjs";

export let browser, folder, file, hasKernel;
before(async () => {
  browser = await launch();
  folder = fs.mkdtempSync(path.join(os.tmpdir(), "cognate-sketch-"));
  file = path.join(folder, "sketch.html");
  execFileSync(process.env.COGNATE, ["sketch", "--out", file]);
  const text = fs.readFileSync(file, "utf8");
  hasKernel = !text.includes('id="kernel"></script>');
  // A module without anything in it: the page has a search, and the program is it.
  const empty = gzipSync(Buffer.from([0, 97, 115, 109, 1, 0, 0, 0])).toString("base64");
  fs.writeFileSync(path.join(folder, "answered.html"), hasKernel ? text : text.replace('id="kernel">', `id="kernel">${empty}`));
});
after(async () => { await browser?.close(); fs.rmSync(folder, { recursive: true }); });

let files = 0;
export async function answered(command, text, ...options) {
  const name = path.join(folder, `${++files}.toml`);
  fs.writeFileSync(name, text);
  const run = await promisify(execFile)(process.env.COGNATE, [command, "--json", name, ...options], { maxBuffer: 1 << 28 }).catch((error) => error);
  return JSON.parse(run.stdout);
}

// A slider-crank as the search gives it, of one that the program gives as a chain.
function sliderCrank({ pivot: [{ at }], crank, dyad: [{ lengths: [coupler], slide, assembly }], point: [{ at: point }] }) {
  return { type: "slider-crank", pivot: at, crank: crank.length, coupler, offset: slide.offset, direction_deg: slide.direction_deg, assembly, coupler_point: point };
}

// Of a straight line the deviation is the error.
const lineOf = ({ deviation, crank_from_deg: from, crank_to_deg: to, direction_deg: direction, speed_variation: variation }) =>
  ({ crank_deg: [from, (from + to) / 2, to], rms: deviation, max: deviation, direction_deg: direction, speed_variation: variation });

// What the search answers, by the program. Errors of functions are in degrees.
async function programAnswer(problem) {
  const result = await answered("solve", problemToml(problem)), unit = problem.kind === "function-generation" ? 180 / Math.PI : 1;
  return { designs: result.designs.map(({ mechanism, crank_deg: cranks, error, metrics }) => ({ mechanism: mechanism.type === "chain" ? sliderCrank(mechanism) : mechanism, crank_deg: cranks, rms: unit * error.rms, max: unit * error.max,
    stray: metrics.stray_between_points, ...(problem.kind === "straight-line" ? lineOf(metrics) : {}), class: metrics.class ?? metrics.topology, transmission_acute_min_deg: metrics.transmission_angle_deg.acute_min, body_angle_deg: metrics.body_angle_in_link_deg, angle_max_deg: metrics.angle_error_max_deg,
    input_start_deg: metrics.input_start_deg, output_start_deg: metrics.output_start_deg })) };
}

async function prepare(page) {
  await page.exposeFunction("programAnswer", programAnswer);
  await page.addInitScript(() => {
    window.Worker = class {
      terminate() { this.ended = true; }
      postMessage({ id, problem }) {
        if (problem === undefined || problem.known_alone) return;   // the program draws starts besides
        this.queue = (this.queue ?? Promise.resolve()).then(async () => {
          if (this.ended) return;
          const answer = await window.programAnswer(problem);
          if (!this.ended) this.onmessage({ data: { id, answer } });
        });
      }
    };
  });
}

// Likewise; while `window.holds` is set, questions about all designs wait as {worker, message, send} in `window.held`. `window.told` is what was answered.
export async function holding(page) {
  if (!hasKernel) await prepare(page);
  await page.addInitScript(() => {
    Object.assign(window, { held: [], holds: false, told: [] });
    const { postMessage } = Worker.prototype;
    const listened = new WeakSet();
    Worker.prototype.postMessage = function (message) {
      const { onmessage } = this, send = () => postMessage.call(this, message);
      if (!listened.has(this)) { listened.add(this); this.onmessage = (event) => { window.told.push(event.data); onmessage.call(this, event); }; }
      if (window.holds && message.problem && !message.problem.known_alone) window.held.push({ worker: this, message, send }); else send();
    };
  });
}
export const hold = (page) => page.evaluate(() => { window.holds = true; });
export const letGo = (page) => page.evaluate(() => { window.holds = false; for (const { send } of window.held.splice(0)) send(); });

export async function visit(options, steps) {
  await visitFile(browser, path.join(folder, "answered.html"), { motion: "reduce", ...(hasKernel ? {} : { prepare }), ...options }, steps);
}

// Draws with the mouse through places given by shares of the picture.
export async function draw(page, at, [from, to] = [0, 2 * Math.PI]) {
  const box = await page.locator("#sheet").boundingBox();
  const place = (t) => { const [x, y] = at(t); return [box.x + x * box.width, box.y + y * box.height]; };
  await page.mouse.move(...place(from));
  await page.mouse.down();
  for (let i = 1; i <= 60; ++i) await page.mouse.move(...place(from + ((to - from) * i) / 60));
  await page.mouse.up();
}

// Six poses by shares of the picture: where the body is, and how far the hand goes from there in its direction.
export const SIX = [[0.25, 0.7, 0.1, 0], [0.32, 0.5, 0.08, -0.03], [0.42, 0.36, 0.07, -0.06], [0.55, 0.32, 0.05, -0.09], [0.66, 0.4, 0.03, -0.1], [0.72, 0.55, 0, -0.1]];

// Puts such poses with the mouse.
export async function put(page, poses) {
  if (await page.locator("#of-poses").getAttribute("aria-pressed") === "false") await page.locator("#of-poses").click();
  const box = await page.locator("#sheet").boundingBox();
  const place = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  for (const [x, y, across, down] of poses) {
    await page.mouse.move(...place(x, y));
    await page.mouse.down();
    await page.mouse.move(...place(x + across, y + down), { steps: 6 });
    await page.mouse.up();
  }
}

// Until all searches for a drawing have ended, or the first has given designs.
export const offered = (page) => page.waitForFunction(() => /designs? after /.test(document.getElementById("state").textContent));
export const settled = (page) => page.waitForFunction(() => /designs? after [^;]*\.$/.test(document.getElementById("state").textContent), undefined, { timeout: 120000 });
export const facts = (page, name) => page.locator(`[data-fact="${name}"]`).evaluateAll((all) => all.map((one) => JSON.parse(one.dataset.value)));
export const targets = (page) => page.locator("[data-target]").count();

// The numbers of the address: its points, and its design.
export function addressOf(page) {
  const parts = Object.fromEntries(page.url().split("#")[1].split("&").map((part) => part.split("=")));
  const [numbers, assembly, , cranks = ""] = (parts.d ?? "").split(";");
  const [ax, ay, dx, dy, crank, coupler, rocker, u, v, rms, max, , body] = numbers.split(",").map(Number);
  return { points: parts.p.split(";").map((p) => p.split(",").map(Number)), a: [ax, ay], d: [dx, dy], crank, coupler, rocker, u, v, rms, max, body, cranks: cranks.split(",").map(Number), side: assembly === "crossed" ? -1 : 1 };
}
