// A design that was found, in motion.

import { RADIANS } from "../sampling.js";
import { RowLinkage, TURN } from "../study/linkage.js";
import { boxOf, diagonal } from "../view.js";

const SAMPLES = 180;
const INSIDE = 0.05;   // degrees within the limits of a crank that does not turn fully
const ALIKE = 0.05;    // of the size of the drawing

export class Candidate {
  // `entry`: mechanism, crank_deg at the points, rms, max, class, transmission_acute_min_deg.
  constructor(entry) {
    const { mechanism, crank_deg: cranks } = entry;
    const linkage = new RowLinkage({ ...mechanism, start: cranks[0] * RADIANS });
    Object.assign(this, { entry, linkage, first: cranks[0] * RADIANS, sense: senseOf(cranks) });
    this.poses = Array.from({ length: SAMPLES + 1 }, (_, i) => this.pose((TURN * i) / SAMPLES)).filter(Boolean);
    this.curve = this.poses.map(({ p }) => p);
    this.places = [...mechanism.fixed_pivots, ...this.poses.flatMap(({ b, c, p }) => [b, c, p])];
    this.size = diagonal(boxOf(this.places));
  }

  // Where it is at `phase`, 0 to 2π, of its motion: round from the first point in the order of the points, else to and
  // fro between the limits.
  pose(phase) {
    if (this.linkage.fullTurn) return this.linkage.pose(this.first + this.sense * phase);
    const turn = phase - TURN * Math.floor(phase / TURN);
    return this.linkage.pose(Math.min(turn, TURN - turn));
  }

  // The crank's angles over the whole motion, in degrees.
  get range() {
    const { fullTurn, from, to, closure } = this.linkage;
    return fullTurn ? [0, 360] : [(from + closure.frameAngle) / RADIANS + INSIDE, (to + closure.frameAngle) / RADIANS - INSIDE];
  }

  get dimensions() { return [...this.entry.mechanism.fixed_pivots.flat(), ...this.linkage.lengths]; }

  // Whether both are the same linkage to the eye, of a drawing of `size`.
  isLike(other, size) {
    const own = this.dimensions;
    return other.dimensions.every((x, i) => Math.abs(x - own[i]) <= ALIKE * size);
  }
}

// +1 where the crank turns to the left from point to point on the whole.
function senseOf(cranks) {
  const step = (from, to) => ((((to - from) % 360) + 540) % 360) - 180;
  return cranks.reduce((sum, angle, i) => sum + (i ? step(cranks[i - 1], angle) : 0), 0) < 0 ? -1 : 1;
}

// The best `count` that differ to the eye, best first; `held` is always among them.
export function differing(candidates, count, size, held) {
  const chosen = held ? [held] : [];
  for (const one of [...candidates].sort((a, b) => a.entry.rms - b.entry.rms)) {
    if (chosen.length < count && one.poses.length > 1 && !chosen.some((other) => one.isLike(other, size))) chosen.push(one);
  }
  return chosen.sort((a, b) => a.entry.rms - b.entry.rms);
}
