// What is asked of the search.

import { boxOf, diagonal } from "../view.js";

export const CLASSES_ASKED = ["any", "crank-rocker", "double-crank", "double-rocker", "triple-rocker"];

const PIVOTS_WITHIN = 1.5;   // of the drawing's size, from its middle
const SHORTEST = 0.02;
// Of poses, which may stand at one place, the least size (a twelfth of the sheet) and the least that a radian counts.
const LEAST_SIZE = 10, LEAST_WEIGHT = 5;

// What of a linkage stays out of a box.
const KEPT_CLEAR = ["coupler-point", "B", "C"];

// Starts of the searches that follow one another. Fewer are mostly enough for poses, since more is made of each; limits over the
// whole turn take ten times as long.
export function startsOf({ angles, ranges, obstacle, straight }) {
  if (ranges) return [16, 128, 512];
  if (straight) return [15, 120, 480];
  return obstacle ? [15, 60, 250] : [...(angles ? [15] : []), 60, 500, 2500];
}

const middleOf = (state) => startsOf(state).at(-2);
// Those of a search while a hand drags, and the designs that it begins with: curves take longer.
const besideKnown = ({ angles }) => (angles ? 4 : 1);
const mostKnown = ({ angles, ranges }) => (angles || ranges ? 6 : 4);
// Designs of a search, of which those are shown that differ; more is made of each of a line.
const foundFor = ({ straight }) => (straight ? 4 : 8);

// Of a function the range of its output, in degrees.
export const drawingSize = ({ points, angles, ranges }) => (ranges ? Math.abs(ranges[1]) : Math.max(angles ? LEAST_SIZE : 0, diagonal(boxOf(points))));

export const short = (x) => Number(x.toPrecision(4));

// A state for each kind of mechanism that is searched for: where `both` are, one for four-bars and one for slider-cranks.
export const kindsOf = (state) => (state.both ? [false, true].map((slides) => ({ ...state, slides, both: false })) : [state]);

// Where the fixed pivots may stand, low and high corner: as the hand says, or not far from the drawing.
function pivotsWithin({ points, region, reach }, size) {
  if (region) return region;
  const box = boxOf(points);
  const [x, y] = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const far = PIVOTS_WITHIN * Math.max(1, reach / 3) * size;
  return [[short(x - far), short(y - far)], [short(x + far), short(y + far)]];
}

// Of a line, in percent: from here on the speed along it may vary as it likes.
export const ANY_SPEED = 100;

// Longer links beside short ones are always straighter.
const RATIO_OF_LINE = 10;

// Those of every kind of drawing.
const commonLimits = ({ class: asked, least }) => ({ ...(asked === "any" ? {} : { class: asked }), ...(least > 0 ? { transmission_angle_deg: [least, 180 - least] } : {}) });

// Of chains: one box for all pivots.
const limitsOfChain = ({ least }, length, pivots) => ({ bounds: { length, pivots }, constraints: commonLimits({ class: "any", least }) });

const limitsOfLine = (state) => ({ constraints: { ...commonLimits(state), size_over_length_max: state.reach, link_ratio_max: RATIO_OF_LINE,
  ...(state.even < ANY_SPEED ? { speed_variation_max: state.even / 100 } : {}), ...(state.region ? { pivot_region: state.region } : {}) } });

// Links of a generator are as long as one likes: the limit is on the longest by the shortest.
function limitsOf(state) {
  const { ranges, reach, obstacle } = state;
  if (ranges) return { constraints: { ...commonLimits(state), link_ratio_max: reach } };
  if (state.straight) return limitsOfLine(state);
  const size = drawingSize(state), within = pivotsWithin(state, size), length = [short(SHORTEST * size), short(reach * size)];
  if (state.slides) return limitsOfChain(state, length, within);
  return { bounds: { length, pivot_a: within, pivot_d: within },
    constraints: { ...commonLimits(state), ...(obstacle ? { clearance: KEPT_CLEAR.map((point) => ({ point, outside: obstacle })) } : {}) } };
}

// What a radian counts beside lengths: the root mean squared distance from the middle, as in a file that does not say, but
// not next to nothing where a body does little else than turn.
function weightOf(points) {
  const middle = [0, 1].map((k) => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  const natural = Math.hypot(...points.map((p) => Math.hypot(p[0] - middle[0], p[1] - middle[1]))) / Math.sqrt(points.length);
  return natural < LEAST_WEIGHT ? { angle_weight: LEAST_WEIGHT } : {};
}

// Two poses leave circles undetermined: files have them met exactly.
const guiding = (points, angles) => ({ kind: "motion-generation",
  target: { ...(points.length > 2 ? { method: "least-squares", ...weightOf(points) } : {}), poses: points.map((p, i) => [...p, angles[i]]) }, mechanism: { dyads: ["RR"] } });

const ruling = (ends) => ({ kind: "straight-line", target: { ends } });

const bySlider = (points, closed) => ({ kind: "path-generation", target: { points, timing: "free", closed }, mechanism: { type: "slider-crank" } });

const tracing = (points) => ({ kind: "path-generation", target: { points, timing: "free", order: "cyclic" } });

const generating = (pairs) => ({ kind: "function-generation", target: { pairs_deg: pairs } });

function targetsOf({ points, angles, ranges, closed, slides, straight }) {
  if (ranges) return generating(points);
  if (straight) return ruling(points);
  if (slides) return bySlider(points, closed);
  return angles ? guiding(points, angles) : tracing(points);
}

// The problem of a sketch for one kind of mechanism: its points, poses or pairs, and the limits set beside it.
export const problemOf = (state, solve) => ({ ...targetsOf(state), ...limitsOf(state), solve });

// A design as the search takes it up: see read_known and read_generators in the kernel.
const asKnown = ({ mechanism: m, crank_deg: cranks, body_angle_deg: body = 0 }) =>
  [...m.fixed_pivots.flat(), m.crank, m.coupler, m.rocker, ...m.coupler_point, m.assembly === "open" ? 1 : 0, body, ...cranks];
const asKnownSlider = ({ mechanism: m, crank_deg: cranks }) =>
  [...m.pivot, m.crank, m.direction_deg, m.offset, m.coupler, ...m.coupler_point, m.assembly === "open" ? 1 : 0, ...cranks];
const asKnownGenerator = ({ mechanism: m, input_start_deg: input, output_start_deg: output }) =>
  [m.crank, m.coupler, m.rocker, Math.hypot(...m.fixed_pivots[1].map((x, k) => x - m.fixed_pivots[0][k])), m.assembly === "open" ? 1 : 0, input, output];

export const isSlider = ({ mechanism }) => mechanism.type === "slider-crank";

// Whether a design is a mechanism of a kind that is searched for, for targets of the same kind.
export const suits = (entry, { angles, ranges, slides, both, straight }) => (both || isSlider(entry) === Boolean(slides))
  && [[entry.input_start_deg, ranges], [entry.body_angle_deg, angles], [entry.direction_deg, straight]].every(([own, asked]) => (own !== undefined) === Boolean(asked));

// That state of `kindsOf` which a design is of; without a design the first.
export const kindOf = (state, entry) => kindsOf(state).find((kind) => entry && suits(entry, kind)) ?? kindsOf(state)[0];

// Of the designs shown those that suit and, but for functions, are for as many targets.
function knownOf(state, candidates) {
  const { points, ranges, slides, straight } = state, entries = candidates.map(({ entry }) => entry).filter((entry) => suits(entry, state));
  if (straight) return entries.map(asKnown);
  return ranges ? entries.map(asKnownGenerator) : entries.filter(({ crank_deg: cranks }) => cranks.length === points.length).map(slides ? asKnownSlider : asKnown);
}

// The question of the design that leads while a hand drags, from what it was; null where it has no place to begin at.
export function leadingQuestion(state, candidate) {
  const kind = kindOf(state, candidate.entry), known = knownOf(kind, [candidate]);
  return known.length ? { problem: { ...problemOf(kind, { designs: 1 }), known_alone: true }, known } : null;
}

// One question about all kinds of mechanisms: `ask(state)` gives {problem, known} of each, `others` are those after the first.
function together(state, ask) {
  const [question, ...others] = kindsOf(state).map(ask);
  return { ...question, others };
}

// The question while a hand still drags: from designs that were shown, if there are any.
export function liveQuestion(state, candidates) {
  const ask = (kind) => {
    const known = knownOf(kind, candidates).slice(0, mostKnown(kind));
    return { problem: problemOf(kind, { starts: known.length ? besideKnown(kind) : startsOf(kind)[0], designs: foundFor(kind) }), known };
  };
  return { ...together(state, ask), live: true, first: true, last: true };
}

// The question from designs that were found for other limits: of a search of middle length, or of as good as none besides.
export const questionFrom = (state, candidates, fresh) => together(state, (kind) => ({ problem: problemOf(kind, { starts: fresh ? middleOf(kind) : besideKnown(kind), designs: foundFor(kind) }), known: knownOf(kind, candidates) }));

// One question, of a search of middle length.
export const questionFor = (state) => together(state, (kind) => ({ problem: problemOf(kind, { starts: middleOf(kind), designs: foundFor(kind) }) }));

// The questions for a drawing at rest: searches of more and more starts, each for one kind of mechanism after the other.
export function questionsOf(state, candidates) {
  const searches = startsOf(state).flatMap((starts, round) => kindsOf(state).map((kind) => ({ problem: problemOf(kind, { starts, designs: foundFor(kind) }), known: round ? [] : knownOf(kind, candidates) })));
  return searches.map((search, i) => ({ ...search, first: i === 0, last: i === searches.length - 1 }));
}
