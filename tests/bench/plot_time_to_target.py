#!/usr/bin/env python3
"""Draws time-to-target plots: of each published problem the share of seeds that have reached its record by a time.

    build/release/tests/time_to_target --csv times.csv
    tests/bench/plot_time_to_target.py times.csv docs/pictures/time-to-target.png

A line is the exponential distribution after a shift that has the same quartiles, which the times of independent
restarts follow. Needs matplotlib (Debian: python3-matplotlib).
"""

import argparse
import csv
import math
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLUMNS = 9
POINTS, LINE = "#0072b2", "#d55e00"


def read(path):
    """The seconds of each problem by seed, sorted; infinite where the record was never reached."""
    times = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            seconds = float(row["seconds"]) if row["reached"] == "1" else math.inf
            times.setdefault(row["problem"], []).append(seconds)
    return {problem: sorted(seconds) for problem, seconds in times.items()}


def shifted_exponential(seconds):
    """Shift and scale by the quartiles of the times; no line where they are one number."""
    low, high = (seconds[int(share * (len(seconds) - 1))] for share in (0.25, 0.75))
    if not 0 < high - low < math.inf:
        return None
    scale = (high - low) / math.log(3)
    return max(low - scale * math.log(4 / 3), 0), scale


def draw(axes, problem, seconds):
    reached = [at for at in seconds if math.isfinite(at)]
    shares = [(place + 0.5) / len(seconds) for place in range(len(reached))]
    axes.plot(reached, shares, ".", color=POINTS, markersize=2.5)
    fitted = shifted_exponential(seconds)
    if fitted:
        shift, scale = fitted
        share = [step / 200 for step in range(1, 199)]
        axes.plot([shift - scale * math.log(1 - part) for part in share], share, color=LINE, linewidth=0.8)
    axes.set_title(textwrap.fill(problem, 22), fontsize=6, pad=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv")
    parser.add_argument("picture")
    arguments = parser.parse_args()
    times = read(arguments.csv)
    rows = math.ceil(len(times) / COLUMNS)
    figure, panels = plt.subplots(rows, COLUMNS, figsize=(1.5 * COLUMNS, 1.35 * rows), sharex=True, sharey=True,
                                  squeeze=False, layout="constrained")
    for axes in panels.flat:
        axes.set_xscale("log")
        axes.set_ylim(0, 1)
        axes.tick_params(labelsize=6)
        axes.grid(alpha=0.3, linewidth=0.4)
    for axes, (problem, seconds) in zip(panels.flat, times.items()):
        draw(axes, problem, seconds)
    for axes in panels.flat[len(times):]:
        axes.set_axis_off()
    figure.supxlabel("seconds on one core", fontsize=8)
    figure.supylabel("share of seeds that have reached the record", fontsize=8)
    figure.savefig(arguments.picture, dpi=110)


if __name__ == "__main__":
    main()
