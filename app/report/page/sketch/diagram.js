// The diagram of a function: the input angle across, the output angle upwards, both in degrees.

import { set, svg } from "../dom.js";
import { number } from "../format.js";
import { pathThrough, round } from "../shapes.js";
import { say } from "../words.js";
import { layout, placeOf } from "./layout.js";

export const DIAGRAM_MARGIN = 14;   // pixels about the sheet

const FEWEST_PIXELS = 46;     // from tick to tick
const TICK_STEPS = [1, 2, 5, 10, 15, 30, 45, 60, 90, 120, 180];

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
export function errorStrip(view, ranges, lists, names) {
  const { diagram, errors: { y0, y1 } } = layout(), box = { ...diagram, y0, y1 }, middle = (y0 + y1) / 2, most = Math.max(...lists.flat().map(([, error]) => Math.abs(error)), 1e-9);
  const at = ([input, error]) => view.screen([placeOf([input, 0], ranges)[0], middle + (error / most) * (0.42 * (y1 - y0))]);
  const [left, zero] = at([0, 0]), [right] = at([ranges[0], 0]), limits = [1, -1].map((sense) => at([0, sense * most])[1]);
  const lines = lists.map((list, i) => svg("path", { class: `diagram-error ${names[i]}`, d: pathThrough(list.map(at)) }));
  return svg("g", { class: "diagram" }, frame(view, box, {}), svg("path", { class: "diagram-grid", d: `M${round(left)} ${round(zero)}H${round(right)}` }), ...lines,
    ...limits.map((y, i) => tick("diagram-tick", [left - 6, y + 4], "end", `${i ? "−" : "+"}${number(most, 2)}°`)), tick("diagram-axis", [right, view.screen([0, y1])[1] - 5], "end", say("sketch.error_axis")));
}

// The axes with their ticks, in the pixels of `view`.
export function diagramAxes(view, ranges) {
  const { diagram } = layout(), [[left, bottom], [right, top]] = [[diagram.x0, diagram.y0], [diagram.x1, diagram.y1]].map((corner) => view.screen(corner));
  const at = (pair) => view.screen(placeOf(pair, ranges));
  const across = ticksOf(ranges[0], right - left).map((v) => [at([v, 0])[0], v]), upwards = ticksOf(ranges[1], bottom - top).map((v) => [at([0, v])[1], v]);
  const grid = svg("path", { class: "diagram-grid", d: [...across.map(([x]) => `M${round(x)} ${round(top)}V${round(bottom)}`), ...upwards.map(([y]) => `M${round(left)} ${round(y)}H${round(right)}`)].join("") });
  const turned = tick("diagram-axis", [0, 0], "middle", say("sketch.output_axis"));
  set(turned, { transform: `translate(${round(left - 36)} ${round((top + bottom) / 2)}) rotate(-90)` });
  return svg("g", { class: "diagram" }, frame(view, diagram, { id: "diagram" }), grid, ...across.map(([x, v]) => tick("diagram-tick", [x, bottom + 15], "middle", `${number(v)}°`)),
    ...upwards.map(([y, v]) => tick("diagram-tick", [left - 6, y + 4], "end", `${number(v)}°`)), tick("diagram-axis", [(left + right) / 2, bottom + 31], "middle", say("sketch.input_axis")), turned);
}
