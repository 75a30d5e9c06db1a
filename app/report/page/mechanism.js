// A mechanism in motion. Where each body stands at each sample of the drive was computed by the
// analysis kernel; between samples positions and angles are interpolated.

import { interpolate, locate, RADIANS } from "./sampling.js";
import { boxOf } from "./view.js";

export class Mechanism {
  constructor({ drive, bodies, output, pins, points }, { from, to, round }) {
    Object.assign(this, { samples: drive, bodies, output, pins, points, round });
    [this.from, this.to] = [Math.min(from, to), Math.max(from, to)];
    this.start = from;
    this.reversed = to < from;
    for (const point of [...pins, ...points]) point.path = this.#path(point);
    for (const point of points) point.moves = point.path.some((p) => p && Math.hypot(p[0] - point.path[0]?.[0], p[1] - point.path[0]?.[1]) > 1e-9);
    for (const point of points) point.isPin = pins.some((pin) => samePath(pin.path, point.path));
    for (const point of points) point.ground = pins.some((pin) => pin.fixed && samePath(pin.path, point.path));
    for (const pin of pins) pin.name = points.find((point) => samePath(pin.path, point.path))?.name;
  }

  // The drive coordinate within the motion that is nearest to `drive`.
  within(drive) {
    if (!this.round) return Math.min(this.to, Math.max(this.from, drive));
    const turn = this.to - this.from;
    return drive - turn * Math.floor((drive - this.from) / turn);
  }

  // For each body its place [x, y, cos, sin], or null where it has none.
  places(drive) {
    const at = locate(this.samples, this.within(drive));
    const value = (track) => (Array.isArray(track) ? interpolate(track, at) : track);
    return this.bodies.map((body) => {
      const [x, y, deg] = [value(body.x), value(body.y), value(body.deg)];
      return x === null || y === null || deg === null ? null : [x, y, Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];
    });
  }

  // The point `at` of a body in the plane.
  static point(place, [u, v]) {
    return place && [place[0] + place[2] * u - place[3] * v, place[1] + place[3] * u + place[2] * v];
  }

  #path({ body, at }) {
    const { x, y, deg } = this.bodies[body];
    const value = (track, k) => (Array.isArray(track) ? track[k] : track);
    return this.samples.map((_, k) => {
      const angle = value(deg, k);
      return angle === null ? null : Mechanism.point([value(x, k), value(y, k), Math.cos(angle * RADIANS), Math.sin(angle * RADIANS)], at);
    });
  }

  get closes() { return this.bodies.slice(1).some((body) => !Array.isArray(body.x) || body.x.some((v) => v !== null)); }

  // The named points that move with a body: those on it, and its joints on others.
  pointsOf(body) {
    const corners = this.bodies[body].outline.map((at) => this.#path({ body, at }));
    return this.points.filter((p) => p.moves && (p.body === body || corners.some((path) => samePath(path, p.path))));
  }

  // What the motion sweeps: the places of all pins and points and the rails.
  get box() {
    const rails = this.bodies.flatMap((body, i) => body.rails.flatMap((ends) => ends.flatMap((at) => (i ? this.#path({ body: i, at }) : [at]))));
    return boxOf([...[...this.pins, ...this.points].flatMap((p) => p.path), ...rails]);
  }

  // The sample that brings a path nearest to (x, y), not far from the present drive coordinate.
  nearest(path, [x, y], present) {
    const reach = 0.15 * (this.to - this.from);
    let [best, least] = [null, Infinity];
    this.samples.forEach((drive, k) => {
      if (!path[k]) return;
      const away = Math.abs(drive - present);
      const distance = Math.hypot(path[k][0] - x, path[k][1] - y);
      if ((this.round ? Math.min(away, this.to - this.from - away) : away) < reach && distance < least) [best, least] = [drive, distance];
    });
    return best;
  }
}

// Whether two paths are the same, to the digits that were written.
function samePath(p, q) {
  const known = p.findIndex((point, k) => point && q[k]);
  if (known < 0) return false;
  const size = Math.max(...p.filter(Boolean).map(([x, y]) => Math.abs(x) + Math.abs(y)), 1e-300);
  const step = Math.max(1, Math.floor(p.length / 24));
  for (let k = known; k < p.length; k += step) {
    if (p[k] && q[k] && Math.hypot(p[k][0] - q[k][0], p[k][1] - q[k][1]) > 1e-5 * size) return false;
  }
  return true;
}
