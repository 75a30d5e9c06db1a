// A mechanism table with one dimension changed, by the names that results give dimensions.

const AXIS = { x: 0, y: 1, u: 0, v: 1 };
const PIVOTS = { A: 0, D: 1 };

const moved = (at, axis, by) => at.map((value, k) => (k === axis ? value + by : value));
const replaced = (list, i, entry) => list.map((old, k) => (k === i ? entry : old));

// Of a length between two pivots the second moves along the line of both.
function longer([a, d], by) {
  const length = Math.hypot(d[0] - a[0], d[1] - a[1]);
  return [a, d.map((value, k) => value + (by * (value - a[k])) / length)];
}

// The entry of `list` with the name, its place moved along an axis; null where there is none.
function withPlace(table, list, [name, axis], by) {
  const i = (table[list] ?? []).findIndex((entry) => entry.name === name);
  return i < 0 ? null : { ...table, [list]: replaced(table[list], i, { ...table[list][i], at: moved(table[list][i].at, axis, by) }) };
}

// Body k of a dyad has a length, or the offset of the block or of its guide; where both slide, each has a guide.
function dyadWith(dyad, k, by) {
  const { lengths = [], offset, slide, slides } = dyad;
  if (k < lengths.length) return { ...dyad, lengths: replaced(lengths, k, lengths[k] + by) };
  const moved = (guide) => ({ ...guide, offset: (guide.offset ?? 0) + by });
  if (slides) return k < slides.length ? { ...dyad, slides: replaced(slides, k, moved(slides[k])) } : null;
  if (k === 1 && slide) return { ...dyad, slide: moved(slide) };
  return k === 1 && offset !== undefined ? { ...dyad, offset: offset + by } : null;
}

function chainWith(table, name, by) {
  const { crank, dyad = [] } = table;
  if (crank && name === (crank.name ?? "crank")) return { ...table, crank: { ...crank, length: crank.length + by } };
  const d = dyad.findIndex(({ names = [] }) => names.includes(name));
  const changed = d < 0 ? null : dyadWith(dyad[d], dyad[d].names.indexOf(name), by);
  return changed && { ...table, dyad: replaced(dyad, d, changed) };
}

// `table` with the dimension `name` changed by `by`; null where the page does not know how.
export function withDimension(table, name, by) {
  const [key, letter] = name.split(".");
  if (letter === undefined) {
    if (table.type === "chain") return chainWith(table, name, by);
    if (name === "frame") return { ...table, fixed_pivots: longer(table.fixed_pivots, by) };
    return typeof table[name] === "number" ? { ...table, [name]: table[name] + by } : null;
  }
  const axis = AXIS[letter];
  if (table.fixed_pivots && key in PIVOTS && "xy".includes(letter)) {
    return { ...table, fixed_pivots: replaced(table.fixed_pivots, PIVOTS[key], moved(table.fixed_pivots[PIVOTS[key]], axis, by)) };
  }
  if (Array.isArray(table[key]) && typeof table[key][axis] === "number") return { ...table, [key]: moved(table[key], axis, by) };
  return withPlace(table, "xy".includes(letter) ? "pivot" : "point", [key, axis], by);
}

// All `changes`, [name, by]; null where one is not known.
export const withDimensions = (table, changes) => changes.reduce((now, [name, by]) => now && withDimension(now, name, by), table);
