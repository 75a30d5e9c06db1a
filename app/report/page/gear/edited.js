// What can be changed of gears: their problem with all given as the design shown has it, and the numbers in that.

import { metricName, metricRows } from "../checks.js";
import { problemFields, withPart } from "../edit/problem_model.js";
import { sentence } from "../format.js";
import { keyName } from "../problem.js";
import { say } from "../words.js";
import { GEARS, gearName } from "./facts.js";

// What a search finds of spur and helical pairs.
const FOUND = ["teeth", "module", "profile_shift", "helix_deg"];

// The place of gears with given shifts is that of a distance, or that of a backlash.
export const DISTANCES = { spur: "centre_distance", helical: "centre_distance", internal: "centre_distance", rack: "rack_distance" };

const without = (table, ...keys) => Object.fromEntries(Object.entries(table).filter(([key]) => !keys.includes(key)));
const bounded = (bounds, key) => (bounds?.[key] === undefined ? {} : { bounds: { [key]: bounds[key] } });

// The problem that gives the whole of a design: a file of it finds nothing, and is judged by the same limits.
export function givenGears(problem, { mechanism: found }) {
  const { kind, mechanism, bounds, solve, ...tables } = problem;
  if (kind === "gear" || !solve) return problem;
  const settled = Object.fromEntries(FOUND.filter((key) => found[key] !== undefined).map((key) => [key, found[key]]));
  const whole = { ...mechanism, ...settled };
  const isPlaced = whole.centre_distance !== undefined;
  return { kind, ...tables, mechanism: isPlaced ? without(whole, "backlash") : whole, solve, ...(isPlaced ? {} : bounded(bounds, "centre_distance")) };
}

// Of two gears the numbers of each are named after it.
function labelOf({ path, label }, gearing) {
  const [, key, i] = path;
  if (i === undefined || !["teeth", "profile_shift", "tip_reduction"].includes(key)) return label;
  return say("edit.of_gear", { gear: gearName(["pinion", "wheel"][i], gearing), name: keyName(key, "mechanism") });
}

// One of distance and backlash; the other follows. A distance leaves nothing of a size to be least.
function placeField(key, other) {
  const set = (problem, value) => {
    const mechanism = without(problem.mechanism, key, other);
    const target = value !== undefined && key !== "backlash" && problem.target?.objective === "size" ? { target: without(problem.target, "objective") } : {};
    return { ...without(problem, "bounds"), ...target, mechanism: value === undefined ? mechanism : { ...mechanism, [key]: value } };
  };
  return { key, path: ["mechanism", key], label: sentence(keyName(key, "mechanism")), optional: true, get: ({ mechanism }) => mechanism[key], set };
}

// The numbers of a bevel pair's shifts are opposite.
function setterOf({ path, set }, gearing) {
  if (gearing !== "bevel" || path[1] !== "profile_shift") return set;
  return (problem, value) => withPart(problem, ["mechanism", "profile_shift"], path[2] ? [-value, value] : [value, -value]);
}

// Where the slider of a field goes: of counts in whole numbers.
function sliderRange({ path: [table, key] }, value) {
  if (table !== "mechanism") return {};
  if (/teeth|starts/.test(key)) return { range: [key === "starts" ? 1 : 5, Math.max(key === "starts" ? 8 : 40, 2 * value)], step: 1 };
  if (/shift/.test(key)) return { range: [-1, 1.5] };
  if (key === "helix_deg") return { range: [-45, 45] };
  return value > 0 && !/backlash|friction|reduction/.test(key) ? { range: [0.4 * value, 2 * value] } : {};
}

export function gearFields(problem) {
  const { gearing } = problem.mechanism;
  const distance = problem.kind === "gear" ? undefined : DISTANCES[gearing];
  const fields = problemFields(problem, ["mechanism", "rack", "target", "constraints"]).filter(({ path }) => !(distance && path[0] === "mechanism" && ["backlash", distance].includes(path[1])));
  const places = distance ? [placeField(distance, "backlash"), placeField("backlash", distance)] : [];
  return [...fields, ...places].map((field) => ({ ...field, label: labelOf(field, gearing), set: setterOf(field, gearing), ...sliderRange(field, field.get(problem)) }));
}

// A metric's name with the gear that it is of.
function gearMetricName(name, gearing) {
  const [, gear, of] = /^(\w+)\.(.+)$/.exec(name) ?? [];
  return GEARS.includes(gear) ? say("edit.of_gear", { gear: gearName(gear, gearing), name: metricName(of) }) : metricName(name);
}

// What the panel says of the gears now beside what they were.
export const gearRows = (before, now) => metricRows(before.designs[0]?.metrics ?? [], now.designs[0].metrics, (name) => gearMetricName(name, now.gearing));
