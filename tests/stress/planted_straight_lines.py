"""Straight lines planted in the coupler curves of four-bars: what the program's search finds.

Run as: planted_straight_lines.py PROGRAM [--count N] [--seed S] [--seeds K] [--allowed SHARE] [--placed]

A random linkage has a segment that is straight to a few hundredths; the problem is the least
deviation over that length within limits that the linkage meets, some of them barely. A design that
is less straight, or none within the limits, is missed. With --placed the line lies where the
linkage has it, from either end, and the pivots stand in a region that barely holds those planted.
"""

import argparse
import cmath
import math
import sys

import planting

SAMPLES = 240


def strip(points):
    """The ends of the middle of the strip about the chord, turned until it is narrowest, and half
    its width."""
    chord = points[-1] - points[0]
    turned = [(point - points[0]) * cmath.exp(-1j * cmath.phase(chord)) for point in points]
    best, line = math.inf, None
    low, high = -0.1, 0.1
    for _ in range(40):  # the width is convex in the direction
        one, other = low + (high - low) / 3, high - (high - low) / 3
        widths = []
        for turn in (one, other):
            heights = [(point * cmath.exp(-1j * turn)).imag for point in turned]
            widths.append(max(heights) - min(heights))
            if widths[-1] < best:
                best, line = widths[-1], (turn, (max(heights) + min(heights)) / 2)
        low, high = (low, other) if widths[0] < widths[1] else (one, high)
    along = cmath.exp(1j * (cmath.phase(chord) + line[0]))
    ends = [points[0] + along * complex(((p - points[0]) / along).real, line[1])
            for p in (points[0], points[-1])]
    return ends, best / 2


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
        ends, width = strip(points[begin:end + 1])
        length = abs(ends[1] - ends[0])
        if length > min(linkage.lengths()) and 1e-4 < width / length < 0.02:
            return angles[begin:end + 1], width, ends
    return None


def plant(rng, limited, wanted, placed):
    while True:
        linkage = planting.random_four_bar(rng, wanted)
        found = segment(rng, linkage)
        if found:
            break
    angles, width, ends = found
    length = abs(ends[1] - ends[0])
    sizes = linkage.lengths() + [abs(linkage.point), abs(linkage.point - linkage.coupler)]
    target = f"length = {length!r}"
    if placed:
        order = ends if rng.random() < 0.5 else ends[::-1]
        target = f"ends = {[[end.real, end.imag] for end in order]!r}"
    text = f'kind = "straight-line"\n[target]\n{target}\n'
    limits = planting.limits(rng, linkage, angles) if limited else ""
    turn = abs(angles[-1] - angles[0])
    extra = (f"size_over_length_max = {max(sizes) / length * rng.uniform(1.001, 1.1)!r}\n"
             f"crank_range_deg = [{math.degrees(turn) * rng.uniform(0.9, 0.999)!r}, "
             f"{math.degrees(turn) * rng.uniform(1.001, 1.1)!r}]\n")
    if placed and "pivot_region" not in limits:
        extra += f"pivot_region = {planting.region(rng, linkage)}\n"
    if "[constraints]\n" in limits:
        limits = limits.replace("[constraints]\n", "[constraints]\n" + extra)
    else:
        limits = "[constraints]\n" + extra + limits
    return text + limits, width**2, length**2


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 20)
    parser.add_argument("--placed", action="store_true", help="lines with a place")
    arguments = parser.parse_args()
    arguments.noise = [0]
    kind = "placed line" if arguments.placed else "straight line"
    sys.exit(planting.run(arguments, kind, lambda rng, _, limited, wanted: plant(rng, limited, wanted, arguments.placed)))


if __name__ == "__main__":
    main()
