"""Targets that no linkage was planted in, with limited transmission angles: is the search for any class
as good as those for each class by itself?

Run as: border_optima.py PROGRAM [--kinds function minimax timed free motion] [--count N] [--seed S]
                         [--threads N] [--worse-by SHARE] [--allowed SHARE] [--keep FOLDER]

Every linkage has a class, so that the least error of the five searches bounds that of the first from
below. Many optima lie at the border of two classes, beyond which other limits hold: searches that cross
it lose them. Prints each problem that is worse by more than a share, and how many are.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from planting import CLASSES

FUNCTIONS = [("1/x", [1, 2]), ("log10(x)", [1, 2]), ("x^2", [0, 1]), ("x^1.5", [0, 1]),
             ("sin(x)", [0, 1.57]), ("exp(x)", [0, 1]), ("tan(x)", [0, 0.785]), ("sqrt(x)", [1, 4])]


def function(rng, objective):
    text, domain = rng.choice(FUNCTIONS)
    return (f'kind = "function-generation"\n[target]\nfunction = "{text}"\ndomain = {domain}\n'
            f"input_range_deg = {rng.choice([40, 60, 90, 120])}\n"
            f"output_range_deg = {rng.choice([-90, -60, 40, 60, 90])}\nsamples = 21\n"
            f'objective = "{objective}"\n[mechanism]\nframe = 1\n')


def path(rng, timed):
    count, phase, bent = rng.choice([6, 8, 12]), rng.uniform(0, 2 * math.pi), rng.uniform(-0.3, 0.3)
    wide, high = rng.uniform(1, 3), rng.uniform(0.5, 2)
    arc = rng.choice([1.0, 1.5, 3.0] if timed else [2.0, 4.0, 6.0])
    angles = [arc * k / count for k in range(count)]
    points = [[wide * math.cos(phase + a) + bent * math.cos(2 * (phase + a)),
               high * math.sin(phase + a) + bent * math.sin(3 * (phase + a))] for a in angles]
    timing = f'timing = "prescribed"\ncrank_deg = {[math.degrees(a) for a in angles]}\n' if timed else ""
    return f'kind = "path-generation"\n[target]\npoints = {points}\n{timing}'


def motion(rng):
    poses, at = [], [0.0, 0.0, 0.0]
    for _ in range(rng.choice([4, 5, 6, 8])):
        poses.append(list(at))
        at = [at[0] + rng.uniform(0.3, 1.2), at[1] + rng.uniform(-0.6, 0.6), at[2] + rng.uniform(-5, 25)]
    return (f'kind = "motion-generation"\n[target]\nmethod = "least-squares"\nposes = {poses}\n'
            '[mechanism]\ndyads = ["RR"]\n')


KINDS = {"function": lambda rng: function(rng, "least-squares"), "minimax": lambda rng: function(rng, "minimax"),
         "timed": lambda rng: path(rng, True), "free": lambda rng: path(rng, False), "motion": motion}


def limits(rng):
    low = rng.choice([30, 40, 50])
    ratio = f"link_ratio_max = {rng.choice([4, 6, 10])}\n" if rng.random() < 0.3 else ""
    return f"[constraints]\ntransmission_angle_deg = [{low}, {180 - low}]\n{ratio}"


def error(arguments, kind, text):
    """The error that the program minimises; infinite where it finds no design."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "problem.toml")
        file.write_text(text)
        command = [arguments.program, "solve", str(file), "--json"]
        if arguments.threads:
            command += ["--threads", str(arguments.threads)]
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
    document = json.loads(answer.stdout)
    if document.get("status") != "solved":
        return math.inf
    return document["designs"][0]["error"]["max" if kind == "minimax" else "rms"]


def compare(arguments, kind):
    """How many problems are worse than in a class."""
    worse = 0
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        rng = random.Random(seed)
        text = KINDS[kind](rng) + limits(rng)
        by_class = {name: error(arguments, kind, text + f'class = "{name}"\n') for name in CLASSES}
        best = min(by_class, key=by_class.get)
        of_any = error(arguments, kind, text)
        if of_any <= by_class[best] * (1 + arguments.worse_by) + 1e-9:
            continue
        worse += 1
        print(f"{kind} {seed}: {of_any:.6g} of any class, {by_class[best]:.6g} as {best}")
        if arguments.keep:
            arguments.keep.mkdir(parents=True, exist_ok=True)
            (arguments.keep / f"{kind}-{seed}.toml").write_text(text)
    print(f"{kind}: {worse} of {arguments.count} are worse than in a class", flush=True)
    return worse


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--kinds", nargs="*", choices=KINDS, default=list(KINDS))
    parser.add_argument("--count", type=int, default=20, help="problems of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int)
    parser.add_argument("--worse-by", type=float, default=1e-3)
    parser.add_argument("--allowed", type=float, default=0, help="share of problems that may be worse")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files of what is worse")
    arguments = parser.parse_args()
    worse = sum(compare(arguments, kind) for kind in arguments.kinds)
    sys.exit(int(worse > arguments.allowed * arguments.count * len(arguments.kinds)))


if __name__ == "__main__":
    main()
