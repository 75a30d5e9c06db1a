// The linkage of a row, and its motion. Where the crank does not turn fully, the motion goes on in
// the other assembly at each limit position, so that the coupler point traces its whole circuit.

import { RADIANS } from "../sampling.js";
import { Closure } from "./closure.js";

export const TURN = 2 * Math.PI;
const HAIR = 1e-9;

// `template` with the numbers that the row varies, `value(variable)`.
export function filledIn(template, value) {
  if (Array.isArray(template)) return template.map((part) => filledIn(part, value));
  if (template === null || typeof template !== "object") return template;
  if ("variable" in template) return value(template.variable);
  return Object.fromEntries(Object.entries(template).map(([key, part]) => [key, filledIn(part, value)]));
}

export class RowLinkage {
  constructor(dimensions) {
    this.dimensions = dimensions;
    this.closure = new Closure(dimensions);
    this.#setRange();
  }

  get lengths() {
    const { crank, coupler, rocker } = this.dimensions;
    return [crank, coupler, rocker, this.closure.frame];
  }

  #setRange() {
    const [least, greatest] = this.closure.limits;
    this.closes = least <= 1 && greatest >= -1 && this.lengths.every((length) => length > 0);
    this.fullTurn = this.closes && least <= -1 && greatest >= 1;
    const [inner, outer] = [greatest >= 1 ? 0 : Math.acos(greatest), least <= -1 ? Math.PI : Math.acos(least)];
    // About the frame line where the limits lie on both sides of it.
    const range = greatest >= 1 ? [-outer, outer] : least <= -1 ? [inner, TURN - inner] : this.#startsBelow(inner, outer) ? [-outer, -inner] : [inner, outer];
    // A hair within the limits, where rounding cannot open the triangle.
    [this.from, this.to] = [range[0] + HAIR, range[1] - HAIR];
    this.closes = this.closes && this.pose(1) !== null;
  }

  // Of two ranges, mirror images in the frame line, whether the drive starts in the lower one or, in
  // none, reaches it first.
  #startsBelow(inner, outer) {
    const start = (this.dimensions.start ?? 0) - this.closure.frameAngle;
    const angle = start - TURN * Math.floor(start / TURN);
    return angle > outer && angle <= TURN - inner;
  }

  // The pose at `phase` of the motion, 0 to 2π. `crank`: the angle from the x axis, in degrees.
  pose(phase) {
    const turn = phase - TURN * Math.floor(phase / TURN);
    const back = !this.fullTurn && turn > Math.PI;
    const angle = this.fullTurn ? turn - this.closure.frameAngle : (this.from + this.to) / 2 - ((this.to - this.from) / 2) * Math.cos(turn);
    const pose = this.closes ? this.closure.at(angle, back ? -1 : 1) : null;
    return pose && { ...pose, crank: (angle + this.closure.frameAngle) / RADIANS };
  }

  // The motion in `count` equal steps of the phase; places where it does not close left out.
  poses(count) {
    return Array.from({ length: count + 1 }, (_, i) => this.pose((TURN * i) / count)).filter(Boolean);
  }
}
