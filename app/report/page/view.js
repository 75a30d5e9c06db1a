// From the plane of the mechanism to the picture: which part is framed, and how large.

export function boxOf(points) {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (const point of points) {
    if (!point) continue;
    box.x0 = Math.min(box.x0, point[0]); box.x1 = Math.max(box.x1, point[0]);
    box.y0 = Math.min(box.y0, point[1]); box.y1 = Math.max(box.y1, point[1]);
  }
  return box;
}

export const diagonal = (box) => Math.hypot(box.x1 - box.x0, box.y1 - box.y0);

// Pixels kept free at the foot of the picture for its scale.
export const SCALE_ROOM = 22;

export class View {
  constructor(box, width, height, margin = Math.min(56, Math.max(50, 0.1 * Math.min(width, height) + 8))) {
    const [w, h] = [box.x1 - box.x0, box.y1 - box.y0];
    const room = height - SCALE_ROOM;
    const fit = Math.min((width - 2 * margin) / w, (room - 2 * margin) / h);
    Object.assign(this, { width, height, margin, middle: [width / 2, room / 2], scale: Number.isFinite(fit) && fit > 0 ? fit : 1 });
    this.centre = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
    this.whole = { scale: this.scale, centre: this.centre };
  }

  // From nearer by `factor`, the middle moved by `shift` in the plane.
  look({ factor, shift }) {
    this.scale = this.whole.scale * factor;
    this.centre = this.whole.centre.map((v, k) => v + shift[k]);
  }

  screen([x, y]) {
    return [this.middle[0] + this.scale * (x - this.centre[0]), this.middle[1] - this.scale * (y - this.centre[1])];
  }

  plane([x, y]) {
    return [this.centre[0] + (x - this.middle[0]) / this.scale, this.centre[1] - (y - this.middle[1]) / this.scale];
  }

  // A round length that takes about a fifth of the width.
  scaleBar() {
    const wanted = this.width / 5 / this.scale;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = [5, 2, 1].map((k) => k * power).find((l) => l <= wanted) ?? power;
    return { length, pixels: length * this.scale };
  }
}
