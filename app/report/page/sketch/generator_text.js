// A generator of a function in the address: its lengths, its start angles and what was measured.

import { withoutRounding } from "../rounding.js";

const GENERATOR_CLASSES = ["crank-rocker", "double-crank", "rocker-crank", "double-rocker", "triple-rocker"];

export function generatorText({ mechanism: m, input_start_deg: input, output_start_deg: output, rms, max, class: name, transmission_acute_min_deg: least }) {
  const [[ax, ay], [dx, dy]] = m.fixed_pivots, lengths = [m.crank, m.coupler, m.rocker, Math.hypot(dx - ax, dy - ay)], size = Math.max(...lengths);
  const starts = [input, output].map((angle) => withoutRounding(angle, 360));
  return [[...lengths.map((x) => withoutRounding(x, size)), ...starts, rms, max, least].join(","), m.assembly, name].join(";");
}

// For pairs; null where the text says no generator.
export function generatorOf(text, pairs) {
  const [values, assembly, name] = text.split(";"), numbers = values.split(",").map(Number);
  const [crank, coupler, rocker, frame, input, output, rms, max, least] = numbers;
  if (numbers.length !== 9 || !numbers.every(Number.isFinite) || !(Math.min(crank, coupler, rocker, frame) > 0) || !["open", "crossed"].includes(assembly) || !GENERATOR_CLASSES.includes(name)) return null;
  return { mechanism: { type: "four-bar", fixed_pivots: [[0, 0], [frame, 0]], crank, coupler, rocker, assembly }, crank_deg: pairs.map(([angle]) => input + angle),
    rms, max, class: name, transmission_acute_min_deg: least, input_start_deg: input, output_start_deg: output };
}
