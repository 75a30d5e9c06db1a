#!/usr/bin/env python3
"""A study on 10, 100 and 1000 processes, simulated from the measured costs of the first one.

    tests/bench/sweep/ranks.py [--writer build/release/tests/study_writer_bench] [--message SECONDS]

The first process, which evaluates nothing itself, answers each message, unpacks its rows and stores them, one thing after another; every other
one evaluates a block, sends it, and has two blocks in advance, so that it waits only once both are done. The
costs of rows and of blocks without rows are those that study_writer_bench prints, or the ones below, of one
core of an x86-64 virtual machine; that of a message and its answer is an assumption. Evaluation times are
drawn anew for each block: equal, or spread as those of searches are (log-normal, a factor of two).

For each study and number of processes: designs a second, their share of what the processes could evaluate,
and the share of the time that the first process is busy. One that is busy all the time is what breaks first.
"""

import argparse
import heapq
import math
import random
import re
import subprocess

AHEAD = 2          # blocks that a process has in advance
BLOCKS_EACH = 60   # of each process, in a simulation

# Name, seconds of a design, designs of a block, share of the designs whose rows are kept, spread of the times.
STUDIES = [
    ("solves of 0.1 s", 0.1, 4, 1, math.log(2)),
    ("analyses of 0.25 ms, a tenth kept", 0.25e-3, 64, 0.1, 0),
    ("analyses of 0.25 ms, all kept", 0.25e-3, 64, 1, 0),
    ("four-bars in batches, 4 % kept", 1 / 13e6, 8192, 0.04, 0),
    ("four-bars in batches, none kept", 1 / 13e6, 8192, 0, 0),
]


def measured(program):
    """Seconds of a stored and unpacked row, and of a block without rows, as the bench prints them."""
    text = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    lines = re.findall(r"^(rows, one objective|blocks without a row)\s+\S+\s+(\S+)\s+(\S+)", text, re.MULTILINE)
    cost = {name: 1 / float(unpacked) + 1 / float(stored) for name, unpacked, stored in lines}
    return cost["rows, one objective"], cost["blocks without a row"]


def simulate(processes, study, row, empty, message, seed=1):
    """Seconds until all blocks are stored, and how long the first process is busy."""
    _, seconds, block, kept, spread = study
    rng = random.Random(seed)
    cost = message + (block * kept * row if kept else empty)
    left = processes * BLOCKS_EACH
    ready = [0.0] * processes          # until when each process has evaluated what it was given
    waiting = []                       # (when a block is done, by whom), earliest first
    for rank in range(processes):
        for _ in range(AHEAD):
            ready[rank] += block * seconds * rng.lognormvariate(-spread**2 / 2, spread)
            heapq.heappush(waiting, (ready[rank], rank))
            left -= 1
    now = busy = 0.0
    while waiting:
        done, rank = heapq.heappop(waiting)
        now = max(now, done) + cost
        busy += cost
        if left > 0:
            left -= 1
            ready[rank] = max(ready[rank], now) + block * seconds * rng.lognormvariate(-spread**2 / 2, spread)
            heapq.heappush(waiting, (ready[rank], rank))
    return now, busy


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--writer", help="study_writer_bench, to measure the costs of the first process here")
    parser.add_argument("--message", type=float, default=5e-6, help="seconds of a message and its answer")
    arguments = parser.parse_args()
    row, empty = measured(arguments.writer) if arguments.writer else (1 / 8e6 + 1 / 1.6e6, 1 / 0.8e6)
    print(f"A row costs {1e6 * row:.2f} µs, a block without rows {1e6 * empty:.2f} µs, "
          f"a message {1e6 * arguments.message:.1f} µs.\n")
    print("| study | processes | designs/s | of the possible | first process busy |\n|---|---|---|---|---|")
    for study in STUDIES:
        for processes in (10, 100, 1000):
            time, busy = simulate(processes, study, row, empty, arguments.message)
            designs = processes * BLOCKS_EACH * study[2] / time
            print(f"| {study[0]} | {processes} | {designs:.2g} | {designs * study[1] / processes:.0%} | {busy / time:.0%} |")


if __name__ == "__main__":
    main()
