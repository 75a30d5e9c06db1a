// A front: how small the error of a drawing can be for each lower bound of the transmission angle, and by which design.

import { withoutNoise } from "./candidate.js";
import { drawingSize, kindsOf, questionFrom, suits } from "./question.js";

const LEVELS = [10, 20, 30, 40, 50, 60, 70];
// What is searched for in turn: for each level from its neighbours, so that there soon is a front, then anew, and once more from
// neighbours.
const upwards = (fresh) => LEVELS.map((_, i) => ({ i, fresh }));
const SEARCHES = [...upwards(false), ...upwards(true), ...upwards(false).reverse()];
// Of two errors that differ by less the one with the greater angle counts alone.
const TIE = 1e-6;
const ANGLE_ROUNDING = 1e-6;   // degrees

const angleOf = ({ entry }) => entry.transmission_acute_min_deg;

// What a front depends on: all of the state but the bound that it varies.
const ground = ({ points, angles, ranges, closed, slides, both, straight, class: asked, reach, even, region, obstacle }) => JSON.stringify([points, angles, ranges, slides && [both, closed], straight && [even], asked, reach, region, obstacle]);

export class Front {
  constructor() { Object.assign(this, { ground: null, pool: [], done: 0, size: 1, least: LEVELS[0] }); }

  // Begins anew with the next state.
  forget() { this.ground = null; }

  // Goes on where the state is another only in the bound, else begins anew.
  follow(state) {
    Object.assign(this, { state, size: drawingSize(state) });
    if (ground(state) !== this.ground) Object.assign(this, { ground: ground(state), pool: [], done: 0 });
  }

  // Takes up designs within all limits but the bound, whichever search found them.
  add(candidates) {
    this.pool.push(...candidates.filter((one) => one.poses.length > 1 && one.entry.rms < this.size));
  }

  // Whether every level has been looked at, so that what there is has the shape of a front.
  get stands() { return this.done >= LEVELS.length; }

  // Nothing is better than no error at the greatest bound.
  get ended() { return this.done === SEARCHES.length || (this.stands && this.points.some(({ level, error }) => level === LEVELS.at(-1) && error === 0)); }

  // The next question, until it has ended.
  get question() {
    const { i, fresh } = SEARCHES[this.done];
    const neighbours = kindsOf(this.state).flatMap((kind) => [i - 1, i, i + 1].map((k) => this.#best(LEVELS[k], kind))).filter(Boolean);
    const state = { ...this.state, least: LEVELS[i] };
    return { ...questionFrom(state, [...new Set(neighbours)], fresh), front: true };
  }

  // The answer to the question.
  take(candidates) {
    this.done += 1;
    this.add(candidates);
  }

  #error({ entry }) { return withoutNoise(entry.rms, this.size); }

  // Of the mechanisms that `state` asks for.
  #best(level, state = this.state) {
    return this.within(level).filter(({ entry }) => suits(entry, state)).sort((a, b) => this.#error(a) - this.#error(b) || angleOf(b) - angleOf(a))[0];
  }

  // The designs within a bound.
  within(least) { return this.pool.filter((one) => angleOf(one) >= least - ANGLE_ROUNDING); }

  // A design by what the axes are of.
  pointOf(candidate) { return { candidate, angle: angleOf(candidate), error: this.#error(candidate) }; }

  // The points {candidate, level, angle, error} that none beats in both, by rising angle; `level`: the greatest bound met.
  get points() {
    const points = [];
    for (const level of LEVELS.toReversed()) {
      const candidate = this.#best(level);
      if (!candidate || points[0]?.error <= this.#error(candidate) * (1 + TIE)) continue;
      points.unshift({ ...this.pointOf(candidate), level });
    }
    return points;
  }
}
