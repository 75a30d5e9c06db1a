// A plane of two columns: a bitmap for what is many, and above it axes and marks.

import { element, set, svg } from "../dom.js";
import { round } from "../shapes.js";
import { say } from "../words.js";

// A bitmap of `width` × `height` in the page's pixels.
export function sized(canvas, width, height) {
  const ratio = Math.min(3, devicePixelRatio || 1);
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    set(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio), style: `width:${width}px;height:${height}px` });
  }
  const brush = canvas.getContext("2d");
  brush.setTransform(ratio, 0, 0, ratio, 0, 0);
  brush.clearRect(0, 0, width, height);
  return brush;
}

export class Plane {
  constructor(holder, label) {
    this.holder = holder;
    this.canvas = element("canvas", { "aria-hidden": "true" });
    this.root = svg("svg", { role: "application", tabindex: 0, "aria-label": label });
    this.tip = element("div", { class: "tip", hidden: "" });
    holder.append(this.canvas, this.root, this.tip);
  }

  // Measures the holder, empties the bitmap and returns its brush, clipped to the plane.
  begin() {
    [this.width, this.height] = [this.holder.clientWidth || 600, this.holder.clientHeight || 400];
    this.box = { left: 62, top: 10, right: this.width - 14, bottom: this.height - 42 };
    const brush = sized(this.canvas, this.width, this.height);
    set(this.root, { viewBox: `0 0 ${this.width} ${this.height}` });
    brush.save();
    brush.beginPath();
    brush.rect(this.box.left, this.box.top, this.box.right - this.box.left, this.box.bottom - this.box.top);
    brush.clip();
    return brush;
  }

  get across() { return [this.box.left, this.box.right]; }
  get up() { return [this.box.bottom, this.box.top]; }

  // Both axes with their names; `marks` above them.
  axes(x, scaleX, y, scaleY, ...marks) {
    const { left, right, top, bottom } = this.box;
    const label = (column, v) => shorten(column.show(v, 4), 11);
    const parts = [svg("rect", { class: "frame", x: left, y: top, width: right - left, height: bottom - top })];
    for (const v of x.ticks(scaleX, 80)) {
      const at = round(scaleX(v));
      if (at >= left - 1 && at <= right + 1) parts.push(svg("path", { class: "tick", d: `M${at} ${bottom}v5` }), svg("text", { class: "tick-text", x: at, y: bottom + 17, "text-anchor": "middle" }, label(x, v)));
    }
    for (const v of y.ticks(scaleY, 50)) {
      const at = round(scaleY(v));
      if (at >= top - 1 && at <= bottom + 1) parts.push(svg("path", { class: "tick", d: `M${left} ${at}h-5` }), svg("text", { class: "tick-text", x: left - 8, y: at + 4, "text-anchor": "end" }, label(y, v)));
    }
    parts.push(svg("text", { class: "axis-text", x: (left + right) / 2, y: bottom + 35, "text-anchor": "middle" }, x.label),
      svg("text", { class: "axis-text", transform: `translate(13 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, y.label));
    this.root.replaceChildren(...parts, ...marks);
  }

  // Where the pointer is, in the plane's pixels.
  pointer(event) {
    const area = this.root.getBoundingClientRect();
    return [event.clientX - area.left, event.clientY - area.top];
  }

  inside([x, y]) { return x >= this.box.left && x <= this.box.right && y >= this.box.top && y <= this.box.bottom; }

  showTip([x, y], lines) {
    this.tip.hidden = lines === null;
    if (!lines) return;
    this.tip.replaceChildren(...lines.map((line) => element("div", {}, line)));
    const left = Math.min(x + 14, this.width - this.tip.offsetWidth - 4);
    const top = y + 14 + this.tip.offsetHeight > this.height ? y - 10 - this.tip.offsetHeight : y + 14;
    this.tip.style.transform = `translate(${round(Math.max(0, left))}px, ${round(Math.max(0, top))}px)`;
  }

  // Draws anew where the holder's size has changed.
  watch() {
    new ResizeObserver(() => { if (this.holder.clientWidth !== this.width || this.holder.clientHeight !== this.height) this.later(); }).observe(this.holder);
  }

  // Joins the requests of a frame into one drawing.
  later() {
    this.pending ??= requestAnimationFrame(() => { this.pending = undefined; this.draw(); });
  }
}

export const shorten = (text, most) => (text.length > most ? `${text.slice(0, most - 1)}…` : text);

// The rows' own lines of a tip: number, and the columns named.
export const tipLines = (study, row, columns) => [`${say("row.design", { n: study.ids[row] })}${study.best.has(row) ? " ★" : ""}`,
  ...[...new Set(columns)].filter(Boolean).map((column) => say("row.value", { name: column.label, value: column.text(row) }))];
