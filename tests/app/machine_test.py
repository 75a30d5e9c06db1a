"""Machines from outside: the library's files, what they are known to do, studies, exports.

Run as: machine_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems and
the JSON schema of results.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

# Torque 10 - 2 w at an inertia of 3: after t seconds w is 5 (1 - exp(-2 t/3)).
RUN_UP = """
kind = "machine"
[equivalent]
inertia = 3
[motor]
line = {stall_torque = 10, no_load_speed = 5}
[run]
tasks = ["start", "steady", "stop"]
speed_end = 4
[brake]
torque = 6
"""


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          check=False, **options)


def metrics_of(document):
    (design,) = document["designs"]
    return design["metrics"]


class Machine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="written.toml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def analyze(self, file, status=0):
        done = run("analyze", file, "--json")
        self.assertEqual((done.returncode, done.stderr), (status, ""))
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        return document

    def test_every_machine_of_the_library(self):
        files = sorted((LIBRARY / "machine").glob("*.toml"))
        self.assertGreaterEqual(len(files), 8)
        for file in files:
            with self.subTest(file.name):
                document = self.analyze(file, 1 if file.stem == "stall" else 0)
                motions = document["machine"]["motions"]
                self.assertEqual([motion["task"] for motion in motions],
                                 [] if file.stem == "stall" else document["problem"]["run"]["tasks"])
                for motion in motions:
                    names = [column["name"] for column in motion["columns"]]
                    self.assertEqual(names[:3], ["time_s", "crank_deg", "speed_rad_s"])
                    times = motion["columns"][0]["values"]
                    self.assertEqual(times, sorted(times))
                    self.assertEqual({len(c["values"]) for c in motion["columns"]}, {len(times)})

    def test_published_machines(self):
        """Li & Xu 2011, examples 6-2 to 6-5, integrated without the book's steps of 15 degrees."""
        for name, key, value, digits in [
                ("motor-line-table-loads", "fluctuation", 0.15364081857184053, 7),
                ("motor-line-table-loads", "speed_min_at_deg", 337.5, 1),
                ("flywheel-of-table-loads", "fluctuation", 0.05, 8),
                ("run-up", "speed_mean_rad_s", 25400 / 264, 9),
                ("run-up", "start_time_s", 0.2317103319042227, 8),
                ("run-up", "start_turns", 18.65697890290627 / 6.283185307179586, 7)]:
            with self.subTest(name=name, key=key):
                metrics = metrics_of(self.analyze(LIBRARY / "machine" / f"{name}.toml"))
                self.assertAlmostEqual(metrics[key], value, digits)

    def test_the_book_s_flywheel(self):
        text = (LIBRARY / "machine" / "flywheel-of-table-loads.toml").read_text()
        document = self.analyze(self.write(text.replace("fluctuation = 0.05", "inertia = 587.92849")))
        self.assertAlmostEqual(metrics_of(document)["fluctuation"], 0.053070380911850124, 6)

    def test_a_run_up_in_closed_form(self):
        document = self.analyze(self.write(RUN_UP))
        metrics = metrics_of(document)
        self.assertAlmostEqual(metrics["start_time_s"], 1.5 * 1.6094379124341003, 8)
        self.assertAlmostEqual(metrics["speed_mean_rad_s"], 5, 9)
        self.assertAlmostEqual(metrics["stop_time_s"], 5 * 3 / 6, 8)

    def test_files_that_are_written(self):
        done = run("analyze", self.write(RUN_UP), "--out", self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("speed_mean_rad_s", done.stdout)
        self.assertIn("</html>", (self.folder / "written.report.html").read_text())
        with open(self.folder / "written.csv", newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file, strict=True)
        self.assertEqual(header[:4], ["task", "time_s", "crank_deg", "speed_rad_s"])
        self.assertEqual({row[0] for row in rows}, {"start", "steady", "stop"})
        document = json.loads((self.folder / "written.result.json").read_text())
        count = sum(len(motion["columns"][0]["values"]) for motion in document["machine"]["motions"])
        self.assertEqual(len(rows), count)

    def test_a_machine_that_stalls_says_so(self):
        document = self.analyze(LIBRARY / "machine" / "stall.toml", 1)
        self.assertEqual(document["status"], "no-solution")
        self.assertIn("stalls", document["notes"][0])

    def test_check_and_solve(self):
        file = LIBRARY / "machine" / "press.toml"
        done = run("check", file)
        self.assertEqual(done.returncode, 0)
        self.assertIn("machine of slider-crank with a motor", done.stdout)
        done = run("solve", file)
        self.assertEqual(done.returncode, 2)
        self.assertIn("'cognate analyze' runs this machine", done.stderr)

    def test_a_study_varies_a_machine(self):
        self.write(RUN_UP, "base.toml")
        study = self.write('base = "base.toml"\n[output]\nmetrics = ["speed_mean_rad_s", '
                           '"start_time_s"]\n[[vary]]\nkey = "equivalent.inertia"\nvalues = [3, 6]\n'
                           '[objective]\nminimize = "start_time_s"\n', "study.toml")
        done = run("sweep", study, "--out", self.folder, "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        best = json.loads(done.stdout)["best"][0]
        self.assertEqual(best["equivalent.inertia"], 3)
        self.assertAlmostEqual(best["start_time_s"], 1.5 * 1.6094379124341003, 8)

    def test_exports(self):
        run("analyze", LIBRARY / "machine" / "press.toml", "--out", self.folder, "--quiet")
        done = run("export", self.folder / "press.result.json", "--format", "svg", "--out", self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("</svg>", (self.folder / "press.svg").read_text())
        run("analyze", self.write(RUN_UP), "--out", self.folder, "--quiet")
        done = run("export", self.folder / "written.result.json", "--format", "svg")
        self.assertEqual(done.returncode, 2)
        self.assertIn("expected one with a [mechanism]", done.stderr)
        done = run("export", LIBRARY / "machine" / "press.toml", "--format", "svg")
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"'cognate analyze {LIBRARY / 'machine' / 'press.toml'}' writes one", done.stderr)
        done = run("export", LIBRARY / "function" / "logarithm-small-flywheel.toml", "--format", "svg")
        self.assertIn("'cognate solve", done.stderr)

    def test_lengths_are_metres_beside_inertias(self):
        done = run("solve", LIBRARY / "function" / "logarithm-small-flywheel.toml", "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[kg m²]", done.stdout)
        self.assertIn("[m]", done.stdout)
        self.assertNotIn("[length]", done.stdout)

    def test_a_table_holds_every_motion_column_by_column(self):
        run("analyze", self.write(RUN_UP), "--out", self.folder, "--quiet")
        document = json.loads((self.folder / "written.result.json").read_text())
        with open(self.folder / "written.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file, strict=True))
        for motion in document["machine"]["motions"]:
            own = [row for row in rows if row["task"] == motion["task"]]
            for column in motion["columns"]:
                for row, value in zip(own, column["values"], strict=True):
                    self.assertAlmostEqual(float(row[column["name"]]), value, delta=1e-9 * (1 + abs(value)))


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    LIBRARY = pathlib.Path(sys.argv[2]).resolve()
    SCHEMA = pathlib.Path(sys.argv[3]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
