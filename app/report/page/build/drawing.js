// A mechanism that is built as a drawing for CAD (DXF), where it stands, in millimetres.

import { DxfSigns, dxfText } from "../dxf.js";
import { RADIANS } from "../sampling.js";
import { boxOf, diagonal } from "../view.js";
import { hullOf } from "./hits.js";
import { directionOf, isBlock, isFixed, jointsOn, pinOf } from "./model.js";
import { after } from "./motion.js";

// The runs of a path between its gaps, once round as one that is closed.
function runsOf(path) {
  const runs = [[]];
  for (const at of path) if (at) runs.at(-1).push(at); else if (runs.at(-1).length) runs.push([]);
  return runs.filter((run) => run.length > 1);
}

// `moveOf(link)`: where a link is now; `at`: the places of joints by name; `paths` likewise; `railOf(slider)`: the ends of the way of its block.
export function drawingOfState(state, { moveOf, at, paths, railOf }) {
  const seen = state.joints.filter(({ name }) => at.get(name)), size = diagonal(boxOf([...seen.map(({ name }) => at.get(name)), ...[...paths.values()].flat().filter(Boolean)]));
  const signs = new DxfSigns(size || 1), placeOf = ({ name }) => at.get(name);
  const bars = state.links.filter(({ name }) => !isBlock(state, name)).map(({ name }) => hullOf(jointsOn(state, name).filter(placeOf).map(placeOf))).map((points) => ({ layer: "LINKS", points, closed: points.length > 2 }));
  const sliding = state.sliders.filter((slider) => placeOf(pinOf(state, slider)) && moveOf(slider.on)).flatMap((slider) => {
    const move = moveOf(slider.on), [, , c, s] = move, angle = directionOf(state, slider) * RADIANS, way = [Math.cos(angle), Math.sin(angle)];
    return [{ layer: "GUIDES", points: railOf(slider).map((end) => after(move, end)) }, signs.blockAt(placeOf(pinOf(state, slider)), [way[0] * c - way[1] * s, way[0] * s + way[1] * c])];
  });
  const isPoint = (joint) => joint.of.length === 1 && !isFixed(joint);
  return dxfText({
    lines: [...[...paths.values()].flatMap(runsOf).map((points) => ({ layer: "PATHS", points })), ...bars, ...sliding, ...seen.filter(isFixed).map((joint) => signs.groundAt(placeOf(joint)))],
    circles: seen.map((joint) => (isPoint(joint) ? signs.pointAt : signs.jointAt).call(signs, placeOf(joint))),
    labels: seen.map((joint) => signs.nameAt(placeOf(joint), joint.name)) });
}
