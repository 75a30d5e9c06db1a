// The problem of a page with the chain of a design given whole, as `cognate solve` evaluates it.

const isRange = (value) => Array.isArray(value) && value.length === 2 && value.every((part) => typeof part === "number");

// A dyad as problems have it: its links are named by their points, and the guides of its sliders are of the frame.
function givenDyad({ type, joins, new: made, lengths, slide, assembly }) {
  if (type !== "RRP") return { joins, new: made, lengths, assembly };
  const { through, direction_deg, offset } = slide;
  return { type, joins: joins[0], new: made, length: lengths[0], slide: { through, direction_deg, offset }, assembly };
}

function givenChain({ pivot, crank: { at, pin, length }, dyad, point = [] }) {
  return { type: "chain", pivot, crank: { at, pin, length }, dyad: dyad.map(givenDyad), ...(point.length ? { point } : {}) };
}

// What the bounds of a chain are of: the dimensions of each of its points by name, of a place its two coordinates.
function boundedNumbers({ pivot, crank, dyad, point = [] }) {
  const slides = dyad.filter(({ slide }) => slide).map(({ new: made, slide }) => [`${made}-slide`, { numbers: [slide.offset] }]);
  return new Map([...[...pivot, ...point].map(({ name, at }) => [name, { at }]), [crank.pin, { numbers: [crank.length] }],
    ...dyad.map(({ new: made, lengths }) => [made, { numbers: lengths }]), ...slides]);
}

// The ranges of those numbers by a bound; nothing where it has an open end.
function rangesOfBound({ at, numbers }, bound) {
  const ranges = at ? [0, 1].map((axis) => [bound[0]?.[axis], bound[1]?.[axis]]) : numbers.length === 1 ? [bound] : bound;
  return Array.isArray(ranges) && ranges.every(isRange) ? ranges : null;
}

// The bounds that the dimensions keep: what is given beyond a bound, a file may not have.
function chainBoundsKept(bounds, chain) {
  const dimensions = boundedNumbers(chain);
  return Object.fromEntries(Object.entries(bounds).filter(([name, bound]) => {
    const own = dimensions.get(name);
    const ranges = own && rangesOfBound(own, bound);
    return ranges && (own.at ?? own.numbers).every((x, i) => x >= ranges[i][0] && x <= ranges[i][1]);
  }));
}

// `point`: the one that is traced. A chain that is given is not made robust.
export function givenProblem({ bounds, solve, ...problem }, chain, point) {
  const { robust, ...kept } = solve ?? {};
  return { ...problem, target: { ...problem.target, point }, mechanism: givenChain(chain), ...(bounds ? { bounds: chainBoundsKept(bounds, chain) } : {}), ...(solve ? { solve: kept } : {}) };
}
