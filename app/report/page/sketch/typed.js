// A function that is typed, and the ranges of its angles.

import { byId } from "../dom.js";
import { say } from "../words.js";
import { MOST_RANGE, pairsOfValues, withRanges } from "./pairs.js";

const TYPED_PAIRS = 19;

const isRange = (value, k) => Number.isFinite(value) && Math.abs(value) >= 1 && Math.abs(value) <= MOST_RANGE && (k === 1 || value > 0);

export class Typed {
  // `on`: state(), change(parts), ask(question), announce(text).
  constructor(on) {
    this.on = on;
    this.fields = [byId("input-range"), byId("output-range")];
    for (const field of this.fields) field.addEventListener("change", () => this.#takeRanges());
    byId("typed").addEventListener("submit", (event) => { event.preventDefault(); this.#ask(); });
  }

  show(ranges) { ranges?.forEach((range, k) => { this.fields[k].value = range; }); }

  #takeRanges() {
    const { points, ranges } = this.on.state(), asked = this.fields.map((field) => field.valueAsNumber);
    if (!asked.every(isRange)) { this.show(ranges); this.on.announce(say("sketch.bad_range", { most: MOST_RANGE })); return; }
    this.on.change({ ranges: asked, points: withRanges(points, ranges, asked) });
  }

  #ask() {
    const domain = ["domain-from", "domain-to"].map((id) => byId(id).valueAsNumber);
    if (!(domain[0] < domain[1])) { this.on.announce(say("sketch.bad_domain")); return; }
    this.on.ask({ problem: { kind: "function-values", function: byId("expression").value, domain, samples: TYPED_PAIRS }, typed: true });
  }

  // The answer to that question.
  take({ values }) {
    if (values) this.on.change({ points: pairsOfValues(values, this.on.state().ranges) });
    else this.on.announce(say("sketch.no_expression"));
  }
}
