// A function that is typed, and the ranges of its angles.

import { byId } from "../dom.js";
import { say } from "../words.js";
import { areOfValues, MOST_RANGE, pairsOfValues, withRanges } from "./pairs.js";

const TYPED_PAIRS = 19;
const DOMAIN = ["domain-from", "domain-to"];

const questionOf = (expression, rest) => ({ problem: { kind: "function-values", function: expression.text, domain: expression.domain, samples: TYPED_PAIRS }, typed: expression, ...rest });

const isRange = (value, k) => Number.isFinite(value) && Math.abs(value) >= 1 && Math.abs(value) <= MOST_RANGE && (k === 1 || value > 0);

export class Typed {
  // `on`: state(), change(parts), ask(question), forget() of an expression that is not that of the pairs, announce(text).
  constructor(on) {
    Object.assign(this, { on, sure: null });
    this.fields = [byId("input-range"), byId("output-range")];
    for (const field of this.fields) field.addEventListener("change", () => this.#takeRanges());
    byId("typed").addEventListener("submit", (event) => { event.preventDefault(); this.#ask(); });
  }

  show(ranges, expression) {
    ranges?.forEach((range, k) => { this.fields[k].value = range; });
    if (!expression) return;
    byId("expression").value = expression.text;
    DOMAIN.forEach((id, k) => { byId(id).value = expression.domain[k]; });
  }

  #takeRanges() {
    const { points, ranges } = this.on.state(), asked = this.fields.map((field) => field.valueAsNumber);
    if (!asked.every(isRange)) { this.show(ranges); this.on.announce(say("sketch.bad_range", { most: MOST_RANGE })); return; }
    this.on.change({ ranges: asked, points: withRanges(points, ranges, asked) });
  }

  #ask() {
    const domain = DOMAIN.map((id) => byId(id).valueAsNumber);
    if (!(domain[0] < domain[1])) { this.on.announce(say("sketch.bad_domain")); return; }
    this.on.ask(questionOf({ text: byId("expression").value, domain }));
  }

  // The question whether a state's expression, which may be of an address, is that of its pairs; none where that is known.
  checks({ typed: expression }) { return expression && expression !== this.sure ? [questionOf(expression, { check: true })] : []; }

  // The answer to one of these questions.
  take({ values }, { typed: expression, check }) {
    const { points, ranges } = this.on.state(), isRight = values && (!check || areOfValues(points, values, ranges));
    if (isRight) this.sure = expression;
    if (isRight && !check) this.on.change({ points: pairsOfValues(values, ranges), typed: expression });
    if (!isRight && check) this.on.forget();
    if (!isRight && !check) this.on.announce(say("sketch.no_expression"));
  }
}
