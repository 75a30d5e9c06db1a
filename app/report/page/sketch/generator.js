// A four-bar that generates a function, in motion on the sheet: to and fro over the inputs of the pairs, or round over a whole turn.

import { RADIANS } from "../sampling.js";
import { Closure } from "../study/closure.js";
import { boxOf } from "../view.js";
import { withoutNoise } from "./candidate.js";
import { layout, placeOf } from "./layout.js";

const PLACES_OF_MOTION = 120;
const WHOLE_TURN = 359.99;    // degrees of the input from which on the crank goes round
const ALIKE_GENERATOR = 0.1, ALIKE_GENERATOR_IF_MET = 0.3;   // in the logarithms of lengths and in radians

const lengthsOf = ({ crank, coupler, rocker, fixed_pivots: [a, d] }) => [crank, coupler, rocker, Math.hypot(d[0] - a[0], d[1] - a[1])];

// As large as fits the stage, in its middle, A→D level.
function placed(mechanism, places) {
  const box = boxOf(places), middle = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const { x0, y0, x1, y1 } = layout().stage, scale = Math.min((x1 - x0) / (box.x1 - box.x0), (y1 - y0) / (box.y1 - box.y0));
  const put = ([x, y]) => [(x0 + x1) / 2 + scale * (x - middle[0]), (y0 + y1) / 2 + scale * (y - middle[1])];
  const { crank, coupler, rocker, fixed_pivots: pivots } = mechanism;
  return { ...mechanism, fixed_pivots: pivots.map(put), crank: scale * crank, coupler: scale * coupler, rocker: scale * rocker };
}

export class Generator {
  // `entry`: mechanism with A→D along the x axis, input_start_deg and output_start_deg, rms and max in degrees, class,
  // transmission_acute_min_deg; for the pairs and ranges of a state.
  constructor(entry, { points, ranges }) {
    Object.assign(this, { entry, ranges, from: points[0][0], to: points.at(-1)[0], tracesFunction: true });
    this.goesRound = this.to - this.from > WHOLE_TURN;
    this.lengths = lengthsOf(entry.mechanism);
    const own = new Closure(entry.mechanism), last = this.goesRound ? 2 * Math.PI - 1e-9 : Math.PI, phases = Array.from({ length: PLACES_OF_MOTION + 1 }, (_, i) => (last * i) / PLACES_OF_MOTION);
    const joints = phases.map((phase) => own.at(this.#crank(phase) * RADIANS)).filter(Boolean).flatMap(({ b, c }) => [b, c]);
    this.linkage = { closure: new Closure(joints.length ? placed(entry.mechanism, [own.a, own.d, ...joints]) : entry.mechanism) };
    this.poses = phases.map((phase) => this.pose(phase)).filter(Boolean);
    this.curve = this.poses.map(({ p }) => p);
    this.errors = points.map(([input, output]) => [input, this.#miss(input, output)]).filter(([, miss]) => Number.isFinite(miss));
    this.places = [];
    this.ratio = Math.max(...this.lengths) / Math.min(...this.lengths);
  }

  #input(phase) {
    const turns = phase / (2 * Math.PI);
    return this.from + (this.to - this.from) * (this.goesRound ? turns - Math.floor(turns) : (1 - Math.cos(phase)) / 2);
  }

  #crank(phase) { return this.entry.input_start_deg + this.#input(phase); }

  // The output angle at a pose, in degrees from its start: the one next to `near`.
  #output({ c }, near) {
    const { d } = this.linkage.closure;
    return near + ((((Math.atan2(c[1] - d[1], c[0] - d[0]) / RADIANS - this.entry.output_start_deg - near) % 360) + 540) % 360) - 180;
  }

  #miss(input, output) {
    const pose = this.linkage.closure.at((this.entry.input_start_deg + input) * RADIANS);
    return pose ? this.#output(pose, output) - output : NaN;
  }

  // Where it is at `phase`, 0 to 2π, its output, and p, where its pair of angles stands in the diagram.
  pose(phase) {
    const pose = this.linkage.closure.at(this.#crank(phase) * RADIANS);
    if (!pose) return null;
    const output = this.#output(pose, this.ranges[1] / 2);
    return { ...pose, output, p: placeOf([this.#input(phase), output], this.ranges) };
  }

  bodyAngle() { return null; }

  // What crank and rocker turn through: {at, radius, from, to}, of places of the sheet and degrees.
  get sectors() {
    const { a, d, linkage: { crank, rocker } } = this.linkage.closure, [first] = this.range, outputs = this.poses.map(({ output }) => output + this.entry.output_start_deg);
    return [{ at: a, radius: crank, from: first, to: first + Math.min(this.to - this.from, WHOLE_TURN) }, { at: d, radius: rocker, from: Math.min(...outputs), to: Math.max(...outputs) }];
  }

  // The crank's angles over the motion, in degrees.
  get range() { return [this.from, this.to].map((input) => this.entry.input_start_deg + input); }

  get dimensions() { return [...this.lengths.map(Math.log), this.entry.input_start_deg * RADIANS, this.entry.output_start_deg * RADIANS]; }

  isLike(other, size) {
    const own = this.dimensions, areMet = [this, other].every(({ entry }) => withoutNoise(entry.rms, size) === 0);
    return other.dimensions.every((x, i) => Math.abs(x - own[i]) <= (areMet ? ALIKE_GENERATOR_IF_MET : ALIKE_GENERATOR));
  }
}
