// A cam and its follower at any cam angle, in the frame's axes of a cam that turns counter-clockwise.

import { interpolate, locate, RADIANS } from "../sampling.js";

export const rotated = ([x, y], deg) => {
  const [c, s] = [Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];
  return [c * x - s * y, s * x + c * y];
};
export const along = (p, direction, length) => [p[0] + length * direction[0], p[1] + length * direction[1]];
const curvePoints = (curve) => curve.x.map((x, i) => [x, curve.y[i]]);
export const leastOf = (values) => values.reduce((a, b) => (b !== null && b < a ? b : a), Infinity);
export const greatestOf = (values) => values.reduce((a, b) => (b !== null && b > a ? b : a), -Infinity);

// One cam and the roller, edge or face that it touches; `turn` takes its upright position into the
// frame (the other of two conjugate cams).
class CamBody {
  constructor({ dimensions, start, side, profile, pitch, outer, table, turn_deg: turn = 0 }, kind) {
    Object.assign(this, { ...dimensions, start, side, table, turn, kind });
    this.profile = curvePoints(profile);
    this.angles = profile.deg;
    this.curvature = profile.curvature;
    this.pitch = pitch && curvePoints(pitch);
    this.outer = outer && curvePoints(outer);
    this.radius = Math.max(...this.profile.map((p) => Math.hypot(...p)));
    this.lowest = leastOf(table.displacement);
    this.highest = greatestOf(table.displacement);
    this.spins = this.#spins();
  }

  at(name, deg) { return interpolate(this.table[name], locate(this.table.deg, deg)); }

  // How far the roller has turned about itself from cam angle 0 on, in degrees of the frame: it
  // rolls on the cam without sliding.
  #spins() {
    const { deg, roller_speed: speed, displacement } = this.table;
    if (!speed) return null;
    const swing = this.kind.oscillating ? this.side : 0;
    let turned = 0;
    return deg.map((d, i) => {
      if (i) turned += ((speed[i] + speed[i - 1]) / 2) * (d - deg[i - 1]);
      return turned - swing * displacement[i];
    });
  }

  spin(deg, turns) {
    if (!this.spins) return 0;
    const whole = this.spins.at(-1) - this.spins[0];
    return turns * whole + interpolate(this.spins, locate(this.table.deg, deg));
  }

  // The angle in radians between an oscillating follower's arm and the line to the cam's centre.
  swing(deg) { return this.start + this.at("displacement", deg) * RADIANS; }
  get pivot() { return [0, this.centre_distance]; }

  // Unit vectors along the arm or the face of an oscillating follower, and square to it.
  arms(deg) {
    const [c, s] = [Math.cos(this.swing(deg)), Math.sin(this.swing(deg))];
    return { arm: [-this.side * s, -c], normal: [-this.side * c, s] };
  }

  // The centre of the roller, the tip of a knife edge.
  centre(deg) {
    if (this.kind.flat) return null;
    const p = this.kind.oscillating ? along(this.pivot, this.arms(deg).arm, this.arm)
      : [this.offset, this.start + this.at("displacement", deg)];
    return this.turn ? rotated(p, this.turn) : p;
  }

  // The ends of the face that is touched.
  face(deg) {
    const [low, high] = this.reaches;
    if (!this.kind.oscillating) {
      const ends = [low, high].map((x) => [x, this.start + this.at("displacement", deg)]);
      return this.turn ? ends.map((p) => rotated(p, this.turn)) : ends;
    }
    const { arm, normal } = this.arms(deg);
    const foot = along(this.pivot, normal, -this.face_offset);
    return [low, high].map((reach) => along(foot, arm, reach));
  }

  // From where to where the contact wanders along a face.
  get reaches() { return [leastOf(this.table.reach), greatestOf(this.table.reach)]; }

  contact(deg) {
    const p = [this.at("contact_x", deg), this.at("contact_y", deg)];
    return p[0] === null ? null : this.turn ? rotated(p, this.turn) : p;
  }

  normal(deg) {
    const n = [this.at("normal_x", deg), this.at("normal_y", deg)];
    const length = Math.hypot(...n);
    return length > 0 ? (this.turn ? rotated(n, this.turn) : n).map((v) => v / length) : null;
  }

  // Where the common normal meets the follower's way: the point whose pressure angle is meant, and
  // the unit direction in which it gives way.
  way(deg) {
    const { oscillating, flat } = this.kind;
    const from = flat ? this.contact(deg) : this.centre(deg);
    if (!from || !oscillating) return from && { from, direction: this.turn ? rotated([0, 1], this.turn) : [0, 1] };
    const [x, y] = [from[0], from[1] - this.centre_distance];
    const length = Math.hypot(x, y) || 1;
    return { from, direction: [(this.side * y) / length, (-this.side * x) / length] };
  }

  // Velocities at the contact for a cam that turns by a radian in unit time.
  velocities(deg) {
    const p = this.contact(deg);
    const way = this.way(deg);
    if (!p || !way) return [];
    const reach = this.kind.oscillating ? Math.hypot(way.from[0], way.from[1] - this.centre_distance) : 1;
    const v = reach * this.at("velocity", deg);
    return [{ kind: "cam", at: p, vector: [-p[1], p[0]] }, { kind: "follower", at: p, vector: way.direction.map((d) => v * d) }];
  }
}

// The second contact of a follower of constant breadth: where the first is half a turn later.
class FarContact extends CamBody {
  constructor(drawn, kind) { super({ ...drawn, turn_deg: 180 }, kind); }
  at(name, deg) { return super.at(name, (deg + 180) % 360); }
  spin(deg, turns) { return super.spin((deg + 180) % 360, deg < 180 ? turns : turns + 1); }
}

export class CamDesign {
  constructor(drawn, data) {
    Object.assign(this, { drawn, kind: data, deg: 0 });
    this.first = new CamBody(drawn, data);
    this.second = drawn.second ? new CamBody(drawn.second, data) : null;
    this.bodies = [this.first, this.second].filter(Boolean);
    this.far = data.closure === "constant-breadth" ? new FarContact(drawn, data) : null;
    this.contacts = [...this.bodies, this.far].filter(Boolean);
    this.mirror = data.clockwise ? -1 : 1;
    const walls = this.first.outer ?? [];
    this.radius = Math.max(...this.bodies.map((b) => b.radius), ...walls.map((p) => Math.hypot(...p)));
    // What parts of the follower have no size of their own are drawn by.
    this.part = 0.11 * this.radius;
  }

  get sound() { return this.first.profile.every((p) => p.every((v) => v !== null)) && this.radius > 0; }

  // The distance of the parallel faces of a follower of constant breadth.
  get breadth() {
    if (!this.far) return null;
    const { first } = this;
    return 2 * first.start + first.at("displacement", 0) + first.at("displacement", 180);
  }

  // Where a stroke's part of the profile begins and ends.
  strokes() {
    const { angles, profile } = this.first;
    const parts = this.drawn.strokes.map(({ from_deg: from, to_deg: to, stroke }) => ({ stroke,
      points: profile.filter((_, i) => angles[i] >= from - 1e-4 && angles[i] <= to + 1e-4) }));
    parts.at(-1)?.points.push(profile[0]);
    return parts;
  }

  // The stroke at a cam angle: "rise", "return" or "dwell".
  strokeAt(deg) { return this.drawn.strokes.find((s) => deg >= s.from_deg && deg < s.to_deg)?.stroke ?? ""; }
}
