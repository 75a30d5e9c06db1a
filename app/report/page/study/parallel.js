// Parallel coordinates: an axis for each column and a line for each row. A brush on an axis filters
// the page; axes are moved, turned over and hidden by their names.

import { colour, element, set, svg } from "../dom.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { shorten, sized } from "./axes.js";

// `least`: pixels that an axis takes where there is room, `narrow` where there is little, and its name stands upright.
const PARALLEL = { height: 330, top: 64, foot: 26, least: 92, narrow: 70, phone: 560, bins: 28, most: 14 };

// How many letters of a text have room between two narrow axes: Chinese ones are as wide as high.
const lettersIn = (room, text) => Math.max(4, Math.floor((room - 12) / (/[\u4e00-\u9fff]/.test(text) ? 11 : 6.2)));

// What is not drawn at first: columns of one value, and of many the least useful.
function firstHidden(columns) {
  const varying = columns.filter((column) => !column.constant);
  const rank = (column) => (column.wanted ? 0 : column.role === "variable" ? 1 : 2);
  const first = [...(varying.length > 1 ? varying : columns)].sort((a, b) => rank(a) - rank(b)).slice(0, PARALLEL.most);
  return new Set(columns.filter((column) => !first.includes(column)));
}

export class Parallel {
  // `actions.filter(column, range)`, `actions.changed()` where axes are hidden.
  constructor(holder, study, actions) {
    Object.assign(this, { holder, study, actions, order: [...study.columns], hidden: firstHidden(study.columns), turned: new Set() });
    this.frame = element("div", { class: "parallel" });
    [this.back, this.front] = [element("canvas", { "aria-hidden": "true" }), element("canvas", { "aria-hidden": "true" })];
    this.root = svg("svg", { role: "group", "aria-label": say("parallel.axes") });
    this.names = element("div", { class: "axis-names" });
    this.frame.append(this.back, this.front, this.root, this.names);
    holder.append(this.frame);
  }

  get shown() { return this.order.filter((column) => !this.hidden.has(column)); }

  show(column, shown) {
    if (shown) this.hidden.delete(column); else this.hidden.add(column);
    this.build();
    this.actions.changed();
  }

  move(column, by) {
    const { shown } = this;
    const other = shown[shown.indexOf(column) + by];
    if (!other) return;
    this.order = this.order.filter((c) => c !== column);
    this.order.splice(this.order.indexOf(other) + (by > 0 ? 1 : 0), 0, column);
    this.build();
    this.names.querySelector(`[data-column="${column.index}"]`).focus();
  }

  turn(column) {
    if (!this.turned.delete(column)) this.turned.add(column);
    this.build();
  }

  // Axes, scales and brushes; then all rows.
  build() {
    const { shown } = this;
    const given = this.holder.clientWidth || 800;
    const isNarrow = given < PARALLEL.phone;
    const width = Math.max(given, (isNarrow ? PARALLEL.narrow : PARALLEL.least) * shown.length);
    const room = width / Math.max(1, shown.length);
    this.frame.classList.toggle("narrow", isNarrow);
    this.frame.style.width = `${width}px`;
    const [top, bottom] = [PARALLEL.top, PARALLEL.height - PARALLEL.foot];
    this.axes = shown.map((column, i) => ({ column, x: room * (i + 0.5), room, scale: column.scale(this.turned.has(column) ? [top, bottom] : [bottom, top], column.words ? 0 : 0.01) }));
    this.width = width;
    set(this.root, { viewBox: `0 0 ${width} ${PARALLEL.height}`, width, height: PARALLEL.height });
    this.names.replaceChildren(...this.axes.map((axis) => this.#name(axis)));
    this.root.replaceChildren(...this.axes.map((axis) => this.#axis(axis)), this.chosen = svg("path", { class: "chosen-line" }));
    this.#placeRows();
    this.draw();
    this.#placeBrushes();
    this.select();
  }

  #name({ column, x, room }) {
    const text = `${this.turned.has(column) ? "↓ " : ""}${column.label}`;
    const button = element("button", { type: "button", "data-column": column.index, style: `left:${x}px;width:${room - 6}px`,
      title: say("parallel.axis_title", { name: column.name }) }, element("span", {}, text));
    const mark = { least: " ↓", greatest: " ↑" }[column.wanted];
    if (mark) button.firstChild.append(element("b", { title: say(`parallel.wanted_${column.wanted}`) }, mark));
    let start = null;
    button.addEventListener("pointerdown", (event) => { start = event.clientX; button.setPointerCapture(event.pointerId); });
    button.addEventListener("pointermove", (event) => { if (start !== null) button.style.translate = `${event.clientX - start}px 0`; });
    button.addEventListener("pointercancel", () => { start = null; button.style.translate = ""; });
    button.addEventListener("pointerup", (event) => {
      const by = Math.round((event.clientX - start) / room);
      start = null;
      button.style.translate = "";
      if (by) this.#moveFar(column, by);
      button.dataset.dragged = by ? "yes" : "";
    });
    button.addEventListener("click", () => { if (!button.dataset.dragged) this.turn(column); button.dataset.dragged = ""; });
    button.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (by) this.move(column, by);
      else if (event.key === "Delete" && this.shown.length > 2) this.show(column, false);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    return button;
  }

  #moveFar(column, by) { for (let i = 0; i < Math.abs(by); ++i) this.move(column, Math.sign(by)); }

  // The axis with ticks, a histogram of the rows that pass, and its brush.
  #axis(axis) {
    const { column, x, scale } = axis;
    const [top, bottom] = [PARALLEL.top, PARALLEL.height - PARALLEL.foot];
    axis.bars = svg("path", { class: "bars" });
    const group = svg("g", { transform: `translate(${round(x)} 0)` }, axis.bars, svg("path", { class: "axis-line", d: `M0 ${top}V${bottom}` }));
    for (const v of axis.room < 60 ? column.ticks(scale, 300) : column.ticks(scale, 44)) {
      const y = round(scale(v));
      group.append(svg("path", { class: "tick", d: `M-4 ${y}H0` }), svg("text", { class: "tick-text", x: -7, y: y + 4, "text-anchor": "end" }, shorten(column.show(v, 4), axis.room < 92 ? lettersIn(axis.room, column.show(v, 4)) : 12)));
    }
    if (column.missing) group.append(svg("text", { class: "tick-text", x: 0, y: PARALLEL.height - 4, "text-anchor": "middle" }, say("parallel.missing")));
    const brush = d3.brushY().extent([[-13, top], [13, bottom]]).on("brush end", (event) => { if (event.sourceEvent) this.#brushed(axis, event.selection); });
    axis.brush = d3.select(svg("g", { class: "brush" }));
    group.append(axis.brush.node());
    axis.brush.call(brush);
    axis.place = (range) => axis.brush.call(brush.move, range);
    return group;
  }

  #brushed({ column, scale }, selection) {
    const ends = selection?.map((y) => scale.invert(y)).sort((a, b) => a - b);
    this.actions.filter(column, !ends ? null : column.words ? [Math.ceil(ends[0]), Math.floor(ends[1])] : ends);
  }

  // Of each row the height on each axis; what it lacks is below.
  #placeRows() {
    for (const axis of this.axes) axis.ys = Float32Array.from(axis.column.values, (v) => (Number.isNaN(v) ? PARALLEL.height - 18 : axis.scale(v)));
  }

  #line(brush, row) {
    this.axes.forEach(({ x, ys }, i) => (i ? brush.lineTo(x, ys[row]) : brush.moveTo(x, ys[row])));
  }

  draw() {
    this.hasBack = false;
    this.#drawRows();
  }

  // What stands behind where rows are left out: all in grey. Each line is stroked by itself, since
  // one path of thousands of crossing lines takes the browser seconds.
  #drawBack() {
    if (this.hasBack) return;
    this.hasBack = true;
    const brush = sized(this.back, this.width, PARALLEL.height);
    brush.strokeStyle = colour("--line");
    brush.globalAlpha = this.study.count > 1000 ? 0.35 : 0.7;
    for (let row = 0; row < this.study.count; ++row) {
      brush.beginPath();
      this.#line(brush, row);
      brush.stroke();
    }
  }

  // The rows that pass in their colours, the best last.
  #drawRows() {
    const { filters, paint, best } = this.study;
    this.back.toggleAttribute("hidden", !filters.any);
    if (filters.any) this.#drawBack();
    const brush = sized(this.front, this.width, PARALLEL.height);
    const stroke = (rows, alpha, width) => {
      Object.assign(brush, { globalAlpha: alpha, lineWidth: width, lineJoin: "round" });
      for (const row of rows) {
        brush.strokeStyle = paint.of(row);
        brush.beginPath();
        this.#line(brush, row);
        brush.stroke();
      }
    };
    stroke(filters.rows.filter((row) => !best.has(row)), Math.min(0.85, Math.max(0.06, 8 / Math.sqrt(filters.rows.length + 1))), 1);
    stroke(filters.rows.filter((row) => best.has(row)), best.size > 200 ? 0.5 : 0.95, 1.8);
  }

  // After the filters have changed.
  filtered() {
    this.#drawRows();
    this.#placeBrushes();
  }

  #placeBrushes() {
    for (const axis of this.axes) {
      const range = this.study.filters.chosen.get(axis.column);
      const [low, high] = axis.scale.range().slice().sort((a, b) => a - b);
      const place = (v) => Math.min(high, Math.max(low, axis.scale(v)));
      if (!axis.brush.node().matches(":active")) axis.place(range ? this.#ends(axis.column, range).map(place).sort((a, b) => a - b) : null);
      axis.bars.setAttribute("d", this.#bars(axis));
    }
  }

  #ends(column, [from, to]) {
    const [least, greatest] = column.domain(column.words ? 0 : 0.01);
    const half = column.words ? 0.4 : 0;
    return [Math.max(from - half, least), Math.min(to + half, greatest)];
  }

  #bars({ scale, ys, room }) {
    const counts = new Array(PARALLEL.bins).fill(0);
    const [low, high] = scale.range().slice().sort((a, b) => a - b);
    const step = (high - low) / PARALLEL.bins;
    for (const row of this.study.filters.rows) {
      if (ys[row] <= high + 0.5) counts[Math.min(PARALLEL.bins - 1, Math.max(0, Math.floor((ys[row] - low) / step)))] += 1;
    }
    const most = Math.max(1, ...counts);
    return counts.map((n, i) => (n ? `M1 ${round(low + i * step + 0.5)}h${round(Math.max(1, (0.3 * room * n) / most))}v${round(step - 1)}H1Z` : "")).join("");
  }

  select() {
    const row = this.study.selected;
    this.chosen.setAttribute("d", row === null ? "" : pathThrough(this.axes.map(({ x, ys }) => [x, ys[row]])));
  }
}
