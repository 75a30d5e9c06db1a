// The picture of a gear that a rack cuts: the rack rolls on it, and what it has passed is gone.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { GearBody, PARTS, polar, turned, UPRIGHT } from "./model.js";

// Positions of the rack that have cut, and of how many of them one is drawn as a line.
const CUTS = 120;
const LINE_OF_CUTS = 4;

export class RackScene extends Picture {
  constructor(frame, onDrag) {
    super(frame, say("picture.gear_rack"), onDrag);
    this.shown = { flank: true, envelope: true, base: true, form: true };
    this.held = "gear";
  }

  #box() {
    const { body, range: { pitchLength } } = this.generation;
    const reach = Math.min(1.15 * pitchLength, 1.05 * body.tip);
    return { x0: -reach, x1: reach, y0: body.root - 0.8 * body.module, y1: body.tip + 0.9 * body.module };
  }

  build(generation) {
    this.generation = generation;
    const { body } = generation;
    this.clear(body.sound ? this.#box() : null, say("picture.gear_impossible"));
    if (!body.sound) return;
    this.world = svg("g", { class: "world" });
    this.turning = svg("g", {});
    const rack = this.#rackPath();
    this.cuts = generation.cuts.map((angle, i) => ({ angle, part: this.#placed(svg("path", { class: "rack-cut", d: rack }), angle),
      line: i % LINE_OF_CUTS ? null : this.#placed(svg("path", { class: "rack-trace", d: rack }), angle) }));
    this.present = svg("path", { class: "rack-cut", d: rack });
    this.rack = svg("path", { class: "rack", d: rack });
    const blank = this.#blank();
    const clip = svg("clipPath", { id: "rack-blank" }, svg("path", { d: blank }));
    this.parts = { envelope: svg("g", { "clip-path": "url(#rack-blank)" }, ...this.cuts.flatMap(({ line }) => (line ? [line] : []))), flank: this.#flank(), base: this.#circle(body.base, "base"), form: this.#circle(body.form, "form"),
      reference: this.#circle(body.reference, "working"), tip: svg("g", {}, this.#circle(body.tip, "tip"), this.#circle(body.root, "tip")) };
    this.turning.append(clip, svg("path", { class: "gear pinion blank", d: blank }), ...this.cuts.map(({ part }) => part), this.present, this.parts.envelope, svg("path", { class: "gear-outline", d: this.closed(body.outline()) }), this.parts.flank);
    this.dots = [1, -1].map(() => svg("circle", { class: "gear-contact alone", r: 4.2 }));
    this.handle = svg("circle", { class: "handle", r: round(this.view.scale * (body.tip + 2 * body.module)) });
    this.world.append(this.turning, this.parts.tip, this.parts.reference, this.parts.base, this.parts.form, this.rack, this.handle, ...this.dots);
    this.root.append(this.world, this.scaleBar());
    const [x, y] = this.view.screen([0, 0]).map(round);
    this.origin = `translate(${x} ${y})`;
    this.#takeHold();
    this.show(this.shown);
  }

  local([x, y]) { return [this.view.scale * x, -this.view.scale * y]; }
  closed(points) { return `${pathThrough(points.map((p) => this.local(p)))}Z`; }

  // The rack as far as it is ever seen, closed above.
  #rackPath() {
    const { rack, range, body } = this.generation;
    const side = 2 + Math.ceil(range.travel / range.pitchLength);
    const points = [];
    for (let k = -side; k <= side; ++k) points.push(...rack.map(([x, y]) => [x + k * range.pitchLength, y]));
    const top = body.tip + 1.1 * body.module;
    return this.closed([...points, [points.at(-1)[0], top], [points[0][0], top]]);
  }

  // Where the rack is, seen from the gear, after the gear has turned by `angle`.
  #placed(part, angle) {
    const way = this.view.scale * this.generation.body.reference * angle;
    set(part, { transform: `rotate(${(angle / RADIANS).toFixed(4)}) translate(${round(-way)} 0)` });
    return part;
  }

  // The gear, uncut about its upright tooth.
  #blank() {
    const { body } = this.generation;
    const steps = 24;
    const arc = Array.from({ length: steps + 1 }, (_, i) => polar(body.tip, UPRIGHT + body.pitch * ((2 * i) / steps - 1)));
    const others = [];
    for (let k = 1; k < body.teeth; ++k) {
      const tooth = body.tooth.map((p) => turned(p, k * body.pitch));
      const middle = tooth.length / 2;
      others.push(...(k === 1 ? tooth.slice(middle) : k === body.teeth - 1 ? tooth.slice(0, middle) : tooth));
    }
    return this.closed([...arc, ...others]);
  }

  // The upright tooth by what its parts are.
  #flank() {
    const { body: { points, half: { part } } } = this.generation;
    const runs = [];
    points.forEach((p, i) => {
      if (!runs.length || runs.at(-1).kind !== part[i]) runs.push({ kind: part[i], points: i ? [points[i - 1]] : [] });
      runs.at(-1).points.push(p);
    });
    const sides = [1, -1].flatMap((side) => runs.map(({ kind, points: run }) => svg("path", { class: `tooth-part ${PARTS[kind]}`, d: pathThrough(run.map(([x, y]) => this.local([side * x, y]))) })));
    return svg("g", {}, ...sides);
  }

  #circle(radius, name) { return svg("circle", { class: `gear-circle ${name}`, r: round(this.view.scale * radius) }); }

  #takeHold() {
    let grip = null;
    this.handle.addEventListener("pointerdown", () => { grip = null; });
    this.listen(this.handle, ([x, y]) => {
      const angle = (this.held === "gear" ? -1 : 1) * Math.atan2(y, x) / RADIANS;
      const turn = grip === null ? 0 : angle - grip;
      grip = angle;
      return turn === 0 ? null : this.deg + turn - 360 * Math.round(turn / 360);
    });
  }

  show(shown) {
    this.shown = { ...this.shown, ...shown };
    for (const [layer, part] of Object.entries(this.parts ?? {})) part.toggleAttribute("hidden", !this.shown[layer]);
  }

  marksAt(deg) {
    const { generation } = this;
    return generation?.body.sound ? generation.contacts(deg * RADIANS).map((p) => p && (this.held === "gear" ? turned(p, -deg * RADIANS) : p)).filter(Boolean) : [];
  }

  move(deg) {
    const { generation, held } = this;
    if (!generation?.body.sound) return;
    this.deg = deg;
    const angle = deg * RADIANS;
    const { reference } = generation.body;
    set(this.world, { transform: `${this.origin} rotate(${(held === "gear" ? deg : 0).toFixed(4)})` });
    set(this.turning, { transform: `rotate(${(-deg).toFixed(4)})` });
    set(this.rack, { transform: `translate(${round(-this.view.scale * reference * angle)} 0)` });
    this.#placed(this.present, angle);
    for (const { angle: cut, part, line } of this.cuts) {
      part.toggleAttribute("hidden", cut > angle);
      line?.toggleAttribute("hidden", cut > angle);
    }
    generation.contacts(angle).forEach((p, i) => {
      this.dots[i].toggleAttribute("hidden", !p);
      if (!p) return;
      const [cx, cy] = this.local(p).map(round);
      set(this.dots[i], { cx, cy });
    });
  }
}

// How a rack cuts a gear that turns counter-clockwise below it: angles of the gear.
export class Generation {
  constructor(drawn) {
    this.body = new GearBody(drawn);
    this.rack = drawn.rack.x.map((x, i) => [x, drawn.rack.y[i]]);
    this.pressure = drawn.pressure_angle;
    const { body } = this;
    const pitchLength = body.reference * body.pitch;
    // A tooth of the rack leaves the blank where its tip line leaves the tip circle.
    const travel = pitchLength / 2 + pitchLength / 4 + Math.sqrt(Math.max(0, body.tip ** 2 - body.root ** 2));
    this.range = { pitchLength, travel, deg: Math.min(180, travel / body.reference / RADIANS) };
    this.cuts = Array.from({ length: CUTS + 1 }, (_, i) => RADIANS * this.range.deg * ((2 * i) / CUTS - 1));
  }

  // How far the string of the left flank is unwound where the rack's straight flank touches it.
  unwound(angle) { return this.body.base * (angle + this.body.half_angle + this.pressure); }

  isOnFlank(way) { return way >= Math.sqrt(Math.max(0, this.body.form ** 2 - this.body.base ** 2)) - 1e-9 * this.body.base && Math.hypot(way, this.body.base) <= this.body.tip_end * (1 + 1e-9); }

  // Where the rack's flanks touch the upright tooth's left and right flank; null where they do not.
  contacts(angle) {
    return [1, -1].map((side) => {
      const way = this.unwound(side * angle);
      if (!this.isOnFlank(way)) return null;
      const [x, y] = polar(this.body.base, UPRIGHT - this.pressure);
      return [side * (x - way * Math.cos(this.pressure)), y + way * Math.sin(this.pressure)];
    });
  }

  // The radius at which the left flank is cut now; null where it is not.
  radius(angle) {
    const way = this.unwound(angle);
    return this.isOnFlank(way) ? Math.hypot(way, this.body.base) : null;
  }

  angleAt(radius) { return Math.sqrt(Math.max(0, radius ** 2 - this.body.base ** 2)) / this.body.base - this.body.half_angle - this.pressure; }
}
