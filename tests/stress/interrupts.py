"""A signal at any moment ends a long command soon, with what was found until then.

Run as: interrupts.py PROGRAM LIBRARY [--count N] [--seed N] [--allowed SECONDS] [--only NAME]

Starts a long search, one with limits, a proof that a design is the best, the front of several
objectives, the exact synthesis of nine points, a study, an analysis and exports; sends SIGINT, SIGTERM or SIGHUP
after a random share of processor time, and looks at what is left: a result that says that it was
interrupted, a study that goes on with every row it had, an export that is there whole or not at all,
and no draft of a file. Prints the processor time that each took after the signal; with --allowed,
more than that is a fault.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
HANG = 120  # seconds after which a command is taken to go on for ever

SEARCH = """kind = "path-generation"
[target]
points = [[0, 0], [1, 0.3], [2, 0.1], [2.5, 1], [1.8, 1.7], [1.1, 1.2], [0.2, 1.6], [-0.6, 0.9]]
[bounds]
length = [0.05, 60]
{limits}
[solve]
starts = 100000
{solve}
"""
LIMITS = '[constraints]\nclass = "crank-rocker"\ntransmission_angle_deg = [40, 140]\n'
FRONT = 'objectives = ["error", "size"]\n'

STUDY = """kind = "study"
base = "base.toml"
[[vary]]
key = "mechanism.coupler"
range = [2, 5]
sampling = "sobol"
count = 4000000
[[vary]]
key = "mechanism.offset"
range = [0, 0.5]
sampling = "sobol"
count = 4000000
[output]
metrics = ["output_stroke", "time_ratio"]
[objective]
maximize = ["output_stroke", "time_ratio"]
"""

BASE = """kind = "analysis"
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = 1
coupler = 3
offset = 0.25
[drive]
speed = 1
steps = {steps}
[output]
position = true
velocity = true
"""


def cases(library, folder):
    """Name, arguments, and the processor seconds before which the signal is sent."""
    texts = {
        "search": SEARCH.format(limits="", solve=""),
        "limited": SEARCH.format(limits=LIMITS, solve=""),
        "front": SEARCH.format(limits="", solve=FRONT),
        "certificate": (library / "path/eighteen-points.toml").read_text() + "certify = true\n"
        if "[solve]" in (library / "path/eighteen-points.toml").read_text()
        else (library / "path/eighteen-points.toml").read_text() + "\n[solve]\ncertify = true\n",
        "nine-points": (library / "path/nine-points-3.toml").read_text(),
        "study": STUDY,
        "base": BASE.format(steps=36),
        "table": BASE.format(steps=100000),
    }
    for name, text in texts.items():
        (folder / f"{name}.toml").write_text(text)
    solves = ["search", "limited", "front", "certificate", "nine-points"]
    return (
        [(name, ["solve", f"{name}.toml"], 1.5) for name in solves]
        + [("study", ["sweep", "study.toml"], 1.5), ("table", ["analyze", "table.toml"], 1.0)]
        + [("export", ["export", "base.result.json", "--format", "csv", "--steps", "100000"], 0.3)]
    )


def processor_time(process):
    """Seconds that a process has used; None where it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    except (FileNotFoundError, ProcessLookupError):
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Tester:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.faults = []
        self.counts = collections.Counter()
        self.longest = collections.defaultdict(float)
        # A start set kept by one run would leave the next less to do.
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(folder / "cache"))

    def fault(self, name, what):
        self.faults.append(f"{name}: {what}")
        print(self.faults[-1], flush=True)

    def start(self, arguments):
        # A program started in the background by a shell may ignore SIGINT.
        return subprocess.Popen(
            [self.program, *arguments, "--threads", "1", "--out", "out"], cwd=self.folder, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=self.environment,
            preexec_fn=lambda: [signal.signal(each, signal.SIG_DFL) for each in SIGNALS],
        )

    def interrupt(self, name, arguments, after, sent):
        """Sends a signal after so much processor time and looks at what is left."""
        shutil.rmtree(self.folder / "cache", ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        process = self.start(arguments)
        used = processor_time(process)
        while process.poll() is None and used is not None and used < after:
            time.sleep(0.005)
            used = processor_time(process)
        interrupted = process.poll() is None
        if interrupted:
            process.send_signal(sent)
        try:
            _, errors = process.communicate(timeout=HANG)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return self.fault(name, f"still running {HANG} s after {sent.name}")
        ended = resource.getrusage(resource.RUSAGE_CHILDREN)
        if interrupted:
            total = ended.ru_utime + ended.ru_stime - before.ru_utime - before.ru_stime
            self.longest[name] = max(self.longest[name], total - (used or 0))
            self.counts[name] += 1
        self.look(name, arguments[0], process.returncode, sent, errors)
        return None

    def look(self, name, command, status, sent, errors):
        out = self.folder / "out"
        left = list(out.glob(".cognate-*")) if out.exists() else []
        if left:
            self.fault(name, f"{len(left)} drafts are left")
        if command == "export":
            if status not in (0, -sent):
                self.fault(name, f"status {status}: {errors}")
            for file in out.glob("*.csv"):
                if file.read_text().count("\n") != 100002:
                    self.fault(name, f"a part of {file.name}")
        elif status == -sent:  # before it listened
            if out.exists() and any(out.iterdir()):
                self.fault(name, f"{sent.name} ended it with files written")
        elif status not in (0, 1):
            self.fault(name, f"status {status}: {errors}")
        elif command == "sweep":
            self.goes_on(name)
        else:
            self.result(name, errors)
        shutil.rmtree(out, ignore_errors=True)

    def result(self, name, errors):
        for ending in (".result.json", ".report.html"):
            if not (self.folder / "out" / (name + ending)).exists():
                return self.fault(name, f"no {name}{ending}: {errors}")
        document = json.loads((self.folder / "out" / f"{name}.result.json").read_text())
        self.counts[f"{name} {document['status']}"] += 1
        return None

    def goes_on(self, name):
        """Rows of an interrupted study are all there after the next run."""
        rows = self.rows(name)
        again = subprocess.run(
            [self.program, "sweep", f"{name}.toml", "--threads", "1", "--out", "out", "--time-limit", "0.2"],
            cwd=self.folder, capture_output=True, text=True, timeout=HANG)
        if again.returncode not in (0, 1):
            self.fault(name, f"does not go on: {again.stderr}")
        now = self.rows(name)
        if {row[0]: row for row in now if row[0] in {row[0] for row in rows}} != {row[0]: row for row in rows}:
            self.fault(name, "rows are lost")
        self.counts[f"{name} rows"] += len(rows)

    def rows(self, name):
        database = sqlite3.connect(self.folder / "out" / f"{name}.study.db")
        try:
            return database.execute("SELECT * FROM runs ORDER BY id").fetchall()
        finally:
            database.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=30, help="signals sent to each command")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--allowed", type=float, help="processor seconds after the signal")
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    rng = random.Random(given.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tester = Tester(os.path.abspath(given.program), folder)
        chosen = [case for case in cases(given.library, folder) if given.only in case[0]]
        subprocess.run([tester.program, "analyze", "base.toml", "--quiet"], cwd=folder, check=True)
        for case, arguments, span in chosen:
            for number in range(given.count):
                tester.interrupt(case, arguments, span * rng.random(), SIGNALS[number % len(SIGNALS)])
            took = tester.longest[case]
            print(f"{case}: {tester.counts[case]} of {given.count} interrupted, at most {took:.2f} s of "
                  "processor time after the signal", flush=True)
            if given.allowed is not None and took > given.allowed:
                tester.fault(case, f"took more than {given.allowed} s")
            if tester.counts[case] == 0 and case not in ("export", "table"):
                tester.fault(case, "was over before every signal")
    print(dict(tester.counts))
    return 1 if tester.faults else 0


if __name__ == "__main__":
    sys.exit(main())
