// The sketch and a design of it at the end of the address: #p=x,y;x,y&…, each part by a letter; a pose is x,y,degrees; where there
// are ranges of a function a point is a pair of its angles, and x=expression,from,to what was typed for them.

import { LANGUAGES } from "../words.js";
import { withoutRounding } from "../rounding.js";
import { turnsFully } from "./boxes.js";
import { generatorOf, generatorText } from "./generator_text.js";
import { areSound } from "./pairs.js";
import { ANY_SPEED, isSlider } from "./question.js";
import { inTurn } from "./posed.js";
import { isFourBarText, sliderOf, sliderText } from "./slider_text.js";
import { FARTHEST } from "./stroke.js";

const PLACES_OF_LINE = 3;
const LONGEST_EXPRESSION = 400;
const LEAST = [0, 70], REACH = [1, 10], EVEN = [5, ANY_SPEED];

const numbersOf = (text) => text.split(",").map(Number);
const areFinite = (numbers) => numbers.every(Number.isFinite);
const arePlaces = (numbers) => numbers.every((x) => Math.abs(x) <= FARTHEST);
const isWithin = (text, [low, high]) => text !== "" && Number(text) >= low && Number(text) <= high;

// A design's numbers in the order of the address; its words stand behind them.
function designText({ mechanism: m, crank_deg: cranks, rms, max, class: name, transmission_acute_min_deg: least, body_angle_deg: body, angle_max_deg: turned, direction_deg: direction, speed_variation: speed }) {
  const size = Math.max(m.crank, m.coupler, m.rocker);
  const lengths = [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point].map((x) => withoutRounding(x, size));
  const more = body === undefined ? direction === undefined ? [] : [direction, speed] : [body, turned];
  return [[...lengths, rms, max, least, ...more].join(","), m.assembly, name, cranks.map((x) => withoutRounding(x, 360)).join(",")].join(";");
}

function designOf(text, straight) {
  const [numbers, assembly, name, cranks = ""] = text.split(";");
  const [ax, ay, dx, dy, crank, coupler, rocker, u, v, rms, max, least, ...more] = numbersOf(numbers);
  const names = straight ? ["direction_deg", "speed_variation"] : ["body_angle_deg", "angle_max_deg"];
  const entry = { mechanism: { type: "four-bar", fixed_pivots: [[ax, ay], [dx, dy]], crank, coupler, rocker, coupler_point: [u, v], assembly },
    crank_deg: numbersOf(cranks), rms, max, class: name, transmission_acute_min_deg: least, ...(more.length === 2 ? Object.fromEntries(names.map((name, i) => [name, more[i]])) : {}) };
  const isSound = arePlaces([...numbersOf(numbers), ...entry.crank_deg]) && Math.min(crank, coupler, rocker) > 0;
  return isSound && ["open", "crossed"].includes(assembly) && /^[a-z-]+$/.test(name) ? entry : null;
}

// How a design stands in the address, by the kind of its drawing.
const textOf = ({ ranges }, entry) => (ranges ? generatorText : isSlider(entry) ? sliderText : designText)(entry);
const entryOf = ({ ranges, slides, both, straight }, text, rows) => (ranges ? generatorOf(text, rows) : slides && !(both && isFourBarText(text)) ? sliderOf(text) : designOf(text, straight));

// Whether a design is one for as many targets, of the same kind; generators are for any pairs, and a line has three places.
const isFor = ({ points, angles, straight }, { crank_deg: cranks, body_angle_deg: body, direction_deg: direction }) => cranks.length === (straight ? PLACES_OF_LINE : points.length)
  && (body === undefined) === (angles === null) && (direction !== undefined) === straight;

// A box in the address, by a letter.
const boxPart = (letter, box) => (box ? [`${letter}=${box.flat().join(",")}`] : []);

function boxIn(text = "") {
  const bounds = numbersOf(text), [x0, y0, x1, y1] = bounds;
  return bounds.length === 4 && arePlaces(bounds) && x0 <= x1 && y0 <= y1 ? [[x0, y0], [x1, y1]] : null;
}

const typedPart = (typed) => (typed ? [`x=${encodeURIComponent(typed.text)},${typed.domain.join(",")}`] : []);

// An expression that was typed, and from where to where x goes; null where the text says none.
function typedIn(text = "") {
  const parts = text.split(","), domain = parts.slice(-2).map(Number);
  try {
    const written = decodeURIComponent(parts.slice(0, -2).join(","));
    return written !== "" && written.length <= LONGEST_EXPRESSION && areFinite(domain) && domain[0] < domain[1] ? { text: written, domain } : null;
  } catch {
    return null;   // a damaged escape
  }
}

// What stands behind the # for a state and, perhaps, the entry of a design.
export function addressOf(state, entry) {
  const { points, angles, ranges, typed, closed, stroke, slides, both, straight, class: asked, least, reach, even, region, obstacle } = state;
  const parts = [...location.hash.slice(1).split("&").filter((part) => LANGUAGES.includes(part)), `p=${points.map((p, i) => [...p, ...(angles ? [angles[i]] : [])].join(",")).join(";")}`,
    `o=${[closed ? "closed" : "open", stroke ? "stroke" : "points", ...(slides ? [both ? "both" : "slider"] : straight ? ["line"] : [])].join(",")}`, `l=${[asked, least, reach, ...(straight && even < ANY_SPEED ? [even] : [])].join(",")}`, ...(ranges ? [`f=${ranges.join(",")}`] : []), ...typedPart(typed), ...boxPart("b", region), ...boxPart("c", obstacle)];
  return `#${[...parts, ...(entry ? [`d=${textOf(state, entry)}`] : [])].join("&")}`;
}

// {state, entry} of the address; null where it holds no sketch.
export function readAddress(classes) {
  const parts = Object.fromEntries(location.hash.slice(1).replaceAll(/%3B/gi, ";").replaceAll(/%2C/gi, ",").split("&").map((part) => [part.slice(0, 1), part.slice(2)]));
  if (!parts.p) return null;
  const rows = parts.p.split(";").map(numbersOf);
  const width = rows[0].length;
  const [asked, least, reach, even = ""] = (parts.l ?? "").split(",");
  const [line, drawn, by] = (parts.o ?? "").split(",");
  if (![2, 3].includes(width) || !rows.every((row) => row.length === width && arePlaces(row))) return null;
  const ranges = parts.f ? numbersOf(parts.f) : null;
  if (ranges && !(width === 2 && ranges.length === 2 && areFinite(ranges) && areSound(rows, ranges))) return null;
  const slides = ["slider", "both"].includes(by) && width === 2 && !ranges;
  const straight = by === "line" && width === 2 && rows.length <= 2 && !ranges;
  const region = boxIn(parts.b), held = boxIn(parts.c), isArea = held && held[0].every((x, k) => x < held[1][k]);
  const state = { ranges, typed: ranges && typedIn(parts.x), slides, both: slides && by === "both", straight, region: ranges ? null : region, obstacle: isArea && !ranges && !slides && !straight && turnsFully({ class: asked }) ? held : null, points: rows.map((row) => row.slice(0, 2)), angles: width === 3 ? rows.map((row) => inTurn(row[2])) : null, closed: line === "closed", stroke: drawn === "stroke", ...(classes.includes(asked) && !slides ? { class: asked } : {}),
    ...(isWithin(least, LEAST) ? { least: Number(least) } : {}), ...(isWithin(reach, REACH) ? { reach: Number(reach) } : {}), ...(straight && isWithin(even, EVEN) ? { even: Number(even) } : {}) };
  const entry = parts.d ? entryOf(state, parts.d, rows) : null;
  return { state, entry: entry && (ranges || isFor(state, entry)) ? entry : null };
}
