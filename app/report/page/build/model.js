// A mechanism as it is built by hand: joints, sliders and links where they are drawn. States are plain values that nothing
// changes; every edit gives another.
//   joints  [{ name, at, of }]: `of` names the links that a pin joins, among them perhaps the frame; a joint of one link is a point of it
//   sliders [{ name, block, on, degrees, along }]: the link `block` slides on a link or the frame, in the position drawn in the direction
//           `degrees`; `along` names the two joints of `on` that give the direction instead, or is null
//   links   [{ name, mass }], in kg, with a `centre` of mass on the sheet and an `inertia` about it in kg m² where it is not spread evenly
//   loads   [{ on, force }] at joints in N, or [{ on, torque }] on links in N m, each with a `window` in which it acts, where it does not always:
//           { link, when, stroke }, `when` of "always", "advance" or "return" of the link, or [from, to] of the drive, `stroke` null or the
//           part [from, to] of that of the link
//   driven  the name of a link or null, speed and acceleration of the drive: rad or mm, and s; gravity: in mm/s², or null

import { RADIANS } from "../sampling.js";

export const FRAME = "frame";
export const EMPTY = { joints: [], sliders: [], links: [], driven: null, loads: [], speed: 1, acceleration: 0, gravity: null };
export const GRAVITY = [0, -9806.65];   // mm/s²
const FASTEST = 1e9, MOST_FORCE = 1e12;
export const MOST = { joints: 60, sliders: 20, links: 60, loads: 20 };

export const jointOf = ({ joints }, name) => joints.find((joint) => joint.name === name);
export const linkOf = ({ links }, name) => links.find((link) => link.name === name);
export const sliderOf = ({ sliders }, name) => sliders.find((slider) => slider.name === name);
export const jointsOn = ({ joints }, link) => joints.filter(({ of }) => of.includes(link));
export const slidersOn = ({ sliders }, link) => sliders.filter(({ block, on }) => block === link || on === link);
// Whether a link is nothing but the block of a slider on its pin.
export const isBlock = (state, link) => state.sliders.some(({ block }) => block === link) && jointsOn(state, link).length === 1;
export const isFixed = ({ of }) => of.includes(FRAME);

// The pin at which a slider's block sits, and the direction in which it slides in the position drawn.
export const pinOf = (state, { block }) => jointsOn(state, block)[0];

export function directionOf(state, { along, degrees }) {
  if (!along) return degrees;
  const [p, q] = along.map((name) => jointOf(state, name).at);
  return Math.atan2(q[1] - p[1], q[0] - p[0]) / RADIANS;
}

// How many joints a link has with the frame.
const groundings = (state, link) => jointsOn(state, link).filter(isFixed).length + state.sliders.filter(({ block, on }) => block === link && on === FRAME).length;

// Whether a link can drive.
export const canDrive = (state, link) => link !== FRAME && groundings(state, link) === 1;

// The link that drives: the one chosen, as long as it can, else the first with a fixed pivot.
export function driverOf(state) {
  if (state.driven && canDrive(state, state.driven)) return state.driven;
  return state.links.find(({ name }) => canDrive(state, name) && !isBlock(state, name))?.name ?? null;
}

// Whether a slider drives: its coordinate is 0 in the position drawn, an angle that of the drawing.
export const drivesBySlide = (state) => state.sliders.some(({ block, on }) => on === FRAME && block === driverOf(state));

// The degrees of freedom of a planar chain of the links of the state (Chebychev, Grübler); a pin of n links counts n − 1 times.
export function mobilityOf({ joints, sliders, links }) {
  const pins = joints.reduce((sum, { of }) => sum + Math.max(0, of.length - 1), 0);
  return 3 * links.length - 2 * (pins + sliders.length);
}

// The links that joints and sliders join to one another and to the frame.
export function joinedToFrame({ joints, sliders }) {
  const joined = new Set([FRAME]);
  const groups = [...joints.map(({ of }) => of), ...sliders.map(({ block, on }) => [block, on])];
  for (let size = 0; size !== joined.size;) {
    size = joined.size;
    for (const group of groups) if (group.some((name) => joined.has(name))) for (const name of group) joined.add(name);
  }
  return joined;
}

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

const namesIn = ({ joints, sliders, links }) => new Set([FRAME, ...[joints, sliders, links].flatMap((list) => list.map(({ name }) => name))]);

// A new name of a joint: A to Z, then A1 and on; of what is not a joint `letter`1 and on.
export function freshName(state, letter = null) {
  const taken = namesIn(state);
  for (let i = 0; ; ++i) {
    const name = letter ? `${letter}${i + 1}` : `${LETTERS[i % 26]}${i < 26 ? "" : Math.floor(i / 26)}`;
    if (!taken.has(name)) return name;
  }
}

export const isName = (name) => typeof name === "string" && /^[\p{L}\p{N}_.'-]{1,40}$/u.test(name);
export const isFree = (state, name) => isName(name) && !namesIn(state).has(name);

const areDistinct = (list) => new Set(list).size === list.length;

// The names of the loads: what each is on; of a second one there with its number.
export const loadNames = ({ loads }) => loads.map(({ on }, i) => {
  const before = loads.slice(0, i).filter((other) => other.on === on).length;
  return before ? `${on}#${before + 1}` : on;
});
export const loadOf = (state, name) => state.loads[loadNames(state).indexOf(name)];

// The links that a load may follow in its window.
export const linksOfLoad = (state, { on }) => (linkOf(state, on) ? [on] : jointOf(state, on).of.filter((name) => name !== FRAME));

const areNumbers = (pair, limit) => Array.isArray(pair) && pair.length === 2 && pair.every((x) => Number.isFinite(x) && Math.abs(x) <= limit);
const isShare = (part) => areNumbers(part, 1) && part[0] >= 0 && part[0] < part[1];

function isWindow(state, load) {
  const { link, when, stroke } = load.window;
  return linksOfLoad(state, load).includes(link) && (["always", "advance", "return"].includes(when) || (areNumbers(when, 1e6) && when[0] !== when[1])) && (stroke === null || isShare(stroke));
}

// A force at a moving joint or a torque on a link.
function isLoad(state, load) {
  const { on, force, torque, window = null } = load, joint = jointOf(state, on);
  const isThere = force ? joint !== undefined && !isFixed(joint) && areNumbers(force, MOST_FORCE) : linkOf(state, on) !== undefined && Number.isFinite(torque);
  return isThere && (window === null || isWindow(state, load));
}

const isLink = (state, { name, mass, centre = null, inertia = null }) => jointsOn(state, name).length + slidersOn(state, name).length > 1 && Number.isFinite(mass) && mass >= 0
  && (centre === null || areNumbers(centre, 1e6)) && (inertia === null || (Number.isFinite(inertia) && inertia >= 0));

// Whether a state is one that edits can make: what it names is there, and nothing is too much.
export function isSound(state) {
  const { joints, sliders, links, driven, loads, speed, acceleration, gravity } = state;
  const links_ = new Set(links.map(({ name }) => name)), isBody = (name) => name === FRAME || links_.has(name);
  const names = [joints, sliders, links].flatMap((list) => list.map(({ name }) => name));
  const isJoint = ({ at, of }) => areNumbers(at, 1e6) && of.length > 0 && areDistinct(of) && of.every(isBody);
  const isSlider = ({ block, on, degrees, along }) => links_.has(block) && isBody(on) && on !== block && Number.isFinite(degrees) && jointsOn(state, block).length > 0
    && (along === null || (along.length === 2 && along[0] !== along[1] && along.every((name) => jointOf(state, name)?.of.includes(on))));
  return Object.entries(MOST).every(([key, most]) => state[key].length <= most) && names.every((name) => isName(name) && name !== FRAME) && areDistinct(names)
    && joints.every(isJoint) && sliders.every(isSlider) && areDistinct(sliders.map(({ block }) => block)) && links.every((link) => isLink(state, link)) && (driven === null || links_.has(driven))
    && loads.every((load) => isLoad(state, load)) && [speed, acceleration].every((x) => Number.isFinite(x) && Math.abs(x) <= FASTEST) && (gravity === null || areNumbers(gravity, FASTEST));
}
