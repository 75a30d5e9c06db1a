// The picture of a worm and its wheel, cut along the worm's axis through the wheel's middle: there
// they mesh like a rack and a gear.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { GearBody } from "./model.js";
import { contactClass } from "./pair_scene.js";

export class WormScene extends Picture {
  constructor(frame, onDrag, isRack = false) {
    super(frame, say(isRack ? "picture.gear_pair" : "picture.worm"), onDrag);
    this.shown = { action: true, reference: true, tip: true };
    this.looks = "whole";
  }

  #box() {
    const { worm, half, length } = this;
    const [top, foot] = [worm.centre_distance + (worm.is_rack ? 0 : worm.tip), worm.centre_distance - worm.tip];
    if (this.looks === "mesh") return { x0: -length, x1: length, y0: foot - 1.6 * worm.module, y1: foot + 3.4 * worm.module };
    return { x0: -Math.max(half, this.body.tip), x1: Math.max(half, this.body.tip), y0: -this.body.tip, y1: top };
  }

  build({ drawn }) {
    const { worm } = drawn;
    Object.assign(this, { drawn, worm, body: new GearBody(drawn.gears[0]), pitchLength: Math.PI * worm.module });
    const { body } = this;
    const foot = worm.centre_distance - worm.tip;
    this.length = Math.sqrt(Math.max(0, body.tip ** 2 - foot ** 2)) + this.pitchLength;
    this.half = 1.25 * this.length + this.pitchLength;
    this.clear(body.sound ? this.#box() : null, say("picture.gear_impossible"));
    if (!body.sound) return;
    const { scale } = this.view;
    this.turning = svg("g", {}, svg("path", { class: "gear wheel", d: this.closed(body.outline()) }));
    this.threads = svg("g", {}, ...this.#threads());
    const [left, top] = this.local([-this.half, worm.centre_distance + worm.tip + worm.module]);
    const frame = { x: round(left), y: round(top), width: round(2 * scale * this.half), height: round(2 * scale * (worm.tip + worm.module)) };
    const clip = svg("clipPath", { id: "worm-ends" }, svg("rect", frame));
    const line = (y, name) => svg("path", { class: `gear-circle ${name}`, d: pathThrough([[-this.half, y], [this.half, y]].map((p) => this.local(p))) });
    const circle = (radius, name) => svg("circle", { class: `gear-circle ${name}`, r: round(scale * radius) });
    const both = (radius, name) => (worm.is_rack ? [-1] : [1, -1]).map((side) => line(worm.centre_distance + side * radius, name));
    const axis = worm.is_rack ? [line(body.reference, "working")] : [...both(worm.reference, "working"), line(worm.centre_distance, "axis")];
    this.parts = { action: svg("g", {}), reference: svg("g", {}, circle(body.reference, "working"), ...axis),
      base: circle(body.base, "base"), tip: svg("g", {}, circle(body.tip, "tip"), circle(body.root, "tip"), ...both(worm.tip, "tip"), ...both(worm.root, "tip")) };
    this.parts.action.append(svg("path", { class: "action-line", d: pathThrough([-this.length, this.length].map((t) => this.local(this.#onLine(t)))) }));
    this.dots = Array.from({ length: 8 }, () => svg("circle", { class: "gear-contact", r: 4.2 }));
    this.handle = svg("circle", { class: "handle", r: round(scale * body.tip) });
    this.world = svg("g", { class: "world", transform: `translate(${this.view.screen([0, 0]).map(round).join(" ")})` }, clip, this.turning, svg("g", { "clip-path": "url(#worm-ends)" }, this.threads),
      this.parts.tip, this.parts.reference, this.parts.base, this.parts.action, this.handle, ...this.dots);
    this.root.append(this.world, this.scaleBar());
    this.#takeHold();
    this.show(this.shown);
  }

  local([x, y]) { return [this.view.scale * x, -this.view.scale * y]; }
  closed(points) { return `${pathThrough(points.map((p) => this.local(p)))}Z`; }

  // Where the driving flanks touch, `t` beyond the pitch point.
  #onLine(t) {
    const { body, worm: { pressure_angle: angle } } = this;
    return [t * Math.cos(angle), body.reference + t * Math.sin(angle)];
  }

  // The axial section: trapezoids on both sides, that above half a lead further.
  #threads() {
    const { worm, pitchLength } = this;
    const slope = Math.tan(worm.pressure_angle);
    const count = Math.ceil(this.half / pitchLength) + (worm.is_rack ? 1 : worm.starts) + 1;
    const profile = (side, shift) => {
      const points = [];
      for (let k = -count; k <= count; ++k) {
        const at = (k + 0.5) * pitchLength + shift + (worm.offset ?? 0);
        const width = (radius) => pitchLength / 4 - (radius - worm.reference) * slope;
        for (const [sense, radius] of [[-1, worm.root], [-1, worm.tip], [1, worm.tip], [1, worm.root]]) points.push([at + sense * width(radius), worm.centre_distance + side * radius]);
      }
      return points;
    };
    const [below, above] = [profile(-1, 0), worm.is_rack ? [-1, 1].map((sense) => [sense * (count + 1) * pitchLength, worm.centre_distance]) : profile(1, (worm.starts * pitchLength) / 2)];
    return [svg("path", { class: "gear pinion", d: this.closed([...below, ...above.reverse()]) })];
  }

  #takeHold() {
    let grip = null;
    this.handle.addEventListener("pointerdown", () => { grip = null; });
    this.listen(this.handle, ([x, y]) => {
      const angle = Math.atan2(y, x) / RADIANS;
      const turn = grip === null ? 0 : angle - grip;
      grip = angle;
      return turn === 0 ? null : this.deg + (turn - 360 * Math.round(turn / 360)) * this.body.teeth / this.worm.starts;
    });
  }

  show(shown) {
    this.shown = { ...this.shown, ...shown };
    for (const [layer, part] of Object.entries(this.parts ?? {})) part.toggleAttribute("hidden", !this.shown[layer]);
  }

  // Places of contact on the line of action while the wheel has turned by `angle`.
  contacts(angle) {
    const { body, worm } = this;
    const least = worm.centre_distance - worm.tip;
    const start = Math.sqrt(Math.max(0, body.form ** 2 - body.base ** 2));
    const found = [];
    for (let k = -12; k <= 12; ++k) {
      const way = body.base * (-(angle + k * body.pitch) + body.half_angle + worm.pressure_angle);
      if (way < start || Math.hypot(way, body.base) > body.tip_end) continue;
      const p = this.#onLine(way - body.base * Math.tan(worm.pressure_angle));
      if (p[1] >= least) found.push(p);
    }
    return found;
  }

  marksAt() { return []; }

  move(deg) {
    if (!this.body?.sound) return;
    this.deg = deg;
    const way = (deg / 360) * this.worm.starts * this.pitchLength;
    const angle = way / this.body.reference;
    set(this.turning, { transform: `rotate(${(-angle / RADIANS).toFixed(4)})` });
    const lead = this.pitchLength * (this.worm.is_rack ? 1 : this.worm.starts);
    const within = way - lead * Math.round(way / lead);
    set(this.threads, { transform: `translate(${round(-this.view.scale * within)} 0)` });
    const places = this.contacts(angle - this.body.pitch * Math.round(angle / this.body.pitch));
    this.now = places.length;
    this.dots.forEach((dot, i) => {
      dot.toggleAttribute("hidden", i >= places.length);
      if (i >= places.length) return;
      const [cx, cy] = this.local(places[i]).map(round);
      set(dot, { cx, cy, class: `gear-contact ${contactClass(places.length)}` });
    });
  }
}
