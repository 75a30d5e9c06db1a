// Facts of a motion or of a synthesis in words.

import { degreesShort, number, sentence } from "./format.js";
import { keyword, language, LENGTH_UNIT, say, sentenceOf, term } from "./words.js";

const FACT_WORDS = { min: say("fact.least"), max: say("fact.greatest"), N_m: say("unit.torque"), N: say("unit.force"), deg: "°", length: LENGTH_UNIT ?? "" };

const NO_ANGLE = 1e-9;

// Facts that are lengths, whose names have no unit.
const LENGTH_FACTS = /^(output_stroke|circuit_stroke|stroke|half_band|apart|output_start|longest_link|size|curve_length|curve_width_(min|max)|straight_length|deviation|target_length|stride|step_height|stray_between_points)$/;

// Shares of a segment's length to which it is straight, as names end.
const STRAIGHTNESS = { _at_0_001: "fact.to_0_001", _at_0_01: "fact.to_0_01" };

// A fact's name without its unit, and whether it says where something is reached: "torque_N_m.max"
// and "torque_N_m.max_at_deg" are of one "torque.max"; so is "torque_N_m.max_unbounded_at_deg", which
// says that there is none.
export function factParts(name) {
  const [share = ""] = /_at_0_0*1$/.exec(name) ?? [];
  if (share) {
    const parts = factParts(name.slice(0, -share.length));
    return { ...parts, key: parts.key + share };
  }
  const where = /_at(_deg)?(?=\.|$)/.test(name);
  const bare = name.replace(/_at(_deg)?(?=\.|$)/, "");
  const [, unit = LENGTH_FACTS.test(bare) ? "length" : ""] = /_(N_m|N|deg)(?=\.|$)/.exec(bare) ?? [];
  const placed = name.includes("_at_deg") ? "deg" : "";
  return { key: bare.replace(/_(N_m|N|deg|unbounded)(?=\.|$)/g, ""), unit: where ? placed : unit, where, unbounded: /_unbounded_at/.test(name) };
}

// The force of a joint on a body, "A_on_crank"; nothing of other names.
function onBody(name) {
  const [, first, second] = /^(.+)_on_(.+)$/.exec(name) ?? [];
  return first && say("fact.on", { first: term(first.replaceAll("_", " ")), second: term(second.replaceAll("_", " ")) });
}

export function factName(key) {
  const [of, what] = key.split(/\.(.*)/);
  const words = (text) => {
    const [share] = /_at_0_0*1$/.exec(text) ?? [];
    if (share in STRAIGHTNESS) return say(STRAIGHTNESS[share], { name: words(text.slice(0, -share.length)) });
    return term(text.replaceAll("_", " "));
  };
  const joint = /^transmission_(?!angle)([^.]+)_min$/.exec(key)?.[1];
  if (joint) return say("fact.transmission_at", { joint });
  if (!what) return sentence(words(of));
  if (what === "acute_min") return sentence(say("fact.least_acute", { of: words(of) }));
  const largest = /^(.*)_max$/.exec(of);
  return largest ? say("fact.largest_of", { of: words(largest[1]), what: onBody(what) ?? words(what) })
    : say("fact.of", { of: sentence(words(of)), what: FACT_WORDS[what] ?? words(what) });
}

// The unit that the end of a fact's name stands for.
export const unitWord = (unit) => FACT_WORDS[unit] ?? "";

export function factText(value, unit) {
  if (value === null) return "–";
  if (typeof value === "boolean") return say(value ? "yes" : "no");
  if (Number.isInteger(value) && !unit) return value.toLocaleString(language).replace("-", "−");
  if (typeof value !== "number") return keyword(String(value)) ?? sentenceOf(String(value).replaceAll("_", " "));
  // Of an angle less than this is left by rounding.
  return unit === "deg" ? degreesShort(Math.abs(value) < NO_ANGLE ? 0 : value, 6) : `${number(value, 6)} ${FACT_WORDS[unit] ?? ""}`.trim();
}

// A length with its unit, which stays with it where a line ends.
export const lengthText = (value, digits) => (LENGTH_UNIT ? `${number(value, digits)}\u00a0${LENGTH_UNIT}` : number(value, digits));

// A sum of squares of lengths, or of angles.
export const squaresText = (value, digits, angular) => `${number(value, digits)}${angular ? "\u00a0rad²" : LENGTH_UNIT ? `\u00a0${LENGTH_UNIT}²` : ""}`;

// Curves that share n points at one place have contact of order n − 1.
const contactText = (points) => say("fact.contact", { order: points - 1, points });

// The facts by their names, each with the place where it holds.
export function factRows(facts) {
  const rows = new Map();
  for (const { name, value } of facts) {
    const { key, unit, where, unbounded } = factParts(name);
    const row = rows.get(key) ?? (unbounded ? { text: say("fact.unbounded") } : {});
    rows.set(key, where ? { ...row, place: factText(value, unit) } : { ...row, text: key === "contact_points" ? contactText(value) : factText(value, unit), exact: value });
  }
  return rows;
}
