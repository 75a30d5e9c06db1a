// Places of the sheet as a hand sees them, where the mechanism stands.

import { spotAt } from "./hits.js";
import { before } from "./motion.js";

const LEAST_STEP = 3.5;   // pixels
const STEPS = [1, 2, 5, 10];
const ARC_REACH = 0.6;    // of a reach: how far from its arc a torque is taken

// The step to which places are rounded: a round number of the sheet's units that is some pixels wide.
export function stepIn({ scale }) {
  const least = LEAST_STEP / scale, power = 10 ** Math.floor(Math.log10(least));
  return STEPS.map((k) => k * power).find((step) => step >= 0.9999 * least);
}

export function snapTo(place, view) {
  const step = stepIn(view);
  return place.map((x) => Number((Math.round(x / step) * step).toPrecision(9)) + 0);
}

// The spot at a place of the picture; on a link where it is drawn. The arc of a torque, where it is of use, comes before a link.
export function seenSpot(scene, state, place, reach, takesTorques) {
  const seen = { ...state, joints: state.joints.map((joint) => ({ ...joint, at: scene.at.get(joint.name) ?? joint.at })) };
  const other = spotAt(seen, place, reach), isPoint = other.joint !== undefined || other.load !== undefined;
  const spot = (takesTorques && !isPoint && scene.torqueAt(place, ARC_REACH * reach * scene.view.scale)) || other, move = spot.link === undefined ? null : scene.moves?.get(spot.link);
  if (spot.link !== undefined) return move ? { ...spot, at: before(move, spot.at) } : spot;
  return spot.at ? { ...spot, at: snapTo(spot.at, scene.view) } : spot;
}
