// The picture of a sketch: its points or poses, the design chosen in motion, the others as ghosts.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { barPath, blockPath, groundSign, guideSign, pathThrough, round, sectorPath } from "../shapes.js";
import { diagramAxes, DIAGRAM_MARGIN, errorStrip } from "./diagram.js";
import { layout } from "./layout.js";
import { modeOf } from "./modes.js";
import { along, axesPath } from "./posed.js";

// The part of the plane to draw in, in its units.
export const SHEET = { x0: -60, y0: -42, x1: 60, y1: 42 };

const PLATE = 5;
const BLOCK = { length: 26, height: 15 };
const BEHIND = 225;   // degrees from the first axis of a pose, opposite to both: there its number stands

export class SketchScene extends Picture {
  constructor(frame, label) {
    super(frame, label);
    Object.assign(this, { candidates: [], chosen: 0, looked: null, picture: null, targets: { points: [], angles: null, ranges: null, closed: false, region: null, obstacle: null }, phase: 0 });
  }

  build() {
    const { candidates, chosen, looked, targets: { ranges } } = this;
    this.clear(ranges ? layout().sheet : SHEET, "", ranges ? DIAGRAM_MARGIN : undefined);
    const { view } = this;
    this.ranges = ranges;
    const line = (points) => pathThrough(points.map((p) => view.screen(p)));
    this.boxes = { region: svg("rect", { class: "sketch-region", id: "pivot-region" }), obstacle: svg("rect", { class: "sketch-obstacle", id: "kept-clear" }) };
    this.drawn = svg("path", { class: "sketch-line" });
    this.spots = svg("g");
    this.ghosts = candidates.map((one, i) => (i === chosen ? null : this.#ghost(one, `sketch-${i}`, line)));
    this.lookedAt = looked && this.#ghost(looked, "looked-at", line);
    this.root.append(...(this.picture ? [this.#underneath(this.picture)] : []), ...Object.values(this.boxes), ...this.#scales(ranges), this.drawn, ...this.ghosts.filter(Boolean).map(({ root }) => root));
    this.parts = candidates[chosen] ? this.#linkage(candidates[chosen], line) : null;
    if (this.parts) this.root.append(this.parts.root);
    this.root.append(...(looked ? [this.lookedAt.root] : []), this.spots);
    this.target(this.targets);
    this.move(this.phase);
  }

  // The scale of the sheet; of a function its diagram, with the errors of the generators.
  #scales(ranges) {
    if (!ranges) return [this.scaleBar()];
    const { candidates, chosen, looked } = this, shown = [...candidates.filter((_, i) => i !== chosen), ...candidates.slice(chosen, chosen + 1), ...(looked ? [looked] : [])];
    const names = shown.map((one) => (one === looked ? "looked-at" : `sketch-${candidates.indexOf(one)}`));
    return [diagramAxes(this.view, ranges), ...(shown.length ? [errorStrip(this.view, ranges, shown.map(({ errors }) => errors), names)] : [])];
  }

  // A picture {address, width, share} that is drawn over, about the middle of the sheet.
  #underneath({ address, width, share }) {
    const [x, y] = this.view.screen([-width / 2, (width * share) / 2]);
    return svg("image", { href: address, class: "underneath", x: round(x), y: round(y), width: round(width * this.view.scale), height: round(width * share * this.view.scale), preserveAspectRatio: "none" });
  }

  #ghost({ curve }, name, line) {
    const links = svg("path", { class: "ghost-links" });
    const root = svg("g", { class: `ghost-linkage ${name}` }, svg("path", { class: "ghost-path", d: line(curve) }), links);
    return { root, links };
  }

  // What a slider runs on; nothing of a four-bar.
  #guides({ guide = [] }) {
    return guide.length ? [guideSign(...guide.map((place) => this.view.screen(place)), BLOCK.height / 2, BLOCK.length / 2 + 4)] : [];
  }

  #linkage({ curve, linkage, sectors = [] }, line) {
    const { closure } = linkage, grounds = [closure.a, closure.d].filter(Boolean);
    const bars = ["crank", "coupler", "rocker"].map((name) => svg("path", { class: `link-body ${name}`, style: "fill: var(--tint)" }));
    const pins = ["A", "B", "C", ...(closure.d ? ["D"] : [])].map((name) => svg("circle", { class: "pin", r: 4, "data-pin": name }));
    const point = svg("circle", { class: "coupler-point", r: 5, id: "tracing" });
    const body = svg("path", { class: "sketch-axes reached", id: "body" });
    const turned = sectors.map(({ at, radius, from, to }) => svg("path", { class: "diagram-sector", d: sectorPath(this.view.screen(at), radius * this.view.scale, from, to) }));
    const root = svg("g", { id: "linkage" }, ...turned, svg("path", { class: "path", id: "curve", d: line(curve) }), ...grounds.map((p) => groundSign(this.view.screen(p))), ...this.#guides(linkage), ...bars, ...pins, body, point);
    return { root, bars, pins, point, body };
  }

  #bound(part, box) {
    part.toggleAttribute("hidden", !box);
    if (!box) return;
    const [[x0, y1], [x1, y0]] = box.map((corner) => this.view.screen(corner));
    set(part, { x: round(x0), y: round(y0), width: round(x1 - x0), height: round(y1 - y0) });
  }

  #number(value, [x, y]) { return svg("text", { class: "sketch-number", x: round(x), y: round(y + 4) }, String(value)); }

  // The points drawn, poses, or pairs of a function, where pivots may stand, and where no joint comes: a state.
  target(targets) {
    this.targets = targets;
    const { angles, closed, ranges } = targets;
    if (ranges?.join() !== this.ranges?.join()) { this.build(); return; }
    for (const [name, part] of Object.entries(this.boxes)) this.#bound(part, targets[name]);
    const at = modeOf(targets).places(targets).map((p) => this.view.screen(p));
    set(this.drawn, { d: at.length && !angles ? pathThrough(at) + (closed ? "Z" : "") : "" });
    const axes = (angles ?? []).map((degrees, i) => svg("path", { class: "sketch-axes", d: axesPath(at[i], degrees) }));
    const numbers = (angles ?? []).map((degrees, i) => this.#number(i + 1, along(at[i], degrees + BEHIND, 16)));
    this.spots.replaceChildren(...axes, ...numbers, ...at.map(([x, y]) => svg("circle", { class: "sketch-spot", cx: round(x), cy: round(y), r: 3.5 })));
  }

  // Every linkage at `phase` of its motion.
  move(phase) {
    this.phase = phase;
    this.candidates.forEach((one, i) => { if (i !== this.chosen) this.#moveGhost(this.ghosts[i], one); });
    if (this.lookedAt) this.#moveGhost(this.lookedAt, this.looked);
    if (this.parts) this.#moveLinkage(this.candidates[this.chosen]);
  }

  // Its joints and its point on the screen; none where it does not close.
  #joints({ linkage: { closure } }, pose) { return pose ? [closure.a, pose.b, pose.c, closure.d, pose.p].map((place) => place && this.view.screen(place)) : null; }

  #moveGhost({ links }, one) {
    const [a, b, c, d, p] = this.#joints(one, one.pose(this.phase)) ?? [];
    set(links, { d: a ? `${pathThrough([a, b, c, d].filter(Boolean))}${one.tracesFunction ? "" : pathThrough([b, p, c])}` : "" });
  }

  #moveLinkage(one) {
    const pose = one.pose(this.phase);
    this.parts.root.toggleAttribute("hidden", !pose);
    if (pose) this.#place(one, ...this.#joints(one, pose), one.bodyAngle(pose));
  }

  // The link that turns about D, or the slider.
  #lastLink({ linkage: { along } }, c, d) {
    return d ? { d: barPath(d, c, PLATE) } : { d: blockPath(BLOCK.length, BLOCK.height), transform: `translate(${c.map(round).join(" ")}) rotate(${round(-Math.atan2(along[1], along[0]) / RADIANS)})` };
  }

  #place(one, a, b, c, d, p, turned) {
    const { tracesFunction } = one;
    const { bars: [crank, coupler, rocker], pins, point, body } = this.parts;
    set(crank, { d: barPath(a, b, PLATE) });
    set(coupler, { d: `${barPath(b, c, PLATE)}${tracesFunction ? "" : barPath(b, p, PLATE - 1) + barPath(c, p, PLATE - 1)}` });
    set(rocker, this.#lastLink(one, c, d));
    [a, b, c, d].filter(Boolean).forEach(([x, y], i) => set(pins[i], { cx: round(x), cy: round(y) }));
    set(point, { cx: round(p[0]), cy: round(p[1]) });
    set(body, { d: turned === null ? "" : axesPath(p, turned) });
  }
}
