// Mechanisms of the simple types by the kernel: what the program draws and says of them.

// The dimensions of each type in the order in which the kernel takes them.
const MECHANISM_LAYOUTS = {
  "four-bar": ["fixed_pivots", "crank", "coupler", "rocker", "assembly", "coupler_point"], "slider-crank": ["pivot", "crank", "coupler", "offset", "direction_deg", "assembly"],
  "guide-bar": ["fixed_pivots", "crank", "offset", "assembly"], "oscillating-block": ["fixed_pivots", "crank", "offset", "assembly"],
  "fixed-block": ["pivot", "crank", "coupler", "offset", "direction_deg", "assembly"], "scotch-yoke": ["pivot", "crank", "offset", "direction_deg", "slot_deg"],
  "tangent-generator": ["pivot", "offset", "direction_deg"], "elliptic-trammel": ["centre", "length", "direction_deg", "second_line_deg"], "oldham-coupling": ["fixed_pivots", "slot_deg"],
};

function layoutNumbers(key, mechanism) {
  const value = mechanism[key];
  if (key === "coupler_point") return value ? [1, ...value] : [0, 0, 0];
  if (key === "assembly") return [value === "crossed" ? -1 : 1];
  return key.endsWith("_deg") ? [value * RADIANS] : [value].flat(2);
}

class MechanismKernel extends Kernel {
  // Takes a mechanism as results hold it, driven from `from` to `to` (degrees), with the names of its
  // bodies. False where a dimension is none.
  takeMechanism(mechanism, bodies, from, to) {
    const points = mechanism.point ?? [];
    const numbers = [...MECHANISM_LAYOUTS[mechanism.type].flatMap((key) => layoutNumbers(key, mechanism)), from * RADIANS, to * RADIANS,
      ...points.flatMap(({ on, at }) => [bodies.indexOf(on), ...at])];
    const lengths = ["crank", "coupler", "rocker", "length"].filter((key) => key in mechanism).map((key) => mechanism[key]);
    const [a, d] = mechanism.fixed_pivots ?? [[0, 0], [1, 0]];
    if (!numbers.every(Number.isFinite) || !lengths.every((length) => length > 0) || !(Math.hypot(d[0] - a[0], d[1] - a[1]) > 0)) return false;
    this.put(numbers);
    this.calls.mechanism(Object.keys(MECHANISM_LAYOUTS).indexOf(mechanism.type), points.length);
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
    const length = this.calls.mechanism_facts();
    const text = new TextDecoder().decode(new Uint8Array(this.calls.memory.buffer, this.calls.text(), length));
    const numbers = this.numbers;
    let next = 0;
    const value = (written) => (written === "#" ? numbers[next++] : written === "true" || written === "false" ? written === "true" : written);
    return text.split("\n").filter(Boolean).map((line) => { const [name, written] = line.split("\t"); return { name, value: value(written) }; });
  }
}
