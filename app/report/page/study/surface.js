// A column over two others: as a table on a grid of the study, as means of cells, or through
// triangles between the rows. Each gives {nx, ny, z, xs, ys, note}: z row by row from the lower left,
// NaN where nothing is known, and the places of the table's nodes.

import { d3Range } from "./filters.js";

// The value that represents the rows in a cell or at a node: the mean.
class Means {
  constructor(size) { this.sums = new Float64Array(size); this.counts = new Int32Array(size); }
  add(i, value) { if (!Number.isNaN(value)) { this.sums[i] += value; this.counts[i] += 1; } }
  get values() { return this.sums.map((sum, i) => (this.counts[i] ? sum / this.counts[i] : NaN)); }
}

// `held`: of each other varied column the value that it has, or none.
export function gridSurface(x, y, z, rows, held) {
  const [nx, ny] = [x.grid.length, y.grid.length];
  const [ix, iy] = [x, y].map(({ grid }) => new Map(grid.map((v, i) => [v, i])));
  const means = new Means(nx * ny);
  for (const row of rows) {
    if (![...held].every(([column, value]) => column.values[row] === value)) continue;
    const [i, j] = [ix.get(x.values[row]), iy.get(y.values[row])];
    if (i !== undefined && j !== undefined) means.add(j * nx + i, z.values[row]);
  }
  const missing = means.counts.reduce((n, count) => n + (count === 0), 0);
  return { nx, ny, xs: x.grid, ys: y.grid, z: means.values, missing };
}

// Equal steps of a column's scale.
function steps(column, count) {
  const scale = column.scale([0, count - 1]);
  return d3Range(count).map((i) => scale.invert(i));
}

export function binSurface(x, y, z, rows) {
  const [nx, ny] = [2.2, 4].map((rarer) => Math.max(5, Math.min(48, Math.round(Math.sqrt(rows.length) / rarer))));
  const [sx, sy] = [x.scale([0, nx]), y.scale([0, ny])];
  const cell = (scale, n, v) => Math.min(n - 1, Math.max(0, Math.floor(scale(v))));
  const means = new Means(nx * ny);
  for (const row of rows) if (!Number.isNaN(x.values[row]) && !Number.isNaN(y.values[row])) means.add(cell(sy, ny, y.values[row]) * nx + cell(sx, nx, x.values[row]), z.values[row]);
  const middles = (scale, n) => d3Range(n).map((i) => scale.invert(i + 0.5));
  return { nx, ny, xs: middles(sx, nx), ys: middles(sy, ny), z: means.values, cells: true };
}

const RASTER = [140, 100];
// Triangles with a side longer than this many usual ones bridge a hole.
const BRIDGE = 10;

export function triangleSurface(x, y, z, rows) {
  const [nx, ny] = RASTER;
  const [sx, sy] = [x.scale([0, nx - 1]), y.scale([0, ny - 1])];
  const known = rows.filter((row) => [x, y, z].every((column) => !Number.isNaN(column.values[row])));
  const points = known.map((row) => [sx(x.values[row]), sy(y.values[row])]);
  const table = new Float64Array(nx * ny).fill(NaN);
  const surface = { nx, ny, xs: steps(x, nx), ys: steps(y, ny), z: table };
  if (points.length < 3) return surface;
  const { triangles } = d3.Delaunay.from(points);
  const longest = (i) => Math.max(...[0, 1, 2].map((k) => Math.hypot(...[0, 1].map((axis) => points[triangles[i + k]][axis] - points[triangles[i + (k + 1) % 3]][axis]))));
  const sizes = d3.range(0, triangles.length, 3).map(longest);
  const usual = d3.median(sizes);
  sizes.forEach((size, k) => {
    if (size > BRIDGE * usual) return;
    const corners = [0, 1, 2].map((i) => triangles[3 * k + i]);
    fillTriangle(table, nx, ny, corners.map((i) => points[i]), corners.map((i) => z.values[known[i]]));
  });
  return surface;
}

// The nodes within a triangle, linearly between its corners' values.
function fillTriangle(table, nx, ny, [[ax, ay], [bx, by], [cx, cy]], [za, zb, zc]) {
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (area === 0) return;
  const [left, right] = [Math.min(ax, bx, cx), Math.max(ax, bx, cx)];
  const [low, high] = [Math.min(ay, by, cy), Math.max(ay, by, cy)];
  for (let j = Math.max(0, Math.ceil(low)); j <= Math.min(ny - 1, high); ++j) {
    for (let i = Math.max(0, Math.ceil(left)); i <= Math.min(nx - 1, right); ++i) {
      const s = ((i - ax) * (cy - ay) - (cx - ax) * (j - ay)) / area;
      const t = ((bx - ax) * (j - ay) - (i - ax) * (by - ay)) / area;
      if (s >= -1e-9 && t >= -1e-9 && s + t <= 1 + 1e-9) table[j * nx + i] = za + s * (zb - za) + t * (zc - za);
    }
  }
}
