// Pairs [input, output] of a function in degrees, by rising input, as a hand changes them.

import { isNear, sharesOf } from "./layout.js";
import { rounded, smoothed } from "./stroke.js";

const COLUMNS = 240;          // of the diagram, in which a stroke leaves one value each
const NARROWEST = 0.02;       // share of the input range below which a stroke is none
const SMOOTHINGS = 12;
const PAIRS = [9, 24];
const PAIRS_A_WIDTH = 16;     // of a stroke that goes straight across the diagram
const APART = 1e-3;           // share of the input range between two pairs
const SAME = 0.01;            // share of a range
export const MOST_RANGE = 360;

const pairOf = ([across, upwards], ranges) => rounded([across * ranges[0], upwards * ranges[1]]);

// The value in each column that the line through `shares` passes; where it runs back the later one.
function columnsOf(shares) {
  const columns = new Array(COLUMNS + 1).fill(null);
  shares.forEach(([x1, y1], i) => {
    const [x0, y0] = shares[Math.max(0, i - 1)];
    const [from, to] = [Math.min(x0, x1), Math.max(x0, x1)].map((x) => x * COLUMNS);
    for (let k = Math.ceil(from); k <= to; ++k) columns[k] = x1 === x0 ? y1 : y0 + ((k / COLUMNS - x0) / (x1 - x0)) * (y1 - y0);
  });
  return columns;
}

// The value at a place between the entries.
function valueAt(values, place) {
  const i = Math.min(values.length - 2, Math.floor(place));
  return values[i] + (place - i) * (values[i + 1] - values[i]);
}

// The pairs of a freehand stroke through the diagram, at equal steps of the input; null where it passes too little of that.
export function pairsOfStroke(line, ranges) {
  const shares = line.filter(isNear).map(sharesOf);
  const columns = shares.length ? columnsOf(shares) : [];
  const first = columns.findIndex((v) => v !== null), last = columns.findLastIndex((v) => v !== null);
  if (first < 0 || last - first < NARROWEST * COLUMNS) return null;
  let values = columns.slice(first, last + 1);
  const length = values.reduce((sum, v, i) => sum + (i ? Math.hypot(v - values[i - 1], 1 / COLUMNS) : 0), 0);
  for (let i = 0; i < SMOOTHINGS; ++i) values = smoothed(values.map((v) => [v]), false).flat();
  const count = Math.max(PAIRS[0], Math.min(PAIRS[1], Math.round(PAIRS_A_WIDTH * length)));
  return Array.from({ length: count }, (_, i) => ((last - first) * i) / (count - 1)).map((place) => pairOf([(first + place) / COLUMNS, valueAt(values, place)], ranges));
}

const apart = (ranges) => Math.max(0.01, APART * ranges[0]);

// With a pair at a place of the sheet, which replaces one of about the same input; null beside the diagram.
export function withPair(pairs, place, ranges) {
  if (!isNear(place)) return null;
  const pair = pairOf(sharesOf(place), ranges);
  return [...pairs.filter(([input]) => Math.abs(input - pair[0]) >= apart(ranges)), pair].sort((a, b) => a[0] - b[0]);
}

// With pair i moved to a place, between its neighbours.
export function withPairMoved(pairs, i, place, ranges) {
  const [input, output] = pairOf(sharesOf(place), ranges);
  const [low, high] = [i ? pairs[i - 1][0] + apart(ranges) : 0, i + 1 < pairs.length ? pairs[i + 1][0] - apart(ranges) : ranges[0]];
  return pairs.with(i, rounded([Math.max(low, Math.min(high, input)), output]));
}

// The same drawing in other ranges.
export const withRanges = (pairs, from, to) => pairs.map((pair) => rounded(pair.map((v, k) => (v / from[k]) * to[k])));

// Values of a function at equal steps, which fill both ranges; one that is constant stands in the middle.
export function pairsOfValues(values, ranges) {
  const low = Math.min(...values), high = Math.max(...values);
  return values.map((v, i) => pairOf([i / (values.length - 1), high > low ? (v - low) / (high - low) : 0.5], ranges));
}

// Whether pairs are those, but for the rounding of ranges that were others.
export function areOfValues(pairs, values, ranges) {
  const own = pairsOfValues(values, ranges);
  return pairs.length === own.length && pairs.every((pair, i) => pair.every((v, k) => Math.abs(v - own[i][k]) <= SAME * Math.abs(ranges[k])));
}

// Whether pairs of an address are of such ranges.
export function areSound(pairs, [across, upwards]) {
  const inRanges = ([input, output]) => input >= 0 && input <= across && output / upwards >= 0 && output / upwards <= 1;
  return across > 0 && across <= MOST_RANGE && upwards !== 0 && Math.abs(upwards) <= MOST_RANGE && pairs.every((pair, i) => inRanges(pair) && (i === 0 || pair[0] > pairs[i - 1][0]));
}
