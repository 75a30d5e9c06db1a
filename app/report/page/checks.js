// Metrics of a design and its constraints, as all designs but those of studies have them.

import { breakable, byId, element, fact } from "./dom.js";
import { factText } from "./fact_text.js";
import { degreesShort, number, sentence } from "./format.js";
import { say, term } from "./words.js";

// A metric's name in words: "Maximum pressure angle in the return" of "pressure_angle_deg_max_return".
export function metricName(name) {
  const words = (text) => term(text.replace(/_deg(?=_|$)/, "").replaceAll("_", " "));
  const [, of, side, stroke, working = ""] = /^(.*)_(min|max)(?:_(rise|return)(_working)?)?$/.exec(name) ?? [];
  return side ? say(`metric.${side}${stroke ? `_${stroke}${working}` : ""}`, { of: words(of) }) : sentence(words(name));
}

export function showMetrics(metrics) {
  const places = new Map(metrics.filter(({ name }) => name.endsWith("_at_deg")).map(({ name, value }) => [name.replace(/_at_deg$/, ""), value]));
  const rows = metrics.filter(({ name }) => !name.endsWith("_at_deg")).flatMap(({ name, value }) => {
    const text = factText(value, /_deg(?=_|$)/.test(name) ? "deg" : "");
    return fact(metricName(name), places.has(name) ? say("fact.at", { value: text, place: degreesShort(places.get(name), 5) }) : text, typeof value === "number" ? String(value) : undefined);
  });
  byId("facts").hidden = rows.length === 0;
  byId("facts-list").replaceChildren(...rows);
}

export function boundOf(bound) {
  if (bound === null || bound === undefined) return "–";
  if (typeof bound === "number") return number(bound, 7);
  if (Array.isArray(bound)) return say("range.to", { from: number(bound[0], 7), to: number(bound[1], 7) });
  if (typeof bound === "object") return "min" in bound ? say("range.at_least", { value: number(bound.min, 7) }) : say("range.at_most", { value: number(bound.max, 7) });
  return String(bound).split(", ").map(term).join(say("list.comma"));
}

export const headRow = (names) => element("tr", {}, ...names.map(([name, kind = ""]) => element("th", { scope: "col", class: kind }, name)));

export function showChecks(constraints) {
  document.querySelector(".checks thead").replaceChildren(headRow([[say("constraints.constraint")], [say("constraints.value"), "number"], [say("constraints.bound"), "number"], [say("constraints.met")]]));
  byId("checks").replaceChildren(...[...constraints].sort((a, b) => a.satisfied - b.satisfied).map((check) =>
    element("tr", { class: check.satisfied ? "met" : "missed" }, element("td", {}, element("code", {}, ...breakable(check.name))),
      element("td", { class: "number" }, boundOf(check.value)), element("td", { class: "number" }, boundOf(check.bound)),
      element("td", {}, element("span", { class: `mark ${check.satisfied ? "yes" : "no"}` }, check.satisfied ? `✓ ${say("yes")}` : `✗ ${say("no")}`)))));
  const missed = constraints.filter((check) => !check.satisfied).length;
  byId("constraints-count").textContent = constraints.length === 0 ? say("constraints.none") : say(missed ? "constraints.missed" : "constraints.all_met", { missed, count: constraints.length });
}

// ✓, or ✗ and what is wrong.
export function markOf(text) {
  return element("span", { class: `mark ${text ? "no" : "yes"}`, title: text || say("yes") }, text ? "✗" : "✓",
    element("span", { class: "wide" }, text ? ` ${text}` : ""));
}
