// Drawings as hands make them, the same in every run.

import { drawnLetter } from "./letters.mjs";

export const TREMOR = 0.004;

// Numbers in [0, 1) (Marsaglia's xorshift).
export function randomNumbers(state = 2463534242) {
  return () => {
    state ^= state << 13; state ^= state >>> 17; state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

// A sum of three harmonics with the tremor of a hand, of a size of about `size`, in `count` points about the origin.
export function harmonicStroke(random, closed, size, count) {
  const waves = [1, 2, 3].map((k) => ({ k, x: [random() - 0.5, random() - 0.5], y: [random() - 0.5, random() - 0.5], size: size / k ** 2.5 }));
  const span = closed ? 2 * Math.PI : Math.PI * (0.4 + 0.8 * random());
  const steps = closed ? count : count - 1;
  const at = (t, key) => waves.reduce((sum, wave) => sum + wave.size * (wave[key][0] * Math.cos(wave.k * t) + wave[key][1] * Math.sin(wave.k * t)), 0);
  return Array.from({ length: count }, (_, i) => ["x", "y"].map((key) => at((span * i) / steps, key) + size * TREMOR * (random() - 0.5)));
}

// By shares of a sheet, moved into it and made smaller where it would leave it.
function within(points) {
  const [low, high] = [Math.min, Math.max].map((pick) => [0, 1].map((k) => pick(...points.map((p) => p[k]))));
  const scale = Math.min(1, 0.7 / Math.max(high[0] - low[0], high[1] - low[1]));
  return points.map((p) => p.map((x, k) => 0.5 + scale * (x - (low[k] + high[k]) / 2)));
}

// The strokes of drawing `i`: of a curve one, every second closed; of poses one for each, two to seven.
export function drawnStroke(i) {
  const random = randomNumbers(88675123 + 7919 * i);
  const points = within(harmonicStroke(random, i % 2 === 0, 0.9, 60));
  return [i % 2 === 0 ? [...points, points[0]] : points];
}

export const drawnLetterStroke = (i) => [drawnLetter(i, randomNumbers(19088743 + 7919 * i), TREMOR)];

export function drawnPoses(i) {
  const random = randomNumbers(521288629 + 7919 * i);
  const places = within(harmonicStroke(random, false, 0.9, 2 + (i % 6)));
  let direction = 2 * Math.PI * random();
  return places.map(([x, y]) => {
    direction += 0.8 * (random() - 0.3);
    return [[x, y], [x + 0.05 * Math.cos(direction), y - 0.05 * Math.sin(direction)], [x + 0.08 * Math.cos(direction), y - 0.08 * Math.sin(direction)]];
  });
}

// A function drawn through its diagram, which lies on the left of the sheet.
export function drawnFunctionStroke(i) {
  const random = randomNumbers(362436069 + 7919 * i);
  const [rise, bend, wave] = [0.3 + 0.4 * random(), random() - 0.5, 0.2 * (random() - 0.5)];
  return [Array.from({ length: 60 }, (_, k) => k / 59).map((t) => [0.16 + 0.37 * t, 0.56 - 0.5 * (0.15 + rise * t + bend * t * (1 - t) + wave * Math.sin(5 * t))])];
}

// A line of a length between a tenth and half of the sheet, with a bow.
export function drawnLine(i) {
  const random = randomNumbers(123456789 + 7919 * i);
  const [length, direction, bow] = [0.1 + 0.4 * random(), 2 * Math.PI * random(), 0.1 * (random() - 0.5)], [x, y] = [Math.cos(direction), Math.sin(direction)];
  return [Array.from({ length: 30 }, (_, k) => k / 29).map((t) => [0.5 + length * (x * (t - 0.5) - y * bow * Math.sin(Math.PI * t)), 0.5 + length * (y * (t - 0.5) + x * bow * Math.sin(Math.PI * t))])];
}
