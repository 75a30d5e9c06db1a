// The mechanism of a file that the page was written with: a problem by its joints as drawn, and how many millimetres a unit of it is.

import { EMPTY, FRAME, isFixed, isSound, jointOf } from "./model.js";

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

// The line of a bar on which a block slides goes by two of its joints, where it is theirs.
function byJoints(pins, slider) {
  const at = pins.find(({ of }) => of.includes(slider.block))?.at, angle = (slider.degrees * Math.PI) / 180;
  const isOn = (p, q) => Math.abs((q[0] - p[0]) * Math.sin(angle) - (q[1] - p[1]) * Math.cos(angle)) <= 1e-9 * Math.hypot(q[0] - p[0], q[1] - p[1]);
  const own = slider.on === FRAME ? [] : pins.filter(({ of, at: place }) => of.includes(slider.on) && (!at || isOn(at, place)));
  return own.length > 1 ? { ...slider, along: own.slice(0, 2).map(({ name }) => name) } : slider;
}

// A force at a point that acts always.
const isPlain = (pins, { on, force, torque = 0, when = "always", stroke = null }) => !torque && when === "always" && stroke === null && Array.isArray(force) && pins.some(({ name }) => name === on);

// A whole turn at the speed of the page.
const isPlainDrive = ({ speed = 1, acceleration = 0, start_deg: start = 0, end_deg: end = start + 360 }) => speed === 1 && acceleration === 0 && Math.abs(end - start - 360) < 1e-9;

// One force at each point.
function summed(forces) {
  const sums = new Map();
  for (const { on, force } of forces) sums.set(on, (sums.get(on) ?? [0, 0]).map((x, k) => x + force[k]));
  return [...sums].map(([on, force]) => ({ on, force }));
}

// {state, isWhole}: whether all of the file is on the page; null where the page cannot hold the mechanism.
export function stateOfProblem({ problem: { mechanism, link = [], load = [], gravity = null, drive = {} }, millimetres, left_out: leftOut = false }) {
  const pins = mechanism.joint.filter(({ at }) => at).map(({ name, at, of }) => ({ name, at: at.map((x) => millimetres * x), of }));
  const slides = mechanism.joint.filter(({ at }) => !at), forces = load.filter((one) => isPlain(pins, one));
  const massOf = (name) => link.find((one) => (one.name ?? one.between?.[0]) === name)?.mass ?? 0;
  const state = { ...EMPTY, joints: pins, sliders: slidersOf(pins, slides).map((slider) => byJoints(pins, slider)), links: linksNamed(mechanism.joint).map((name) => ({ name, mass: massOf(name) })),
    driven: mechanism.driven, loads: summed(forces), weighs: (gravity?.[1] ?? 0) < 0 };
  const isWhole = !leftOut && isPlainDrive(drive) && link.length === 0 && forces.length === load.length;
  return isSound(state) && forces.every(({ on }) => jointOf(state, on)) ? { state, isWhole } : null;
}
