"""Paths and functions of planted mechanisms with a three-pin link: what the program finds.

Run as: planted_three_pins.py PROGRAM [--count N] [--seed S] [--noise SHARE...] [--limit DEGREES] [--functions]
Paths of three-pin-1 and three-pin-2 with transmission angles of more than 35 degrees, which turn
fully. How far the noise lies from the planted path is its error. A design worse than that, or none,
is missed; an exact path is found below 0.01 % of its diagonal. With --functions the angles of their
third links over 130 degrees of the crank, noise in shares of the swing; an exact one is found below
0.01 % of that.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "app"))
import three_pin_paths  # noqa: E402

POINTS = 72


def problem(points, kind, limit):
    rows = ", ".join(f"[{p.real:.15g}, {p.imag:.15g}]" for p in points)
    return (f'kind = "path-generation"\n[target]\nclosed = true\npoints = [{rows}]\n'
            f'[mechanism]\ntype = "three-pin-{kind}"\n'
            f'[constraints]\ntransmission_angle_deg = [{limit}, {180 - limit}]\n')


def solved(program, text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        done = subprocess.run([program, "--quiet", "--json", "solve", path], capture_output=True,
                              check=False)
        return json.loads(done.stdout)["designs"]


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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--noise", type=float, nargs="+", default=[0, 0.001, 0.01])
    parser.add_argument("--limit", type=float, default=30)
    parser.add_argument("--functions", dest="of", action="store_const", const=Functions, default=Paths)
    arguments = parser.parse_args()
    for kind in (1, 2):
        for noise in arguments.noise:
            found, seconds = 0, []
            for i in range(arguments.count):
                rng = random.Random(f"{arguments.seed} {kind} {i}")
                planted = arguments.of(kind, rng, noise, arguments.limit)
                begun = time.monotonic()
                designs = solved(arguments.program, planted.text)
                seconds.append(time.monotonic() - begun)
                met = [d for d in designs if all(row["satisfied"] for row in d["constraints"])]
                found += bool(met) and met[0]["error"]["rms"] < planted.allowed
            seconds.sort()
            print(f"three-pin-{kind}, noise {noise:g}: {found} of {arguments.count} found, "
                  f"median {seconds[len(seconds) // 2]:.1f} s", flush=True)


if __name__ == "__main__":
    main()
