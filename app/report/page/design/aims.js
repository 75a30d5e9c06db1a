// What the lens shows of a design: each target beside what is reached of it.

import { degrees } from "../format.js";
import { diagonal } from "../view.js";
import { say } from "../words.js";

// The place on a closed curve that is nearest to p.
function nearestOn(curve, p) {
  let [best, least] = [null, Infinity];
  curve.forEach((from, i) => {
    const foot = footWithin(from, curve[(i + 1) % curve.length], p);
    const away = Math.hypot(foot[0] - p[0], foot[1] - p[1]);
    if (away < least) [best, least] = [foot, away];
  });
  return best;
}

// The point nearest to r of the line from p to q.
function footWithin(p, q, r) {
  const [x, y] = [q[0] - p[0], q[1] - p[1]];
  const size = x * x + y * y;
  const t = size > 0 ? Math.min(1, Math.max(0, ((r[0] - p[0]) * x + (r[1] - p[1]) * y) / size)) : 0;
  return [p[0] + t * x, p[1] + t * y];
}

// The path of the point near `station`, `half` to either side, moved by what drawing rounded, so that
// it leads through `through`; nothing where the point followed is another one.
function curveNear(design, station, through) {
  const at = design.pointAt(station);
  if (!at) return undefined;
  const off = [through[0] - at[0], through[1] - at[1]];
  if (Math.hypot(...off) > 1e-3 * diagonal(design.boxes.whole)) return undefined;
  return (count, half) => {
    const step = 1e-3 * (design.to - design.from);
    const next = design.pointAt(station + step) ?? design.pointAt(station - step);
    const speed = next ? Math.hypot(next[0] - at[0], next[1] - at[1]) / step : 0;
    const reach = Math.min(0.1 * (design.to - design.from), speed > 0 ? half / speed : step);
    return Array.from({ length: 2 * count + 1 }, (_, i) => {
      const p = design.pointAt(station + (reach * (i - count)) / count);
      return p && [p[0] + off[0], p[1] + off[1]];
    });
  };
}

const CURVE_AIMS = 16;

export function aimsOf(design) {
  if (!design.assembles) return [];
  if (design.outline.length && design.targets.length === 0) {
    return Array.from({ length: CURVE_AIMS }, (_, i) => design.from + ((design.to - design.from) * i) / CURVE_AIMS).flatMap((drive) => {
      const reached = design.pointAt(drive);
      return reached ? [{ name: say("lens.curve_at", { at: degrees(drive, 1) }), target: nearestOn(design.outline, reached), reached, curve: curveNear(design, drive, reached) }] : [];
    });
  }
  return design.targets.flatMap((target, i) => {
    const reached = design.reached[i];
    if (!reached) return [];
    const pose = design.poses[i];
    const body = design.guided?.reached[i];
    const turned = pose && body ? { deg: pose[2], reachedDeg: body[2] + design.guided.axes[2] } : {};
    return [{ name: say("lens.target", { n: i + 1 }), target, reached, ...turned, curve: design.stations[i] === undefined ? undefined : curveNear(design, design.stations[i], reached) }];
  });
}
