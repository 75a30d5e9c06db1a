// What is known of the design chosen, and of the run.

import { byId, element, fact } from "../dom.js";
import { factName, factRows, lengthText, squaresText } from "../fact_text.js";
import { degrees, degreesShort, duration, number, sentence } from "../format.js";
import { showHead } from "../head.js";
import { isOfComputation, showMore } from "../meaning.js";
import { errorText, sizeOf, tableWithoutRounding, withoutRounding } from "../rounding.js";
import { RADIANS } from "../sampling.js";
import { keyword, LENGTH_UNIT, knows, say, term } from "../words.js";
import { ofRaster } from "./raster.js";
import { ERRORS, isExact, isSearched, originText, straightLength } from "./table.js";

const units = (x, size) => element("span", { title: String(withoutRounding(x, size)) }, number(x, 7));
// What is less than this share of the mechanism is read as nothing.
const READ_SHARE = 1e-7;

const pointText = (point, size) => point.map((x) => number(Math.abs(x) < READ_SHARE * size ? 0 : x, 6)).join(", ");

// `pinned`: a design whose values stand beside those of the one shown, or null.
export function showDimensions(design, pinned = null) {
  byId("dimensions-list").replaceChildren(...beside(dimensionRows(design), pinned && dimensionRows(pinned)), ...fact(say("dimensions.lengths_in"), LENGTH_UNIT ?? say("dimensions.units")));
}

const dimensionRows = ({ entry: { mechanism } }) => (mechanism.type === "four-bar" ? linkageRows(mechanism) : mechanismRows(tableWithoutRounding(mechanism)));

// Pairs of a list, each with the value that another list has under its name where that is another one.
function beside(pairs, others) {
  if (!others) return pairs;
  const known = new Map(Array.from({ length: others.length / 2 }, (_, i) => [others[2 * i].textContent, others[2 * i + 1].textContent]));
  for (let i = 0; i < pairs.length; i += 2) {
    const other = known.get(pairs[i].textContent);
    if (other !== undefined && other !== pairs[i + 1].textContent) pairs[i + 1].prepend(element("span", { class: "beside" }, other));
  }
  return pairs;
}

function linkageRows(m) {
  const size = sizeOf(m);
  const exactly = (point) => point.map((x) => withoutRounding(x, size)).join(", ");
  const [a, d] = m.fixed_pivots;
  const [dx, dy] = [d[0] - a[0], d[1] - a[1]];
  return [
    ...fact(say("dimensions.crank"), units(m.crank, size)), ...fact(say("dimensions.coupler"), units(m.coupler, size)), ...fact(say("dimensions.rocker"), units(m.rocker, size)),
    ...fact(say("dimensions.frame"), units(Math.hypot(dx, dy), size)), ...fact(say("dimensions.frame_angle"), degreesShort(Math.atan2(dy, dx) / RADIANS, 7)),
    ...fact(say("dimensions.pivot", { name: "A" }), pointText(a, size), exactly(a)), ...fact(say("dimensions.pivot", { name: "D" }), pointText(d, size), exactly(d)),
    ...(m.coupler_point ? fact(say("dimensions.coupler_point"), pointText(m.coupler_point, size), exactly(m.coupler_point)) : []),
    ...fact(say("dimensions.assembly"), term(m.assembly))];
}

// The table of any other mechanism, key by key.
function mechanismRows({ type, ...table }) {
  const size = sizeOf(table);
  const rows = Object.entries(table).flatMap(([key, value]) => {
    if (type === "chain" && CHAIN_ROWS[key]) return [value].flat().flatMap((part) => CHAIN_ROWS[key](part, size));
    if (key === "fixed_pivots") return value.flatMap((pivot, i) => fact(say("dimensions.pivot", { name: "AD"[i] }), pointText(pivot, size), pivot.join(", ")));
    const parts = Array.isArray(value) && value.every((part) => typeof part === "object" && !Array.isArray(part)) ? value : [value];
    return parts.flatMap((part) => fact(factName(key.replace(/_deg$/, "")), partText(part, key), JSON.stringify(part)));
  });
  return [...fact(say("dimensions.mechanism"), sentence(term(type))), ...rows];
}

// A length between two joints, of a link that its file may have named otherwise than by these.
function linkRow(name, from, to, length) {
  const label = name === from + to ? say("dimensions.link", { from, to }) : say("dimensions.named_link", { name: sentence(term(name)), from, to });
  return fact(label, number(length, 7), String(length));
}

const partRow = (label, part, key = "") => fact(label, partText(part, key), JSON.stringify(part));

// The links of a group by the distances between their joints.
function groupRows({ names, joint }) {
  return names.flatMap((name) => {
    const on = joint.filter(({ of }) => of.includes(name)).map(({ name: pin, of, at }) => ({ pin, at: at[of.indexOf(name)] }));
    const pairs = on.flatMap((from, i) => on.slice(i + 1).map((to) => [from, to]));
    return pairs.flatMap(([from, to]) => linkRow(name, from.pin, to.pin, Math.hypot(to.at[0] - from.at[0], to.at[1] - from.at[1])));
  });
}

// The links of a dyad by their lengths, its slides, and in which of two ways it is put together.
function dyadRows({ type, joins, lengths = [], assembly, new: made, names, ...slides }) {
  if (type === "group") return groupRows({ names, ...slides });
  const ends = [[joins[0], made], [made, joins[1]]];
  const links = made ? lengths.flatMap((length, i) => linkRow(names[i], ...ends[i], length)) : [];
  const rest = { ...(made ? {} : { joins, ...(lengths.length ? { lengths } : {}) }), ...slides };
  return [...links, ...(Object.keys(rest).length ? partRow(sentence(names.slice(lengths.length ? -1 : 0).map(term).join(say("list.comma"))), rest) : []),
    ...fact(say("dimensions.assembly_at", { name: made ?? joins.join("–") }), term(assembly))];
}

// The parts of a chain, each in a row of its own name; `size`: its largest length.
const CHAIN_ROWS = {
  pivot: ({ name, at }, size) => fact(say("dimensions.pivot", { name }), pointText(at, size), at.join(", ")),
  crank: ({ at, pin, length, name }) => linkRow(name, at, pin, length),
  dyad: dyadRows,
  point: ({ name, on, at }, size) => fact(say("dimensions.point", { name, on: [on].flat().map(term).join("–") }), pointText(at, size), at.join(", ")),
};

// A value of a mechanism's table in words.
function partText(value, key) {
  if (typeof value === "number") return key.endsWith("_deg") ? degreesShort(value, 7) : number(value, 7);
  if (Array.isArray(value)) return value.map((part) => partText(part, "")).join(", ");
  if (typeof value !== "object" || value === null) return term(String(value));
  return Object.entries(value).map(([name, part]) => `${keyword(name) ?? term(name.replace(/_deg$/, "").replaceAll("_", " "))} ${partText(part, name)}`).join(say("list.semicolon"));
}

// Metrics with their levels joined by dots, as `cognate list --metrics` names them.
export function flatMetrics(table, above = "") {
  return Object.entries(table).flatMap(([key, value]) =>
    (value !== null && typeof value === "object" && !Array.isArray(value) ? flatMetrics(value, `${above}${key}.`) : [[above + key, value]]));
}

// Metrics that have a row of their own; all others are listed by their names.
const SHOWN_METRICS = /^(tolerance_.*|layers\..*|class|change_point|transmission_angle_deg\..*|time_ratio|defects|input_start_deg|output_start_deg|precision_residual|condition)$/;

function otherMetrics(metrics) {
  const facts = flatMetrics(metrics).filter(([name]) => !SHOWN_METRICS.test(name)).map(([name, value]) => ({ name, value }));
  return factPairs(facts);
}

const factPairs = (facts) => [...factRows(facts)].flatMap(([key, { text = "", place, exact }]) =>
  fact(factName(key), place ? say("fact.at", { value: text, place }).trim() : text, typeof exact === "number" ? String(exact) : undefined));

function errorRows({ error, mechanism }, kind) {
  if (!ERRORS[kind]) return [];
  if (!error) return fact(say("qualities.largest"), say("edit.unmet"));
  if (isExact({ error, mechanism })) return fact(say("qualities.largest"), say("rounding.exact"), String(error.max_deg ?? error.max));
  const angular = error.max_deg !== undefined;
  const length = (value) => lengthText(value, 6);
  return [
    ...fact(say("qualities.largest"), angular ? degreesShort(error.max_deg) : length(error.max), String(angular ? error.max_deg : error.max)),
    ...fact(say("qualities.rms"), angular ? degreesShort(error.rms_deg) : length(error.rms), String(angular ? error.rms_deg : error.rms)),
    ...fact(say("designs.sum_of_squares"), squaresText(error.sum_of_squares, 7, angular), String(error.sum_of_squares))];
}

export function showQualities(design, kind, pinned = null) {
  byId("qualities-list").replaceChildren(...beside(qualityRows(design, kind), pinned && qualityRows(pinned, kind)));
  const { entry, entry: { metrics } } = design;
  showMore(byId("qualities"), [...computed("precision_residual", say("qualities.residual"), metrics, (v) => errorText(v, 1, (x) => number(x, 3))),
    ...computed("condition", say("qualities.condition"), metrics, (v) => number(v, 3)), ["found_by", say("qualities.found_by"), originText(entry)]]);
}

function qualityRows({ entry, transmissionOfPart }, kind) {
  const { metrics } = entry;
  const t = metrics.transmission_angle_deg?.max > 0 ? metrics.transmission_angle_deg : null;
  const optional = (name, value, text) => (value === undefined || value === null ? [] : fact(name, text(value)));
  return [...errorRows(entry, kind),
    ...optional(say("designs.class"), metrics.class, (name) => (metrics.change_point ? say("qualities.change_point", { name: term(name) }) : term(name))),
    ...(t ? [...fact(say(transmissionOfPart ? "qualities.transmission_used" : "qualities.transmission"), say("range.to", { from: degrees(t.min), to: degrees(t.max) })), ...fact(say("qualities.least_acute"), degrees(t.acute_min))] : []),
    ...optional(say("designs.time_ratio"), metrics.time_ratio, (v) => number(v, 6)),
    ...fact(say("qualities.defects"), metrics.defects?.length ? metrics.defects.map(term).join(say("list.comma")) : say("qualities.no_defects")),
    ...optional(say("qualities.input_start"), metrics.input_start_deg, (v) => degreesShort(v, 8)),
    ...optional(say("qualities.output_start"), metrics.output_start_deg, (v) => degreesShort(v, 8)),
    ...otherMetrics(metrics)];
}

const computed = (key, name, metrics, show) => (metrics[key] === undefined || metrics[key] === null ? [] : [[key, name, show(metrics[key]), metrics[key]]]);

// Facts of the synthesis as a whole.
export function showFindings(facts) {
  const all = flatMetrics(facts ?? {}).filter(([name]) => !ofRaster(name)).map(([name, value]) => ({ name, value }));
  const pairs = factPairs(all.filter(({ name }) => !isOfComputation(name)));
  const rows = all.filter(({ name }) => isOfComputation(name)).map(({ name, value }) => [name, factName(name), typeof value === "number" ? number(value, 4) : String(value), value]);
  byId("findings").hidden = all.length === 0;
  showMore(byId("findings"), rows);
  byId("problem").after(byId("findings"));
  byId("findings-list").replaceChildren(...Array.from({ length: pairs.length / 2 }, (_, i) => element("div", {}, pairs[2 * i], pairs[2 * i + 1])));
}

// What is to be known first of the best design.
function bestText(best, kind) {
  if (!best) return "";
  if (kind === "straight-line" && isSearched(best)) {
    return say("best.straight_searched", { deviation: number(best.metrics.deviation_relative, 3), length: number(best.metrics.straight_length, 4) });
  }
  if (kind === "straight-line") return say("best.straight", { length: straightLength(best) });
  if (ERRORS[kind] && isExact(best)) return say("best.exact");
  return ERRORS[kind] ? say(`best.${kind}`, { value: ERRORS[kind].text(best) }) : "";
}

export function showDesignHead(result, kind) {
  const { problem, designs, work } = result;
  showHead(result, knows(`kind.${problem?.kind}`) ? say(`kind.${problem.kind}`) : problem?.kind ?? "",
    [say("count.designs", { n: designs.length }), bestText(designs[0], kind), work ? duration(work.seconds) : ""],
    say("head.keys_crank"));
}
