// The closure of the four-bar, by the formulas of analysis/linkage/closure.hpp: products of sums of lengths
// in place of differences of squares, so that no digits are lost near limit positions.

export class Closure {
  // `linkage`: fixed_pivots, crank, coupler, rocker, assembly, and perhaps coupler_point.
  constructor(linkage) {
    const [a, d] = linkage.fixed_pivots;
    const frame = Math.hypot(d[0] - a[0], d[1] - a[1]);
    Object.assign(this, { linkage, a, d, frame, axis: [(d[0] - a[0]) / frame, (d[1] - a[1]) / frame] });
  }

  get frameAngle() { return Math.atan2(this.axis[1], this.axis[0]); }

  // The joints B and C and the coupler point P, the crank at `angle` from the frame A→D in radians;
  // `sense`: −1 for the other assembly. Null where the linkage does not close.
  at(angle, sense = 1) {
    const { crank, coupler, rocker, assembly, coupler_point: point } = this.linkage;
    const [c, s] = [Math.cos(angle / 2), Math.sin(angle / 2)];
    const side = c * c < s * s ? -1 : 1;
    const versine = 2 * Math.min(c * c, s * s);
    const alpha = this.frame - side * crank;
    const [sum, difference] = [coupler + rocker, coupler - rocker];
    const growth = 2 * side * crank * this.frame * versine;
    const p = (alpha - difference) * (alpha + difference) + growth;
    const q = (sum - alpha) * (sum + alpha) - growth;
    const square = alpha * alpha + growth;
    if (!(p * q >= 0) || !(p + q > 0) || !(square > 0)) return null;
    const sign = sense * (assembly === "crossed" ? -1 : 1);
    const ratio = [0.5 * (sum * difference + square) / square, 0.5 * sign * Math.sqrt(p * q) / square];
    const link = times(this.axis, times(ratio, [alpha + side * crank * versine, -2 * crank * s * c]));
    const b = plus(this.a, times(this.axis, [side * crank * (1 - versine), 2 * crank * s * c]));
    return { b, c: plus(b, link), p: point ? plus(b, times([point[0] / coupler, point[1] / coupler], link)) : null };
  }

  // Cosines of the crank's angle from the frame between which the linkage closes.
  get limits() {
    const { crank, coupler, rocker } = this.linkage;
    const cosine = (side) => ((crank - this.frame) ** 2 - side * side) / (2 * crank * this.frame);
    return [1 + cosine(coupler + rocker), 1 + cosine(coupler - rocker)];
  }
}

// Of plane vectors as complex numbers.
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const plus = ([a, b], [c, d]) => [a + c, b + d];
