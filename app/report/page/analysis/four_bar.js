// The joints of an analysed four-bar, from which its other assembly and its cognates follow.

// A function of the drive, or nothing where the mechanism is no four-bar.
function fourBarOf(mechanism, { type } = {}) {
  const fixed = mechanism.pins.filter((pin) => pin.fixed);
  const [b, c] = [1, 2].map((body) => mechanism.pins.find((pin) => !pin.fixed && pin.body === body));
  if (type !== "four-bar" || mechanism.pins.length !== 4 || fixed.length !== 2 || !b || !c) return undefined;
  const point = mechanism.points.find(({ name, body, isPin }) => name === "P" && body === 2 && !isPin);
  return (drive) => {
    const places = mechanism.places(drive);
    const at = (spot) => Mechanism.point(places[spot.body], spot.at);
    const pose = { a: at(fixed[0]), b: at(b), c: at(c), d: at(fixed[1]), p: point ? at(point) : null };
    return pose.b && pose.c ? pose : null;
  };
}
