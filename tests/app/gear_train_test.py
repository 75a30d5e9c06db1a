"""Gear trains from outside: every worked file, its document and page, studies, what is refused.

Run as: gear_train_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems and
the JSON schema of results.
"""

import fractions
import json
import os
import pathlib
import sqlite3
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

STUDY = """
kind = "study"
base = "{base}"
[[vary]]
key = "mesh[0].efficiency"
values = [0.9, 0.95, 1]
[output]
metrics = ["ratio", "efficiency", "members.ring.torque_N_m", "self_locking"]
"""


class GearTrains(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_it(self, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, text=True, timeout=240,
                              capture_output=True, check=False)

    def document_of(self, file, command="solve", status=0):
        done = self.run_it(command, file, "--json")
        self.assertEqual(done.returncode, status, done.stderr)
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        return document

    def test_every_train_of_the_library(self):
        listed = json.loads(self.run_it("list", "--metrics", "--json").stdout)
        keys = {part: {key for metric in listed[part] for key in metric["key"].split(", ")}
                for part in ("gear_train_metrics", "gear_train_member_metrics")}
        known = keys["gear_train_metrics"] | {"class", "members", "meshes", "defects", "time_ratio",
                                              "transmission_angle_deg"}
        files = sorted((LIBRARY / "gear-train").glob("*.toml"))
        self.assertGreaterEqual(len(files), 9)
        for file in files:
            with self.subTest(file.name):
                document = self.document_of(file)
                self.assertEqual(document["status"], "solved")
                for design in document["designs"]:
                    metrics = design["metrics"]
                    self.assertLessEqual(metrics.keys(), known)
                    for member in metrics["members"].values():
                        self.assertLessEqual(member.keys() - {"role", "speed_exact"},
                                             keys["gear_train_member_metrics"])
                    if "ratio" in metrics:
                        exact = fractions.Fraction(metrics["ratio_exact"])
                        self.assertAlmostEqual(metrics["ratio"] / float(exact), 1, places=14)

    def test_power_that_enters_leaves_or_is_lost(self):
        for name in ("planetary", "clock", "differential", "ten-thousand-to-one", "simpson"):
            for design in self.document_of(LIBRARY / "gear-train" / f"{name}.toml")["designs"]:
                metrics = design["metrics"]
                total = sum(member.get("power_W", 0) for member in metrics["members"].values())
                with self.subTest(name):
                    self.assertAlmostEqual(total, metrics["loss_W"], delta=1e-9 * metrics["power_W"])

    def test_the_page_holds_the_train(self):
        done = self.run_it("analyze", LIBRARY / "gear-train" / "simpson.toml")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("2.45161", done.stdout)
        page = (self.folder / "simpson.report.html").read_text(encoding="utf-8")
        self.assertIn("rear carrier", page)
        self.assertLess(len(page), 1.5e6)

    def test_a_study_varies_an_efficiency(self):
        (self.folder / "base.toml").write_text((LIBRARY / "gear-train" / "planetary.toml").read_text())
        (self.folder / "study.toml").write_text(STUDY.format(base="base.toml"))
        done = self.run_it("sweep", "study.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        with sqlite3.connect(self.folder / "study.study.db") as database:
            rows = database.execute('select * from runs order by "mesh[0].efficiency"')
            names = [column[0] for column in rows.description]
            rows = [dict(zip(names, row)) for row in rows]
        self.assertEqual(len(rows), 3)
        for row, loss in zip(rows, (0.9, 0.95, 1)):
            self.assertAlmostEqual(row["efficiency"], (1 + 3.5 * 0.99 * loss) / 4.5, places=12)
            self.assertEqual(row["ratio"], 4.5)

    def test_what_is_refused(self):
        search = LIBRARY / "gear-train" / "prime-ratio.toml"
        done = self.run_it("analyze", search)
        self.assertEqual(done.returncode, 2)
        self.assertIn("expected 'cognate solve'", done.stderr)
        self.run_it("solve", LIBRARY / "gear-train" / "planetary.toml")
        done = self.run_it("export", "planetary.result.json", "--format", "dxf")
        self.assertEqual(done.returncode, 2)
        self.assertIn("planetary.result.json: the gears of a gear-train have numbers of teeth and no outline", done.stderr)

    def test_the_nearest_ratio_is_reported(self):
        (self.folder / "far.toml").write_text('kind = "gear-train"\n[target]\nratio = 100\n'
                                              "[bounds]\nteeth = [20, 40]\npairs = [1, 2]\n")
        document = self.document_of("far.toml", status=1)
        self.assertEqual(document["status"], "infeasible")
        self.assertEqual(document["designs"][0]["metrics"]["ratio"], 4)
        self.assertIn("nearest", document["notes"][0])


if __name__ == "__main__":
    PROGRAM, LIBRARY, SCHEMA = os.path.abspath(sys.argv[1]), *map(
        lambda name: pathlib.Path(name).resolve(), sys.argv[2:4]
    )
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
