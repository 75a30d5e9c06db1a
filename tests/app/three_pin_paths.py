"""Links with three pins, closed here by Newton's method on complex numbers: paths of planted ones,
and the motion that a result has.
"""

import cmath
import math

TURN = 2 * math.pi


def crossed(a, b):
    return a.real * b.imag - a.imag * b.real


def dotted(a, b):
    return a.real * b.real + a.imag * b.imag


def determinant(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


class Plate:
    """A link with `pins` in its own axes, held from points by links of `lengths`, at `place`: its
    origin and the direction of its first axis."""

    def __init__(self, pins, lengths, place):
        self.pins, self.lengths, self.place = pins, lengths, place

    def ends(self):
        origin, axis = self.place
        return [origin + axis * pin for pin in self.pins]

    def close(self, holders):
        """Moves it to where `holders` hold it, from nearby; False where that does not succeed."""
        for _ in range(20):
            origin, axis = self.place
            along = [end - holder for end, holder in zip(self.ends(), holders)]
            rows = [[d.real, d.imag, crossed(axis * pin, d)] for d, pin in zip(along, self.pins)]
            right = [(length**2 - abs(d)**2) / 2 for d, length in zip(along, self.lengths)]
            whole = determinant(rows)
            if whole == 0:
                return False
            step = [determinant([[*row[:i], value, *row[i + 1:]] for row, value in zip(rows, right)])
                    / whole for i in range(3)]
            self.place = origin + complex(step[0], step[1]), axis * cmath.exp(1j * step[2])
            if sum(map(abs, step)) < 1e-13 * sum(self.lengths):
                return True
        return False

    def transmission_deg(self, holders):
        """The angle of each holding link with the line from its pin to the crossing of the others,
        acute."""
        ends = self.ends()
        along = [(end - holder) / abs(end - holder) for end, holder in zip(ends, holders)]
        angles = []
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            arm = (crossed(along[i], along[j]) * (ends[k] - ends[i])
                   - crossed(ends[j] - ends[i], along[j]) * along[i])
            angles.append(math.degrees(math.acos(min(1, abs(dotted(along[k], arm)) / abs(arm)))))
        return angles


def turn(plate, holders_at, samples, jump=0.3):
    """What `holders_at` and the plate's pins are at equal steps of a turn of the crank, with the
    least transmission angle; None where it does not come round."""
    began, rows, least = plate.place, [], 90.0
    for i in range(samples + 1):
        holders, before = holders_at(TURN * i / samples), plate.place
        size = sum(plate.lengths)
        if not plate.close(holders) or abs(plate.place[1] - before[1]) > jump:
            return None
        if abs(plate.place[0] - before[0]) > jump * size:
            return None
        least = min(least, *plate.transmission_deg(holders))
        rows.append((holders, plate.ends()))
    if abs(plate.place[0] - began[0]) > 1e-9 * size or abs(plate.place[1] - began[1]) > 1e-9:
        return None
    return rows[:-1], least


def from_axes(first, second, at):
    return first + (second - first) / abs(second - first) * at


def planted(kind, rng, least_deg, samples=720, body=None, output=False):
    """The path over a turn of a random mechanism of the type three-pin-1 or three-pin-2, with a
    crank of length 1 about the origin; with the angle `body` of a body in the link that carries the
    point, (point, angle) of that; or as `output` the angles of the third link, from the frame."""
    def log_uniform(low, high):
        return math.exp(rng.uniform(math.log(low), math.log(high)))

    def some(low, high):
        return cmath.rect(log_uniform(low, high), rng.uniform(0, TURN))

    while True:
        first = 1 + some(0.7, 5)
        pins = [first, first + some(0.7, 5), first + some(0.7, 5)]
        carried, second = some(0.3, 2), pins[1] + some(0.7, 5)
        third, point = pins[2] + some(0.7, 5), some(0.3, 3)

        def holders_at(angle):
            crank = cmath.exp(1j * angle)
            return [crank, crank * carried if kind == 2 else second, third]

        axis = (pins[1] - pins[0]) / abs(pins[1] - pins[0])
        plate = Plate([(pin - pins[0]) / axis for pin in pins],
                      [abs(pin - holder) for pin, holder in zip(pins, holders_at(0))],
                      (pins[0], axis))
        moved = turn(plate, holders_at, samples)
        if moved is None or moved[1] < least_deg:
            continue
        if output:
            return [cmath.phase(ends[2] - holders[2]) for holders, ends in moved[0]]
        carriers = [(holders[0], ends[0]) if kind == 1 else (ends[0], ends[1])
                    for holders, ends in moved[0]]
        path = [from_axes(*carrier, point) for carrier in carriers]
        if body is None:
            return path
        return [(at, cmath.phase(second - first) + body)
                for at, (first, second) in zip(path, carriers)]


def planted_pairs(kind, rng, least_deg, sweep=130, count=14):
    """Pairs of increments in degrees: what the third link of a random mechanism turns through while
    the crank turns by `sweep`, from anywhere."""
    samples = 720
    outputs = unrolled(planted(kind, rng, least_deg, samples, output=True))
    begin = rng.randrange(samples)
    inputs = [sweep * i / (count - 1) for i in range(count)]
    turned = [outputs[(begin + round(2 * x)) % samples] - outputs[begin] for x in inputs]
    return [(round(2 * x) / 2, math.degrees(math.remainder(y, TURN))) for x, y in zip(inputs, turned)]


def unrolled(angles):
    """Each within half a turn of the one before."""
    all_of = [angles[0]]
    for angle in angles[1:]:
        all_of.append(all_of[-1] + math.remainder(angle - all_of[-1], TURN))
    return all_of


def at_equal_arcs(path, count):
    """`count` of the points of a closed path, at nearly equal arcs."""
    arcs = [0]
    for here, after in zip(path, path[1:] + path[:1]):
        arcs.append(arcs[-1] + abs(after - here))
    chosen, i = [], 0
    for k in range(count):
        while arcs[i + 1] < arcs[-1] * k / count:
            i += 1
        chosen.append(path[i])
    return chosen


def size_of(points):
    """The root of the mean squared distance from the centre."""
    centre = sum(points) / len(points)
    return math.sqrt(sum(abs(p - centre)**2 for p in points) / len(points))


class Design:
    """A mechanism of a result whose last part is a link with three pins, moved here."""

    def __init__(self, mechanism):
        self.mechanism = mechanism
        group = mechanism["dyad"][-1]
        joints = group["joint"]
        self.pins = [complex(*joint["at"][1]) for joint in joints[3:]]
        lengths = [joint["at"][0][0] for joint in joints[3:]]
        place = complex(*group["at"][3]), cmath.rect(1, math.radians(group["direction_deg"][3]))
        self.plate = Plate(self.pins, lengths, place)
        self.began = place
        self.names = [joint["name"] for joint in joints]

    def holders_at(self, angle):
        at = {row["name"]: complex(*row["at"]) for row in self.mechanism["pivot"]}
        crank = self.mechanism["crank"]
        at[crank["pin"]] = at[crank["at"]] + cmath.rect(crank["length"], angle)
        for row in self.mechanism.get("point", []):
            if all(name in at for name in row["on"]):
                at[row["name"]] = from_axes(*(at[name] for name in row["on"]), complex(*row["at"]))
        return [at[name] for name in self.names[:3]]

    def places_after(self, angle, steps=360):
        """Every point by name, the crank having turned from angle 0."""
        self.plate.place = self.began
        for i in range(steps + 1):
            holders = self.holders_at(angle * i / steps)
            if not self.plate.close(holders):
                return None
        at = dict(zip(self.names, [*holders, *self.plate.ends()]))
        for row in self.mechanism.get("point", []):
            if all(name in at for name in row["on"]):
                at[row["name"]] = from_axes(*(at[name] for name in row["on"]), complex(*row["at"]))
        return at

    def joints(self, samples):
        """The joints of the link by their names over a turn, and the least transmission angle; None
        where the mechanism does not come round."""
        self.plate.place = self.began
        moved = turn(self.plate, self.holders_at, samples)
        if moved is None:
            return None
        return [dict(zip(self.names, [*holders, *ends])) for holders, ends in moved[0]], moved[1]

    def path(self, name, samples):
        """The path of a point over a turn, and that angle."""
        moved = self.joints(samples)
        if moved is None:
            return None
        row = next(row for row in self.mechanism["point"] if row["name"] == name)
        return [from_axes(*(at[on] for on in row["on"]), complex(*row["at"])) for at in moved[0]], moved[1]


def rms_distance(path, points):
    """Of points from a closed polyline."""
    return math.sqrt(sum(distance_to(path, p)**2 for p in points) / len(points))


def distance_to(path, point):
    """Of `point` from a closed polyline."""
    nearest = math.inf
    for here, after in zip(path, path[1:] + path[:1]):
        way = after - here
        share = min(1, max(0, dotted(point - here, way) / abs(way)**2)) if way else 0
        nearest = min(nearest, abs(point - here - share * way))
    return nearest
