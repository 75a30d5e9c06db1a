// The columns of the study: numbers, or words as numbers of their levels; NaN where a row lacks one.

import { metricName } from "../checks.js";
import { factName, factParts, unitWord } from "../fact_text.js";
import { number, sentence } from "../format.js";
import { keyName, unitOfKey } from "../problem.js";
import { LENGTH_UNIT, say, term, withUnit } from "../words.js";

// Numbers of these tables are lengths, but for those whose keys say something else.
const LENGTH_TABLES = /^(mechanism|bounds|follower)\./;
const NO_LENGTH = /(_deg|teeth|module|shift|ratio)$/;

// Quantities of cams, whose extremes are named by the stroke.
const CAM_QUANTITY = /^(pressure_angle_deg|(second_cam_)?curvature_radius)_(min|max)/;

// The name of a column in words, with its unit: a key of the base file, or a metric.
function columnLabel({ name, role, levels }) {
  const isWord = typeof levels?.[0] === "string";
  if (name === "status") return sentence(term(name));
  if (role === "variable") {
    const key = name.split(".").findLast((part) => !/^[\d[\]]+$/.test(part)) ?? name;
    const place = /\[?(\d+)\]?$/.exec(name)?.[1];
    const unit = unitOfKey(key, name.split(".")[0]).trim() || (LENGTH_UNIT && LENGTH_TABLES.test(name) && !NO_LENGTH.test(key) ? LENGTH_UNIT : "");
    const words = sentence(keyName(key.replace(/\[\d+\]$/, ""), name.split(".")[0])) + (place === undefined ? "" : ` ${Number(place) + (/\[/.test(name) ? 0 : 1)}`);
    return unit && !isWord ? say("unit.axis", { name: words, unit }) : words;
  }
  const cam = CAM_QUANTITY.exec(name);
  if (cam) return withUnit(metricName(name), cam[1] === "pressure_angle_deg" ? "°" : LENGTH_UNIT);
  const { key, unit } = factParts(name);
  const words = factName(key);
  return unitWord(unit) && !isWord ? say("unit.axis", { name: words, unit: unitWord(unit) }) : words;
}

class Column {
  constructor(raw, index) {
    Object.assign(this, { index, name: raw.name, role: raw.role, wanted: raw.wanted, label: columnLabel(raw) });
    this.words = raw.levels && typeof raw.levels[0] === "string" ? raw.levels : null;
    const value = (i) => raw.values ? raw.values[i] : raw.index[i] < 0 ? null : this.words ? raw.index[i] : raw.levels[raw.index[i]];
    this.values = Float64Array.from({ length: (raw.values ?? raw.index).length }, (_, i) => value(i) ?? NaN);
    this.range = raw.range ?? null;
    this.grid = raw.grid ? [...new Set(raw.grid)].sort((a, b) => a - b) : null;
    this.#setExtent();
    this.log = Boolean(raw.log) && this.least > 0;
  }

  #setExtent() {
    [this.least, this.greatest, this.missing] = [Infinity, -Infinity, false];
    for (const v of this.values) {
      if (Number.isNaN(v)) this.missing = true;
      else { this.least = Math.min(this.least, v); this.greatest = Math.max(this.greatest, v); }
    }
    this.empty = this.least > this.greatest;
    if (this.empty) [this.least, this.greatest] = [0, 0];
    this.constant = this.least === this.greatest;
  }

  // A value as a reader sees it.
  show(value, digits = 5) {
    return Number.isNaN(value) ? "–" : this.words ? term(this.words[value].replaceAll("_", " ")) : number(value, digits);
  }
  text(row, digits) { return this.show(this.values[row], digits); }

  // A value as a file or a table takes it.
  written(row) {
    const value = this.values[row];
    return Number.isNaN(value) ? "" : this.words ? this.words[value] : String(value);
  }

  // The values with a margin, from which a scale can be made.
  domain(margin = 0) {
    if (this.words) return [-0.5, this.words.length - 0.5];
    if (this.log) return this.constant ? [this.least / 2, this.greatest * 2] : [this.least, this.greatest].map((v, i) => v * (this.greatest / this.least) ** (i ? margin : -margin));
    const room = this.constant ? Math.abs(this.least) / 2 || 1 : margin * (this.greatest - this.least);
    return [this.least - room, this.greatest + room];
  }

  // A scale to pixels.
  scale(range, margin) { return (this.log ? d3.scaleLog() : d3.scaleLinear()).domain(this.domain(margin)).range(range); }

  // Places on a scale worth a tick, about one in each `room` pixels.
  ticks(scale, room = 50) {
    const [from, to] = scale.range();
    if (this.words) return d3.range(this.words.length);
    const wanted = Math.max(2, Math.floor(Math.abs(to - from) / room));
    const [least, greatest] = scale.domain();
    if (!this.log || greatest < 10 * least) return d3.ticks(least, greatest, wanted);
    return scale.ticks(wanted).filter((v) => (greatest > 1e4 * least ? /^1e/ : /^[125]e/).test(v.toExponential(0)));
  }
}

// How designs came out is a column where it differs.
export function columnsOf(data) {
  const outcome = data.statuses.levels.length > 1 ? [{ name: "status", role: "metric", ...data.statuses }] : [];
  return [...data.columns, ...outcome].map((raw, i) => new Column(raw, i));
}
