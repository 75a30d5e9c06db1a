// A slider-crank in motion: the crank AB turns fully and drives the slider C along its guide by the rod BC.

import { RADIANS } from "../sampling.js";

export class SliderLinkage {
  // `mechanism`: pivot, crank, coupler, offset of the guide to the left of its direction, direction_deg, assembly, coupler_point.
  constructor(mechanism) {
    const angle = mechanism.direction_deg * RADIANS, along = [Math.cos(angle), Math.sin(angle)];
    Object.assign(this, { mechanism, along, across: [-along[1], along[0]], fullTurn: true, closure: { a: mechanism.pivot, d: null } });
    const [near, far] = this.#ends(mechanism);
    this.guide = far > near ? [near, far].map((travel) => this.#onGuide(travel)) : [];
    this.stroke = far - near;
  }

  // The slider's travels where crank and rod lie in one line, the lesser first.
  #ends({ crank, coupler, offset, assembly }) {
    const ahead = assembly === "crossed" ? -1 : 1, travel = (reach) => ahead * Math.sqrt(Math.max(0, (reach - offset) * (reach + offset)));
    return [travel(coupler - crank), travel(coupler + crank)].toSorted((p, q) => p - q);
  }

  // Also where the slider goes, whichever way along its guide counts.
  get lengths() {
    const { mechanism: { crank, coupler }, guide: [p, q], along: [x, y], stroke } = this, middle = p ? [0, 1].map((k) => (p[k] + q[k]) / 2) : [];
    return [crank, coupler, ...middle, stroke * (x * x - y * y), stroke * 2 * x * y];
  }

  // The place on the guide so far from the foot of the pivot on it.
  #onGuide(travel) { return [0, 1].map((k) => this.mechanism.pivot[k] + travel * this.along[k] + this.mechanism.offset * this.across[k]); }

  // The joints, the point P and the slider's travel, the crank at `angle` from the x axis in radians. Null where the rod does not reach.
  pose(angle) {
    const { pivot, crank, coupler, offset, assembly, coupler_point: [u, v] } = this.mechanism;
    const b = [pivot[0] + crank * Math.cos(angle), pivot[1] + crank * Math.sin(angle)], arm = [b[0] - pivot[0], b[1] - pivot[1]];
    const rise = offset - arm[0] * this.across[0] - arm[1] * this.across[1];
    if (Math.abs(rise) > coupler) return null;
    const reach = (assembly === "crossed" ? -1 : 1) * Math.sqrt((coupler - rise) * (coupler + rise));
    const travel = arm[0] * this.along[0] + arm[1] * this.along[1] + reach, c = this.#onGuide(travel);
    const [x, y] = [(c[0] - b[0]) / coupler, (c[1] - b[1]) / coupler];
    return { b, c, p: [b[0] + u * x - v * y, b[1] + u * y + v * x], travel, crank: angle / RADIANS };
  }
}
