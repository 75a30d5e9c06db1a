#!/usr/bin/env python3
"""What searches find by their seeds: the best design's error and the processor time, of several programs in turn.

    tests/bench/seeds.py build/release/app/cognate [OTHER...] --files problems/library/dwell/*.toml --seeds 8

Behind each file stand for each program how many seeds came within 1 % of the best that any of them found, the
greatest ratio to that best, and the median of the processor time.
"""

import argparse
import json
import pathlib
import resource
import statistics
import subprocess

WITHIN = 1.01


def solved(program, file, seed, key):
    """The error of the best design, infinite where there is none, and the seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "solve", "--json", "--quiet", "--seed", str(seed), file],
                         capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    result = json.loads(run.stdout) if run.stdout else {}
    designs = result.get("designs", []) if result.get("status") == "solved" else []
    return (designs[0]["error"][key] if designs else float("inf")), seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", type=pathlib.Path)
    parser.add_argument("--files", nargs="+", type=pathlib.Path, required=True)
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--key", choices=("rms", "max"), default="max", help="of the error")
    arguments = parser.parse_args()
    for file in arguments.files:
        found = [[solved(program, file, seed, arguments.key) for program in arguments.programs]
                 for seed in range(1, arguments.seeds + 1)]
        best = min(error for row in found for error, _ in row)
        if best == float("inf"):
            print(f"{file.stem}: no design")
            continue
        print(f"{file.stem}: best {best:.6g}")
        for program, column in zip(arguments.programs, zip(*found)):
            errors = [error for error, _ in column]
            near = sum(error <= WITHIN * best for error in errors)
            seconds = statistics.median(spent for _, spent in column)
            print(f"  {program}: {near} of {len(errors)}, worst {max(errors) / best:.3g}, {seconds:.1f} s", flush=True)


if __name__ == "__main__":
    main()
