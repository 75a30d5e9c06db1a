// The sketch and a design of it at the end of the address: #p=x,y;x,y&…, each part by a letter; a pose is x,y,degrees; where there
// are ranges of a function a point is a pair of its angles.

import { LANGUAGES } from "../words.js";
import { withoutRounding } from "../rounding.js";
import { turnsFully } from "./boxes.js";
import { generatorOf, generatorText } from "./generator_text.js";
import { areSound } from "./pairs.js";
import { inTurn } from "./posed.js";

const numbersOf = (text) => text.split(",").map(Number);
const areFinite = (numbers) => numbers.every(Number.isFinite);

// A design's numbers in the order of the address; its words stand behind them.
function designText({ mechanism: m, crank_deg: cranks, rms, max, class: name, transmission_acute_min_deg: least, body_angle_deg: body, angle_max_deg: turned }) {
  const size = Math.max(m.crank, m.coupler, m.rocker);
  const lengths = [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point].map((x) => withoutRounding(x, size));
  const guided = body === undefined ? [] : [body, turned];
  return [[...lengths, rms, max, least, ...guided].join(","), m.assembly, name, cranks.map((x) => withoutRounding(x, 360)).join(",")].join(";");
}

function designOf(text) {
  const [numbers, assembly, name, cranks = ""] = text.split(";");
  const [ax, ay, dx, dy, crank, coupler, rocker, u, v, rms, max, least, body, turned] = numbersOf(numbers);
  const entry = { mechanism: { type: "four-bar", fixed_pivots: [[ax, ay], [dx, dy]], crank, coupler, rocker, coupler_point: [u, v], assembly },
    crank_deg: numbersOf(cranks), rms, max, class: name, transmission_acute_min_deg: least, ...(turned === undefined ? {} : { body_angle_deg: body, angle_max_deg: turned }) };
  const isSound = areFinite([...numbersOf(numbers), ...entry.crank_deg, least]) && Math.min(crank, coupler, rocker) > 0;
  return isSound && ["open", "crossed"].includes(assembly) && /^[a-z-]+$/.test(name) ? entry : null;
}

// Whether a design is one for as many targets, of the same kind; generators are for any pairs.
const isFor = ({ points, angles }, { crank_deg: cranks, body_angle_deg: body }) => cranks.length === points.length && (body === undefined) === (angles === null);

// A box in the address, by a letter.
const boxPart = (letter, box) => (box ? [`${letter}=${box.flat().join(",")}`] : []);

function boxIn(text = "") {
  const bounds = numbersOf(text), [x0, y0, x1, y1] = bounds;
  return bounds.length === 4 && areFinite(bounds) && x0 <= x1 && y0 <= y1 ? [[x0, y0], [x1, y1]] : null;
}

// What stands behind the # for a state and, perhaps, the entry of a design.
export function addressOf({ points, angles, ranges, closed, stroke, class: asked, least, reach, region, obstacle }, entry) {
  const parts = [...location.hash.slice(1).split("&").filter((part) => LANGUAGES.includes(part)), `p=${points.map((p, i) => [...p, ...(angles ? [angles[i]] : [])].join(",")).join(";")}`,
    `o=${[closed ? "closed" : "open", stroke ? "stroke" : "points"].join(",")}`, `l=${[asked, least, reach].join(",")}`, ...(ranges ? [`f=${ranges.join(",")}`] : []), ...boxPart("b", region), ...boxPart("c", obstacle)];
  return `#${[...parts, ...(entry ? [`d=${ranges ? generatorText(entry) : designText(entry)}`] : [])].join("&")}`;
}

// {state, entry} of the address; null where it holds no sketch.
export function readAddress(classes) {
  const parts = Object.fromEntries(location.hash.slice(1).replaceAll(/%3B/gi, ";").replaceAll(/%2C/gi, ",").split("&").map((part) => [part.slice(0, 1), part.slice(2)]));
  if (!parts.p) return null;
  const rows = parts.p.split(";").map(numbersOf);
  const width = rows[0].length;
  const [asked, least, reach] = (parts.l ?? "").split(",");
  const [line, drawn] = (parts.o ?? "").split(",");
  if (![2, 3].includes(width) || !rows.every((row) => row.length === width && areFinite(row))) return null;
  const ranges = parts.f ? numbersOf(parts.f) : null;
  if (ranges && !(width === 2 && ranges.length === 2 && areFinite(ranges) && areSound(rows, ranges))) return null;
  const region = boxIn(parts.b), held = boxIn(parts.c), isArea = held && held[0].every((x, k) => x < held[1][k]);
  const state = { ranges, region: ranges ? null : region, obstacle: isArea && !ranges && turnsFully({ class: asked }) ? held : null, points: rows.map((row) => row.slice(0, 2)), angles: width === 3 ? rows.map((row) => inTurn(row[2])) : null, closed: line === "closed", stroke: drawn === "stroke", ...(classes.includes(asked) ? { class: asked } : {}),
    ...(Number.isFinite(Number(least)) && least ? { least: Number(least) } : {}), ...(Number(reach) > 0 ? { reach: Number(reach) } : {}) };
  const entry = parts.d ? (ranges ? generatorOf : designOf)(parts.d, rows) : null;
  return { state, entry: entry && (ranges || isFor(state, entry)) ? entry : null };
}
