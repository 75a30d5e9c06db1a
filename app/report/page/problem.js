// The card "Problem": the problem in words, and the file itself.

import { byId, element, fact } from "./dom.js";
import { number, sentence } from "./format.js";
import { problemToml } from "./toml.js";
import { LENGTH_UNIT, keyword, language, say } from "./words.js";

// Of a file these are described elsewhere: its head, and how the answer is found and shown.
const SHOWN_ELSEWHERE = ["kind", "title", "length_unit", "solve", "output", "warnings"];

// What of `solve` says which design is best.
const AIMS = ["objectives", "robust"];

// The units of what is neither a length nor an angle.
const UNITS_OF_KEYS = {
  mass: "kg", mass_per_length: say("unit.mass_by_length"), force: "N", torque: "N·m", stall_torque: "N·m", inertia: "kg·m²", gravity: say("unit.acceleration"),
  speed: "rad/s", no_load_speed: "rad/s", start_speed: "rad/s", speed_end: "rad/s", time_max: "s", elasticity: say("unit.stress"),
  "drive.acceleration": "rad/s²", "sliding_drive.speed": say("unit.speed"), "sliding_drive.acceleration": say("unit.acceleration"),
  torque_max: "N·m", contact_force_max: "N", contact_stress_max: say("unit.stress"),
  ...limitUnits(),
};

// Of the limits over the cycle, as the program has them: "torque_ripple_max=N m;…".
function limitUnits() {
  const { limitUnits: listed = "" } = document.documentElement.dataset;
  return Object.fromEntries([...listed.matchAll(/(\w+)=([^;]+)/g)].map(([, key, unit]) => [key, unit.replace(" ", "·").replace("m2", "m²")]));
}

// Pairs of numbers under these keys, and all in these tables, are intervals; under those they are vectors.
const INTERVALS = /^(domain|.*_range(_deg)?|when|stroke|over_deg)$/;
const OF_INTERVALS = ["bounds", "constraints"];
const VECTORS = ["force", "centre", "gravity", "at", "pivot", "pivot_a", "pivot_d", "coupler_point", "through"];

// What the two numbers of such a pair are called, where they are no coordinates of the plane.
const PAIR_NAMES = { coupler_point: ["u", "v"], teeth: [say("gear.pinion"), say("gear.wheel")] };

const FEW = 4;     // entries of a list that are shown
const DIGITS = 7;
const LONG = 120;  // characters of a text, likewise

const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
const isNumberPair = (value) => Array.isArray(value) && value.length === 2 && value.every((part) => typeof part === "number");
const isEmpty = (value) => value === null || (Array.isArray(value) && value.length === 0) || (isTable(value) && Object.keys(value).length === 0);

// Zeros, and weights that are all alike, are what is meant where nothing is given.
const isUsual = (value, key) => value === 0 || (Array.isArray(value) && value.every((part) => part === (key === "weights" ? 1 : 0)));

// A key of the table `scope` in words, "torque_ripple_max" as "maximum torque ripple".
export function keyName(key, scope) {
  const bare = key.replace(/_deg(?=_|$)/, "");
  const [, of, end] = /^(.+)_(max|min)$/.exec(bare) ?? [];
  const words = (of ?? bare).replaceAll("_", " ");
  return keyword(`${scope}.${key}`) ?? keyword(key) ?? (of ? say(`problem.${end}`, { of: words }) : words);
}

export function unitOfKey(key, scope) {
  const unit = UNITS_OF_KEYS[`${scope}.${key}`] ?? UNITS_OF_KEYS[key];
  return /_deg(_|$)/.test(key) ? "°" : unit ? ` ${unit}` : "";
}

// The drive of a slider has a place in the place of an angle.
const scopeOf = (name, table) => (name === "drive" && "end" in table ? "sliding_drive" : name);

// Under these keys stand names that the file gives, which may be words by chance.
const GIVEN_NAMES = /^(name|carrier|member|gears|fixed|holds|joins|engaged)$/;

// A word of files in the reader's language; expressions and names as they are written.
function wordText(text, key) {
  const known = GIVEN_NAMES.test(key) ? undefined : keyword(`${key}.${text}`) ?? keyword(text);
  if (known) return known;
  if (language === "en" && /^[a-z]+([-_][a-z]+)*$/.test(text)) return text.replaceAll("_", " ");
  return element("code", {}, text.length > LONG ? `${text.slice(0, LONG)}…` : text);
}

// `value` under `key` of the table `scope` as a list of texts and elements.
function valueParts(value, key, scope) {
  const inBounds = OF_INTERVALS.includes(scope), unit = unitOfKey(key, scope);
  if (typeof value === "boolean") return [say(value ? "yes" : "no")];
  if (typeof value === "number") return [number(value, DIGITS) + unit];
  if (typeof value === "string") return [wordText(value, key)];
  if (isTable(value) && ("min" in value || "max" in value)) return [rangeText(value, unit)];
  if (isTable(value)) return tableParts(value, scopeOf(key, value));
  if (isNumberPair(value) && (inBounds || INTERVALS.test(key))) return [intervalText(value, unit)];
  if (inBounds && value.length === 2 && value.every(isNumberPair)) {
    if (!isBox(value)) return joinedParts(value.map((range) => valueParts(range, key, scope)), say("list.comma"));
    return [(PAIR_NAMES[key] ?? ["x", "y"]).map((axis, i) => `${axis}\u00a0${intervalText([value[0][i], value[1][i]])}`).join(say("list.comma"))];
  }
  return [...(isNumberPair(value) && VECTORS.includes(key) ? bracketed(value) : listParts(value, key)), unit];
}

// Whether two pairs are corners: of a place; two ranges of lengths would make a box without an extent.
const isBox = ([low, high]) => low.every((x, i) => x <= high[i]) && low.some((x, i) => x < high[i]);

// The problem, the bounds of the links of `dyads` under their names.
export function withNamedLinks(problem, dyads) {
  if (!problem?.bounds) return problem;
  const links = new Map(dyads.filter(({ names }) => names).map(({ new: made, names }) => [made, names]));
  const bounds = Object.entries(problem.bounds).flatMap(([name, bound]) => (links.has(name) && Array.isArray(bound?.[0])
    ? bound.map((range, i) => [links.get(name)[i], range]) : [[name, bound]]));
  return { ...problem, bounds: Object.fromEntries(bounds) };
}

// One that no line's end parts.
const intervalText = ([from, to], unit = "") => `${number(from, DIGITS)}\u00a0…\u00a0${number(to, DIGITS)}${unit.replace(" ", "\u00a0")}`;

const rangeText = ({ min, max }, unit) => (max === undefined || max === null ? say("range.at_least", { value: number(min, DIGITS) + unit })
  : say("range.at_most", { value: number(max, DIGITS) + unit }));

const bracketed = (list) => [`(${list.map((part) => number(part, DIGITS)).join(", ")})`];

// The first entries of a list; what is a list or a table itself stands in brackets.
function listParts(list, key) {
  const shown = list.length > FEW + 1 ? list.slice(0, FEW) : list;
  const parts = shown.map((part) => {
    if (typeof part === "number") return [number(part, DIGITS)];
    if (Array.isArray(part) && part.every((one) => typeof one === "number")) return bracketed(part);
    if (Array.isArray(part)) return ["(", ...listParts(part, key), ")"];
    return isTable(part) ? ["(", ...entryParts(Object.entries(part), key), ")"] : valueParts(part, key, "");
  });
  const all = joinedParts(parts, say("list.comma"));
  return shown.length < list.length ? [...all, ` … (${list.length})`] : all;
}

const joinedParts = (lists, between) => lists.flatMap((parts, i) => (i === 0 ? parts : [between, ...parts]));

// "domain 0 … 1; samples 20"
const entryParts = (entries, scope) => joinedParts(entries.map(([key, value]) =>
  (value === true ? [keyName(key, scope)] : [`${keyName(key, scope)} `, ...valueParts(value, key, scope)])), say("list.semicolon"));

// The entries of a table that say something.
const tableParts = (table, scope) => entryParts(Object.entries(table).filter(([key, value]) => !isEmpty(value) && !isUsual(value, key)), scope);

// A row of the card for each table, and for each of a list of tables.
function rowsOf([name, value]) {
  if (isEmpty(value) || isUsual(value, name)) return [];
  const heading = sentence(keyName(name, ""));
  const rows = Array.isArray(value) && value.every(isTable) ? value.map((part, i) => [value.length > 1 ? `${heading} ${i + 1}` : heading, tableParts(part, name)])
    : [[heading, valueParts(value, name, name)]];
  return rows.filter(([, parts]) => parts.length);
}

// `kind`: what the page calls the kind; `shown`: the problem under the names that its designs have.
export function showProblem(problem, kind, shown = problem) {
  byId("problem").hidden = !problem?.kind;
  if (!problem?.kind) return;
  const described = Object.entries(shown).filter(([key]) => !SHOWN_ELSEWHERE.includes(key)).flatMap(rowsOf);
  const aims = AIMS.filter((key) => !isEmpty(problem.solve?.[key] ?? null)).map((key) => [sentence(keyName(key, "")), valueParts(problem.solve[key], key, "solve")]);
  const unit = LENGTH_UNIT ? [[say("dimensions.lengths_in"), [LENGTH_UNIT]]] : [];
  byId("problem-list").replaceChildren(...[[say("problem.kind"), [kind]], ...unit, ...described, ...aims].flatMap(([name, parts]) => {
    const [dt, dd] = fact(name, "");
    dd.append(...parts);
    return [dt, dd];
  }));
  byId("problem-file").textContent = problemToml(problem);
  document.querySelector("#main > .side")?.after(byId("problem"));
}
