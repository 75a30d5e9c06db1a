"""Timed paths of planted four-bars, their points disturbed: what the program finds.

Run as: planted_timed.py PROGRAM [--count N] [--seed S] [--seeds K] [--noise SHARE...]

The planted linkage meets every limit at the crank angles given; the squares of the noise are its
error. A design worse than that, or none, is missed.
"""

import argparse
import cmath
import math
import sys

import planting


def reference(rng, linkage, angles):
    """Increments from the first point in either sense, or angles from the frame or the x axis."""
    kind = rng.choice(["first", "frame", "global"])
    origin = {"first": angles[0], "frame": cmath.phase(linkage.pivot_d - linkage.pivot_a),
              "global": 0}[kind]
    sense = rng.choice([1, -1]) if kind == "first" else 1
    crank = [math.degrees(sense * (angle - origin)) for angle in angles]
    return f'timing = "prescribed"\ncrank_deg = {crank}\ncrank_reference = "{kind}"\n'


def plant(rng, noise, limited, wanted):
    linkage = planting.random_four_bar(rng, wanted)
    angles = planting.ordered_angles(rng, linkage, rng.choice([8, 12, 18, 35]))
    points = [linkage.at(angle)[0] for angle in angles]
    size = planting.size_of(points)
    misses = [complex(rng.gauss(0, 1), rng.gauss(0, 1)) * noise * size for _ in points]
    rows = [[(at + miss).real, (at + miss).imag] for at, miss in zip(points, misses)]
    text = f'kind = "path-generation"\n[target]\npoints = {rows}\n' + reference(rng, linkage, angles)
    if limited:
        text += planting.limits(rng, linkage, angles)
    return text, sum(abs(miss) ** 2 for miss in misses), len(points) * size**2


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 20)
    arguments = parser.parse_args()
    sys.exit(planting.run(arguments, "timed", plant))


if __name__ == "__main__":
    main()
