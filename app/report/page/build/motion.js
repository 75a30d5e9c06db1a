// What the kernel says of a mechanism that was built: how it moves from the position drawn, and what follows from it.

import { AnalysisKernel } from "../edit/analysis_kernel.js";
import { Mechanism } from "../mechanism.js";
import { boxOf, diagonal } from "../view.js";
import { say } from "../words.js";
import { problemOfState } from "./chain.js";
import { lackOf } from "./lacks.js";
import { drivesBySlide } from "./model.js";

const FULL = 360, NEAR = 1e-6;
const FARTHEST = 4;     // sizes of the mechanism to either side that the range of a driving slider is looked for
const INSIDE = 1e-6;    // of the range within its limits: there rounding decides whether it closes

const isRound = ({ drive }) => Math.abs(Math.abs(drive.at(-1) - drive[0]) - FULL) < NEAR;

// Where the places of bodies are at a sample of a motion.
function placesAt({ bodies }, k) {
  const value = (track) => (Array.isArray(track) ? track[k] : track);
  return new Map(bodies.map(({ name, x, y, deg }) => [name, [x, y, deg].map(value)]));
}

// A mechanism in motion whose bodies are known by their names in the state.
class BuiltMotion {
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
  // `whole`: the WholeAnalysis that answers in its own time.
  constructor(kernel, whole) { Object.assign(this, { kernel, whole }); }

  // The motion alone, as it follows a hand; {faults} where there is none, nothing where something is missing.
  quick(state) {
    const { data, slides, drawn } = this.#sweep(state);
    if (!data || data.faults) return data ?? {};
    return { motion: motionOf(data, placesAt(data.mechanism, drawn), data.mechanism.drive[drawn], slides) };
  }

  // The motion over the whole turn or over the range about the position drawn in which it can be assembled: at once. All that follows from it comes
  // later, by onWhole({motion, range} or {faults}), unless something else is asked before.
  settled(state, onWhole) {
    this.whole.cancel();
    const { data, slides, drawn } = this.#sweep(state);
    if (!data || data.faults) return data ?? {};
    const range = rangeAbout(data, slides, drawn), places = placesAt(data.mechanism, drawn), start = data.mechanism.drive[drawn];
    const own = range ? this.#motion(state, range) : data;
    if (own.faults) return own;
    this.whole.ask(problemOfState(state, range), (all) => onWhole(all.faults ? all : { motion: motionOf(all, places, start, slides, all.drive.round), range }));
    return { motion: motionOf(own, places, start, slides, !range && !slides && isRound(own.mechanism)), range, isPending: true };
  }

  cancel() { this.whole.cancel(); }

  // The motion over a turn from the position drawn, or about it; `drawn` is the number of the sample at which it is drawn.
  #sweep(state) {
    if (lackOf(state)) return {};
    const slides = drivesBySlide(state), data = this.#motion(state, slides ? wayOf(state) : null);
    return { data, slides, drawn: slides && !data.faults ? nearestToZero(data.mechanism.drive) : 0 };
  }

  // The kernel's answer; where it fails the next question goes to a fresh one.
  #motion(state, range) {
    try {
      return this.kernel.bareMotion(problemOfState(state, range));
    } catch {
      AnalysisKernel.load().then((kernel) => { this.kernel = kernel; });
      return { faults: [say("edit.failed")] };
    }
  }
}

const motionOf = (data, drawn, start, slides, round = !slides && isRound(data.mechanism)) => new BuiltMotion(data, drawn, { start, round, isTurning: !slides });

function wayOf({ joints }) {
  const far = FARTHEST * Math.max(diagonal(boxOf(joints.map(({ at }) => at))), NEAR);
  return { start: -far, end: far };
}

const nearestToZero = (list) => list.reduce((best, x, k) => (Math.abs(x) < Math.abs(list[best]) ? k : best), 0);
// The limits of the drive about the position drawn as files have them; null where it turns fully. Over a turn what lies before
// that position stands at the end.
function rangeAbout({ ranges, mechanism: { drive } }, slides, drawn) {
  const at = drive[drawn], own = ranges.find(([from, to]) => from - NEAR <= at && at <= to + NEAR) ?? [at, at], last = ranges.at(-1);
  if (!slides && own[1] >= drive.at(-1) - NEAR) return null;
  const isBefore = !slides && last !== own && last?.[1] >= drive.at(-1) - NEAR;
  const [low, high] = [isBefore ? last[0] - FULL : own[0], own[1]], inside = INSIDE * (high - low);
  return rangeOf(slides, Math.min(at, low + inside), Math.max(at, high - inside));
}

const rangeOf = (slides, from, to) => (slides ? { start: from, end: to } : { start_deg: from, end_deg: to });
