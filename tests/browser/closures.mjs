// A four-bar {a, d, crank, coupler, rocker, u, v, side} by the intersection of two circles, as in a textbook.

const RADIANS = Math.PI / 180;
const FINE = 20000;

// The joints B and C; null where the circles do not meet.
function joints({ a, d, crank, coupler, rocker, side }, angle) {
  const b = [a[0] + crank * Math.cos(angle), a[1] + crank * Math.sin(angle)];
  const base = Math.hypot(d[0] - b[0], d[1] - b[1]), along = (coupler ** 2 - rocker ** 2 + base ** 2) / (2 * base);
  const height = Math.sqrt(coupler ** 2 - along ** 2);
  if (Number.isNaN(height)) return null;
  const e = [(d[0] - b[0]) / base, (d[1] - b[1]) / base];
  return { b, c: [b[0] + along * e[0] - side * height * e[1], b[1] + along * e[1] + side * height * e[0]] };
}

// Where the coupler point is and the direction of the coupler.
export function couplerPose(bar, angle) {
  const found = joints(bar, angle);
  if (!found) return null;
  const { b, c } = found, { coupler, u, v } = bar;
  const f = [(c[0] - b[0]) / coupler, (c[1] - b[1]) / coupler];
  return { at: [b[0] + u * f[0] - v * f[1], b[1] + u * f[1] + v * f[0]], direction: Math.atan2(f[1], f[0]) };
}

// The direction of the rocker from D to C, the crank at `degrees`, in degrees; NaN where it does not close.
export function rockerAngle(bar, degrees) {
  const found = joints(bar, degrees * RADIANS);
  return found ? Math.atan2(found.c[1] - bar.d[1], found.c[0] - bar.d[0]) / RADIANS : NaN;
}

// Of the joints B and C and of the coupler point the least distance from a box, negative within it, over a turn of the crank.
export function clearanceOf(bar, [[x0, y0], [x1, y1]]) {
  const beyond = ([x, y]) => Math.max(x0 - x, x - x1, y0 - y, y - y1);
  return Math.min(...Array.from({ length: FINE }, (_, i) => (2 * Math.PI * i) / FINE).map((angle) => {
    const found = joints(bar, angle);
    return found ? Math.min(...[found.b, found.c, couplerPose(bar, angle).at].map(beyond)) : NaN;
  }));
}

// The angle BCD, of at most 90 degrees.
function transmission(bar, angle) {
  const found = joints(bar, angle);
  if (!found) return NaN;
  const [p, q] = [found.b, bar.d].map((end) => end.map((x, k) => x - found.c[k]));
  return Math.atan2(Math.abs(p[0] * q[1] - p[1] * q[0]), Math.abs(p[0] * q[0] + p[1] * q[1])) / RADIANS;
}

const leastOver = (bar, from, to) => Math.min(...Array.from({ length: FINE + 1 }, (_, i) => transmission(bar, from + ((to - from) * i) / FINE)));

// The least of those angles over a turn of the crank, where it turns fully, else from the first to the last of the crank's
// angles used, `cranks` in degrees.
export function leastTransmission(bar, cranks) {
  const overTurn = leastOver(bar, 0, 2 * Math.PI);
  if (!Number.isNaN(overTurn)) return overTurn;
  const frame = Math.atan2(bar.d[1] - bar.a[1], bar.d[0] - bar.a[0]);
  // Angles from the frame run on where the crank can lie on it, else over the half turn from it.
  const first = joints(bar, frame) ? -Math.PI : 0;
  const used = cranks.map((degrees) => { const x = degrees * RADIANS - frame - first; return first + x - 2 * Math.PI * Math.floor(x / (2 * Math.PI)); });
  return leastOver(bar, frame + Math.min(...used), frame + Math.max(...used));
}

// A slider-crank {a, crank, coupler, offset, direction, u, v, ahead}, of its guide's direction in degrees and 1 where the slider is ahead of the
// crank's pin, by the circle about that pin that meets the guide: the point on the rod, and the angle of rod and guide's normal; null where
// they do not meet.
export function sliderPose({ a, crank, coupler, offset, direction, u, v, ahead }, angle) {
  const b = [a[0] + crank * Math.cos(angle), a[1] + crank * Math.sin(angle)], e = [Math.cos(direction * RADIANS), Math.sin(direction * RADIANS)];
  // The guide is n·x = h; the foot of B on it is as far from C as Pythagoras says.
  const n = [-e[1], e[0]], h = n[0] * a[0] + n[1] * a[1] + offset, rise = h - n[0] * b[0] - n[1] * b[1], way = Math.sqrt(coupler ** 2 - rise ** 2);
  if (Number.isNaN(way)) return null;
  const c = [b[0] + rise * n[0] + ahead * way * e[0], b[1] + rise * n[1] + ahead * way * e[1]], turn = Math.atan2(c[1] - b[1], c[0] - b[0]);
  return { at: [b[0] + u * Math.cos(turn) - v * Math.sin(turn), b[1] + u * Math.sin(turn) + v * Math.cos(turn)], c, transmission: Math.acos(Math.abs(rise) / coupler) / RADIANS };
}

export const sliderOf = ({ pivot, crank, coupler, offset, direction_deg: direction, assembly, coupler_point: [u, v] }) => ({ a: pivot, crank, coupler, offset, direction, u, v, ahead: assembly === "open" ? 1 : -1 });
