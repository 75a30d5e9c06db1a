// A design in motion. Where the rocker stands for each crank angle was computed by the analysis
// kernel; here the rigid bodies are only put in their places.

import { interpolate, locate, RADIANS } from "../sampling.js";

const along = (from, length, deg) =>
  [from[0] + length * Math.cos(deg * RADIANS), from[1] + length * Math.sin(deg * RADIANS)];

// The angle at `corner` between the directions to p and q, in degrees from 0 to 180.
export function angleAt(corner, p, q) {
  const [ux, uy, vx, vy] = [p[0] - corner[0], p[1] - corner[1], q[0] - corner[0], q[1] - corner[1]];
  return Math.atan2(Math.abs(ux * vy - uy * vx), ux * vx + uy * vy) / RADIANS;
}

export class Linkage {
  constructor(mechanism, motion) {
    [this.a, this.d] = mechanism.fixed_pivots;
    Object.assign(this, { mechanism, fullTurn: motion.full_turn, rockers: motion.rocker_deg });
    this.point = mechanism.coupler_point ?? null;
    this.assembles = this.rockers.length > 1;
    this.cranks = motion.crank_deg ?? this.rockers.map((_, i) => (360 * i) / (this.rockers.length - 1));
    this.from = this.cranks[0] ?? 0;
    this.to = this.cranks.at(-1) ?? 0;
    this.poses = this.cranks.map((crank, i) => this.#place(crank, this.rockers[i]));
  }

  // The crank angle within the motion that is nearest to `deg`.
  within(deg) {
    if (this.fullTurn) return deg - 360 * Math.floor((deg - this.from) / 360);
    const middle = (this.from + this.to) / 2;
    const turned = deg - 360 * Math.round((deg - middle) / 360);
    return Math.min(this.to, Math.max(this.from, turned));
  }

  pose(deg) {
    return this.#place(deg, interpolate(this.rockers, locate(this.cranks, this.within(deg))));
  }

  // The pose by the lengths alone, not between samples: of the two places where coupler and rocker
  // meet the one that the motion has. Null where they do not meet.
  exact(deg) {
    const { crank, coupler, rocker } = this.mechanism;
    const b = along(this.a, crank, deg);
    const [x, y] = [this.d[0] - b[0], this.d[1] - b[1]];
    const far = Math.hypot(x, y);
    const foot = (coupler * coupler - rocker * rocker + far * far) / (2 * far);
    const square = coupler * coupler - foot * foot;
    if (!(square >= 0)) return null;
    const near = this.pose(deg).c;
    const side = Math.sign((near[1] - b[1]) * x - (near[0] - b[0]) * y) || 1;
    const high = (side * Math.sqrt(square)) / far;
    const c = [b[0] + (foot / far) * x - high * y, b[1] + (foot / far) * y + high * x];
    return { b, c, p: this.point ? this.#couplerPoint(b, c) : null };
  }

  // Where the axes of a body stand in a pose, [x, y, cos, sin]: 1 the crank, 2 the coupler, 3 the
  // rocker, each from its first joint to its second.
  placeOf(body, pose) {
    const [from, to] = { 1: [this.a, pose.b], 2: [pose.b, pose.c], 3: [this.d, pose.c] }[body];
    const [x, y] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(x, y) || 1;
    return [...from, x / length, y / length];
  }

  #place(crank, rocker) {
    const b = along(this.a, this.mechanism.crank, crank);
    const c = along(this.d, this.mechanism.rocker, rocker);
    return { crank, rocker, b, c, p: this.point ? this.#couplerPoint(b, c) : null, transmission: angleAt(c, b, this.d) };
  }

  #couplerPoint(b, c) {
    const [x, y] = [c[0] - b[0], c[1] - b[1]];
    const length = Math.hypot(x, y) || 1;
    const [u, v] = this.point;
    return [b[0] + (u * x - v * y) / length, b[1] + (u * y + v * x) / length];
  }
}
