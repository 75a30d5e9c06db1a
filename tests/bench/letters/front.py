#!/usr/bin/env python3
"""How many links a letter takes: capitals written by four-bars, six-bars and eight-bars.

    tests/bench/letters/front.py build/release/app/cognate --folder letters --picture docs/pictures/letters.png

For each capital of a single-stroke font the best chain of each number of links, every transmission angle
of 30° to 150° over the whole turn. The folder gets a problem, a result and a report of each letter, and
index.html, a page of all. Letters that have a result are not solved again. Distances are means of those from
the letter to the curve and back, in hundredths of the letter's height, by a closure of this script's own.
Needs hershey-fonts-data, python3-scipy and, for the picture, python3-matplotlib (Debian).
"""

import argparse
import html
import json
import pathlib
import string
import subprocess
import sys

import numpy as np

import curves
import strokes

POINTS = 64
TRANSMISSION = 30
LINKS = (4, 6, 8)

FILE = """# The letter {letter} of Hershey's Roman simplex, as a pen draws it without being lifted.
kind = "path-generation"
title = "{letter}"
[target]
points = {points}
closed = {closed}
[mechanism]
type = "any"
[bounds]
length = [0.05, 5]
pivots = [[-4, -4], [4, 5]]
point = [[-4, -4], [4, 4]]
[constraints]
transmission_angle_deg = [{least}, {greatest}]
[solve]
objectives = ["error", "links"]
"""


def solve(program, folder, letter, arguments):
    """Seconds that the search took."""
    points, closed = strokes.pen_path(letter, POINTS)
    points = np.round(points, 6)
    # Where the pen turns back, two neighbours may be one.
    points = points[np.append(True, np.any(np.diff(points, axis=0) != 0, axis=1))]
    file = folder / f"{letter}.toml"
    file.write_text(FILE.format(letter=letter, points=points.tolist(), closed=str(closed).lower(),
                                least=TRANSMISSION, greatest=180 - TRANSMISSION), encoding="utf-8")
    subprocess.run([program, "solve", "--quiet", "--seed", str(arguments.seed), "--time-limit",
                    str(arguments.seconds), file.name], cwd=folder, stdout=subprocess.DEVNULL, check=False)


def designs(folder, letter):
    """For each number of links found: curve while writing, curve of the whole turn, mean distance; and the
    seconds."""
    result = json.loads((folder / f"{letter}.result.json").read_text(encoding="utf-8"))
    points, closed = strokes.pen_path(letter, 600)
    pen = np.append(points, points[:1], axis=0) if closed else points
    found = {}
    for design in result["designs"]:
        if not all(check["satisfied"] for check in design["constraints"]):
            continue
        first, turned = curves.written(design["crank_deg"], closed)
        writing = curves.trace(design["mechanism"], first + np.linspace(0, turned, 2001))
        turn = curves.trace(design["mechanism"], np.linspace(0, 2 * np.pi, 721))
        if not np.all(np.isfinite(turn)):
            sys.exit(f"{letter}: the chain of {design['metrics']['link_count']} links does not close over the turn")
        distance = curves.mean_distance(writing, pen @ (1, 1j))
        found[int(design["metrics"]["link_count"])] = (writing, turn, distance)
    return found, result["work"]["seconds"]


def percent(distance):
    return f"{100 * distance:.2g} %" if distance >= 1e-4 else "< 0.01 %"


def outline(curve):
    return "M" + "L".join(f"{z.real:.3f} {-z.imag:.3f}" for z in curve)


def drawing(letter, found, links):
    """A letter with the curve of its chain of so many links, as SVG."""
    pen, closed = strokes.pen_path(letter, 200)
    target = outline(pen @ (1, 1j)) + ("Z" if closed else "")
    paths = f'<path class="target" d="{target}"/>'
    caption = "no nearer"
    if links in found:
        writing, _, distance = found[links]
        paths += f'<path class="curve" d="{outline(writing[::8])}"/>'
        caption = percent(distance)
    return (f'<figure><svg viewBox="-0.7 -1.15 1.4 1.3" role="img" aria-label="{letter}, {links} links">{paths}</svg>'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Letters written by linkages</title>
<style>
body {{ font: 1rem/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color-scheme: light dark; }}
.letters {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: 1.5rem; }}
.row {{ display: grid; grid-template-columns: repeat(3, 1fr); }}
figure {{ margin: 0; text-align: center; }} figcaption {{ font-size: .85rem; }}
path {{ fill: none; stroke-linejoin: round; stroke-linecap: round; }}
.target {{ stroke: #8888; stroke-width: .07; }} .curve {{ stroke: #c2410c; stroke-width: .018; }}
</style>
<h1>Letters written by linkages</h1>
<p>Capitals of Hershey's single-stroke font, written by the best four-bar, six-bar and eight-bar (4, 7 and 10
joints) whose transmission angles stay between {least}° and {greatest}° over the whole turn. Below each: the mean
distance between letter and curve, both ways, in hundredths of the letter's height.</p>
<div class="letters">
{letters}
</div>
</html>
"""


def page(all_found):
    sections = [f'<section><h2><a href="{letter}.report.html">{letter}</a></h2><div class="row">'
                + "".join(drawing(letter, found, links) for links in LINKS) + "</div></section>"
                for letter, found in all_found.items()]
    return PAGE.format(least=TRANSMISSION, greatest=180 - TRANSMISSION, letters="\n".join(sections))


def picture(all_found, path):
    import matplotlib  # pylint: disable=import-outside-toplevel

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel

    columns = 13
    blocks = -(-len(all_found) // columns)
    figure, axes = plt.subplots(3 * blocks, columns, figsize=(13, 3.9 * blocks), squeeze=False)
    for axis in axes.flat:
        axis.set(xlim=(-0.62, 0.62), ylim=(-0.28, 1.08), aspect="equal")
        axis.axis("off")
    for k, (letter, found) in enumerate(all_found.items()):
        pen, closed = strokes.pen_path(letter, 400)
        pen = np.append(pen, pen[:1], axis=0) if closed else pen
        for row, links in enumerate(LINKS):
            axis = axes[3 * (k // columns) + row, k % columns]
            axis.plot(*pen.T, color="0.82", lw=4.5, solid_capstyle="round", solid_joinstyle="round")
            if links in found:
                writing, _, distance = found[links]
                axis.plot(writing.real, writing.imag, color="#c2410c", lw=1.1)
                axis.text(0, -0.26, percent(distance), ha="center", size=8)
            if k % columns == 0:
                axis.text(-0.9, 0.5, f"{links} links", rotation=90, va="center", ha="center", size=9)
    figure.subplots_adjust(0.025, 0.01, 1, 0.99, 0.02, 0.05)
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--letters", default=string.ascii_uppercase)
    parser.add_argument("--seconds", type=float, default=60, help="for each letter")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--picture", type=pathlib.Path)
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    all_found = {}
    print("letter  " + "".join(f"{links} links, %   " for links in LINKS) + "seconds")
    for letter in arguments.letters:
        if not (arguments.folder / f"{letter}.result.json").exists():
            solve(program, arguments.folder, letter, arguments)
        found, seconds = designs(arguments.folder, letter)
        all_found[letter] = found
        columns = (f"{100 * found[links][2]:<12.3g}" if links in found else f"{'–':<12}" for links in LINKS)
        print(f"{letter:<8}" + "".join(columns) + f"{seconds:.0f}", flush=True)
    best = [min(distance for *_, distance in found.values()) for found in all_found.values() if found]
    print(f"{sum(100 * one < 1 for one in best)} of {len(all_found)} letters below 1 %")
    (arguments.folder / "index.html").write_text(page(all_found), encoding="utf-8")
    if arguments.picture:
        picture(all_found, arguments.picture)


if __name__ == "__main__":
    main()
