// The capitals of the Roman alphabet as a pen draws each without being lifted, over some lines twice, and some signs.

// Corners in a box 4 wide and 6 high.
const CORNERS = {
  A: "0,0 2,6 4,0 3.3,2 0.7,2", B: "0,0 0,6 3,6 4,5 3,3 0,3 3,3 4,1.5 3,0 0,0", C: "4,5 3,6 1,6 0,4.5 0,1.5 1,0 3,0 4,1", D: "0,0 0,6 2.5,6 4,4.5 4,1.5 2.5,0 0,0",
  E: "4,6 0,6 0,3 3,3 0,3 0,0 4,0", F: "4,6 0,6 0,3 3,3 0,3 0,0", G: "4,5 3,6 1,6 0,4.5 0,1.5 1,0 3,0 4,1 4,3 2.5,3", H: "0,6 0,0 0,3 4,3 4,6 4,0", I: "0,6 0,0",
  J: "3,6 3,1.5 2,0 1,0 0,1.5", K: "0,6 0,0 0,2 4,6 1.5,3.5 4,0", L: "0,6 0,0 4,0", M: "0,0 0,6 2,2 4,6 4,0", N: "0,0 0,6 4,0 4,6", O: "2,6 0.6,5 0,3 0.6,1 2,0 3.4,1 4,3 3.4,5 2,6",
  P: "0,0 0,6 3,6 4,5 4,4 3,3 0,3", Q: "2,6 0.6,5 0,3 0.6,1 2,0 3.4,1 4,3 3.4,5 2,6 0.6,5 0,3 0.6,1 2,0 3,1.5 4,0", R: "0,0 0,6 3,6 4,5 4,4 3,3 0,3 2,3 4,0",
  S: "4,5 3,6 1,6 0,5 0,4 1,3.2 3,2.8 4,2 4,1 3,0 1,0 0,1", T: "0,6 4,6 2,6 2,0", U: "0,6 0,1.5 1,0 3,0 4,1.5 4,6", V: "0,6 2,0 4,6", W: "0,6 1,0 2,4 3,0 4,6", X: "0,6 4,0 2,3 4,6 0,0",
  Y: "0,6 2,3 4,6 2,3 2,0", Z: "0,6 4,6 0,0 4,0",
  heart: "2,1 0,3.5 0,5 1,5.8 2,4.8 3,5.8 4,5 4,3.5 2,1", star: "2,6 3.2,0 0,3.8 4,3.8 0.8,0 2,6", drop: "2,6 3.5,3 3.2,1 2,0 0.8,1 0.5,3 2,6", eight: "2,3 3.4,4.4 2,6 0.6,4.4 2,3 3.6,1.4 2,0 0.4,1.4 2,3",
};

const POINTS = 60, HEIGHT = 0.45, LOW = 0.27;   // of a sheet

// `POINTS` places at equal steps along a polygon.
function along(corners) {
  const steps = corners.slice(1).map((q, i) => Math.hypot(q[0] - corners[i][0], q[1] - corners[i][1])), whole = steps.reduce((sum, step) => sum + step, 0);
  return Array.from({ length: POINTS }, (_, k) => {
    let left = (whole * k) / (POINTS - 1), i = 0;
    while (i < steps.length - 1 && left > steps[i]) left -= steps[i++];
    return corners[i].map((x, axis) => x + (left / steps[i]) * (corners[i + 1][axis] - x));
  });
}

export const LETTER_COUNT = Object.keys(CORNERS).length;

// The stroke of letter `i`, by shares of a sheet, with the tremor of a hand.
export function drawnLetter(i, random, tremor) {
  const corners = Object.values(CORNERS)[i % LETTER_COUNT].split(" ").map((place) => place.split(",").map(Number));
  return along(corners).map(([x, y]) => [0.5 + (HEIGHT * (x - 2)) / 6, LOW + HEIGHT * (1 - y / 6)].map((z) => z + HEIGHT * tremor * (random() - 0.5)));
}
