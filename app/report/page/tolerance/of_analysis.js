// What the card of tolerances needs to know of an analysis.

import { MechanismMover } from "./mechanism_mover.js";

export function analysisTolerances(problem, drive, mechanism, xLabel, canMove) {
  const { x0, x1, y0, y1 } = mechanism.box;
  const inRange = (at) => at >= mechanism.from - 1e-9 && at <= mechanism.to + 1e-9;
  const limit = problem.tolerance?.yield;
  return { xOf: (at) => (inRange(at) ? at : mechanism.within(at)), range: [mechanism.from, mechanism.to], xLabel, size: Math.hypot(x1 - x0, y1 - y0), limit: limit?.max_error_deg ?? limit?.max_error,
    mover: canMove ? new MechanismMover(problem, drive) : null };
}
