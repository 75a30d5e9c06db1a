#!/usr/bin/env python3
"""Draws the precision that each solver reached against its run time.

    build/release/tests/bench/work_precision/work_precision --csv work_precision.csv
    tests/bench/work_precision/plot_work_precision.py work_precision.csv docs/pictures/work-precision.png

Needs matplotlib (Debian: python3-matplotlib).
"""

import argparse
import csv
import statistics

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FLOOR = 1e-12
COLUMNS = 5

# Solver: label, colour, line width; the palette of Okabe & Ito. Close kin share a colour and are
# distinguished by their marker.
SOLVERS = {
    "mma": ("MMA", "#cc79a7", "v"),
    "ccsaq": ("CCSAQ", "#cc79a7", "^"),
    "cobyla": ("COBYLA", "#e69f00", "s"),
    "bobyqa": ("BOBYQA", "#e69f00", "D"),
    "ags": ("AGS", "#999999", "v"),
    "isres": ("ISRES", "#999999", "^"),
    "crs": ("CRS", "#999999", "s"),
    "mlsl": ("MLSL", "#999999", "D"),
    "direct": ("DIRECT", "#999999", "x"),
    "ceres": ("Ceres", "#009e73", "s"),
    "ipopt": ("Ipopt", "#d55e00", "D"),
    "slsqp": ("SLSQP", "#56b4e9", "^"),
    "gauss-newton": ("Gauss-Newton", "#0072b2", "o"),
    "auto": ("auto: the program's search", "#000000", "o"),
}
STARTS = {"screened": "-", "random": (0, (2, 1.5))}


def read(path):
    """Improvements (seconds, excess) by problem, then by solver, starts and seed."""
    problems, kinds = {}, {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            kinds[row["problem"]] = row["kind"]
            courses = problems.setdefault(row["problem"], {}).setdefault(
                (row["solver"], row["starts"]), {})
            point = (float(row["seconds"]), max(float(row["excess"]), FLOOR))
            courses.setdefault(row["seed"], []).append(point)
    return problems, kinds


def excess_at(course, seconds):
    """What a run had reached by then; infinite before its first design."""
    return min((excess for at, excess in course if at <= seconds), default=float("inf"))


def median_course(courses, seeds):
    """The median of the runs, as steps at each of their improvements."""
    times = sorted(at for course in courses for at, _ in course)
    missing = [float("inf")] * (seeds - len(courses))
    points = []
    for at in times:
        excess = statistics.median_high([excess_at(course, at) for course in courses] + missing)
        if excess != float("inf") and (not points or excess < points[-1][1]):
            points.append((at, excess))
    return points


def draw_panel(axes, problem, kind, runs, last, seeds):
    for solver, (label, colour, marker) in SOLVERS.items():
        for starts, style in STARTS.items():
            courses = list(runs.get((solver, starts), {}).values())
            points = median_course(courses, seeds)
            if not points:
                continue
            x, y = zip(*points, (last, points[-1][1]))
            ours = solver == "auto"
            axes.step(x, y, where="post", color=colour, linestyle=style, marker=marker,
                      markevery=(0, max(1, len(x) // 4)), markersize=4.5 if ours else 2.8,
                      linewidth=2.6 if ours else 1.0, zorder=4 if ours else 3,
                      label=label if starts == "screened" else None)
    axes.set(xscale="log", yscale="log", title=f"{problem}\n({kind})", ylim=(FLOOR / 3, 1e4))
    axes.grid(color="#e4e4e4", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("csv", help="what work_precision --csv wrote")
    parser.add_argument("picture", help="where to write the picture (.png or .svg)")
    arguments = parser.parse_args()

    problems, kinds = read(arguments.csv)
    everything = [course for runs in problems.values() for seeds in runs.values()
                  for course in seeds.values()]
    last = max(at for course in everything for at, _ in course)
    seeds = max(len(runs) for problem in problems.values() for runs in problem.values())
    plt.rcParams.update({"font.size": 8, "axes.titlesize": 9})
    rows = -(-len(problems) // COLUMNS)
    figure, panels = plt.subplots(rows, COLUMNS, figsize=(13, 3.1 * rows + 1), sharex=True,
                                  sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.06, right=0.99, top=0.93, bottom=0.2, wspace=0.08, hspace=0.3)
    for axes, (problem, runs) in zip(panels.flat, problems.items()):
        draw_panel(axes, problem, kinds[problem], runs, last, seeds)
    for axes in panels.flat[len(problems):]:
        axes.set_visible(False)
    for axes in panels[-1]:
        axes.set_xlabel("run time on one thread, s")
    for row in panels:
        row[0].set_ylabel("excess over the least error known")
    handles = {}
    for axes in panels.flat:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    for style, label in ((STARTS["screened"], "starts screened by structure"),
                         (STARTS["random"], "starts at random")):
        handles[label] = plt.Line2D([], [], color="#404040", linestyle=style, linewidth=1.2)
    figure.legend(handles.values(), handles.keys(), loc="lower center", ncols=6, frameon=False)
    figure.savefig(arguments.picture, dpi=110)


if __name__ == "__main__":
    main()
