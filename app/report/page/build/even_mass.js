// Mass that is spread evenly over a link.

// Of a polygon, counter-clockwise, its centroid and the moment of inertia about it over the mass; of a rod of two points likewise.
export function evenMass(corners) {
  if (corners.length < 3) {
    const [p, q = p] = corners;
    return { centre: p.map((x, k) => (x + q[k]) / 2), square: ((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) / 12 };
  }
  const [o] = corners;
  const parts = corners.slice(1, -1).map((p, i) => [p, corners[i + 2]].map((r) => [r[0] - o[0], r[1] - o[1]])).map(([u, v]) => ({ u, v, area: u[0] * v[1] - u[1] * v[0] }));
  const area = parts.reduce((sum, part) => sum + part.area, 0);
  const mean = (value) => parts.reduce((sum, part) => sum + part.area * value(part), 0) / area;
  const centre = [0, 1].map((k) => mean(({ u, v }) => (u[k] + v[k]) / 3));
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
  const about = mean(({ u, v }) => (dot(u, u) + dot(u, v) + dot(v, v)) / 6);
  return { centre: centre.map((x, k) => x + o[k]), square: about - dot(centre, centre) };
}
