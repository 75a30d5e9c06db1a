// What stands still behind and beside a design: the curves that the synthesis found, the targets,
// and how far they are missed.

import { set, svg } from "../dom.js";
import { Mechanism } from "../mechanism.js";
import { RADIANS } from "../sampling.js";
import { arrowPath, pathThrough, pathWithGaps, round } from "../shapes.js";
import { sentenceOf } from "../words.js";

const LOCUS_COLOURS = ["--link-b", "--warn", "--link-c", "--accent", "--link-d", "--velocity", "--rocker", "--crank"];
export const locusColour = (index) => LOCUS_COLOURS[index % LOCUS_COLOURS.length];

// The curves of the synthesis that are `shown` (a set of indices), as far as they are near the
// picture: they may run to infinity. A branch of one point is a mark.
function locusShapes(view, loci, shown) {
  const reach = 4 * Math.max(view.width, view.height);
  const near = (p) => Math.abs(p[0]) < reach && Math.abs(p[1]) < reach;
  return loci.flatMap(({ name, branches }, i) => {
    if (!shown.has(i)) return [];
    const group = svg("g", { class: "synthesis-locus", "data-locus": i, style: `--tint:var(${locusColour(i)})` }, svg("title", {}, sentenceOf(name)));
    for (const branch of branches) {
      const points = branch.map((p) => p && view.screen(p)).map((p) => (p && (near(p) || branch.length < 3) ? p : null));
      if (points.length === 1 && points[0]) group.append(svg("path", { class: "locus-point", d: diamondPath(points[0], 6) }));
      else group.append(svg("path", { class: "locus-curve", d: pathWithGaps(points) }));
    }
    return [group];
  });
}

const diamondPath = ([x, y], r) => `M${round(x - r)} ${round(y)}L${round(x)} ${round(y - r)}L${round(x + r)} ${round(y)}L${round(x)} ${round(y + r)}Z`;

function pointMarks(view, points) {
  return points.map((point) => {
    const [x, y] = view.screen(point);
    return svg("g", {}, svg("circle", { class: "target", cx: round(x), cy: round(y), r: 6 }),
      svg("circle", { class: "target-dot", cx: round(x), cy: round(y), r: 1.6 }));
  });
}

// The axes of a body, the first one longer.
function axesSign() {
  return [svg("path", { class: "pose-axis", d: arrowPath([0, 0], [34, 0]) }), svg("path", { class: "pose-axis second", d: arrowPath([0, 0], [0, -22]) }),
    svg("circle", { class: "pose-dot", r: 3 })];
}
const placeText = (view, [x, y, deg]) => `translate(${view.screen([x, y]).map(round).join(" ")}) rotate(${round(-deg)})`;

// Where beside a pose its number may stand, as angles from its first axis, and how far from it.
const NUMBER_PLACES = [225, 135, 315, 45];
const NUMBER_AWAY = 14;
// Names of pivots stand on either side below them.
const PIVOT_NAME = 22;

// Of those places the one farthest from all that is `taken`, in pixels.
function numberPlace(view, [x, y, deg], taken) {
  const [px, py] = view.screen([x, y]);
  const room = (place) => {
    const angle = (deg + place) * RADIANS;
    return Math.min(...taken.map(([qx, qy]) => Math.hypot(px + NUMBER_AWAY * Math.cos(angle) - qx, py - NUMBER_AWAY * Math.sin(angle) - qy)));
  };
  return NUMBER_PLACES.reduce((best, place) => (room(place) > 1.2 * room(best) ? place : best));
}

// The axes of each pose that the body is to take, with its number beside what else stands still.
function poseMarks(view, poses, pivots) {
  const still = [...poses.map((p) => view.screen(p)), ...pivots.map((p) => view.screen(p)).flatMap(([x, y]) => [[x, y], [x - PIVOT_NAME, y + 12], [x + PIVOT_NAME, y + 12]])];
  return poses.map((pose, i) => {
    const away = numberPlace(view, pose, still.filter((_, k) => k !== i)) * RADIANS;
    return svg("g", { class: "pose", transform: placeText(view, pose) }, ...axesSign(),
      svg("text", { class: "joint-name pose-name", transform: `translate(${round(NUMBER_AWAY * Math.cos(away))} ${round(-NUMBER_AWAY * Math.sin(away))}) rotate(${round(pose[2])})` }, String(i + 1)));
  });
}

// The guided body where it is taken at each pose.
function bodyGhosts(view, guided) {
  if (!guided || guided.outline.length < 2) return [];
  return guided.reached.filter(Boolean).map(([x, y, deg]) => {
    const [c, s] = [Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];
    const corners = guided.outline.map(([u, v]) => view.screen([x + c * u - s * v, y + s * u + c * v]));
    return svg("path", { class: "ghost", d: `${pathThrough(corners)}Z` });
  });
}

// From each target towards the point that is reached, as many times as long as asked.
function errorMarks(view, targets, reached, magnify) {
  return targets.flatMap((target, i) => {
    if (!reached[i]) return [];
    const from = view.screen(target);
    const to = view.screen([0, 1].map((k) => target[k] + magnify * (reached[i][k] - target[k])));
    return [svg("path", { class: "error", d: pathThrough([from, to]) }), svg("circle", { class: "error-tip", cx: round(to[0]), cy: round(to[1]), r: 2.4 })];
  });
}

// The part of the path that is to be straight, and the straight line between the ends given, else between its own.
function stretchMarks(view, stretch, ends) {
  const points = stretch.filter(Boolean).map((p) => view.screen(p));
  if (points.length < 2) return [];
  const line = ends ? ends.map((end) => view.screen(end)) : [points[0], points.at(-1)];
  return [svg("path", { class: "straight", d: pathThrough(line) }), svg("path", { class: "stretch", d: pathThrough(points) })];
}

// The part of a foot's path in which it stands, and the ground below.
function walkMarks(view, walk) {
  if (!walk) return [];
  const points = walk.stance;
  const ways = points.map(([x]) => x);
  const [from, to] = [Math.min(...ways), Math.max(...ways)], beyond = 0.08 * (to - from);
  const ground = [from - beyond, to + beyond].map((x) => view.screen([x, walk.ground]));
  return [svg("path", { class: "straight", d: pathThrough(ground) }), svg("path", { class: "stretch", d: pathThrough(points.map((p) => view.screen(p))) })];
}

// A closed curve that is to be followed.
function outlineMark(view, outline) {
  if (outline.length === 0) return [];
  return [svg("path", { class: "outline", d: `${pathThrough(outline.map((p) => view.screen(p)))}Z` })];
}

// All that stands behind a design, and all that stands before it.
export function backdropOf(view, design, options) {
  return [...locusShapes(view, options.loci, options.shownLoci), ...outlineMark(view, design.outline), ...bodyGhosts(view, design.guided), ...stretchMarks(view, design.stretch, design.ends), ...walkMarks(view, design.walk)];
}
export function targetsOf(view, design, options) {
  const marks = design.poses.length ? poseMarks(view, design.poses, design.fixedPivots) : [];
  const points = design.outline.length ? [] : design.targets.slice(design.poses.length);
  return [...pointMarks(view, points), ...marks, ...errorMarks(view, design.targets, design.reached, options.magnify)];
}

// The axes of the guided body, which move with it; nothing where no body is guided.
export class GuidedAxes {
  constructor(view, guided) {
    Object.assign(this, { view, guided, part: svg("g", { class: "pose guided" }, ...(guided ? axesSign() : [])) });
  }

  // `place` of the body's own axes: [x, y, cos, sin].
  move(place) {
    if (!this.guided || !place) return;
    const [u, v, deg] = this.guided.axes;
    const [x, y] = Mechanism.point(place, [u, v]);
    set(this.part, { transform: placeText(this.view, [x, y, Math.atan2(place[3], place[2]) / RADIANS + deg]) });
  }
}
