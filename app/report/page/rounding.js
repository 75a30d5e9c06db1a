// What is rounding and no error, and numbers without it.

import { say } from "./words.js";

// Of a size of one, what is left by rounding in some hundred operations.
const ROUNDING = 1e-11;

export const isRounding = (value, size) => Math.abs(value) <= ROUNDING * size;

// An error of things of a `size` in words.
export const errorText = (value, size, show) => (isRounding(value, size) ? say("rounding.exact") : show(value));

const COPIED_DIGITS = 12;

// `x` to as many digits as a number of the size `size` has with twelve: copied numbers are not rounded.
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
