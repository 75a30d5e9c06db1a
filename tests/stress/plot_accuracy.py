#!/usr/bin/env python3
"""Draws the errors that closure_accuracy measured against the distance from the singular position.

    build/release/tests/closure_accuracy --csv accuracy.csv
    tests/stress/plot_accuracy.py accuracy.csv docs/pictures/accuracy.png

Needs matplotlib (Debian: python3-matplotlib).
"""

import argparse
import csv

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

UNIT = 2.0**-53

PANELS = {
    "dead point, stretched": ("A dead point", "distance from stretched, 1 − d/(l₂ + l₃)"),
    "change point": ("A change point", "crank angle from the frame's line, rad"),
    "near a change point": ("Nearly a change point", "excess of l₄ over l₁ + l₂ − l₃, relative"),
}

# Form: label, colour, marker; the palette of Okabe & Ito, distinguishable without colour vision too.
FORMS = {
    "half-angle tangents": ("Freudenstein, tangents of half angles", "#cc79a7", "v"),
    "law of cosines": ("law of cosines, acos and atan2", "#e69f00", "s"),
    "raw discriminant": ("circle–circle, raw discriminant", "#009e73", "^"),
    "sorted sides": ("circle–circle, Kahan's sorted sides", "#56b4e9", "D"),
    "kernel": ("Cognate", "#0072b2", "o"),
}


def read(path):
    """Rows by family and form, each (distance, worst error, condition), nearest last."""
    rows = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if int(row["closed"]) == 0:
                continue
            point = (float(row["distance"]), float(row["error_eps"]) * UNIT, float(row["condition"]))
            rows.setdefault((row["family"], row["form"]), []).append(point)
    return {key: sorted(points, reverse=True) for key, points in rows.items()}


def draw_panel(axes, rows, family):
    title, distance = PANELS[family]
    for form, (label, colour, marker) in FORMS.items():
        x, error, condition = zip(*rows[family, form])
        ours = form == "kernel"
        axes.plot(x, [max(e, UNIT / 2) for e in error], color=colour, marker=marker, label=label,
                  markersize=4.5 if ours else 3.2, linewidth=2.4 if ours else 1.2,
                  zorder=4 if ours else 3)
        if ours:
            bound = [UNIT * c for c in condition]
            axes.plot(x, bound, color="#404040", linestyle=(0, (4, 2)), linewidth=1.2, zorder=2,
                      label="ε × condition: what rounding the inputs may change")
    axes.axhline(UNIT, color="#909090", linewidth=0.8, linestyle=":")
    axes.text(1.2e-2, UNIT / 1.3, "ε = 2⁻⁵³", color="#606060", fontsize=8, va="top")
    axes.set(xscale="log", yscale="log", title=title, xlabel=distance, ylim=(1e-17, 3))
    axes.invert_xaxis()
    axes.grid(color="#e4e4e4", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("csv", help="what closure_accuracy --csv wrote")
    parser.add_argument("picture", help="where to write the picture (.png or .svg)")
    arguments = parser.parse_args()

    rows = read(arguments.csv)
    plt.rcParams.update({"font.size": 9, "axes.titlesize": 10.5})
    figure, panels = plt.subplots(1, len(PANELS), figsize=(11, 4.6), sharey=True)
    figure.subplots_adjust(left=0.075, right=0.985, top=0.93, bottom=0.25, wspace=0.06)
    for axes, family in zip(panels, PANELS):
        draw_panel(axes, rows, family)
    panels[0].set_ylabel("worst error of the links' directions\nand of the coupler point, relative")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncols=3, frameon=False)
    figure.savefig(arguments.picture, dpi=110)


if __name__ == "__main__":
    main()
