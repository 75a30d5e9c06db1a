// A design that is no four-bar: its bodies move as the analysis kernel sampled them.

import { lengthText } from "../fact_text.js";
import { degrees, number, sentence } from "../format.js";
import { Mechanism } from "../mechanism.js";
import { interpolate, locate, lookUp } from "../sampling.js";
import { boxOf } from "../view.js";
import { say, term } from "../words.js";
import { DesignMechanismScene, EmptyScene } from "./design_mechanism_scene.js";
import { largestDistance, stretchOf, takeTargets, turnInto } from "./model.js";
import { deviationSheet, distanceSheet, maximumOf, overDrive, structuralErrorSheet } from "./sheets.js";
import { Walk } from "./walk.js";

// The samples from the first to the last at which every body is placed.
function placedSamples(drawn) {
  const { bodies, drive } = drawn;
  const placed = (k) => bodies.every((body) => ["x", "y", "deg"].every((track) => !Array.isArray(body[track]) || body[track][k] !== null));
  const first = drive.findIndex((_, k) => placed(k));
  if (first < 0) return null;
  const last = drive.findLastIndex((_, k) => placed(k));
  const cut = (track) => (Array.isArray(track) ? track.slice(first, last + 1) : track);
  return { ...drawn, drive: cut(drive), bodies: bodies.map((body) => ({ ...body, x: cut(body.x), y: cut(body.y), deg: cut(body.deg) })) };
}

export class MechanismDesign {
  constructor(entry, drawn, target) {
    this.entry = entry;
    takeTargets(this, drawn, target);
    const samples = drawn.mechanism && placedSamples(drawn.mechanism);
    this.angular = drawn.drive?.kind !== "slider";
    this.driveName = drawn.drive ? sentence(term(drawn.drive.name)) : say("part.drive");
    this.stations = drawn.stations ?? [];
    this.trace = drawn.trace?.crank_deg.length ? drawn.trace : null;
    this.errors = this.trace && (this.trace.error_deg ?? this.trace.error);
    if (this.trace) this.span = [Math.min(...this.trace.crank_deg), Math.max(...this.trace.crank_deg)];
    this.assembles = Boolean(samples) && samples.drive.length > 1;
    const ends = this.assembles ? [samples.drive[0], samples.drive.at(-1)] : [0, 1];
    this.fullTurn = Boolean(drawn.drive?.round);
    [this.from, this.to] = ends;
    Object.assign(this, { boxes: { curve: null, moving: null, whole: null }, stretch: [], crank: 0 });
    if (!this.assembles) return;
    this.mechanism = new Mechanism(samples, { from: this.from, to: this.to, round: this.fullTurn });
    const traced = (point) => (target.point ? point.name === target.point : point.name === "P" && !point.isPin);
    this.point = this.mechanism.points.find((point) => traced(point) && point.moves) ?? null;
    this.boxes = this.#boxes();
    this.stretch = target.kind === "straight-line" ? stretchOf(entry, (drive) => this.pointAt(drive)) : [];
    this.walk = this.#walk(target);
    this.crank = this.within(this.stations[0] ?? this.walk?.from ?? this.from);
  }

  get fixedPivots() { return this.mechanism.pins.filter((pin) => pin.fixed).map((pin) => pin.path[0]); }

  // Of a leg how its foot walks; nothing where it has no stance.
  #walk({ kind }) {
    const { crank_deg: ends = [], metrics } = this.entry;
    if (kind !== "leg" || !this.point || ends.length !== 2 || !this.point.path.every(Boolean)) return null;
    return new Walk(ends, this.mechanism.samples, this.point.path, metrics);
  }

  // The coordinate within the motion that is nearest to `drive`.
  within(drive) {
    if (!this.assembles) return drive;
    if (this.fullTurn || !this.angular) return this.mechanism.within(drive);
    return this.mechanism.within(turnInto(drive, [this.from, this.to]));
  }

  // Whether the output turns; else it slides along its own first axis.
  get outputTurns() { return Array.isArray(this.mechanism.bodies[this.mechanism.output].deg); }

  // Angle of the output in degrees, or its way along its slide from where it stands first.
  outputAt(drive) {
    const [x, y, c, s] = this.mechanism.places(drive)[this.mechanism.output];
    if (this.outputTurns) {
      const { deg } = this.mechanism.bodies[this.mechanism.output];
      return interpolate(deg, locate(this.mechanism.samples, this.mechanism.within(drive)));
    }
    const [x0, y0] = this.mechanism.places(this.from)[this.mechanism.output];
    return (x - x0) * c + (y - y0) * s;
  }

  get outputName() { return term(this.mechanism.bodies[this.mechanism.output].name); }

  pointAt(drive) {
    return this.point && Mechanism.point(this.mechanism.places(drive)[this.point.body], this.point.at);
  }

  #boxes() {
    const moving = this.mechanism.box;
    const corners = [[moving.x0, moving.y0], [moving.x1, moving.y1]];
    return { curve: this.point ? boxOf([...this.point.path, ...this.targets]) : null, moving, whole: boxOf([...corners, ...this.targets]) };
  }

  errorAt(crank) { return this.trace?.x ? this.between(crank, this.trace.crank_deg, this.errors) : null; }
  get largestError() { return this.trace ? Math.max(...this.errors.map(Math.abs)) : largestDistance(this.targets, this.reached); }

  // `value` carried from one list to another; crank angles are first turned into the range used.
  between(value, from, to, isCrank = true) {
    return lookUp(isCrank ? turnInto(value, this.span) : value, from, to);
  }
  get played() { return [this.from, this.to, this.fullTurn]; }

  sceneIn(frame, onDrag) {
    return this.assembles ? new DesignMechanismScene(frame, this, onDrag) : new EmptyScene(frame);
  }

  moved(drive) { return drive; }

  // Its bodies and its curve in the plane, for a picture of another design.
  outlineAt(drive) {
    const places = this.mechanism.places(this.within(drive));
    const lines = this.mechanism.bodies.flatMap(({ outline }, i) => (i && places[i] && outline.length > 1 ? [outline.map((at) => Mechanism.point(places[i], at))] : []));
    return { lines, curve: this.point?.path ?? [] };
  }

  readout(drive) {
    const at = this.angular ? degrees(drive, 1) : number(drive, 5);
    const output = this.outputTurns ? degrees(this.outputAt(drive), 1) : lengthText(this.outputAt(drive), 5);
    return `${this.driveName.toLowerCase()} ${at} · ${this.outputName} ${output}`;
  }

  sheets() {
    const turns = this.outputTurns;
    const drives = this.mechanism.samples;
    const values = drives.map((drive) => this.outputAt(drive));
    const [least, greatest] = [Math.min(...values), Math.max(...values)];
    const text = (v) => (turns ? degrees(v, 1) : say("sheet.length", { value: number(v, 6) }));
    const stroke = maximumOf(this.entry.metrics?.circuit_stroke, greatest - least);
    const sheet = { ...overDrive(this), x: drives, title: say(turns ? "sheet.angle_of" : "sheet.displacement_of", { name: this.outputName }),
      lines: [{ y: values, colour: "--rocker" }], note: say(turns ? "sheet.swing" : "sheet.stroke", { value: text(turns ? greatest - least : stroke) }), summary: say("curves.range", { least: text(least), greatest: text(greatest) }) };
    if (this.walk) return [...this.walk.sheets(overDrive(this)), sheet];
    const error = this.trace ? structuralErrorSheet(this) : this.stretch.length ? deviationSheet(this) : distanceSheet(this);
    return [sheet, error].filter(Boolean);
  }
}
