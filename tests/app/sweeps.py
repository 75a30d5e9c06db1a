"""Studies for the tests of `cognate sweep`: a base file, studies of it, and how they are run."""

import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = sys.argv[1]

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
steps = 36
[output]
position = true
"""

SMALL = """
base = "slider.toml"
[[vary]]
key = "mechanism.coupler"
range = [0.5, 5.5]
steps = 21
[[vary]]
key = "mechanism.offset"
values = [0, 0.25, 0.5]
[output]
metrics = ["class", "output_stroke", "time_ratio"]
[filter]
"transmission_angle_deg.acute_min" = { min = 30 }
[objective]
maximize = "output_stroke"
"""

# Analysed one by one for longer than any test lasts.
LONG = """
base = "slider.toml"
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
metrics = ["output_stroke"]
"""


class Sweeps(unittest.TestCase):
    """A folder with a base file and studies of it."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "slider.toml").write_text(SLIDER)
        (self.folder / "small.toml").write_text(SMALL)
        (self.folder / "long.toml").write_text(LONG)

    def run_program(self, *arguments, **options):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=120,
            **options,
        )

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )

    def rows(self, file, table="runs ORDER BY id"):
        with sqlite3.connect(self.folder / file) as database:
            return database.execute(f"SELECT * FROM {table}").fetchall()

    def wait_for_rows(self, file):
        """Queries the study file while the study runs, until there are rows."""
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            try:
                if (self.folder / file).exists() and self.rows(file, "runs LIMIT 1"):
                    return
            except sqlite3.OperationalError:
                pass  # its tables are not there yet
            time.sleep(0.02)
        self.fail("no rows within a minute")

    def expect_refusal(self, done, *parts):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
