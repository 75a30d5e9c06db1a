"""Columns of a study with changed bytes: a command gives the answer of the whole file, or says in a line what is wrong.

Run as: damaged_columns.py PROGRAM [--count N] [--seed N] [--keep DIR]

Writes a study as columns, once by the program and once by h5py in HDF5's oldest format, whose headers have no checksums; flips
bits, sets bytes to extremes, exchanges, cuts and doubles pieces of the files, and exports a row of each or merges it. It is a fault
if a command ends by a signal, or takes a minute, or prints more than one line on standard error, or gives another answer. Prints
the counts, and the signals, which are HDF5's own where a file is of the oldest format; ends with status 1 if there was a fault.
"""

import argparse
import collections
import pathlib
import random
import shutil
import sqlite3
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "app"))
import columns_by_hand as by_hand  # noqa: E402

SLIDER = 'kind = "analysis"\n[mechanism]\ntype = "slider-crank"\npivot = [0, 0]\ncrank = 1\ncoupler = 3\noffset = 0.25\n'
STUDY = """base = "slider.toml"
[[vary]]
key = "mechanism.coupler"
range = [0.5, 5.5]
steps = 40
[output]
rows = "all"
metrics = ["class", "output_stroke", "time_ratio"]
[objective]
maximize = ["output_stroke", "time_ratio"]
"""


def damaged(rng, valid):
    data = bytearray(valid)
    change = rng.randrange(8)
    if change < 5:
        for _ in range(rng.choice([1, 1, 1, 2, 4, 16])):
            data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    elif change == 5:
        at = rng.randrange(len(data))
        size = rng.choice([1, 2, 4, 8])
        data[at : at + size] = bytes([rng.choice([0, 1, 0x7F, 0x80, 0xFF])]) * size
    elif change == 6:
        here, there, size = rng.randrange(len(data)), rng.randrange(len(data)), rng.choice([8, 64, 512])
        data[here : here + size] = data[there : there + size]
    else:
        del data[rng.randrange(len(data)) :]
    return bytes(data)


class Runner:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.counts = collections.Counter()

    def run(self, *arguments):
        """What ended; with status 256 where it took too long."""
        try:
            return subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, capture_output=True, timeout=60)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(arguments, 256, b"", b"")

    def answer(self, file, merges):
        """The status, the message, and what was written."""
        shutil.rmtree(self.folder / "new", ignore_errors=True)
        command = ["sweep", "study.toml", "--merge", file] if merges else ["export", file, "--row", 17]
        done = self.run(*command, "--json", "--out", "new")
        written = None
        if done.returncode == 0 and merges:
            with sqlite3.connect(self.folder / "new/study.study.db") as database:
                written = [database.execute(f"SELECT * FROM {table}").fetchall() for table in ("runs", "best", "blocks")]
            database.close()
        elif done.returncode == 0:
            written = [file.read_bytes() for file in (self.folder / "new").iterdir()]
        return done.returncode, done.stderr.decode(errors="replace"), written

    def fault_of(self, file, merges, right):
        status, message, written = self.answer(file, merges)
        self.counts[("merge" if merges else "export") + f" {status}"] += 1
        if status == 0:
            return "" if written == right[merges] else "another answer"
        if status != 2:
            return f"status {status}: {message[:500]}"
        return "" if message.count("\n") == 1 and file.name in message else f"unclear message: {message[:500]}"


def prepared(runner):
    """The two files, and the right answers."""
    (runner.folder / "slider.toml").write_text(SLIDER)
    (runner.folder / "study.toml").write_text(STUDY)
    runner.run("sweep", "study.toml", "--format", "hdf5", "--json").check_returncode()
    by_hand.write_by_hand(runner.folder / "hand.study.h5", by_hand.tables_of(runner.folder / "study.study.db"))
    files = [runner.folder / name for name in ("study.study.h5", "hand.study.h5")]
    right = [runner.answer(files[0], merges) for merges in (False, True)]
    assert all(status == 0 for status, *_ in right), right
    return [file.read_bytes() for file in files], [written for *_, written in right]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files that show faults")
    given = parser.parse_args()
    rng = random.Random(given.seed)
    faults = 0
    with tempfile.TemporaryDirectory() as name:
        runner = Runner(pathlib.Path(given.program).absolute(), pathlib.Path(name))
        valid, right = prepared(runner)
        bad = runner.folder / "bad.study.h5"
        for number in range(given.count):
            of_old_format = number % 2 == 1
            bad.write_bytes(damaged(rng, valid[of_old_format]))
            fault = runner.fault_of(bad, rng.random() < 0.3, right)
            if not fault:
                continue
            faults += 1
            print(f"{number}{' (oldest format)' if of_old_format else ''}: {fault}", flush=True)
            if given.keep:
                given.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(bad, given.keep / f"{number}.study.h5")
    for what, count in sorted(runner.counts.items()):
        print(f"{what}: {count}")
    print(f"{given.count} files, {faults} faults")
    return 1 if faults or not given.count else 0


if __name__ == "__main__":
    sys.exit(main())
