// The picture of the linkage. `build` draws what stands still, `move` places what moves.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { barPath, groundSign, legendItem, pathThrough, round, sectorPath } from "../shapes.js";
import { fourBarRates } from "../vectors.js";
import { say } from "../words.js";
import { aimsOf } from "./aims.js";
import { backdropOf, GuidedAxes, targetsOf } from "./backdrop.js";

const LINKS = ["crank", "coupler", "rocker"];

// Room that a name needs to other joints, in pixels, and the angles by which it turns away from where it would stand.
const NAME_ROOM = 14;
const TURNS = [0, 50, -50, 100, -100, 150, -150].map((deg) => deg * RADIANS);

// The place of a name `away` from its joint p, as near to `direction` as leaves room to the `others`.
function besideJoint([x, y], direction, away, others) {
  const at = (turn) => [x + away * Math.cos(direction + turn), y + away * Math.sin(direction + turn)];
  const isFree = ([u, v]) => others.every((q) => Math.hypot(u - q[0], v - q[1]) > NAME_ROOM);
  return TURNS.map(at).find(isFree) ?? at(0);
}

export class Scene extends Picture {
  constructor(frame, onDrag) {
    super(frame, say("picture.linkage"), onDrag);
  }

  // `design`: linkage, targets, reached, trace (of a function, or null); `options`: framing,
  // magnify, loci, shownLoci.
  build(design, options) {
    Object.assign(this, { design, options });
    const { assembles } = design.linkage;
    this.clear(assembles ? design.boxes[options.framing] : null, say("picture.links_not_assembled"));
    if (!assembles) return;
    const { linkage } = design;
    const [a, d] = [this.view.screen(linkage.a), this.view.screen(linkage.d)];
    this.axes = new GuidedAxes(this.view, design.guided);
    this.root.append(
      svg("path", { class: "frame-line", d: pathThrough([a, d]) }), ...this.#paths(), ...backdropOf(this.view, design, options), ...this.#sectors(a, d),
      groundSign(a), groundSign(d), ...this.#movingParts(), ...targetsOf(this.view, design, options), this.axes.part, this.scaleBar());
  }

  legend() {
    return [legendItem("crank", "line", say("part.crank")), legendItem("coupler", "line", say("part.coupler")), legendItem("rocker", "line", say("part.rocker"))];
  }

  get drives() { return this.design.linkage.cranks; }

  // Which link a part of the drawing is of, where it stands, and what it is called.
  bodyOf(part) { return part.classList?.contains("link-body") ? LINKS.findIndex((name) => part.classList.contains(name)) + 1 : undefined; }
  placeOf(body, crank) { return this.design.linkage.placeOf(body, this.design.linkage.pose(crank)); }
  nameOf(body) { return say(`part.${LINKS[body - 1]}`); }
  // Places that things of the picture reach.
  get crowd() {
    const { linkage } = this.design;
    return [linkage.a, linkage.d, ...linkage.poses.flatMap(({ b, c, p }) => (p ? [b, c, p] : [b, c]))];
  }

  get aims() { return aimsOf(this.design); }
  get wanted() { return this.design.outline; }

  marksAt(crank) {
    const { b, c, p } = this.design.linkage.pose(crank);
    return p ? [p] : [b, c];
  }

  jointsAt(crank) {
    const { linkage } = this.design;
    return { a: linkage.a, d: linkage.d, ...linkage.pose(crank) };
  }

  ratesAt(crank) { return fourBarRates(this.jointsAt(crank)); }

  #paths() {
    const { linkage } = this.design;
    const line = (key) => pathThrough(linkage.poses.map((pose) => this.view.screen(pose[key])));
    const paths = ["b", "c"].map((key) => svg("path", { class: "circle-path", d: line(key) }));
    if (linkage.point) paths.push(svg("path", { class: "path", d: line("p") }));
    return paths;
  }

  // Of a function generator: the parts of the turn of input and output that are used.
  #sectors(a, d) {
    const { trace, linkage } = this.design;
    if (!trace) return [];
    const sector = (kind, centre, length, angles) => svg("path", {
      class: `sweep ${kind}`,
      d: sectorPath(centre, length * this.view.scale, Math.min(...angles), Math.max(...angles)) });
    return [sector("crank", a, linkage.mechanism.crank, trace.crank_deg),
      sector("rocker", d, linkage.mechanism.rocker, trace.crank_deg.map((deg) => linkage.pose(deg).rocker))];
  }

  #movingParts() {
    const part = (name, attributes) => svg(name, attributes);
    this.parts = {
      coupler: part("path", { class: "link-body coupler" }), edge: part("path", { class: "coupler-edge" }), rocker: part("path", { class: "link-body rocker" }),
      crank: part("path", { class: "link-body crank" }), wanted: part("path", { class: "wanted" }),
      pinA: part("circle", { class: "pin", r: 4.5 }), pinD: part("circle", { class: "pin", r: 4.5 }),
      pinB: part("circle", { class: "pin", r: 4.5, id: "pin-b" }), pinC: part("circle", { class: "pin", r: 4.5 }),
      point: part("circle", { class: "coupler-point", r: 5.5, id: "coupler-point" }),
      names: Object.fromEntries(["A", "B", "C", "D", "P"].map((n) => [n, svg("text", { class: "joint-name" }, n)])),
      handleB: part("circle", { class: "handle", r: 24 }), handleP: part("circle", { class: "handle", r: 18 }),
    };
    this.listen(this.parts.handleB, (p) => this.#crankToward(p));
    this.listen(this.parts.handleP, (p) => this.#crankNear(p));
    const { names, wanted, handleB, handleP, point, ...links } = this.parts;
    const shown = [...Object.values(links), wanted];
    if (this.design.linkage.point) shown.push(point, handleP); else names.P.remove();
    return [...shown, ...Object.values(names).filter((n) => n !== names.P || this.design.linkage.point), handleB];
  }

  move(pose) {
    if (!this.design.linkage.assembles) return;
    const { linkage, guided } = this.design;
    this.axes.move(guided && linkage.placeOf(guided.body, pose));
    const at = { A: linkage.a, B: pose.b, C: pose.c, D: linkage.d, P: pose.p };
    for (const key of Object.keys(at)) if (at[key]) at[key] = this.view.screen(at[key]);
    const { parts } = this;
    const radius = (p, q) => Math.min(7, Math.max(2.5, 0.2 * Math.hypot(p[0] - q[0], p[1] - q[1])));
    set(parts.crank, { d: barPath(at.A, at.B, radius(at.A, at.B)) });
    set(parts.rocker, { d: barPath(at.D, at.C, Math.min(7, radius(at.D, at.C))) });
    const coupler = `${pathThrough(at.P ? [at.B, at.C, at.P] : [at.B, at.C])}Z`;
    for (const shape of [parts.coupler, parts.edge]) set(shape, { d: coupler });
    const place = (circle, p) => set(circle, { cx: round(p[0]), cy: round(p[1]) });
    for (const [key, name] of [["pinA", "A"], ["pinB", "B"], ["pinC", "C"], ["pinD", "D"], ["handleB", "B"]]) place(parts[key], at[name]);
    if (at.P) for (const key of ["point", "handleP"]) place(parts[key], at.P);
    this.#moveNames(at);
    this.#moveWanted(pose, at.D);
  }

  // Each name stands beside its joint: of fixed pivots on the outer side of the ground sign, of others
  // away from the middle of the linkage.
  #moveNames(at) {
    const known = Object.values(at).filter(Boolean);
    const middle = [0, 1].map((k) => known.reduce((sum, p) => sum + p[k], 0) / known.length);
    for (const [name, text] of Object.entries(this.parts.names)) {
      const p = at[name];
      if (!p) continue;
      const other = { A: at.D, D: at.A }[name];
      const [x, y] = other ? [p[0] < other[0] ? -1 : 1, 0.55] : [p[0] - middle[0], p[1] - middle[1]];
      const [u, v] = besideJoint(p, Math.atan2(y, x), other ? 22 : 18, known.filter((q) => q !== p));
      set(text, { x: round(u), y: round(v) });
    }
  }

  // Of a function generator: where the output should stand, its error as many times as asked.
  #moveWanted(pose, d) {
    const error = this.design.errorAt?.(pose.crank) ?? null;
    if (error === null) return set(this.parts.wanted, { d: "" });
    const length = this.design.linkage.mechanism.rocker * this.view.scale * 1.12;
    const deg = pose.rocker - this.options.magnify * error;
    set(this.parts.wanted, { d: pathThrough([d, [d[0] + length * Math.cos(deg * RADIANS), d[1] - length * Math.sin(deg * RADIANS)]]) });
  }

  #crankToward([x, y]) {
    const [ax, ay] = this.design.linkage.a;
    return Math.atan2(y - ay, x - ax) / RADIANS;
  }

  // The crank angle that brings the coupler point nearest, not far from the present one: a curve
  // that crosses itself is followed through.
  #crankNear([x, y]) {
    const { linkage, crank } = this.design;
    let best = null;
    let least = Infinity;
    for (const pose of linkage.poses) {
      const turn = Math.abs(pose.crank - crank - 360 * Math.round((pose.crank - crank) / 360));
      const distance = Math.hypot(pose.p[0] - x, pose.p[1] - y);
      if (turn < 50 && distance < least) [best, least] = [pose.crank, distance];
    }
    return best;
  }
}
