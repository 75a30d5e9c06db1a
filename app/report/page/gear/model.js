// Gears as their outlines have them, and how two of them turn in mesh: the pinion counter-clockwise
// about the origin, the wheel about a point on the x axis. Angles in radians but for the drive's.

import { RADIANS } from "../sampling.js";

export const turned = ([x, y], angle) => {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y];
};
export const polar = (radius, angle) => [radius * Math.cos(angle), radius * Math.sin(angle)];
export const UPRIGHT = Math.PI / 2;
export const PARTS = ["root", "fillet", "involute", "tip"];

// At most so many teeth are drawn; of more, and of virtual gears, a sector.
const MOST_TEETH = 400;
// So near to a tangent point, as a share of the line of action, contact is on the base circle.
const ON_BASE = 1e-6;

export class GearBody {
  // `drawn.half`: x, y and part from a root's middle to the tip's, of the tooth upright on the y axis.
  constructor(drawn) {
    Object.assign(this, drawn);
    this.pitch = (2 * Math.PI) / this.teeth;
    this.points = drawn.half.x.map((x, i) => [x, drawn.half.y[i]]);
    this.sound = this.points.length > 1;
    // Where the tooth ends: a pointed one below its tip circle.
    this.tip_end = this.sound ? Math.hypot(...this.points.at(-1)) : 0;
    // From the space clockwise of the tooth to that on its other side.
    this.tooth = [...this.points.map(([x, y]) => [-x, y]), ...[...this.points].reverse()];
    this.isWhole = Number.isInteger(this.teeth) && this.teeth <= MOST_TEETH;
  }

  // Closed about the centre: round, or of a sector whose teeth face upwards.
  outline() {
    const side = this.isWhole ? null : Math.floor(Math.min(this.teeth / 2 - 1, Math.max(8, 0.9 / this.pitch)));
    const numbers = this.isWhole ? Array.from({ length: this.teeth }, (_, k) => k) : Array.from({ length: 2 * side + 1 }, (_, k) => k - side);
    const points = numbers.flatMap((k) => this.tooth.map((p) => turned(p, k * this.pitch)));
    return this.isWhole ? points : [...points, ...[side + 0.5, -side - 0.5].map((k) => polar((this.is_ring ? 1.1 : 0.9) * this.root, UPRIGHT + k * this.pitch))];
  }

  // A sector is moved on by teeth only as far as one.
  shown(angle) { return this.isWhole ? angle : angle - this.pitch * Math.round(angle / this.pitch); }
}

export class GearMesh {
  constructor(drawn) {
    Object.assign(this, drawn, { drawn, pinion: new GearBody(drawn.gears[0]), wheel: new GearBody(drawn.gears[1]) });
    const { pinion, wheel, centre_distance: a, working_angle: angle } = this;
    this.bodies = [pinion, wheel];
    this.sound = this.bodies.every((body) => body.sound) && a > 0;
    this.meshes = this.sound && angle !== null && angle !== undefined;
    this.ratio = wheel.teeth / pinion.teeth;
    // A ring's centre is on the pinion's side, and it turns with the pinion.
    this.side = wheel.is_ring ? -1 : 1;
    this.reach = wheel.is_ring ? wheel.root + 2.5 * wheel.module : wheel.tip;
    this.basePitch = pinion.base * pinion.pitch;
    this.span = this.meshes ? this.side * a * Math.sin(angle) : 0; // from one tangent point to the other
    this.pitchPoint = this.meshes ? pinion.base * Math.tan(angle) : 0;
    this.touches = this.meshes && this.path_end > this.path_start;
    [this.start, this.end] = this.touches ? [this.path_start, this.path_end] : [this.pitchPoint, this.pitchPoint];
    this.pairs = Math.max(1, Math.ceil((this.end - this.start) / this.basePitch - 1e-9));
  }

  // The way of the tooth pair that begins contact at drive 0, from the pinion's tangent point on.
  reached(deg) { return this.start + this.pinion.base * deg * RADIANS; }

  // That of the pair that the page follows: the one that began, until it leaves and the next begins.
  followed(deg) {
    const turns = (this.pinion.base * deg * RADIANS) / this.basePitch;
    const way = this.start + this.basePitch * (turns - this.pairs * Math.floor(turns / this.pairs));
    return this.touches && way <= this.end ? way : null;
  }

  // Ways of all tooth pairs in contact, increasing.
  contacts(deg) {
    if (!this.touches) return [];
    const way = this.reached(deg);
    const ways = [];
    for (let k = Math.ceil((this.start - way) / this.basePitch - 1e-9); way + k * this.basePitch <= this.end; ++k) ways.push(way + k * this.basePitch);
    return ways;
  }

  count(way) { return this.touches ? Math.floor((this.end - way) / this.basePitch) + Math.floor((way - this.start) / this.basePitch) + 1 : 0; }

  // Directions of the middles of the two teeth that touch at `way`.
  directions(way) {
    const { pinion, wheel, working_angle: angle } = this;
    if (!this.meshes) return null;
    const ofWheel = wheel.is_ring ? (way - this.span) / wheel.base - angle - wheel.half_angle : Math.PI - angle + (this.span - way) / wheel.base - wheel.half_angle;
    return [way / pinion.base - angle - pinion.half_angle, ofWheel];
  }

  // Those of one tooth of each, wherever they are; gears that cannot mesh face tooth to space.
  turns(deg) {
    const facing = this.side < 0 ? 0 : Math.PI;
    return this.directions(this.reached(deg)) ?? [deg * RADIANS, facing + this.wheel.pitch / 2 - this.side * (deg * RADIANS) / this.ratio];
  }

  // The point of the line of action that is `way` beyond the pinion's tangent point.
  at(way) {
    const { working_angle: angle, pinion } = this;
    const [x, y] = polar(pinion.base, -angle);
    return [x + way * Math.sin(angle), y + way * Math.cos(angle)];
  }

  // Specific sliding of the pinion's flank and of the wheel's: 1 − v of the other / v of its own.
  sliding(way) {
    const other = this.side * (this.span - way);
    const slide = (own, against) => (Math.abs(own) < ON_BASE * this.span ? -Infinity : 1 - against / own);
    return [slide(this.ratio * way, other), slide(other, this.ratio * way)];
  }

  // Sliding speed over that of the pitch line.
  slidingSpeed(way) { return (Math.abs(way - this.pitchPoint) * (1 + this.side / this.ratio)) / this.pinion.working; }

  // Where the number of pairs in contact changes, with both ends of the path.
  borders() {
    const places = [this.start, this.end];
    for (let k = 1; k < this.pairs; ++k) places.push(this.start + k * this.basePitch, this.end - k * this.basePitch);
    return [...new Set(places)].sort((a, b) => a - b);
  }
}
