// Functions as hands draw them, in states of the page of `cognate sketch`: half are sums of harmonics over the whole diagram,
// half are outputs of four-bars within the limits of the state, with the tremor of a hand.
import { leastTransmission, rockerAngle } from "../../browser/closures.mjs";

const PAIRS = 19, RANGES = [90, 60], TREMOR = 0.2;   // degrees
const inputs = Array.from({ length: PAIRS }, (_, i) => (RANGES[0] * i) / (PAIRS - 1));
const rounded = (x) => Math.round(100 * x) / 100;

function filled(outputs) {
  const low = Math.min(...outputs), high = Math.max(...outputs);
  return outputs.map((y, i) => [inputs[i], rounded((RANGES[1] * (y - low)) / (high - low))]);
}

function harmonicFunction(random) {
  const waves = [1, 2, 3].map((k) => ({ k, phase: 2 * Math.PI * random(), size: (random() - 0.5) / k ** 2.5 })), span = Math.PI * (0.2 + 0.8 * random());
  const slope = 2 * random();
  return filled(inputs.map((x) => (slope * x) / RANGES[0] + waves.reduce((sum, { k, phase, size }) => sum + size * Math.sin((k * span * x) / RANGES[0] + phase), 0)));
}

// Pairs {points, ranges} that a random four-bar generates within the limits, but for `tremor` degrees.
export function generatedFunction(random, { least, reach }, tremor) {
  for (;;) {
    const [crank, coupler, rocker, frame] = Array.from({ length: 4 }, () => reach ** random());
    const bar = { a: [0, 0], d: [frame, 0], crank, coupler, rocker, side: random() < 0.5 ? 1 : -1 }, start = 360 * random();
    const angles = inputs.map((input) => rockerAngle(bar, start + input));
    if (!angles.every(Number.isFinite) || !(leastTransmission(bar, inputs.map((input) => start + input)) >= least)) continue;
    const outputs = angles.map((angle) => { const turned = angle - angles[0]; return turned - 360 * Math.round(turned / 360); });
    const low = Math.min(...outputs), range = Math.max(...outputs) - low;
    if (range < 20 || range > 150) continue;
    return { points: outputs.map((y, i) => [inputs[i], y - low + tremor * (random() - 0.5)]), ranges: [RANGES[0], Math.ceil(range + 1)] };
  }
}

export function drawnFunction(random, i, state) {
  const drawn = i % 2 ? generatedFunction(random, state, TREMOR) : { points: harmonicFunction(random), ranges: RANGES };
  return { ...state, angles: null, ...drawn, points: drawn.points.map((pair) => pair.map(rounded)) };
}
