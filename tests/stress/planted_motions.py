"""Bodies guided by planted four-bars, their poses disturbed: what the program finds.

Run as: planted_motions.py PROGRAM [--count N] [--seed S] [--seeds K] [--noise SHARE...] [--unordered]

The planted linkage meets every limit at its own crank angles, in order; the squares of the noise are
its error. A design worse than that, or none, is missed. Unordered poses are shuffled, and the file
allows any order.
"""

import argparse
import cmath
import json
import math
import sys

import planting


def shuffled(rng, noise, limited, wanted):
    """A problem of `plant` whose poses may be met in any order."""
    text, planted, scale = plant(rng, noise, limited, wanted)
    lines = text.split("\n")
    at = next(i for i, line in enumerate(lines) if line.startswith("poses = "))
    rows = json.loads(lines[at].removeprefix("poses = "))
    rng.shuffle(rows)
    lines[at] = f"poses = {rows}"
    if "[constraints]" in lines:
        lines.insert(lines.index("[constraints]") + 1, "no_order_defect = false")
    else:
        lines += ["[constraints]", "no_order_defect = false", ""]
    return "\n".join(lines), planted, scale


def plant(rng, noise, limited, wanted):
    linkage = planting.random_four_bar(rng, wanted)
    angles = planting.ordered_angles(rng, linkage, rng.choice([6, 8, 12, 20, 30]))
    turned = cmath.exp(1j * rng.uniform(0, 2 * math.pi))  # of the body's axes in the coupler
    poses = [linkage.at(angle)[:2] for angle in angles]
    size = planting.size_of([at for at, _ in poses])
    rows, planted, last = [], 0, 0
    for at, direction in poses:
        miss = complex(rng.gauss(0, 1), rng.gauss(0, 1)) * noise * size
        wrong = rng.gauss(0, 1) * noise
        angle = cmath.phase(direction * turned) + wrong
        last = angle = angle + 2 * math.pi * round((last - angle) / (2 * math.pi))
        rows.append([(at + miss).real, (at + miss).imag, math.degrees(angle)])
        planted += abs(miss) ** 2 + (size * wrong) ** 2
    text = (f'kind = "motion-generation"\n[target]\nposes = {rows}\nangle_weight = {size!r}\n'
            '[mechanism]\ndyads = ["RR"]\n')
    if limited:
        text += planting.limits(rng, linkage, angles)
    return text, planted, len(rows) * size**2


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    planting.add_arguments(parser, 20)
    parser.add_argument("--unordered", action="store_true", help="poses in any order")
    arguments = parser.parse_args()
    unordered = arguments.unordered
    kind = "unordered motion" if unordered else "motion"
    sys.exit(planting.run(arguments, kind, shuffled if unordered else plant))


if __name__ == "__main__":
    main()
