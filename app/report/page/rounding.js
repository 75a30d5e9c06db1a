// What is rounding and no error, and numbers without it.

import { say } from "./words.js";

// Of a size of one, what is left by rounding in some hundred operations.
const ROUNDING = 1e-11;

// The last place of targets that were cut off at a tenth digit or later; 0 of others, which are taken for exact.
let lastPlace = 0;
const MANY_DIGITS = 1e-8;

const decimalsOf = (x) => (String(x).split("e")[0].split(".")[1] ?? "").length - Number(String(x).split("e")[1] ?? 0);

// Points or pairs as the file gives them: an error within their last place is their rounding.
export function takeGiven({ points, pairs_deg: pairs } = {}) {
  const numbers = (points ?? pairs ?? []).flat().filter(Number.isFinite);
  const place = 10 ** -Math.max(0, ...numbers.map(decimalsOf));
  lastPlace = place <= MANY_DIGITS * Math.max(0, ...numbers.map(Math.abs)) ? place : 0;
}

const isRounding = (value, size) => Math.abs(value) <= ROUNDING * size;

// Whether an error of things of a `size` is rounding, of its own or of the targets.
export const isNoError = (error, size) => isRounding(error, size) || Math.abs(error) <= lastPlace;

// An error of things of a `size` in words.
export const errorText = (value, size, show) => (isRounding(value, size) ? say("rounding.exact") : show(value));

const COPIED_DIGITS = 12;

// `x` to as many places as a number of the size `size` with twelve digits has: copied numbers are not rounded.
export function withoutRounding(x, size) {
  if (!Number.isFinite(x) || !(size > 0)) return x;
  const places = COPIED_DIGITS - 1 - Math.floor(Math.log10(size));
  if (places > 100 || places < 0) return Number(x.toPrecision(COPIED_DIGITS));
  return Number(x.toFixed(places)) + 0;
}

const isDegrees = (key) => /_deg$/.test(key);

// The largest length in a table of dimensions of any shape.
export function sizeOf(table) {
  const sizes = (value, key) => (typeof value === "number" ? [isDegrees(key) ? 0 : Math.abs(value)]
    : value !== null && typeof value === "object" ? Object.entries(value).flatMap(([k, part]) => sizes(part, Array.isArray(value) ? key : k)) : []);
  return Math.max(0, ...sizes(table, ""));
}

// A table of dimensions without rounding: lengths by the largest of them, angles by a turn.
export function tableWithoutRounding(table, size = sizeOf(table)) {
  const rounded = (value, key) => {
    if (typeof value === "number") return withoutRounding(value, isDegrees(key) ? 360 : size);
    if (Array.isArray(value)) return value.map((part) => rounded(part, key));
    return value !== null && typeof value === "object" ? Object.fromEntries(Object.entries(value).map(([k, part]) => [k, rounded(part, k)])) : value;
  };
  return rounded(table, "");
}
