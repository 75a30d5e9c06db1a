// How the foot of a leg walks: its height and its speed along the ground, and the part of the turn in which it stands.

import { padded } from "../curves.js";
import { degrees, number } from "../format.js";
import { interpolate, locate } from "../sampling.js";
import { say } from "../words.js";

const STANCE = "--accent-soft";

export class Walk {
  // `ends`: the crank angles between which the foot stands; `samples` of the turn and the foot's `path` there; `metrics` of the design.
  constructor([from, to], samples, path, metrics) {
    Object.assign(this, { samples, path, metrics, from, span: to > from ? to - from : to + 360 - from });
    this.ground = Math.min(...path.map(([, y]) => y));
    this.heights = path.map(([, y]) => y - this.ground);
    this.ways = path.map(([x]) => x);
    this.speeds = this.#speeds();
  }

  stands(deg) { return (((deg - this.from) % 360) + 360) % 360 <= this.span; }

  // Stretches of the axis from the first sample to the last in which the foot stands.
  get shades() {
    const [first, last] = [this.samples[0], this.samples.at(-1)];
    return [-360, 0, 360].map((turn) => ({ axis: "x", from: Math.max(first, this.from + turn), to: Math.min(last, this.from + this.span + turn), colour: STANCE })).filter(({ from, to }) => to > from);
  }

  // dx by the crank angle over what it is on average while the foot stands, from the samples on either side.
  #speeds() {
    const { samples, ways } = this;
    const last = samples.length - 1;
    const mean = (Math.sign(this.#at(this.from + this.span) - this.#at(this.from)) * this.metrics.stride) / this.span;
    return samples.map((_, i) => {
      const [j, k] = [i > 0 ? i - 1 : last - 1, i < last ? i + 1 : 1];
      const turn = (samples[k] - samples[j] + 360) % 360;
      return (ways[k] - ways[j]) / turn / mean;
    });
  }

  #at(deg) {
    const [first] = this.samples;
    return interpolate(this.ways, locate(this.samples, first + ((((deg - first) % 360) + 360) % 360)));
  }

  // The foot's positions while it stands.
  get stance() {
    const steps = 120;
    return Array.from({ length: steps + 1 }, (_, i) => this.placeAt(this.from + (this.span * i) / steps));
  }

  placeAt(deg) {
    const [first] = this.samples;
    const place = locate(this.samples, first + ((((deg - first) % 360) + 360) % 360));
    return [interpolate(this.ways, place), interpolate(this.heights, place) + this.ground];
  }

  // Pieces of the path in which the foot goes one way along the ground.
  #branches() {
    const { ways } = this;
    const branches = [[0]];
    for (let i = 1; i < ways.length; ++i) {
      const sense = Math.sign(ways[i] - ways[i - 1]);
      const branch = branches.at(-1);
      if (branch.length > 1 && sense * (ways[branch[1]] - ways[branch[0]]) < 0) branches.push([i - 1]);
      branches.at(-1).push(i);
    }
    return branches.filter((branch) => branch.length > 1);
  }

  sheets(overDrive) {
    return [this.#heightSheet(overDrive), this.#pathSheet(), this.#speedSheet(overDrive)];
  }

  #heightSheet(overDrive) {
    const { metrics } = this;
    return { ...overDrive, x: this.samples, title: say("unit.axis", { name: say("walk.height"), unit: say("unit.length") }), lines: [{ y: this.heights, colour: "--curve" }], shades: this.shades,
      note: say("walk.height_note", { height: number(metrics.step_height, 5), from: degrees(this.from, 1), to: degrees((this.from + this.span) % 360, 1) }),
      summary: say("range.at_most_unit", { value: number(metrics.step_height, 5), unit: say("unit.length") }) };
  }

  // The path in its own plane; heights are drawn larger than distances.
  #pathSheet() {
    const { ways, heights, samples, metrics } = this;
    const branches = this.#branches();
    const x = [...new Set(ways)].sort((a, b) => a - b);
    const lines = branches.map((branch) => {
      const order = [...branch].sort((i, j) => ways[i] - ways[j]);
      const [xs, ys] = [order.map((i) => ways[i]), order.map((i) => heights[i])];
      return { y: x.map((at) => (at < xs[0] || at > xs.at(-1) ? null : interpolate(ys, locate(xs, at)))), colour: "--curve" };
    });
    const stance = this.stance.map(([at]) => at);
    const [from, to] = [Math.min(...stance), Math.max(...stance)];
    const standing = samples.map((_, i) => i).filter((i) => this.stands(samples[i])).sort((i, j) => ways[i] - ways[j]);
    return { x, xRange: padded(x[0], x.at(-1)), xLabel: say("unit.axis", { name: say("walk.along"), unit: say("unit.length") }), title: say("unit.axis", { name: say("walk.path"), unit: say("unit.length") }), lines, hover: false,
      shades: [{ axis: "x", from, to, colour: STANCE }], xAt: (deg) => this.placeAt(deg)[0],
      driveAt: (at) => (standing.length ? samples[standing.reduce((best, i) => (Math.abs(ways[i] - at) < Math.abs(ways[best] - at) ? i : best))] : null),
      note: say("walk.path_note", { stride: number(metrics.stride, 5), band: number(metrics.flatness * metrics.stride, 4) }), summary: say("walk.path_note", { stride: number(metrics.stride, 5), band: number(metrics.flatness * metrics.stride, 4) }) };
  }

  #speedSheet(overDrive) {
    const { metrics } = this;
    const note = say("walk.speed_note", { least: number(metrics.foot_speed_min, 4), greatest: number(metrics.foot_speed_max, 4) });
    return { ...overDrive, x: this.samples, title: say("walk.speed"), lines: [{ y: this.speeds, colour: "--velocity" }], shades: this.shades, note, summary: note };
  }
}
