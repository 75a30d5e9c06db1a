// A mechanism of any kind moved within its tolerances: the evaluator of analyses in the page.

import { AnalysisKernel } from "../edit/analysis_kernel.js";
import { Mechanism } from "../mechanism.js";
import { interpolate, locate } from "../sampling.js";
import { withDimension, withDimensions } from "./changed.js";
import { isTransmission } from "./quantity.js";

const bodyNamed = (mechanism, name) => mechanism.bodies.findIndex((body) => body.name === name);

export class MechanismMover {
  // `problem` as results of analyses hold it, `drive` the sweep of what is drawn, `module` the evaluator in base64.
  constructor(problem, drive, module) { Object.assign(this, { problem, drive, module }); }

  knows(name) { return withDimension(this.problem.mechanism, name, 0) !== null; }

  measures(quantity) { return !isTransmission(quantity); }

  async changed(changes) {
    MechanismMover.kernel ??= await AnalysisKernel.load(this.module);
    this.nominal ??= this.#motion(this.problem.mechanism);
    const table = withDimensions(this.problem.mechanism, changes);
    return this.nominal && table && this.#motion(table);
  }

  #motion(mechanism) {
    const data = MechanismMover.kernel.motion({ ...this.problem, mechanism });
    return data.faults ? null : new Mechanism(data.mechanism, this.drive);
  }

  deviation(state, { name }, drive) {
    if (this.nominal.points.some((one) => one.name === name)) {
      const [p, q] = this.places(state, name, drive);
      return p && q ? Math.hypot(q[0] - p[0], q[1] - p[1]) : null;
    }
    return this.bodyDeviation(state, name, drive);
  }

  // Where the point `name` is, as designed and as set; null where it is nowhere.
  places(state, name, drive) {
    return [this.nominal, state].map((mechanism) => {
      const { body, at } = mechanism.points.find((one) => one.name === name);
      return Mechanism.point(mechanism.places(drive)[body], at);
    });
  }

  // By how much the body `name` is turned, or has slid along its own first axis.
  bodyDeviation(state, name, drive) {
    const [before, now] = [this.nominal, state];
    const at = [before, now].map((mechanism) => mechanism.places(drive));
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
