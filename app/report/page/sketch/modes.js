// What differs by what is drawn: a curve, poses of a body, a function, or a straight line.

import { number } from "../format.js";
import { say } from "../words.js";
import { Candidate } from "./candidate.js";
import { Generator } from "./generator.js";
import { placeOf } from "./layout.js";
import { pairsOfStroke, withPair, withPairMoved } from "./pairs.js";
import { directionOf } from "./posed.js";
import { placedOn, SHORTEST_LINE } from "./ruled.js";
import { rounded, strokeTargets } from "./stroke.js";

const FIRST_RANGES = [90, 60];
const NOTHING = { points: [], angles: null, ranges: null, typed: null, closed: false, stroke: false, slides: false, both: false, straight: false };

const posed = ({ points, angles }, place, degrees) => ({ points: [...points, rounded(place)], angles: [...angles, degrees] });

const isLine = ([p, q]) => Math.hypot(q[0] - p[0], q[1] - p[1]) >= SHORTEST_LINE;

// Of each: the least number of targets; its texts; the kind after it; `empty(state)`, a state without a drawing; where the targets stand on the
// sheet; the label of the handle of one; whether slider-cranks can be searched for; what a stroke, a click (on target i, if any), a drag of target i and its removal change,
// null where that is nothing; a design that was found.
const CURVE = {
  name: "curve", fewest: 3, hint: "sketch.hint", more: "sketch.more_points", title: "sketch.title_of_file", times: "sketch.times", next: () => POSES, canSlide: true,
  empty: ({ slides = false, both = false }) => ({ ...NOTHING, slides, both }),
  places: ({ points }) => points,
  label: (_, i) => say("sketch.point", { name: i + 1 }),
  stroke: (_, line) => ({ ...strokeTargets(line), stroke: true }),
  // Behind the others, on the first of them it closes the curve; after a stroke it begins anew.
  click({ points, stroke: drawn, closed }, place, i) {
    if (i === undefined) return { points: drawn ? [rounded(place)] : [...points, rounded(place)], stroke: false, closed: drawn ? false : closed };
    return i === 0 && !drawn && points.length >= 3 ? { closed: !closed } : null;
  },
  moved: ({ points }, i, place) => ({ points: points.with(i, rounded(place)) }),
  removed: ({ points }, i) => ({ points: points.toSpliced(i, 1) }),
  candidate: (entry) => new Candidate(entry),
};

const POSES = {
  ...CURVE, name: "poses", fewest: 2, hint: "sketch.hint_of_poses", more: "sketch.more_poses", title: "sketch.title_of_poses", next: () => FUNCTION, canSlide: false,
  empty: () => ({ ...NOTHING, angles: [] }),
  label: (_, i) => say("sketch.pose", { name: i + 1 }),
  // At the start of the stroke, in the direction of its end; by a click in that of the last pose.
  stroke: (state, line) => posed(state, line[0], directionOf(line[0], line.at(-1))),
  click: (state, place, i) => (i === undefined ? posed(state, place, state.angles.at(-1) ?? 0) : null),
  removed: ({ points, angles }, i) => ({ points: points.toSpliced(i, 1), angles: angles.toSpliced(i, 1) }),
};

const FUNCTION = {
  ...CURVE, name: "function", hint: "sketch.hint_of_function", more: "sketch.more_pairs", title: "sketch.title_of_function", times: "sketch.times_shortest", next: () => RULED, canSlide: false,
  empty: ({ ranges }) => ({ ...NOTHING, ranges: ranges ?? FIRST_RANGES, region: null, obstacle: null }),
  places: ({ points, ranges }) => points.map((pair) => placeOf(pair, ranges)),
  label: ({ points }, i) => say("sketch.pair", { name: i + 1, input: number(points[i][0]), output: number(points[i][1]) }),
  stroke({ ranges }, line) {
    const points = pairsOfStroke(line, ranges);
    return points && { points, typed: null };
  },
  click({ points, ranges }, place, i) {
    const pairs = i === undefined ? withPair(points, place, ranges) : null;
    return pairs && { points: pairs, typed: null };
  },
  moved: ({ points, ranges }, i, place) => ({ points: withPairMoved(points, i, place, ranges), typed: null }),
  removed: ({ points }, i) => ({ points: points.toSpliced(i, 1), typed: null }),
  candidate: (entry, state) => new Generator(entry, state),
};

const RULED = {
  ...CURVE, name: "line", fewest: 2, hint: "sketch.hint_of_line", more: "sketch.more_ends", title: "sketch.title_of_line", times: "sketch.times_line", next: () => CURVE, canSlide: false,
  empty: () => ({ ...NOTHING, straight: true, obstacle: null }),
  label: (_, i) => say("sketch.end", { name: i + 1 }),
  stroke(_, line) {
    const points = [line[0], line.at(-1)].map(rounded);
    return isLine(points) ? { points } : null;
  },
  // The other end, or after both the first of another line.
  click({ points }, place, i) {
    if (i !== undefined) return null;
    const ends = [...(points.length < 2 ? points : []), rounded(place)];
    return ends.length < 2 || isLine(ends) ? { points: ends } : null;
  },
  moved({ points }, i, place) {
    const ends = points.with(i, rounded(place));
    return { points: ends.length < 2 || isLine(ends) ? ends : points };
  },
  candidate: (entry, { points }) => new Candidate(placedOn(entry, points)),
};

export const MODES = { curve: CURVE, poses: POSES, function: FUNCTION, line: RULED };

// That of a state: `ranges` are of a function, `angles` of poses.
export const modeOf = ({ angles, ranges, straight }) => (ranges ? FUNCTION : angles ? POSES : straight ? RULED : CURVE);
