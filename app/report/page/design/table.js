// The table of designs. Each row has a radio button, so that arrow keys go from design to design.

import { markOf } from "../checks.js";
import { byId, element } from "../dom.js";
import { degreesShort, fixed, number } from "../format.js";
import { squaresText } from "../fact_text.js";
import { isNoError, sizeOf } from "../rounding.js";
import { keyword, LENGTH_UNIT, say, sentenceOf, term } from "../words.js";

// The largest error: of an angle in degrees, of a slider as a length.
const largestText = (error, digits) => (error.max_deg === undefined ? `${number(error.max, digits)} ${LENGTH_UNIT ?? ""}`.trim() : degreesShort(error.max_deg, digits));

// Whether nothing but rounding parts a design from its targets; an edited one may not reach them, and has no error.
export const isExact = ({ error, mechanism }) => Boolean(error) && (error.max_deg === undefined ? isNoError(error.max, sizeOf(mechanism)) : isNoError(error.max_deg, 180 / Math.PI));

const unlessExact = (show) => (entry) => (isExact(entry) ? say("rounding.exact_short") : show(entry));

// What errors are called where designs are of one kind of problem; none where it has no targets.
export const ERRORS = {
  function: { name: say("designs.largest_error"), text: ({ error }) => largestText(error, 4) },
  dwell: { name: say("designs.half_band"), text: ({ error }) => largestText(error, 4) },
  leg: { name: say("designs.flatness"), text: ({ metrics }) => number(metrics.flatness, 3), value: ({ metrics }) => metrics.flatness },
  path: { name: say("designs.sum_of_squares"), text: ({ error }) => squaresText(error.sum_of_squares, 5), value: ({ error }) => error.sum_of_squares },
  motion: { name: say("designs.largest_error"), text: ({ error }) => number(error.max, 3) },
};

export const straightLength = ({ metrics }) => number(metrics.straight_length_at_0_001, 5);
// Searched designs have one stretch, with its own deviation.
const SEARCHED = [
  { name: say("designs.straight"), title: say("designs.straight_searched_title"), text: ({ metrics }) => number(metrics.straight_length, 5), kind: "number" },
  { name: say("designs.deviation"), title: say("designs.deviation_title"), text: ({ metrics }) => number(metrics.deviation_relative, 3), kind: "number" },
  { name: say("designs.size"), title: say("designs.size_title"), text: ({ metrics }) => number(metrics.size_over_length, 3), kind: "number wide" },
];
export const isSearched = ({ metrics }) => metrics.straight_length !== undefined;
const STRAIGHT = { name: say("designs.straight"), title: say("designs.straight_title"), text: straightLength };

export const isFourBar = (d) => d.mechanism.type === "four-bar";

// Class of a four-bar; of another mechanism its topology or its type.
const classText = (d) => sentenceOf(isFourBar(d) ? d.metrics.class ?? "–" : keyword(d.metrics.topology) ?? d.metrics.topology ?? d.mechanism.type);

function designColumns(kind, entries) {
  const first = kind === "straight-line" ? STRAIGHT : ERRORS[kind];
  const searched = kind === "straight-line" && entries.some(isSearched);
  return [
    ...(searched ? SEARCHED : first ? [{ ...first, ...(ERRORS[kind] ? { text: unlessExact(first.text), sort: first.value ?? (({ error }) => error.max_deg ?? error.max) } : {}), kind: "number" }] : []),
    { name: say(entries.every(isFourBar) ? "designs.class" : "designs.type"), text: classText, kind: "class" },
    { name: say("designs.transmission"), text: (d) => transmissionText(d), kind: "number" },
    { name: "K", title: say("designs.time_ratio"), text: (d) => number(d.metrics.time_ratio, 4), kind: "number wide" },
    { name: say("designs.sound"), title: say("designs.sound_title"), mark: (d) => faults(d), kind: "sound" },
  ];
}

const transmissionText = ({ metrics: { transmission_angle_deg: t } }) => (t && t.max > 0 ? `${fixed(t.min, 0)}–${fixed(t.max, 0)}°` : "–");
const missed = (d) => (d.constraints ?? []).filter((c) => !c.satisfied);

export function originText(d) {
  const of = (index, words) => (index === undefined || index === null ? [] : [say(words, { n: index + 1 })]);
  return [(d.origin ?? "").split(" + ").map(sentenceOf).join(" + "), ...of(d.cognate_of, "origin.cognate_of"), ...of(d.mirror_of, "origin.mirror_of"), ...of(d.twin_of, "origin.twin_of"),
    ...(d.differs?.length ? [say("origin.differs", { list: d.differs.map(term).join(say("list.comma")) })] : [])].join(say("list.semicolon"));
}

// What is wrong with a design: its defects and the count of other constraints missed; empty for a
// sound one.
function faults(d) {
  const defects = d.metrics.defects ?? [];
  const checks = missed(d).filter((c) => !/^no_.*_defect$/.test(c.name)).length;
  return [...defects.map(term), ...(checks ? [say("designs.missed", { n: checks })] : [])].join(say("list.comma"));
}

const warningMark = ({ warnings = [] }) => (warnings.length ? [" ", element("span", { class: "mark warn-mark", title: warnings.map(sentenceOf).join("\n") }, "⚠")] : []);

export class DesignTable {
  constructor(designs, kind, onChoose) {
    const columns = designColumns(kind, designs.map((design) => design.entry));
    const head = element("tr", {}, element("th", { scope: "col" }, say("designs.design")),
      ...columns.map((c) => element("th", { scope: "col", class: c.kind ?? "", ...(c.title ? { title: c.title } : {}) }, c.name)));
    const table = byId("designs");
    table.classList.toggle("many", columns.length > 5);
    table.tHead.replaceChildren(head);
    this.rows = designs.map((design, i) => this.#row(design.entry, i, columns, onChoose));
    table.append(...this.rows);
  }

  #row(entry, index, columns, onChoose) {
    const radio = element("input", { type: "radio", name: "design", id: `design-${index}`, value: index });
    radio.addEventListener("change", () => onChoose(index));
    const cells = columns.map((c) => element("td", { class: c.kind ?? "", ...(c.sort ? { "data-sort": c.sort(entry) } : {}) },
      ...(c.mark ? [markOf(c.mark(entry)), ...warningMark(entry)] : [c.text(entry)])));
    const number = element("td", { rowspan: 2 }, element("label", { for: radio.id }, radio, String(index + 1)));
    const row = element("tbody", {}, element("tr", { class: "main" }, number, ...cells),
      element("tr", {}, element("td", { class: "origin", colspan: columns.length }, originText(entry))));
    row.addEventListener("click", (event) => {
      if (event.target.closest("label, input")) return;
      radio.focus({ preventScroll: true });
      onChoose(index);
    });
    return row;
  }

  choose(index) {
    this.rows.forEach((row, i) => {
      row.classList.toggle("chosen", i === index);
      row.querySelector("input").checked = i === index;
    });
    const frame = byId("designs-frame");
    const row = this.rows[index];
    const head = frame.querySelector("thead").offsetHeight;
    if (row.offsetTop < frame.scrollTop + head) frame.scrollTop = row.offsetTop - head;
    else if (row.offsetTop + row.offsetHeight > frame.scrollTop + frame.clientHeight) frame.scrollTop = row.offsetTop + row.offsetHeight - frame.clientHeight;
  }
}
