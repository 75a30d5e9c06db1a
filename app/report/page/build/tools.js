// What a hand does with each tool, from spot to spot of a mechanism.

import { addLink, addPoint, addSlider, placeOfSpot, putPivot, removeSlider, setDriven, setLoad, setTorque } from "./edits.js";
import { FORCE_SCALE } from "./hits.js";
import { canDrive, FRAME, isBlock, isFixed, jointOf, loadOf, sliderOf } from "./model.js";
import { RADIANS } from "../sampling.js";

const RIGHT = 15, NEARLY_RIGHT = 4;   // degrees: directions near multiples of the first become such

function degreesTo(p, q) {
  const degrees = Math.atan2(q[1] - p[1], q[0] - p[0]) / RADIANS, right = RIGHT * Math.round(degrees / RIGHT);
  return Math.abs(degrees - right) <= NEARLY_RIGHT ? right : Math.round(degrees);
}

const isAt = (spot) => spot.joint !== undefined || spot.at !== undefined;

// The link that a spot is on: of a joint the last that is no block.
const linkAtSpot = (state, { joint, link }) => link ?? (joint === undefined ? undefined : jointOf(state, joint).of.findLast((name) => name !== FRAME && !isBlock(state, name)));

function slide(state, from, to) {
  const [p, q] = [from, to].map((spot) => placeOfSpot(state, spot));
  return isAt(from) && isAt(to) && (p[0] !== q[0] || p[1] !== q[1]) ? addSlider(state, from, to, degreesTo(p, q)) : null;
}

// A click on a slider, or on its pin, takes it away.
function unslide(state, { joint, slider }) {
  const own = state.sliders.find(({ name, block }) => name === slider || (joint !== undefined && jointOf(state, joint).of.includes(block)));
  return own ? removeSlider(state, own.name) : null;
}

function pull(state, from, to) {
  const on = from.joint ?? (from.load === undefined ? undefined : loadOf(state, from.load).on);
  if (jointOf(state, on) === undefined || to.at === undefined && to.joint === undefined || isFixed(jointOf(state, on))) return null;
  const p = jointOf(state, on).at, q = placeOfSpot(state, to);
  return setLoad(state, from.load ?? on, p.map((x, k) => Math.round(FORCE_SCALE * (q[k] - x))));
}

// A first torque on the link at a spot, counter-clockwise; then the other way round.
const twist = (state, { link }) => (link === undefined ? null : setTorque(state, link, -(loadOf(state, link)?.torque ?? -1)));

function trace(state, from, to) {
  const link = linkAtSpot(state, from);
  return link === undefined || to.at === undefined ? null : addPoint(state, link, to.at);
}

// The link at a spot drives, or of those that are joined there the first that can.
function drivenBy(state, { joint, link, slider }) {
  const links = joint !== undefined ? jointOf(state, joint).of : slider !== undefined ? [sliderOf(state, slider).block] : [link];
  const driver = links.find((name) => name !== undefined && canDrive(state, name));
  return driver === undefined ? null : setDriven(state, driver);
}

// drag(state, from, to) and click(state, spot) give another state, or null; `ends`: whether two clicks do what a drag does.
export const TOOLS = {
  move: { key: "v" },
  link: { key: "l", ends: true, drag: addLink },
  pivot: { key: "f", click: putPivot },
  slider: { key: "s", ends: true, drag: slide, click: unslide },
  point: { key: "p", drag: trace, click: (state, spot) => (spot.link === undefined ? null : addPoint(state, spot.link, spot.at)) },
  drive: { key: "d", click: drivenBy },
  load: { key: "o", ends: true, drag: pull, click: twist },
};
