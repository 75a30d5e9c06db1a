"""Many programs, one study file: one runs, the others are refused, and the rows are those of one.

Run as: concurrent_studies_test.py PROGRAM
"""

import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""

BASE = """kind = "analysis"
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = 1
coupler = 3
offset = 0.25
[drive]
speed = 1
steps = 36
[output]
position = true
"""

STUDY = """kind = "study"
base = "base.toml"
[[vary]]
key = "mechanism.coupler"
range = [2, 5]
sampling = "sobol"
count = {count}
[[vary]]
key = "mechanism.offset"
range = [0, 0.5]
sampling = "sobol"
count = {count}
[output]
metrics = ["output_stroke", "time_ratio"]
[objective]
maximize = ["output_stroke", "time_ratio"]
"""


class ConcurrentStudies(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "base.toml").write_text(BASE)
        (self.folder / "other").mkdir()
        (self.folder / "other/base.toml").write_text(BASE)

    def start(self, file, out):
        return subprocess.Popen(
            [PROGRAM, "sweep", file, "--out", out, "--threads", "1", "--quiet"],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def tables(self, file):
        database = sqlite3.connect(self.folder / file)
        try:
            return [database.execute(f"SELECT * FROM {table} ORDER BY 1").fetchall()
                    for table in ("runs", "front", "study")]
        finally:
            database.close()

    def ended(self, running):
        """The exit statuses; those refused say why."""
        statuses = []
        for process in running:
            _, errors = process.communicate(timeout=300)
            statuses.append(process.returncode)
            self.assertIn(process.returncode, (0, 2), errors)
            if process.returncode == 2:
                self.assertRegex(errors, r"(another process|process \d+ on .*) is running this study"
                                         r"|begun with other input")
        return statuses

    def test_started_at_once(self):
        study = self.folder / "study.toml"
        study.write_text(STUDY.format(count=1500))
        self.ended([self.start("study.toml", "alone")])
        whole = self.tables("alone/study.study.db")
        self.assertEqual(len(whole[0]), 1500)
        ended = 0
        for number in range(2):
            out = f"shared-{number}"
            (self.folder / out).mkdir()
            (self.folder / f"link-{number}").symlink_to(out)
            statuses = self.ended([self.start("study.toml", f"{'shared' if k % 2 else 'link'}-{number}")
                                   for k in range(6)])
            self.assertIn(0, statuses)
            ended += len(statuses)
            self.assertEqual(self.tables(f"{out}/study.study.db"), whole)
            self.assertEqual(list((self.folder / out).glob("*.lock")), [])
        self.assertEqual(ended, 12)

    def test_two_studies_of_one_name(self):
        (self.folder / "study.toml").write_text(STUDY.format(count=900))
        (self.folder / "other/study.toml").write_text(STUDY.format(count=600))
        for number in range(2):
            out = f"shared-{number}"
            statuses = self.ended([self.start(file, out) for file in ("study.toml", "other/study.toml")])
            self.assertEqual(sorted(statuses), [0, 2])
            rows = self.tables(f"{out}/study.study.db")[0]
            self.assertEqual(len(rows), 900 if statuses[0] == 0 else 600)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
