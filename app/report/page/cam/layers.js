// Extra layers of a cam's picture: drawn once on the cam, or anew at each position.

import { set, svg } from "../dom.js";
import { quantile, RADIANS } from "../sampling.js";
import { arrowPath, pathThrough, round, sectorPath } from "../shapes.js";
import { along, rotated } from "./model.js";

// Pixels between the common normal and the name of the angle.
const ANGLE_NAME_ROOM = 26;

// Teeth along the profile as long as it is curved there, and the line through their tips.
export function combPath(body, scale, radius) {
  const { profile, curvature } = body;
  const usual = quantile(curvature, 0.9);
  if (!(usual > 0)) return { teeth: "", tips: "" };
  const [unit, most] = [(0.16 * radius) / usual, 0.45 * radius];
  const tips = [];
  let teeth = "";
  profile.forEach((p, i) => {
    const [a, b] = [profile.at(i - 1), profile[(i + 1) % profile.length]];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const bend = curvature[i] ?? 0;
    const high = Math.sign(bend) * Math.min(most, unit * Math.abs(bend));
    const tip = length > 0 ? along(p, [-(b[1] - a[1]) / length, (b[0] - a[0]) / length], high) : p;
    tips.push([scale * tip[0], -scale * tip[1]]);
    if (i % Math.ceil(profile.length / 360) === 0) teeth += pathThrough([[scale * p[0], -scale * p[1]], tips.at(-1)]);
  });
  return { teeth, tips: `${pathThrough(tips)}Z` };
}

// The follower's rollers, edges or faces all round the cam as the cam sees them: the profile is what
// they leave free.
export function envelopePath(body, scale) {
  let d = "";
  for (let deg = 0; deg < 360; deg += 6) {
    const seen = (p) => rotated(p, -deg).map((v, k) => (k ? -scale : scale) * v);
    if (body.kind.flat) d += pathThrough(body.face(deg).map(seen));
    else {
      const [x, y] = seen(body.centre(deg)).map(round);
      const r = round(Math.max(1.5, scale * body.roller_radius));
      d += `M${round(x - r)} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
    }
  }
  return d;
}

// The contact, its common normal and the pressure angle between that and the follower's way.
export class PressureLayer {
  constructor(body, scale, size) {
    Object.assign(this, { body, scale, size });
    this.wedge = svg("path", { class: "wedge" });
    this.normal = svg("path", { class: "normal-line" });
    this.way = svg("path", { class: "way-line" });
    this.dot = svg("circle", { class: "contact", r: 3.6 });
    this.root = svg("g", {}, this.wedge, this.normal, this.way, this.dot);
  }

  local([x, y]) { return [this.scale * x, -this.scale * y]; }

  // Returns where the angle's name may stand, in the plane, or null.
  move(deg, missed) {
    const [contact, normal, way] = [this.body.contact(deg), this.body.normal(deg), this.body.way(deg)];
    this.root.toggleAttribute("hidden", !contact || !normal || !way);
    if (!contact || !normal || !way) return null;
    const { size } = this;
    const line = (p, direction, back, forth) => pathThrough([along(p, direction, -back), along(p, direction, forth)].map((q) => this.local(q)));
    set(this.normal, { d: line(contact, normal, 0.45 * size, Math.hypot(contact[0] - way.from[0], contact[1] - way.from[1]) + 1.25 * size) });
    set(this.way, { d: line(way.from, way.direction, 0, 1.25 * size) });
    const from = Math.atan2(way.direction[1], way.direction[0]) / RADIANS;
    const turn = Math.atan2(way.direction[0] * normal[1] - way.direction[1] * normal[0], way.direction[0] * normal[0] + way.direction[1] * normal[1]) / RADIANS;
    const p = this.local(way.from);
    set(this.wedge, { d: sectorPath(p, this.scale * size, from, from + turn) });
    this.wedge.classList.toggle("missed", missed);
    const [x, y] = this.local(contact).map(round);
    set(this.dot, { cx: x, cy: y });
    // The angle's name stands beside the normal, away from the follower's stem.
    const beside = (ANGLE_NAME_ROOM / this.scale / size) * Math.sign(turn || 1) / RADIANS;
    return along(way.from, rotated([1, 0], from + turn + beside), size);
  }
}

// Velocities of cam and follower where they touch.
export class VelocityLayer {
  constructor(body, scale, unit) {
    Object.assign(this, { body, scale, unit, root: svg("g", {}) });
    this.parts = Object.fromEntries(["cam", "follower"].map((kind) => [kind, svg("g", { class: `arrow ${kind}` }, svg("path", { class: "halo" }), svg("path", {}))]));
    this.root.append(...Object.values(this.parts));
  }

  move(deg) {
    for (const { kind, at, vector } of this.body.velocities(deg)) {
      const d = arrowPath([this.scale * at[0], -this.scale * at[1]], [this.unit * vector[0], -this.unit * vector[1]]);
      for (const line of this.parts[kind].children) set(line, { d });
    }
  }
}
