// The cursor that all plots share while one of them is pointed at: a line, and the values there.

import { element } from "./dom.js";
import { number } from "./format.js";
import { interpolate, locate } from "./sampling.js";

export class PlotCursor {
  constructor({ plot, sheet }) {
    Object.assign(this, { plot, sheet, line: element("div", { class: "hover-line", hidden: "" }), text: element("div", { class: "hover-text" }) });
    this.line.append(this.text);
    plot.over.append(this.line);
  }

  // `drive`: null takes the cursor away.
  show(drive) {
    const x = drive === null ? null : this.sheet.xAt(drive);
    this.line.hidden = x === null || this.sheet.x.length < 2;
    if (this.line.hidden) return;
    const left = this.plot.valToPos(x, "x");
    const width = this.plot.over.clientWidth;
    this.line.style.transform = `translateX(${Math.round(left)}px)`;
    this.text.classList.toggle("leftward", left > width / 2);
    const { sheet } = this;
    const place = locate(sheet.x, x);
    const value = (line) => (sheet.stems ? this.#nearest(line, x) : interpolate(line.y, place));
    this.text.replaceChildren(element("div", {}, number(x, 5)), ...sheet.lines.map((line) => element("div", {},
      element("span", { class: "dot", style: `background:var(${line.colour})` }), [line.label, number(value(line), 5)].filter(Boolean).join(" "))));
  }

  // Of single values that which stands nearest.
  #nearest(line, x) {
    return line.y[this.sheet.x.reduce((best, at, i, all) => (Math.abs(at - x) < Math.abs(all[best] - x) ? i : best), 0)];
  }
}
