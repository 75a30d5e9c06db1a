// A Pareto front: the designs by their two objectives, each a point that chooses its design.

import { byId, svg } from "../dom.js";
import { number, sentence } from "../format.js";
import { keyName } from "../problem.js";
import { pathThrough, round } from "../shapes.js";
import { LENGTH_UNIT, say, withUnit } from "../words.js";
import { flatMetrics } from "./facts.js";

const FRONT = { height: 260, left: 64, right: 18, top: 14, bottom: 44 };

// Objectives that metrics hold under other names.
const OBJECTIVE_METRICS = { transmission_angle: ["transmission_angle_deg.acute_min"], deviation: ["deviation_relative"], length: ["straight_length"], links: ["link_count"], size: ["size_over_length", "longest_link"] };
const COUNTS = ["links"];

// The errors of the designs along a front as the program weighs them: of dwells half bands, of legs their flatness; none where it says nothing.
function errorsOf(families, count) {
  const column = families.find(({ name }) => / front$/.test(name))?.columns[1];
  if (column?.values.length !== count) return null;
  return { values: column.values, unit: column.name.endsWith("_deg") ? "°" : /error|band/.test(column.name) ? LENGTH_UNIT ?? "" : "" };
}

// The value of an objective that a design has, and its unit; null where it is not known.
function objectiveOf(name, { error, metrics, mechanism }, weighed, index) {
  if (name === "error" && weighed) return { value: weighed.values[index], unit: weighed.unit };
  if (name === "error") return error.max_deg === undefined ? { value: error.rms, unit: LENGTH_UNIT ?? "" } : { value: error.rms_deg, unit: "°" };
  if (name === "link_ratio") return { value: linkRatio(mechanism), unit: "" };
  const known = flatMetrics(metrics);
  const [key, value] = known.find(([metric]) => (OBJECTIVE_METRICS[name] ?? [name]).includes(metric)) ?? known.find(([metric]) => metric.startsWith(name)) ?? [];
  return typeof value === "number" ? { value, unit: /_deg(\.|$)/.test(key) ? "°" : name in OBJECTIVE_WORDS && !COUNTS.includes(name) ? LENGTH_UNIT ?? "" : "" } : null;
}

// What the designs of a problem are traded off by: those of a robust one are judged by the nominal error and by that of what is made.
export const frontObjectives = ({ objectives = [], robust } = {}) => (robust === undefined ? objectives : ["nominal_error", robust === "worst" ? "worst_case" : "quantile"]);

const OBJECTIVE_WORDS = { error: "front.error", nominal_error: "front.nominal_error", quantile: "front.quantile", worst_case: "front.worst_case", transmission_angle: "qualities.least_acute", links: "front.links" };

function linkRatio({ crank, coupler, rocker, fixed_pivots: pivots }) {
  const all = [crank, coupler, rocker, pivots && Math.hypot(pivots[1][0] - pivots[0][0], pivots[1][1] - pivots[0][1])];
  return all.every(Number.isFinite) ? Math.max(...all) / Math.min(...all) : null;
}

export class Front {
  // `entries` of the result, `families` of its page, `onChoose(index)`. Without a front of two objectives the card stays hidden.
  constructor(objectives, entries, families, onChoose) {
    Object.assign(this, { onChoose, holder: byId("front-plot") });
    const weighed = errorsOf(families, entries.length);
    const values = entries.map((entry, i) => objectives.map((name) => objectiveOf(name, entry, weighed, i)));
    this.shown = objectives.length === 2 && entries.length > 1 && values.every((pair) => pair.every((part) => part && Number.isFinite(part.value)));
    byId("front").hidden = !this.shown;
    if (!this.shown) return;
    this.points = values.map((pair) => pair.map(({ value }) => value));
    this.labels = objectives.map((name, k) => { const { unit } = values[0][k]; const words = sentence(OBJECTIVE_WORDS[name] ? say(OBJECTIVE_WORDS[name]) : keyName(name, "")); return withUnit(words, unit); });
    this.chosen = 0;
    new ResizeObserver(() => this.draw()).observe(this.holder);
  }

  choose(index) {
    this.chosen = index;
    if (this.shown) this.draw();
  }

  draw() {
    const width = this.holder.clientWidth || 600;
    const [x, y] = [0, 1].map((k) => this.#scale(k, k ? [FRONT.height - FRONT.bottom, FRONT.top] : [FRONT.left, width - FRONT.right]));
    const at = (p) => [round(x.to(p[0])), round(y.to(p[1]))];
    const root = svg("svg", { viewBox: `0 0 ${width} ${FRONT.height}`, width, height: FRONT.height, role: "group", "aria-label": say("front.title") },
      ...x.ticks.flatMap((v) => [svg("path", { class: "grid", d: `M${round(x.to(v))} ${FRONT.top}V${FRONT.height - FRONT.bottom}` }), svg("text", { class: "tick", x: round(x.to(v)), y: FRONT.height - FRONT.bottom + 16, "text-anchor": "middle" }, number(v, 6))]),
      ...y.ticks.flatMap((v) => [svg("path", { class: "grid", d: `M${FRONT.left} ${round(y.to(v))}H${width - FRONT.right}` }), svg("text", { class: "tick", x: FRONT.left - 6, y: round(y.to(v)) + 4, "text-anchor": "end" }, number(v, 6))]),
      svg("text", { class: "axis", x: (FRONT.left + width - FRONT.right) / 2, y: FRONT.height - 8, "text-anchor": "middle" }, this.labels[0]),
      svg("text", { class: "axis", transform: `translate(14 ${(FRONT.height - FRONT.bottom + FRONT.top) / 2}) rotate(-90)`, "text-anchor": "middle" }, this.labels[1]),
      svg("path", { class: "front-line", d: pathThrough([...this.points].sort((p, q) => p[0] - q[0]).map(at)) }), ...this.points.map((p, i) => this.#point(p, i, at(p))));
    this.holder.replaceChildren(root);
  }

  #point(values, index, [cx, cy]) {
    const text = say("front.point", { n: index + 1, first: number(values[0], 4), second: number(values[1], 4) });
    const point = svg("circle", { class: "front-point", cx, cy, r: index === this.chosen ? 7 : 5, tabindex: 0, role: "button", "aria-pressed": String(index === this.chosen), "aria-label": text, "data-design": index }, svg("title", {}, text));
    const choose = () => { this.onChoose(index); this.holder.querySelector(`[data-design="${index}"]`).focus(); };
    point.addEventListener("click", choose);
    point.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); event.stopPropagation(); choose(); } });
    return point;
  }

  // From values of an objective to pixels, with round values for its axis.
  #scale(k, [from, to]) {
    const values = this.points.map((p) => p[k]);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = 0.06 * (high - low) || 0.1 * Math.abs(high) || 1;
    const [least, most] = [low - room, high + room];
    const wanted = (most - least) / Math.max(4, Math.abs(to - from) / 70);
    const power = 10 ** Math.floor(Math.log10(wanted));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= wanted);
    const ticks = Array.from({ length: Math.floor(most / step) - Math.ceil(least / step) + 1 }, (_, i) => (Math.ceil(least / step) + i) * step);
    return { ticks: ticks.map((v) => Number(v.toPrecision(12))), to: (v) => from + ((to - from) * (v - least)) / (most - least) };
  }
}
