"""The cost of Python against C++: ratios measured side by side in one run.

Run as: ratios.py PROGRAM BATCH LIBRARY, the built program, `python_batch_bench` and
problems/library, with the module on PYTHONPATH. Prints a table.
"""

import pathlib
import statistics
import subprocess
import sys
import time

import cognate
import numpy as np


def least(do, calls):
    best = float("inf")
    for _ in range(calls):
        begun = time.perf_counter()
        do()
        best = min(best, time.perf_counter() - begun)
    return best


def batches(bench):
    """C++ and Python in turns, the medians of the ratios."""
    random = np.random.default_rng(1)
    for designs, angles in ((1000, 360), (100, 360), (10000, 36)):
        table = np.asfortranarray(random.uniform(0.5, 3, size=(designs, 10)))
        table[:, 7] = 1
        at = np.linspace(0, 6, angles, endpoint=False)
        out = np.empty((designs, angles, 2), order="F")
        fresh, reused = [], []
        for _ in range(9):
            ran = subprocess.run([bench, str(designs), str(angles), "40"], capture_output=True,
                                 text=True, check=True)
            there = float(ran.stdout)
            fresh.append(there / least(lambda: cognate.batch.positions(table, at), 40))
            reused.append(there / least(lambda: cognate.batch.positions(table, at, out=out), 40))
        print(f"throughput, {designs} designs x {angles} angles, of C++: "
              f"new arrays {statistics.median(fresh):.2f}, out= {statistics.median(reused):.2f}")


def single_calls():
    bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3,
                          coupler_point=[1, 1])
    for name, do in (("curve(angle)", lambda: bar.curve(0.5)), ("positions(angle)", lambda: bar.positions(0.5))):
        many = 2000
        taken = least(lambda: [do() for _ in range(many)], 20) / many
        print(f"one call of {name}: {1e6 * taken:.2f} us")


def solves(program, library):
    """The least time of a solve from Python, less what the search itself says it took, and that of
    the program's process less that of `--version`: reading and the document are in both."""
    for name in ("function/log10", "motion/five-poses", "quick-return/crank-rocker-best"):
        file = library / f"{name}.toml"
        over = []
        for _ in range(60):
            begun = time.perf_counter()
            result = cognate.solve(file, threads=1)
            result.document
            over.append(time.perf_counter() - begun - result.work.seconds)
        command = [program, "solve", str(file), "--json", "--threads", "1"]
        there = least(lambda: subprocess.run(command, capture_output=True), 15)
        start = least(lambda: subprocess.run([program, "--version"], capture_output=True), 15)
        print(f"solve {name}: {1e3 * min(over):.2f} ms plus the search of "
              f"{1e3 * result.work.seconds:.2f} ms (the program: {1e3 * (there - start):.2f} ms "
              f"plus its start of {1e3 * start:.2f} ms)")


if __name__ == "__main__":
    batches(sys.argv[2])
    single_calls()
    solves(sys.argv[1], pathlib.Path(sys.argv[3]))
