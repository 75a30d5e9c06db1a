// The scales of a front's plot: {to, ticks}, from values to pixels, and round values.

const WIDE = 12;         // ratio of errors from which on their scale is logarithmic
const ROOM = 1.25;       // beside the least and the greatest on it
const LINE = 28;         // pixels from tick to tick upwards
const TICK = 28;         // and across

const between = (share, [from, to]) => from + (to - from) * share;

// The least of 1, 2, 5, 10 times a power of ten that is not less than `wanted`.
function roundStep(wanted) {
  const power = 10 ** Math.floor(Math.log10(wanted));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= wanted);
}

const multiples = (step, most) => Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, i) => Number((i * step).toPrecision(12)));

function fromZero(most, range) {
  const step = roundStep((most * LINE) / Math.abs(range[1] - range[0]));
  return { to: (v) => between(v / most, range), ticks: multiples(step, most) };
}

function logarithmic(least, most, range) {
  const decades = Array.from({ length: Math.ceil(Math.log10(most)) - Math.floor(Math.log10(least)) + 1 }, (_, i) => 10 ** (Math.floor(Math.log10(least)) + i));
  const within = (factors) => decades.flatMap((power) => factors.map((k) => Number((k * power).toPrecision(12)))).filter((v) => v >= least && v <= most);
  const few = Math.abs(range[1] - range[0]) / LINE;
  return { to: (v) => between(Math.log(v / least) / Math.log(most / least), range), ticks: [[1, 2, 5], [1, 3], [1]].map(within).find((ticks) => ticks.length <= few) ?? within([1]) };
}

// Of errors: logarithmic where they differ so much that the small ones would lie on one line.
export function errorScale(errors, range) {
  const [least, most] = [Math.min(...errors), Math.max(...errors)];
  return least > 0 && most > WIDE * least ? logarithmic(least / ROOM, most * ROOM, range) : fromZero(1.1 * most || 1, range);
}

// Of angles up to a right one, in degrees.
export function angleScale(range) {
  const step = [10, 15, 30].find((k) => ((range[1] - range[0]) * k) / 90 >= TICK) ?? 45;
  return { to: (v) => between(v / 90, range), ticks: multiples(step, 90) };
}
