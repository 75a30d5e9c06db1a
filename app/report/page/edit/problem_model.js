// What can be changed of an analysed problem: every number of its tables, and joints in the picture.

import { sentence } from "../format.js";
import { keyName, unitOfKey } from "../problem.js";
import { RADIANS } from "../sampling.js";
import { knows, say } from "../words.js";
import { crossOf, FOUR_BAR_JOINTS, inFrame, lengthOf, minus } from "./four_bar.js";

const EDITED_TABLES = ["mechanism", "drive", "link", "load", "gravity"];

export const withPart = (table, [key, ...rest], value) => {
  const copy = Array.isArray(table) ? [...table] : { ...table };
  copy[key] = rest.length ? withPart(table[key], rest, value) : value;
  return copy;
};
const partOf = (table, path) => path.reduce((part, key) => part[key], table);

// Short keys of the places that mechanisms of the simple types have.
const SHORT_KEYS = { "fixed_pivots.0.0": "a_x", "fixed_pivots.0.1": "a_y", "fixed_pivots.1.0": "d_x", "fixed_pivots.1.1": "d_y", "pivot.0": "a_x", "pivot.1": "a_y",
  "centre.0": "centre_x", "centre.1": "centre_y", "coupler_point.0": "point_u", "coupler_point.1": "point_v" };

// Numbers whose sign or size is no dimension, and that no one would type.
const KEPT = /^(steps|points)$/;

const AXES = { at: "uv", centre: "uv", coupler_point: "uv" };

// Each number below `value` with its path and the words for it.
function numbersIn(value, path, words, scope) {
  if (typeof value === "number") return [{ path, words, unit: unitOfKey(path.findLast((key) => typeof key === "string"), scope) }];
  if (Array.isArray(value)) {
    return value.flatMap((part, i) => numbersIn(part, [...path, i], partWords(value, i, path, words), scope));
  }
  if (value === null || typeof value !== "object") return [];
  if (value.names && value.lengths) return [...linkLengths(value, path, scope), ...numbersIn({ ...value, lengths: null }, path, words, scope)];
  return Object.entries(value).filter(([key]) => !KEPT.test(key)).flatMap(([key, part]) => numbersIn(part, [...path, key], key === "at" ? words : [...words, keyName(key, scope)], scope));
}

// The lengths of the links of a dyad, by their names.
const linkLengths = ({ names, lengths }, path, scope) => lengths.flatMap((length, i) => numbersIn(length, [...path, "lengths", i], [names[i], keyName("length", scope)], scope));

// Entry `i` of a list in words: a table by what it names, a coordinate by its axis.
function partWords(list, i, path, words) {
  const [part, key] = [list[i], path.at(-1)];
  if (part !== null && typeof part === "object" && !Array.isArray(part)) {
    const name = part.name ?? (part.names ?? part.gears ?? part.between)?.join("–") ?? part.member ?? part.on ?? i + 1;
    return [...words.slice(0, -1), `${words.at(-1)} ${name}`];
  }
  if (typeof part === "number" && list.length === 2 && key !== "stroke") return [...words, (path.includes("pivot") ? "xy" : AXES[key] ?? "xy")[i]];
  return list.length > 1 ? [...words, String(i + 1)] : words;
}

// The fields of a problem; those of other tables than the mechanism in groups.
export function problemFields(problem, tables = EDITED_TABLES) {
  return tables.filter((name) => problem[name] !== undefined).flatMap((name) => numbersIn(problem[name], [name], name === "mechanism" ? [] : [keyName(name, "")], name).map(({ path, words, unit }) => {
    const own = path.slice(1).join(".");
    const key = name === "mechanism" ? SHORT_KEYS[own] ?? own : path.join(".");
    const label = knows(`edit.field.${key}`) ? say(`edit.field.${key}`) : sentence(words.join(", ")) + (unit ? `,${unit === "°" ? " °" : unit}` : "");
    return { key, path, label, ...(name === "mechanism" ? {} : { group: keyName(name, "") }), get: (state) => partOf(state, path), set: (state, value) => withPart(state, path, value) };
  }));
}

// The joints of the mechanism that can be dragged: each makes a mechanism of `m` where it is taken `to`, from the
// places `at` of the named points. `turns`: the drive follows it.
export function mechanismJoints(mechanism) {
  if (mechanism.type === "chain") return { ...chainJoints(mechanism), ...pointJoints(mechanism) };
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
  return { ...joints, ...pointJoints(mechanism) };
}

// Points of bodies, in whose own axes they are given.
function pointJoints({ point = [] }) {
  return Object.fromEntries(point.flatMap(({ name, on }, i) => (typeof on === "string" ? [[name, { on, drag: (m, at, to, place) => withPart(m, ["point", i, "at"], inPlace(place, to)) }]] : [])));
}

// Of a chain the fixed pivots, the pins of the crank and of its dyads, and the points of its links.
function chainJoints({ pivot = [], crank, dyad = [], point = [] }) {
  const joints = Object.fromEntries(pivot.map(({ name }, i) => [name, { drag: (m, at, to) => withPart(m, ["pivot", i, "at"], to) }]));
  if (typeof crank?.length === "number") joints[crank.pin] = { turns: true, about: crank.at, drag: (m, at, to) => withPart(m, ["crank", "length"], lengthOf(minus(to, at[crank.at]))) };
  dyad.forEach((part, i) => {
    const follow = isLinkPair(part) ? linksTo : isLinkAndSlider(part) ? sliderTo : null;
    if (follow) joints[part.new] = { drag: (m, at, to) => withPart(m, ["dyad", i], { ...m.dyad[i], ...follow(m.dyad[i], at, to) }) };
  });
  point.forEach(({ name, on }, i) => {
    if (areNames(on, 2)) joints[name] = { drag: (m, at, to) => withPart(m, ["point", i, "at"], inFrame(at[on[0]], at[on[1]], to)) };
  });
  return joints;
}

const areNames = (list, count) => Array.isArray(list) && list.length === count && list.every((name) => typeof name === "string");
const isLinkPair = ({ type = "RRR", joins, lengths = [], new: made }) => type === "RRR" && areNames(joins, 2) && lengths.length === 2 && made !== undefined;
const isLinkAndSlider = ({ type, joins, slide, new: made }) => type === "RRP" && areNames(joins, 1) && typeof slide?.through === "string" && (slide.on ?? "frame") === "frame" && made !== undefined;

// Two links whose common pin is taken `to`.
function linksTo({ joins: [p, q] }, at, to) {
  return { lengths: [p, q].map((name) => lengthOf(minus(to, at[name]))), assembly: crossOf(minus(at[q], at[p]), minus(to, at[p])) > 0 ? "open" : "crossed" };
}

// A link and the slider on whose pin it is.
function sliderTo({ joins: [p], slide }, at, to) {
  const [x, y] = alongOf(slide);
  const [u, v] = minus(to, at[p]);
  return { lengths: [Math.hypot(u, v)], slide: { ...slide, offset: crossOf([x, y], minus(to, at[slide.through])) }, assembly: u * x + v * y < 0 ? "crossed" : "open" };
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
