// What can be changed of a four-bar, as numbers and by its joints in the picture.

export const minus = ([a, b], [c, d]) => [a - c, b - d];
export const lengthOf = ([x, y]) => Math.hypot(x, y);
export const crossOf = ([a, b], [c, d]) => a * d - b * c;

// `starts` of a function generator: the angles of crank and rocker at its start, from A→D in degrees.
export function fourBarFields({ mechanism, starts }) {
  const length = (key) => ({ key, get: (s) => s.mechanism[key], set: (s, value) => ({ ...s, mechanism: { ...s.mechanism, [key]: value } }), positive: true });
  const part = (key, list, i, name) => ({ key: name, get: (s) => s.mechanism[list][i], set: (s, value) => ({ ...s, mechanism: { ...s.mechanism, [list]: s.mechanism[list].with(i, value) } }) });
  const pivot = (i, k) => ({ key: `${"ad"[i]}_${"xy"[k]}`, get: (s) => s.mechanism.fixed_pivots[i][k],
    set: (s, value) => ({ ...s, mechanism: { ...s.mechanism, fixed_pivots: s.mechanism.fixed_pivots.with(i, s.mechanism.fixed_pivots[i].with(k, value)) } }) });
  const start = (key) => ({ key, get: (s) => s.starts[`${key}_deg`], set: (s, value) => ({ ...s, starts: { ...s.starts, [`${key}_deg`]: value } }) });
  return [...["crank", "coupler", "rocker"].map(length), pivot(0, 0), pivot(0, 1), pivot(1, 0), pivot(1, 1),
    ...(mechanism.coupler_point ? [part("coupler_point", "coupler_point", 0, "point_u"), part("coupler_point", "coupler_point", 1, "point_v")] : []),
    ...(starts ? ["input", "output"].map(start) : [])];
}

// The joints that can be dragged, each with the mechanism that it makes when it is taken to `to` from
// the pose at which the drag began.
export const FOUR_BAR_JOINTS = {
  A: { at: (m) => m.fixed_pivots[0], drag: (m, pose, to) => ({ ...m, fixed_pivots: [to, m.fixed_pivots[1]] }) },
  D: { at: (m) => m.fixed_pivots[1], drag: (m, pose, to) => ({ ...m, fixed_pivots: [m.fixed_pivots[0], to] }) },
  B: { at: (m, pose) => pose.b, moves: "crank",
    drag: (m, pose, to) => assembled({ ...m, crank: lengthOf(minus(to, m.fixed_pivots[0])), coupler: lengthOf(minus(pose.c, to)) }, to, pose.c) },
  C: { at: (m, pose) => pose.c,
    drag: (m, pose, to) => assembled({ ...m, coupler: lengthOf(minus(to, pose.b)), rocker: lengthOf(minus(to, m.fixed_pivots[1])) }, pose.b, to) },
  P: { at: (m, pose) => pose.p, drag: (m, pose, to) => ({ ...m, coupler_point: inFrame(pose.b, pose.c, to) }) },
};

// On which side of B→D the joint C lies.
function assembled(mechanism, b, c) {
  const side = crossOf(minus(mechanism.fixed_pivots[1], b), minus(c, b));
  return { ...mechanism, assembly: side > 0 ? "open" : "crossed" };
}

// `p` in axes at b, the first towards c.
export function inFrame(b, c, p) {
  const [x, y] = minus(c, b);
  const length = Math.hypot(x, y);
  const [u, v] = minus(p, b);
  return [(u * x + v * y) / length, (v * x - u * y) / length];
}
