// How links are drawn: bars, plates, blocks, and the slots in which blocks slide.

import { svg } from "../dom.js";
import { barPath, blockPath, pathThrough, round } from "../shapes.js";
import { hullOf } from "./hits.js";
import { directionOf, jointsOn, linkOf, pinOf } from "./model.js";

export const RIDER = { length: 28, height: 16 };   // of a slider's block, in pixels
const BAR_WIDTH = 6, CENTRE_RADIUS = 5;

// A link in pixels about its first joint, the `origin`, where a unit of the plane has `scale`; railOf(slider) gives the ends of a block's way.
export function linkShape(state, name, scale, railOf) {
  const origin = jointsOn(state, name)[0]?.at ?? pinOf(state, state.sliders.find(({ on }) => on === name)).at;
  const local = ([x, y]) => [scale * (x - origin[0]), scale * (origin[1] - y)];
  const own = state.sliders.find(({ block }) => block === name);
  const body = plateParts(hullOf(jointsOn(state, name).map(({ at }) => at)).map(local)), rider = own ? [riderPart(directionOf(state, own))] : [];
  const slots = state.sliders.filter(({ on }) => on === name).flatMap((slider) => slotParts(railOf(slider).map(local)));
  const { centre } = linkOf(state, name);
  return { origin, parts: [...body, ...rider, ...slots, ...(centre ? [centreSign(local(centre))] : [])], isRider: Boolean(own) };
}

// The sign of a centre of mass: a circle in quarters.
function centreSign([x, y]) {
  const [left, right, top, bottom] = [x - CENTRE_RADIUS, x + CENTRE_RADIUS, y - CENTRE_RADIUS, y + CENTRE_RADIUS].map(round), arc = `A${CENTRE_RADIUS} ${CENTRE_RADIUS} 0 0 1`;
  return svg("g", { class: "mass-centre" }, svg("circle", { cx: round(x), cy: round(y), r: CENTRE_RADIUS }),
    svg("path", { d: `M${round(x)} ${top}${arc} ${right} ${round(y)}H${left}${`A${CENTRE_RADIUS} ${CENTRE_RADIUS} 0 0 0`} ${round(x)} ${bottom}Z` }));
}

const riderPart = (degrees) => svg("path", { class: "block", d: blockPath(RIDER.length, RIDER.height), transform: `rotate(${round(-degrees)})` });

function plateParts(corners) {
  if (corners.length > 2) {
    const d = `${pathThrough(corners)}Z`;
    return [svg("path", { class: "plate", d, style: `stroke-width:${2 * BAR_WIDTH}` }), svg("path", { class: "plate-edge", d })];
  }
  return corners.length === 2 ? [svg("path", { class: "link", d: barPath(corners[0], corners[1], BAR_WIDTH) })] : [];
}

function slotParts([p, q]) {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1, over = RIDER.length / 2 + 3;
  const ends = [[p, -1], [q, 1]].map(([end, side]) => end.map((x, k) => x + (side * over * (q[k] - p[k])) / length));
  return [svg("path", { class: "link", d: barPath(...ends, RIDER.height / 2 + 1) }), svg("path", { class: "groove", d: barPath(...ends, RIDER.height / 2 - 3.5) })];
}
