// The design chosen as a drawing for CAD (DXF), where it stands.

import { DxfSigns, dxfText } from "../dxf.js";
import { TURN } from "../study/linkage.js";
import { boxOf, diagonal } from "../view.js";
import { modeOf } from "./modes.js";

const STEPS_OF_PATH = 720;   // of a turn: the polygon is within 1e-5 of the size of a curve that bends as its links turn

// The whole path of the point: once round, or from one end of the motion to the other.
function pathOf(candidate) {
  const closed = candidate.linkage.fullTurn, count = closed ? STEPS_OF_PATH : STEPS_OF_PATH / 2 + 1;
  const points = Array.from({ length: count }, (_, i) => candidate.pose((TURN * i) / STEPS_OF_PATH)?.p).filter(Boolean);
  return { layer: "PATHS", points, closed: closed && points.length === count };
}

// The links of a pose; the coupler with its point, where it traces one.
function linksOf({ a, d }, { b, c, p }, tracesFunction) {
  const link = (...points) => ({ layer: "LINKS", points, closed: points.length > 2 });
  return [link(a, b), tracesFunction ? link(b, c) : link(b, c, p), ...(d ? [link(d, c)] : [])];
}

// Of a slider its guide and its block at `c`.
function slidingParts({ guide = [], along }, c, signs) {
  return guide.length ? [{ layer: "GUIDES", points: guide }, signs.blockAt(c, along)] : [];
}

// Of a candidate at a phase of its motion, with the targets of a state; null where it does not close there. Of a function the
// linkage alone: its path and its targets are in a diagram.
export function drawingOf(candidate, phase, state) {
  const pose = candidate?.pose(phase);
  if (!pose) return null;
  const { linkage, tracesFunction = false } = candidate, { a, d } = linkage.closure, grounds = [a, d].filter(Boolean);
  const joints = [["A", a], ["B", pose.b], ["C", pose.c], ...(d ? [["D", d]] : [])], paths = tracesFunction ? [] : [pathOf(candidate)];
  const signs = new DxfSigns(diagonal(boxOf([...joints.map(([, at]) => at), ...paths.flatMap(({ points }) => points)])));
  return dxfText({
    lines: [...paths, ...linksOf({ a, d }, pose, tracesFunction), ...slidingParts(linkage, pose.c, signs), ...grounds.map((at) => signs.groundAt(at))],
    circles: [...joints.map(([, at]) => signs.jointAt(at)), ...(tracesFunction ? [] : [signs.pointAt(pose.p), ...modeOf(state).places(state).map((at) => signs.targetAt(at))])],
    labels: [...joints, ...(tracesFunction ? [] : [["P", pose.p]])].map(([name, at]) => signs.nameAt(at, name)) });
}
