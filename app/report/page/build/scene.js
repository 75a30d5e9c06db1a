// The picture of a mechanism that is built: everything where it is drawn, and moved from there.

import { set, svg } from "../dom.js";
import { number } from "../format.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { arcPath, arrowPath, distanceToArc, groundSign, guideSign, pathWithGaps, round } from "../shapes.js";
import { boxOf, diagonal, View } from "../view.js";
import { say } from "../words.js";
import { spreadOf } from "./chain.js";
import { drawingOfState } from "./drawing.js";
import { FORCE_SCALE } from "./hits.js";
import { linkShape, RIDER } from "./link_shapes.js";
import { directionOf, driverOf, FRAME, isBlock, isFixed, jointsOn, loadNames, pinOf } from "./model.js";
import { after, before } from "./motion.js";
import { BUILD_SHEET } from "./sheet.js";

const GRID_PIXELS = 16;   // between lines at least
const TINTS = ["--coupler", "--rocker", "--link-b", "--link-c", "--link-d"];
const STILL_MOVE = [0, 0, 1, 0];
const FAR_AWAY = 3;   // sizes of the mechanism
const RAIL_MOST = 2;  // widths of the picture
const SMALL = 0.3, LARGE = 1.2;   // of the width of the sheet
const BESIDE_ARC = [0, -34];   // pixels
const NAME_AWAY = 18, BESIDE_GROUND = [22, 7], BEYOND_TIP = [30, 14];   // pixels

export class BuildScene extends Picture {
  constructor(frame, label) {
    super(frame, label);
    this.state = null;
    this.motion = null;
  }

  // A state, with its motion where there is one; `chosen`: {joint}, {link} or {load}, or null.
  take(state, motion, chosen) { Object.assign(this, { state, motion, chosen }); }

  tintOf(link) {
    const driver = driverOf(this.state);
    if (link === driver) return "--crank";
    const others = this.state.links.filter(({ name }) => name !== driver);
    return TINTS[Math.max(0, others.findIndex(({ name }) => name === link)) % TINTS.length];
  }

  // All where it is drawn.
  build() {
    this.clear(BUILD_SHEET);
    const names = ["grid", "ground", "paths", "links", "riders", "pins", "loads", "names"];
    this.layers = Object.fromEntries(names.map((name) => [name, svg("g", { class: `build-${name}` })]));
    this.root.append(...Object.values(this.layers), this.scaleBar());
    this.#grid();
    this.#ground();
    this.paths = new Map(this.state.joints.map((joint) => [joint.name, this.#pathOf(joint)]));
    this.#drawPaths();
    this.bodies = this.state.links.map((link) => this.#body(link));
    this.layers.links.append(...this.bodies.filter(({ isRider }) => !isRider).map(({ part }) => part));
    this.layers.riders.append(...this.bodies.filter(({ isRider }) => isRider).map(({ part }) => part));
    this.#pins();
    this.#loads();
    this.move(null);
  }

  #grid() {
    const { view } = this, [left, top] = view.plane([0, 0]), [right, bottom] = view.plane([view.width, view.height]);
    const step = 10 ** Math.ceil(Math.log10(GRID_PIXELS / view.scale));
    const lines = (from, to) => Array.from({ length: Math.floor(to / step) - Math.ceil(from / step) + 1 }, (_, i) => (Math.ceil(from / step) + i) * step);
    const across = lines(left, right).map((x) => `M${round(view.screen([x, 0])[0])} 0V${view.height}`);
    const down = lines(bottom, top).map((y) => `M0 ${round(view.screen([0, y])[1])}H${view.width}`);
    this.layers.grid.append(svg("path", { class: "grid-line", d: [...across, ...down].join("") }));
  }

  #ground() {
    const { ground } = this.layers;
    for (const slider of this.state.sliders.filter(({ on }) => on === FRAME)) {
      const [from, to] = this.#rail(slider);
      ground.append(svg("g", { "data-slider": slider.name }, guideSign(this.view.screen(from), this.view.screen(to), RIDER.height / 2 + 2, RIDER.length / 2 + 8)));
    }
    for (const { at } of this.state.joints.filter(isFixed)) {
      const [x, y] = this.view.screen(at);
      ground.append(svg("g", { transform: `translate(${round(x)} ${round(y)})` }, svg("rect", { class: "ground-back", x: -17, y: 0, width: 34, height: 25 }), groundSign([0, 0])));
    }
  }

  // The ends of the way of a slider's pin along its line, in the position drawn of what it slides on.
  #rail(slider) {
    const pin = pinOf(this.state, slider), angle = directionOf(this.state, slider) * RADIANS, way = [Math.cos(angle), Math.sin(angle)];
    const least = 4 / this.view.scale, most = RAIL_MOST * (this.view.width / this.view.scale), along = [-least, least];
    for (const moves of this.#sampled()) {
      const [block, on] = [slider.block, slider.on].map((name) => moves.get(name));
      if (!block || !on) continue;
      const p = before(on, after(block, pin.at));
      const t = (p[0] - pin.at[0]) * way[0] + (p[1] - pin.at[1]) * way[1];
      along[0] = Math.max(-most, Math.min(along[0], t));
      along[1] = Math.min(most, Math.max(along[1], t));
    }
    return along.map((t) => pin.at.map((x, k) => x + t * way[k]));
  }

  // Looks at a mechanism from near or far, where it is small on the sheet or goes beyond it.
  look() {
    const box = boxOf(this.reached), size = Math.max(box.x1 - box.x0, box.y1 - box.y0), { view } = this;
    if (!(size > 0) || (size > SMALL * (BUILD_SHEET.x1 - BUILD_SHEET.x0) && size < LARGE * (BUILD_SHEET.x1 - BUILD_SHEET.x0) && Math.abs(box.x0 + box.x1) < size && Math.abs(box.y0 + box.y1) < size)) return;
    const fitting = new View(box, view.width, view.height, view.margin);
    Object.assign(this.camera, { factor: fitting.scale / view.whole.scale, shift: fitting.centre.map((x, k) => x - view.whole.centre[k]), widened: true });
    this.build();
  }

  // What the mechanism reaches: its joints, and their paths but for what is far away, where a way has no end.
  get reached() {
    const joints = this.state.joints.map(({ at }) => at), box = boxOf(joints), far = FAR_AWAY * diagonal(box);
    const isNear = (p) => p && Math.hypot(p[0] - (box.x0 + box.x1) / 2, p[1] - (box.y0 + box.y1) / 2) <= far;
    return [...joints, ...[...this.paths.values()].flat().filter(isNear)];
  }

  // The moves of all bodies at every sample of the motion.
  #sampled() {
    if (!this.motion) return [];
    if (this.samplesOf !== this.motion) Object.assign(this, { samplesOf: this.motion, samples: this.motion.mechanism.samples.map((drive) => this.motion.moves(drive)) });
    return this.samples;
  }

  #pathOf({ at, of }) {
    if (isFixed({ of })) return [];
    return this.#sampled().map((moves) => { const move = moves.get(of[0]); return move ? after(move, at) : null; });
  }

  // Curves of points, thin ones of pins.
  #drawPaths() {
    for (const { name, of } of this.state.joints) {
      const path = this.paths.get(name);
      if (path.length) this.layers.paths.append(svg("path", { class: of.length > 1 ? "circle-path" : "path", "data-path": name, d: pathWithGaps(path.map((p) => p && this.view.screen(p))) }));
    }
  }

  #body({ name }) {
    const { state, view } = this, classes = `build-link${this.chosen?.link === name ? " chosen" : ""}`;
    const { origin, parts, isRider } = linkShape(state, name, view.scale, (slider) => this.#rail(slider));
    const part = svg("g", { class: classes, "data-link": name, style: `--tint:var(${this.tintOf(name)})` }, svg("title", {}, name), ...parts);
    return { name, origin, part, isRider };
  }

  #pins() {
    this.pins = this.state.joints.map((joint) => {
      const isPoint = joint.of.length === 1 && !isFixed(joint), isChosen = this.chosen?.joint === joint.name;
      const part = svg("circle", { class: `${isPoint ? "coupler-point" : "pin"}${isChosen ? " chosen" : ""}`, r: isPoint ? 5 : 4.5, "data-pin": joint.name });
      const name = svg("text", { class: "joint-name" }, joint.name);
      this.layers.pins.append(part);
      this.layers.names.append(name);
      return { joint, part, name, away: this.#nameWay(joint) };
    });
  }

  // Whereto a name stands beside its joint, in pixels: away from what starts there.
  #nameWay(joint) {
    const fixed = isFixed(joint), others = joint.of.filter((link) => link !== FRAME && !isBlock(this.state, link)).flatMap((link) => jointsOn(this.state, link)).filter(({ name }) => name !== joint.name);
    const sum = others.reduce(([x, y], { at }) => {
      const [u, v] = [at[0] - joint.at[0], at[1] - joint.at[1]], size = Math.hypot(u, v) || 1;
      return [x + u / size, y + v / size];
    }, [0, 0]);
    // The sign of a fixed pivot takes the room below it.
    if (fixed) return [sum[0] > 0.01 ? -BESIDE_GROUND[0] : BESIDE_GROUND[0], BESIDE_GROUND[1]];
    const size = Math.hypot(...sum);
    return size < 0.2 ? [-0.6 * NAME_AWAY, -0.8 * NAME_AWAY] : [(-NAME_AWAY * sum[0]) / size, (NAME_AWAY * sum[1]) / size];
  }

  #loads() {
    const names = loadNames(this.state);
    this.loads = this.state.loads.map(({ on, force, torque }, i) => {
      const lines = [svg("path", { class: "halo" }), svg("path", {})];
      const text = svg("text", { class: "joint-name" }, force ? say("build.newtons", { value: number(Math.hypot(...force), 4) }) : say("build.newton_metres", { value: number(torque, 4) }));
      this.layers.loads.append(svg("g", { class: `arrow load${this.chosen?.load === names[i] ? " chosen" : ""}`, "data-load": names[i] }, ...lines), text);
      const middle = force ? null : spreadOf(this.state, on)?.centre ?? null;
      return { name: names[i], on, force, torque, middle, way: force && [force[0], -force[1]].map((x) => (x / FORCE_SCALE) * this.view.scale), lines, text };
    });
  }

  // Where all is at a drive coordinate; null: where it is drawn.
  move(drive) {
    this.drive = drive;
    this.moves = drive === null || !this.motion ? null : this.motion.moves(drive);
    const moveOf = (link) => this.#moveOf(link);
    for (const { name, origin, part } of this.bodies) {
      const move = moveOf(name);
      part.toggleAttribute("hidden", !move);
      if (!move) continue;
      const [x, y] = this.view.screen(after(move, origin)), [, , c, s] = move;
      set(part, { transform: `matrix(${c.toFixed(6)} ${(-s).toFixed(6)} ${s.toFixed(6)} ${c.toFixed(6)} ${x.toFixed(2)} ${y.toFixed(2)})` });
    }
    this.at = new Map(this.state.joints.map((joint) => [joint.name, this.#placeOf(joint, moveOf)]));
    for (const pin of this.pins) this.#movePin(pin);
    for (const load of this.loads) if (load.way) this.#moveLoad(load); else this.#moveTorque(load, moveOf(load.on));
  }

  #moveOf(link) { return this.moves ? this.moves.get(link) ?? null : STILL_MOVE; }

  // All where it is now, for CAD.
  get drawing() { return drawingOfState(this.state, { moveOf: (link) => this.#moveOf(link), at: this.at, paths: this.paths, railOf: (slider) => this.#rail(slider) }); }

  #placeOf(joint, moveOf) {
    if (isFixed(joint)) return joint.at;
    const move = moveOf(joint.of[0]);
    return move && after(move, joint.at);
  }

  #movePin({ joint, part, name, away }) {
    const place = this.at.get(joint.name);
    for (const one of [part, name]) one.toggleAttribute("hidden", !place);
    if (!place) return;
    const [x, y] = this.view.screen(place);
    set(part, { cx: round(x), cy: round(y) });
    set(name, { x: round(x + away[0]), y: round(y + away[1]) });
  }

  // Each load where it is taken hold of: a force at its tip, a torque in the middle of its arc; those that are seen.
  get grips() { return this.loads.filter(({ grip }) => grip); }

  // The torque whose arc is within so many pixels of a place, as a spot on its link.
  torqueAt(place, pixels) {
    const at = this.view.screen(place), own = this.grips.find(({ force, grip }) => !force && distanceToArc(this.view.screen(grip), at) <= pixels);
    return own && { load: own.name, link: own.on, at: place };
  }

  #moveTorque(load, move) {
    const { torque, middle, lines, text } = load;
    load.grip = move && middle && after(move, middle);
    const p = load.grip && this.view.screen(load.grip);
    for (const line of lines) set(line, { d: p ? arcPath(p, torque) : "" });
    text.toggleAttribute("hidden", !p);
    if (p) set(text, { x: round(p[0] + BESIDE_ARC[0]), y: round(p[1] + BESIDE_ARC[1]) });
  }

  #moveLoad(load) {
    const { on, force, way, lines, text } = load, place = this.at.get(on);
    load.grip = place && place.map((x, k) => x + force[k] / FORCE_SCALE);
    const p = place && this.view.screen(place), long = Math.hypot(...way) || 1;
    for (const line of lines) set(line, { d: p ? arrowPath(p, way) : "" });
    text.toggleAttribute("hidden", !p);
    if (p) set(text, { x: round(p[0] + way[0] + (BEYOND_TIP[0] * way[0]) / long), y: round(p[1] + way[1] + (BEYOND_TIP[1] * way[1]) / long) });
  }
}
