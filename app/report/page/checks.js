// Metrics of a design and its constraints, as all designs but those of studies have them.

import { byId, element, fact } from "./dom.js";
import { factText } from "./fact_text.js";
import { degreesShort, number, sentence } from "./format.js";
import { keyword, LENGTH_UNIT, say, term } from "./words.js";

// A metric's name in words: "Maximum pressure angle in the return" of "pressure_angle_deg_max_return".
export function metricName(name) {
  const words = (text) => term(text.replace(/_deg(?=_|$)/, "").replaceAll("_", " "));
  const [, of, side, stroke, working = ""] = /^(.*)_(min|max)(?:_(rise|return)(_working)?)?$/.exec(name) ?? [];
  return side ? say(`metric.${side}${stroke ? `_${stroke}${working}` : ""}`, { of: words(of) }) : sentence(words(name));
}

const metricText = (name, value) => factText(value, /_deg(?=_|$)/.test(name) ? "deg" : "");

// Metrics of an edited design beside those it had, as the panel of edits shows them.
export function metricRows(before, now, nameOf = metricName) {
  const cell = (name, metrics) => {
    const { value = null } = metrics.find((metric) => metric.name === name) ?? {};
    return { value, text: metricText(name, value) };
  };
  return now.filter(({ name }) => !name.endsWith("_at_deg")).map(({ name }) => ({ key: name, label: nameOf(name), before: cell(name, before), now: cell(name, now) }));
}

// Constraints of an edited design, as the panel shows them.
export const checkRows = (constraints) => constraints.map((check) => [checkName(check), checkBound(check), checkValue(check), check.satisfied]);

export function showMetrics(metrics) {
  const places = new Map(metrics.filter(({ name }) => name.endsWith("_at_deg")).map(({ name, value }) => [name.replace(/_at_deg$/, ""), value]));
  const rows = metrics.filter(({ name }) => !name.endsWith("_at_deg")).flatMap(({ name, value }) => {
    const text = metricText(name, value);
    return fact(metricName(name), places.has(name) ? say("fact.at", { value: text, place: degreesShort(places.get(name), 5) }) : text, typeof value === "number" ? String(value) : undefined);
  });
  byId("facts").hidden = rows.length === 0;
  byId("facts-list").replaceChildren(...rows);
}

const CHECK_DIGITS = 6;
const UNIT_SIGNS = { "": "", deg: "°", length: LENGTH_UNIT ? ` ${LENGTH_UNIT}` : "", module: ` ${say("unit.module")}`, N: ` ${say("unit.force")}`, "N m": ` ${say("unit.torque")}`, "N/length2": ` ${say("unit.stress")}` };
const RELATIONS = { "<=": "≤ ", ">=": "≥ ", "=": "= ", in: "" };

const unitSign = (unit = "") => UNIT_SIGNS[unit] ?? ` ${unit}`;
const remarked = (label) => { const [, of, remark] = /^(.*) \((.*)\)$/.exec(label) ?? []; return of ? `${term(of)} (${term(remark)})` : term(label); };

// What a row of constraints is of.
export const checkName = ({ label, name }) => sentence(remarked(label ?? name));

// A number with its unit; words, which may be several, in the reader's language.
const numbered = (value, unit) => (typeof value === "number" ? number(value, CHECK_DIGITS) + unitSign(unit) : String(value).split(", ").map((word) => keyword(word) ?? term(word)).join(say("list.comma")));

export const checkValue = ({ value, unit }) => (value === null || value === undefined ? "–" : numbered(value, unit));

// A bound with its relation and its unit: "≥ 45°", "5 … 80 mm", "= crank-rocker".
export function checkBound({ bound, unit, relation = "=" }) {
  if (bound === null || bound === undefined) return "–";
  if (bound === "none") return numbered(bound);
  if (typeof bound !== "object") return RELATIONS[relation] + numbered(bound, unit);
  const [min, max] = Array.isArray(bound) ? bound : [bound.min, bound.max];
  if (min === undefined || min === null) return `≤ ${numbered(max, unit)}`;
  if (max === undefined || max === null) return `≥ ${numbered(min, unit)}`;
  return min === max ? RELATIONS["="] + numbered(max, unit) : `${number(min, CHECK_DIGITS)} … ${numbered(max, unit)}`;
}

export const headRow = (names) => element("tr", {}, ...names.map(([name, kind = ""]) => element("th", { scope: "col", class: kind }, name)));

export function showChecks(constraints) {
  document.querySelector("#constraints .checks thead").replaceChildren(headRow([[say("constraints.constraint")], [say("constraints.value"), "number"], [say("constraints.bound"), "number"], [say("constraints.met")]]));
  byId("checks").replaceChildren(...[...constraints].sort((a, b) => a.satisfied - b.satisfied).map((check) =>
    element("tr", { class: check.satisfied === false ? "missed" : "met" }, element("td", { title: check.name }, checkName(check)),
      element("td", { class: "number" }, checkValue(check)), element("td", { class: "number" }, checkBound(check)), element("td", {}, metMark(check)))));
  const missed = constraints.filter((check) => check.satisfied === false).length;
  byId("constraints-count").textContent = constraints.length === 0 ? say("constraints.none") : say(missed ? "constraints.missed" : "constraints.all_met", { missed, count: constraints.length });
}

// Whether it is met; of an edited design it may take a run of the program to know.
function metMark({ satisfied }) {
  if (satisfied === null) return element("span", { class: "muted" }, say("edit.program"));
  return element("span", { class: `mark ${satisfied ? "yes" : "no"}` }, satisfied ? `✓ ${say("yes")}` : `✗ ${say("no")}`);
}

// ✓, or ✗ and what is wrong.
export function markOf(text) {
  return element("span", { class: `mark ${text ? "no" : "yes"}`, title: text || say("yes") }, text ? "✗" : "✓",
    element("span", { class: "wide" }, text ? ` ${text}` : ""));
}
