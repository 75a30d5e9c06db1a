"""Designs per second of one study with one thread, two threads and two processes under mpirun.

Run as: scaling.py PROGRAM [--designs N] [--repeat N]

Three studies: a four-bar that is evaluated in batches with few rows kept, the same with all rows
kept, and a slider-crank that is analysed design by design. Each figure is the best of the
repetitions, which take turns; start-up is left out, and measured by itself.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

FOUR_BAR = """
kind = "analysis"
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [2, 0]]
crank = 1
coupler = 2.5
rocker = 2.5
assembly = "open"
[drive]
speed = 1
steps = 72
"""

SLIDER = """
kind = "analysis"
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = 1
coupler = 3
offset = 0.25
[drive]
speed = 1
steps = 72
"""

VARY = """
[[vary]]
key = "mechanism.{key}"
range = [{least}, {greatest}]
sampling = "sobol"
count = {count}
"""

FEW = """
[output]
metrics = ["transmission_angle_deg.acute_min", "time_ratio"]
[filter]
"transmission_angle_deg.acute_min" = { min = 30 }
[objective]
maximize = "time_ratio"
"""

ALL = FEW.replace("[filter]", 'rows = "all"\n[filter]')

ROOT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def studies(designs):
    box = (("coupler", 1, 4), ("rocker", 1, 4))
    varied = lambda keys, count: "".join(
        VARY.format(key=key, least=least, greatest=greatest, count=count) for key, least, greatest in keys
    )
    slider = (("coupler", 1.5, 6), ("offset", 0, 1))
    return {
        "four-bars, few rows": (FOUR_BAR, varied(box, designs) + FEW),
        "four-bars, all rows": (FOUR_BAR, varied(box, designs // 4) + ALL),
        "slider-cranks, one by one": (SLIDER, varied(slider, max(designs // 400, 1000)) + FEW),
    }


def rate(command, file, folder):
    """Designs per second, and the best rows, by which runs are compared."""
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    done = subprocess.run(
        [*command, str(file), "--json", "--quiet", "--out", str(out)],
        capture_output=True,
        env=ROOT,
        check=True,
    )
    document = json.loads(done.stdout)
    return document["work"]["designs_per_second"], document["best"]


def start_up(command, repeat):
    best = float("inf")
    for _ in range(repeat):
        begun = time.perf_counter()
        subprocess.run(command, capture_output=True, env=ROOT, check=False)
        best = min(best, time.perf_counter() - begun)
    return best


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--designs", type=int, default=4_000_000)
    parser.add_argument("--repeat", type=int, default=3)
    asked = parser.parse_args()
    ways = {
        "1 thread": [asked.program, "sweep", "--threads", "1"],
        "2 threads": [asked.program, "sweep", "--threads", "2"],
        "mpirun -n 2": ["mpirun", "--oversubscribe", "-n", "2", asked.program, "sweep"],
    }
    if shutil.which("mpirun") is None:
        del ways["mpirun -n 2"]
    print(f"{'designs per second':28}" + "".join(f"{way:>14}" for way in ways) + f"{'ratios':>16}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, (base, study) in studies(asked.designs).items():
            (folder / "base.toml").write_text(base)
            (folder / "study.toml").write_text('base = "base.toml"\n' + study)
            best = dict.fromkeys(ways, 0.0)
            found = []
            for _ in range(asked.repeat):
                for way, command in ways.items():
                    figure, rows = rate(command, folder / "study.toml", folder)
                    best[way] = max(best[way], figure)
                    found.append(rows)
            if any(rows != found[0] for rows in found):
                sys.exit(f"{title}: not all ways found the same rows")
            rates = list(best.values())
            ratios = "  ".join(f"{figure / rates[0]:.2f}" for figure in rates[1:])
            print(f"{title:28}" + "".join(f"{figure:14,.0f}" for figure in rates) + f"{ratios:>16}")
    with_mpi = str(pathlib.Path(asked.program).resolve().with_name("cognate-mpi"))
    print(f"\nstart-up: {1e3 * start_up([asked.program, '--version'], 10):.1f} ms")
    if shutil.which(with_mpi):
        print(f"start-up of cognate-mpi: {1e3 * start_up([with_mpi, '--version'], 5):.1f} ms")


if __name__ == "__main__":
    main()
