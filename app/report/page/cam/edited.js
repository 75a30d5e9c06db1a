// What can be changed of a cam: its problem with all given as the design shown has it, and the numbers in that.

import { metricRows } from "../checks.js";
import { problemFields, withPart } from "../edit/problem_model.js";
import { withoutRounding } from "../rounding.js";
import { say } from "../words.js";
import { camMetrics, radiusKeyOf } from "./facts.js";

// More numbers than these are no fields of a form.
const MOST_NUMBERS = 120;

// Of the table of a design's mechanism these have tables of their own in a file, or follow from the rest.
const NO_LENGTHS = ["type", "follower", "side", "closure", "breadth", "arms_deg", "motion", "preload"];

// The problem that gives the whole of a design: a file of it finds nothing, and is judged by the same limits.
export function givenCam({ bounds = {}, raster, ...problem }, { mechanism }) {
  const lengths = Object.fromEntries(Object.entries(mechanism).filter(([key]) => !NO_LENGTHS.includes(key)));
  // The distance of parallel contacts follows from the base radius; that of conjugate rollers does not.
  const { breadth: asked, ...follower } = problem.follower;
  const breadth = mechanism.closure === "conjugate" ? mechanism.breadth : undefined;
  return { ...problem, follower: { ...follower, ...(breadth === undefined ? {} : { breadth }) }, motion: mechanism.motion, mechanism: lengths,
    ...(Object.keys(bounds).length ? { bounds } : {}) };
}

// Bounds of lengths that lie within them alone: what is given beyond a bound, a file may not have.
function withinBounds({ bounds, ...problem }) {
  const kept = Object.entries(bounds ?? {}).filter(([key, bound]) => {
    const [low, high] = Array.isArray(bound) ? bound : [bound.min ?? -Infinity, bound.max ?? Infinity];
    return !(problem.mechanism[key] < low || problem.mechanism[key] > high);
  });
  return kept.length ? { ...problem, bounds: Object.fromEntries(kept) } : problem;
}

// The others of a list, beginning behind entry i and going round.
const behind = (list, i) => Array.from({ length: list.length - 1 }, (_, k) => (i + 1 + k) % list.length);

// Segment i with the number `key` as `value`; that of another segment, `giving` way, keeps the sum of both.
function shared(problem, i, key, value, giving, size) {
  const { motion } = problem;
  if (giving === undefined) return withPart(problem, ["motion", i, key], value);
  const rest = withoutRounding(motion[giving][key] + motion[i][key] - value, size);
  return withPart(withPart(problem, ["motion", i, key], value), ["motion", giving, key], rest);
}

// All angles make a turn: the next dwell gives way, or else the next segment.
function withAngle(problem, i, value) {
  const others = behind(problem.motion, i);
  return shared(problem, i, "over_deg", value, others.find((k) => problem.motion[k].law === "dwell") ?? others[0], 360);
}

// All rises come back to the base circle: the next one of the other sense gives way.
function withRise(problem, i, key, value) {
  const { motion } = problem;
  const size = Math.max(...motion.map((segment) => Math.abs(segment[key] ?? 0)));
  return shared(problem, i, key, value, behind(motion, i).find((k) => motion[k][key] * motion[i][key] < 0), size);
}

function setterOf(field) {
  const [table, i, key, ...deeper] = field.path;
  if (table !== "motion" || deeper.length) return field.set;
  if (key === "over_deg") return (problem, value) => withAngle(problem, i, value);
  return /^rise/.test(key) ? (problem, value) => withRise(problem, i, key, value) : field.set;
}

// Where the slider of a field goes; only lengths, angles of the motion and rises have one.
function sliderRange({ path }, value, problem) {
  const [table, , key] = path;
  if (table === "mechanism") return path.at(-1) === "offset" || path.at(-1) === "face_offset" ? [-0.9 * problem.mechanism.base_radius, 0.9 * problem.mechanism.base_radius] : value > 0 ? [0.2 * value, 3 * value] : undefined;
  if (table !== "motion" || path.length > 3) return undefined;
  return key === "over_deg" ? [1, 359] : /^rise/.test(key) && value ? [Math.min(0, 3 * value), Math.max(0, 3 * value)] : undefined;
}

// A file's base radius is that of the circle about which the roller's centre lies.
const labelOf = ({ key, label }, { follower: { type } }) => (key === "base_radius" ? say(`cam.${radiusKeyOf(type)}`) : label);

export function camFields(problem) {
  const all = problemFields(problem, ["mechanism", "motion", "follower", "drive", "contact", "constraints"]);
  const few = all.filter(({ path: [table] }) => table !== "motion").length + 1 < all.length && all.length > MOST_NUMBERS ? all.filter(({ path: [table] }) => table !== "motion") : all;
  return few.map((field) => {
    const set = setterOf(field), range = sliderRange(field, field.get(problem), problem);
    return { ...field, label: labelOf(field, problem), ...(range ? { range } : {}), open: field.path[0] === "motion", set: (state, value) => withinBounds(set(state, value)) };
  });
}

const shownMetrics = ({ designs: [design] }) => camMetrics(design?.metrics ?? []);

// What the panel says of the cam now beside what it was.
export const camRows = (before, now) => metricRows(shownMetrics(before), shownMetrics(now));
