// The picture of a mechanism. `build` draws what stands still and every body in its own axes;
// `move` places the bodies.

import { set, svg } from "./dom.js";
import { MOST_MARKS } from "./extras.js";
import { Mechanism } from "./mechanism.js";
import { Picture } from "./picture.js";
import { quantile, RADIANS } from "./sampling.js";
import { arrowPath, barPath, blockPath, groundSign, guideSign, pathThrough, pathWithGaps, round } from "./shapes.js";
import { pathRates } from "./vectors.js";
import { say, term } from "./words.js";

const BLOCK = { length: 28, height: 16 };
export const ARROWS = { velocity: say("arrows.velocity"), acceleration: say("arrows.acceleration"), reactions: say("arrows.reactions") };
const MANY_NAMES = 24;

// What a mechanism without a table of values has to draw of one.
export const NO_TABLE = { columns: [], normals: [], centrodes: [], loads: [], vectorsOf: () => [] };

export class MechanismScene extends Picture {
  // `table`: of an analysis; its vectors can be shown as arrows.
  // `unit`: what a radian, of a slider a unit of length, is in the drive's coordinate.
  constructor(frame, mechanism, onDrag, table = NO_TABLE, unit = 1 / RADIANS) {
    super(frame, say("picture.mechanism"), onDrag);
    Object.assign(this, { mechanism, table, unit, shown: { paths: true, names: mechanism.points.length <= MANY_NAMES } });
    this.#collectArrows();
    this.many = mechanism.bodies.length > 30;
    this.box = mechanism.closes ? mechanism.box : null;
  }

  #collectArrows() { this.arrows = Object.keys(ARROWS).flatMap((quantity) => this.#arrowsOf(quantity)); }

  // Another mechanism in place of the one drawn, in the same frame, with a table of its own or none.
  adopt(mechanism, table = NO_TABLE) {
    Object.assign(this, { mechanism, table });
    this.#collectArrows();
  }

  get drives() { return this.mechanism.samples; }

  // The points that are no joints; of a mechanism without them its moving points.
  marksAt(drive) {
    const moving = this.mechanism.points.filter((point) => point.moves);
    const own = moving.filter((point) => !point.isPin);
    const places = this.mechanism.places(drive);
    return (own.length ? own : moving).slice(0, MOST_MARKS).map((point) => Mechanism.point(places[point.body], point.at)).filter(Boolean);
  }

  // Which body a part of the drawing is of, where it stands, and what it is called.
  bodyOf(part) { const body = part.closest?.(".body")?.dataset.body; return body === undefined ? undefined : Number(body); }
  placeOf(body, drive) { return this.mechanism.places(drive)[body]; }
  nameOf(body) { return term(this.mechanism.bodies[body].name); }

  // Places that things of the picture reach.
  get crowd() { return this.mechanism.points.flatMap((point) => point.path.filter(Boolean)); }

  // Of the points followed and the joints, from where they were sampled.
  ratesAt(drive) {
    const { mechanism } = this;
    const places = mechanism.places(drive);
    return mechanism.points.filter((point) => point.moves).slice(0, 2 * MOST_MARKS).flatMap((point) => {
      const rates = pathRates(point.path, mechanism.samples, mechanism.within(drive), mechanism.round, this.unit);
      const at = Mechanism.point(places[point.body], point.at);
      return rates && at ? [{ at, ...rates }] : [];
    });
  }

  tint(body) {
    if (body === 1) return "--crank";
    if (body === this.mechanism.output) return "--rocker";
    return ["--coupler", "--link-b", "--link-c", "--link-d"][(body - 2 + 4) % 4];
  }

  // Vectors that act at a point, with the size to which their arrows are drawn.
  #arrowsOf(quantity) {
    const vectors = this.table.vectorsOf(quantity).filter((v) => v.at);
    const sizes = vectors.flatMap((v) => v.x.values.map((x, i) => (x === null || v.y.values[i] === null ? null : Math.hypot(x, v.y.values[i]))));
    const normals = quantity === "reactions" ? this.table.normals.map((n) => ({ ...n, column: this.table.columns[n.column] })) : [];
    const size = quantile([...sizes, ...normals.flatMap((n) => n.column.values)], 0.98);
    return size > 0 ? [...vectors, ...normals].map((v) => ({ ...v, quantity, size })) : [];
  }

  build() {
    this.clear(this.box, say("picture.nowhere_assembled"));
    if (!this.box) return;
    const { mechanism, view } = this;
    this.bars = this.many ? 2.6 : Math.min(7, 0.016 * Math.min(view.width, view.height));
    this.layers = Object.fromEntries(["ground", "backdrop", "paths", "bodies", "pins", "targets", "arrows", "names", "handles"].map((name) => [name, svg("g", { class: `layer-${name}` })]));
    this.root.append(...Object.values(this.layers), this.scaleBar());
    this.#ground();
    this.#paths();
    this.groups = mechanism.bodies.map((body, i) => (i ? this.#body(body, i) : null));
    this.blocks = mechanism.bodies.map((body, i) => (body.block ? this.#group(body, i, svg("path", { class: "block", d: blockPath(BLOCK.length, BLOCK.height) })) : null));
    // Blocks lie on what they slide on.
    this.layers.bodies.append(...[...this.groups, ...this.blocks].filter(Boolean));
    this.#pins();
    this.#arrowParts();
    this.#names();
    this.#handles();
    this.show(this.shown);
  }

  // Switches layers and kinds of arrows on and off.
  show(shown) {
    this.shown = { ...this.shown, ...shown };
    if (!this.box) return;
    this.layers.paths.toggleAttribute("hidden", !this.shown.paths);
    this.layers.names.toggleAttribute("hidden", !this.shown.names);
    for (const { quantity, part } of this.arrowParts) part.toggleAttribute("hidden", !this.shown[quantity]);
  }

  #ground() {
    const { ground } = this.layers;
    for (const [from, to] of this.mechanism.bodies[0].rails) {
      ground.append(guideSign(this.view.screen(from), this.view.screen(to), BLOCK.height / 2 + 2, BLOCK.length / 2 + 8));
    }
    for (const pin of this.mechanism.pins) {
      const still = pin.path.find(Boolean);
      if (!pin.fixed || !still) continue;
      const [x, y] = this.view.screen(still);
      const sign = svg("g", {}, svg("rect", { class: "ground-back", x: -19, y: 0, width: 38, height: 26 }), groundSign([0, 0]));
      set(sign, { transform: `translate(${round(x)} ${round(y)}) scale(${this.many ? 0.55 : 1})` });
      ground.append(sign);
    }
  }

  #paths() {
    for (const point of this.mechanism.points) {
      if (!point.moves) continue;
      const d = pathWithGaps(point.path.map((p) => p && this.view.screen(p)));
      this.layers.paths.append(svg("path", { class: point.isPin ? "circle-path" : "path", d }));
    }
    for (const centrode of this.table.centrodes) this.#centrode(centrode);
  }

  // As far as it is near the picture: it runs to infinity where its body slides.
  #centrode({ of, path }) {
    const reach = 2 * Math.max(this.view.width, this.view.height);
    const shown = path.map((p) => p && this.view.screen(p)).map((p) => (p && Math.abs(p[0]) < reach && Math.abs(p[1]) < reach ? p : null));
    const body = this.mechanism.bodies.findIndex(({ name }) => name === of);
    this.layers.paths.append(svg("path", { class: "centrode", style: `stroke:var(${this.tint(body)})`, d: pathWithGaps(shown) }, svg("title", {}, say("picture.fixed_centrode", { of: term(of) }))));
  }

  // A body in its own axes, in pixels.
  #body(body, index) {
    const local = ([u, v]) => [this.view.scale * u, -this.view.scale * v];
    const group = this.#group(body, index);
    const corners = body.outline.map(local);
    if (corners.length > 2) {
      const d = `${pathThrough(corners)}Z`;
      group.append(svg("path", { class: "plate", d, style: `stroke-width:${2 * this.bars}` }), svg("path", { class: "plate-edge", d }));
    } else if (corners.length === 2 && Math.hypot(corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]) > 1) {
      group.append(svg("path", { class: "link", d: barPath(corners[0], corners[1], this.bars) }));
    }
    for (const rail of body.rails) group.append(...this.#slot(rail.map(local)));
    return group;
  }

  #group(body, index, ...parts) {
    return svg("g", { class: "body", "data-body": index, style: `--tint:var(${this.tint(index)})` }, svg("title", {}, term(body.name)), ...parts);
  }

  // A slot in a moving body, long enough for the block.
  #slot([p, q]) {
    const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    const [x, y] = length > 0 ? [(q[0] - p[0]) / length, (q[1] - p[1]) / length] : [1, 0];
    const over = BLOCK.length / 2 + 3;
    const ends = [[p[0] - over * x, p[1] - over * y], [q[0] + over * x, q[1] + over * y]];
    return [svg("path", { class: "link", d: barPath(...ends, BLOCK.height / 2 + 1) }), svg("path", { class: "groove", d: barPath(...ends, BLOCK.height / 2 - 3.5) })];
  }

  #pins() {
    const { mechanism } = this;
    const size = this.many ? 2.4 : 4.5;
    const places = [...mechanism.pins, ...mechanism.points.filter((point) => !point.isPin && point.moves)];
    this.pinParts = places.map((pin) => {
      const part = svg("circle", pin.isPin === false ? { class: "coupler-point", r: size + 0.6 } : { class: "pin", r: size });
      if (pin.name) part.dataset.name = pin.name;
      this.layers.pins.append(part);
      return { pin, part };
    });
  }

  #arrowParts() {
    const reach = 0.24 * Math.min(this.view.width, this.view.height);
    this.arrowParts = this.arrows.map((arrow) => {
      const part = svg("g", { class: `arrow ${arrow.quantity}` }, svg("path", { class: "halo" }), svg("path", {}));
      this.layers.arrows.append(part);
      return { ...arrow, part, scale: reach / arrow.size, reach: 1.7 * reach };
    });
  }

  #names() {
    this.nameParts = this.mechanism.points.map((point) => {
      const part = svg("text", { class: "joint-name" }, point.name);
      this.layers.names.append(part);
      return { point, part, spokes: this.#spokes(point) };
    });
  }

  // Every moving joint can be taken hold of; one that turns about a fixed pivot with the drive
  // follows the pointer's direction, others go to the nearest place on their paths.
  #handles() {
    const { mechanism } = this;
    const moving = mechanism.pins.filter((pin) => !pin.fixed && pin.body !== 0);
    const blocks = mechanism.bodies.flatMap((body, i) => (body.block ? [{ body: i, at: [0, 0] }] : []));
    const points = mechanism.points.filter((point) => point.moves && !point.isPin);
    const places = [...moving, ...points, ...blocks.filter((b) => ![...moving, ...points].some((p) => p.body === b.body && p.at.every((v, k) => v === b.at[k])))];
    this.handleParts = places.map((place) => {
      const part = svg("circle", { class: "handle", r: this.many ? 9 : 20 });
      const path = place.path ?? mechanism.samples.map((drive) => Mechanism.point(mechanism.places(drive)[place.body], place.at));
      this.listen(part, (p) => mechanism.nearest(path, p, this.drive));
      this.layers.handles.append(part);
      return { place, part };
    });
  }

  move(drive) {
    this.drive = drive;
    if (!this.box) return;
    const { view } = this;
    const places = this.mechanism.places(drive);
    const at = (spot) => Mechanism.point(places[spot.body], spot.at);
    const screen = (spot) => { const p = at(spot); return p && view.screen(p); };
    places.forEach((place, i) => {
      const parts = [this.groups[i], this.blocks[i]].filter(Boolean);
      for (const part of parts) part.toggleAttribute("hidden", !place);
      if (!place) return;
      const [x, y, c, s] = place;
      const [left, top] = view.screen([x, y]);
      const transform = `matrix(${c.toFixed(6)} ${(-s).toFixed(6)} ${s.toFixed(6)} ${c.toFixed(6)} ${left.toFixed(2)} ${top.toFixed(2)})`;
      for (const part of parts) set(part, { transform });
    });
    const put = (part, p) => { part.toggleAttribute("hidden", !p); if (p) set(part, { cx: round(p[0]), cy: round(p[1]) }); };
    for (const { pin, part } of this.pinParts) put(part, screen(pin));
    for (const { place, part } of this.handleParts) put(part, screen(place));
    this.#moveArrows(drive, places);
    this.#moveNames(places);
  }

  // The vector of an arrow: two columns, or along a body's normal as much as one column says.
  #vectorOf({ x, y, column, normal }, place, drive) {
    if (!column) return [this.table.at(x, drive), this.table.at(y, drive)];
    const size = this.table.at(column, drive);
    return size === null ? [null, null] : Mechanism.point([0, 0, place[2], place[3]], normal).map((part) => size * part);
  }

  #moveArrows(drive, places) {
    for (const arrow of this.arrowParts) {
      const { body, at, part, scale, reach, quantity } = arrow;
      const place = places[body];
      if (!this.shown[quantity]) continue;
      const p = place && this.view.screen(Mechanism.point(place, at));
      const v = place ? this.#vectorOf(arrow, place, drive) : [null, null];
      const known = p && v[0] !== null && v[1] !== null;
      const long = known ? Math.hypot(...v) * scale : 0;
      const k = long > reach ? (scale * reach) / long : scale;
      const d = known ? arrowPath(p, [k * v[0], -k * v[1]]) : "";
      for (const line of part.children) set(line, { d });
    }
  }

  // Names stand beside their points, in the widest gap between what starts there.
  #moveNames(places) {
    if (!this.shown.names) return;
    const { view } = this;
    for (const name of this.nameParts) {
      const { point, part, spokes } = name;
      const place = Mechanism.point(places[point.body], point.at);
      part.toggleAttribute("hidden", !place);
      if (!place) continue;
      const p = view.screen(place);
      const taken = spokes.flatMap(({ body, at, both }) => {
        const end = Mechanism.point(places[body], at);
        if (!end) return [];
        const angle = Math.atan2(place[1] - end[1], end[0] - place[0]);
        return both ? [angle, angle + Math.PI] : [angle];
      });
      if (point.ground) taken.push(...[60, 90, 120].map((deg) => deg * RADIANS));
      name.angle = widestGap(taken, name.angle);
      const away = point.ground ? 18 : 20;
      set(part, { x: round(p[0] + away * Math.cos(name.angle)), y: round(p[1] + away * Math.sin(name.angle)) });
    }
  }

  // What starts at a named point: the other corners of each body that has a corner there, and
  // guides that run through it.
  #spokes(point) {
    const { mechanism } = this;
    const known = mechanism.samples.find((drive) => mechanism.places(drive).every(Boolean)) ?? mechanism.start;
    const places = mechanism.places(known);
    const here = Mechanism.point(places[point.body], point.at);
    const near = (p) => here && p && this.view.scale * Math.hypot(p[0] - here[0], p[1] - here[1]) < 2;
    return mechanism.bodies.flatMap((body, i) => {
      const corners = body.outline.map((at) => ({ body: i, at }));
      const own = corners.some(({ at }) => near(Mechanism.point(places[i], at)));
      const rails = body.rails.filter(([from, to]) => near(footOn(Mechanism.point(places[i], from), Mechanism.point(places[i], to), here)));
      return [...(own ? corners.filter(({ at }) => !near(Mechanism.point(places[i], at))) : []),
        ...rails.map(([, to]) => ({ body: i, at: to, both: true }))];
    });
  }
}

// The point of the line through p and q that is nearest to r.
function footOn(p, q, r) {
  if (!p || !q || !r) return null;
  const [x, y] = [q[0] - p[0], q[1] - p[1]];
  const length = x * x + y * y;
  const t = length > 0 ? ((r[0] - p[0]) * x + (r[1] - p[1]) * y) / length : 0;
  return [p[0] + t * x, p[1] + t * y];
}

// The middle of the widest gap between angles; that of the gap in which `present` lies, as long as no
// other is much wider.
function widestGap(angles, present = -Math.PI / 4) {
  if (angles.length === 0) return present;
  const turn = 2 * Math.PI;
  const sorted = angles.map((a) => a - turn * Math.floor(a / turn)).sort((a, b) => a - b);
  const gaps = sorted.map((from, i) => ({ from, width: (sorted[i + 1] ?? sorted[0] + turn) - from }));
  const inside = present - turn * Math.floor((present - sorted[0]) / turn);
  const own = gaps.findLast((gap) => gap.from <= inside) ?? gaps[0];
  const widest = gaps.reduce((best, gap) => (gap.width > best.width ? gap : best));
  const { from, width } = widest.width > 1.4 * own.width ? widest : own;
  return from + width / 2;
}
