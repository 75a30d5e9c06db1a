// The problem of a mechanism that was built: the file of joints as drawn that `cognate analyze` reads.

import { tableWithoutRounding } from "../rounding.js";
import { evenMass } from "./even_mass.js";
import { hullOf } from "./hits.js";
import { directionOf, driverOf, FRAME, isBlock, jointOf, jointsOn, linkOf, slidersOn } from "./model.js";

const MILLI = 1e-3;

const turned = (angle) => angle - 360 * Math.round(angle / 360);

// Points that the file has beside the joints of a state, where what it says can be said by points of a link alone.
class MorePoints {
  constructor(state) { Object.assign(this, { state, points: [] }); }

  // A point of one link at a place, by its name.
  on(link, at) {
    const isTaken = (name) => [this.state.joints, this.state.links, this.state.sliders, this.points].some((list) => list.some((one) => one.name === name));
    let count = 1;
    while (isTaken(`${link}.${count}`)) count += 1;
    this.points.push({ name: `${link}.${count}`, at, of: [link] });
    return this.points.at(-1);
  }
}

function mechanismTable(state, more) {
  const pins = [...state.joints.filter(({ of }) => of.some((name) => name !== FRAME)), ...more.points].map(({ name, at, of }) => ({ name, at, of }));
  const slides = state.sliders.map((slider) => ({ name: slider.name, of: [slider.block, slider.on], direction_deg: turned(directionOf(state, slider)) }));
  return tableWithoutRounding({ type: "chain", driven: driverOf(state), joint: [...pins, ...slides] });
}

// A place in axes from p towards q, and their distance.
function inAxes(p, q, at) {
  const way = q.map((x, k) => x - p[k]), size = Math.hypot(...way), from = at.map((x, k) => x - p[k]);
  return { size, own: size > 0 ? [from[0] * way[0] + from[1] * way[1], way[0] * from[1] - way[1] * from[0]].map((x) => x / size) : [0, 0] };
}

// Where the mass of a link is, and the moment of inertia about that place over the mass, in mm²: spread evenly over it, that of a block
// at its pin.
export function spreadOf(state, name) {
  const places = jointsOn(state, name).map(({ at }) => at);
  if (places.length === 0) return null;
  return isBlock(state, name) || places.length < 2 ? { centre: places[0], square: 0 } : evenMass(hullOf(places));
}

// Inertia is in kg m², lengths are in mm.
function linkTable(state, link, more) {
  const { name, mass, centre = null, inertia = null } = link, even = spreadOf(state, name), [p, q] = jointsOn(state, name);
  const moment = inertia ?? mass * (even?.square ?? 0) * MILLI * MILLI, massive = { ...(mass ? { mass } : {}), ...(moment ? { inertia: moment } : {}) };
  if (!centre && !q) return { name, ...massive, centre: [0, 0] };
  const at = centre ?? even.centre, from = p ?? more.on(name, at);
  const isThere = at.every((x, k) => x === from.at[k]), to = q ?? more.on(name, isThere ? [at[0] + 1, at[1]] : at);
  const { own, size } = inAxes(from.at, to.at, at);
  return { between: [from.name, to.name], ...massive, centre: tableWithoutRounding(own, Math.max(1, size)) };
}

// Where a load acts: on a link, or at a joint, as a point of the link that its window follows.
function placeTable(state, { on, window = null }, more) {
  if (linkOf(state, on)) return { on };
  const joint = jointOf(state, on), link = window?.link;
  if (!link || joint.of.length === 1) return { on };
  const other = jointsOn(state, link).find(({ name }) => name !== on);
  if (other) return { on: [on, other.name], at: [0, 0] };
  const isPlain = isBlock(state, link) && slidersOn(state, link).length === 1 && driverOf(state) !== link;
  return isPlain ? { on: link } : { on: more.on(link, joint.at).name };
}

function loadTable(state, load, more) {
  const { force, torque, window = null } = load, isAlways = window === null || window.when === "always";
  return { ...placeTable(state, load, more), ...(force ? { force } : { torque }), ...(isAlways ? {} : { when: window.when }), ...(window?.stroke ? { stroke: window.stroke } : {}) };
}

function driveTable({ speed, acceleration }, range) {
  const drive = { ...(speed === 1 ? {} : { speed }), ...(acceleration === 0 ? {} : { acceleration }), ...range };
  return Object.keys(drive).length ? { drive } : {};
}

// The problem of a state, its drive in the range given, if any.
export function problemOfState(state, range = null) {
  const more = new MorePoints(state), heavy = state.links.filter(({ mass, inertia }) => mass > 0 || inertia > 0);
  const link = heavy.map((one) => linkTable(state, one, more)), load = state.loads.map((one) => loadTable(state, one, more));
  return { kind: "analysis", length_unit: "mm", ...(state.gravity ? { gravity: state.gravity } : {}), mechanism: mechanismTable(state, more), ...driveTable(state, range), link, load };
}
