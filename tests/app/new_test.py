"""Files to start from, lists of one kind, several files at once, results analysed again.

Run as: new_test.py PROGRAM, the built program.
"""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from thinned import some

PROGRAM = ""

COMMANDS = {"analysis": "analyze", "gear": "analyze", "gear-train": "analyze", "machine": "analyze", "study": "sweep"}


class NewTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def run_program(self, *arguments, status=0):
        ran = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.at, capture_output=True,
                             text=True, timeout=300)
        self.assertEqual(ran.returncode, status, ran.stderr)
        return ran

    def kinds(self):
        kinds = [kind["name"] for kind in json.loads(self.run_program("list", "--json").stdout)["problem_kinds"]]
        self.assertGreater(len(kinds), 10)
        return kinds

    def documents(self, text):
        """The JSON documents that follow one another in `text`."""
        decoder, found, at = json.JSONDecoder(), [], 0
        while at < len(text):
            document, at = decoder.raw_decode(text, at)
            found.append(document)
            at += len(text) - at - len(text[at:].lstrip())
        return found

    def test_every_kind_begins_with_a_file_that_is_solved(self):
        for kind in some(self.kinds()):
            with self.subTest(kind):
                said = self.run_program("new", kind)
                command = COMMANDS.get(kind, "solve")
                self.assertEqual(said.stdout,
                                 f"wrote {kind}.toml; next: cognate {command} {kind}.toml\n")
                there = self.run_program("new", kind, "--out", "there").stdout
                self.assertTrue(there.endswith(f"next: cognate {command} there/{kind}.toml\n"))
                self.run_program("check", f"{kind}.toml")
                self.run_program(command, f"{kind}.toml", "--quiet", "--out", "out")

    def test_every_line_behind_a_hash_may_be_added(self):
        options = 0
        self.run_program("new", "analysis")  # the base of the study
        for kind in self.kinds():
            if kind != "analysis":
                self.run_program("new", kind)
            lines = (self.at / f"{kind}.toml").read_text().splitlines()
            for i, line in enumerate(lines):
                if not re.match(r"#[a-z_]+ = ", line):
                    continue
                changed = lines[:i] + [line[1:]] + lines[i + 1:]
                (self.at / "changed.toml").write_text("\n".join(changed) + "\n")
                with self.subTest(kind=kind, line=line):
                    self.run_program("check", "changed.toml")
                options += 1
        self.assertGreater(options, 30)

    def test_what_is_there_is_left(self):
        (self.at / "cam.toml").write_text("mine")
        refused = self.run_program("new", "cam", status=2)
        self.assertIn("cam.toml: is there already", refused.stderr)
        self.assertEqual((self.at / "cam.toml").read_text(), "mine")
        (self.at / "gear.toml").symlink_to("nowhere")
        self.run_program("new", "gear", status=2)
        self.assertTrue((self.at / "gear.toml").is_symlink())
        self.run_program("new", "gear", "--out", "a/b", "--quiet")
        self.assertTrue((self.at / "a/b/gear.toml").is_file())

    def test_kinds_are_named(self):
        for command in ("new", "list"):
            refused = self.run_program(command, "path-generator", status=2)
            self.assertIn('perhaps for "path-generation"', refused.stderr)
            for kind in self.kinds():
                self.assertIn(f'"{kind}"', refused.stderr)
        self.assertIn("new takes one KIND", self.run_program("new", "cam", "x", status=2).stderr)

    def test_a_list_of_one_kind_is_part_of_the_whole(self):
        for options in ([], ["--metrics"]):
            whole = set(self.run_program("list", *options).stdout.splitlines())
            for kind in self.kinds():
                lines = self.run_program("list", kind, *options).stdout.splitlines()
                self.assertGreater(len(lines), 3, kind)
                keys = [line for line in lines if line.startswith("      ")]
                if not options:
                    self.assertTrue(set(keys) <= whole, kind)
                    self.assertLess(len(lines), len(whole) / 2)

    def test_several_files_end_with_the_worst_status(self):
        for kind in ("gear", "cam"):
            self.run_program("new", kind)
        (self.at / "bad.toml").write_text('kind = "cam"\n')
        said = self.run_program("check", "gear.toml", "bad.toml", "cam.toml", status=2)
        self.assertEqual(said.stdout.count("no fault found"), 2)
        self.assertIn("bad.toml:", said.stderr)
        found = self.documents(self.run_program("check", "--json", "gear.toml", "bad.toml", "cam.toml",
                                                status=2).stdout)
        self.assertEqual([document["valid"] for document in found], [True, False, True])
        self.run_program("solve", "cam.toml", "bad.toml", "--quiet", status=2)
        self.assertTrue((self.at / "cam.result.json").is_file())

    def test_two_results_of_one_name_are_refused(self):
        self.run_program("new", "cam")
        self.run_program("new", "cam", "--out", "other")
        refused = self.run_program("solve", "cam.toml", "other/cam.toml", status=2)
        self.assertIn("two of the files would write cam.result.json", refused.stderr)
        self.assertFalse((self.at / "cam.result.json").exists())
        both = self.run_program("solve", "cam.toml", "other/cam.toml", "--json").stdout
        self.assertEqual(len(self.documents(both)), 2)

    def test_faults_are_documents_too(self):
        (self.at / "bad.toml").write_text('kind = "cam"\nwrong = 1\n')
        for command in ("solve", "analyze", "sweep", "check"):
            refused = self.run_program(command, "bad.toml", "--json", status=2)
            document, = self.documents(refused.stdout)
            self.assertEqual((document["format"], document["valid"]), ("cognate-check/1", False))
            for fault in document["faults"]:
                place = f"bad.toml:{fault['line']}:{fault['column']}: {fault['message']}"
                self.assertIn(place, refused.stderr)

    def test_a_file_of_a_similar_name_is_meant(self):
        self.run_program("new", "cam", "--out", "here")
        refused = self.run_program("solve", "here/cma.toml", status=2)
        self.assertIn("did you mean here/cam.toml?", refused.stderr)
        self.assertNotIn("did you mean", self.run_program("solve", "here/shaft.toml", status=2).stderr)

    def test_designs_of_a_result_are_analysed(self):
        """The curve of each design passes the targets within its greatest error."""
        self.run_program("new", "path-generation")
        self.run_program("solve", "path-generation.toml", "--quiet")
        result = json.loads((self.at / "path-generation.result.json").read_text())
        points = result["problem"]["target"]["points"]
        self.assertGreater(len(result["designs"]), 1)
        for number, design in enumerate(result["designs"], 1):
            self.run_program("export", "path-generation.result.json", "--format", "toml", "--design",
                             number, "--quiet")
            stem = f"path-generation.design{number}"
            text = (self.at / f"{stem}.toml").read_text()
            (self.at / f"{stem}.toml").write_text(text + "[drive]\nsteps = 3600\n")
            self.run_program("analyze", f"{stem}.toml", "--quiet", "--out", "written")
            with open(self.at / "written" / f"{stem}.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            x, y = (next(key for key in rows[0] if key.startswith(f"P_{axis}")) for axis in "xy")
            curve = [(float(row[x]), float(row[y])) for row in rows]
            step = max(math.dist(a, b) for a, b in zip(curve, curve[1:]))
            for point in points:
                self.assertLessEqual(min(math.dist(point, at) for at in curve),
                                     design["error"]["max"] * (1 + 1e-9) + step / 2)
            self.run_program("analyze", "path-generation.result.json", "--design", number, "--quiet")
            again = json.loads((self.at / f"{stem}.result.json").read_text())
            whole = json.loads((self.at / "written" / f"{stem}.result.json").read_text())
            for key in ("class", "transmission_angle_deg", "output_swing_deg"):
                self.assertEqual(again["designs"][0]["metrics"][key], whole["designs"][0]["metrics"][key])

    def test_a_design_that_ends_at_dead_points_is_analysed_within_one_range(self):
        """A crank as long as its coupler but for rounding turns from one dead point to the next."""
        (self.at / "line.toml").write_text(
            'kind = "straight-line"\n[target]\nlength = 1\n[mechanism]\ntype = "slider-crank"\n')
        self.run_program("solve", "line.toml", "--quiet")
        self.run_program("analyze", "line.result.json", "--quiet")
        document = json.loads((self.at / "line.design1.result.json").read_text())
        self.assertFalse([note for note in document["notes"] if "separate ranges" in note])
        found = json.loads((self.at / "line.result.json").read_text())["designs"][0]
        self.assertGreater(document["designs"][0]["metrics"]["output_stroke"],
                           found["mechanism"]["crank"])

    def test_an_analysis_comes_back_as_its_file(self):
        self.run_program("new", "analysis")
        self.run_program("analyze", "analysis.toml", "--quiet")
        first = json.loads((self.at / "analysis.result.json").read_text())
        told = self.run_program("export", "analysis.result.json", "--format", "toml", "--json")
        self.assertEqual(json.loads(told.stdout)["files"], ["analysis.design1.toml"])
        self.run_program("analyze", "analysis.design1.toml", "--quiet", "--out", "again")
        again = json.loads((self.at / "again/analysis.design1.result.json").read_text())
        self.assertEqual(again["designs"], first["designs"])
        self.assertEqual(again["problem"], first["problem"])

    def test_what_is_no_linkage_is_not_analysed(self):
        self.run_program("new", "cam")
        self.run_program("solve", "cam.toml", "--quiet")
        refused = self.run_program("analyze", "cam.result.json", status=2)
        self.assertIn("is the result of a cam; expected that of a linkage", refused.stderr)
        refused = self.run_program("export", "cam.result.json", "--format", "toml", status=2)
        self.assertIn("are for linkages", refused.stderr)
        refused = self.run_program("analyze", "cam.toml", "--design", "2", status=2)
        self.assertIn("--design: is of results", refused.stderr)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
