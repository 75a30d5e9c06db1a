// What moves an analysed mechanism within its tolerances: the evaluator in the page.

import { AnalysisKernel } from "../edit/analysis_kernel.js";
import { Mechanism } from "../mechanism.js";
import { interpolate, locate } from "../sampling.js";
import { withDimension, withDimensions } from "./changed.js";

const bodyNamed = (mechanism, name) => mechanism.bodies.findIndex((body) => body.name === name);

class AnalysisMover {
  // `problem` as results hold it, `drive` the sweep of what is drawn.
  constructor(problem, drive) { Object.assign(this, { problem, drive }); }

  knows(name) { return withDimension(this.problem.mechanism, name, 0) !== null; }

  measures({ name }) { return !name.endsWith(" transmission"); }

  async changed(changes) {
    AnalysisMover.kernel ??= await AnalysisKernel.load();
    this.nominal ??= this.#motion(this.problem.mechanism);
    const table = withDimensions(this.problem.mechanism, changes);
    return this.nominal && table && this.#motion(table);
  }

  #motion(mechanism) {
    const data = AnalysisMover.kernel.motion({ ...this.problem, mechanism });
    return data.faults ? null : new Mechanism(data.mechanism, this.drive);
  }

  deviation(state, { name }, drive) {
    const [before, now] = [this.nominal, state];
    const at = [before, now].map((mechanism) => mechanism.places(drive));
    const point = before.points.find((one) => one.name === name);
    if (point) {
      const [p, q] = at.map((places) => Mechanism.point(places[point.body], (places === at[0] ? before : now).points.find((one) => one.name === name).at));
      return p && q ? Math.hypot(q[0] - p[0], q[1] - p[1]) : null;
    }
    const body = bodyNamed(before, name);
    if (body < 0 || !at[0][body] || !at[1][body]) return null;
    if (!Array.isArray(before.bodies[body].deg)) {
      const [[x, y, c, s], [u, v]] = [at[0][body], at[1][body]];
      return (u - x) * c + (v - y) * s;
    }
    const [p, q] = [before, now].map((mechanism) => interpolate(mechanism.bodies[body].deg, locate(mechanism.samples, mechanism.within(drive))));
    return q - p - 360 * Math.round((q - p) / 360);
  }

  outlines(state, drive) {
    const [at, to] = [this.nominal, state].map((mechanism) => mechanism.places(drive));
    const line = (mechanism, places, i) => mechanism.bodies[i].outline.map((corner) => Mechanism.point(places[i], corner));
    const lines = this.nominal.bodies.flatMap(({ outline }, i) => (i && at[i] && to[i] && outline.length > 1 ? [[line(this.nominal, at, i), line(state, to, i)]] : []));
    const traced = this.nominal.points.findIndex((point) => point.moves && !point.isPin);
    return { lines, curve: traced < 0 ? null : [this.nominal.points[traced].path, state.points[traced].path] };
  }
}

// What the card needs to know of an analysis.
export function analysisTolerances(problem, drive, mechanism, xLabel, canMove) {
  const { x0, x1, y0, y1 } = mechanism.box;
  const inRange = (at) => at >= mechanism.from - 1e-9 && at <= mechanism.to + 1e-9;
  const limit = problem.tolerance?.yield;
  return { xOf: (at) => (inRange(at) ? at : mechanism.within(at)), range: [mechanism.from, mechanism.to], xLabel, size: Math.hypot(x1 - x0, y1 - y0), limit: limit?.max_error_deg ?? limit?.max_error,
    mover: canMove ? new AnalysisMover(problem, drive) : null };
}
