// The card of a front beside the designs: what is searched for it, its plot, and what is said of it.

import { byId } from "../dom.js";
import { degrees, sentence } from "../format.js";
import { say, term } from "../words.js";
import { rmsText } from "./cards.js";
import { Front } from "./front.js";
import { FrontPlot } from "./front_plot.js";

export class FrontPanel {
  // `on.point(candidate)`: the one to look at, null where none is; `on.take(candidate, level)`: chosen, for that bound.
  constructor(on) {
    this.front = new Front();
    const point = (looked) => { this.#read(looked); on.point(looked?.candidate ?? null); };
    this.plot = new FrontPlot({ point, take: ({ candidate, level }) => on.take(candidate, level) }, (one) => this.#textOf(one));
  }

  // Of a state at rest; null of one that has no front yet, or changes under the hand.
  follow(state) {
    byId("front").hidden = !state;
    this.state = state;
    if (state) this.front.follow(state);
    this.show(this.chosen);
  }

  // With the design chosen, if any.
  show(chosen) {
    this.chosen = chosen;
    const points = this.state && this.front.stands ? this.front.points : [], isPlotted = points.length > 1;
    byId("front-plot").hidden = byId("front-reading").hidden = !isPlotted;
    byId("front-note").textContent = isPlotted ? say(this.front.ended ? "sketch.front_hint" : "sketch.front_going_on") : this.#without(points);
    this.plot.show({ points: isPlotted ? points : [], chosen: isPlotted && chosen ? this.front.pointOf(chosen) : null, least: this.state?.least, axis: this.state?.ranges ? "sketch.front_error_deg" : this.state?.straight ? "sketch.front_deviation" : "sketch.front_error" });
    this.#read(this.plot.hinted);
  }

  // Why there is no plot.
  #without([only]) {
    if (!this.state || !this.front.ended) return say("sketch.front_waits");
    if (!only) return say("sketch.front_none", { least: degrees(this.front.least, 0) });
    return say("sketch.front_one", { angle: degrees(only.angle, 1), error: this.#errorOf(only), least: degrees(only.level, 0) });
  }

  #errorOf({ error }) { return rmsText(error, this.front.state); }

  #textOf(point) {
    return say(this.front.state.straight ? "sketch.front_point_of_line" : "sketch.front_point", { angle: degrees(point.angle, 1), error: this.#errorOf(point), class: sentence(term(point.candidate.entry.class)) });
  }

  // The values of a point, else of the design chosen.
  #read(point) {
    const shown = point ?? this.plot.front.chosen;
    byId("front-reading").textContent = shown ? this.#textOf(shown) : "";
  }
}
