// Velocities and accelerations of points as arrows, for a drive that moves by one unit (a radian, a
// length) in a second and evenly.

import { set, svg } from "./dom.js";
import { locate, quantile } from "./sampling.js";
import { arrowPath, legendItem } from "./shapes.js";
import { say } from "./words.js";

// Angular velocities and accelerations of coupler and rocker of a four-bar, the crank turning at
// 1 rad/s: the loop equation B − A + C − B = D − A + C − D, derived once and twice, its components
// across the coupler and across the rocker.
export function fourBarRates({ a, b, c, d, p }) {
  const less = (u, v) => [u[0] - v[0], u[1] - v[1]];
  const cross = (u, v) => u[0] * v[1] - u[1] * v[0];
  const [crank, coupler, rocker] = [less(b, a), less(c, b), less(c, d)];
  const area = cross(coupler, rocker);
  const [w3, w4] = [cross(rocker, crank) / area, cross(coupler, crank) / area];
  const rest = [0, 1].map((k) => w4 * w4 * rocker[k] - crank[k] - w3 * w3 * coupler[k]);
  const turned = [rest[1], -rest[0]];
  const [a3, a4] = [cross(rocker, turned) / area, cross(coupler, turned) / area];
  const spun = (r, w, alpha) => ({ velocity: [-w * r[1], w * r[0]], acceleration: [-w * w * r[0] - alpha * r[1], -w * w * r[1] + alpha * r[0]] });
  const ofB = spun(crank, 1, 0);
  const sum = (u, v) => ({ velocity: u.velocity.map((x, k) => x + v.velocity[k]), acceleration: u.acceleration.map((x, k) => x + v.acceleration[k]) });
  return [{ at: b, ...ofB }, { at: c, ...spun(rocker, w4, a4) }, ...(p ? [{ at: p, ...sum(ofB, spun(less(p, b), w3, a3)) }] : [])];
}

// Of a path sampled at increasing `drives`, the first and second derivatives at sample k by the
// parabola through it and its neighbours; null beside a gap. `round`: the ends are one place.
function samplesRates(path, drives, k, round) {
  const last = drives.length - 1;
  const turn = drives[last] - drives[0];
  const [before, after] = round && (k === 0 || k === last) ? [[path[last - 1], drives[last - 1] - turn], [path[1], drives[1]]]
    : [[path[k - 1], drives[k - 1]], [path[k + 1], drives[k + 1]]];
  if (!before[0] || !path[k] || !after[0]) return null;
  const at = round && k === last ? drives[0] : drives[k];
  const [h, g] = [at - before[1], after[1] - at];
  const rates = [0, 1].map((i) => [(path[k][i] - before[0][i]) / h, (after[0][i] - path[k][i]) / g]);
  return { velocity: rates.map(([l, r]) => (g * l + h * r) / (h + g)), acceleration: rates.map(([l, r]) => (2 * (r - l)) / (h + g)) };
}

// The same anywhere, between samples; `unit`: what one unit of the drive is in its coordinate.
export function pathRates(path, drives, drive, round, unit) {
  const [k, t] = locate(drives, drive);
  const [p, q] = [samplesRates(path, drives, k, round), samplesRates(path, drives, k + 1, round)];
  if (!p || !q) return null;
  const mixed = (name, scale) => p[name].map((v, i) => scale * (v + t * (q[name][i] - v)));
  return { velocity: mixed("velocity", unit), acceleration: mixed("acceleration", unit * unit) };
}

// One kind of arrows, drawn so that nearly the longest takes a fair part of the picture.
export class Vectors {
  constructor(quantity, key) {
    Object.assign(this, { quantity, key, name: quantity, words: `extras.${quantity}`, root: svg("g", { class: `arrow ${quantity}` }) });
  }

  // `scene.ratesAt(drive)`: points with their velocities and accelerations; `scene.drives`: a sweep.
  available(scene) { return Boolean(scene.ratesAt) && Boolean(scene.view); }

  build(scene) {
    const step = Math.max(1, Math.floor(scene.drives.length / 90));
    const sizes = scene.drives.filter((_, i) => i % step === 0).flatMap((drive) => scene.ratesAt(drive).map((r) => Math.hypot(...r[this.quantity])));
    const size = quantile(sizes.filter(Number.isFinite), 0.95);
    // A picture that is nearer shows arrows of the same length.
    this.reach = 0.24 * Math.min(scene.view.width, scene.view.height);
    this.scale = size > 0 ? this.reach / size : 0;
    this.slides = scene.unit === 1;
    this.parts = [];
    this.root.replaceChildren();
  }

  move(scene, drive) {
    const rates = scene.ratesAt(drive);
    while (this.parts.length < rates.length) {
      const part = [svg("path", { class: "halo" }), svg("path", {})];
      this.root.append(...part);
      this.parts.push(part);
    }
    this.parts.forEach((part, i) => {
      const v = rates[i]?.[this.quantity];
      const long = v ? this.scale * Math.hypot(...v) : 0;
      const k = this.scale * Math.min(1, (1.7 * this.reach) / (long || 1));
      const d = v && Number.isFinite(long) ? arrowPath(scene.view.screen(rates[i].at), [k * v[0], -k * v[1]]) : "";
      for (const line of part) set(line, { d });
    });
  }

  legend() {
    const speed = say(this.slides ? "extras.unit_s" : "extras.rad_s");
    return [legendItem(this.quantity, "line", say("extras.at_unit_speed", { name: say(`arrows.${this.quantity}`), speed }))];
  }
}
