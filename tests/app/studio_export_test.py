"""What is taken along of the studio's results, against `cognate solve` and `cognate export` on files.

Run as: studio_export_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from studios import ENDLESS, PROGRAM, SHORT, Studios

LIBRARY = pathlib.Path(sys.argv[2])
PARTS = {"parts": True, "hole": 3, "width": 8, "thickness": "3"}

CASES = {
    "quick-return": (SHORT, [
        {"format": "dxf"}, {"format": "dxf", "dxf-version": "r12", "position": "90", "design": 1},
        {"format": "svg", "chord-tolerance": 0.5}, {"format": "csv", "steps": 36}, {"format": "json"},
        {"format": "dot"}, {"format": "toml"}, {"format": "dxf", **PARTS},
        {"format": "dxf", **PARTS, "kerf": 0.2, "sheet": "600x400", "labels": "stroke", "bill": True,
         "spacers": True}]),
    "cam": ((LIBRARY / "cam" / "translating-roller.toml").read_text(),
            [{"format": "dxf"}, {"format": "csv", "curve": "pitch"},
             {"format": "svg", "bore": "8", "timing-mark": True}]),
    "gear": ((LIBRARY / "gear" / "helical.toml").read_text(), [{"format": "dxf"}, {"format": "csv"}]),
}

# A chain whose lengths are given and never close.
NOTHING = """kind = "path-generation"
[target]
points = [[0, 0], [1, 0.3], [2, 0.1], [3, 1], [2, 2], [1, 1.5]]
point = "P"
[mechanism]
type = "chain"
[[pivot]]
name = "A"
at = [0, 0]
[[pivot]]
name = "D"
at = [50, 0]
[crank]
at = "A"
pin = "B"
length = 1
[[dyad]]
joins = ["B", "D"]
new = "C"
lengths = [2, 3]
assembly = "open"
[[point]]
name = "P"
on = ["B", "C"]
at = [1, 1]
"""

WRONG = [
    ({}, "--format"),
    ({"format": "pdf"}, "--format"),
    ({"format": ["dxf"]}, "format: expected a text or a number"),
    ({"format": "dxf", "parts": "yes"}, "parts: expected true or false"),
    ({"format": "dxf", "hole": True}, "hole: expected a text or a number"),
    ({"format": "dxf", "out": "/tmp"}, "out: is no option of an export"),
    ({"format": "dxf", "--parts": True}, "--parts: is no option of an export"),
    ({"format": "dxf", "hole": 3}, "--hole: is that of parts"),
    ({"format": "dxf", "design": 99}, "there is no design 99"),
    ({"format": "dxf", "design": -1}, "--design"),
    ({"format": "dxf", "position": "1e999"}, "--position"),
    ({"format": "dxf", "parts": True, "hole": 9, "width": 8}, "--width"),
    ({"format": "dxf", "curve": "pitch"}, "is for cams"),
]


class StudioExport(Studios):
    def solved(self, text):
        studio = self.serve(text, "--seed", "3", "--threads", "1")
        studio.document("/solve", {"text": text})
        studio.wait_until(lambda state: state["phase"] == "done")
        return studio

    def exported(self, command, asked):
        """What the program writes of its own result of the file, by names."""
        words = []
        for name, value in asked.items():
            words += [f"--{name}"] if value is True else [f"--{name}", str(value)]
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, command, "--seed", "3", "--quiet", "--out", folder, self.file],
                           check=True)
            result = pathlib.Path(folder, "problem.result.json")
            made = pathlib.Path(folder, "made")
            subprocess.run([PROGRAM, "export", result, *words, "--quiet", "--out", made], check=True,
                           capture_output=True)
            return {file.name: file.read_bytes().decode() for file in made.iterdir()}

    def test_files_are_those_of_export(self):
        for name, (text, cases) in CASES.items():
            studio = self.solved(text)
            for asked in cases:
                with self.subTest(f"{name}: {asked}"):
                    answer = studio.document("/export", asked)
                    self.assertIn("files", answer, answer)
                    made = {file["name"]: file["text"] for file in answer["files"]}
                    self.assertEqual(made, self.exported("analyze" if name == "gear" else "solve", asked))
                    self.assertTrue(answer["summary"])
            self.ends_well(studio)

    def test_what_cannot_be_made_is_refused(self):
        studio = self.solved(SHORT)
        for asked, why in WRONG:
            with self.subTest(str(asked)):
                answer = studio.document("/export", asked)
                self.assertNotIn("files", answer)
                self.assertIn(why, " ".join(answer["faults"]))
        self.assertEqual(studio.status("/export", [1]), 400)
        self.ends_well(studio)

    def test_there_is_nothing_before_a_result_and_a_result_without_designs_has_none(self):
        studio = self.serve(NOTHING)
        self.assertEqual(studio.status("/export", {"format": "dxf"}), 404)
        self.assertEqual(studio.document("/state")["designs"], 0)
        studio.document("/solve", {"text": self.file.read_text()})
        state = studio.wait_until(lambda state: state["phase"] == "done")
        self.assertEqual(state["designs"], 0)
        self.assertIn("no design", " ".join(studio.document("/export", {"format": "dxf"})["faults"]))
        self.ends_well(studio)

    def test_a_result_can_be_taken_while_the_next_is_sought(self):
        studio = self.solved(SHORT)
        before = studio.document("/export", {"format": "toml"})
        studio.document("/solve", {"text": ENDLESS})
        studio.wait_until(lambda state: state["best"] is not None)
        self.assertEqual(studio.document("/export", {"format": "toml"}), before)
        self.ends_well(studio)


if __name__ == "__main__":
    del sys.argv[1:3]
    unittest.main()
