// The diagram of a function on the left of the sheet: the input angle across, the output angle upwards, both in degrees.

import { set, svg } from "../dom.js";
import { number } from "../format.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";

// Where it stands on the sheet, in its units, and where linkages stand that generate the function.
const DIAGRAM = { x0: -47, y0: -16, x1: 4, y1: 41 };
export const STAGE = { x0: 15, y0: -33, x1: 57, y1: 32 };
export const DIAGRAM_MARGIN = 14;   // pixels about the sheet
const ERRORS = { y0: -40, y1: -31 };   // units of the strip below, with the errors

const BESIDE = 6;             // units beside the diagram within which a hand means its edge
const FEWEST_PIXELS = 46;     // from tick to tick
const TICK_STEPS = [1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180];

const shareOf = (value, from, to) => (value - from) / (to - from);
const within = (share) => Math.max(0, Math.min(1, share));

// Where a pair [input, output] stands; `ranges`: of both, the second with its sign.
export const placeOf = ([input, output], [across, upwards]) =>
  [DIAGRAM.x0 + (input / across) * (DIAGRAM.x1 - DIAGRAM.x0), DIAGRAM.y0 + (output / upwards) * (DIAGRAM.y1 - DIAGRAM.y0)];

// The shares of both ranges at a place, that of the nearest edge beside the diagram.
export const sharesOf = ([x, y]) => [within(shareOf(x, DIAGRAM.x0, DIAGRAM.x1)), within(shareOf(y, DIAGRAM.y0, DIAGRAM.y1))];

export const isNear = ([x, y]) => x > DIAGRAM.x0 - BESIDE && x < DIAGRAM.x1 + BESIDE && y > DIAGRAM.y0 - BESIDE && y < DIAGRAM.y1 + BESIDE;

// Round values from 0 to `range`, at least FEWEST_PIXELS apart on `length` pixels.
function ticksOf(range, length) {
  const size = Math.abs(range);
  const step = TICK_STEPS.find((one) => (one / size) * length >= FEWEST_PIXELS) ?? size;
  return Array.from({ length: Math.floor(size / step + 1e-9) + 1 }, (_, i) => Math.sign(range) * i * step);
}

const tick = (name, [x, y], anchor, value) => svg("text", { class: name, x: round(x), y: round(y), "text-anchor": anchor }, value);

function frame(view, { x0, y0, x1, y1 }, attributes) {
  const [[left, bottom], [right, top]] = [[x0, y0], [x1, y1]].map((corner) => view.screen(corner));
  return svg("rect", { class: "diagram-box", ...attributes, x: round(left), y: round(top), width: round(right - left), height: round(bottom - top) });
}

// The errors of generators at their pairs, lists of [input, error]: a line for each, of a class `names[i]`.
export function errorStrip(view, ranges, errors, names) {
  const box = { ...DIAGRAM, ...ERRORS }, middle = (ERRORS.y0 + ERRORS.y1) / 2, most = Math.max(...errors.flat().map(([, error]) => Math.abs(error)), 1e-9);
  const at = ([input, error]) => view.screen([placeOf([input, 0], ranges)[0], middle + (error / most) * (0.42 * (ERRORS.y1 - ERRORS.y0))]);
  const [left, zero] = at([0, 0]), [right] = at([ranges[0], 0]), limits = [1, -1].map((sense) => at([0, sense * most])[1]);
  const lines = errors.map((list, i) => svg("path", { class: `diagram-error ${names[i]}`, d: pathThrough(list.map(at)) }));
  return svg("g", { class: "diagram" }, frame(view, box, {}), svg("path", { class: "diagram-grid", d: `M${round(left)} ${round(zero)}H${round(right)}` }), ...lines,
    ...limits.map((y, i) => tick("diagram-tick", [left - 6, y + 4], "end", `${i ? "−" : "+"}${number(most, 2)}°`)), tick("diagram-axis", [right, view.screen([0, ERRORS.y1])[1] - 5], "end", say("sketch.error_axis")));
}

// The axes with their ticks, in the pixels of `view`.
export function diagramAxes(view, ranges) {
  const [[left, bottom], [right, top]] = [[DIAGRAM.x0, DIAGRAM.y0], [DIAGRAM.x1, DIAGRAM.y1]].map((corner) => view.screen(corner));
  const at = (pair) => view.screen(placeOf(pair, ranges));
  const across = ticksOf(ranges[0], right - left).map((v) => [at([v, 0])[0], v]), upwards = ticksOf(ranges[1], bottom - top).map((v) => [at([0, v])[1], v]);
  const grid = svg("path", { class: "diagram-grid", d: [...across.map(([x]) => `M${round(x)} ${round(top)}V${round(bottom)}`), ...upwards.map(([y]) => `M${round(left)} ${round(y)}H${round(right)}`)].join("") });
  const turned = tick("diagram-axis", [0, 0], "middle", say("sketch.output_axis"));
  set(turned, { transform: `translate(${round(left - 36)} ${round((top + bottom) / 2)}) rotate(-90)` });
  return svg("g", { class: "diagram" }, frame(view, DIAGRAM, { id: "diagram" }), grid, ...across.map(([x, v]) => tick("diagram-tick", [x, bottom + 15], "middle", `${number(v)}°`)),
    ...upwards.map(([y, v]) => tick("diagram-tick", [left - 6, y + 4], "end", `${number(v)}°`)), tick("diagram-axis", [(left + right) / 2, bottom + 31], "middle", say("sketch.input_axis")), turned);
}
