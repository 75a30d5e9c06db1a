// Metrics of a design and its constraints, as all designs but those of studies have them.

import { byId, element, fact } from "./dom.js";
import { factText } from "./fact_text.js";
import { degreesShort, number, sentence } from "./format.js";
import { keyName, unitOfKey } from "./problem.js";
import { keyword, LENGTH_UNIT, say, term } from "./words.js";

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

const CHECK_DIGITS = 6;
// Tables whose numbers are lengths, but for their angles.
const LENGTH_TABLES = /^(bounds|mechanism|pivot_region|clearance)\b/;

// What stands behind a constraint's numbers: as its row says it, else by its key.
function checkUnit({ name, unit }) {
  if (unit !== undefined) return unit === "deg" ? "°" : unit === "" ? "" : ` ${unit === "length" ? LENGTH_UNIT ?? "" : unit}`.trimEnd();
  const key = name.split(".").at(-1);
  return unitOfKey(key, "constraints") || (LENGTH_TABLES.test(name) && LENGTH_UNIT ? ` ${LENGTH_UNIT}` : "");
}

// The key of a constraint in words: "Bound of the crank", "Crank, given", "Minimum curvature radius".
export function checkName({ name, label }) {
  if (label !== undefined) return sentence(term(label));
  const [, table, key] = /^(bounds|mechanism|pivot_region)\.(.+)$/.exec(name) ?? [];
  if (table === "pivot_region") return sentence(say("constraints.in_region", { of: keyName(key, "") }));
  if (table) return sentence(say(`constraints.of_${table}`, { of: keyName(key.replace(/\.[xyuv]$/, ""), "") + (/\.([xyuv])$/.exec(key)?.[0].replace(".", " ") ?? "") }));
  const [, of, index] = /^(.+)\[(\d+)\]$/.exec(name) ?? [];
  return sentence(index ? `${keyName(of, "constraints")} ${index}` : keyName(name, "constraints"));
}

const numbered = (value, unit) => (typeof value === "number" ? number(value, CHECK_DIGITS) + unit : String(value).split(", ").map((word) => keyword(word) ?? term(word)).join(say("list.comma")));

export const checkValue = (check) => (check.value === null || check.value === undefined ? "–" : Array.isArray(check.value) || typeof check.value === "object" ? limitText(check.value, checkUnit(check)) : numbered(check.value, checkUnit(check)));

function limitText(bound, unit) {
  const [min, max] = Array.isArray(bound) ? bound : [bound.min, bound.max];
  if (min === undefined || min === null) return `≤ ${numbered(max, unit)}`;
  return max === undefined || max === null ? `≥ ${numbered(min, unit)}` : `${number(min, CHECK_DIGITS)} … ${numbered(max, unit)}`;
}

// The side on which a single number limits: by the row, else by what its key ends in.
function relationOf({ name, relation }) {
  if (relation !== undefined) return relation;
  if (/^mechanism\./.test(name)) return "=";
  return /_min$|^clearance|^no_undercut$/.test(name) ? "≥" : "≤";
}

// A bound with its relation and its unit: "≥ 45°", "5 … 80 mm", "= crank-rocker".
export function checkBound(check) {
  const { bound } = check;
  if (bound === null || bound === undefined) return "–";
  if (bound === "none") return keyword("none") ?? term("none");
  if (typeof bound === "object") return limitText(bound, checkUnit(check));
  return `${typeof bound === "string" ? "=" : relationOf(check)} ${numbered(bound, checkUnit(check))}`;
}

export const headRow = (names) => element("tr", {}, ...names.map(([name, kind = ""]) => element("th", { scope: "col", class: kind }, name)));

export function showChecks(constraints) {
  document.querySelector(".checks thead").replaceChildren(headRow([[say("constraints.constraint")], [say("constraints.value"), "number"], [say("constraints.bound"), "number"], [say("constraints.met")]]));
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
