// A slider-crank in the address: its dimensions and what was measured.

import { withoutRounding } from "../rounding.js";

const SLIDER_CRANK = "slider-crank";

// Whether a design in the address is no slider-crank.
export const isFourBarText = (text) => text.split(";")[2] !== SLIDER_CRANK;

export function sliderText({ mechanism: m, crank_deg: cranks, rms, max, stray = 0, transmission_acute_min_deg: least }) {
  const size = Math.max(m.crank, m.coupler), lengths = [...m.pivot, m.crank, m.coupler, m.offset, ...m.coupler_point].map((x) => withoutRounding(x, size));
  const angles = [m.direction_deg, ...cranks].map((x) => withoutRounding(x, 360));
  return [[...lengths, rms, max, stray, least].join(","), m.assembly, SLIDER_CRANK, angles.join(",")].join(";");
}

// Null where the text says no slider-crank.
export function sliderOf(text) {
  const [values, assembly, name, turns = ""] = text.split(";"), numbers = values.split(",").map(Number), [direction, ...cranks] = turns.split(",").map(Number);
  const [ax, ay, crank, coupler, offset, u, v, rms, max, stray, least] = numbers;
  if (numbers.length !== 11 || ![...numbers, direction, ...cranks].every(Number.isFinite) || !(Math.min(crank, coupler) > 0) || !["open", "crossed"].includes(assembly) || name !== SLIDER_CRANK) return null;
  return { mechanism: { type: name, pivot: [ax, ay], crank, coupler, offset, direction_deg: direction, assembly, coupler_point: [u, v] }, crank_deg: cranks,
    rms, max, ...(stray > 0 ? { stray } : {}), class: name, transmission_acute_min_deg: least };
}
