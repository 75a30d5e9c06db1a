"""Paths of planted four-bars with free or mixed timing, their points disturbed: what the program finds.

Run as: planted_paths.py PROGRAM [--count N] [--seed S] [--seeds K] [--noise SHARE...]
                         [--orders cyclic any] [--timings free mixed] [--allowed SHARE]

The planted linkage passes the points in order within every limit; the squares of the noise are its
error at those crank angles, so that a design worse than that, or none, is missed. Where a problem
is solved in both orders, any order may not be worse than cyclic.
"""

import argparse
import math
import sys

import planting


def mixed_timing(angles):
    """Lines that give every fourth crank angle, as increments from the first."""
    sense = 1 if angles[-1] > angles[0] else -1
    degrees = [repr(sense * math.degrees(angle - angles[0])) if k % 4 == 0 else '"free"'
               for k, angle in enumerate(angles)]
    return (f'timing = "mixed"\ncrank_deg = [{", ".join(degrees)}]\n'
            f'crank_sense = "{"ccw" if sense > 0 else "cw"}"\n')


def planter(timing, order):
    """How a path of that timing is planted; the same linkage for every order."""
    def plant(rng, noise, limited, wanted):
        linkage = planting.random_four_bar(rng, wanted)
        angles = planting.ordered_angles(rng, linkage, rng.randint(8, 40))
        points = [linkage.at(angle)[0] for angle in angles]
        size = planting.size_of(points)
        if size < 0.05:
            return plant(rng, noise, limited, wanted)
        misses = [complex(rng.gauss(0, 1), rng.gauss(0, 1)) * noise * size / math.sqrt(2)
                  for _ in points]
        rows = [[(at + miss).real, (at + miss).imag] for at, miss in zip(points, misses)]
        text = f'kind = "path-generation"\n[target]\npoints = {rows}\norder = "{order}"\n'
        if timing == "mixed":
            text += mixed_timing(angles)
        if limited:
            text += planting.limits(rng, linkage, angles)
        return text, sum(abs(miss) ** 2 for miss in misses), len(points) * size**2
    return plant


def worse_in_any_order(cyclic, free):
    """How many problems have a greater error in any order than in cyclic order, and of how many."""
    behind = compared = 0
    for one, other in zip(cyclic, free):
        for in_order, in_any in zip(one.errors, other.errors):
            compared += 1
            behind += in_any > in_order * (1 + 1e-6) + one.floor_of_exact
    return behind, compared


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 20)
    parser.add_argument("--orders", nargs="*", default=["cyclic"])
    parser.add_argument("--timings", nargs="*", default=["free", "mixed"])
    arguments = parser.parse_args()
    status = 0
    for timing in arguments.timings:
        tallies = {}
        for order in arguments.orders:
            failed, tallies[order] = planting.run_all(
                arguments, f"path, {timing} timing, {order} order", planter(timing, order),
                f"path-{timing}")
            status |= failed
        if {"cyclic", "any"} <= tallies.keys():
            behind, compared = worse_in_any_order(tallies["cyclic"], tallies["any"])
            print(f"{behind} of {compared} are worse in any order than in cyclic order")
            status |= behind > 0 or compared == 0
    sys.exit(int(status))


if __name__ == "__main__":
    main()
