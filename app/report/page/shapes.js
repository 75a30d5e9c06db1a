// The signs of a mechanism's drawing, in pixels.

import { element, svg } from "./dom.js";
import { RADIANS } from "./sampling.js";

export const round = (x) => Math.round(x * 100) / 100;
export const pathThrough = (points) => points.map((p, i) => `${i ? "L" : "M"}${round(p[0])} ${round(p[1])}`).join("");

// A bar with round ends about p and q.
export function barPath(p, q, radius) {
  const [x, y] = [q[0] - p[0], q[1] - p[1]];
  const length = Math.hypot(x, y) || 1;
  const [nx, ny] = [(-y / length) * radius, (x / length) * radius];
  const r = round(radius);
  const at = (point, side) => `${round(point[0] + side * nx)} ${round(point[1] + side * ny)}`;
  return `M${at(p, 1)}A${r} ${r} 0 0 1 ${at(p, -1)}L${at(q, -1)}A${r} ${r} 0 0 1 ${at(q, 1)}Z`;
}

// A fixed pivot: the bearing on hatched ground.
export function groundSign([x, y]) {
  const hatches = [-12, -6, 0, 6, 12].map((dx) => `M${dx} 18l-5 6`).join("");
  return svg("g", { transform: `translate(${round(x)} ${round(y)})` },
    svg("path", { class: "ground", d: "M0 0L-10 18H10Z" }),
    svg("path", { class: "ground-hatch", d: `M-16 18H16${hatches}` }));
}

// The sector of `radius` pixels about p from one angle to another, in degrees of the plane.
export function sectorPath(p, radius, from, to) {
  const tip = (deg) => [p[0] + radius * Math.cos(deg * RADIANS), p[1] - radius * Math.sin(deg * RADIANS)];
  const [a, b] = [tip(from), tip(to)];
  const large = Math.abs(to - from) > 180 ? 1 : 0;
  return `M${p.map(round).join(" ")}L${a.map(round).join(" ")}A${round(radius)} ${round(radius)} 0 ${large} ${to > from ? 0 : 1} ${b.map(round).join(" ")}Z`;
}

const LEGEND_SIGNS = { line: "M1 6H21", dashed: "M1 6H6M10 6H14M18 6H21", dot: "M11 2a4 4 0 1 0 .01 0" };

// An entry of a legend; `kind` names its colour.
export function legendItem(kind, sign, text) {
  return element("span", {}, svg("svg", { viewBox: "0 0 22 12", "aria-hidden": "true" },
    svg("path", { d: LEGEND_SIGNS[sign], style: `stroke:var(--${kind});stroke-width:2;fill:none` })), text);
}

// A block about the origin, along the first axis.
export function blockPath(length, height) {
  const [a, b, r] = [length / 2, height / 2, 2.5];
  return `M${-a + r} ${-b}H${a - r}A${r} ${r} 0 0 1 ${a} ${-b + r}V${b - r}A${r} ${r} 0 0 1 ${a - r} ${b}H${-a + r}A${r} ${r} 0 0 1 ${-a} ${b - r}V${-b + r}A${r} ${r} 0 0 1 ${-a + r} ${-b}Z`;
}

// The hatched face of a fixed guide from p to q, `away` pixels beside it, on its lower side.
export function guideSign(p, q, away, overhang) {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
  const [x, y] = length > 0 ? [(q[0] - p[0]) / length, (q[1] - p[1]) / length] : [1, 0];
  const side = x > 0 || (x === 0 && y < 0) ? 1 : -1;
  const [nx, ny] = [-y * side, x * side];
  const at = (along, across) => `${round(p[0] + along * x + across * nx)} ${round(p[1] + along * y + across * ny)}`;
  let hatches = "";
  for (let s = -overhang + 3; s <= length + overhang; s += 7) hatches += `M${at(s, away)}L${at(s - 5 * side, away + 6)}`;
  return svg("g", {}, svg("path", { class: "guide-axis", d: `M${at(-overhang, 0)}L${at(length + overhang, 0)}` }),
    svg("path", { class: "guide-face", d: `M${at(-overhang, away)}L${at(length + overhang, away)}` }),
    svg("path", { class: "ground-hatch", d: hatches }));
}

// An arrow from p by the vector v, with a head no longer than itself.
export function arrowPath(p, v) {
  const length = Math.hypot(v[0], v[1]);
  if (!(length > 0.5)) return "";
  const [x, y] = [v[0] / length, v[1] / length];
  const head = Math.min(8, 0.6 * length);
  const tip = [p[0] + v[0], p[1] + v[1]];
  const wing = (side) => `${round(tip[0] - head * (x + 0.42 * side * -y))} ${round(tip[1] - head * (y + 0.42 * side * x))}`;
  return `M${round(p[0])} ${round(p[1])}L${round(tip[0])} ${round(tip[1])}M${wing(1)}L${round(tip[0])} ${round(tip[1])}L${wing(-1)}`;
}

// A line through points of which some are missing.
export function pathWithGaps(points) {
  let text = "";
  let pen = "M";
  for (const p of points) {
    if (p) text += `${pen}${round(p[0])} ${round(p[1])}`;
    pen = p ? "L" : "M";
  }
  return text;
}

// Of the arc that stands for a torque: its radius in pixels, and the angles it takes.
const ARC = { radius: 25, from: -60, to: 210 };

// How far a place is from such an arc about another, all in pixels.
export function distanceToArc([x, y], [u, v]) {
  const middle = (ARC.from + ARC.to) / 2, half = (ARC.to - ARC.from) / 2;
  const off = (((Math.atan2(y - v, u - x) * 180) / Math.PI - middle + 540) % 360) - 180;
  const nearest = ((middle + Math.max(-half, Math.min(half, off))) * Math.PI) / 180;
  return Math.hypot(u - x - ARC.radius * Math.cos(nearest), v - y + ARC.radius * Math.sin(nearest));
}

// An arc about a place, with a head at the end to which a torque turns (counter-clockwise: above 0).
export function arcPath([x, y], torque) {
  if (!torque) return "";
  const at = (deg) => [x + ARC.radius * Math.cos((deg * Math.PI) / 180), y - ARC.radius * Math.sin((deg * Math.PI) / 180)];
  const [from, to] = torque > 0 ? [ARC.from, ARC.to] : [ARC.to, ARC.from];
  const [p, q] = [at(from), at(to)];
  const along = ((to + (torque > 0 ? 90 : -90)) * Math.PI) / 180;
  const wing = (turn) => [q[0] - 8 * Math.cos(along + turn), q[1] + 8 * Math.sin(along + turn)];
  const text = (point) => point.map(round).join(" ");
  return `M${text(p)}A${ARC.radius} ${ARC.radius} 0 1 ${torque > 0 ? 0 : 1} ${text(q)}M${text(wing(0.4))}L${text(q)}L${text(wing(-0.4))}`;
}
