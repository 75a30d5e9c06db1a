// Two columns against each other. The best rows are ringed, and joined where the axes are the two
// objectives.

import { byId, colour, svg } from "../dom.js";
import { round } from "../shapes.js";
import { say } from "../words.js";
import { Plane, tipLines } from "./axes.js";

const NEAR = 14;  // pixels

export class Scatter extends Plane {
  // `actions.select(row)`
  constructor(holder, study, actions) {
    super(holder, say("scatter.label"));
    Object.assign(this, { study, actions, transform: d3.zoomIdentity });
    this.zoom = d3.zoom().scaleExtent([1, 400]).on("zoom", (event) => { this.transform = event.transform; this.later(); })
      .filter((event) => !event.button && (event.type !== "wheel" || event.ctrlKey || document.activeElement === this.root) && (!event.touches || event.touches.length > 1));
    d3.select(this.root).call(this.zoom);
    this.root.addEventListener("click", (event) => { const row = this.#near(this.pointer(event)); if (row !== null) actions.select(row); });
    this.root.addEventListener("pointermove", (event) => this.#hover(this.pointer(event)));
    this.root.addEventListener("pointerleave", () => this.showTip([0, 0], null));
    this.root.addEventListener("keydown", (event) => this.#step(event));
    const by = (factor) => () => d3.select(this.root).call(this.zoom.scaleBy, factor);
    byId("zoom-in").addEventListener("click", by(1.6));
    byId("zoom-out").addEventListener("click", by(1 / 1.6));
    byId("zoom-reset").addEventListener("click", () => this.reset());
  }

  reset() { d3.select(this.root).call(this.zoom.transform, d3.zoomIdentity); }

  choose(x, y) {
    Object.assign(this, { x, y });
    if (this.transform !== d3.zoomIdentity) this.reset();
    this.draw();
  }

  select() { this.draw(); }
  filtered() { this.draw(); }

  draw() {
    const brush = this.begin();
    const { left, right, top, bottom } = this.box;
    const { study, x, y } = this;
    this.zoom.extent([[left, top], [right, bottom]]).translateExtent([[left, top], [right, bottom]]);
    this.scaleX = this.transform.rescaleX(x.scale(this.across, 0.03));
    this.scaleY = this.transform.rescaleY(y.scale(this.up, 0.04));
    const at = (row) => [this.scaleX(x.values[row]), this.scaleY(y.values[row])];
    const known = (row) => !Number.isNaN(x.values[row]) && !Number.isNaN(y.values[row]);
    this.rows = study.filters.rows.filter(known);
    const radius = this.rows.length > 2000 ? 2.2 : this.rows.length > 300 ? 3 : 4;
    if (study.filters.any) this.#others(brush, at, known);
    brush.globalAlpha = this.rows.length > 1500 ? 0.7 : 0.9;
    for (const row of this.rows) dot(brush, at(row), radius, study.paint.of(row));
    const best = this.rows.filter((row) => study.best.has(row));
    this.#front(brush, best, at);
    brush.globalAlpha = 1;
    Object.assign(brush, { strokeStyle: colour("--ink"), lineWidth: 1.3 });
    for (const row of best) ring(brush, at(row), radius + 1.6);
    brush.restore();
    const { selected } = study;
    const mark = selected !== null && known(selected) && this.inside(at(selected)) ? [svg("circle", { class: "chosen", cx: round(at(selected)[0]), cy: round(at(selected)[1]), r: radius + 5 })] : [];
    this.axes(x, this.scaleX, y, this.scaleY, ...mark);
    this.tree = d3.quadtree(this.rows, (row) => at(row)[0], (row) => at(row)[1]);
  }

  // The rows that the filters leave out.
  #others(brush, at, known) {
    const tone = colour("--line");
    for (let row = 0; row < this.study.count; ++row) if (!this.study.filters.passes[row] && known(row)) dot(brush, at(row), 1.6, tone);
  }

  // The line through the best of two objectives.
  #front(brush, best, at) {
    if (![this.x, this.y].every((column) => column.wanted) || this.x === this.y || this.study.columns.filter((c) => c.wanted).length !== 2) return;
    Object.assign(brush, { strokeStyle: colour("--ink"), lineWidth: 1.2, globalAlpha: 0.55 });
    brush.beginPath();
    best.map(at).sort((p, q) => p[0] - q[0] || p[1] - q[1]).forEach((p, i) => (i ? brush.lineTo(...p) : brush.moveTo(...p)));
    brush.stroke();
  }

  #near(p) { return this.inside(p) ? this.tree.find(...p, NEAR) ?? null : null; }

  #hover(p) {
    const row = this.#near(p);
    this.root.style.cursor = row === null ? "" : "pointer";
    this.showTip(p, row === null ? null : tipLines(this.study, row, [this.x, this.y, this.study.paint.column, ...this.study.columns.filter((c) => c.wanted)]));
  }

  #step(event) {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by || !this.rows.length) return;
    event.preventDefault();
    event.stopPropagation();
    const { values } = this.x;
    const order = [...this.rows].sort((a, b) => values[a] - values[b] || a - b);
    const place = order.indexOf(this.study.selected);
    this.actions.select(order[Math.min(order.length - 1, Math.max(0, place + by))]);
  }
}

function dot(brush, [x, y], radius, fill) {
  brush.fillStyle = fill;
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.fill();
}

function ring(brush, [x, y], radius) {
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.stroke();
}
