// The picture of a gear train: pitch circles that roll, planets on the arms of their carriers.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { RADIANS } from "../sampling.js";
import { round } from "../shapes.js";
import { say, term } from "../words.js";

// Teeth are marked while they are at least so many pixels apart.
const LEAST_PITCH = 4;

export class TrainScene extends Picture {
  constructor(frame, onDrag) { super(frame, say("picture.gear_train"), onDrag); }

  #box() {
    const { circles } = this.design;
    const reach = ({ orbit, radius }) => orbit + radius;
    const high = Math.max(...circles.map(reach));
    return { x0: Math.min(...circles.map((c) => c.x - reach(c))), x1: Math.max(...circles.map((c) => c.x + reach(c))), y0: -high, y1: high };
  }

  build(design) {
    this.design = design;
    this.clear(design.circles.length ? this.#box() : null, say("train.no_picture"));
    if (!design.circles.length) return;
    this.world = svg("g", { class: "world" });
    const bySize = [...design.circles].sort((a, b) => b.radius - a.radius);
    this.arms = design.circles.filter(({ orbit }) => orbit > 0).flatMap((circle) => this.#copies(circle, () => this.#arm(circle)));
    this.gears = bySize.flatMap((circle) => this.#copies(circle, () => this.#gear(circle)));
    this.world.append(...this.gears.map(({ root }) => root), ...this.arms.map(({ root }) => root), this.#names(bySize));
    this.root.append(this.world, this.scaleBar());
    const [x, y] = this.view.screen([0, 0]).map(round);
    set(this.world, { transform: `translate(${x} ${y})` });
  }

  #copies(circle, make) { return Array.from({ length: circle.copies }, (_, k) => ({ circle, k, root: make() })); }

  #gear({ radius, teeth, orbit, internal }) {
    const r = this.view.scale * radius, pitch = (2 * Math.PI * r) / teeth;
    const body = svg("circle", { class: `pitch-circle${internal ? " internal" : ""}`, r: round(r) });
    const marks = pitch < LEAST_PITCH ? [] : [svg("circle", { class: "teeth-marks", r: round(r), "stroke-dasharray": `${(pitch / 2).toFixed(3)} ${(pitch / 2).toFixed(3)}` })];
    const spoke = svg("line", { class: "gear-spoke", x1: round(internal ? r : 0.12 * r), x2: round(internal ? 1.06 * r : 0.9 * r) });
    const hub = internal ? [] : [svg("circle", { class: "gear-hub", r: round(Math.min(0.12 * r, 7)) })];
    return svg("g", { class: orbit > 0 ? "planet-gear" : "shaft-gear" }, body, ...marks, spoke, ...hub);
  }

  #arm({ orbit }) { return svg("g", { class: "carrier-arm" }, svg("line", { x2: round(this.view.scale * orbit) })); }

  // Names stand at the top of the largest circle of each member on a fixed axis.
  #names(circles) {
    const { scale } = this.view;
    const isFirst = (circle, i) => circles.findIndex(({ member, x }) => member === circle.member && x === circle.x) === i;
    return svg("g", {}, ...circles.filter((circle, i) => circle.orbit === 0 && isFirst(circle, i)).map(({ member, radius, x, internal }) =>
      svg("text", { class: "gear-name", x: round(scale * x), y: round(-scale * radius + (internal ? -6 : 16)) }, term(this.design.members[member].name))));
  }

  // By how much a member has turned for each turn of the input, as far as floating point goes.
  rate(member) {
    const { members, input } = this.design;
    const own = members[input].speed || 1;
    return member < 0 ? 0 : members[member].speed / own;
  }

  move(deg) {
    if (!this.design?.circles.length) return;
    const { scale } = this.view;
    for (const { circle, k, root } of [...this.gears, ...this.arms]) {
      const around = deg * this.rate(circle.carrier) + (360 * k) / circle.copies;
      const isArm = root.classList.contains("carrier-arm");
      const out = isArm ? 0 : circle.orbit;
      const [x, y] = [circle.x + out * Math.cos(around * RADIANS), out * Math.sin(around * RADIANS)];
      const turn = isArm ? around : deg * this.rate(circle.member) + (360 * k) / circle.copies;
      set(root, { transform: `translate(${round(scale * x)} ${round(-scale * y)}) rotate(${(-turn % 360).toFixed(3)})` });
    }
  }
}
