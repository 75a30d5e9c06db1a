"""Straight lines planted in the coupler curves of four-bars: what the program's search finds.

Run as: planted_straight_lines.py PROGRAM [--count N] [--seed S] [--seeds K] [--allowed SHARE]

A random linkage has a segment that is straight to a few hundredths; the problem is the least
deviation over that length within limits that the linkage meets, some of them barely. A design that
is less straight, or none within the limits, is missed.
"""

import argparse
import cmath
import math
import sys

import planting

SAMPLES = 240


def deviation(points):
    """Half the width of the strip about a line along the chord, as the mean line turns it least."""
    chord = points[-1] - points[0]
    turned = [(point - points[0]) * cmath.exp(-1j * cmath.phase(chord)) for point in points]
    best = math.inf
    low, high = -0.1, 0.1
    for _ in range(40):  # the width is convex in the direction
        one, other = low + (high - low) / 3, high - (high - low) / 3
        widths = []
        for turn in (one, other):
            heights = [(point * cmath.exp(-1j * turn)).imag for point in turned]
            widths.append(max(heights) - min(heights))
        best = min(best, *widths)
        low, high = (low, other) if widths[0] < widths[1] else (one, high)
    return best / 2, abs(chord)


def segment(rng, linkage):
    """A part of a curve straight to a hundredth and longer than the shortest link."""
    low, high = rng.choice(planting.ranges(linkage))
    margin = 0 if linkage.turns_fully() else 0.05 * (high - low)
    angles = [low + margin + (high - low - 2 * margin) * k / SAMPLES for k in range(SAMPLES)]
    points = [linkage.at(angle)[0] for angle in angles]
    for _ in range(40):
        begin = rng.randrange(SAMPLES - 20)
        end = begin + rng.randrange(12, 20 + SAMPLES // 3)
        if end >= SAMPLES:
            continue
        width, length = deviation(points[begin:end + 1])
        if length > min(linkage.lengths()) and 1e-4 < width / length < 0.02:
            return angles[begin:end + 1], width, length
    return None


def plant(rng, noise, limited, wanted):
    while True:
        linkage = planting.random_four_bar(rng, wanted)
        found = segment(rng, linkage)
        if found:
            break
    angles, width, length = found
    sizes = linkage.lengths() + [abs(linkage.point), abs(linkage.point - linkage.coupler)]
    text = f'kind = "straight-line"\n[target]\nlength = {length!r}\n'
    limits = planting.limits(rng, linkage, angles) if limited else ""
    turn = abs(angles[-1] - angles[0])
    extra = (f"size_over_length_max = {max(sizes) / length * rng.uniform(1.001, 1.1)!r}\n"
             f"crank_range_deg = [{math.degrees(turn) * rng.uniform(0.9, 0.999)!r}, "
             f"{math.degrees(turn) * rng.uniform(1.001, 1.1)!r}]\n")
    if "[constraints]\n" in limits:
        limits = limits.replace("[constraints]\n", "[constraints]\n" + extra)
    else:
        limits = "[constraints]\n" + extra + limits
    return text + limits, width**2, length**2


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 20)
    arguments = parser.parse_args()
    arguments.noise = [0]
    sys.exit(planting.run(arguments, "straight line", plant))


if __name__ == "__main__":
    main()
