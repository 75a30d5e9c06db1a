// What stands at a place of the sheet.

import { distanceToSegment } from "./edits.js";
import { directionOf, isBlock, jointOf, jointsOn, loadNames, pinOf } from "./model.js";
import { RADIANS } from "../sampling.js";

export const FORCE_SCALE = 10;       // newtons for a unit of the sheet
const GUIDE = 3;                     // reaches: how far from its pin the line of a slider can be taken
const BODY = 0.7;                    // of a reach: how far from the middle of a link it is still the link

const turnOf = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);

// The convex hull of points, counter-clockwise (Andrew's monotone chain).
export function hullOf(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (list) => list.reduce((chain, p) => {
    while (chain.length > 1 && turnOf(chain.at(-2), chain.at(-1), p) <= 0) chain.pop();
    return [...chain, p];
  }, []);
  const [low, high] = [half(sorted), half(sorted.toReversed())];
  return sorted.length < 3 ? sorted : [...low.slice(0, -1), ...high.slice(0, -1)];
}

// The corners of a link as it is drawn: the hull of its joints and of the pins of blocks that slide on it.
function outlineOf(state, link) {
  const riders = state.sliders.filter(({ on }) => on === link).map((slider) => pinOf(state, slider).at);
  return hullOf([...jointsOn(state, link).map(({ at }) => at), ...riders]);
}

const edgesOf = (corners) => corners.map((p, i) => [p, corners[(i + 1) % corners.length]]);
const isInside = (corners, r) => corners.length > 2 && edgesOf(corners).every(([p, q]) => turnOf(p, q, r) >= 0);
const distanceToBody = (corners, r) => (isInside(corners, r) ? 0 : Math.min(...edgesOf(corners).map(([p, q]) => distanceToSegment(r, p, q))));

// The foot of a place on a link of one line, else the place.
function footOnBody(corners, r) {
  if (corners.length !== 2) return r;
  const [p, q] = corners, way = [q[0] - p[0], q[1] - p[1]], square = way[0] ** 2 + way[1] ** 2;
  const share = square > 0 ? Math.min(1, Math.max(0, ((r[0] - p[0]) * way[0] + (r[1] - p[1]) * way[1]) / square)) : 0;
  return [p[0] + share * way[0], p[1] + share * way[1]];
}

const tipOf = (state, { on, force }) => jointOf(state, on).at.map((x, k) => x + force[k] / FORCE_SCALE);

// The nearest of `list` within `reach` of a place, by its distance.
function nearest(list, reach, distanceOf) {
  const far = list.map(distanceOf), least = Math.min(...far);
  return least <= reach ? list[far.indexOf(least)] : undefined;
}

// The spot at a place, within `reach`: a joint before the tip of a load, that before a link, and a slider's line last.
export function spotAt(state, place, reach) {
  const away = (p) => Math.hypot(p[0] - place[0], p[1] - place[1]);
  const joint = nearest(state.joints, reach, ({ at }) => away(at));
  if (joint) return { joint: joint.name };
  const load = nearest(state.loads.filter(({ force }) => force), reach, (one) => away(tipOf(state, one)));
  if (load) return { load: loadNames(state)[state.loads.indexOf(load)] };
  const link = nearest(state.links.filter(({ name }) => !isBlock(state, name)), BODY * reach, ({ name }) => distanceToBody(outlineOf(state, name), place));
  if (link) return { link: link.name, at: footOnBody(outlineOf(state, link.name), place) };
  const slider = nearest(state.sliders, BODY * reach, (one) => distanceToSegment(place, ...guideOf(state, one, GUIDE * reach)));
  return slider ? { slider: slider.name, at: place } : { at: place };
}

// The line of a slider so far to either side of its pin.
function guideOf(state, slider, far) {
  const { at } = pinOf(state, slider), angle = directionOf(state, slider) * RADIANS;
  return [-far, far].map((way) => [at[0] + way * Math.cos(angle), at[1] + way * Math.sin(angle)]);
}

