// Which part of a four-bar's motion the picture frames.

import { boxOf, diagonal } from "../view.js";

// The parts that can be framed. Without a coupler point there is no curve; `used`: the poses of a
// function generator in its range, or null.
export function framings(linkage, targets, used) {
  const curve = [...linkage.poses.map((pose) => pose.p), ...targets];
  const pins = (poses) => poses.flatMap((pose) => [pose.b, pose.c]);
  const whole = [...curve, ...pins(linkage.poses), linkage.a, linkage.d];
  const moving = used ? [...pins(used), linkage.a, linkage.d] : [...curve, ...pins(linkage.poses)];
  return { curve: linkage.point ? boxOf(curve) : null, moving: boxOf(moving), whole: boxOf(whole) };
}

// The widest framing in which the coupler curve still takes a fair part of the picture. Pivots are left out where they
// would make all else half as large.
export function bestFraming({ curve, moving, whole }) {
  if (!curve) return diagonal(whole) < 1.6 * diagonal(moving) ? "whole" : "moving";
  if (diagonal(curve) > 0.3 * diagonal(whole)) return "whole";
  if (diagonal(curve) < 0.2 * diagonal(moving)) return "curve";
  return diagonal(whole) < 2 * diagonal(moving) ? "whole" : "moving";
}
