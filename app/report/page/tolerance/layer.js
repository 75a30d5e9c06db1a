// In the picture: the mechanism with its dimensions as the sliders set them, and how far its point may
// be off, both magnified.

import { svg } from "../dom.js";
import { legendItem, pathThrough, pathWithGaps } from "../shapes.js";
import { say } from "../words.js";

const away = (p, q, times) => p.map((value, k) => value + times * (q[k] - value));

export class ToleranceLayer {
  // `card`: the tolerances of the page.
  constructor(card) {
    Object.assign(this, { card, name: "tolerance", words: "tolerance.layer", key: "o", root: svg("g", { class: "tolerance-layer" }) });
  }

  available(scene) { return Boolean(scene.view) && this.card.shown && (this.card.adjustable || this.card.whiskers().length > 0); }

  build(scene) {
    const { times } = this.card;
    const whiskers = this.card.whiskers().map(({ at, normal, low, high, inner }) => {
      const ends = (list) => list.map((d) => scene.view.screen([at[0] + times * d * normal[0], at[1] + times * d * normal[1]]));
      return [svg("path", { class: "whisker", d: pathThrough(ends([low, high])) }), ...(inner ? [svg("path", { class: "whisker inner", d: pathThrough(ends(inner)) })] : [])];
    });
    this.line = svg("path", { class: "changed-line" });
    this.curve = svg("path", { class: "changed-curve" });
    this.root.replaceChildren(...whiskers.flat(), this.curve, this.line);
  }

  move({ view }, drive) {
    const pair = this.card.outlines(drive);
    const { times } = this.card;
    const drawn = (from, to) => from.map((p, i) => p && to[i] && view.screen(away(p, to[i], times)));
    this.line.setAttribute("d", pair ? pair.lines.map(([from, to]) => pathWithGaps(drawn(from, to))).join("") : "");
    this.curve.setAttribute("d", pair?.curve ? pathWithGaps(drawn(...pair.curve)) : "");
  }

  legend() {
    const times = `×${this.card.times.toLocaleString()}`;
    return [...(this.card.adjustable ? [legendItem("tolerance", "dashed", say("tolerance.as_set", { times }))] : []),
      ...(this.card.whiskers().length ? [legendItem("tolerance", "line", say("tolerance.whiskers", { times }))] : [])];
  }
}

export const roundedTimes = (wanted) => Math.max(1, 10 ** Math.floor(Math.log10(wanted)), 5 * 10 ** Math.floor(Math.log10(wanted / 5)));
