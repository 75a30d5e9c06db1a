// From what a hand drew to the target points of a search.

const CLOSES_WITHIN = 0.12;  // of its length: so near to its start a stroke ends in it
const FINE = 120;
const SPACING = 4;           // units of the sheet between target points
const COUNT = [6, 24];

const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
const ring = (points, closed) => (closed ? [...points, points[0]] : points);

const lengthOfLine = (points, closed = false) => ring(points, closed).reduce((sum, p, i, all) => sum + (i ? distance(p, all[i - 1]) : 0), 0);

// `count` points at equal steps along the line through `points`; of a closed one the end is the start, and left out.
function equallySpaced(points, closed, count) {
  const line = ring(points, closed);
  const step = lengthOfLine(line) / (closed ? count : count - 1);
  const spaced = [line[0]];
  let [passed, next] = [0, step];
  for (let i = 1; i < line.length; ++i) {
    const [p, q] = [line[i - 1], line[i]];
    const length = distance(p, q);
    for (; length > 0 && passed + length >= next && spaced.length < count; next += step) {
      const share = (next - passed) / length;
      spaced.push(p.map((x, k) => x + share * (q[k] - x)));
    }
    passed += length;
  }
  if (!closed && spaced.length < count) spaced.push(line.at(-1));
  return spaced;
}

// Each point a quarter of the way to its neighbours on either side; open ends stay.
export function smoothed(points, closed) {
  const count = points.length;
  return points.map((p, i) => (!closed && (i === 0 || i === count - 1) ? p
    : p.map((x, k) => x / 2 + (points[(i + count - 1) % count][k] + points[(i + 1) % count][k]) / 4)));
}

// Units of the sheet: no target lies farther out, however far the view is. An address holds no places beyond, either.
export const FARTHEST = 1e6;
const SHARE = 100;
export const rounded = (point) => point.map((x) => Math.round(SHARE * Math.max(-FARTHEST, Math.min(FARTHEST, x))) / SHARE + 0);

// The target points of a freehand stroke, and whether it is closed.
export function strokeTargets(stroke) {
  const length = lengthOfLine(stroke);
  const closed = distance(stroke[0], stroke.at(-1)) < CLOSES_WITHIN * length;
  let line = equallySpaced(stroke, closed, FINE);
  for (let i = 0; i < 3; ++i) line = smoothed(line, closed);
  const count = Math.max(COUNT[0], Math.min(COUNT[1], Math.round(length / SPACING)));
  return { points: equallySpaced(line, closed, count).map(rounded), closed };
}
