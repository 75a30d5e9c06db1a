// A four-bar with the straight part of its curve on a line that is drawn.

import { RADIANS } from "../sampling.js";
import { Closure } from "../study/closure.js";

const LINE_SAMPLES = 400;
export const SHORTEST_LINE = 1;   // unit of the sheet

// The places of its point over the line, by equal steps of the crank.
function tracedLine({ mechanism, crank_deg: [from, , to] }) {
  const closure = new Closure(mechanism);
  return Array.from({ length: LINE_SAMPLES + 1 }, (_, i) => from + ((to - from) * i) / LINE_SAMPLES).map((crank) => closure.at(crank * RADIANS - closure.frameAngle)?.p).filter(Boolean);
}

const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2;

// The same figure moved, turned and enlarged so that its line, in the direction `direction_deg`, lies from end to end.
export function placedOn(entry, [p, q]) {
  const traced = tracedLine(entry), angle = entry.direction_deg * RADIANS, [x, y] = [Math.cos(angle), Math.sin(angle)];
  if (!traced.length) return entry;
  const along = traced.map((at) => at[0] * x + at[1] * y), across = traced.map((at) => at[1] * x - at[0] * y);
  const length = Math.max(...along) - Math.min(...along), [s, h] = [middle(along), middle(across)], centre = [s * x - h * y, s * y + h * x];
  const turn = (Math.atan2(q[1] - p[1], q[0] - p[0]) - angle) - Math.PI * Math.round((Math.atan2(q[1] - p[1], q[0] - p[0]) - angle) / Math.PI);
  const scale = Math.hypot(q[0] - p[0], q[1] - p[1]) / length, [c, k] = [scale * Math.cos(turn), scale * Math.sin(turn)];
  const put = ([u, v]) => [(p[0] + q[0]) / 2 + c * (u - centre[0]) - k * (v - centre[1]), (p[1] + q[1]) / 2 + k * (u - centre[0]) + c * (v - centre[1])];
  const { fixed_pivots: pivots, crank, coupler, rocker, coupler_point: point } = entry.mechanism;
  const mechanism = { ...entry.mechanism, fixed_pivots: pivots.map(put), crank: scale * crank, coupler: scale * coupler, rocker: scale * rocker, coupler_point: point.map((part) => scale * part) };
  return { ...entry, mechanism, crank_deg: entry.crank_deg.map((degrees) => degrees + turn / RADIANS), direction_deg: entry.direction_deg + turn / RADIANS, rms: scale * entry.rms, max: scale * entry.max };
}
