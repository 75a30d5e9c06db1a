// What is asked of the search, and the files that are taken along.

import { boxOf, diagonal } from "../view.js";
import { tableWithoutRounding } from "../rounding.js";

export const CLASSES_ASKED = ["any", "crank-rocker", "double-crank", "double-rocker", "triple-rocker"];
export const FEWEST_POINTS = 3;

const PIVOTS_WITHIN = 1.5;   // of the drawing's size, from its middle
const SHORTEST = 0.02;

export const drawingSize = (points) => diagonal(boxOf(points));

const short = (x) => Number(x.toPrecision(4));

// The problem of a sketch: its points, and the limits set beside it.
export function problemOf({ points, class: asked, least, reach }, solve) {
  const box = boxOf(points), size = diagonal(box);
  const [x, y] = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const far = PIVOTS_WITHIN * Math.max(1, reach / 3) * size;
  const within = [[short(x - far), short(y - far)], [short(x + far), short(y + far)]];
  return { kind: "path-generation", target: { points, timing: "free", order: "cyclic" },
    bounds: { length: [short(SHORTEST * size), short(reach * size)], pivot_a: within, pivot_d: within },
    constraints: { ...(asked === "any" ? {} : { class: asked }), ...(least > 0 ? { transmission_angle_deg: [least, 180 - least] } : {}) },
    solve };
}

// The analysis of a candidate over its whole motion.
export const analysisOf = ({ entry: { mechanism }, range: [from, to] }) => ({ kind: "analysis", mechanism: tableWithoutRounding(mechanism),
  drive: { start_deg: short(from), end_deg: short(to), steps: 360 } });
