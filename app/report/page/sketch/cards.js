// The designs to choose from.

import { byId, element } from "../dom.js";
import { degrees, number, sentence } from "../format.js";
import { say, term } from "../words.js";
import { withoutNoise } from "./candidate.js";

const percent = (share) => `${number(100 * share, 2)}\u00a0%`;

// A root mean square error of a drawing of `size`, also as its share.
export function rmsText(error, size) {
  const rms = withoutNoise(error, size);
  return `${number(rms, 3)} (${percent(rms / size)})`;
}

export class Cards {
  constructor(onChoose) { this.onChoose = onChoose; }

  // Of a drawing of `size`.
  show(candidates, chosen, size) {
    byId("designs").replaceChildren(...candidates.map((one, i) => this.#card(one, i, i === chosen, size)));
    byId("designs-none").hidden = candidates.length > 0;
  }

  #card({ entry, size: own }, i, chosen, size) {
    const input = element("input", { type: "radio", name: "design", id: `design-${i}`, value: i });
    input.checked = chosen;
    input.addEventListener("change", () => this.onChoose(i));
    const rows = [["rms", say("sketch.rms"), entry.rms, rmsText(entry.rms, size)], ["max", say("sketch.max"), entry.max, number(withoutNoise(entry.max, size), 3)],
      ...(entry.angle_max_deg === undefined ? [] : [["angle", say("sketch.angle"), entry.angle_max_deg, degrees(entry.angle_max_deg, 2)]]),
      ["least", say("sketch.transmission"), entry.transmission_acute_min_deg, degrees(entry.transmission_acute_min_deg, 1)], ["class", say("sketch.class"), entry.class, sentence(term(entry.class))],
      ["size", say("sketch.size"), own, `${number(own, 3)} (×${number(own / size, 2)})`]];
    return element("label", { class: `design-card sketch-${i}`, for: `design-${i}` }, element("span", { class: "design-name" }, input, say("sketch.design", { name: i + 1 })),
      element("dl", {}, ...rows.map(([key, name, value, text]) => element("div", {}, element("dt", {}, name), element("dd", { "data-fact": key, "data-value": JSON.stringify(value) }, text)))));
  }
}
