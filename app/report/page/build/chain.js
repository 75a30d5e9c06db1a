// The problem of a mechanism that was built: the file of joints as drawn that `cognate analyze` reads.

import { tableWithoutRounding } from "../rounding.js";
import { evenMass } from "./even_mass.js";
import { hullOf } from "./hits.js";
import { directionOf, driverOf, FRAME, isBlock, jointsOn } from "./model.js";

const GRAVITY = [0, -9806.65];   // mm/s²

const turned = (angle) => angle - 360 * Math.round(angle / 360);

function mechanismTable(state) {
  const pins = state.joints.filter(({ of }) => of.some((name) => name !== FRAME)).map(({ name, at, of }) => ({ name, at, of }));
  const slides = state.sliders.map((slider) => ({ name: slider.name, of: [slider.block, slider.on], direction_deg: turned(directionOf(state, slider)) }));
  return tableWithoutRounding({ type: "chain", driven: driverOf(state), joint: [...pins, ...slides] });
}

const MILLI = 1e-3;

// A mass is spread evenly over its link; inertia is in kg m², lengths are in mm.
function linkTable(state, { name, mass }) {
  if (isBlock(state, name)) return { name, mass };
  const [p, q] = jointsOn(state, name);
  if (!q) return { name, mass, centre: [0, 0] };
  const { centre, square } = evenMass(hullOf(jointsOn(state, name).map(({ at }) => at)));
  const way = q.at.map((x, k) => x - p.at[k]), size = Math.hypot(...way), from = centre.map((x, k) => x - p.at[k]);
  const own = size > 0 ? [from[0] * way[0] + from[1] * way[1], way[0] * from[1] - way[1] * from[0]].map((x) => x / size) : [0, 0];
  return { between: [p.name, q.name], mass, centre: tableWithoutRounding(own, Math.max(1, size)), inertia: mass * square * MILLI * MILLI };
}

// The problem of a state, its drive in the range given, if any.
export function problemOfState(state, range = null) {
  const heavy = state.links.filter(({ mass }) => mass > 0);
  return { kind: "analysis", length_unit: "mm", ...(state.weighs ? { gravity: GRAVITY } : {}), mechanism: mechanismTable(state),
    ...(range ? { drive: range } : {}), link: heavy.map((link) => linkTable(state, link)), load: state.loads.map(({ on, force }) => ({ on, force })) };
}
