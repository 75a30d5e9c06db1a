"""Paths and functions of planted mechanisms with a three-pin link: what the program finds.

Run as: planted_three_pins.py PROGRAM [--count N] [--seed S] [--noise SHARE...] [--limit DEGREES]
        [--functions] [--kinds 1 2] [--first I] [--starts N] [--jobs N] [--within SECONDS] [--allowed SHARE]
Paths of three-pin-1 and three-pin-2 with transmission angles of more than 35 degrees, which turn
fully. How far the noise lies from the planted path is its error. A design worse than that, or none,
is missed; an exact path is found below 0.01 % of its diagonal. With --functions the angles of their
third links over 130 degrees of the crank, noise in shares of the swing; an exact one is found below
0.01 % of that. Planted mechanism I depends on the seed, its type and I alone. Seconds are of
processor time, so that it does not matter how many run at a time or what else the machine does;
each that is missed is named by its I, with its error in shares of the planted one. The status is 1
where more than SHARE of those of one type and noise are missed.
"""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "app"))
import three_pin_paths  # noqa: E402

POINTS = 72


def problem(points, kind, limit):
    rows = ", ".join(f"[{p.real:.15g}, {p.imag:.15g}]" for p in points)
    return (f'kind = "path-generation"\n[target]\nclosed = true\npoints = [{rows}]\n'
            f'[mechanism]\ntype = "three-pin-{kind}"\n'
            f'[constraints]\ntransmission_angle_deg = [{limit}, {180 - limit}]\n')


def solved(program, text):
    """The designs, and the seconds of processor time that they took."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        words = [program, "--quiet", "--json", "--threads", "1", "solve", path]
        with subprocess.Popen(words, stdout=subprocess.PIPE) as process:
            document = process.stdout.read()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        return json.loads(document)["designs"], used.ru_utime + used.ru_stime


class Paths:
    """What is planted as a path, with its noise: the text of the problem, and the error allowed."""

    def __init__(self, kind, rng, noise, limit):
        path = three_pin_paths.planted(kind, rng, 35)
        points = three_pin_paths.at_equal_arcs(path, POINTS)
        share = noise * three_pin_paths.size_of(points)
        points = [p + share * complex(rng.gauss(0, 1), rng.gauss(0, 1)) for p in points]
        diagonal = max(abs(p - q) for p in points for q in points)
        self.text = problem(points, kind, limit)
        self.allowed = three_pin_paths.rms_distance(path, points) if noise else 1e-4 * diagonal


class Functions:
    """The same of a function."""

    def __init__(self, kind, rng, noise, limit):
        pairs = three_pin_paths.planted_pairs(kind, rng, 35)
        swing = max(y for _, y in pairs) - min(y for _, y in pairs)
        missed = [rng.gauss(0, noise * swing) for _ in pairs]
        rows = ", ".join(f"[{x}, {y + e:.15g}]" for (x, y), e in zip(pairs, missed))
        self.text = (f'kind = "function-generation"\n[target]\npairs_deg = [{rows}]\n[mechanism]\n'
                     f'type = "three-pin-{kind}"\n'
                     f'[constraints]\ntransmission_angle_deg = [{limit}, {180 - limit}]\n')
        middle = sum(missed) / len(missed)
        own = math.sqrt(sum((e - middle)**2 for e in missed) / len(missed))
        self.allowed = math.radians(own if noise else 1e-4 * swing)


class Outcome:
    """Of one planted mechanism: its number, the seconds, and the error of what was found in shares of
    what is allowed."""

    def __init__(self, arguments, kind, noise, i):
        rng = random.Random(f"{arguments.seed} {kind} {i}")
        planted = arguments.of(kind, rng, noise, arguments.limit)
        text = planted.text + (f"[solve]\nstarts = {arguments.starts}\n" if arguments.starts else "")
        designs, self.seconds = solved(arguments.program, text)
        met = [d for d in designs if all(row["satisfied"] for row in d["constraints"])]
        self.i = i
        self.share = met[0]["error"]["rms"] / planted.allowed if met else math.inf


def report(arguments, kind, noise, outcomes):
    """Whether no more are missed than allowed."""
    seconds = sorted(one.seconds for one in outcomes)
    found = [one for one in outcomes if one.share < 1]
    soon = sum(one.seconds <= arguments.within for one in found)
    missed = ", ".join(f"{one.i} ({one.share:.3g})" for one in outcomes if one.share >= 1)
    print(f"three-pin-{kind}, noise {noise:g}: {len(found)} of {len(outcomes)} found, {soon} of them within "
          f"{arguments.within:g} s, median {seconds[len(seconds) // 2]:.1f} s, at most {seconds[-1]:.1f} s"
          + (f"; missed {missed}" if missed else ""), flush=True)
    return len(outcomes) - len(found) <= arguments.allowed * len(outcomes)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--noise", type=float, nargs="+", default=[0, 0.001, 0.01])
    parser.add_argument("--limit", type=float, default=30)
    parser.add_argument("--starts", type=int)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--within", type=float, default=5)
    parser.add_argument("--allowed", type=float, default=1)
    parser.add_argument("--functions", dest="of", action="store_const", const=Functions, default=Paths)
    arguments = parser.parse_args()
    is_well = True
    for kind in arguments.kinds:
        for noise in arguments.noise:
            numbers = range(arguments.first, arguments.first + arguments.count)
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                outcomes = list(pool.map(lambda i, of=(kind, noise): Outcome(arguments, *of, i), numbers))
            is_well = report(arguments, kind, noise, outcomes) and is_well
    sys.exit(0 if is_well else 1)


if __name__ == "__main__":
    main()
