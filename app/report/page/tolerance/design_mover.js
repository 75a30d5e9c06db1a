// A design that is no four-bar moved within its tolerances, and how far what is judged of it is then off.

import { embedded } from "../embedded.js";
import { MechanismMover } from "./mechanism_mover.js";
import { isDistance } from "./quantity.js";

const MODULE = "mechanism-kernel";

// The target that a design reaches at a drive coordinate in degrees: stations are rounded.
export function targetAt({ stations, targets }, drive) {
  const off = stations.map((deg) => Math.abs(drive - deg - 360 * Math.round((drive - deg) / 360)));
  return targets[off.indexOf(Math.min(...off))];
}

export class DesignMover extends MechanismMover {
  static get available() { return embedded(MODULE).trim() !== ""; }

  constructor(design) {
    const { from, to } = design;
    super({ kind: "analysis", mechanism: design.entry.mechanism, drive: { start_deg: from, end_deg: to } }, { from, to, round: design.fullTurn }, embedded(MODULE));
    // The origin of a guided body is a point, also where it is a pin.
    Object.assign(this, { design, point: design.poses.length ? "P" : design.point?.name });
  }

  measures(quantity) { return super.measures(quantity) && Boolean(this.point || !(quantity.along || isDistance(quantity))); }

  // `k`: the number of the position.
  deviation(state, quantity, drive, k) {
    const { design } = this;
    const { along } = quantity;
    const at = design.within(drive);
    if (!along && !isDistance(quantity)) return this.bodyDeviation(state, this.nominal.bodies[this.nominal.output].name, at);
    const [p, q] = this.places(state, this.point, at);
    if (!p || !q) return null;
    if (along) return along[k][0] * (q[0] - p[0]) + along[k][1] * (q[1] - p[1]);
    const target = targetAt(design, drive);
    return target && Math.hypot(q[0] - target[0], q[1] - target[1]);
  }
}
