// Designs that depend on one number: a plot of everything over it, with the design chosen.

import { Curves } from "../curves.js";
import { byId, element } from "../dom.js";
import { factName } from "../fact_text.js";
import { number, sentence } from "../format.js";
import { say, sentenceOf } from "../words.js";
import { locusColour } from "./backdrop.js";
import { flatMetrics } from "./facts.js";

const FAMILY_UNITS = { deg: "°", rad: "rad" };

// "least_transmission_deg", or "transmission_angle_deg.acute_min": its words and its unit.
function familyLabel(name) {
  const [, unit] = /_(deg|rad)(?=$|\.)/.exec(name) ?? [];
  const words = factName(name.replace(/_(deg|rad)(?=$|\.)/, ""));
  return unit ? say("unit.axis", { name: words, unit: FAMILY_UNITS[unit] }) : words;
}

// Every number that is known of a design, by its key: metrics with their levels, dimensions.
function numbersOf(entry) {
  const numbers = Object.fromEntries(Object.entries(entry.mechanism).filter(([, value]) => typeof value === "number"));
  const pivots = entry.mechanism.fixed_pivots;
  if (pivots) numbers.frame = Math.hypot(pivots[1][0] - pivots[0][0], pivots[1][1] - pivots[0][1]);
  for (const [key, value] of flatMetrics(entry.metrics)) if (typeof value === "number") numbers[key] = value;
  return numbers;
}

// Of a column's range, what a design of the family is off at most between two samples.
const OF_FAMILY = 0.02;

// The value of a family's parameter that a design has; null where it has none.
const parameterOf = (family, entry) => numbersOf(entry)[family.columns[0].name] ?? null;

// Whether a design lies on a family's curves where it has the parameter `at`: of several families it is of one.
function liesOn({ columns: [{ values: places }, ...columns] }, entry, at) {
  const numbers = numbersOf(entry);
  return columns.every(({ name, values }) => {
    const known = values.filter((value) => value !== null);
    if (numbers[name] === undefined || known.length < 2) return true;
    const room = OF_FAMILY * (Math.max(...known) - Math.min(...known)) + 1e-9;
    const within = (one, other) => numbers[name] >= Math.min(one, other) - room && numbers[name] <= Math.max(one, other) + room;
    return places.some((place, i) => i > 0 && (place - at) * (places[i - 1] - at) <= 0 && values[i] !== null && values[i - 1] !== null && within(values[i - 1], values[i]));
  });
}

// Steps this many times as long as most are leaps from one side of infinity to the other.
const LEAP = 50;

// The values of a column with a gap where they leap.
function withGaps(values) {
  const steps = values.slice(1).map((value, i) => (value === null || values[i] === null ? 0 : Math.abs(value - values[i])));
  const most = LEAP * [...steps].sort((p, q) => p - q)[Math.floor(steps.length / 2)];
  return values.map((value, i) => (i > 0 && steps[i - 1] > most && value * values[i - 1] < 0 ? null : value));
}

// A plot for each column over the first one. A family that goes to and fro in its parameter is
// drawn as points.
function familySheets(family) {
  const [parameter, ...columns] = family.columns;
  const order = parameter.values.map((_, i) => i).filter((i) => parameter.values[i] !== null);
  const steps = order.slice(1).map((i, k) => parameter.values[i] - parameter.values[order[k]]);
  const monotonic = steps.every((step) => step >= 0) || steps.every((step) => step <= 0);
  order.sort((i, j) => parameter.values[i] - parameter.values[j]);
  const x = order.map((i) => parameter.values[i]);
  if (x.length < 2) return [];
  const margin = 0.03 * (x.at(-1) - x[0]) || 1;
  const common = { x, xRange: [x[0] - margin, x.at(-1) + margin], xLabel: familyLabel(parameter.name), hover: false,
    marks: [], driveAt: (at) => at, xAt: () => null };
  return columns.map((column, i) => {
    const y = withGaps(order.map((k) => column.values[k]));
    const known = y.filter((v) => v !== null);
    const summary = known.length ? say("curves.range", { least: number(Math.min(...known), 5), greatest: number(Math.max(...known), 5) }) : say("curves.no_values");
    return { ...common, title: familyLabel(column.name), summary, note: sentence(summary), lines: [{ y, colour: locusColour(i), dots: !monotonic }] };
  });
}

// The card of families: chips choose among several.
export class Families {
  constructor(families, entries, onChoose) {
    Object.assign(this, { families: families.filter((family) => family.columns.length > 1), entries, onChoose });
    byId("families").hidden = this.families.length === 0;
    if (this.families.length === 0) return;
    this.curves = new Curves(byId("families-plots"), (at) => this.#pick(at));
    this.buttons = this.families.map((family, i) => {
      const button = element("button", { type: "button" }, sentence(sentenceOf(family.name)));
      button.addEventListener("click", () => this.show(i));
      return button;
    });
    byId("families-names").replaceChildren(...this.buttons);
    byId("families-names").hidden = this.families.length < 2;
    if (this.families.length === 1) byId("families-title").textContent = say("families.one", { name: sentenceOf(this.families[0].name) });
    this.show(0);
  }

  show(index) {
    this.family = this.families[index];
    this.buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === index)));
    const place = (entry) => {
      const at = parameterOf(this.family, entry);
      return at === null || this.families.length === 1 || liesOn(this.family, entry, at) ? at : null;
    };
    this.places = this.entries.map(place);
    byId("families-hint").hidden = this.places.every((place) => place === null);
    this.sheets = familySheets(this.family);
    this.curves.build(this.sheets);
    this.choose(this.chosen ?? 0);
  }

  // Marks where the designs stand, above all the one chosen.
  choose(index) {
    this.chosen = index;
    if (!this.curves) return;
    const marks = this.places.map((at, i) => ({ at, colour: i === index ? "--accent" : "--ground" })).filter(({ at }) => at !== null);
    for (const sheet of this.sheets) sheet.marks = [...marks.filter((m) => m.colour !== "--accent"), ...marks.filter((m) => m.colour === "--accent")];
    this.curves.redraw();
  }

  redraw() { this.curves?.redraw(); }

  // Goes to the design that stands nearest to a place of the plot.
  #pick(at) {
    let [best, least] = [null, Infinity];
    this.places.forEach((place, i) => {
      if (place !== null && Math.abs(place - at) < least) [best, least] = [i, Math.abs(place - at)];
    });
    if (best !== null) this.onChoose(best);
  }
}
