// The designs to choose from.

import { byId, element } from "../dom.js";
import { degrees, number, sentence } from "../format.js";
import { say, term } from "../words.js";
import { drawingSize } from "./question.js";

const percent = (share) => `${number(100 * share, 2)} %`;

export class Cards {
  constructor(onChoose) { this.onChoose = onChoose; }

  show(candidates, chosen, points) {
    const size = drawingSize(points);
    byId("designs").replaceChildren(...candidates.map((one, i) => this.#card(one, i, i === chosen, size)));
    byId("designs-none").hidden = candidates.length > 0;
  }

  #card({ entry, size: own }, i, chosen, size) {
    const input = element("input", { type: "radio", name: "design", id: `design-${i}`, value: i });
    input.checked = chosen;
    input.addEventListener("change", () => this.onChoose(i));
    const rows = [["rms", say("sketch.rms"), entry.rms, `${number(entry.rms, 3)} (${percent(entry.rms / size)})`], ["max", say("sketch.max"), entry.max, number(entry.max, 3)],
      ["least", say("sketch.transmission"), entry.transmission_acute_min_deg, degrees(entry.transmission_acute_min_deg, 1)], ["class", say("sketch.class"), entry.class, sentence(term(entry.class))],
      ["size", say("sketch.size"), own, `${number(own, 3)} (×${number(own / size, 2)})`]];
    return element("label", { class: `design-card sketch-${i}`, for: `design-${i}` }, element("span", { class: "design-name" }, input, say("sketch.design", { name: i + 1 })),
      element("dl", {}, ...rows.map(([key, name, value, text]) => element("div", {}, element("dt", {}, name), element("dd", { "data-fact": key, "data-value": JSON.stringify(value) }, text)))));
  }
}
