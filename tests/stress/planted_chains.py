"""Paths of planted six-bars and eight-bars, or motions of the link that traces them, their points
and poses disturbed: what the program finds.

Run as: planted_chains.py PROGRAM [--count N] [--seed S] [--seeds K] [--noise SHARE...]
[--topologies stephenson-3 watt-1 eight-bar-1] [--any] [--targets closed open timed] [--motions]
The planted chain closes over the whole turn, within the limit on the transmission angles of a
problem with limits, and passes the points in order; the squares of the noise are its error. A
design worse than that, or none, is missed. With --any the file specifies a six-bar or an eight-bar,
without saying which. Exact problems count as found below 0.01 % of the diagonal.
"""

import argparse
import cmath
import math
import pathlib
import sys

import planting

# Joints and points in the order in which they close: name, first, second.
TOPOLOGIES = {
    "stephenson-3": [("C", "B", "D"), ("E on", "B", "C"), ("F", "E", "G"), ("P on", "E", "F")],
    "watt-1": [("C", "B", "D"), ("E on", "B", "C"), ("H on", "D", "C"), ("F", "E", "H"),
               ("P on", "E", "F")],
    "eight-bar-1": [("C", "B", "D"), ("E on", "B", "C"), ("F", "E", "G"), ("K on", "E", "F"),
                    ("J", "K", "L"), ("P on", "K", "J")]}
SAMPLES = 360
TURN = 2 * math.pi


class Chain:
    """Random dimensions of a topology, the crank of length 1 about the origin."""

    def __init__(self, rng, rows):
        self.rows = rows
        self.pivots = {name: rng.uniform(1.5, 6) * cmath.exp(1j * rng.uniform(0, TURN))
                       for name in "DGL"}
        self.dimensions = [self.draw(rng, row) for row in rows]

    @staticmethod
    def draw(rng, row):
        if row[0].endswith("on"):
            return complex(rng.uniform(-3, 5), rng.uniform(-4, 4))
        return rng.uniform(1, 6), rng.uniform(1, 6), rng.choice([1, -1])

    def places(self, angle):
        """Points by name, and the least transmission angle; None where the chain is open."""
        at = {"A": 0j, "B": cmath.exp(1j * angle), **self.pivots}
        least = 90.0
        for (name, first, second), own in zip(self.rows, self.dimensions):
            p, q = at[first], at[second]
            if name.endswith("on"):
                at[name[0]] = p + (q - p) / abs(q - p) * own
                continue
            a, b, side = own
            way = abs(q - p)
            cosine = (a * a + b * b - way * way) / (2 * a * b)
            if way == 0 or abs(cosine) >= 1:
                return None
            least = min(least, math.degrees(math.acos(abs(cosine))))
            turned = math.acos((a * a + way * way - b * b) / (2 * a * way))
            at[name] = p + a * (q - p) / way * cmath.exp(1j * side * turned)
        return at, least


def random_chain(rng, rows):
    """A chain that closes over the turn, transmission angles of 30 degrees or more, its path not
    small beside it, with the path and the least angle."""
    while True:
        chain = Chain(rng, rows)
        places = []
        for k in range(SAMPLES):
            place = chain.places(TURN * k / SAMPLES)
            if place is None or place[1] < 30:
                break
            places.append(place)
        if len(places) < SAMPLES:
            continue
        path = [place[0]["P"] for place in places]
        if planting.size_of(path) > 0.5 and max(map(abs, path)) < 12:
            return chain, min(place[1] for place in places)


def angles_of(rng, target):
    if target == "closed":
        count = rng.randint(30, 80)
        return [TURN * k / count for k in range(count)]
    count, start, span = rng.randint(20, 40), rng.uniform(0, TURN), rng.uniform(1.5, 4.5)
    return [start + span * k / (count - 1) for k in range(count)]


def directions(topology, places):
    """Of the link that carries P."""
    _, first, second = TOPOLOGIES[topology][-1]
    return [cmath.phase(at[second] - at[first]) for at in places]


def planter(topology, asked, target, motion):
    def plant(rng, noise, limited, _wanted):
        chain, least = random_chain(rng, TOPOLOGIES[topology])
        angles = angles_of(rng, target)
        places = [chain.places(angle)[0] for angle in angles]
        points = [at["P"] for at in places]
        size = planting.size_of(points)
        if size < 0.1:
            return plant(rng, noise, limited, _wanted)
        placed = cmath.rect(rng.uniform(0.2, 30), rng.uniform(0, TURN))
        moved = complex(rng.uniform(-99, 99), rng.uniform(-99, 99))
        size *= abs(placed)
        misses = [complex(rng.gauss(0, 1), rng.gauss(0, 1)) * noise * size / math.sqrt(2)
                  for _ in points]
        rows = [[(moved + placed * at + miss).real, (moved + placed * at + miss).imag]
                for at, miss in zip(points, misses)]
        error = sum(abs(miss) ** 2 for miss in misses)
        if motion:
            body = rng.uniform(0, TURN)
            wrong = [rng.gauss(0, 1) * noise for _ in rows]
            for row, direction, miss in zip(rows, directions(topology, places), wrong):
                row.append(math.degrees(direction + body + miss))
            error += sum((size * miss) ** 2 for miss in wrong)
        kind, key = ("motion", "poses") if motion else ("path", "points")
        text = f'kind = "{kind}-generation"\n[target]\n{key} = {rows}\n'
        text += f"angle_weight = {size!r}\n" if motion else ""
        text += f"closed = {'true' if target == 'closed' else 'false'}\n"
        if target == "timed":
            text += f'timing = "prescribed"\ncrank_deg = {[math.degrees(a) for a in angles]}\n'
        text += f'[mechanism]\ntype = "{asked}"\n'
        if limited:
            low = least - rng.uniform(0.01, 3)
            text += f"[constraints]\ntransmission_angle_deg = [{low!r}, {180 - low!r}]\n"
        return text, error, len(points) * size**2
    return plant


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 10)
    parser.add_argument("--topologies", nargs="*", default=list(TOPOLOGIES), choices=list(TOPOLOGIES))
    parser.add_argument("--targets", nargs="*", default=["closed", "open", "timed"])
    parser.add_argument("--motions", action="store_true", help="of the link that carries the point")
    parser.add_argument("--any", action="store_true", help="let the program find the topology")
    arguments = parser.parse_args()
    # 0.01 % of the diagonal, which is about three times the size.
    planting.Tally.EXACT = 3e-4
    status = 0
    for topology in arguments.topologies:
        family = "eight-bar" if topology.startswith("eight") else "six-bar"
        asked = family if arguments.any else topology
        for target in arguments.targets:
            what = "motion" if arguments.motions else "path"
            status |= planting.run(arguments, f"{topology} asked as {asked}, {target} {what}",
                                   planter(topology, asked, target, arguments.motions))
    sys.exit(status)


if __name__ == "__main__":
    main()
