// Whether a changed four-bar meets the constraints that its design was checked against: what
// problems/linkage/constraint_checks.cpp says of them, for those that lengths, angles and defects settle.

import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { lengthOf, minus } from "./four_bar.js";

const CHECK_TOLERANCE = 1e-9;
const DEGREE_TOLERANCE = CHECK_TOLERANCE / RADIANS;
// Degrees by which the greatest and least of the positions sampled may miss the limits of the rocker.
const SWING_TOLERANCE = 0.01;

// What a file specifies that designs meet by their synthesis, and that results do not check: those edited may lose it.
export function specifiedChecks({ kind, target = {}, mechanism = {}, raster = null }) {
  const equality = (name, label, bound, unit) => (typeof bound === "number" ? [{ name, label, bound, unit, relation: "=" }] : []);
  const stroke = kind === "quick-return" ? [...equality("time_ratio", say("check.time_ratio"), target.time_ratio, ""), ...equality("swing_deg", say("check.swing"), mechanism.swing_deg, "deg")] : [];
  return [...stroke, ...(raster ? [{ name: "raster", label: say("check.raster"), bound: null }] : [])];
}

// The numbers that checks of single dimensions are named after.
function dimensionOf(name, { crank, coupler, rocker, fixed_pivots: [a, d], coupler_point: p }) {
  const frame = minus(d, a);
  return { crank, coupler, rocker, frame: lengthOf(frame), "pivot_a.x": a[0], "pivot_a.y": a[1], "pivot_d.x": d[0], "pivot_d.y": d[1],
    "coupler_point.u": p?.[0], "coupler_point.v": p?.[1] }[name];
}

// Angles that a file may give, in degrees.
function givenAngle(name, { fixed_pivots: [a, d] }, starts) {
  const [x, y] = minus(d, a);
  return { "mechanism.frame_angle_deg": Math.atan2(y, x) / RADIANS, "mechanism.input_start_deg": starts?.input_deg, "mechanism.output_start_deg": starts?.output_deg }[name];
}

// The value of a check as `measured` has it and whether it is met; null for one that takes the program.
export function checkOf({ name, bound }, { mechanism, facts, swing, starts = null }) {
  const longest = Math.max(...["crank", "coupler", "rocker", "frame"].map((key) => dimensionOf(key, mechanism)));
  const shortest = Math.min(...["crank", "coupler", "rocker", "frame"].map((key) => dimensionOf(key, mechanism)));
  const [, table, key] = /^(mechanism|bounds|pivot_region)\.(.+)$/.exec(name) ?? [];
  const length = table && dimensionOf(key, mechanism);
  if (length !== undefined) return { value: length, met: isWithin(length, bound, (limit) => CHECK_TOLERANCE * Math.max(Math.abs(limit), longest)) };
  const angle = givenAngle(name, mechanism, starts);
  if (angle !== undefined && typeof bound === "number") return { value: bound + turnBetween(bound, angle), met: Math.abs(turnBetween(bound, angle)) <= DEGREE_TOLERANCE };
  if (name === "transmission_angle_deg") return transmissionCheck(bound, facts);
  if (name === "link_ratio_max") return { value: longest / shortest, met: longest / shortest <= bound * (1 + CHECK_TOLERANCE) };
  if (name === "time_ratio") return { value: facts.timeRatio, met: facts.timeRatio !== null && isWithin(facts.timeRatio, bound, (limit) => CHECK_TOLERANCE * Math.abs(limit)) };
  if (name === "swing_deg") return { value: swing, met: Math.abs(swing - bound) <= SWING_TOLERANCE };
  if (name === "class") return { value: facts.class, met: hasClass(bound, facts) };
  if (name === "full_turn") return { value: facts.class, met: hasClass("crank-rocker", facts) || hasClass("double-crank", facts) };
  const defect = /^no_(\w+)_defect$/.exec(name)?.[1];
  if (defect) return { value: facts.defects.includes(defect) ? defect : "none", met: !facts.defects.includes(defect) };
  return null;
}

// The least turn from one direction to another, in degrees.
const turnBetween = (from, to) => to - from - 360 * Math.round((to - from) / 360);

// The ends of a bound as results hold it: a number, both ends, or the one that there is.
function endsOf(bound) {
  if (Array.isArray(bound)) return [bound[0] ?? -Infinity, bound[1] ?? Infinity];
  return typeof bound === "object" ? [bound?.min ?? -Infinity, bound?.max ?? Infinity] : [bound, bound];
}

function isWithin(value, bound, allowance) {
  const [least, greatest] = endsOf(bound);
  const allowed = (limit) => (Number.isFinite(limit) ? allowance(limit) : 0);
  return value >= least - allowed(least) && value <= greatest + allowed(greatest);
}

function transmissionCheck(bound, facts) {
  const [low, high] = [facts.least / RADIANS, facts.greatest / RADIANS];
  const [least, greatest] = endsOf(bound);
  const [above, below] = [low - least, greatest - high];
  return { value: above < below ? low : high, met: Math.min(above, below) >= -DEGREE_TOLERANCE };
}

function hasClass(required, facts) {
  const grashof = facts.class !== "triple-rocker";
  if (required === "grashof") return grashof;
  if (required === "non-grashof" || required === "triple-rocker") return !grashof;
  return facts.class === required;
}
