// The picture of a row's four-bar.

import { set, svg } from "../dom.js";
import { Picture } from "../picture.js";
import { barPath, groundSign, pathThrough, round } from "../shapes.js";
import { fourBarRates } from "../vectors.js";
import { boxOf } from "../view.js";
import { say } from "../words.js";
import { TURN } from "./linkage.js";

export class LinkageScene extends Picture {
  // `onDrag(phase)`
  constructor(frame, onDrag) { super(frame, say("picture.row_linkage"), onDrag); }

  // `linkage`: a RowLinkage, or null.
  build(linkage) {
    this.linkage = linkage;
    this.samples = linkage?.poses(240) ?? [];
    const box = this.samples.length ? boxOf([...this.samples.flatMap(({ b, c, p }) => [b, c, p]), linkage.closure.a, linkage.closure.d]) : null;
    this.clear(box, say("picture.row_not_assembled"));
    if (!box) return;
    const { view } = this;
    const [a, d] = [linkage.closure.a, linkage.closure.d].map((p) => view.screen(p));
    const line = (name, key) => svg("path", { class: name, d: pathThrough(this.samples.map((pose) => view.screen(pose[key]))) });
    this.bars = Math.min(6, 0.02 * Math.min(view.width, view.height));
    this.links = ["rocker", "coupler", "crank"].map((name) => svg("path", { class: `link-body ${name}`, fill: "var(--tint)" }));
    this.plate = svg("path", { class: "coupler-plate" });
    this.pins = [0, 1].map(() => svg("circle", { class: "pin", r: 3.6 }));
    this.point = svg("circle", { class: "coupler-point", r: 5 });
    this.handle = svg("circle", { class: "handle", r: 22 });
    this.point.toggleAttribute("hidden", !this.samples[0].p);
    this.root.append(svg("path", { class: "frame-line", d: pathThrough([a, d]) }), groundSign(a), groundSign(d),
      line("circle-path", "b"), line("circle-path", "c"), ...(this.samples[0].p ? [line("path", "p")] : []),
      this.plate, ...this.links, svg("circle", { class: "pin", cx: a[0], cy: a[1], r: 3.6 }), svg("circle", { class: "pin", cx: d[0], cy: d[1], r: 3.6 }),
      ...this.pins, this.point, this.scaleBar(), this.handle);
    this.listen(this.handle, (q) => this.#phaseAt(q));
  }

  // The drive of this picture is the phase of the motion.
  get drives() { return Array.from({ length: 181 }, (_, i) => (TURN * i) / 180); }

  marksAt(phase) {
    const pose = this.linkage?.pose(phase);
    return pose ? (pose.p ? [pose.p] : [pose.b, pose.c]) : [];
  }

  jointsAt(phase) {
    const pose = this.linkage?.pose(phase);
    return pose ? { a: this.linkage.closure.a, d: this.linkage.closure.d, ...pose } : null;
  }

  ratesAt(phase) { return this.linkage?.closes ? fourBarRates(this.jointsAt(phase)) : []; }

  // The phase at which the point that is held is nearest to q.
  #phaseAt(q) {
    const key = this.samples[0].p ? "p" : "b";
    let [best, least] = [null, Infinity];
    for (let i = 0; i < 720; ++i) {
      const pose = this.linkage.pose((TURN * i) / 720);
      const away = pose ? Math.hypot(pose[key][0] - q[0], pose[key][1] - q[1]) : Infinity;
      if (away < least) [best, least] = [(TURN * i) / 720, away];
    }
    return best;
  }

  move(phase) {
    const pose = this.view && this.linkage.pose(phase);
    if (!pose) return;
    const { view, linkage } = this;
    const [a, b, c, d] = [linkage.closure.a, pose.b, pose.c, linkage.closure.d].map((p) => view.screen(p));
    [[d, c], [b, c], [a, b]].forEach((ends, i) => set(this.links[i], { d: barPath(...ends, this.bars) }));
    [b, c].forEach((p, i) => set(this.pins[i], { cx: round(p[0]), cy: round(p[1]) }));
    const held = pose.p ? view.screen(pose.p) : b;
    if (pose.p) {
      set(this.plate, { d: `${pathThrough([b, c, held])}Z`, style: `stroke-width:${2 * this.bars}` });
      set(this.point, { cx: round(held[0]), cy: round(held[1]) });
    }
    set(this.handle, { cx: round(held[0]), cy: round(held[1]) });
  }
}
