// A design that was found, in motion.

import { RADIANS } from "../sampling.js";
import { RowLinkage, TURN } from "../study/linkage.js";
import { boxOf, diagonal } from "../view.js";
import { SliderLinkage } from "./slider.js";

const SAMPLES = 180;
const INSIDE = 0.05;   // degrees within the limits of a crank that does not turn fully
// Of the size of the drawing: two designs are alike; two of the many that meet all targets; smaller errors are rounding.
const ALIKE = 0.05, ALIKE_IF_MET = 0.3, MET = 1e-9;

const linkageOf = (mechanism, first) => (mechanism.type === "slider-crank" ? new SliderLinkage(mechanism) : new RowLinkage({ ...mechanism, start: first }));

export class Candidate {
  // `entry`: mechanism, a four-bar or a slider-crank, crank_deg at the targets, rms, max, class, transmission_acute_min_deg; where it guides
  // a body also body_angle_deg, in the coupler, and angle_max_deg, the greatest error; `stray`, how far the curve strays between the targets.
  constructor(entry) {
    const { mechanism, crank_deg: cranks } = entry;
    const first = cranks[0] * RADIANS;
    Object.assign(this, { entry, linkage: linkageOf(mechanism, first), first, sense: senseOf(cranks) });
    this.poses = Array.from({ length: SAMPLES + 1 }, (_, i) => this.pose((TURN * i) / SAMPLES)).filter(Boolean);
    this.curve = this.poses.map(({ p }) => p);
    this.places = [...this.pivots, ...this.poses.flatMap(({ b, c, p }) => [b, c, p])];
    this.size = diagonal(boxOf(this.places));
  }

  // Of a straight line many are about as good.
  get isStraight() { return this.entry.direction_deg !== undefined; }

  get pivots() { return this.entry.mechanism.fixed_pivots ?? [this.entry.mechanism.pivot]; }

  // Where it is at `phase`, 0 to 2π, of its motion: round from the first point in the order of the points, else to and
  // fro between the limits.
  pose(phase) {
    if (this.linkage.fullTurn) return this.linkage.pose(this.first + this.sense * phase);
    const turn = phase - TURN * Math.floor(phase / TURN);
    return this.linkage.pose(Math.min(turn, TURN - turn));
  }

  // Of a guided body at a pose, in degrees; null where there is none.
  bodyAngle({ b, c }) {
    const { body_angle_deg: inCoupler } = this.entry;
    return inCoupler === undefined ? null : Math.atan2(c[1] - b[1], c[0] - b[0]) / RADIANS + inCoupler;
  }

  // The crank's angles over the whole motion, in degrees.
  get range() {
    const { fullTurn, from, to, closure } = this.linkage;
    return fullTurn ? [0, 360] : [(from + closure.frameAngle) / RADIANS + INSIDE, (to + closure.frameAngle) / RADIANS - INSIDE];
  }

  get dimensions() { return [...this.pivots.flat(), ...this.linkage.lengths]; }

  // Whether both are the same mechanism to the eye, of a drawing of `size`.
  isLike(other, size) {
    const own = this.dimensions;
    if (!areOfType(this, other)) return false;
    const areMany = this.isStraight || [this, other].every(({ entry }) => withoutNoise(entry.rms, size) === 0);
    return other.dimensions.every((x, i) => Math.abs(x - own[i]) <= (areMany ? ALIKE_IF_MET : ALIKE) * size);
  }
}

// Whether the dimensions of two can be compared.
const areOfType = (one, other) => one.entry.mechanism.type === other.entry.mechanism.type;

// The number of the one out of `candidates` that is nearest to `one`; the first where none is of its kind.
export function nearestTo(candidates, one) {
  const far = candidates.map((other) => (areOfType(other, one) ? Math.max(...other.dimensions.map((x, i) => Math.abs(x - one.dimensions[i]))) : Infinity));
  return far.indexOf(Math.min(...far));
}

// +1 where the crank turns to the left from point to point on the whole.
function senseOf(cranks) {
  const step = (from, to) => ((((to - from) % 360) + 540) % 360) - 180;
  return cranks.reduce((sum, angle, i) => sum + (i ? step(cranks[i - 1], angle) : 0), 0) < 0 ? -1 : 1;
}

// An error of a drawing of `size`; 0 where it is rounding.
export const withoutNoise = (error, size) => (error < MET * size ? 0 : error);

// By what designs are ordered: the worse of the errors at the targets and between them.
const errorOf = ({ rms, stray = 0 }) => Math.max(rms, stray);

// The best `count` that differ to the eye, best first; `held` is always among them. Of those that meet all targets that is
// the one with the greatest transmission angle.
export function differing(candidates, count, size, held) {
  const error = ({ entry }) => withoutNoise(errorOf(entry), size);
  const order = (a, b) => error(a) - error(b) || b.entry.transmission_acute_min_deg - a.entry.transmission_acute_min_deg;
  const chosen = held ? [held] : [];
  for (const one of [...candidates].sort(order)) {
    if (chosen.length < count && one.poses.length > 1 && error(one) < size && !chosen.some((other) => one.isLike(other, size))) chosen.push(one);
  }
  return chosen.sort(order);
}
