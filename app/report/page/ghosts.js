// The other linkages of a four-bar: its other assembly, and Roberts' cognates, which trace the same
// coupler curve.

const times2 = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const less2 = (p, q) => [p[0] - q[0], p[1] - q[1]];
const more2 = (p, q) => [p[0] + q[0], p[1] + q[1]];

// C mirrored in the line through B and D: the other place where coupler and rocker meet; the coupler
// point goes with the coupler.
function otherAssembly({ a, b, c, d, p }) {
  const line = less2(d, b);
  const size = line[0] ** 2 + line[1] ** 2;
  if (!(size > 0)) return null;
  const [x, y] = less2(c, b);
  const share = (x * line[0] + y * line[1]) / size;
  const mirrored = [b[0] + 2 * share * line[0] - x, b[1] + 2 * share * line[1] - y];
  const ratio = p && dividedBy(less2(p, b), less2(c, b));
  return { a, b, c: mirrored, d, p: ratio && more2(b, times2(ratio, less2(mirrored, b))) };
}

function dividedBy([a, b], [c, d]) {
  const size = c * c + d * d;
  return [(a * c + b * d) / size, (b * c - a * d) / size];
}

// Roberts 1875: with k = (P − B)/(C − B) the third fixed pivot is E = A + k·(D − A); one cognate
// stands on A and E, the other on D and E. Links follow from two parallelograms at P.
function robertsCognate({ a, b, c, d, p }, which) {
  if (!p) return null;
  const k = dividedBy(less2(p, b), less2(c, b));
  const pivot = more2(a, times2(k, less2(d, a)));
  if (which === 1) {
    const joint = more2(a, less2(p, b));
    return { a, b: joint, c: more2(pivot, times2(k, less2(c, d))), d: pivot, p };
  }
  const joint = more2(d, less2(p, c));
  return { a: d, b: joint, c: more2(pivot, times2(less2([1, 0], k), less2(b, a))), d: pivot, p };
}

const GHOSTS = {
  assembly: (pose) => otherAssembly(pose),
  cognate2: (pose) => robertsCognate(pose, 1),
  cognate3: (pose) => robertsCognate(pose, 2),
};

// The lengths and pivots of a four-bar that stands in a pose.
function dimensionsOf({ a, b, c, d, p }) {
  const far = (u, v) => Math.hypot(u[0] - v[0], u[1] - v[1]);
  const [u, v] = p ? times2(less2(p, b), less2(c, b).map((x, k) => (k ? -x : x) / far(b, c))) : [];
  return { crank: far(a, b), coupler: far(b, c), rocker: far(c, d), pivots: [a, d], point: p ? [u, v] : null };
}

function ghostAt(kind, scene, drive) {
  const pose = scene.fourBarAt(drive);
  return pose && GHOSTS[kind](pose);
}

class Ghost {
  // `notes`: a list in which the dimensions are told.
  constructor(kind, notes) {
    Object.assign(this, { kind, notes, name: kind, words: `extras.${kind}`, root: svg("g", { class: `ghost-linkage ${kind}` }), line: element("li") });
  }

  // `scene.fourBarAt(drive)`: joints a, b, c, d and the coupler point p of a four-bar.
  available(scene) {
    const pose = scene.fourBarAt?.(scene.drives[0]);
    return Boolean(pose) && (this.kind === "assembly" || (Boolean(pose.p) && dividedBy(less2(pose.p, pose.b), less2(pose.c, pose.b)).every(Number.isFinite)));
  }

  build(scene) {
    const at = (drive) => ghostAt(this.kind, scene, drive);
    const { view } = scene;
    const start = at(scene.drives[0]);
    const path = this.kind === "assembly" && start.p ? [svg("path", { class: "ghost-path", d: pathWithGaps(scene.drives.map((drive) => at(drive)?.p).map((p) => p && view.screen(p))) })] : [];
    this.parts = { plate: svg("path", { class: "ghost-plate" }), links: svg("path", { class: "ghost-links" }), pins: [0, 1, 2, 3].map(() => svg("circle", { class: "pin", r: 3.4 })) };
    this.root.replaceChildren(...path, groundSign(view.screen(start.a)), groundSign(view.screen(start.d)), this.parts.plate, this.parts.links, ...this.parts.pins);
    this.#tell(start);
  }

  #tell(pose) {
    const { crank, coupler, rocker, pivots, point } = dimensionsOf(pose);
    const pair = (p) => `${number(p[0], 6)}, ${number(p[1], 6)}`;
    this.line.textContent = say("extras.dimensions", { name: say(this.words), crank: number(crank, 7), coupler: number(coupler, 7), rocker: number(rocker, 7),
      first: pair(pivots[0]), second: pair(pivots[1]) }) + (point ? say("extras.dimensions_point", { point: pair(point) }) : "");
    this.notes.append(this.line);
  }

  move(scene, drive) {
    const pose = ghostAt(this.kind, scene, drive);
    this.root.toggleAttribute("hidden", !pose);
    if (!pose) return;
    const at = Object.fromEntries(["a", "b", "c", "d", "p"].map((key) => [key, pose[key] && scene.view.screen(pose[key])]));
    set(this.parts.plate, { d: at.p ? `${pathThrough([at.b, at.c, at.p])}Z` : "" });
    set(this.parts.links, { d: pathThrough([at.a, at.b, at.c, at.d]) });
    ["a", "b", "c", "d"].forEach((key, i) => set(this.parts.pins[i], { cx: round(at[key][0]), cy: round(at[key][1]) }));
  }

  clear() { this.line.remove(); }

  legend() { return [legendItem(`ghost-${this.kind}`, "dashed", say(this.words))]; }
}
