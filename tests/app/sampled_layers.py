"""The layers of links by dense samples, sharing no code with the program: own closures by circles, own
distances between corners and sides, and every assignment of layers tried.

Four-bars and chains of RRR dyads, whose crank turns fully or which a cylinder drives.
"""

import cmath
import itertools
import math


def circle_joint(first, second, first_length, second_length, left):
    """The joint of two links from `first` and `second`, left of the way between them or right."""
    way = second - first
    distance = abs(way)
    along = (first_length**2 - second_length**2 + distance**2) / (2 * distance)
    aside = math.sqrt(first_length**2 - along**2)
    return first + way / distance * complex(along, aside if left else -aside)


def place_on(origin, other, at):
    """The point `at` in the axes from `origin` towards `other`."""
    return origin + (other - origin) / abs(other - origin) * complex(*at)


class Samples:
    """Places of the points of a mechanism at `count` positions of its crank, and its links by points."""

    def __init__(self, mechanism, count, lengths=()):
        self.links, self.base = {}, []
        shares = [i / count for i in range(count)]
        if lengths:  # of the cylinder, from and to
            drive = [lengths[0] + share * (lengths[1] - lengths[0]) for share in [*shares, 1]]
        else:
            drive = [cmath.rect(1, 2 * math.pi * share) for share in shares]
        read = self.four_bar if mechanism["type"] == "four-bar" else self.chain
        self.poses = [read(mechanism, at) for at in drive]

    def four_bar(self, given, direction):
        a, d = (complex(*pivot) for pivot in given["fixed_pivots"])
        b = a + given["crank"] * direction
        c = circle_joint(b, d, given["coupler"], given["rocker"],
                         given.get("assembly", "open") == "open")
        pose = {"A": a, "B": b, "C": c, "D": d}
        self.links = {"crank": "AB", "coupler": "BC", "rocker": "CD"}
        if "coupler_point" in given:
            pose["P"] = place_on(b, c, given["coupler_point"])
            self.links["coupler"] = "BCP"
        self.base = ["A", "D"]
        return pose

    def chain(self, given, drive):
        pose = {pivot["name"]: complex(*pivot["at"]) for pivot in given["pivot"]}
        self.base = list(pose)
        if "cylinder" in given:
            cylinder = given["cylinder"]
            base, pivot, pin = (cylinder[key] for key in ("at", "about", "pin"))
            pose[pin] = circle_joint(pose[base], pose[pivot], drive, cylinder["length"],
                                     cylinder.get("assembly", "open") == "open")
            _, barrel, link = cylinder.get("names", ["rod", "cylinder", self.link_name(pivot, pin)])
            links = {barrel: [base, pin], link: [pivot, pin]}
        else:
            crank = given["crank"]
            pose[crank["pin"]] = pose[crank["at"]] + crank["length"] * drive
            links = {crank.get("name", "crank"): [crank["at"], crank["pin"]]}
        # A point on two joints of a link is on it; parts of a chain may stand in any order.
        rest = given.get("dyad", []) + given.get("point", [])
        while rest:
            ready = [part for part in rest if set(part.get("joins", part.get("on"))) <= set(pose)]
            for part in ready:
                rest.remove(part)
                if "on" in part:
                    first, second = part["on"]
                    pose[part["name"]] = place_on(pose[first], pose[second], part["at"])
                    for points in links.values():
                        if first in points and second in points:
                            points.append(part["name"])
                else:
                    (first, second), (one, two), new = part["joins"], part["lengths"], part["new"]
                    pose[new] = circle_joint(pose[first], pose[second], one, two,
                                             part.get("assembly", "open") == "open")
                    names = part.get("names") or [self.link_name(first, new), self.link_name(new, second)]
                    links[names[0]], links[names[1]] = [first, new], [new, second]
        self.links = links
        return pose

    @staticmethod
    def link_name(first, second):
        return first + second if len(first) == len(second) == 1 else f"{first}-{second}"


def hull(points):
    """Corners of the convex hull, counter-clockwise."""
    ordered = sorted(set(points), key=lambda p: (p.real, p.imag))
    if len(ordered) < 3:
        return ordered

    def half(way):
        corners = []
        for p in way:
            while len(corners) > 1 and ((corners[-1] - corners[-2]).conjugate() * (p - corners[-1])).imag <= 0:
                corners.pop()
            corners.append(p)
        return corners[:-1]

    return half(ordered) + half(reversed(ordered))


def to_segment(p, a, b):
    way = b - a
    share = ((p - a) * way.conjugate()).real / abs(way) ** 2 if way else 0
    return abs(p - a - min(1, max(0, share)) * way)


def sides(corners):
    return [(corners[i], corners[(i + 1) % len(corners)]) for i in range(len(corners))]


def crosses(a, b, c, d):
    def side(p, q, r):
        return ((q - p).conjugate() * (r - p)).imag

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def inside(p, corners):
    return len(corners) > 2 and all(((b - a).conjugate() * (p - a)).imag >= 0 for a, b in sides(corners))


def between(one, other):
    """The distance of two convex polygons, 0 where they overlap."""
    if inside(one[0], other) or inside(other[0], one):
        return 0
    if any(crosses(*s, *t) for s in sides(one) for t in sides(other)):
        return 0
    return min(min(to_segment(p, *s) for p in one for s in sides(other)),
               min(to_segment(p, *s) for p in other for s in sides(one)))


class SampledLayers:
    """What of the links and pins of a design collides at the samples."""

    def __init__(self, mechanism, sizes, count=720, lengths=()):
        samples = Samples(mechanism, count, lengths)
        self.links = list(samples.links)
        moved = {point for points in samples.links.values() for point in points}
        self.pins = {point: [name for name in self.links if point in samples.links[name]]
                     for point in sorted(moved)}
        self.pins = {point: joined for point, joined in self.pins.items()
                     if len(joined) > 1 or point in samples.base}
        self.on_base = [point for point in self.pins if point in samples.base]
        widths = {name: sizes.get("widths", {}).get(name, sizes["link_width"]) for name in self.links}
        radius = {name: width / 2 for name, width in widths.items()}
        radius |= {("pin", point): sizes["pin_diameter"] / 2 for point in self.pins}
        self.room = {}
        parts = [*self.links, *(("pin", point) for point in self.pins)]
        for pose in samples.poses:
            shapes = {name: hull([pose[point] for point in samples.links[name]]) for name in self.links}
            shapes |= {("pin", point): [pose[point]] for point in self.pins}
            for one, other in itertools.combinations(parts, 2):
                room = (between(shapes[one], shapes[other]) - radius[one] - radius[other]
                        - sizes.get("clearance", 0))
                self.room[one, other] = min(self.room.get((one, other), math.inf), room)

    def least_room(self, layer_of):
        """How near parts of one layer come, less what they must keep: negative where they collide.

        A pin ends within its lowest and its highest link, which cover it there: it is in the layers between.
        """
        spans = {}
        for point, joined in self.pins.items():
            held = [layer_of[name] for name in joined] + [0] * (point in self.on_base)
            spans[point] = (min(held), max(held))

        def met(one, other):
            pins = [part[1] for part in (one, other) if isinstance(part, tuple)]
            links = [part for part in (one, other) if not isinstance(part, tuple)]
            if len(links) == 2:
                return layer_of[links[0]] == layer_of[links[1]]
            if len(pins) == 2:
                (a, b), (c, d) = spans[pins[0]], spans[pins[1]]
                return max(a, c) + 1 < min(b, d)
            low, high = spans[pins[0]]
            return links[0] not in self.pins[pins[0]] and low < layer_of[links[0]] < high

        return min((room for pair, room in self.room.items() if met(*pair)), default=math.inf)

    def fewest(self, tolerance):
        """The least number of layers, by trying all assignments; None where there is none."""
        for count in range(1, len(self.links) + 1):
            for layers in itertools.product(range(1, count + 1), repeat=len(self.links)):
                if self.least_room(dict(zip(self.links, layers))) >= -tolerance:
                    return count
        return None
