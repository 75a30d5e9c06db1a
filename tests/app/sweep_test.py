"""Studies from outside: rows, documents, reports, and what is refused.

Run as: sweep_test.py PROGRAM SCHEMA, the built program and the JSON schema of summaries.
"""

import cmath
import json
import math
import os
import pathlib
import re
import sqlite3
import sys
import unittest

from sweeps import SLIDER, SMALL, Sweeps

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMA = pathlib.Path()

ATLAS_BASE = """
kind = "analysis"
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [3, 0]]
crank = 1
coupler = 3
rocker = 2.5
coupler_point = [1, 1]
[output]
curve = true
"""

HARMONICS = ["m4", "m3", "m2", "m1", "p1", "p2", "p3", "p4"]
DESCRIPTORS = [f"fourier.{name}" for name in HARMONICS] + [
    f"fourier_phase_deg.{name}" for name in HARMONICS if name[1] != "1"
]

ATLAS = """
base = "four-bar.toml"
[[vary]]
key = "mechanism.coupler_point[0]"
values = [0.5, 1.5, 2.5]
[[vary]]
key = "mechanism.coupler_point[1]"
values = [-1, 0.5, 2]
[output]
metrics = {metrics}
"""

CLOSED = """kind = "path-generation"
[target]
curve = {curve}
[bounds]
length = [0.1, 50]
[solve]
starts = 1
atlas = "atlas.study.db"
"""

# MPI keeps some memory to its end, which a sanitized program would count as leaked.


def refuse_constant(name):
    raise AssertionError(f"{name} is no JSON")


def planted_curve():
    """Of the linkage of ATLAS with its point at (1.5, 2), twice as large and turned by 90 degrees."""
    points = []
    for step in range(72):
        b = cmath.rect(1, step * math.pi / 36)
        to_d = 3 - b
        # The triangle B, C, D of coupler 3 and rocker 2.5; C left of B–D is the open assembly.
        angle = math.acos((9 + abs(to_d) ** 2 - 2.5**2) / (6 * abs(to_d)))
        coupler = to_d / abs(to_d) * cmath.exp(1j * angle)
        point = 2j * (b + (1.5 + 2j) * coupler)
        points.append([point.real, point.imag])
    return points


class SweepTest(Sweeps):
    def test_rows_table_and_report(self):
        done = self.run_program("sweep", "small.toml", "--seed", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("done: 63 designs evaluated", done.stdout)
        self.assertIn("wrote small.study.db and small.report.html", done.stdout)
        self.assertEqual(
            sorted(path.name for path in self.folder.iterdir()),
            ["long.toml", "slider.toml", "small.report.html", "small.study.db", "small.toml"],
        )
        with sqlite3.connect(self.folder / "small.study.db") as database:
            columns = [row[1] for row in database.execute("PRAGMA table_info(runs)")]
            study = dict(database.execute("SELECT name, value FROM study"))
        self.assertEqual(
            columns,
            ["id", "mechanism.coupler", "mechanism.offset", "class", "output_stroke", "time_ratio", "status"],
        )
        self.assertEqual(study["study"], SMALL)
        self.assertEqual(study["base"], SLIDER)
        self.assertEqual(study["seed"], "3")
        rows = self.rows("small.study.db")
        # By hand: the crank turns fully where coupler − crank ≥ offset, and its transmission angle
        # is least at cos = (crank + offset) / coupler; the grid's last variable is the fastest.
        for number, coupler, offset, _, stroke, _, status in rows:
            self.assertEqual(coupler, 0.5 + number // 3 * 0.25)
            self.assertEqual(offset, [0, 0.25, 0.5][number % 3])
            self.assertEqual(status, "solved")
            outer, inner = ((coupler + sign) ** 2 - offset**2 for sign in (1, -1))
            self.assertAlmostEqual(stroke, outer**0.5 - inner**0.5, delta=1e-9)
        kept = [
            number
            for number in range(63)
            if 0.5 + number // 3 * 0.25 >= (1 + [0, 0.25, 0.5][number % 3]) / (3**0.5 / 2)
        ]
        self.assertEqual([row[0] for row in rows], kept)
        best = self.rows("small.study.db", "best")
        self.assertEqual(sorted(best), rows)
        self.assertEqual(best, sorted(best, key=lambda row: (-row[4], row[0])))

    def test_numbers_of_layers_are_metrics(self):
        """Cranks that sweep over each other's pivots have no layers, those of a longer frame two."""
        (self.folder / "linkage.toml").write_text(
            'kind = "analysis"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [4, 0]]\n'
            "crank = 3\ncoupler = 2.5\nrocker = 3\n"
            "[layers]\nlink_width = 0.3\npin_diameter = 0.15\n")
        (self.folder / "layers.toml").write_text(
            'base = "linkage.toml"\n[[vary]]\nkey = "mechanism.fixed_pivots[1][0]"\nvalues = [1, 5.2]\n'
            '[output]\nmetrics = ["layers.count"]\nrows = "all"\n[filter]\n"layers.count" = {max = 2}\n')
        done = self.run_program("sweep", "layers.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row[2:] for row in self.rows("layers.study.db")],
                         [(None, "filtered"), (2, "solved")])

    def test_document(self):
        done = self.run_program("sweep", "small.toml", "--json", "--out", "deep/er")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = json.loads(done.stdout, parse_constant=refuse_constant)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        rows = self.rows("deep/er/small.study.db")
        best = self.rows("deep/er/small.study.db", "best LIMIT 10")
        self.assertEqual([list(row.values()) for row in document["best"]], [list(row) for row in best])
        self.assertEqual(document["status"], "done")
        self.assertEqual(document["counts"]["evaluated"], 63)
        self.assertEqual(document["counts"]["kept"], len(rows))
        self.assertEqual(document["counts"]["filtered"], 63 - len(rows))
        self.assertTrue((self.folder / "deep/er/small.report.html").exists())
        self.run_program("sweep", "small.toml", "--json")
        self.assertFalse((self.folder / "small.report.html").exists())

    def test_again_there_is_nothing_to_do(self):
        self.run_program("sweep", "small.toml")
        (self.folder / "small.report.html").unlink()
        rows = self.rows("small.study.db")
        again = self.run_program("sweep", "small.toml")
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        self.assertIn("nothing was left to do", again.stdout)
        self.assertEqual(self.rows("small.study.db"), rows)
        self.assertTrue((self.folder / "small.report.html").exists())

    def test_nothing_passes(self):
        (self.folder / "none.toml").write_text(SMALL.replace("min = 30", "min = 89.9"))
        done = self.run_program("sweep", "none.toml")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("0 kept", done.stdout)

    def test_faults_of_the_file(self):
        (self.folder / "bad.toml").write_text(SMALL.replace("coupler", "cuopler"))
        done = self.run_program("sweep", "bad.toml")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^bad\.toml:\d+:\d+: ")
        self.assertFalse((self.folder / "bad.study.db").exists())
        self.expect_refusal(self.run_program("sweep", "nowhere.toml"), "nowhere.toml:1:1: ")

    def test_other_input_is_refused(self):
        self.run_program("sweep", "small.toml")
        rows = self.rows("small.study.db")
        self.expect_refusal(self.run_program("sweep", "small.toml", "--seed", "2"), "the seed (1 there, 2 here)")
        (self.folder / "slider.toml").write_text(SLIDER.replace("speed = 1", "speed = 2"))
        self.expect_refusal(self.run_program("sweep", "small.toml"), "the base file (from line 10 on)")
        (self.folder / "slider.toml").write_text(SLIDER)
        (self.folder / "small.toml").write_text("# other\n" + SMALL)
        self.expect_refusal(self.run_program("sweep", "small.toml"), "the study file (from line 1 on)", "--out")
        self.assertEqual(self.rows("small.study.db"), rows)
        (self.folder / "small.toml").write_text(SMALL)
        (self.folder / "small.study.db").write_text("no database, but long enough to be looked at")
        self.expect_refusal(self.run_program("sweep", "small.toml"), "is no study file")

    def test_a_search_begins_with_an_atlas(self):
        (self.folder / "four-bar.toml").write_text(ATLAS_BASE)
        (self.folder / "atlas.toml").write_text(ATLAS.format(metrics=json.dumps(DESCRIPTORS)))
        (self.folder / "closed.toml").write_text(CLOSED.format(curve=planted_curve()))
        place = "closed.toml:8:9: solve.atlas is "
        for command in ("check", "solve"):
            done = self.run_program(command, "closed.toml")
            self.expect_refusal(done, place + '"atlas.study.db", where there is no file')
        self.assertEqual(self.run_program("sweep", "atlas.toml").returncode, 0)

        self.assertIn("from the atlas atlas.study.db", self.run_program("check", "closed.toml").stdout)
        done = self.run_program("solve", "closed.toml", "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = json.loads(done.stdout, parse_constant=refuse_constant)
        if jsonschema is not None:
            schema = SCHEMA.with_name("cognate-result-1.schema.json")
            jsonschema.validate(document, json.loads(schema.read_text()))
        self.assertEqual(document["problem"]["solve"]["atlas"], "atlas.study.db")
        self.assertTrue(any("9 curves of the atlas" in note for note in document["notes"]))
        self.assertLess(document["designs"][0]["error"]["max"], 5e-3)  # the target is a polygon

        (self.folder / "of-closed.toml").write_text(
            'base = "closed.toml"\n[[vary]]\nkey = "bounds.length[1]"\nvalues = [40, 50]\n'
            '[output]\nmetrics = ["error.rms"]\n'
        )
        self.expect_refusal(
            self.run_program("sweep", "of-closed.toml"), "of-closed.toml:1:8: ", "which has solve.atlas"
        )
        for content, why in (("", "it is no study file"), ("x" * 5000, "it cannot be read")):
            (self.folder / "atlas.study.db").write_text(content)
            for command in ("check", "solve"):
                self.expect_refusal(self.run_program(command, "closed.toml"), place, why)
        (self.folder / "atlas.study.db").unlink()
        (self.folder / "atlas.toml").write_text(ATLAS.format(metrics=json.dumps(DESCRIPTORS[1:])))
        self.run_program("sweep", "atlas.toml")
        for command in ("check", "solve"):
            done = self.run_program(command, "closed.toml")
            self.expect_refusal(done, place, "it has no column fourier.m4; an atlas is")

    def test_pipes(self):
        os.mkfifo(self.folder / "pipe")
        for base in ("pipe", "/dev/zero", "/dev/tty"):
            (self.folder / "piped.toml").write_text(SMALL.replace("slider.toml", base))
            for command in ("check", "sweep"):
                with self.subTest(base=base, command=command):
                    self.expect_refusal(
                        self.run_program(command, "piped.toml"), "piped.toml:", "expected a regular file"
                    )
        os.mkfifo(self.folder / "small.study.db")
        self.expect_refusal(self.run_program("sweep", "small.toml"), "is no study file")
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "1"), "no regular file")
        os.unlink(self.folder / "small.study.db")
        # The text of a study that comes by a pipe is stored like that of a file.
        text = SMALL.replace("slider.toml", str(self.folder / "slider.toml"))
        read = self.run_program("sweep", "/dev/stdin", input=text)
        self.assertEqual(read.returncode, 0, read.stderr)
        with sqlite3.connect(self.folder / "stdin.study.db") as database:
            self.assertEqual(
                database.execute("SELECT value FROM study WHERE name = 'study'").fetchone()[0], text
            )

    def test_design_of_a_row(self):
        self.run_program("sweep", "small.toml")
        number, coupler, offset, _, stroke, *_ = self.rows("small.study.db", "best")[0]
        done = self.run_program("export", "small.study.db", "--row", number, "--out", "designs")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        file = f"designs/small.{number}.toml"
        self.assertEqual(done.stdout, f"wrote {file}\n")
        text = (self.folder / file).read_text()
        self.assertEqual(float(re.search(r"coupler = (\S+)", text)[1]), coupler)
        self.assertEqual(float(re.search(r"offset = (\S+)", text)[1]), offset)
        result = json.loads(self.run_program("analyze", file, "--json").stdout)
        self.assertAlmostEqual(result["designs"][0]["metrics"]["output_stroke"], stroke, delta=1e-12)
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "0"), "has no row 0")
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "-1"), "--row: '-1'")
        self.expect_refusal(self.run_program("export", "small.toml", "--row", "1"), "study file")
        self.expect_refusal(self.run_program("export", "small.study.db"), "--format is required")
        self.expect_refusal(
            self.run_program("export", "small.study.db", "--row", "1", "--format", "svg"), "--format"
        )


if __name__ == "__main__":
    SCHEMA = pathlib.Path(sys.argv.pop(2))
    del sys.argv[1]
    unittest.main()
