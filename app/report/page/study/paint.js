// Colours of rows by a column, and their key.

import { colour, element } from "../dom.js";
import { d3Range } from "./filters.js";

const isDark = () => document.documentElement.dataset.theme === "dark";
const SHADES = 48;

// The colour at a share from 0 to 1 that stands out from the page.
export const shadeAt = (share) => d3.interpolateViridis(isDark() ? 0.22 + 0.78 * share : 0.9 * share);

export class Paint {
  constructor(column) { this.column = column; }

  // Taken anew where the theme changes.
  prepare() {
    const { column } = this;
    this.shades = column?.words ? column.words.map((_, i) => d3.schemeTableau10[i % 10]) : d3Range(SHADES).map((i) => shadeAt(i / (SHADES - 1)));
    const [from, to] = column ? [column.least, column.greatest].map(column.log ? Math.log : Number) : [0, 1];
    const place = (v) => Math.max(0, Math.min(SHADES - 1, Math.floor(((column.log ? Math.log(v) : v) - from) / (to - from || 1) * SHADES)));
    this.indexOf = !column ? () => -1 : (row) => { const v = column.values[row]; return Number.isNaN(v) ? -1 : column.words ? v : place(v); };
    this.plain = colour(column ? "--ground" : "--accent");
  }

  of(row) { return this.shades[this.indexOf(row)] ?? this.plain; }

  key() {
    const { column } = this;
    if (!column) return [];
    if (column.words) {
      return [element("span", { class: "muted" }, column.label), ...column.words.map((_, i) => element("span", {}, element("i", { class: "dot", style: `background:${this.shades[i]}` }), column.show(i)))];
    }
    return keyBar(column.label, column.show(column.least, 4), column.show(column.greatest, 4), this.shades);
  }
}

export const keyBar = (label, from, to, shades) => [element("span", { class: "muted" }, label), element("span", {}, from),
  element("i", { class: "bar", style: `background:linear-gradient(to right, ${shades.join(",")})` }), element("span", {}, to)];
