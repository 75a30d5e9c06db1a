// A mechanism at the end of the address, each part by a letter: #j=name,x,y,links;…&s=…&l=…, see `partsOf`.

import { LANGUAGES } from "../words.js";
import { withoutRounding } from "../rounding.js";
import { EMPTY, FRAME, isName, isSound, MOST } from "./model.js";

const TOGETHER = "~";
const SIZE = 1000;           // of the places on the sheet, for their digits
const LONGEST = 20000;

const shortly = (x) => withoutRounding(x, SIZE);

const PARTS = {
  j: ({ joints }) => joints.map(({ name, at, of }) => [name, ...at.map(shortly), of.join(TOGETHER)]),
  s: ({ sliders }) => sliders.map(({ name, block, on, degrees, along }) => [name, block, on, shortly(degrees), ...(along ? [along.join(TOGETHER)] : [])]),
  l: ({ links }) => links.map(({ name, mass }) => [name, ...(mass ? [mass] : [])]),
  f: ({ loads }) => loads.map(({ on, force }) => [on, ...force]),
};

const rowText = (row) => row.map((part) => encodeURIComponent(part)).join(",");

// What stands behind the # for a state; the parts of the address that are a language stay.
export function addressOfState(state) {
  const languages = location.hash.slice(1).split("&").filter((part) => LANGUAGES.includes(part));
  const lists = Object.entries(PARTS).map(([key, rows]) => [key, rows(state).map(rowText).join(";")]).filter(([, text]) => text);
  const parts = [...lists, ...(state.driven ? [["d", encodeURIComponent(state.driven)]] : []), ...(state.weighs ? [["g", "1"]] : [])].map((part) => part.join("="));
  return `#${[...languages, ...parts].join("&")}`;
}

const isNumber = (text) => text !== undefined && /^-?\d+(\.\d+)?(e[+-]?\d+)?$/.test(text);
const namesOf = (text = "") => text.split(TOGETHER);

// Of each part an object from the texts of a row; undefined of a row that is damaged.
const READERS = {
  joints: ([name, x, y, of]) => (isNumber(x) && isNumber(y) && of ? { name, at: [Number(x), Number(y)], of: namesOf(of) } : undefined),
  sliders: ([name, block, on, degrees, along]) => (isNumber(degrees) ? { name, block, on, degrees: Number(degrees), along: along ? namesOf(along) : null } : undefined),
  links: ([name, mass = "0"]) => (isNumber(mass) ? { name, mass: Number(mass) } : undefined),
  loads: ([on, x, y]) => (isNumber(x) && isNumber(y) ? { on, force: [Number(x), Number(y)] } : undefined),
};

const rowsOf = (text, read) => (text ? text.split(";").map((row) => read(row.split(",").map((part) => decodeURIComponent(part)))) : []);

function readParts(hash) {
  const parts = Object.fromEntries(hash.replaceAll(/%3B/gi, ";").replaceAll(/%2C/gi, ",").replaceAll(/%7E/gi, TOGETHER).split("&").map((part) => [part.slice(0, 1), part.slice(2)]));
  const state = { ...EMPTY, driven: parts.d ? decodeURIComponent(parts.d) : null, weighs: parts.g === "1" };
  for (const [key, letter] of [["joints", "j"], ["sliders", "s"], ["links", "l"], ["loads", "f"]]) {
    if ((parts[letter] ?? "").split(";").length > MOST[key]) return null;
    state[key] = rowsOf(parts[letter], READERS[key]);
  }
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
