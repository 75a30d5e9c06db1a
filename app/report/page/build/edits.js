// What a hand changes of a mechanism: every edit gives another state, or null where it is none. A spot is what a hand points
// at: { joint }, { slider } or { load } by name, { link, at } on the body of a link, or { at }, a free place of the sheet.

import { RADIANS } from "../sampling.js";
import { canDrive, directionOf, FRAME, freshName, GRAVITY, isBlock, isFixed, isFree, isSound, jointOf, jointsOn, linkOf, linksOfLoad, loadNames, loadOf, MOST, pinOf, slidersOn } from "./model.js";

const within = (state) => (Object.entries(MOST).every(([key, most]) => state[key].length <= most) ? state : null);
const withJoint = (state, name, change) => ({ ...state, joints: state.joints.map((joint) => (joint.name === name ? { ...joint, ...change(joint) } : joint)) });
const withLink = (state, name, mass = 0) => ({ ...state, links: [...state.links, { name, mass }] });
const withPin = (state, at, of) => { const name = freshName(state); return { name, state: { ...state, joints: [...state.joints, { name, at, of }] } }; };

// Where a spot is.
export const placeOfSpot = (state, { joint, at }) => (joint === undefined ? at : jointOf(state, joint).at);

// The bodies on which a spot is.
const bodiesAt = (state, { joint, link }) => (joint !== undefined ? jointOf(state, joint).of : link !== undefined ? [link] : []);

// A joint of `link` at a spot: the one that is there, or a new one, which the link that is there has in common with it.
function landed(state, spot, link) {
  const { joint: name } = spot;
  if (name !== undefined) return { name, state: withJoint(state, name, ({ of }) => ({ of: [...of, link] })) };
  return withPin(state, spot.at, [...bodiesAt(state, spot), link]);
}

const isPlace = (spot) => spot.joint !== undefined || spot.at !== undefined;

// A link from spot to spot; none between two joints of one body.
export function addLink(state, from, to) {
  if (!isPlace(from) || !isPlace(to)) return null;
  const bodies = bodiesAt(state, from), [p, q] = [from, to].map((spot) => placeOfSpot(state, spot));
  if (bodiesAt(state, to).some((body) => bodies.includes(body)) || (p[0] === q[0] && p[1] === q[1])) return null;
  const name = freshName(state, "L");
  const first = landed(withLink(state, name), from, name).state;
  return within(landed(first, to, name).state);
}

const always = ({ on, force, torque }) => (force ? { on, force } : { on, torque });

// Of loads those on what a state has, but not at its fixed pivots; windows end with the links that they follow.
function loadsLeft(state, loads) {
  const left = loads.filter(({ on, force }) => (force ? state.joints.some((joint) => joint.name === on && !isFixed(joint)) : linkOf(state, on) !== undefined));
  return left.map((load) => (load.window && !linksOfLoad(state, load).includes(load.window.link) ? always(load) : load));
}

// What is left when names are gone: joints have links or are fixed, links have two joints or more, sliders what they slide on.
function tidied(state) {
  const links = state.links.filter(({ name }) => jointsOn(state, name).length + slidersOn(state, name).length > 1);
  const isBody = (name) => name === FRAME || links.some((link) => link.name === name);
  const joints = state.joints.map((joint) => (joint.of.every(isBody) ? joint : { ...joint, of: joint.of.filter(isBody) })).filter(({ of }) => of.length);
  const sliders = state.sliders.filter(({ block, on }) => isBody(block) && isBody(on) && joints.some(({ of }) => of.includes(block)));
  const next = { ...state, links, joints, sliders: sliders.map((slider) => guided(state, joints, slider)), driven: isBody(state.driven) && state.driven !== FRAME ? state.driven : null,
    loads: [] };
  next.loads = loadsLeft(next, state.loads);
  const isSame = ["links", "joints", "sliders"].every((key) => next[key].length === state[key].length);
  return isSame ? next : tidied(next);
}

// A slider keeps its direction when a joint that gave it is gone.
function guided(before, joints, slider) {
  const { on, along } = slider;
  if (!along || along.every((name) => joints.some((joint) => joint.name === name && joint.of.includes(on)))) return slider;
  return { ...slider, along: null, degrees: along.every((name) => jointOf(before, name)) ? directionOf(before, slider) : slider.degrees };
}

// Directions are kept before what gives them goes.
const withKeptDirections = (state, goes) => ({ ...state, sliders: state.sliders.map((slider) => (slider.along?.some(goes) ? { ...slider, along: null, degrees: directionOf(state, slider) } : slider)) });

export const removeJoint = (state, name) => tidied({ ...withKeptDirections(state, (one) => one === name), joints: state.joints.filter((joint) => joint.name !== name) });
export const removeLink = (state, name) => tidied({ ...state, links: state.links.filter((link) => link.name !== name) });
export const removeSlider = (state, name) => tidied({ ...state, sliders: state.sliders.filter((slider) => slider.name !== name) });
export const removeLoad = (state, name) => ({ ...state, loads: state.loads.filter((load) => load !== loadOf(state, name)) });

// Fixes a pin to the frame or frees it; elsewhere puts a fixed pivot.
export function putPivot(state, spot) {
  const { joint: name } = spot;
  if (name === undefined) return spot.at ? within(withPin(state, spot.at, [...bodiesAt(state, spot), FRAME]).state) : null;
  if (isFixed(jointOf(state, name))) return tidied(withJoint(state, name, ({ of }) => ({ of: of.filter((body) => body !== FRAME) })));
  return tidied(withJoint(unguided(state, name), name, ({ of }) => ({ of: [...of, FRAME] })));
}

// A joint without the sliders on the frame that it has.
function unguided(state, name) {
  const guides = state.sliders.filter(({ block, on }) => on === FRAME && jointOf(state, name).of.includes(block));
  const blocks = guides.map(({ block }) => block).filter((block) => jointsOn(state, block).length === 1);
  const left = { ...state, sliders: state.sliders.filter((slider) => !guides.includes(slider)), links: state.links.filter((link) => !blocks.includes(link.name)) };
  return withJoint(left, name, ({ of }) => ({ of: of.filter((body) => !blocks.includes(body)) }));
}

// The link on which a slider is let go.
const linkAt = (state, { link, joint }) => link ?? (joint === undefined ? undefined : jointOf(state, joint).of.find((body) => body !== FRAME && !isBlock(state, body)));

// A slider at a spot: on the link that is at another spot, along its line, or on the frame in a direction.
export function addSlider(state, from, to, degrees) {
  const on = linkAt(state, to) ?? FRAME;
  if (!isPlace(from) || (on !== FRAME && bodiesAt(state, from).includes(on))) return null;
  const isFreed = on === FRAME && from.joint !== undefined;
  const ready = isFreed ? withJoint(unguided(state, from.joint), from.joint, ({ of }) => ({ of: of.filter((body) => body !== FRAME) })) : state;
  const block = freshName(ready, "S"), landing = landed(withLink(ready, block), from, block).state;
  const along = on === FRAME ? null : lineOf(state, on, placeOfSpot(state, to));
  const slider = { name: freshName(landing, "G"), block, on, degrees, along };
  return within(tidied(aligned({ ...landing, sliders: [...landing.sliders, slider] }, slider)));
}

// The two joints of a link between which a place is, or that are nearest to it: the first is not the free end.
function lineOf(state, link, place) {
  const joints = jointsOn(state, link);
  if (joints.length < 2) return null;
  const pairs = joints.flatMap((p, i) => joints.slice(i + 1).map((q) => [p, q]));
  const far = ([p, q]) => distanceToSegment(place, p.at, q.at);
  const [p, q] = pairs.reduce((best, pair) => (far(pair) < far(best) ? pair : best));
  return (p.of.length < q.of.length ? [q, p] : [p, q]).map(({ name }) => name);
}

export function distanceToSegment(r, p, q) {
  const way = [q[0] - p[0], q[1] - p[1]], square = way[0] ** 2 + way[1] ** 2;
  const share = square > 0 ? Math.min(1, Math.max(0, ((r[0] - p[0]) * way[0] + (r[1] - p[1]) * way[1]) / square)) : 0;
  return Math.hypot(r[0] - p[0] - share * way[0], r[1] - p[1] - share * way[1]);
}

const NEARLY = 10;   // degrees by which a bar with a free end turns so that its line runs through the block's pin

// A bar that slides nearly through a pin and has a free end turns until it does.
function aligned(state, slider) {
  if (!slider.along) return state;
  const [held, free] = slider.along.map((name) => jointOf(state, name)), pin = pinOf(state, slider).at;
  const angle = (p) => Math.atan2(p[1] - held.at[1], p[0] - held.at[0]), turn = angle(pin) - angle(free.at);
  const way = Math.abs(turn - Math.PI * Math.round(turn / Math.PI)), size = Math.hypot(free.at[0] - held.at[0], free.at[1] - held.at[1]);
  if (free.of.length > 1 || way === 0 || way > NEARLY * RADIANS) return state;
  const to = angle(free.at) + turn - Math.PI * Math.round(turn / Math.PI);
  return withJoint(state, free.name, () => ({ at: [held.at[0] + size * Math.cos(to), held.at[1] + size * Math.sin(to)] }));
}

export const addPoint = (state, link, at) => within(withPin(state, at, [link]).state);
export const setDriven = (state, link) => (canDrive(state, link) ? { ...state, driven: link } : null);
const changedLink = (state, name, change) => ({ ...state, links: state.links.map((link) => (link.name === name ? { ...link, ...change } : link)) });
export const setMass = (state, name, mass) => (mass >= 0 && Number.isFinite(mass) ? changedLink(state, name, { mass }) : null);
// Null: as of mass that is spread evenly.
export const setCentre = (state, name, centre) => changedLink(state, name, { centre });
export const setInertia = (state, name, inertia) => (inertia === null || inertia >= 0 ? changedLink(state, name, { inertia }) : null);
export const setDegrees = (state, name, degrees) => ({ ...state, sliders: state.sliders.map((slider) => (slider.name === name ? { ...slider, degrees, along: null } : slider)) });
export const setWeighs = (state, weighs) => ({ ...state, gravity: weighs ? state.gravity ?? GRAVITY : null });
export const setRate = (state, rate) => ({ ...state, ...rate });

// Another value of a load, or a new one on what has none; null: none.
function withLoad(state, name, value) {
  const own = loadOf(state, name);
  if (!value) return removeLoad(state, name);
  return within({ ...state, loads: own ? state.loads.map((load) => (load === own ? { ...load, ...value } : load)) : [...state.loads, { on: name, ...value }] });
}

// A force of the name, or at the joint of the name; a torque on a link. None of no size.
export const setLoad = (state, name, force) => (isFixed(jointOf(state, loadOf(state, name)?.on ?? name)) ? null : withLoad(state, name, force.some((x) => x !== 0) ? { force } : null));
export const setTorque = (state, name, torque) => withLoad(state, name, torque === 0 ? null : { torque });

// When a load acts; null: always.
export const setWindow = (state, name, window) => ({ ...state, loads: state.loads.map((load, i) => (loadNames(state)[i] !== name ? load : window ? { ...load, window } : always(load))) });

export const moveJoint = (state, name, at) => withJoint(state, name, () => ({ at }));

// All joints of a link by the same way, and its centre of mass.
export function moveLink(state, link, way) {
  const by = (place) => place.map((x, k) => x + way[k]), moved = { ...state, joints: state.joints.map((joint) => (joint.of.includes(link) ? { ...joint, at: by(joint.at) } : joint)) };
  const { centre } = linkOf(state, link);
  return centre ? setCentre(moved, link, by(centre)) : moved;
}

// Two pins become one; not those of one link.
export function mergeJoints(state, name, into) {
  const [gone, stays] = [name, into].map((one) => jointOf(state, one));
  if (gone === stays || gone.of.some((body) => body !== FRAME && stays.of.includes(body))) return null;
  const merged = withJoint(state, into, ({ of }) => ({ of: [...new Set([...of, ...gone.of])] }));
  const renamed = (one) => (one === name ? into : one);
  const next = { ...merged, joints: merged.joints.filter((joint) => joint.name !== name), sliders: merged.sliders.map((slider) => (slider.along ? { ...slider, along: slider.along.map(renamed) } : slider)),
    loads: [] };
  next.loads = loadsLeft(next, state.loads);
  return isSound(next) ? next : null;
}

// Another name of a joint or a link.
export function rename(state, old, name) {
  if (!isFree(state, name)) return null;
  const to = (one) => (one === old ? name : one);
  const named = (list) => list.map((one) => ({ ...one, name: to(one.name) }));
  return { ...state, joints: named(state.joints).map((joint) => ({ ...joint, of: joint.of.map(to) })), links: named(state.links), driven: to(state.driven),
    sliders: named(state.sliders).map((slider) => ({ ...slider, block: to(slider.block), on: to(slider.on), along: slider.along?.map(to) ?? null })),
    loads: state.loads.map((load) => ({ ...load, on: to(load.on), ...(load.window ? { window: { ...load.window, link: to(load.window.link) } } : {}) })) };
}
