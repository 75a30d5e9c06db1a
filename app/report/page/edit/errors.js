// The errors of a changed four-bar at the targets of its problem. Positions are the kernel's.

import { RADIANS } from "../sampling.js";
import { placing } from "../design/model.js";

const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
const sumOfSquares = (values) => values.reduce((sum, value) => sum + value * value, 0);

function errorFigures(misses) {
  const sum = sumOfSquares(misses);
  return { sum_of_squares: sum, rms: Math.sqrt(sum / misses.length), max: Math.max(...misses.map(Math.abs)) };
}

// What the changed linkage is measured by; `problem` and `target` are the page's, `entry` the design
// as it was found. Each has `evaluate(kernel, state)`, to call when the kernel has taken the linkage:
// the crank angles at the targets in radians, how the kernel is to judge them, the errors (null where
// some target cannot be met at all), and what the picture needs.
export function measureOf(problem, target, entry, drawn) {
  const { kind } = target;
  if (kind === "function" && target.samples && entry.metrics.input_start_deg !== undefined) return new FunctionMeasure(problem, target, entry);
  if (kind === "path" && target.points.length) return new TargetMeasure(pathTargets(problem, target, entry, drawn), sequenceOf(problem), drawn.placement?.scale ?? 1);
  if (kind === "motion" && guidesByPoint(entry, drawn)) return new TargetMeasure(poseTargets(problem, target, entry, drawn), "one_sense", 1);
  return new NoMeasure(entry);
}

const sequenceOf = ({ target }) => (target.timing === "prescribed" ? "timed" : target.order === "any" ? "any" : "one_sense");

function pathTargets(problem, target, entry, drawn) {
  const { timing, crank_deg: given = [] } = problem.target;
  const place = placing(drawn.placement);
  return target.points.map((point, i) => ({ at: place(point), crank: entry.crank_deg[i] * RADIANS,
    prescribed: timing !== undefined && timing !== "free" && typeof given[i] === "number" }));
}

// Whether the body that takes the poses is the coupler, its origin P.
function guidesByPoint({ mechanism: { coupler_point: p, coupler } }, { guided }) {
  return guided?.body === 2 && p !== undefined && Math.hypot(guided.axes[0] - p[0], guided.axes[1] - p[1]) < 1e-6 * coupler;
}

// The body's angle is the coupler's and what it is turned by in it.
function poseTargets(problem, target, entry, { guided }) {
  const turned = guided.axes[2];
  const weight = problem.target.method === "least-squares" ? problem.target.angle_weight ?? 0 : 0;
  return target.poses.map(([x, y, deg], i) => ({ at: [x, y], angle: (deg - turned) * RADIANS, weight, crank: entry.crank_deg[i] * RADIANS }));
}

class NoMeasure {
  constructor({ crank_deg: stations = [] }) { this.stations = stations.map((deg) => deg * RADIANS); }

  evaluate() { return { stations: this.stations, travel: [], sequence: "any", error: null, drawn: {} }; }
}

// Points of the coupler curve, or poses of the coupler. `scale`: what one unit of the target is here.
class TargetMeasure {
  constructor(targets, sequence, scale) { Object.assign(this, { targets, sequence, scale, turns: targets[0].angle !== undefined }); }

  evaluate(kernel) {
    const { near, anywhere } = kernel.nearest(this.targets);
    const found = [near, anywhere].map((stations) => this.#at(kernel, stations));
    const [local, global] = found;
    // Another timing where the first is out of reach, or where it is clearly the better and sound.
    const less = global.misses && local.misses && sumOfSquares(global.misses) < (1 - 1e-6) * sumOfSquares(local.misses);
    const better = less ? kernel.facts(global.stations, [], this.sequence).defects.length === 0 : global.misses && !local.misses;
    const { stations, misses, poses } = better ? global : local;
    const turned = this.turns && misses ? { turned: Math.max(...poses.map((pose, i) => Math.abs(turnedBy(pose, this.targets[i])))) } : {};
    return { stations, travel: [], sequence: this.sequence, error: misses && { ...errorFigures(misses), ...turned }, angular: false,
      drawn: { reached: poses.map((pose) => pose?.p ?? null) } };
  }

  #at(kernel, stations) {
    const poses = kernel.poses(stations);
    const misses = poses.every((pose) => pose?.p) ? poses.map((pose, i) => this.#miss(pose, this.targets[i])) : null;
    return { stations, poses, misses };
  }

  #miss(pose, target) {
    const place = Math.hypot(pose.p[0] - target.at[0], pose.p[1] - target.at[1]) / this.scale;
    return target.weight ? Math.hypot(place, target.weight * turnedBy(pose, target)) : place;
  }
}

// By how much the coupler is turned from a pose that it is to take.
const turnedBy = ({ b, c }, { angle }) => wrapped(Math.atan2(c[1] - b[1], c[0] - b[0]) - angle);

// A function generator: the rocker's angle minus the desired one.
class FunctionMeasure {
  constructor(problem, { samples, range, sweep, x }, { crank_deg: stations, metrics }) {
    Object.assign(this, { samples, range, sweep, x, start: metrics.input_start_deg * RADIANS, stations: stations.map((deg) => deg * RADIANS) });
  }

  evaluate(kernel, { mechanism, starts }) {
    const [a, d] = mechanism.fixed_pivots;
    const frame = Math.atan2(d[1] - a[1], d[0] - a[0]);
    const [input, output] = [frame + starts.input_deg * RADIANS, frame + starts.output_deg * RADIANS];
    const errors = (pairs) => kernel.poses(pairs.map((pair) => input + pair[0])).map((pose, i) => (pose ? wrapped(pose.rocker - output - pairs[i][1]) : null));
    const counted = errors(this.samples);
    const shown = this.range.length ? this.range : this.samples;
    const curve = errors(shown);
    const stations = this.stations.map((angle) => angle + input - this.start);
    const closes = [...counted, ...curve].every((error) => error !== null);
    const kept = curve.map((_, i) => i).filter((i) => curve[i] !== null);
    const trace = { x: this.x && kept.map((i) => this.x[0] + ((this.x[1] - this.x[0]) * i) / (shown.length - 1)),
      crank_deg: kept.map((i) => (input + shown[i][0]) / RADIANS), error_deg: kept.map((i) => curve[i] / RADIANS) };
    return { stations, travel: this.sweep.map((angle) => input + angle), sequence: "timed", angular: true, gap: !closes,
      error: closes ? this.#figures(counted, curve, errors) : null, drawn: { trace } };
  }

  // The greatest error may lie between the places at which the domain is scanned.
  #figures(counted, curve, errors) {
    const figures = errorFigures(counted);
    if (this.range.length === 0) return figures;
    const size = (share) => Math.abs(errors([pairAt(this.range, share)])[0] ?? 0);
    const sizes = curve.map(Math.abs);
    const most = Math.max(...sizes);
    const step = 1 / (this.range.length - 1);
    const peaks = sizes.flatMap((value, i) => {
      if (value < 0.5 * most || value < (sizes[i - 1] ?? 0) || value < (sizes[i + 1] ?? 0)) return [];
      return i === 0 || i === sizes.length - 1 ? [value] : [peakOf(size, (i - 1) * step, (i + 1) * step)];
    });
    return { ...figures, max: Math.max(figures.max, ...peaks) };
  }
}

// The greatest value of `f` between `low` and `high`, where it has one peak (golden section).
function peakOf(f, low, high) {
  const ratio = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [high - ratio * (high - low), low + ratio * (high - low)];
  let [atA, atB] = [f(a), f(b)];
  for (let i = 0; i < 30; i += 1) {
    if (atA > atB) {
      [high, b, atB] = [b, a, atA];
      a = high - ratio * (high - low);
      atA = f(a);
    } else {
      [low, a, atA] = [a, b, atB];
      b = low + ratio * (high - low);
      atB = f(b);
    }
  }
  return f(0.5 * (low + high));
}

// The pair at a share of the domain, from `range` in equal steps: the polynomial through six of them.
function pairAt(range, share) {
  const place = share * (range.length - 1);
  const first = Math.max(0, Math.min(range.length - 6, Math.floor(place) - 2));
  const near = range.slice(first, first + 6);
  const weight = (j) => near.reduce((product, _, k) => (k === j ? product : (product * (place - first - k)) / (j - k)), 1);
  return [0, 1].map((part) => near.reduce((sum, pair, j) => sum + weight(j) * pair[part], 0));
}
