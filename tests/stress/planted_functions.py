#!/usr/bin/env python3
"""Plants random four-bars as function generators and has them found again.

planted_functions.py PROGRAM [--count N] [--seed S] [--seeds K]

Each problem is the output of a random four-bar over a part of its motion, as pairs of angles, with noise
of a share of the output's range. The planted linkage keeps every limit of its file, so that no problem
is infeasible and no design should be worse than it. For each level of noise is printed: how many
were found (no worse than the planted linkage), how many were called infeasible, the worst ratio to
the planted error, median and worst time, and in how many all seeds gave the same error. The status
is 1 where a problem was called infeasible or not found.
"""

import argparse
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile

NOISE = [0.0, 0.001, 0.01, 0.05]
POINTS = 41
FLOOR = 1e-6  # radians: an error below counts as none


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
        text += f"[constraints]\ntransmission_angle_deg = [{low - 2:.3f}, {high + 2:.3f}]\n"
        text += f'class = "{grashof_class(planted.links)}"\nlink_ratio_max = {ratio:.3f}\n'
    return text, inputs, outputs


def errors_of(planted, inputs, outputs):
    """Least squares and greatest error of the planted linkage with its best output start."""
    errors = []
    for x, y in zip(inputs, outputs):
        angle = rocker_angle(planted.links, planted.side, planted.start + x)
        errors.append(math.remainder(angle - planted.full[0] - y, 2 * math.pi))
    mean = sum(errors) / len(errors)
    middle = 0.5 * (max(errors) + min(errors))
    return (
        math.sqrt(sum((e - mean) ** 2 for e in errors) / len(errors)),
        max(abs(e - middle) for e in errors),
    )


def solve(program, text, seed, folder):
    path = os.path.join(folder, "planted.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    command = [program, "solve", path, "--json", "--quiet", "--out", folder, "--seed", str(seed)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{done.stderr}\n{text}")
    result = json.loads(done.stdout)
    error = math.inf
    if result["status"] == "solved":
        design = result["designs"][0]
        error = design["error"]["max" if "minimax" in text else "rms"]
    return result["status"], error, result["work"]["seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=300, help="problems of each objective")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seeds", type=int, default=1, help="seeds of the program for each problem")
    parser.add_argument("--show", action="store_true", help="print each problem that was not found")
    asked = parser.parse_args()
    rng = random.Random(asked.seed)
    rows = {(m, n): [] for m in (False, True) for n in NOISE}
    with tempfile.TemporaryDirectory() as folder:
        for index in range(asked.count):
            noise, limits = NOISE[index % 4], index // 4 % 2 == 1
            planted = Planted(rng)
            for minimax in (False, True):
                text, inputs, outputs = problem(rng, planted, noise, minimax, limits)
                bound = max(errors_of(planted, inputs, outputs)[minimax], FLOOR)
                runs = [solve(asked.program, text, s + 1, folder) for s in range(asked.seeds)]
                rows[minimax, noise].append((bound, runs))
                worst = max(run[1] for run in runs)
                if asked.show and worst > 1.001 * bound:
                    print(f"# {runs[0][0]} {worst / bound:.4g} limits {limits}\n{text}")
    failed = 0
    print("objective      noise  problems  found  infeasible  worst ratio  median s  worst s  agree")
    for (minimax, noise), found in rows.items():
        runs = [(bound, run) for bound, all_runs in found for run in all_runs]
        if not runs:
            continue
        good = sum(run[1] <= 1.001 * bound for bound, run in runs)
        infeasible = sum(run[0] != "solved" for _, run in runs)
        ratio = max(run[1] / bound for bound, run in runs)
        times = [run[2] for _, run in runs]
        agree = 0
        for bound, all_runs in found:
            errors = [max(run[1], 0.01 * bound) for run in all_runs]
            agree += max(errors) <= 1.001 * min(errors)
        failed += len(runs) - good
        print(
            f"{'minimax' if minimax else 'least-squares':14} {noise:5}  {len(runs):8}  {good:5}"
            f"  {infeasible:10}  {ratio:11.4g}  {statistics.median(times):8.3f}"
            f"  {max(times):7.3f}  {agree}/{len(found)}"
        )
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
