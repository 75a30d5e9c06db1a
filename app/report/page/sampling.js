// Sampled values: between the samples, and at a scale that reads well.

import { engineeringExponent, powerOfTen } from "./format.js";

export const RADIANS = Math.PI / 180;

// The index i and share t with value = list[i] + t·(list[i + 1] − list[i]), list increasing.
export function locate(list, value) {
  let low = 0;
  let high = list.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= value) low = middle; else high = middle;
  }
  const step = list[high] - list[low];
  const share = step > 0 ? (value - list[low]) / step : 0;
  return [low, Math.min(1, Math.max(0, share))];
}

// The value at a place that `locate` gives; null beside a gap.
export function interpolate(list, [i, t]) {
  if (t === 0 || i + 1 >= list.length) return list[i];
  if (t === 1) return list[i + 1];
  return list[i] === null || list[i + 1] === null ? null : list[i] + t * (list[i + 1] - list[i]);
}

// The value of `to` where `from` (monotonic) has `value`, by interpolation; null outside.
export function lookUp(value, from, to) {
  const rising = from.at(-1) >= from[0];
  const list = rising ? from : [...from].reverse();
  const margin = 1e-9 * (list.at(-1) - list[0]);
  if (value < list[0] - margin || value > list.at(-1) + margin) return null;
  return interpolate(rising ? to : [...to].reverse(), locate(list, value));
}

// A title's unit with the power of ten taken out of the values.
export function scaled(values, unit) {
  const size = Math.max(...values.filter((v) => v !== null).map(Math.abs), 0);
  const exponent = engineeringExponent(size);
  return { values: values.map((v) => (v === null ? null : v / 10 ** exponent)), size,
    unit: exponent === 0 ? unit : unit === "°" ? `${powerOfTen(exponent)} °` : `${powerOfTen(exponent)} ${unit}` };
}

// The size that all but a share of `values` stay below.
export function quantile(values, share) {
  const sizes = values.filter((v) => v !== null).map(Math.abs).sort((a, b) => a - b);
  return sizes.length ? sizes[Math.min(sizes.length - 1, Math.floor(share * sizes.length))] : 0;
}

// The least and the greatest of `values`, gaps left out.
export function extremes(values) {
  let [least, greatest] = [Infinity, -Infinity];
  for (const v of values) if (v !== null) { least = Math.min(least, v); greatest = Math.max(greatest, v); }
  return least <= greatest ? [least, greatest] : [null, null];
}
