// What can be changed of a mechanism of a simple type, as numbers and by its joints in the picture.

import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { crossOf, FOUR_BAR_JOINTS, inFrame, lengthOf, minus } from "./four_bar.js";
import { MECHANISM_KEYS } from "./mechanism_kernel.js";

const withPart = (table, [key, ...rest], value) => {
  const copy = Array.isArray(table) ? [...table] : { ...table };
  copy[key] = rest.length ? withPart(table[key], rest, value) : value;
  return copy;
};
const partOf = (table, path) => path.reduce((part, key) => part[key], table);

const PAIR_NAMES = { pivot: ["a_x", "a_y"], centre: ["centre_x", "centre_y"], coupler_point: ["point_u", "point_v"] };

// Every number of the table, with the words for it.
export function mechanismFields(mechanism) {
  const field = (key, path, label, positive = false) => ({ key, label, positive, get: (s) => partOf(s, path), set: (s, value) => withPart(s, path, value) });
  const own = MECHANISM_KEYS[mechanism.type].flatMap(([key, form]) => {
    if (form === "assembly" || mechanism[key] === undefined) return [];
    if (form === "pivots") return [["a_x", 0, 0], ["a_y", 0, 1], ["d_x", 1, 0], ["d_y", 1, 1]].map(([name, i, k]) => field(name, [key, i, k], say(`edit.field.${name}`)));
    if (Array.isArray(mechanism[key])) return PAIR_NAMES[key].map((name, k) => field(name, [key, k], say(`edit.field.${name}`)));
    return [field(key, [key], say(`edit.field.${key}`), form === "length")];
  });
  return [...own, ...(mechanism.point ?? []).flatMap(({ name }, i) => ["u", "v"].map((axis, k) => field(`${name}_${axis}`, ["point", i, "at", k], `${name}, ${axis}`)))];
}

// Whether the kernel can be given it: no chain, and no point of axes through other points.
export function isEditable(mechanism = {}) {
  const keys = MECHANISM_KEYS[mechanism.type];
  return keys !== undefined && keys.every(([key, form]) => form === "point" || key in mechanism) && (mechanism.point ?? []).every(({ on }) => typeof on === "string");
}

// The joints that can be dragged: each makes a mechanism of `m` where it is taken `to`, from the
// places `at` of the named points. `turns`: the drive follows it.
export function mechanismJoints(mechanism) {
  const pivots = { fixed_pivots: { A: ["fixed_pivots", 0], D: ["fixed_pivots", 1] }, pivot: { A: ["pivot"] } };
  const driven = mechanism.fixed_pivots ? "fixed_pivots" : "pivot";
  const joints = Object.fromEntries(Object.entries(mechanism[driven] ? pivots[driven] : {}).map(([name, path]) => [name, { drag: (m, at, to) => withPart(m, path, to) }]));
  const inLine = mechanism.type === "slider-crank" || mechanism.type === "fixed-block";
  if (mechanism.type === "four-bar") {
    for (const name of ["B", "C"]) joints[name] = { turns: name === "B", drag: (m, at, to) => FOUR_BAR_JOINTS[name].drag(m, { b: at.B, c: at.C }, to) };
    if (mechanism.coupler_point) joints.P = { drag: (m, at, to) => ({ ...m, coupler_point: inFrame(at.B, at.C, to) }) };
  } else if ("crank" in mechanism) {
    joints.B = { turns: true, drag: (m, at, to) => ({ ...m, crank: lengthOf(minus(to, at.A)), ...(inLine ? { coupler: lengthOf(minus(at.C, to)), ...sideOf(m, to, at.C) } : {}) }) };
  }
  if (inLine) {
    joints.C = { drag: (m, at, to) => ({ ...m, coupler: lengthOf(minus(to, at.B)), offset: crossOf(alongOf(m), minus(to, at.A)), ...sideOf(m, at.B, to) }) };
  }
  (mechanism.point ?? []).forEach(({ name, on }, i) => { joints[name] = { on, drag: (m, at, to, place) => withPart(m, ["point", i, "at"], inPlace(place, to)) }; });
  return joints;
}

const alongOf = ({ direction_deg: deg }) => [Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];

// Of a slider-crank whether C is ahead of B along the slide.
function sideOf(m, b, c) {
  const [x, y] = alongOf(m);
  const [u, v] = minus(c, b);
  return { assembly: u * x + v * y < 0 ? "crossed" : "open" };
}

// `p` in the axes of a body's place.
function inPlace([x, y, c, s], p) {
  const [u, v] = minus(p, [x, y]);
  return [c * u + s * v, c * v - s * u];
}
