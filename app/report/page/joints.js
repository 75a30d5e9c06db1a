// The joints of a sampled four-bar or slider-crank, from which its other linkages follow.

import { less2 } from "./ghosts.js";
import { Mechanism } from "./mechanism.js";

// A function of the drive: joints a, b, c, and d or the direction in which c slides, and the coupler
// point p. Nothing where the mechanism is another one.
export function jointsOf(mechanism, { type } = {}) {
  const fixed = mechanism.pins.filter((pin) => pin.fixed);
  const [b, c] = [1, 2].map((body) => mechanism.pins.find((pin) => !pin.fixed && pin.body === body));
  const rail = mechanism.bodies[0].rails[0];
  const known = type === "four-bar" ? fixed.length === 2 && mechanism.pins.length === 4 : type === "slider-crank" && fixed.length === 1 && rail;
  if (!known || !b || !c) return undefined;
  const way = type === "slider-crank" ? less2(rail[1], rail[0]) : null;
  const point = mechanism.points.find(({ name, body, isPin }) => name === "P" && body === 2 && !isPin);
  return (drive) => {
    const places = mechanism.places(drive);
    const at = (spot) => Mechanism.point(places[spot.body], spot.at);
    const pose = { a: at(fixed[0]), b: at(b), c: at(c), d: fixed[1] ? at(fixed[1]) : null, way, p: point ? at(point) : null };
    return pose.b && pose.c ? pose : null;
  };
}
