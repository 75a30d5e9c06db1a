// Plots over the drive, drawn by uPlot.

import { colour, element, svg } from "./dom.js";
import { number } from "./format.js";
import { PlotCursor } from "./plot_cursor.js";
import { tableButton } from "./plot_table.js";
import { interpolate, locate } from "./sampling.js";
import { say } from "./words.js";

// Steps of an axis of angles, in degrees.
export const TURN_STEPS = [1, 2, 5, 10, 15, 30, 45, 60, 90, 180];

// Makes the plots in `holder`; `onPick` is called with the drive coordinate that is chosen, `onPoint`
// with the one pointed at, null where none is.
export class Curves {
  constructor(holder, onPick, onPoint = () => {}) {
    Object.assign(this, { holder, onPick, onPoint, plots: [], drive: undefined });
    this.available = typeof uPlot !== "undefined";
    new ResizeObserver(() => this.#resize()).observe(holder);
  }

  build(sheets) {
    for (const { plot } of this.plots) plot.destroy();
    this.plots = [];
    this.holder.replaceChildren();
    if (!this.available) {
      this.holder.append(element("p", { class: "muted" },
        say("curves.no_library")));
      return;
    }
    // All boxes first, so that each has its width before a plot fills it.
    const boxes = sheets.map((sheet) => [sheet, this.#box(sheet)]);
    this.plots = boxes.map(([sheet, box]) => this.#plot(sheet, box));
  }

  #box(sheet) {
    const box = element("div", { role: "img", "aria-label": say("curves.label", { title: sheet.title, summary: sheet.summary }) });
    this.holder.append(element("div", { class: "plot" }, element("div", { class: "plot-head" }, element("h3", {}, sheet.title), tableButton(sheet, box)), ...this.#notes(sheet), box));
    return box;
  }

  // Below the title: a note, and for lines with a label their signs and present values.
  #notes(sheet) {
    const keys = sheet.lines.filter((line) => line.label).map((line) => {
      line.value = element("b", {});
      return element("span", {}, keySign(line), line.label, line.value);
    });
    const note = element("p", {}, sheet.note ?? "");
    return keys.length ? [...(sheet.note ? [note] : []), element("div", { class: "keys" }, ...keys)] : [note];
  }

  #plot(sheet, box) {
    const plot = new uPlot(plotOptions(sheet, box.clientWidth || 320), [sheet.x, ...sheet.lines.map((line) => line.y)], box);
    const driveOf = (event) => sheet.driveAt(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
    const pick = (event) => { this.point(null); this.onPick(driveOf(event)); };
    plot.over.addEventListener("pointerdown", (event) => { plot.over.setPointerCapture(event.pointerId); pick(event); });
    plot.over.addEventListener("pointermove", (event) => { if (plot.over.hasPointerCapture(event.pointerId)) pick(event); else this.point(driveOf(event)); });
    plot.over.addEventListener("pointerleave", () => this.point(null));
    return { plot, sheet, box, cursor: new PlotCursor({ plot, sheet }) };
  }

  // A cursor on every plot at the drive coordinate that one of them is pointed at.
  point(drive) {
    for (const { cursor } of this.plots) cursor.show(drive);
    this.onPoint(drive);
  }

  move(drive) {
    this.drive = drive;
    for (const { plot, sheet } of this.plots) {
      const x = sheet.xAt(drive);
      const left = x === null ? -10 : plot.valToPos(x, "x");
      if (x !== null) showValues(sheet, x);
      plot.setCursor({ left, top: left < 0 ? -10 : 0 }, false);
    }
  }

  // After values of the lines have changed.
  refill() {
    for (const { plot, sheet } of this.plots) plot.setData([sheet.x, ...sheet.lines.map((line) => line.y)]);
  }

  redraw() {
    this.#resize();
    for (const { plot } of this.plots) plot.redraw(false, true);
  }

  // A plot of another size has lost its cursor.
  #resize() {
    const outgrown = this.plots.filter(({ plot, box }) => box.clientWidth && box.clientWidth !== plot.width);
    for (const { plot, box } of outgrown) plot.setSize({ width: box.clientWidth, height: plot.height });
    if (outgrown.length && this.drive !== undefined) this.move(this.drive);
  }
}

function plotOptions(sheet, width) {
  const font = '11px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
  const axis = (more) => ({ stroke: () => colour("--soft"), font, labelFont: font, labelSize: 18, values: (_, splits) => splits.map((value) => number(value, 6)), ticks: { show: false },
    grid: { stroke: () => colour("--grid"), width: 1 }, ...more });
  return {
    width, height: 220, legend: { show: false }, padding: [10, 12, 0, 0],
    cursor: { y: false, drag: { x: false, y: false }, bind: { mousemove: () => null, mousedown: () => null, mouseup: () => null, click: () => null, dblclick: () => null, mouseleave: () => null },
      points: { show: sheet.hover !== false, size: 8 } },
    scales: { x: { time: false, range: () => sheet.xRange }, y: { range: (_, low, high) => sheet.yRange ?? padded(low, high) } },
    axes: [axis({ label: sheet.xLabel, size: 30, incrs: sheet.xSteps }), axis({ size: 46 })],
    series: [{}, ...sheet.lines.map((line) => ({ stroke: () => colour(line.colour), width: 2, spanGaps: false, pxAlign: 0,
      dash: line.dash, points: line.dots ? { show: true, size: 7, fill: () => colour(line.colour) } : { show: false },
      ...(line.dots || line.ends ? { paths: () => null } : {}) }))],
    bands: (sheet.bands ?? []).map(({ low, high, colour: name }) => ({ series: [high + 1, low + 1], fill: () => colour(name) })),
    hooks: { drawClear: [(u) => shade(u, sheet), (u) => marks(u, sheet)], draw: [(u) => stems(u, sheet), (u) => whiskers(u, sheet), (u) => spots(u, sheet)] },
  };
}

function showValues(sheet, x) {
  if (!sheet.lines.some((line) => line.value) || sheet.x.length < 2) return;
  const place = locate(sheet.x, x);
  for (const line of sheet.lines) if (line.value) line.value.textContent = line.show(interpolate(line.y, place));
}

// The sign of a line in a key: its colour and its dashes.
export function keySign({ colour: name, dash }) {
  return svg("svg", { viewBox: "0 0 20 8", "aria-hidden": "true" },
    svg("path", { d: "M0 4H20", style: `stroke:var(${name});stroke-width:2.2;stroke-dasharray:${dash ? dash.join(" ") : "none"}` }));
}

// Places on the x axis worth a line.
function marks(u, sheet) {
  u.ctx.save();
  u.ctx.lineWidth = 1.4 * devicePixelRatio;
  u.ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
  for (const { at, colour: name } of sheet.marks ?? []) {
    const left = Math.round(u.valToPos(at, "x", true)) + 0.5;
    u.ctx.strokeStyle = colour(name);
    u.ctx.beginPath();
    u.ctx.moveTo(left, u.bbox.top);
    u.ctx.lineTo(left, u.bbox.top + u.bbox.height);
    u.ctx.stroke();
  }
  u.ctx.restore();
}

export function padded(low, high) {
  const margin = 0.08 * (high - low) || 0.1 * Math.abs(high) || 1;
  return [low - margin, high + margin];
}

// Regions behind the curves: what the limits forbid, and the part of the turn that is used. `over`
// is the part of the x axis where a limit of values holds.
function shade(u, sheet) {
  for (const { axis, from, to, over, colour: name } of sheet.shades ?? []) {
    const { left, top, width, height } = u.bbox;
    const ends = [from, to].map((value) => u.valToPos(value, axis, true));
    u.ctx.save();
    u.ctx.beginPath();
    u.ctx.rect(left, top, width, height);
    u.ctx.clip();
    u.ctx.fillStyle = colour(name);
    if (axis === "x") u.ctx.fillRect(ends[0], top, ends[1] - ends[0], height);
    else {
      const [begin, end] = over ? over.map((value) => u.valToPos(value, "x", true)) : [left, left + width];
      u.ctx.fillRect(begin, ends[0], end - begin, ends[1] - ends[0]);
    }
    u.ctx.restore();
  }
}

// Lines from zero to each value of a plot of single values.
function stems(u, sheet) {
  if (!sheet.stems) return;
  u.ctx.save();
  u.ctx.strokeStyle = colour(sheet.lines[0].colour);
  u.ctx.lineWidth = 2 * devicePixelRatio;
  const zero = u.valToPos(0, "y", true);
  sheet.x.forEach((x, i) => {
    const value = sheet.lines[0].y[i];
    if (value === null) return;
    const left = u.valToPos(x, "x", true);
    u.ctx.beginPath();
    u.ctx.moveTo(left, zero);
    u.ctx.lineTo(left, u.valToPos(value, "y", true));
    u.ctx.stroke();
  });
  u.ctx.restore();
}

// At single places a band is a line from one of its ends to the other.
function whiskers(u, sheet) {
  u.ctx.save();
  for (const [low, high, width] of sheet.whiskers ?? []) {
    u.ctx.strokeStyle = colour(sheet.lines[low].colour);
    u.ctx.lineWidth = width * devicePixelRatio;
    sheet.x.forEach((x, i) => {
      const ends = [low, high].map((line) => sheet.lines[line].y[i]);
      if (ends.includes(null)) return;
      const left = u.valToPos(x, "x", true);
      u.ctx.beginPath();
      ends.forEach((value, k) => u.ctx[k ? "lineTo" : "moveTo"](left, u.valToPos(value, "y", true)));
      u.ctx.stroke();
    });
  }
  u.ctx.restore();
}

// Single places that a plot is about.
function spots(u, sheet) {
  u.ctx.save();
  u.ctx.lineWidth = 2 * devicePixelRatio;
  u.ctx.fillStyle = colour("--card");
  for (const { x, y, colour: name } of sheet.spots ?? []) {
    u.ctx.strokeStyle = colour(name);
    u.ctx.beginPath();
    u.ctx.arc(u.valToPos(x, "x", true), u.valToPos(y, "y", true), 4 * devicePixelRatio, 0, 2 * Math.PI);
    u.ctx.fill();
    u.ctx.stroke();
  }
  u.ctx.restore();
}
