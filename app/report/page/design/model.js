// The designs of the report: the result document's entries beside what was sampled for drawing.

import { degrees, degreesShort } from "../format.js";
import { isNoError } from "../rounding.js";
import { lookUp, RADIANS } from "../sampling.js";
import { diagonal } from "../view.js";
import { say } from "../words.js";
import { framings } from "./framing.js";
import { Linkage } from "./linkage.js";
import { Scene } from "./scene.js";
import { curveSheets } from "./sheets.js";

export const turnInto = (deg, [from, to]) => {
  const middle = (from + to) / 2;
  return deg - 360 * Math.round((deg - middle) / 360);
};

// p → shift + scale·R(deg) p.
export function placing(placement) {
  if (!placement) return (p) => p;
  const { scale, deg, shift } = placement;
  const [c, s] = [scale * Math.cos(deg * RADIANS), scale * Math.sin(deg * RADIANS)];
  return ([x, y]) => [shift[0] + c * x - s * y, shift[1] + s * x + c * y];
}

// The targets of a design as points (of poses the origins), the poses, and what is reached of them.
// A closed curve may have been moved to where the design traces it.
export function takeTargets(design, drawn, target) {
  const poses = target.poses ?? [];
  const place = placing(drawn.placement);
  Object.assign(design, { poses, targets: [...poses.map(([x, y]) => [x, y]), ...(target.points ?? []).map(place)],
    outline: (target.curve ?? []).map(place), enlarged: drawn.placement?.scale ?? 1,
    ends: target.ends ?? null, deviation: drawn.deviation ?? null, reached: drawn.reached ?? [], guided: drawn.guided ?? null });
}

// The largest distance from a target to what is reached of it.
export const largestDistance = (targets, reached) =>
  Math.max(0, ...targets.map((t, i) => (reached[i] ? Math.hypot(reached[i][0] - t[0], reached[i][1] - t[1]) : 0)));

// The part of the path that is straight: as it was sought, or to 0.1 % of its length; empty where
// there is none.
export function stretchOf({ metrics }, pointAt) {
  const from = metrics.crank_from_deg ?? metrics.crank_from_deg_at_0_001;
  const to = metrics.crank_to_deg ?? metrics.crank_to_deg_at_0_001;
  if (from === undefined || to === undefined) return [];
  const steps = 120;
  return Array.from({ length: steps + 1 }, (_, i) => pointAt(from + ((to - from) * i) / steps));
}

// A four-bar.
export class Design {
  constructor(entry, drawn, target) {
    this.entry = entry;
    this.linkage = new Linkage(entry.mechanism, drawn.motion);
    takeTargets(this, drawn, target);
    this.stations = entry.crank_deg ?? [];
    this.trace = drawn.trace?.crank_deg.length ? drawn.trace : null;
    if (this.trace) this.span = [Math.min(...this.trace.crank_deg), Math.max(...this.trace.crank_deg)];
    this.boxes = framings(this.linkage, this.targets, this.trace?.crank_deg.map((deg) => this.linkage.pose(deg)));
    this.crank = this.linkage.within(this.trace ? this.trace.crank_deg[0] : this.stations[0] ?? 0);
    const traced = this.linkage.assembles && this.linkage.point && target.kind === "straight-line";
    this.stretch = traced ? stretchOf(entry, (deg) => this.linkage.pose(deg).p) : [];
  }

  get assembles() { return this.linkage.assembles; }
  get fixedPivots() { return [this.linkage.a, this.linkage.d]; }

  // Extremes of the transmission angle over the motion drawn.
  get transmissionDrawn() {
    const all = this.linkage.poses.map((pose) => pose.transmission);
    return [Math.min(...all), Math.max(...all)];
  }

  // Those over the part of the motion that is used, where they are others than those of all that is drawn.
  get transmissionOfPart() {
    const used = this.entry.metrics.transmission_angle_deg;
    if (!(used?.max > 0)) return null;
    const [least, greatest] = this.transmissionDrawn;
    return Math.max(used.min - least, greatest - used.max) > 0.05 ? used : null;
  }

  get angular() { return true; }
  get driveName() { return say("part.crank"); }
  get from() { return this.linkage.from; }
  get to() { return this.linkage.to; }
  within(crank) { return this.linkage.within(crank); }
  pointAt(crank) { return this.linkage.exact(this.linkage.within(crank))?.p ?? null; }
  // Its links and its curve in the plane, for a picture of another design.
  outlineAt(crank) {
    const { a, d, poses, point } = this.linkage;
    const { b, c, p } = this.linkage.pose(crank);
    return { lines: [[a, b, c, d], ...(p ? [[b, p, c]] : [])], curve: point ? poses.map((pose) => pose.p) : [] };
  }

  sceneIn(frame, onDrag) { return new Scene(frame, onDrag); }
  moved(crank) { return this.linkage.pose(crank); }

  readout(crank) {
    const pose = this.linkage.pose(crank);
    const error = this.errorAt(crank);
    const text = say("readout.crank", { crank: degrees(crank, 1), rocker: degrees(pose.rocker, 1), transmission: degrees(pose.transmission, 1) });
    return error === null || isNoError(error, 1 / RADIANS) ? text : `${text} · ${say("readout.error", { error: degreesShort(error, 3) })}`;
  }

  sheets(limits) { return curveSheets(this, limits); }

  // Generated minus desired output at a crank angle, in degrees; null where none is given.
  errorAt(crank) {
    if (!this.trace) return null;
    if (this.trace.x !== null) return this.between(crank, this.trace.crank_deg, this.trace.error_deg);
    const wanted = this.#wantedPair(crank);
    return wanted === null ? null : this.linkage.pose(crank).rocker - wanted;
  }

  // `value` carried from one list to another; crank angles are first turned into the range used.
  between(value, from, to, isCrank = true) {
    return lookUp(isCrank ? turnInto(value, this.span) : value, from, to);
  }

  // The output wanted by the angle pair near a crank angle.
  #wantedPair(crank) {
    const near = this.trace.crank_deg.findIndex((deg) => Math.abs(turnInto(crank - deg, [-180, 180])) < 3);
    return near < 0 ? null : this.linkage.pose(this.trace.crank_deg[near]).rocker - this.trace.error_deg[near];
  }

  // The largest error as a length (path) or angle in degrees (function).
  get largestError() {
    if (this.trace) return Math.max(...this.trace.error_deg.map(Math.abs));
    return largestDistance(this.targets, this.reached);
  }

  // The part of the motion that plays: all of it, or what a function generator uses.
  get played() {
    if (!this.trace || this.span[1] - this.span[0] < 1) return [this.linkage.from, this.linkage.to, this.linkage.fullTurn];
    return [...this.span, false];
  }
}

// Magnifications by which errors can be drawn: 1, 2, 5, 10, … 10⁶.
export const MAGNIFICATIONS = Array.from({ length: 19 }, (_, i) => [1, 2, 5][i % 3] * 10 ** Math.floor(i / 3));

// The step at which the largest error takes about a twentieth of the picture, or 8°; 10⁴ at most, and
// none where even that would show nothing.
export function fittingMagnification(design, box) {
  if (!box) return 0;
  const wanted = design.trace ? 8 : 0.05 * diagonal(box);
  if (1e6 * design.largestError < wanted / 50) return 0;
  const fit = MAGNIFICATIONS.filter((m) => m <= 1e4 && m * design.largestError <= wanted);
  return Math.max(0, fit.length - 1);
}
