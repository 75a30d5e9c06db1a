"""Paths with free or mixed timing, planted with noise, are solved as well as the planted linkage.

Run as: planted_paths.py PROGRAM [--count N] [--seed N] [--noise SHARE,…] [--points MIN,MAX]
                         [--orders cyclic,any] [--timings free,mixed] [--slack SHARE] [--keep DIR]

Each problem is a random four-bar of every class of mobility, driven over an arc of its crank or a
whole turn. Its coupler points at crank angles in order, each moved by noise that is normal with a
deviation of so much of the path's size, are the target. The planted linkage meets every
requirement, and the squares of the noise are its error at those crank angles: no answer may be
worse. Per noise level, order and timing the table has the number of problems solved and called
infeasible, the worst ratio of the error to the planted one, how many exceed it by the slack, and
the times. Fails where a problem is infeasible or unsolved, and with --slack where one exceeds it.

The four-bar here shares nothing with the program: the coupler joint is the intersection of two
circles.
"""

import argparse
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time


def joint(links, theta, side):
    """Crank pin B and coupler joint C in the frame's axes, or None where it does not close."""
    crank, coupler, rocker, frame = links
    bx, by = crank * math.cos(theta), crank * math.sin(theta)
    dx, dy = frame - bx, -by
    distance = math.hypot(dx, dy)
    if distance == 0:
        return None
    along = (distance**2 + coupler**2 - rocker**2) / (2 * distance)
    square = coupler**2 - along**2
    if square <= 0:
        return None
    across = side * math.sqrt(square)
    return (bx, by), (bx + (along * dx - across * dy) / distance, by + (along * dy + across * dx) / distance)


def coupler_point(design, theta):
    """The coupler point at a crank angle from the frame, or None."""
    links, side, (u, v), (ax, ay), turn = design
    pins = joint(links, theta, side)
    if pins is None:
        return None
    (bx, by), (cx, cy) = pins
    ex, ey = (cx - bx) / links[1], (cy - by) / links[1]
    x, y = bx + u * ex - v * ey, by + u * ey + v * ex
    return ax + x * math.cos(turn) - y * math.sin(turn), ay + x * math.sin(turn) + y * math.cos(turn)


def longest_range(links, side):
    """The longest stretch of whole degrees in which the linkage closes, in radians."""
    closes = [joint(links, math.radians(k), side) is not None for k in range(360)]
    if all(closes):
        return 0.0, 2 * math.pi
    best, run = (0, 0), 0
    for k in range(720):
        run = run + 1 if closes[k % 360] else 0
        if run > best[1]:
            best = (k - run + 1, run)
    return math.radians(best[0]), math.radians(best[0] + best[1] - 1)


def random_design(rng):
    links = [math.exp(rng.uniform(-0.9, 0.9)) for _ in range(4)]
    if 2 * max(links) >= sum(links):
        return random_design(rng)
    place = rng.uniform(-2, 2), rng.uniform(-2, 2)
    point = rng.uniform(-1.5, 1.5) * links[1], rng.uniform(-1.5, 1.5) * links[1]
    return links, rng.choice((-1, 1)), point, place, rng.uniform(-math.pi, math.pi)


def random_angles(rng, design, count, whole):
    """Crank angles in order, and whether they are of a whole turn; empty where the range is narrow."""
    low, high = longest_range(design[0], design[1])
    turns = high - low >= 2 * math.pi
    if whole and not turns:
        return []
    if whole:
        sweep, start = 2 * math.pi * (1 - 1 / count), rng.uniform(0, 2 * math.pi)
    else:
        sweep = rng.uniform(0.15, 0.7) * (high - low)
        start = rng.uniform(0, 2 * math.pi) if turns else low + rng.uniform(0.05, 0.95) * (high - low - sweep)
    if sweep < 0.3:
        return []
    shares = [rng.uniform(0.4, 1.6) for _ in range(count - 1)]
    scale, angles = sweep / sum(shares), [start]
    for share in shares:
        angles.append(angles[-1] + share * scale)
    return angles[::-1] if rng.random() < 0.5 else angles


def size_of(points):
    cx, cy = (statistics.fmean(axis) for axis in zip(*points))
    return math.sqrt(statistics.fmean((x - cx) ** 2 + (y - cy) ** 2 for x, y in points))


def planted(rng, count, noise, timing):
    """A target: points, crank angles where timed, and the planted error."""
    while True:
        design = random_design(rng)
        angles = random_angles(rng, design, count, rng.random() < 0.5)
        clean = [coupler_point(design, angle) for angle in angles]
        if not clean or None in clean:
            continue
        deviation = noise * size_of(clean) / math.sqrt(2)
        if size_of(clean) < 0.05:
            continue
        points = [(x + rng.gauss(0, deviation), y + rng.gauss(0, deviation)) for x, y in clean]
        error = sum((x - p) ** 2 + (y - q) ** 2 for (x, y), (p, q) in zip(points, clean))
        timed = [angles[k] - angles[0] if k % 4 == 0 else None for k in range(count)]
        return points, timed if timing == "mixed" else None, error


def problem_text(points, timed, order):
    lines = ['kind = "path-generation"', "[target]",
             f"points = {[list(point) for point in points]}"]
    if order == "any":
        lines.append('order = "any"')
    if timed is not None:
        sense = "cw" if min(angle for angle in timed if angle is not None) < 0 else "ccw"
        degrees = ['"free"' if angle is None else repr(abs(math.degrees(angle))) for angle in timed]
        lines += ['timing = "mixed"', f"crank_deg = [{', '.join(degrees)}]", f'crank_sense = "{sense}"']
    return "\n".join(lines) + "\n"


def solve(program, text, path, extra):
    path.write_text(text)
    begin = time.monotonic()
    run = subprocess.run([program, "solve", str(path), "--json", *extra], capture_output=True, text=True)
    spent = time.monotonic() - begin
    if run.returncode not in (0, 1, 2, 3) or not run.stdout:
        return "failed: " + run.stderr.strip(), math.inf, spent
    result = json.loads(run.stdout)
    designs = result["designs"]
    error = designs[0]["error"]["sum_of_squares"] if designs else math.inf
    return result["status"], error, spent


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=75, help="problems of each noise level")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--noise", default="0,0.001,0.01,0.05")
    parser.add_argument("--points", default="8,40")
    parser.add_argument("--orders", default="cyclic")
    parser.add_argument("--timings", default="free")
    parser.add_argument("--slack", type=float, default=math.inf)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files of what failed")
    parser.add_argument("--options", default="", help="further options of the program")
    given = parser.parse_args()
    least, most = (int(number) for number in given.points.split(","))
    failures = tested = compared = behind = 0
    print(f"{'noise':>7} {'order':>7} {'timing':>7} {'solved':>8} {'infeasible':>10} {'else':>5} "
          f"{'worst ratio':>12} {'exceed':>7} {'median s':>9} {'worst s':>8}")
    with tempfile.TemporaryDirectory() as folder:
        for timing in given.timings.split(","):
            for noise in (float(each) for each in given.noise.split(",")):
                in_order = {}
                for order in given.orders.split(","):
                    times, solved, infeasible, worst, exceed = [], 0, 0, 0.0, 0
                    for index in range(given.count):
                        rng = random.Random(f"{given.seed} {noise} {timing} {index}")
                        points, timed, error = planted(rng, rng.randint(least, most), noise, timing)
                        text = problem_text(points, timed, order)
                        status, found, spent = solve(given.program, text,
                                                     pathlib.Path(folder) / "path.toml", given.options.split())
                        # Where nothing is planted but rounding remains.
                        ratio = found / max(error, 1e-22 * len(points) * size_of(points) ** 2)
                        if order == "cyclic":
                            in_order[index] = ratio
                        elif index in in_order:
                            compared += 1
                            behind += ratio > max(1e-3, in_order[index] * (1 + 1e-6))
                        times.append(spent)
                        tested += 1
                        solved += status == "solved"
                        infeasible += status == "infeasible"
                        worst = max(worst, ratio)
                        exceeds = ratio > 1 + given.slack
                        exceed += ratio > 1 + (given.slack if math.isfinite(given.slack) else 1e-6)
                        if status != "solved" or exceeds:
                            failures += 1
                        if given.keep and (status != "solved" or ratio > 1 + 1e-6):
                            given.keep.mkdir(parents=True, exist_ok=True)
                            name = f"{noise}-{order}-{timing}-{index}.toml"
                            (given.keep / name).write_text(f"# {status}, {ratio:.6g} of the planted {error}\n" + text)
                    other = given.count - solved - infeasible
                    print(f"{noise:7g} {order:>7} {timing:>7} {solved:8d} {infeasible:10d} {other:5d} {worst:12.5g} "
                          f"{exceed:7d} {statistics.median(times):9.2f} {max(times):8.2f}", flush=True)
    if compared:
        print(f"{behind} of {compared} in any order are worse than the same in order")
    print(f"{tested} problems, {failures} failures")
    return 1 if failures or not tested else 0


if __name__ == "__main__":
    sys.exit(main())
