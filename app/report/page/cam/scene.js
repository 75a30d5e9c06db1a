// The picture of a cam and its follower. All that turns together is in one group; the world's group
// stands still, or turns back about the cam where that is held.

import { set, svg } from "../dom.js";
import { degrees } from "../format.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { pathThrough, round } from "../shapes.js";
import { boxOf } from "../view.js";
import { say } from "../words.js";
import { Follower } from "./follower.js";
import { combPath, envelopePath, PressureLayer, VelocityLayer } from "./layers.js";
import { rotated } from "./model.js";

export class CamScene extends Picture {
  constructor(frame, onDrag) {
    super(frame, say("picture.cam"), onDrag);
    this.shown = { pressure: true, pitch: true, base: true };
    this.held = "frame";
    this.original = null;  // the cam before it was edited
  }

  // What is in the picture at any cam angle.
  #box() {
    const { design } = this;
    const { first, radius, part, kind, mirror } = design;
    const points = [];
    const room = (p, r) => points.push([p[0] - r, p[1] - r], [p[0] + r, p[1] + r]);
    for (let deg = 0; deg < 360; deg += 5) {
      for (const body of design.contacts) {
        if (kind.flat) for (const p of body.face(deg)) room(p, 0.5 * part);
        else room(body.centre(deg), body.roller_radius || 0.4 * part);
      }
    }
    if (kind.oscillating) room(first.pivot, 0.8 * part);
    else points.push([first.offset, Follower.heights(design).top + first.highest]);
    if (design.breadth !== null) {
      const foot = first.start + first.lowest - design.breadth - part;
      points.push([-radius - part, foot], [radius + part, foot]);
    }
    const reach = this.held === "cam" ? Math.max(radius, ...points.map((p) => Math.hypot(...p))) : radius;
    return boxOf([...(this.held === "cam" ? [] : points.map(([x, y]) => [mirror * x, y])), [-reach, -reach], [reach, reach]]);
  }

  build(design) {
    this.design = design;
    this.clear(design.sound ? this.#box() : null, say("picture.cam_impossible"));
    if (!design.sound) return;
    const { view: { scale } } = this;
    this.world = svg("g", { class: "world" });
    this.camGroup = svg("g", { class: "cam-body" });
    this.follower = new Follower(design, scale);
    this.pressures = design.contacts.map((body) => new PressureLayer(body, scale, 4.2 * design.part));
    this.velocities = design.contacts.map((body) => new VelocityLayer(body, scale, 0.55 * scale));
    const overlay = (layers) => svg("g", {}, ...layers.map((layer) => layer.root));
    this.#drawCam();
    this.parts = { ...this.camParts, pressure: overlay(this.pressures), velocity: overlay(this.velocities) };
    this.sense = svg("path", { class: "sense", d: this.#senseArrow() });
    this.handle = svg("circle", { class: "handle", r: round(scale * design.radius) });
    this.world.append(this.follower.frame, this.follower.back, this.camGroup, this.sense, this.follower.front, this.parts.pressure, this.parts.velocity, this.handle);
    this.angleName = svg("text", { class: "joint-name angle-name" });
    this.root.append(this.world, this.angleName, this.scaleBar());
    this.#takeHold();
    this.show(this.shown);
  }

  // The centre of the roller, or the contact of a face, as the picture holds it.
  marksAt(deg) {
    if (!this.design?.sound) return [];
    const p = this.design.first.centre(deg) ?? this.design.first.contact(deg);
    if (!p) return [];
    const [x, y] = this.held === "cam" ? rotated(p, -deg) : p;
    return [[this.design.mirror * x, y]];
  }

  local([x, y]) { return [this.view.scale * x, -this.view.scale * y]; }
  closed(points) { return `${pathThrough(points.map((p) => this.local(p)))}Z`; }

  // The cam in its own axes.
  #drawCam() {
    const { design } = this;
    const { first, second } = design;
    const { scale } = this.view;
    const solid = (body, name) => svg("path", { class: `cam ${name}`, d: this.closed(body.profile) });
    if (second) this.camGroup.append(svg("g", { transform: `rotate(${-second.turn})` }, solid(second, "other")));
    if (first.outer) this.camGroup.append(svg("circle", { class: "cam first", r: round(scale * (design.radius + 0.5 * design.part)) }),
      svg("path", { class: "slot", "fill-rule": "evenodd", d: this.closed(first.outer) + this.closed(first.profile) }));
    else this.camGroup.append(solid(first, "first"));
    const comb = combPath(first, scale, design.radius);
    this.camParts = {
      base: svg("circle", { class: "base-circle", r: round(scale * first.base_radius) }),
      pitch: svg("g", {}, ...design.bodies.filter((b) => b.pitch).map((b) => svg("path", { class: "pitch", d: this.closed(b.pitch), transform: `rotate(${-b.turn})` }))),
      comb: svg("g", {}, svg("path", { class: "comb-teeth", d: comb.teeth }), svg("path", { class: "comb-tips", d: comb.tips })),
      envelope: svg("path", { class: "envelope", d: envelopePath(first, scale) }),
    };
    const strokes = design.strokes().map(({ stroke, points }) => svg("path", { class: `stroke ${stroke}`, d: pathThrough(points.map((p) => this.local(p))) }));
    if (this.original) this.camGroup.append(svg("path", { class: "edit-ghost", d: this.closed(this.original.profile) }));
    this.camGroup.append(this.camParts.envelope, this.camParts.comb, this.camParts.base, this.camParts.pitch, ...strokes, this.#hub());
  }

  // The shaft with its key, which points where the follower was at cam angle 0.
  #hub() {
    const r = 0.85 * this.follower.u;
    const key = 0.3 * r;
    return svg("g", {}, svg("circle", { class: "hub", r: round(1.45 * r) }),
      svg("path", { class: "shaft", d: `M${round(-key)} ${round(-r)}V${round(-1.25 * r)}H${round(key)}V${round(-r)}A${round(r)} ${round(r)} 0 1 1 ${round(-key)} ${round(-r)}Z` }));
  }

  // An arrow about the shaft in the sense of rotation.
  #senseArrow() {
    const r = 1.95 * 0.85 * this.follower.u;
    const at = (deg, radius) => [radius * Math.cos(deg * RADIANS), -radius * Math.sin(deg * RADIANS)].map(round).join(" ");
    return `M${at(-150, r)}A${round(r)} ${round(r)} 0 0 0 ${at(-45, r)}M${at(-60, r - 5)}L${at(-45, r)}L${at(-62, r + 5)}`;
  }

  // The cam is turned by taking hold of it anywhere; where it is held, the frame is turned about it.
  #takeHold() {
    let grip = null;
    this.handle.addEventListener("pointerdown", () => { grip = null; });
    this.listen(this.handle, ([x, y]) => {
      const sense = this.held === "cam" ? -1 : 1;
      const angle = (sense * Math.atan2(y, this.design.mirror * x)) / RADIANS;
      const turned = grip === null ? 0 : angle - grip;
      grip = angle;
      return turned === 0 ? null : this.deg + turned - 360 * Math.round(turned / 360);
    });
  }

  show(shown) {
    this.shown = { ...this.shown, ...shown };
    for (const [layer, part] of Object.entries(this.parts ?? {})) part.toggleAttribute("hidden", !this.shown[layer]);
    this.angleName?.toggleAttribute("hidden", !this.shown.pressure);
  }

  // `deg` in [0, 360), after as many whole turns.
  move(deg, turns, missed) {
    if (!this.design?.sound) return;
    this.deg = deg;
    const { mirror, first } = this.design;
    const [x, y] = this.view.screen([0, 0]).map(round);
    const back = this.held === "cam" ? deg : 0;
    set(this.world, { transform: `translate(${x} ${y}) scale(${mirror} 1) rotate(${round(back)})` });
    set(this.camGroup, { transform: `rotate(${-round(deg)})` });
    this.sense.toggleAttribute("hidden", this.held === "cam");
    this.follower.move(deg, turns);
    const places = this.pressures.map((layer) => layer.move(deg, missed));
    for (const layer of this.velocities) layer.move(deg);
    this.#name(places[0], first.at("pressure_deg", deg), back);
  }

  #name(place, angle, back) {
    this.angleName.textContent = place && angle !== null ? degrees(angle, 1) : "";
    if (!place) return;
    const [x, y] = rotated(place, -back);
    const at = this.view.screen([this.design.mirror * x, y]);
    set(this.angleName, { x: round(at[0]), y: round(at[1]) });
  }
}
