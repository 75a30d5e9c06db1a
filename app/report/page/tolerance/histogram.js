// How the samples of a Monte Carlo are spread: bars of their greatest errors, with the quantiles.

import { element, svg } from "../dom.js";
import { lengthText } from "../fact_text.js";
import { number } from "../format.js";
import { round } from "../shapes.js";
import { say, withUnit } from "../words.js";

// Above the bars there is room for rows of labels, as many as labels that would meet take.
const BOX = { height: 244, left: 46, right: 12, top: 50, bottom: 40, rowHeight: 15, rows: 3 };

// Quantiles that are marked.
const MARKED = [0.5, 0.9, 0.99];

// The least of 1, 2 or 5 times a power of ten that is not below `wanted`.
function roundStep(wanted) {
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= wanted);
}

const percent = (share, digits = 4) => say("tolerance.percent", { value: number(100 * share, digits) });

export class Histogram {
  constructor(holder) {
    this.holder = holder;
    new ResizeObserver(() => { if (this.drawn && this.holder.clientWidth !== this.width) this.#draw(); }).observe(holder);
  }

  // `quantity` as results hold it, `unit` its unit, `limit` the greatest error that is good, if any.
  show(quantity, unit, limit) {
    this.drawn = { quantity, unit, limit };
    this.#draw();
  }

  #draw() {
    const { quantity: { histogram: { edges, counts }, quantiles = [] }, unit, limit } = this.drawn;
    const width = this.width = this.holder.clientWidth || 320;
    const marks = [...quantiles.filter(({ share, error }) => MARKED.includes(share) && error !== null).map(({ share, error }) => [percent(share), error, ""]), ...(limit === undefined ? [] : [[say("tolerance.limit"), limit, "limit"]])];
    const [low, high] = [Math.min(edges[0], ...marks.map(([, at]) => at)), Math.max(edges.at(-1), ...marks.map(([, at]) => at))];
    const x = (value) => BOX.left + ((width - BOX.left - BOX.right) * (value - low)) / (high - low);
    const foot = BOX.height - BOX.bottom;
    const most = Math.max(...counts);
    const all = counts.reduce((sum, n) => sum + n, 0);
    const bars = counts.map((count, i) => {
      const top = foot - ((foot - BOX.top) * count) / most;
      const text = say("tolerance.bin", { from: number(edges[i], 4), to: number(edges[i + 1], 4), unit, n: count, share: percent(count / all) });
      return svg("rect", { class: "bin", x: round(x(edges[i])), y: round(top), width: round(Math.max(0.5, x(edges[i + 1]) - x(edges[i]) - 0.8)), height: round(foot - top), "data-count": count }, svg("title", {}, text));
    });
    const root = svg("svg", { viewBox: `0 0 ${width} ${BOX.height}`, width, height: BOX.height, role: "img", "aria-label": say("tolerance.histogram") },
      ...this.#scale(most, all, foot, width), ...bars, svg("path", { class: "zero", d: `M${BOX.left} ${foot}H${width - BOX.right}` }), ...this.#ticks(x, low, high, foot), ...this.#marks(marks, x, foot, width),
      svg("text", { class: "axis", x: width / 2, y: BOX.height - 6, "text-anchor": "middle" }, withUnit(say("tolerance.greatest_error"), unit)));
    this.holder.replaceChildren(root);
  }

  #ticks(x, low, high, foot) {
    const step = roundStep((high - low) / 5);
    const count = Math.floor(high / step) - Math.ceil(low / step) + 1;
    return Array.from({ length: count }, (_, i) => (Math.ceil(low / step) + i) * step)
      .map((value) => svg("text", { class: "tick", x: round(x(value)), y: foot + 15, "text-anchor": "middle" }, number(value, 6)));
  }

  // Lines for shares of all samples.
  #scale(most, all, foot, width) {
    const step = roundStep(most / all / 3);
    return Array.from({ length: Math.floor(most / all / step) }, (_, i) => (i + 1) * step).flatMap((share) => {
      const y = round(foot - ((foot - BOX.top) * share * all) / most);
      return [svg("path", { class: "share-line", d: `M${BOX.left} ${y}H${width - BOX.right}` }), svg("text", { class: "tick", x: BOX.left - 5, y: y + 4, "text-anchor": "end" }, percent(share, 3))];
    });
  }

  // A label stands in the lowest row in which it does not meet another; where all are taken it is left to the pointer.
  #marks(marks, x, foot, width) {
    const taken = Array(BOX.rows).fill(-Infinity);
    const placed = [...marks].sort((p, q) => p[1] - q[1]).map(([name, value, kind]) => {
      const at = x(value);
      const text = `${name} ${number(value, 4)}`;
      const half = 3.3 * text.length;
      const middle = Math.min(width - half - 2, Math.max(half + 2, at));
      const row = taken.findIndex((end) => middle - half > end + 6);
      if (row >= 0) taken[row] = middle + half;
      const y = BOX.top - 8 - BOX.rowHeight * row;
      const line = svg("path", { class: `mark-line ${kind}`, "data-at": value, d: `M${round(at)} ${row < 0 ? BOX.top : y + 3}V${foot}` }, svg("title", {}, text));
      return { line, label: row < 0 ? [] : [svg("text", { class: `tick ${kind}`, x: round(middle), y, "text-anchor": "middle" }, text)] };
    });
    return [...placed.map(({ line }) => line), ...placed.flatMap(({ label }) => label)];
  }
}

// What each dimension makes of the worst case, the greatest first.
export function contributionBars({ contributions }, dimensions, allocated, show, name) {
  const most = Math.max(...contributions.map(({ amount }) => amount ?? 0)) || 1;
  return element("div", { class: "contributions", role: "list" }, ...contributions.map(({ dimension, amount, share, sensitivity }) => {
    const own = dimensions.find((one) => one.name === dimension);
    const limits = own ? (own.plus === own.minus ? `±${lengthText(own.plus, 4)}` : `+${number(own.plus, 4)} −${lengthText(own.minus, 4)}`) : "";
    const bought = allocated.find((one) => one.dimension === dimension);
    return element("div", { class: "contribution", role: "listitem", "data-dimension": dimension, "data-share": share ?? "", title: say("tolerance.sensitivity", { value: number(sensitivity, 4) }) },
      element("span", { class: "name" }, name(dimension), element("small", {}, limits, ...(bought ? [` → ${bought.tolerance === null ? say("tolerance.any") : `±${lengthText(bought.tolerance, 4)}`}`] : []))),
      element("span", { class: "track" }, element("span", { class: "bar", style: `width:${round((100 * (amount ?? 0)) / most)}%` })),
      element("span", { class: "number" }, show(amount)), element("span", { class: "number share" }, share === null ? "–" : percent(share, 3)));
  }));
}
