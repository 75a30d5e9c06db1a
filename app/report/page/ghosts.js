// The other linkages of a four-bar: its other assembly, and Roberts' cognates, which trace the same
// coupler curve.

import { element, set, svg } from "./dom.js";
import { number } from "./format.js";
import { groundSign, legendItem, pathThrough, pathWithGaps, round } from "./shapes.js";
import { say } from "./words.js";

const times2 = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
export const less2 = (p, q) => [p[0] - q[0], p[1] - q[1]];
const more2 = (p, q) => [p[0] + q[0], p[1] + q[1]];

// The other place where C may be: mirrored in the line through B and D, where it slides in that through
// B square to its way. The coupler point goes with the coupler.
function otherAssembly({ a, b, c, d, way, p }) {
  const line = way ? [-way[1], way[0]] : less2(d, b);
  const size = line[0] ** 2 + line[1] ** 2;
  if (!(size > 0)) return null;
  const [x, y] = less2(c, b);
  const share = (x * line[0] + y * line[1]) / size;
  const mirrored = [b[0] + 2 * share * line[0] - x, b[1] + 2 * share * line[1] - y];
  const ratio = p && dividedBy(less2(p, b), less2(c, b));
  return { a, b, c: mirrored, d, way, p: ratio && more2(b, times2(ratio, less2(mirrored, b))) };
}

function dividedBy([a, b], [c, d]) {
  const size = c * c + d * d;
  return [(a * c + b * d) / size, (b * c - a * d) / size];
}

// Roberts 1875: with k = (P − B)/(C − B) the third fixed pivot is E = A + k·(D − A); one cognate
// stands on A and E, the other on D and E. Links follow from two parallelograms at P.
function robertsCognate({ a, b, c, d, p }, which) {
  if (!p || !d) return null;
  const k = dividedBy(less2(p, b), less2(c, b));
  const pivot = more2(a, times2(k, less2(d, a)));
  if (which === 1) {
    const joint = more2(a, less2(p, b));
    return { a, b: joint, c: more2(pivot, times2(k, less2(c, d))), d: pivot, p };
  }
  const joint = more2(d, less2(p, c));
  return { a: d, b: joint, c: more2(pivot, times2(less2([1, 0], k), less2(b, a))), d: pivot, p };
}

export const GHOSTS = {
  assembly: (pose) => otherAssembly(pose),
  cognate2: (pose) => robertsCognate(pose, 1),
  cognate3: (pose) => robertsCognate(pose, 2),
};

// The lengths and pivots of a linkage that stands in a pose.
function dimensionsOf({ a, b, c, d, p }) {
  const far = (u, v) => Math.hypot(u[0] - v[0], u[1] - v[1]);
  const [u, v] = p ? times2(less2(p, b), less2(c, b).map((x, k) => (k ? -x : x) / far(b, c))) : [];
  return { crank: far(a, b), coupler: far(b, c), rocker: d && far(c, d), pivots: [a, d], point: p ? [u, v] : null };
}

function ghostAt(kind, scene, drive) {
  const pose = scene.jointsAt(drive);
  return pose && GHOSTS[kind](pose);
}

// Where it stands first in the motion; null where it never does.
function firstPose(kind, scene) {
  for (const drive of scene.drives) {
    const pose = ghostAt(kind, scene, drive);
    if (pose) return pose;
  }
  return null;
}

export class Ghost {
  // `notes`: the list that shows the dimensions.
  constructor(kind, notes) {
    Object.assign(this, { kind, notes, name: kind, words: `extras.${kind}`, root: svg("g", { class: `ghost-linkage ${kind}` }), line: element("li") });
  }

  // `scene.jointsAt(drive)`: joints a, b, c, d (or the way of c) and the coupler point p.
  available(scene) {
    if (!scene.jointsAt) return false;
    const pose = firstPose(this.kind, scene);
    return pose !== null && [pose.a, pose.b, pose.c, pose.d ?? pose.a, pose.p ?? pose.a].flat().every(Number.isFinite);
  }

  // The positions of its joints.
  places(scene) {
    return scene.drives.filter((_, i) => i % 8 === 0).map((drive) => ghostAt(this.kind, scene, drive)).flatMap((pose) => (pose ? ["a", "b", "c", "d", "p"].map((key) => pose[key]).filter(Boolean) : []));
  }

  build(scene) {
    const { view } = scene;
    const start = firstPose(this.kind, scene);
    const traced = this.kind === "assembly" && start.p ? scene.drives.map((drive) => ghostAt(this.kind, scene, drive)?.p).map((p) => p && view.screen(p)) : [];
    this.joints = start.d ? ["a", "b", "c", "d"] : ["a", "b", "c"];
    this.parts = { plate: svg("path", { class: "ghost-plate" }), links: svg("path", { class: "ghost-links" }), pins: this.joints.map(() => svg("circle", { class: "pin", r: 3.4 })) };
    this.root.replaceChildren(svg("path", { class: "ghost-path", d: pathWithGaps(traced) }), ...[start.a, start.d].filter(Boolean).map((pivot) => groundSign(view.screen(pivot))),
      this.parts.plate, this.parts.links, ...this.parts.pins);
    this.#showDimensions(start);
  }

  #showDimensions(pose) {
    const { crank, coupler, rocker, pivots, point } = dimensionsOf(pose);
    const pair = (p) => `${number(p[0], 6)}, ${number(p[1], 6)}`;
    const values = { name: say(this.words), crank: number(crank, 7), coupler: number(coupler, 7), first: pair(pivots[0]) };
    this.line.textContent = (rocker === null ? say("extras.dimensions_slider", values) : say("extras.dimensions", { ...values, rocker: number(rocker, 7), second: pair(pivots[1]) }))
      + (point ? say("extras.dimensions_point", { point: pair(point) }) : "");
    this.notes.append(this.line);
  }

  move(scene, drive) {
    const pose = ghostAt(this.kind, scene, drive);
    this.root.toggleAttribute("hidden", !pose);
    if (!pose) return;
    const at = Object.fromEntries([...this.joints, "p"].map((key) => [key, pose[key] && scene.view.screen(pose[key])]));
    set(this.parts.plate, { d: at.p ? `${pathThrough([at.b, at.c, at.p])}Z` : "" });
    set(this.parts.links, { d: pathThrough(this.joints.map((key) => at[key])) });
    this.joints.forEach((key, i) => set(this.parts.pins[i], { cx: round(at[key][0]), cy: round(at[key][1]) }));
  }

  clear() { this.line.remove(); }

  legend() { return [legendItem(`ghost-${this.kind}`, "dashed", say(this.words))]; }
}
