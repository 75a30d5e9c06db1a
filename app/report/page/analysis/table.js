// The columns of the analysis, and which of them belong together.

import { extremes, interpolate, locate, quantile } from "../sampling.js";
import { LENGTH_UNIT, say, term } from "../words.js";

const UNIT_TEXTS = { deg: "°", length: say("unit.length"), "length/s": say("unit.speed"), "length/s2": say("unit.acceleration"), "rad/s2": "rad/s²", N: say("unit.force"), "N m": say("unit.torque"), "1/length": say("unit.curvature") };
export const unitText = (unit) => UNIT_TEXTS[unit] ?? unit;
const UNIT_SUFFIX = /_(deg|per_s2|per_s|rad_s2|rad_s|N_m|N)$/;

export const INSTANT_GEOMETRY = "instant-geometry";

// A column's name in words, without its unit: "E vx", "bar ω", "A on coupler Fx".
function columnLabel({ name, of }) {
  const bare = name.replace(UNIT_SUFFIX, "").replace(/_omega$/, "_ω").replace(/_alpha$/, "_α");
  const words = (text) => term(text.replaceAll("_", " "));
  const partOf = (text) => { const [, what, axis] = /^(.*?)(_F?[xyuvmn])?$/.exec(text); return `${words(what)}${(axis ?? "").replace("_", " ")}`; };
  const [, first, second, what = ""] = /^(.+)_on_(.+?)((?:_F[xy]|_moment)?)$/.exec(bare) ?? [];
  if (first) return say("values.on", { first: words(first), second: words(second), what: words(what.slice(1)) }).trim();
  return bare.startsWith(`${of}_`) ? say("values.of_part", { of: words(of), what: partOf(bare.slice(of.length + 1)) }) : partOf(bare);
}

// A column's name in files, with the unit of lengths: "C_x_mm", "C_vx_mm_per_s", "C_curvature_per_mm".
function fileName({ name, unit }) {
  if (!LENGTH_UNIT || !unit.includes("length")) return name;
  if (unit.startsWith("1/")) return `${name}_per_${LENGTH_UNIT}`;
  const [, bare, rate = ""] = /^(.*?)(_per_s2?)?$/.exec(name);
  return `${bare}_${LENGTH_UNIT}${rate}`;
}

// What a part of the table is called; a sliding pair by the bodies that it joins, as "frame-slider".
export function partName(name) {
  const bodies = name.split("-").map(term);
  return term(name) === name && bodies.length === 2 && bodies.join("-") !== name ? bodies.join("–") : term(name);
}

export class Table {
  // `loads`: what acts from outside, row by row where it does not always.
  constructor({ rows, drive, columns }, vectors, normals, loads) {
    const rising = drive.length < 2 || drive.at(-1) >= drive[0];
    const turned = (list) => (rising ? list : [...list].reverse());
    Object.assign(this, { rows, drawn: drive.length, drive: turned(drive), vectors, normals, loads: loads.map((load) => (load.acts ? { ...load, acts: turned(load.acts) } : load)) });
    this.columns = columns.map((column, index) => ({ ...column, index, label: columnLabel(column), written: turned(column.values) }));
    this.#hush();
    for (const column of this.columns) [column.least, column.greatest] = extremes(column.values);
    // Parts in the order of the table; the drive itself is on every plot's axis.
    this.parts = [...new Set(this.columns.filter((c) => c.quantity !== "drive").map((c) => c.of))];
  }

  // Rounding is no motion: what is next to nothing beside all else of its kind is shown as zero.
  #hush() {
    const sizes = new Map();
    const kind = (column) => `${column.quantity} ${column.unit}`;
    for (const column of this.columns) sizes.set(kind(column), Math.max(sizes.get(kind(column)) ?? 0, quantile(column.written, 0.95)));
    for (const column of this.columns) {
      const least = 1e-11 * sizes.get(kind(column));
      column.values = column.written.map((v) => (v !== null && Math.abs(v) < least ? 0 : v));
    }
  }

  // The centrodes that poles trace in the plane, for each body a path with gaps.
  get centrodes() {
    return this.vectorsOf(INSTANT_GEOMETRY).filter(({ x }) => x.name === `${x.of}_pole_x`)
      .map(({ x, y }) => ({ of: x.of, path: x.values.map((value, i) => (value === null || y.values[i] === null ? null : [value, y.values[i]])) }));
  }

  get thinned() { return this.drawn < this.rows; }

  // The value of a column at a drive coordinate, by interpolation.
  at(column, drive) {
    if (this.drawn === 0 || drive < this.drive[0] - 1e-9 || drive > this.drive.at(-1) + 1e-9) return null;
    return this.drawn === 1 ? column.values[0] : interpolate(column.values, locate(this.drive, drive));
  }

  // The vectors of a quantity, their components as columns.
  vectorsOf(quantity) {
    return this.vectors.map(({ x, y, body, at }) => ({ x: this.columns[x], y: this.columns[y], body, at })).filter((v) => v.x.quantity === quantity);
  }

  get csv() {
    const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    const lines = [this.columns.map((c) => cell(fileName(c))), ...this.drive.map((_, i) => this.columns.map((c) => c.written[i] ?? ""))];
    return `${lines.map((line) => line.join(",")).join("\n")}\n`;
  }
}
