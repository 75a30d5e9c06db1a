// The mechanism of a file that the page was written with: a problem by its joints as drawn, and how many millimetres a unit of it is.

import { spreadOf } from "./chain.js";
import { drivesBySlide, EMPTY, FRAME, freshName, isFixed, isSound } from "./model.js";

const linksNamed = (joints) => [...new Set(joints.flatMap(({ of }) => of))].filter((name) => name !== FRAME);

// Of the two links of a slide the slider, no link twice: the one with fewer joints and slides, but with a pin, of equals one without a fixed pivot.
function slidersOf(pins, slides) {
  const onLink = (link) => pins.filter(({ of }) => of.includes(link)), countOf = (link) => onLink(link).length + slides.filter(({ of }) => of.includes(link)).length;
  const weight = (link) => (link === FRAME || onLink(link).length === 0 ? Infinity : countOf(link) + (onLink(link).some(isFixed) ? 0.5 : 0));
  const sliders = [];
  for (const { name, of, direction_deg: degrees } of slides) {
    const [block, on] = [...of].sort((a, b) => weight(a) - weight(b) || 0), isTaken = sliders.some((one) => one.block === block);
    sliders.push({ name, block: isTaken ? on : block, on: isTaken ? block : on, degrees, along: null });
  }
  return sliders;
}

// The line of a bar on which a block slides goes by two of its joints, where it is theirs, in the sense of the file.
function byJoints(pins, slider) {
  const at = pins.find(({ of }) => of.includes(slider.block))?.at, angle = (slider.degrees * Math.PI) / 180, way = [Math.cos(angle), Math.sin(angle)];
  const along = (p, q) => (q[0] - p[0]) * way[0] + (q[1] - p[1]) * way[1];
  const isOn = (p, q) => Math.abs((q[0] - p[0]) * way[1] - (q[1] - p[1]) * way[0]) <= 1e-9 * Math.hypot(q[0] - p[0], q[1] - p[1]);
  const own = slider.on === FRAME ? [] : pins.filter(({ of, at: place }) => of.includes(slider.on) && (!at || isOn(at, place)));
  if (own.length < 2) return slider;
  const [p, q] = along(own[0].at, own[1].at) > 0 ? own : [own[1], own[0]];
  return { ...slider, along: [p.name, q.name] };
}

const isNear = (p, q, size) => Math.hypot(p[0] - q[0], p[1] - q[1]) <= 1e-9 * size;
const extentOf = (joints) => Math.max(...joints.flatMap(({ at }) => at.map(Math.abs)), 1e-9);

// The masses of a file where they are; those of blocks at their pins go without places.
function withMasses(state, link, centres, millimetres) {
  const given = new Map(link.map((one) => [one.name, one])), size = extentOf(state.joints);
  const massOf = ({ name }) => {
    const { mass = 0, inertia = 0 } = given.get(name) ?? {};
    if (mass === 0 && inertia === 0) return { name, mass };
    const centre = centres[name].map((x) => millimetres * x), even = spreadOf(state, name);
    const isEven = even && even.square === 0 && inertia === 0 && isNear(centre, even.centre, size);
    return isEven ? { name, mass } : { name, mass, centre, inertia };
  };
  return { ...state, links: state.links.map(massOf) };
}

// Where a force acts on a link: at a joint of it, or at a new point.
function withPointAt(state, link, at) {
  const there = state.joints.find((joint) => joint.of.includes(link) && !isFixed(joint) && isNear(joint.at, at, extentOf(state.joints)));
  if (there) return { state, on: there.name };
  const name = freshName(state);
  return { state: { ...state, joints: [...state.joints, { name, at, of: [link] }] }, on: name };
}

// A load of a file: its force at a joint, its torque on the link.
function withGivenLoad(state, { force = [0, 0], torque = 0, when = "always", stroke = null }, { body, at }) {
  const window = when === "always" && stroke === null ? {} : { window: { link: body, when, stroke } };
  const turned = torque ? { ...state, loads: [...state.loads, { on: body, torque, ...window }] } : state;
  if (force.every((x) => x === 0)) return turned;
  const { state: ready, on } = withPointAt(turned, body, at);
  const same = window.window ? undefined : ready.loads.find((load) => load.on === on && load.force && !load.window);
  const others = ready.loads.filter((load) => load !== same), sum = force.map((x, k) => x + (same?.force[k] ?? 0));
  return { ...ready, loads: sum.some((x) => x !== 0) ? [...others, { on, force: sum, ...window }] : others };
}

const isAlong = (when) => Array.isArray(when);

function withLoads(state, load, places, millimetres, slides) {
  const scaled = (one) => (slides && isAlong(one.when) ? { ...one, when: one.when.map((x) => millimetres * x) } : one);
  return load.reduce((next, one, i) => withGivenLoad(next, scaled(one), { body: places[i].body, at: places[i].at.map((x) => millimetres * x) }), state);
}

// How the drive moves; of a slider in millimetres.
function rateOf({ speed = 1, acceleration = 0 }, scale) { return { speed: scale * speed, acceleration: scale * acceleration }; }

// Whether it goes through a whole turn.
const isTurn = ({ start_deg: start = 0, end_deg: end = start + 360 }) => Math.abs(end - start - 360) < 1e-9;

// {state, isWhole}: whether all of the file is on the page; null where the page cannot hold the mechanism.
export function stateOfProblem({ problem: { mechanism, link = [], load = [], gravity = null, drive = {} }, places, millimetres, left_out: leftOut = false }) {
  const pins = mechanism.joint.filter(({ at }) => at).map(({ name, at, of }) => ({ name, at: at.map((x) => millimetres * x), of }));
  const slides = mechanism.joint.filter(({ at }) => !at), falls = gravity?.some((x) => x !== 0) ? gravity.map((x) => millimetres * x) : null;
  const bare = { ...EMPTY, joints: pins, sliders: slidersOf(pins, slides).map((slider) => byJoints(pins, slider)), links: linksNamed(mechanism.joint).map((name) => ({ name, mass: 0 })), driven: mechanism.driven, gravity: falls };
  const isSlid = drivesBySlide(bare), heavy = withMasses(bare, link, places.centres, millimetres);
  const state = { ...withLoads(heavy, load, places.loads, millimetres, isSlid), ...rateOf(drive, isSlid ? millimetres : 1) };
  return isSound(state) ? { state, isWhole: !leftOut && !isSlid && isTurn(drive) } : null;
}
