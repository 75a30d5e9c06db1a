// A mechanism at the end of the address, each part by a letter: #j=name,x,y,links;…&s=…&l=…, see `PARTS`. Of a row what is missing at its end or empty is
// as a hand makes it.

import { LANGUAGES } from "../words.js";
import { withoutRounding } from "../rounding.js";
import { EMPTY, FRAME, GRAVITY, isName, isSound, MOST } from "./model.js";

const TOGETHER = "~";
const SIZE = 1000;           // of the places on the sheet, for their digits
const LONGEST = 20000;

const shortly = (x) => withoutRounding(x, SIZE);

const PARTS = {
  j: ({ joints }) => joints.map(({ name, at, of }) => [name, ...at.map(shortly), of.join(TOGETHER)]),
  s: ({ sliders }) => sliders.map(({ name, block, on, degrees, along }) => [name, block, on, shortly(degrees), ...(along ? [along.join(TOGETHER)] : [])]),
  l: ({ links }) => links.map(({ name, mass, centre = null, inertia = null }) => withoutTail([name, mass || "", ...(centre ?? ["", ""]).map((x) => (x === "" ? x : shortly(x))), inertia ?? ""])),
  f: ({ loads }) => loads.filter(({ force }) => force).map(({ on, force, window }) => [on, ...force, ...windowRow(window)]),
  t: ({ loads }) => loads.filter(({ force }) => !force).map(({ on, torque, window }) => [on, torque, ...windowRow(window)]),
};

// A row without empty parts at its end.
const withoutTail = (row) => row.slice(0, row.findLastIndex((part) => part !== "") + 1);

function windowRow(window = null) {
  if (!window) return [];
  const { link, when, stroke } = window;
  return [link, Array.isArray(when) ? when.join(TOGETHER) : when, ...(stroke ? [stroke.join(TOGETHER)] : [])];
}

const isPlainGravity = (gravity) => gravity.every((x, k) => x === GRAVITY[k]);

// Parts of one value.
function singles({ driven, gravity, speed, acceleration }) {
  return [...(driven ? [["d", encodeURIComponent(driven)]] : []), ...(gravity ? [["g", isPlainGravity(gravity) ? "1" : gravity.join(",")]] : []),
    ...(speed !== 1 || acceleration !== 0 ? [["v", [speed, ...(acceleration ? [acceleration] : [])].join(",")]] : [])];
}

const rowText = (row) => row.map((part) => encodeURIComponent(part)).join(",");

// What stands behind the # for a state; the parts of the address that are a language stay.
export function addressOfState(state) {
  const languages = location.hash.slice(1).split("&").filter((part) => LANGUAGES.includes(part));
  const lists = Object.entries(PARTS).map(([key, rows]) => [key, rows(state).map(rowText).join(";")]).filter(([, text]) => text);
  const parts = [...lists, ...singles(state)].map((part) => part.join("="));
  return `#${[...languages, ...parts].join("&")}`;
}

const isNumber = (text) => text !== undefined && /^-?\d+(\.\d+)?(e[+-]?\d+)?$/.test(text);
const namesOf = (text = "") => text.split(TOGETHER);

// Of each part an object from the texts of a row; undefined of a row that is damaged.
const READERS = {
  joints: ([name, x, y, of]) => (isNumber(x) && isNumber(y) && of ? { name, at: [Number(x), Number(y)], of: namesOf(of) } : undefined),
  sliders: ([name, block, on, degrees, along]) => (isNumber(degrees) ? { name, block, on, degrees: Number(degrees), along: along ? namesOf(along) : null } : undefined),
  links: ([name, mass = "", x = "", y = "", inertia = ""]) => {
    if (![mass, x, y, inertia].every((text) => text === "" || isNumber(text)) || (x === "") !== (y === "")) return undefined;
    return { name, mass: Number(mass), ...(x === "" ? {} : { centre: [Number(x), Number(y)] }), ...(inertia === "" ? {} : { inertia: Number(inertia) }) };
  },
  forces: ([on, x, y, ...window]) => (isNumber(x) && isNumber(y) ? withWindow({ on, force: [Number(x), Number(y)] }, window) : undefined),
  torques: ([on, torque, ...window]) => (isNumber(torque) ? withWindow({ on, torque: Number(torque) }, window) : undefined),
};

// Two numbers; undefined of other texts.
function pairOf(text) {
  const parts = text.split(TOGETHER);
  return parts.length === 2 && parts.every(isNumber) ? parts.map(Number) : undefined;
}

function withWindow(load, [link, when, stroke]) {
  if (link === undefined) return load;
  const window = { link, when: when?.includes(TOGETHER) ? pairOf(when) : when, stroke: stroke === undefined ? null : pairOf(stroke) };
  return window.when === undefined || window.stroke === undefined ? undefined : { ...load, window };
}

const gravityOf = (text) => (text === undefined ? null : text === "1" ? GRAVITY : text.split(",").map((x) => (isNumber(x) ? Number(x) : NaN)));

function rateOfAddress(text = "1") {
  const [speed, acceleration = "0"] = text.split(",");
  return { speed: isNumber(speed) ? Number(speed) : NaN, acceleration: isNumber(acceleration) ? Number(acceleration) : NaN };
}

const rowsOf = (text, read) => (text ? text.split(";").map((row) => read(row.split(",").map((part) => decodeURIComponent(part)))) : []);

function readParts(hash) {
  const parts = Object.fromEntries(hash.replaceAll(/%3B/gi, ";").replaceAll(/%2C/gi, ",").replaceAll(/%7E/gi, TOGETHER).split("&").map((part) => [part.slice(0, 1), part.slice(2)]));
  const state = { ...EMPTY, driven: parts.d ? decodeURIComponent(parts.d) : null, gravity: gravityOf(parts.g), ...rateOfAddress(parts.v) };
  const lists = { joints: "j", sliders: "s", links: "l", forces: "f", torques: "t" };
  if (Object.entries(lists).some(([key, letter]) => (parts[letter] ?? "").split(";").length > (MOST[key] ?? MOST.loads))) return null;
  const [joints, sliders, links, ...loads] = Object.entries(lists).map(([key, letter]) => rowsOf(parts[letter], READERS[key]));
  Object.assign(state, { joints, sliders, links, loads: loads.flat() });
  const isWhole = [state.joints, state.sliders, state.links, state.loads].flat().every((one) => one !== undefined);
  const names = [...state.joints.flatMap(({ of }) => of), ...state.sliders.map(({ on }) => on)];
  return isWhole && names.every((name) => name === FRAME || isName(name)) && isSound(state) ? state : null;
}

// The state of the address; null where it holds none, undefined where what it holds is none.
export function readState() {
  const hash = location.hash.slice(1);
  if (!/(^|&)j=/.test(hash)) return /(^|&)[a-z]=/.test(hash) ? undefined : null;
  if (hash.length > LONGEST) return undefined;
  try {
    return readParts(hash) ?? undefined;
  } catch {
    return undefined;   // no text in percent signs
  }
}
