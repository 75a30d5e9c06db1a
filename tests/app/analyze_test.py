"""Analysing from outside: the table, the documents, exit statuses, interruption, the same numbers again.

Run as: analyze_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems and
the JSON schema of results.
"""

import csv
import json
import math
import os
import pathlib
import pty
import re
import signal
import stat
import subprocess
import sys
import tempfile
import unittest

from thinned import some
from toml_text import toml_of

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

CRANK_ROCKER = """
kind = "analysis"
title = "Crank-rocker"
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [4, 0]]
crank = 1
coupler = 3
rocker = 3
coupler_point = [1.5, 1]
[drive]
speed = 10
steps = 72
"""

# B and D are up to 4 apart, and coupler and rocker reach 3.5.
TRIPLE_ROCKER = CRANK_ROCKER.replace("[4, 0]", "[2, 0]").replace("crank = 1", "crank = 2").replace(
    "coupler = 3", "coupler = 1.5").replace("rocker = 3", "rocker = 2")

NOWHERE = CRANK_ROCKER.replace("[4, 0]", "[40, 0]")

LAYERS = """
[layers]
link_width = 0.3
pin_diameter = 0.15
clearance = 0.02
"""

# Both cranks sweep over the pivot of the other, the driving one first at its bottom right.
DRAG_LINK = CRANK_ROCKER.replace("[4, 0]", "[1, 0]").replace("crank = 1", "crank = 3").replace(
    "coupler = 3", "coupler = 2.5").replace("coupler_point = [1.5, 1]", "").replace(
        "[drive]", "[drive]\nstart_deg = 90") + LAYERS

# Takes seconds: as many rows as a file may ask for, of a long chain.
LONG = """
kind = "analysis"
[output]
want = ["torque"]
[drive]
steps = {steps}
[mechanism]
type = "chain"
crank = {{at = "A", pin = "B0", length = 1}}
pivot = [{{name = "A", at = [0, 0]}}, {pivots}]
dyad = [{dyads}]
"""


def refuse_constant(name):
    raise AssertionError(f"{name} is no JSON")


def parse(text):
    """The document in `text`, which holds neither NaN nor Infinity."""
    return json.loads(text, parse_constant=refuse_constant)


def run(*arguments, **options):
    """Runs the program; drops the lines of progress, which only a slow machine gets to see."""
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options
    )
    done.stderr = re.sub(r"^cognate: +\d+ %.*\n", "", done.stderr, flags=re.MULTILINE)
    return done


def read_csv(path):
    """The columns of a CSV file by name: floats, None for empty cells."""
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file, strict=True)
    cells = [[float(cell) if cell else None for cell in row] for row in rows]
    return {name: [row[i] for row in cells] for i, name in enumerate(header)}


class Analyze(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="written.toml"):
        file = self.folder / name
        file.write_text(text)
        return file

    def document_of(self, done):
        document = parse(done.stdout)
        self.check_document(document)
        return document

    def check_document(self, document):
        """What holds for every result, apart from its schema."""
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        columns = document["analysis"]["columns"]
        (design,) = document["designs"]
        drive = design.get("crank_deg", design.get("slide"))
        self.assertEqual(columns[0]["values"], drive)
        self.assertEqual({len(column["values"]) for column in columns}, {len(drive)})
        names = [column["name"] for column in columns]
        self.assertEqual(len(names), len(set(names)))
        for column in columns:
            if column["unit"] == "deg":
                self.assertTrue(column["name"].endswith("_deg"), column["name"])
            if column["unit"] == "N":
                self.assertTrue(column["name"].endswith("_N"), column["name"])

    def test_every_mechanism_of_the_library(self):
        files = sorted((LIBRARY / "analysis").glob("*.toml"))
        self.assertGreater(len(files), 20)
        for file in some(files):
            with self.subTest(file.name):
                done = run("analyze", file, "--out", self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
                self.assertIn("solved: ", done.stdout)
                document = parse((self.folder / f"{file.stem}.result.json").read_text())
                self.check_document(document)
                self.assertEqual(document["status"], "solved")
                report = (self.folder / f"{file.stem}.report.html").read_text()
                self.assertIn("</html>", report)
                table = read_csv(self.folder / f"{file.stem}.csv")
                self.assertEqual(list(table.values()),
                                 [c["values"] for c in document["analysis"]["columns"]])
                for heading, column in zip(table, document["analysis"]["columns"], strict=True):
                    # A length's heading names the unit of the file, where it has one.
                    unit = document["problem"].get("length_unit", "mm")
                    self.assertIn(column["name"], (heading, heading.replace(f"_{unit}", "", 1)))
                metrics = document["designs"][0]["metrics"]
                self.assertLess(metrics["closure_residual"], 1e-13)
                self.assertLess(metrics.get("power_residual", 0), 1e-11)

    def test_the_schema_names_the_types_of_the_program(self):
        mechanism = json.loads(SCHEMA.read_text())["definitions"]["any_mechanism"]
        listed = json.loads(run("list", "--json").stdout)["mechanisms"]
        self.assertEqual(mechanism["properties"]["type"]["enum"], [each["name"] for each in listed])

    def test_the_mechanism_of_a_result_is_that_of_its_file(self):
        # What a result says of its problem is a file again, and gives the same numbers.
        files = sorted((LIBRARY / "analysis").glob("*.toml"))
        self.assertGreater(len(files), 20)
        for file in some(files):
            with self.subTest(file.name):
                first = parse(run("analyze", file, "--json").stdout)
                again = self.write(toml_of(first["problem"]))
                second = parse(run("analyze", again, "--json").stdout)
                self.assertEqual(second["problem"], first["problem"])
                self.assertEqual(second["analysis"], first["analysis"])

    def test_a_coupler_curve_has_its_geometry(self):
        file = LIBRARY / "analysis" / "coupler-curve.toml"
        analysis = self.document_of(run("analyze", file, "--json"))["analysis"]
        doubles = [l for l in analysis["landmarks"] if l["kind"] == "double point"]
        self.assertEqual(len(doubles), 4)  # two, each passed twice
        self.assertEqual(
            sorted(l["crank_deg"] for l in doubles), sorted(l["again_crank_deg"] for l in doubles)
        )
        turns_with = [c["crank_turns_with"] for c in analysis["cognates"]]
        self.assertEqual(turns_with, ["crank", "coupler"])
        names = [c["name"] for c in analysis["columns"] if c["quantity"] == "instant-geometry"]
        self.assertIn("coupler_pole_x", names)
        table = run("analyze", file, "--out", self.folder).stdout
        self.assertIn("double point, also at", table)

    def test_the_csv_is_rfc_4180(self):
        run("analyze", self.write(CRANK_ROCKER), "--out", self.folder)
        data = (self.folder / "written.csv").read_bytes()
        lines = data.split(b"\r\n")
        self.assertEqual(len(lines), 75)
        self.assertEqual(lines[-1], b"")
        self.assertEqual({line.count(b",") for line in lines[:-1]}, {lines[0].count(b",")})
        self.assertNotIn(b"\n", data.replace(b"\r\n", b""))
        self.assertTrue(lines[0].startswith(b"crank_deg,coupler_deg,"))

    def test_numbers_are_those_of_the_mechanism(self):
        run("analyze", self.write(CRANK_ROCKER), "--out", self.folder)
        table = read_csv(self.folder / "written.csv")
        self.assertEqual(table["crank_deg"], [5.0 * row for row in range(73)])
        for row in range(73):
            theta = math.radians(table["crank_deg"][row])
            c = (table["C_x"][row], table["C_y"][row])
            self.assertAlmostEqual(math.dist(c, (math.cos(theta), math.sin(theta))), 3, delta=1e-14)
            self.assertAlmostEqual(math.dist(c, (4, 0)), 3, delta=1e-14)
            mu = math.radians(table["transmission_deg"][row])
            chord = math.dist((math.cos(theta), math.sin(theta)), (4, 0))
            self.assertAlmostEqual(6 * math.sin(mu / 2), chord, delta=1e-13)

    def test_json_is_the_document_and_nothing_else(self):
        file = self.write(CRANK_ROCKER)
        done = run("analyze", file, "--json", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = self.document_of(done)
        self.assertEqual([path.name for path in self.folder.iterdir()], [file.name])
        self.assertEqual(document["problem"]["drive"]["steps"], 72)
        self.assertEqual(document["work"]["positions"], 73)
        self.assertEqual(document["designs"][0]["origin"], "given")
        self.assertEqual(document["designs"][0]["metrics"]["class"], "crank-rocker")
        beside = run("analyze", file, "--json", "--out", self.folder / "out")
        self.assertEqual(
            parse((self.folder / "out/written.result.json").read_text()), parse(beside.stdout)
        )

    def test_quiet_prints_nothing(self):
        done = run("analyze", self.write(CRANK_ROCKER), "--quiet", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(
            sorted(path.suffix for path in self.folder.iterdir()), [".csv", ".html", ".json", ".toml"]
        )

    def test_the_number_of_threads_changes_no_number(self):
        file = self.write(CRANK_ROCKER.replace("steps = 72", "steps = 3000"))
        one, three = (
            parse(run("analyze", file, "--json", "--threads", n).stdout)["analysis"] for n in (1, 3)
        )
        self.assertEqual(one, three)

    def test_layers_keep_links_apart(self):
        file = self.write(CRANK_ROCKER.replace("coupler_point = [1.5, 1]", "") + LAYERS)
        document = self.document_of(run("analyze", file, "--json", cwd=self.folder))
        layers = document["designs"][0]["layers"]
        self.assertEqual(layers["count"], 2)
        self.assertEqual({link["name"]: link["layer"] for link in layers["links"]},
                         {"crank": 1, "coupler": 2, "rocker": 1})
        self.assertEqual({pin["name"]: pin["joins"] for pin in layers["pins"]},
                         {"A": ["frame", "crank"], "B": ["crank", "coupler"],
                          "C": ["coupler", "rocker"], "D": ["frame", "rocker"]})
        self.assertEqual(document["designs"][0]["metrics"]["layers"], {"count": 2, "pin_crossings": 0})
        self.assertEqual(document["problem"]["layers"],
                         {"link_width": 0.3, "pin_diameter": 0.15, "clearance": 0.02})

    def test_links_that_block_each_other_are_named(self):
        document = self.document_of(run("analyze", self.write(DRAG_LINK), "--json", cwd=self.folder))
        layers = document["designs"][0]["layers"]
        self.assertIsNone(layers["count"])
        self.assertEqual(layers["blocked"], ["crank", "rocker"])
        self.assertTrue(all(link["layer"] is None for link in layers["links"]))
        met = next(conflict for conflict in layers["conflicts"]
                   if conflict["pins"] == ["D"] and conflict["links"] == ["crank"])
        # Where D, 1 from A, is half the sum of both widths and the clearance from the crank.
        self.assertAlmostEqual(met["first_at_deg"], 360 - math.degrees(math.asin(0.245)), places=5)
        self.assertTrue(any("crank and rocker block each other" in note for note in document["notes"]))

    def test_what_cannot_be_assembled_is_empty(self):
        file = self.write(TRIPLE_ROCKER)
        done = run("analyze", file, "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("reach 3.5", done.stdout)
        table = read_csv(self.folder / "written.csv")
        document = parse((self.folder / "written.result.json").read_text())
        self.check_document(document)
        row = table["crank_deg"].index(180)
        self.assertEqual({table[name][row] for name in table if name != "crank_deg"}, {None})
        self.assertNotIn(None, [table[name][table["crank_deg"].index(90)] for name in table])

    def test_a_mechanism_that_closes_nowhere(self):
        done = run("analyze", self.write(NOWHERE), "--out", self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("no solution: ", done.stdout)
        document = parse((self.folder / "written.result.json").read_text())
        self.check_document(document)
        self.assertEqual(document["status"], "no-solution")
        self.assertTrue(any("reach 6" in note for note in document["notes"]), document["notes"])
        self.assertTrue((self.folder / "written.report.html").exists())

    def test_bad_input_is_refused(self):
        faulty = self.write(CRANK_ROCKER.replace("coupler = 3", "coupler = -3\ncuopler = 2"))
        done = run("analyze", faulty, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, r"written\.toml:8:\d+: mechanism\.coupler")
        self.assertRegex(done.stderr, r"written\.toml:9:\d+: ")
        design = LIBRARY / "path" / "six-point-line.toml"
        for arguments, part in [
            ([design], "analysis"),
            ([self.folder / "missing.toml"], "missing.toml:1:1: "),
            ([], "FILE"),
        ]:
            with self.subTest(part):
                done = run("analyze", *arguments, cwd=self.folder)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(part, done.stderr)
        solved = run("solve", self.write(CRANK_ROCKER), cwd=self.folder)
        self.assertEqual(solved.returncode, 2)
        self.assertIn("analyze", solved.stderr)

    def test_places_that_cannot_be_written_to(self):
        file = self.write(CRANK_ROCKER)
        (self.folder / "written.csv").mkdir()
        done = run("analyze", file, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("written.csv", done.stderr)
        self.assertFalse((self.folder / "written.result.json").exists())

    def test_a_read_only_folder(self):
        file = self.write(CRANK_ROCKER)
        closed = self.folder / "closed"
        closed.mkdir()
        closed.chmod(stat.S_IRUSR | stat.S_IXUSR)
        # No folder of a disk is read-only for the superuser; that of the kernel is for everyone.
        folder = pathlib.Path("/proc") if os.geteuid() == 0 else closed
        done = run("analyze", file, "--out", folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn(str(folder), done.stderr)

    def long_chain(self):
        """Nearly the longest sweep that a file may ask for, of ninety-nine dyads in a row."""
        dyads, pivots = [], []
        for i in range(99):
            pivots.append(f'{{name = "D{i}", at = [{3 * (i + 1)}, 0]}}')
            dyads.append(
                f'{{type = "RRR", joins = ["B{i}", "D{i}"], lengths = [3, 1], new = "B{i + 1}"}}'
            )
        return self.write(
            LONG.format(steps=49000, pivots=", ".join(pivots), dyads=", ".join(dyads))
        )

    def test_a_time_limit_ends_the_run(self):
        done = run("analyze", self.long_chain(), "--json", "--time-limit", "0.01")
        document = self.document_of(done)
        self.assertEqual(document["status"], "time-limit")

    def test_ctrl_c_reports_what_was_computed(self):
        screen, terminal = pty.openpty()
        self.addCleanup(os.close, screen)
        program = subprocess.Popen(
            [PROGRAM, "analyze", self.long_chain(), "--threads", "1", "--out", self.folder],
            stdout=subprocess.PIPE,
            stderr=terminal,
            env={**os.environ, "TERM": "xterm"},
            text=True,
        )
        os.close(terminal)
        shown = b""
        while not re.search(rb"[1-9] %", shown):  # some rows are there
            try:
                shown += os.read(screen, 1000)
            except OSError:  # how Linux says that the other end is closed
                program.communicate()
                self.skipTest("this machine is done before it shows progress")
        program.send_signal(signal.SIGINT)
        text, _ = program.communicate(timeout=120)
        self.assertEqual(program.returncode, 0, text)
        self.assertIn("interrupted: ", text)
        document = parse((self.folder / "written.result.json").read_text())
        self.check_document(document)
        self.assertEqual(document["status"], "interrupted")
        rows = len(document["analysis"]["columns"][0]["values"])
        self.assertEqual(document["work"]["positions"], rows)
        self.assertGreater(rows, 0)


if __name__ == "__main__":
    PROGRAM, LIBRARY, SCHEMA = os.path.abspath(sys.argv[1]), *map(
        lambda name: pathlib.Path(name).resolve(), sys.argv[2:4]
    )
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
