// Poses that a hand gives: a place and the direction of the body's first axis, in degrees.

import { RADIANS } from "../sampling.js";
import { pathThrough } from "../shapes.js";

export const FIRST_AXIS = 34;   // pixels
const SECOND_AXIS = 18;

// The same direction in [0, 360).
export const inTurn = (degrees) => ((degrees % 360) + 360) % 360;

// The direction from p to q, in whole degrees.
export const directionOf = (p, q) => inTurn(Math.round(Math.atan2(q[1] - p[1], q[0] - p[0]) / RADIANS));

// `length` pixels from a place of the picture in a direction of the plane.
export const along = ([x, y], degrees, length) => [x + length * Math.cos(degrees * RADIANS), y - length * Math.sin(degrees * RADIANS)];

// The axes of a body at a place of the picture: the first with the tip of an arrow, the second shorter.
export function axesPath(at, degrees) {
  const tip = along(at, degrees, FIRST_AXIS);
  const barbs = [150, -150].map((turn) => along(tip, degrees + turn, 8));
  return `${pathThrough([along(at, degrees + 90, SECOND_AXIS), at, tip])}${pathThrough([barbs[0], tip, barbs[1]])}`;
}
