// The designs to choose from.

import { byId, element } from "../dom.js";
import { degrees, number, sentence } from "../format.js";
import { say, term } from "../words.js";
import { withoutNoise } from "./candidate.js";
import { drawingSize } from "./question.js";

export const percent = (share) => `${number(100 * share, 2)}\u00a0%`;

// An error of a drawing; of a function in degrees.
const errorOfDrawing = (error, state) => `${number(withoutNoise(error, drawingSize(state)), 3)}${state.ranges ? "°" : ""}`;

// A root mean square error, also as its share of the drawing's size.
export const rmsText = (error, state) => `${errorOfDrawing(error, state)} (${percent(withoutNoise(error, drawingSize(state)) / drawingSize(state))})`;

// Of a straight line what the crank turns by over it, and how much the speed along it varies.
function lineRows({ crank_deg: [from, , to], speed_variation: variation }) {
  return [["turn", say("sketch.turn_of_crank"), to - from, degrees(to - from, 1)], ["speed", say("sketch.speed_variation"), variation, percent(variation)]];
}

// Of a slider-crank how far its slider goes.
const sliderRows = ({ stroke }) => (stroke === undefined ? [] : [["stroke", say("sketch.stroke"), stroke, number(stroke, 3)]]);

// What lengths are to be known of a candidate: of a generator their ratios, else how large it is.
function sizeRows({ entry, linkage, lengths, ratio, size: own }, state) {
  if (!state.ranges) return [["size", say("sketch.size"), own, `${number(own, 3)} (×${number(own / drawingSize(state), 2)})`], ...sliderRows(linkage)];
  const shortest = Math.min(...lengths), starts = [entry.input_start_deg, entry.output_start_deg];
  return [["ratio", say("sketch.ratio"), ratio, number(ratio, 3)], ["lengths", say("sketch.lengths"), lengths, lengths.map((length) => number(length / shortest, 3)).join(" : ")],
    ["starts", say("sketch.starts"), starts, starts.map((start) => degrees(start, 1)).join(", ")]];
}

// What a card says: the key, the name, the value and the text of each row.
function rowsOf(one, state) {
  const { entry } = one;
  return [["rms", say(state.straight ? "sketch.deviation" : "sketch.rms"), entry.rms, rmsText(entry.rms, state)], ...(state.straight ? lineRows(entry) : [["max", say("sketch.max"), entry.max, errorOfDrawing(entry.max, state)]]),
    ...(entry.stray > entry.rms ? [["stray", say("sketch.stray"), entry.stray, errorOfDrawing(entry.stray, state)]] : []),
    ...(entry.angle_max_deg === undefined ? [] : [["angle", say("sketch.angle"), entry.angle_max_deg, degrees(entry.angle_max_deg, 2)]]),
    ["least", say("sketch.transmission"), entry.transmission_acute_min_deg, degrees(entry.transmission_acute_min_deg, 1)], ["class", say("sketch.class"), entry.class, sentence(term(entry.class))], ...sizeRows(one, state)];
}

export class Cards {
  constructor(onChoose) { Object.assign(this, { onChoose, cards: [] }); }

  // A card stays, and only its values change, where it says the same of another design: that takes far less of the browser.
  show(candidates, chosen, state) {
    const rows = candidates.map((one) => rowsOf(one, state));
    this.cards = rows.map((own, i) => this.#fitting(i, own.map(([, name]) => name).join()) ?? this.#card(i, own));
    rows.forEach((own, i) => this.#fill(this.cards[i], own, i === chosen));
    const holder = byId("designs"), roots = this.cards.map(({ root }) => root);
    if (roots.length !== holder.children.length || roots.some((root, i) => root !== holder.children[i])) holder.replaceChildren(...roots);
    byId("designs-none").hidden = candidates.length > 0;
  }

  #fitting(i, names) { return this.cards[i]?.names === names ? this.cards[i] : null; }

  #card(i, rows) {
    const input = element("input", { type: "radio", name: "design", id: `design-${i}`, value: i });
    input.addEventListener("change", () => this.onChoose(i));
    const values = rows.map(([key]) => element("dd", { "data-fact": key }));
    const root = element("label", { class: `design-card sketch-${i}`, for: `design-${i}` }, element("span", { class: "design-name" }, input, say("sketch.design", { name: i + 1 })),
      element("dl", {}, ...rows.map(([, name], k) => element("div", {}, element("dt", {}, name), values[k]))));
    return { root, input, values, names: rows.map(([, name]) => name).join() };
  }

  #fill({ input, values }, rows, chosen) {
    input.checked = chosen;
    rows.forEach(([, , value, text], k) => {
      values[k].dataset.value = JSON.stringify(value);
      if (values[k].textContent !== text) values[k].textContent = text;
    });
  }
}
