// The analysis kernel of the program, compiled to WebAssembly, which the page holds compressed and in
// base64; empty where the build had no compiler for it. Angles are in radians, from the x axis unless it says so.

import { embedded } from "./embedded.js";
import { RADIANS } from "./sampling.js";

const CLASSES = ["crank-rocker", "double-crank", "rocker-crank", "double-rocker", "triple-rocker"];
const DEFECTS = ["circuit", "branch", "order"];
const SEQUENCES = { any: 0, one_sense: 1, timed: 2 };

// The module that `base64` holds compressed.
export async function moduleBytes(base64 = embedded("kernel")) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

export class Kernel {
  static get available() { return embedded("kernel").trim() !== "" && typeof WebAssembly !== "undefined" && typeof DecompressionStream !== "undefined"; }

  static async load(base64 = embedded("kernel")) {
    return new this((await WebAssembly.instantiate(await moduleBytes(base64))).instance);
  }

  constructor({ exports }) {
    exports._initialize?.();
    this.calls = exports;
    this.begin = exports.numbers();
  }

  // The block of numbers that calls take and give; memory that has grown is another buffer.
  get numbers() { return new Float64Array(this.calls.memory.buffer, this.begin, 65536); }

  put(values) { this.numbers.set(values); }

  // Takes a four-bar as files have it. False where its links cannot be assembled, or a dimension is
  // none: lengths are positive, and A and D are two points.
  take({ fixed_pivots: [a, d], crank, coupler, rocker, assembly, coupler_point: point }) {
    const numbers = [...a, ...d, crank, coupler, rocker, assembly === "crossed" ? -1 : 1, point ? 1 : 0, ...(point ?? [0, 0])];
    if (!numbers.every(Number.isFinite) || !(Math.min(crank, coupler, rocker, Math.hypot(d[0] - a[0], d[1] - a[1])) > 0)) return false;
    this.put(numbers);
    return this.calls.four_bar() === 1;
  }

  // Facts of the current linkage, used at the crank angles `stations` and moved between `travel`.
  facts(stations, travel = [], sequence = "any") {
    this.put([...stations, ...travel]);
    const count = this.calls.four_bar_quantities(stations.length, travel.length, SEQUENCES[sequence]);
    const [mobility, excess, changePoint, rotates, least, greatest, acute, ratio, ...rest] = this.numbers.slice(0, count);
    return { class: CLASSES[mobility], excess, changePoint: changePoint !== 0, rotates: rotates !== 0, least, greatest, acute,
      timeRatio: Number.isNaN(ratio) ? null : ratio, defects: DEFECTS.filter((_, i) => rest[i] !== 0),
      used: Number.isNaN(rest[3]) ? null : [rest[3], rest[4]] };
  }

  // Where the linkage taken stands at crank angles; null where it does not close.
  poses(cranks) {
    this.put(cranks);
    const count = this.calls.four_bar_poses(cranks.length);
    const all = this.numbers.slice(0, count);
    return cranks.map((crank, i) => {
      const [bx, by, cx, cy, px, py, rocker, transmission] = all.subarray(8 * i, 8 * i + 8);
      return Number.isNaN(bx) ? null : { crank, b: [bx, by], c: [cx, cy], p: Number.isNaN(px) ? null : [px, py], rocker, transmission };
    });
  }

  // Of each target {at, angle, weight, crank, prescribed} the crank angle of the linkage taken that is
  // nearest to it downhill from `crank`, and over the turn.
  nearest(targets) {
    this.put(targets.flatMap(({ at, angle = 0, weight = 0, crank, prescribed }) => [...at, angle, weight, crank, prescribed ? 1 : 0]));
    this.calls.four_bar_nearest(targets.length);
    const all = this.numbers;
    return { near: targets.map((_, i) => all[2 * i]), anywhere: targets.map((_, i) => all[2 * i + 1]) };
  }

  // The motion of the linkage taken as a report draws it, in degrees.
  motion(stations, samples) {
    this.put(stations);
    const count = this.calls.four_bar_motion(stations.length, samples);
    const all = this.numbers;
    const list = (from) => Array.from(all.subarray(from, from + count), (angle) => angle / RADIANS);
    return { full_turn: all[0] !== 0, crank_deg: list(1), rocker_deg: list(1 + count) };
  }
}
