// The picture of two gears in mesh.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { UPRIGHT } from "./model.js";

// How far a circle or a name is from being too small to read, in pixels.
const ROOM_FOR_NAMES = 46;

export class PairScene extends Picture {
  constructor(frame, onDrag) {
    super(frame, say("picture.gear_pair"), onDrag);
    this.shown = { action: true, working: true, base: true };
    this.looks = "whole";
  }

  #box() {
    const { mesh: { pinion, wheel, reach: outside, centre_distance: a } } = this;
    if (this.looks === "whole" && wheel.is_ring && wheel.isWhole) return { x0: -a - outside, x1: outside - a, y0: -outside, y1: outside };
    if (this.looks === "whole" && wheel.isWhole && pinion.isWhole) {
      const high = Math.max(pinion.tip, wheel.tip);
      return { x0: -pinion.tip, x1: a + wheel.tip, y0: -high, y1: high };
    }
    const path = Math.max(Math.abs(this.mesh.start - this.mesh.pitchPoint), Math.abs(this.mesh.end - this.mesh.pitchPoint));
    const reach = Math.max(this.looks === "whole" ? 9 * pinion.module : 3.1 * pinion.module, 1.15 * path);
    const x = a * pinion.teeth / (wheel.is_ring ? wheel.teeth - pinion.teeth : pinion.teeth + wheel.teeth);
    return { x0: x - reach, x1: x + reach, y0: -reach, y1: reach };
  }

  build(mesh) {
    this.mesh = mesh;
    this.clear(mesh.sound ? this.#box() : null, say("picture.gear_impossible"));
    if (!mesh.sound) return;
    const { scale } = this.view;
    this.world = svg("g", { class: "world" });
    this.groups = mesh.bodies.map((body, i) => this.#gear(body, i));
    this.parts = { action: svg("g", {}), base: svg("g", {}), working: svg("g", {}), tip: svg("g", {}) };
    this.#circles();
    this.#action();
    this.dots = Array.from({ length: mesh.pairs + 1 }, () => svg("circle", { class: "gear-contact", r: 4.2 }));
    this.handles = mesh.bodies.map((body) => svg("circle", { class: "handle", r: round(body.is_ring ? 0 : scale * body.tip) }));
    this.world.append(...this.groups.map(({ root }) => root), this.parts.tip, this.parts.working, this.parts.base, this.parts.action, ...this.handles, ...this.dots);
    set(this.handles[1], { cx: round(scale * this.centre(1)[0]) });
    this.root.append(this.world, this.scaleBar());
    const [x, y] = this.view.screen([0, 0]).map(round);
    set(this.world, { transform: `translate(${x} ${y})` });
    this.handles.forEach((handle, i) => this.#takeHold(handle, i));
    this.show(this.shown);
  }

  local([x, y]) { return [this.view.scale * x, -this.view.scale * y]; }
  closed(points) { return `${pathThrough(points.map((p) => this.local(p)))}Z`; }
  centre(i) { return i === 0 ? [0, 0] : [this.mesh.side * this.mesh.centre_distance, 0]; }

  // What turns together: the gear, its shaft with a key, and the tooth that is followed.
  #gear(body, i) {
    const [x, y] = this.local(this.centre(i)).map(round);
    const outline = svg("path", { class: `gear ${i ? "wheel" : "pinion"}`, d: this.closed(body.outline()) + this.#rim(body), "fill-rule": "evenodd" });
    const tooth = svg("path", { class: `gear-tooth ${i ? "wheel" : "pinion"}`, d: this.closed(body.tooth) });
    const turning = svg("g", {}, outline, ...(body.isWhole && !body.is_ring ? [this.#shaft(body)] : []));
    return { root: svg("g", { transform: `translate(${x} ${y})`, class: "gear-body" }, turning, tooth), turning, tooth };
  }

  // The outer edge of a ring.
  #rim(body) {
    if (!body.is_ring || !body.isWhole) return "";
    const r = round(this.view.scale * this.mesh.reach);
    return `M${r} 0A${r} ${r} 0 1 0 ${-r} 0A${r} ${r} 0 1 0 ${r} 0Z`;
  }

  #shaft(body) {
    const r = this.view.scale * Math.min(0.28 * body.root, 3 * body.module);
    const key = 0.28 * r;
    return svg("path", { class: "shaft hub", d: `M${round(-key)} ${round(-0.96 * r)}V${round(-1.28 * r)}H${round(key)}V${round(-0.96 * r)}A${round(r)} ${round(r)} 0 1 1 ${round(-key)} ${round(-0.96 * r)}Z` });
  }

  #circles() {
    const { scale } = this.view;
    this.mesh.bodies.forEach((body, i) => {
      const circle = (radius, name) => svg("circle", { class: `gear-circle ${name}`, cx: round(scale * this.centre(i)[0]), r: round(scale * radius) });
      this.parts.base.append(circle(body.base, "base"));
      this.parts.working.append(circle(body.working ?? (this.mesh.centre_distance * body.teeth) / (this.mesh.pinion.teeth + this.mesh.wheel.teeth), "working"));
      this.parts.tip.append(circle(body.tip, "tip"), circle(body.root, "tip"));
    });
  }

  // The line of action between the tangent points, on it the path of contact by its pairs.
  #action() {
    const { mesh, view: { scale } } = this;
    if (!mesh.meshes) return;
    const line = (from, to, name) => svg("path", { class: name, d: pathThrough([from, to].map((way) => this.local(mesh.at(way)))) });
    const beyond = 0.06 * Math.abs(mesh.span);
    this.parts.action.append(line(Math.min(0, mesh.span) - beyond, Math.max(0, mesh.span, mesh.end) + beyond, "action-line"));
    const borders = mesh.touches ? mesh.borders() : [];
    for (let i = 0; i + 1 < borders.length; ++i) {
      const [from, to] = [borders[i], borders[i + 1]];
      this.parts.action.append(line(from, to, `contact-path ${contactClass(mesh.count((from + to) / 2))}`));
    }
    if (mesh.touches && mesh.end - mesh.start < mesh.basePitch) this.parts.action.append(line(mesh.end, mesh.start + mesh.basePitch, `contact-path ${contactClass(0)}`));
    const marks = [["T₁", 0, ""], ["T₂", mesh.span, ""], ["C", mesh.pitchPoint, "pitch-point"], ...(mesh.touches ? [["A", mesh.start, "path-end"], ["E", mesh.end, "path-end"]] : []),
      ...(mesh.pairs === 2 ? [["B", mesh.end - mesh.basePitch, ""], ["D", mesh.start + mesh.basePitch, ""]] : [])];
    const named = [];
    for (const [name, way, kind] of marks) {
      const [x, y] = this.local(mesh.at(way)).map(round);
      this.parts.action.append(svg("circle", { class: `action-mark ${kind}`, cx: x, cy: y, r: kind === "pitch-point" ? 3.2 : 2.4 }));
      const isFree = named.every((other) => scale * Math.abs(other - way) > 15);
      if (scale * Math.abs(mesh.span) < ROOM_FOR_NAMES || !isFree) continue;
      named.push(way);
      this.parts.action.append(svg("text", { class: "joint-name", x: x + (way > mesh.pitchPoint ? 13 : way < mesh.pitchPoint ? -13 : -14), y: y + (way === mesh.pitchPoint ? -9 : 0) }, name));
    }
  }

  // Either gear is turned by taking hold of it.
  #takeHold(handle, i) {
    const [x0] = this.centre(i);
    let grip = null;
    handle.addEventListener("pointerdown", () => { grip = null; });
    this.listen(handle, ([x, y]) => {
      const angle = Math.atan2(y, x - x0) / RADIANS;
      const turn = grip === null ? 0 : angle - grip;
      grip = angle;
      if (turn === 0) return null;
      const whole = turn - 360 * Math.round(turn / 360);
      return this.deg + (i ? -this.mesh.side * this.mesh.ratio : 1) * whole;
    });
  }

  show(shown) {
    this.shown = { ...this.shown, ...shown };
    for (const [layer, part] of Object.entries(this.parts ?? {})) part.toggleAttribute("hidden", !this.shown[layer]);
  }

  marksAt(deg) {
    const way = this.mesh?.sound ? this.mesh.followed(deg) : null;
    return way === null ? [] : [this.mesh.at(way)];
  }

  move(deg) {
    const { mesh } = this;
    if (!mesh?.sound) return;
    this.deg = deg;
    const turns = mesh.turns(deg);
    const way = mesh.followed(deg);
    const teeth = way === null ? null : mesh.directions(way);
    const rotate = (angle) => `rotate(${((UPRIGHT - angle) / RADIANS).toFixed(4)})`;
    this.groups.forEach(({ turning, tooth }, i) => {
      const body = mesh.bodies[i];
      const facing = i === 0 || body.is_ring ? 0 : Math.PI;
      set(turning, { transform: rotate(facing + body.shown(turns[i] - facing)) });
      tooth.toggleAttribute("hidden", teeth === null);
      if (teeth) set(tooth, { transform: rotate(teeth[i]) });
    });
    const ways = mesh.contacts(deg);
    this.dots.forEach((dot, i) => {
      dot.toggleAttribute("hidden", i >= ways.length);
      if (i >= ways.length) return;
      const [cx, cy] = this.local(mesh.at(ways[i])).map(round);
      set(dot, { cx, cy, class: `gear-contact ${contactClass(ways.length)}` });
    });
  }
}

export const contactClass = (count) => (count > 1 ? "shared" : count === 1 ? "alone" : "lost");
