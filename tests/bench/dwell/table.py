#!/usr/bin/env python3
"""How small the half band of a six-bar's dwell can be, by window and swing.

    tests/bench/dwell/table.py build/release/app/cognate --csv dwells.csv --picture docs/pictures/dwells.png

Solves a dwell for each window and each minimum swing of the output, every dyad's transmission angle being
kept over the whole turn. What dwells over a longer window, or swings further, serves the shorter window and
the smaller swing as well: each entry is the best of all that serve it. Cells that the CSV file has are not
computed again. Needs matplotlib (Debian: python3-matplotlib) for the picture.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

WINDOWS = range(30, 211, 30)
SWINGS = range(20, 121, 20)
TRANSMISSION = 40

FILE = """kind = "function-generation"
[target]
dwell = [{{ over_deg = {window} }}]
swing_deg_min = {swing}
[mechanism]
type = "six-bar"
[constraints]
transmission_angle_deg = [{least}, {greatest}]
[solve]
starts = {starts}
designs = 1
"""


def half_band(program, window, swing, arguments):
    """Of the best design in degrees, its topology and the seconds; no design is None."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "dwell.toml"
        file.write_text(FILE.format(window=window, swing=swing, least=TRANSMISSION, greatest=180 - TRANSMISSION,
                                    starts=arguments.starts), encoding="utf-8")
        run = subprocess.run([program, "solve", "--json", "--quiet", "--seed", str(arguments.seed), file],
                             capture_output=True, text=True, check=False)
    result = json.loads(run.stdout)
    if result["status"] != "solved":
        return None, "", result["work"]["seconds"]
    metrics = result["designs"][0]["metrics"]
    return metrics["half_band_deg"], metrics["topology"], result["work"]["seconds"]


def serving(found, window, swing):
    """The best half band that serves the window and the swing, and its topology."""
    bands = [(band, topology) for (over, by), (band, topology) in found.items()
             if band is not None and over >= window and by >= swing]
    return min(bands, default=(None, ""))


def read(path):
    if not path.exists():
        return {}
    with open(path, encoding="utf-8") as file:
        return {(int(row["window_deg"]), int(row["swing_deg"])):
                (float(row["half_band_deg"]) if row["half_band_deg"] else None, row["topology"])
                for row in csv.DictReader(file)}


def compute(arguments):
    found = read(arguments.csv)
    is_new = not found
    with open(arguments.csv, "a", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        if is_new:
            table.writerow(["window_deg", "swing_deg", "half_band_deg", "topology", "seconds"])
        for window in WINDOWS:
            for swing in SWINGS:
                if (window, swing) in found:
                    continue
                band, topology, seconds = half_band(arguments.program, window, swing, arguments)
                found[window, swing] = band, topology
                table.writerow([window, swing, "" if band is None else band, topology, f"{seconds:.1f}"])
                file.flush()
                print(f"{window}° with a swing of {swing}°: {band} {topology} {seconds:.1f} s", file=sys.stderr)
    return found


def print_table(found):
    print("| window | " + " | ".join(f"swing ≥ {swing}°" for swing in SWINGS) + " |")
    print("|---" * (len(SWINGS) + 1) + "|")
    for window in WINDOWS:
        bands = [serving(found, window, swing)[0] for swing in SWINGS]
        print(f"| {window}° | " + " | ".join("–" if band is None else f"{band:.2g}°" for band in bands) + " |")


def draw(found, picture):
    import matplotlib  # pylint: disable=import-outside-toplevel
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel
    from matplotlib.colors import LogNorm  # pylint: disable=import-outside-toplevel

    bands = [[serving(found, window, swing)[0] or float("nan") for swing in SWINGS] for window in WINDOWS]
    figure, axes = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
    known = [band for row in bands for band in row if band == band]
    image = axes.imshow(bands, norm=LogNorm(min(known), max(known)), cmap="viridis", aspect="auto", origin="lower")
    axes.set_xticks(range(len(SWINGS)), [f"{swing}°" for swing in SWINGS])
    axes.set_yticks(range(len(WINDOWS)), [f"{window}°" for window in WINDOWS])
    axes.set_xlabel("minimum swing of the output")
    axes.set_ylabel("crank angle of the dwell")
    axes.set_title(f"Half band of the best six-bar found, transmission angles ≥ {TRANSMISSION}°")
    middle = (min(known) * max(known)) ** 0.5
    for i, row in enumerate(bands):
        for j, band in enumerate(row):
            text = "none" if band != band else f"{band:.1e}°" if band < 1e-3 else f"{band:.2g}°"
            axes.text(j, i, text, ha="center", va="center", color="white" if band < middle else "black")
    figure.colorbar(image, label="half band, degrees")
    figure.savefig(picture, dpi=130)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--csv", type=pathlib.Path, required=True, help="file of the cells, which is gone on with")
    parser.add_argument("--picture", type=pathlib.Path, help="file of the picture")
    parser.add_argument("--starts", type=int, default=1536, help="of each search")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    found = compute(arguments)
    print_table(found)
    if arguments.picture:
        draw(found, arguments.picture)


if __name__ == "__main__":
    main()
