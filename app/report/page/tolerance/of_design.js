// What moves a four-bar design within its tolerances: the kernel of four-bars in the page.

import { Kernel } from "../kernel.js";
import { RADIANS } from "../sampling.js";
import { say } from "../words.js";
import { diagonal } from "../view.js";
import { withDimension, withDimensions } from "./changed.js";
import { DesignMover, targetAt } from "./design_mover.js";
import { isDistance, isTransmission } from "./quantity.js";

const CURVE_SAMPLES = 181;

class FourBarMover {
  constructor(design, timed) { Object.assign(this, { design, timed, table: design.entry.mechanism }); }

  knows(name) { return withDimension(this.table, name, 0) !== null; }

  measures(quantity) { return !isTransmission(quantity) && (quantity.unit === "deg" || Boolean(this.table.coupler_point && (quantity.along || this.timed))); }

  async changed(changes) {
    FourBarMover.kernel ??= await Kernel.load();
    const table = withDimensions(this.table, changes);
    return table && FourBarMover.kernel.take(table) ? table : null;
  }

  // Where a linkage stands at crank angles in degrees.
  #poses(table, cranks) {
    FourBarMover.kernel.take(table);
    return FourBarMover.kernel.poses(cranks.map((deg) => deg * RADIANS));
  }

  // `k`: the number of the position.
  deviation(state, { unit, along }, drive, k) {
    const [before, now] = [this.table, state].map((table) => this.#poses(table, [drive])[0]);
    if (!before || !now) return null;
    if (unit === "deg") { const turned = (now.rocker - before.rocker) / RADIANS; return turned - 360 * Math.round(turned / 360); }
    if (along) return along[k][0] * (now.p[0] - before.p[0]) + along[k][1] * (now.p[1] - before.p[1]);
    const target = targetAt(this.design, drive);
    return target ? Math.hypot(now.p[0] - target[0], now.p[1] - target[1]) : null;
  }

  outlines(state, drive) {
    const pair = [this.table, state].map((table) => [table, this.#poses(table, [drive])[0]]);
    if (pair.some(([, pose]) => !pose)) return null;
    const loops = pair.map(([{ fixed_pivots: [a, d] }, { b, c, p }]) => [[a, b, c, d], ...(p ? [[b, p, c]] : [])]);
    const cranks = Array.from({ length: CURVE_SAMPLES }, (_, i) => this.design.from + ((this.design.to - this.design.from) * i) / (CURVE_SAMPLES - 1));
    const curve = this.table.coupler_point ? [this.table, state].map((table) => this.#poses(table, cranks).map((pose) => pose?.p ?? null)) : null;
    return { lines: loops[0].map((line, i) => [line, loops[1][i]]), curve };
  }
}

function moverOf(design, timed) {
  if (!design.assembles) return null;
  if (design.entry.mechanism.type === "four-bar") return Kernel.available ? new FourBarMover(design, timed) : null;
  return design.angular && DesignMover.available ? new DesignMover(design) : null;
}

// What the card needs to know of a design.
export function designTolerances(design, problem, kind) {
  const timed = isDistance(design.entry.tolerance?.quantities?.find(({ judged }) => judged) ?? {});
  const onPath = kind === "path" && !timed && design.assembles;
  const inRange = (at) => at >= design.from && at <= design.to;
  const limit = problem?.tolerance?.yield;
  return { xOf: (at) => (inRange(at) ? at : design.within(at)), range: [design.from, design.to], xLabel: say(design.angular ? "drive.angle_axis" : "drive.way_axis", { name: design.driveName }),
    size: design.boxes.whole ? diagonal(design.boxes.whole) : 1, limit: limit?.max_error_deg ?? limit?.max_error, mover: moverOf(design, timed),
    acrossAt: onPath ? (crank) => acrossPath(design, crank) : undefined };
}

// The place of the coupler point and the direction across its path.
function acrossPath(design, crank) {
  const [at, before, ahead] = [0, -0.05, 0.05].map((turn) => design.pointAt(crank + turn));
  if (!at || !before || !ahead) return null;
  const [u, v] = [ahead[0] - before[0], ahead[1] - before[1]];
  const speed = Math.hypot(u, v);
  return speed > 0 ? { at, normal: [-v / speed, u / speed] } : null;
}
