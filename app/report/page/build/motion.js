// What the kernel says of a mechanism that was built: how it moves from the position drawn, and what follows from it.

import { AnalysisKernel } from "../edit/analysis_kernel.js";
import { Mechanism } from "../mechanism.js";
import { say } from "../words.js";
import { problemOfState } from "./chain.js";
import { lackOf } from "./lacks.js";

const FULL = 360, NEAR = 1e-6;
const INSIDE = 1e-6;   // of the range within its limits: there rounding decides whether it closes

const isOpen = ({ bodies }, k) => bodies.slice(1).some(({ x }) => (Array.isArray(x) ? x[k] : x) === null);
const isRound = ({ drive }) => Math.abs(Math.abs(drive.at(-1) - drive[0]) - FULL) < NEAR;

// The first sample from `begin` on in a sense that is open; -1 where none is.
function firstOpen(motion, begin, sense) {
  for (let k = begin; k >= 0 && k < motion.drive.length; k += sense) if (isOpen(motion, k)) return k;
  return -1;
}

// Where the places of bodies are in a motion that begins in the position drawn.
function drawnPlaces({ bodies }) {
  const first = (track) => (Array.isArray(track) ? track[0] : track);
  return new Map(bodies.map(({ name, x, y, deg }) => [name, [x, y, deg].map(first)]));
}

// A mechanism in motion whose bodies are known by their names in the state.
export class BuiltMotion {
  constructor(data, drawn, sweep) {
    const { drive } = data.mechanism;
    Object.assign(this, { data, drawn, start: sweep.start });
    this.isTurning = sweep.isTurning;
    this.mechanism = new Mechanism(data.mechanism, { from: drive[0], to: drive.at(-1), round: sweep.round });
    this.numbers = new Map(this.mechanism.bodies.map(({ name }, i) => [name, i]));
  }

  // Of each body how the plane it was drawn in is moved: [x, y, cos, sin] of the origin; null where it is nowhere.
  moves(drive) {
    const places = this.mechanism.places(drive);
    return new Map([...this.numbers].map(([name, i]) => [name, places[i] && moved(this.drawn.get(name), places[i])]));
  }
}

function moved([x, y, deg], [toX, toY, c, s]) {
  const angle = (deg * Math.PI) / 180, [c0, s0] = [Math.cos(angle), Math.sin(angle)];
  const [cos, sin] = [c * c0 + s * s0, s * c0 - c * s0];
  return [toX - cos * x + sin * y, toY - sin * x - cos * y, cos, sin];
}

// Where a point of the plane drawn is after a move.
export const after = ([x, y, c, s], [u, v]) => [x + c * u - s * v, y + s * u + c * v];
export const before = ([x, y, c, s], [u, v]) => [c * (u - x) + s * (v - y), c * (v - y) - s * (u - x)];

export class Analyst {
  constructor(kernel) { this.kernel = kernel; }

  // The motion alone, as it follows a hand; {faults} where there is none.
  quick(state) {
    if (lackOf(state)) return {};
    const data = this.#ask(() => this.kernel.motion(problemOfState(state)));
    if (data.faults) return data;
    const { mechanism: motion } = data;
    return { motion: new BuiltMotion(data, drawnPlaces(motion), { start: motion.drive[0], round: isRound(motion), isTurning: true }) };
  }

  // Everything, over the whole turn or over the range about the position drawn in which it can be assembled.
  whole(state) {
    if (lackOf(state)) return {};
    const data = this.#ask(() => this.kernel.motion(problemOfState(state)));
    if (data.faults) return data;
    const range = this.#range(state, data.mechanism);
    const all = this.#ask(() => this.kernel.whole(problemOfState(state, range)));
    if (all.faults) return all;
    return { motion: new BuiltMotion(all, drawnPlaces(data.mechanism), { start: data.mechanism.drive[0], round: all.drive.round, isTurning: all.drive.kind !== "slider" }), range };
  }

  // The limits of the drive about the position drawn as files have them; null where it turns fully.
  #range(state, motion) {
    const { drive } = motion, last = drive.length - 1, forward = firstOpen(motion, 0, 1), start = drive[0];
    if (forward < 0) return null;
    const backward = firstOpen(motion, last, -1);
    const high = this.#limit(state, drive[Math.max(0, forward - 1)], drive[forward]);
    const low = this.#limit(state, drive[Math.min(last, backward + 1)] - FULL, drive[backward] - FULL);
    const inside = INSIDE * (high - low);
    return { start_deg: Math.min(start, low + inside), end_deg: Math.max(start, high - inside) };
  }

  // The last place of a finer sweep that is closed, from one that is to one that is not.
  #limit(state, closed, open) {
    const data = this.#ask(() => this.kernel.motion(problemOfState(state, { start_deg: closed, end_deg: open })));
    if (data.faults) return closed;
    const k = firstOpen(data.mechanism, 0, 1);
    return k > 0 ? data.mechanism.drive[k - 1] : closed;
  }

  // The kernel's answer; where it fails the next question goes to a fresh one.
  #ask(question) {
    try {
      return question();
    } catch {
      AnalysisKernel.load().then((kernel) => { this.kernel = kernel; });
      return { faults: [say("edit.failed")] };
    }
  }
}
