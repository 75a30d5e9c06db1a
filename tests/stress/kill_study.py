"""A study that is killed again and again ends with the rows of one that never was.

Run as: kill_study.py PROGRAM [--kills N] [--mpi PROCESSES] [--seed N]

Each run of the study is ended by SIGKILL at a random moment, and the next goes on: with --mpi one
process of several, chosen at random, of `mpirun`. After every kill the study file is read as it was
left: every row that it held before is there still, unchanged, and its blocks account for all rows.
When it has ended its tables are compared with those of an uninterrupted run; it is begun again while
there are kills left.
"""

import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

BASE = """
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
[output]
position = true
"""

STUDY = """
kind = "study"
title = "Killed again and again"
base = "base.toml"
[[vary]]
key = "mechanism.coupler"
range = [1.5, 6]
sampling = "sobol"
count = {count}
[[vary]]
key = "mechanism.offset"
range = [0, 1.5]
sampling = "sobol"
count = {count}
[output]
metrics = ["class", "transmission_angle_deg.acute_min", "time_ratio", "output_stroke"]
[filter]
"transmission_angle_deg.acute_min" = {{ min = 10 }}
[objective]
maximize = ["transmission_angle_deg.acute_min", "time_ratio"]
"""

# MPI keeps some memory to its end, which a sanitized program would count as leaked.
ROOT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    ASAN_OPTIONS="detect_leaks=0",
)


class Killer:
    def __init__(self, program, processes, folder, seed):
        self.command = [program, "sweep", str(folder / "killed.toml"), "--quiet", "--out"]
        if processes > 1:
            self.command = ["mpirun", "--oversubscribe", "-n", str(processes)] + self.command
        self.processes = processes
        self.folder = folder
        self.random = random.Random(seed)
        self.rows = {}
        self.growths = 0  # how many killed runs added rows

    def run(self, out):
        """One run that is left alone."""
        subprocess.run(
            self.command + [str(self.folder / out)],
            env=ROOT,
            check=True,
            stdout=subprocess.DEVNULL,
        )

    def seconds_to_start(self):
        """How long a run takes that finds nothing left to do."""
        (self.folder / "killed.toml").write_text(STUDY.format(count=1))
        self.run("start")
        begun = time.monotonic()
        self.run("start")
        return time.monotonic() - begun

    def victims(self, process):
        """The process, or those that mpirun has started by now."""
        if self.processes == 1:
            return [process.pid]
        try:
            children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
        except OSError:
            return []
        return [int(child) for child in children.split()]

    def kill_once(self, delay):
        """Whether the run was killed before it ended by itself."""
        process = subprocess.Popen(
            self.command + [str(self.folder / "killed")],
            env=ROOT,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        time.sleep(delay)
        victims = self.victims(process)
        killed = process.poll() is None and bool(victims)
        if killed:
            try:
                os.kill(self.random.choice(victims), signal.SIGKILL)
            except ProcessLookupError:
                killed = False
        self.wait(process)
        return killed and process.returncode != 0

    def wait(self, process):
        """Until the process ends. An mpirun one of whose processes is killed while it starts them may
        wait for ever, though all of them have ended: it is killed too."""
        try:
            process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            states = [pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
                      for pid in self.victims(process)]
            assert self.processes > 1 and set(states) <= {"Z"}, f"the study hangs: {states}"
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()

    def compare(self):
        """The study has ended: its tables against those of the uninterrupted run."""
        killed, whole = (tables(self.folder / out / "killed.study.db") for out in ("killed", "whole"))
        assert killed == whole, "the tables differ"

    def begin_again(self):
        shutil.rmtree(self.folder / "killed")
        self.rows = {}

    def check(self):
        """The file as it was left: read in a copy, so that nobody repairs it for the program."""
        with tempfile.TemporaryDirectory() as copy:
            for part in (self.folder / "killed").glob("killed.study.db*"):
                shutil.copy(part, copy)
            if not (pathlib.Path(copy) / "killed.study.db").exists():
                return
            with sqlite3.connect(pathlib.Path(copy) / "killed.study.db") as database:
                if not database.execute("SELECT 1 FROM sqlite_master WHERE name = 'runs'").fetchone():
                    assert not self.rows, "the tables are gone"
                    return
                rows = {row[0]: row[1:] for row in database.execute("SELECT * FROM runs")}
                blocks = database.execute("SELECT first, count, kept FROM blocks ORDER BY first").fetchall()
        lost = [row for row in self.rows.items() if rows.get(row[0]) != row[1]]
        assert not lost, f"lost or changed: {lost[:3]}"
        assert sum(kept for _, _, kept in blocks) == len(rows), "blocks do not account for the rows"
        for (first, count, _), (following, _, _) in zip(blocks, blocks[1:]):
            assert first + count <= following, "a design was evaluated twice"
        self.growths += len(rows) > len(self.rows)
        self.rows = rows


def tables(file):
    with sqlite3.connect(file) as database:
        return [
            database.execute(f"SELECT * FROM {table}").fetchall()
            for table in ("runs ORDER BY id", "best", "study ORDER BY name", "front ORDER BY id")
        ]


def designs_per_second(program, folder):
    """By a short study of its own."""
    (folder / "trial.toml").write_text(STUDY.format(count=2048))
    trial = subprocess.run(
        [program, "sweep", str(folder / "trial.toml"), "--json", "--out", str(folder / "trial")],
        check=True,
        capture_output=True,
    )
    return json.loads(trial.stdout)["work"]["designs_per_second"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--mpi", type=int, default=1, metavar="PROCESSES")
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    if asked.mpi > 1 and shutil.which("mpirun") is None:
        print("mpirun is not there")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "base.toml").write_text(BASE)
        rate = designs_per_second(asked.program, folder)
        # Enough for all kills to find it at work: rows are committed every half second.
        count = int(rate * 0.4 * (asked.kills + 2))
        killer = Killer(asked.program, asked.mpi, folder, asked.seed)
        start = killer.seconds_to_start()
        (folder / "killed.toml").write_text(STUDY.format(count=count))
        killer.run("whole")
        kills = runs = ended = 0
        while kills < asked.kills:
            runs += 1
            if killer.kill_once(start * 0.5 + killer.random.uniform(0, start * 0.5 + 0.9)):
                kills += 1
                killer.check()
                if kills % 20 == 0:
                    print(f"{kills} kills, {len(killer.rows)} rows", file=sys.stderr, flush=True)
            else:
                ended += 1
                killer.compare()
                killer.begin_again()
        killer.run("killed")
        killer.compare()
        print(
            f"{kills} kills in {runs} runs of {count} designs, which ended {ended + 1} times: no row "
            f"lost, none twice; {killer.growths} killed runs added rows; all tables are those of an "
            "uninterrupted run"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
