#!/usr/bin/env python3
"""Plants random four-bars as function generators and has them found again.

planted_functions.py PROGRAM [--count N] [--seed S] [--seeds K] [--noise SHARE...]

Each problem is the output of a random four-bar over a part of its motion, as pairs of angles, with noise
of a share of the output's range, once for least squares and once minimax. The planted linkage keeps
every limit of its file, so that no problem is infeasible and no design should be worse than it. What
is printed for each level of noise, with limits and without, is that of planting.py.
"""

import argparse
import math
import os
import random
import sys

import planting

POINTS = 41


def rocker_angle(links, side, crank):
    """Law of cosines in the triangle B-C-D; None where it does not close."""
    l1, l2, l3, l4 = links
    bx, by = l1 * math.cos(crank), l1 * math.sin(crank)
    d = math.hypot(bx - l4, by)
    if d == 0:
        return None
    cosine = (l3 * l3 + d * d - l2 * l2) / (2 * l3 * d)
    if abs(cosine) > 1:
        return None
    # C is to the left of B -> D for side 1: seen from D, clockwise from the direction to B.
    return math.atan2(by, bx - l4) - side * math.acos(cosine)


def transmission(links, crank):
    l1, l2, l3, l4 = links
    d2 = l1 * l1 + l4 * l4 - 2 * l1 * l4 * math.cos(crank)
    return math.degrees(math.acos(max(-1, min(1, (l2 * l2 + l3 * l3 - d2) / (2 * l2 * l3)))))


def grashof_class(links):
    l1, l2, l3, l4 = links
    if 2 * (min(links) + max(links)) > sum(links):
        return "triple-rocker"
    return ["crank-rocker", "double-rocker", "rocker-crank", "double-crank"][links.index(min(links))]


class Planted:
    """A four-bar, its motion, and the outputs over it."""

    def __init__(self, rng):
        while True:
            self.links = [1.0] + [math.exp(rng.uniform(-1.2, 1.2)) for _ in range(3)]
            self.side = rng.choice([1, -1])
            self.start = rng.uniform(-math.pi, math.pi)
            self.sweep = math.radians(rng.uniform(40, 180))
            steps = [self.start + self.sweep * i / 400 for i in range(401)]
            angles = [rocker_angle(self.links, self.side, a) for a in steps]
            if None in angles:
                continue
            self.transmissions = [transmission(self.links, a) for a in steps]
            if min(self.transmissions) < 15 or max(self.transmissions) > 165:
                continue
            self.full = [angles[0]]
            for angle in angles[1:]:
                self.full.append(self.full[-1] + math.remainder(angle - self.full[-1], 2 * math.pi))
            span = max(self.full) - min(self.full)
            if span > math.radians(15) and abs(self.full[-1] - self.full[0]) > 0.3 * span:
                break
        self.outputs = [f - self.full[0] for f in self.full[:: 400 // (POINTS - 1)]]
        self.span = span


def motion_transmission(planted):
    """Over the full turn of a crank that turns fully, else over the motion."""
    if grashof_class(planted.links) in ("crank-rocker", "double-crank"):
        angles = [transmission(planted.links, math.pi * i) for i in range(2)]
        return min(angles), max(angles)
    low, high = min(planted.transmissions), max(planted.transmissions)
    for k in range(-2, 4):
        if planted.start < k * math.pi < planted.start + planted.sweep:
            angle = transmission(planted.links, k * math.pi)
            low, high = min(low, angle), max(high, angle)
    return low, high


def problem(rng, planted, noise, minimax, limits):
    outputs = [o + noise * planted.span * rng.gauss(0, 1) for o in planted.outputs]
    outputs = [o - outputs[0] for o in outputs]
    inputs = [planted.sweep * i / (POINTS - 1) for i in range(POINTS)]
    rows = ", ".join(
        f"[{math.degrees(x)!r}, {math.degrees(y)!r}]" for x, y in zip(inputs, outputs)
    )
    text = f'kind = "function-generation"\n[target]\npairs_deg = [{rows}]\n'
    text += f'objective = "{"minimax" if minimax else "least-squares"}"\n'
    text += "[bounds]\ncoupler = [0.05, 20]\nrocker = [0.05, 20]\nframe = [0.05, 20]\n"
    if limits:
        low, high = motion_transmission(planted)
        ratio = 1.1 * max(planted.links) / min(planted.links)
        text += f"[constraints]\ntransmission_angle_deg = [{max(0, low - 2):.3f}, {min(180, high + 2):.3f}]\n"
        text += f'class = "{grashof_class(planted.links)}"\nlink_ratio_max = {ratio:.3f}\n'
    return text, inputs, outputs


def errors_of(planted, inputs, outputs):
    """Sum of squares and square of the greatest error of the planted linkage, each with its best
    output start."""
    errors = []
    for x, y in zip(inputs, outputs):
        angle = rocker_angle(planted.links, planted.side, planted.start + x)
        errors.append(math.remainder(angle - planted.full[0] - y, 2 * math.pi))
    mean = sum(errors) / len(errors)
    return sum((e - mean) ** 2 for e in errors), (0.5 * (max(errors) - min(errors))) ** 2


def outcomes_of(arguments, text, minimax):
    """Of each seed; `found` is the square of the greatest error where that is requested."""
    outcomes = [planting.solve(os.path.abspath(arguments.program), text, seed, arguments.threads)
                for seed in range(1, arguments.seeds + 1)]
    for outcome in outcomes:
        if outcome.code not in (0, 1):
            raise RuntimeError(f"{outcome.message}\n{text}")
        if minimax and outcome.designs:
            outcome.found = outcome.designs[0]["error"]["max"] ** 2
    return outcomes


def tally_of(arguments, noise, limited, minimax):
    name = "minimax" if minimax else "least squares"
    limits = "limits" if limited else "no limits"
    tally = planting.Tally(f"function, {name}, noise {100 * noise:g} %, {limits}")
    for index in range(arguments.count):
        label = f"function-{arguments.seed}-{noise:g}-{'limited' if limited else 'free'}-{index}"
        rng = random.Random(label)
        planted = Planted(rng)
        text, inputs, outputs = problem(rng, planted, noise, minimax, limited)
        error = errors_of(planted, inputs, outputs)[minimax]
        scale = planted.span**2 * (1 if minimax else POINTS)
        outcomes = outcomes_of(arguments, text, minimax)
        before = len(tally.worse)
        tally.add(outcomes, error, scale, f"{label}-{name.replace(' ', '-')}")
        if arguments.keep and len(tally.worse) > before:
            arguments.keep.mkdir(parents=True, exist_ok=True)
            (arguments.keep / f"{label}-{minimax:d}.toml").write_text(text)
    return tally


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    planting.add_arguments(parser, 20)
    arguments = parser.parse_args()
    count = missed = infeasible = 0
    for minimax in (False, True):
        for noise in arguments.noise:
            for limited in (False, True):
                tally = tally_of(arguments, noise, limited, minimax)
                print(tally.line(), flush=True)
                for worse in tally.worse:
                    print("   ", worse)
                count += tally.count
                missed += tally.count - tally.found
                infeasible += tally.infeasible
    print(f"{count} problems, {missed} missed, {infeasible} infeasible")
    if count == 0 or infeasible > 0:
        return 1
    return int(arguments.allowed is not None and missed > arguments.allowed * count)


if __name__ == "__main__":
    sys.exit(main())
