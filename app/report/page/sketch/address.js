// The sketch and a design of it at the end of the address: #p=x,y;x,y&…, each part by a letter.

import { LANGUAGES } from "../words.js";
import { withoutRounding } from "../rounding.js";

const numbersOf = (text) => text.split(",").map(Number);
const areFinite = (numbers) => numbers.every(Number.isFinite);

// A design's numbers in the order of the address; its words stand behind them.
function designText({ mechanism: m, crank_deg: cranks, rms, max, class: name, transmission_acute_min_deg: least }) {
  const size = Math.max(m.crank, m.coupler, m.rocker);
  const lengths = [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point].map((x) => withoutRounding(x, size));
  return [[...lengths, rms, max, least].join(","), m.assembly, name, cranks.map((x) => withoutRounding(x, 360)).join(",")].join(";");
}

function designOf(text) {
  const [numbers, assembly, name, cranks = ""] = text.split(";");
  const [ax, ay, dx, dy, crank, coupler, rocker, u, v, rms, max, least] = numbersOf(numbers);
  const entry = { mechanism: { type: "four-bar", fixed_pivots: [[ax, ay], [dx, dy]], crank, coupler, rocker, coupler_point: [u, v], assembly },
    crank_deg: numbersOf(cranks), rms, max, class: name, transmission_acute_min_deg: least };
  const isSound = areFinite([...numbersOf(numbers), ...entry.crank_deg, least]) && Math.min(crank, coupler, rocker) > 0;
  return isSound && ["open", "crossed"].includes(assembly) && /^[a-z-]+$/.test(name) ? entry : null;
}

// What stands behind the # for a state and, perhaps, the entry of a design.
export function addressOf({ points, closed, stroke, class: asked, least, reach }, entry) {
  const parts = [...location.hash.slice(1).split("&").filter((part) => LANGUAGES.includes(part)), `p=${points.map((p) => p.join(",")).join(";")}`,
    `o=${[closed ? "closed" : "open", stroke ? "stroke" : "points"].join(",")}`, `l=${[asked, least, reach].join(",")}`];
  return `#${[...parts, ...(entry ? [`d=${designText(entry)}`] : [])].join("&")}`;
}

// {state, entry} of the address; null where it holds no sketch.
export function readAddress(classes) {
  const parts = Object.fromEntries(location.hash.slice(1).replaceAll(/%3B/gi, ";").replaceAll(/%2C/gi, ",").split("&").map((part) => [part.slice(0, 1), part.slice(2)]));
  if (!parts.p) return null;
  const points = parts.p.split(";").map(numbersOf);
  const [asked, least, reach] = (parts.l ?? "").split(",");
  const [line, drawn] = (parts.o ?? "").split(",");
  if (!points.every((p) => p.length === 2 && areFinite(p))) return null;
  const state = { points, closed: line === "closed", stroke: drawn === "stroke", ...(classes.includes(asked) ? { class: asked } : {}),
    ...(Number.isFinite(Number(least)) && least ? { least: Number(least) } : {}), ...(Number(reach) > 0 ? { reach: Number(reach) } : {}) };
  return { state, entry: parts.d ? designOf(parts.d) : null };
}
