// Mechanisms of the simple types by the kernel: what the program draws and says of them.

import { byId } from "../dom.js";
import { Kernel } from "../kernel.js";
import { RADIANS } from "../sampling.js";

// The keys of each type, [name, form], in the order in which the kernel takes them.
export const MECHANISM_KEYS = JSON.parse(byId("data").textContent).mechanism_keys;

function keyNumbers(value, form) {
  if (form === "point") return value ? [1, ...value] : [0, 0, 0];
  if (form === "assembly") return [value === "crossed" ? -1 : 1];
  return form === "direction" ? [value * RADIANS] : [value].flat(2);
}

export class MechanismKernel extends Kernel {
  // Takes a mechanism as results hold it, driven from `from` to `to` (degrees), with the names of its
  // bodies. False where a dimension is none.
  takeMechanism(mechanism, bodies, from, to) {
    const points = mechanism.point ?? [];
    const keys = MECHANISM_KEYS[mechanism.type];
    const letters = Array.from(mechanism.type, (letter) => letter.charCodeAt(0));
    const numbers = [...letters, ...keys.flatMap(([key, form]) => keyNumbers(mechanism[key], form)), from * RADIANS, to * RADIANS,
      ...points.flatMap(({ on, at }) => [bodies.indexOf(on), ...at])];
    const lengths = keys.filter(([, form]) => form === "length").map(([key]) => mechanism[key]);
    const [a, d] = mechanism.fixed_pivots ?? [[0, 0], [1, 0]];
    if (!numbers.every(Number.isFinite) || !lengths.every((length) => length > 0) || !(Math.hypot(d[0] - a[0], d[1] - a[1]) > 0)) return false;
    this.put(numbers);
    this.calls.mechanism(letters.length, points.length);
    return true;
  }

  // The motion of the mechanism taken as a report draws it, angles in degrees; null where it can be
  // assembled nowhere.
  mechanismMotion(samples) {
    if (this.calls.mechanism_motion(samples) === 0) return null;
    const all = this.numbers;
    let at = 0;
    const one = () => all[at++];
    const list = (count, next) => Array.from({ length: count }, next);
    const pair = () => [one(), one()];
    const [rows, bodies] = pair();
    const track = (unit) => {
      const values = list(rows, () => { const value = one() / unit; return Number.isNaN(value) ? null : value; });
      return values.every((value) => value === values[0]) && values[0] !== null ? values[0] : values;
    };
    const drive = list(rows, () => one() / RADIANS);
    const tracks = list(bodies, () => ({ x: track(1), y: track(1), deg: track(RADIANS) }));
    const shapes = list(bodies, () => ({ outline: list(one(), pair), rails: list(one(), () => [pair(), pair()]), block: one() !== 0 }));
    const place = () => ({ body: one(), at: pair() });
    const pins = list(one(), () => ({ ...place(), fixed: one() !== 0 }));
    const points = list(one(), place);
    return { drive, bodies: tracks.map((body, i) => ({ ...body, ...shapes[i] })), pins, points };
  }

  // The facts of the mechanism taken, by name.
  mechanismFacts() {
    const length = this.calls.mechanism_quantities();
    const text = new TextDecoder().decode(new Uint8Array(this.calls.memory.buffer, this.calls.text(), length));
    const numbers = this.numbers;
    let next = 0;
    const value = (written) => (written === "#" ? numbers[next++] : written === "true" || written === "false" ? written === "true" : written);
    return text.split("\n").filter(Boolean).map((line) => { const [name, written] = line.split("\t"); return { name, value: value(written) }; });
  }
}
