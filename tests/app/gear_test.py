"""Gears from outside: files written, exit statuses, what is said of impossible ones, studies of them.

Run as: gear_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems and the
JSON schema of results.
"""

import csv
import json
import math
import os
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

STUDY = """
kind = "study"
base = "{base}"
[[vary]]
key = "mechanism.{key}"
values = {values}
[output]
metrics = {metrics}
"""


# ISO 21771.
SYMBOLS = {"teeth": "z", "module": "m", "profile_shift": "x", "reference_diameter": "d", "base_diameter": "d_b",
           "tip_diameter": "d_a", "root_diameter": "d_f", "form_diameter": "d_Ff", "addendum": "h_a", "dedendum": "h_f",
           "tooth_depth": "h", "pitch": "p", "base_pitch": "p_b", "tooth_thickness": "s", "space_width": "e",
           "base_thickness": "s_b", "tip_thickness": "s_a", "normal_tooth_thickness": "s_n", "helix_deg": "β",
           "base_helix_deg": "β_b", "lead": "p_z", "span_measurement": "W_k", "working_pressure_angle_deg": "α_wt",
           "contact_ratio": "ε_α", "overlap_ratio": "ε_β", "total_contact_ratio": "ε_γ", "path_length": "g_α",
           "approach_length": "g_f", "recess_length": "g_a", "working_diameter": "d_w", "centre_distance": "a_w",
           "backlash": "j_wt", "normal_backlash": "j_bn"}


def is_inside(point, polygon):
    """Whether a ray to the right crosses the polygon an odd number of times."""
    x, y = point
    inside = False
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


def distance(point, polygon):
    """From its edges."""
    def from_edge(a, b):
        along = (b[0] - a[0], b[1] - a[1])
        length = math.hypot(*along)
        at = (point[0] - a[0], point[1] - a[1])
        share = min(1, max(0, (at[0] * along[0] + at[1] * along[1]) / length**2)) if length else 0
        return math.hypot(at[0] - share * along[0], at[1] - share * along[1])
    return min(from_edge(a, b) for a, b in zip(polygon, polygon[1:] + polygon[:1]))


class Gears(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_it(self, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, text=True, timeout=240,
                              capture_output=True, check=False)

    def document_of(self, file, command="analyze"):
        done = self.run_it(command, file, "--json")
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        self.assertEqual(done.returncode, 0 if document["status"] == "solved" else 1, done.stderr)
        return document

    def test_every_gear_of_the_library(self):
        listed = json.loads(self.run_it("list", "--metrics", "--json").stdout)
        known = {key for part in ("gear_metrics", "gear_pair_metrics") for metric in listed[part]
                 for key in metric["key"].split(", ")}
        known |= {"class", "transmission_angle_deg", "time_ratio", "defects"}
        columns = [key for column in listed["gear_columns"] for key in column["key"].split(", ")]
        impossible = {"undercut-9"}
        files = sorted((LIBRARY / "gear").glob("*.toml"))
        self.assertGreaterEqual(len(files), 4)
        for file in files:
            with self.subTest(file.name):
                document = self.document_of(file)
                self.assertEqual(document["status"] == "infeasible", file.stem in impossible)
                self.assertEqual(bool(document["notes"]), file.stem in impossible)
                design = document["designs"][0]
                self.assertLessEqual(design["metrics"].keys(), known)
                self.assertEqual([c["name"] for c in document["gear"]["columns"]], columns)

    def test_figures_have_the_symbols_of_the_standard(self):
        listed = json.loads(self.run_it("list", "--metrics", "--json").stdout)
        symbols = {}
        for part in ("gear_metrics", "gear_pair_metrics"):
            for metric in listed[part]:
                keys, own = metric["key"].split(", "), metric.get("symbol", "").split(", ")
                symbols |= dict(zip(keys, own, strict=True)) if own != [""] else {}
        self.assertEqual(symbols, symbols | SYMBOLS)
        text = self.run_it("analyze", LIBRARY / "gear" / "helical.toml").stdout
        for key in ("form_diameter", "base_thickness", "base_helix_deg", "span_measurement"):
            self.assertRegex(text, rf"{key} +{SYMBOLS[key]} ")

    def test_a_gear_writes_its_flank(self):
        done = self.run_it("analyze", LIBRARY / "gear" / "standard-35.toml")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.folder / "standard-35.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 22)
        self.assertAlmostEqual(float(rows[-1]["x"]), -1.8761278745879413, places=9)
        self.assertEqual(rows[0]["pressure_angle_deg"], "")

    def test_pairs_that_are_whole_are_analysed_as_they_are_solved(self):
        for name in ("standard", "too-far-apart", "bevel", "worm", "internal", "rack"):
            with self.subTest(name):
                file = LIBRARY / "gear-pair" / f"{name}.toml"
                analysed, solved = self.document_of(file), self.document_of(file, "solve")
                self.assertEqual(analysed["designs"], solved["designs"])
        self.assertIn("253.671", self.document_of(LIBRARY / "gear-pair" / "too-far-apart.toml")["notes"][0])

    def problem(self, text):
        file = self.folder / "asked.toml"
        file.write_text(text)
        return file

    def test_a_worm_wheel_that_cannot_be_is_reported_as_such(self):
        worm = 'kind = "gear-pair"\nmechanism = {gearing = "worm", wheel_teeth = 3, module = 2, wheel_shift = -10}\n'
        document = self.document_of(self.problem(worm))  # by the schema
        self.assertEqual(document["status"], "infeasible")
        self.assertNotIn("centre_distance", document["designs"][0]["mechanism"])
        self.assertIn("greater wheel_shift", document["notes"][0])

    def test_a_ring_and_a_rack(self):
        ring = self.document_of(LIBRARY / "gear-pair" / "internal.toml")
        metrics = ring["designs"][0]["metrics"]
        self.assertEqual((ring["status"], metrics["class"]), ("solved", "internal"))
        self.assertAlmostEqual(metrics["backlash"], 0.08, places=9)
        self.assertFalse(metrics["tips_overlap"])
        bad = self.document_of(LIBRARY / "gear-pair" / "internal-standard.toml")
        self.assertEqual((bad["status"], bad["designs"][0]["metrics"]["defects"]), ("infeasible", ["interference"]))
        self.assertIn("The wheel's tips pass the end of the pinion's flank", bad["notes"][0])
        rack = self.document_of(LIBRARY / "gear-pair" / "rack.toml")
        metrics = rack["designs"][0]["metrics"]
        self.assertAlmostEqual(metrics["travel_per_turn"], math.pi * 84, places=9)
        self.assertAlmostEqual(metrics["rack_distance"], 42 + 1.8 + 0.1 / math.tan(math.radians(20)), places=9)
        self.assertAlmostEqual(metrics["rack"]["tooth_depth"], 6 * 2.25, places=9)

    def test_infinite_sliding_meets_no_limit(self):
        shift = 1 - 5 * math.sin(math.radians(20)) ** 2  # the involute begins on the base circle
        text = (f'kind = "gear-pair"\nmechanism = {{gearing = "rack", pinion_teeth = 10, module = 1, '
                f'pinion_shift = {shift!r}}}\nconstraints = {{sliding_max = 100}}\n')
        document = self.document_of(self.problem(text))
        self.assertEqual(document["status"], "infeasible")
        self.assertIn("infinite", document["notes"][0])

    def test_rings_and_racks_are_exported(self):
        for name, partner in (("internal", "wheel"), ("rack", "rack")):
            self.run_it("solve", LIBRARY / "gear-pair" / f"{name}.toml")
            for form, files in (("dxf", [f"{name}.dxf"]), ("svg", [f"{name}.svg"]), ("json", [f"{name}.gears.json"]),
                                ("csv", [f"{name}.pinion.csv", f"{name}.{partner}.csv"])):
                done = self.run_it("export", f"{name}.result.json", "--format", form)
                self.assertEqual((done.returncode, done.stderr), (0, ""), form)
                for file in files:
                    self.assertTrue((self.folder / file).exists(), file)
        gears = json.loads((self.folder / "internal.gears.json").read_text())["gears"]
        radii = [math.hypot(x - gears[1]["centre"][0], y - gears[1]["centre"][1]) for x, y, _ in gears[1]["outline"]]
        self.assertAlmostEqual(min(radii), gears[1]["tip_radius"], places=9)
        self.assertAlmostEqual(max(radii), gears[1]["root_radius"], places=9)
        # No corner of the pinion lies outside the ring's hole, nor in a tooth of the rack.
        hole = [(x, y) for x, y, _ in gears[1]["outline"]]
        outside = [(x, y) for x, y, _ in gears[0]["outline"] if not is_inside((x, y), hole)]
        self.assertLess(len(outside), 0.2 * len(gears[0]["outline"]))  # where teeth touch, by the chords
        self.assertTrue(all(distance(point, hole) < 4e-3 for point in outside))
        gears = json.loads((self.folder / "rack.gears.json").read_text())["gears"]
        body = [(x, y) for x, y, _ in gears[1]["outline"]]
        within = [(x, y) for x, y, _ in gears[0]["outline"] if is_inside((x, y), body)]
        self.assertTrue(all(distance(point, body) < 0.012 for point in within))

    def test_rings_and_racks_that_are_refused(self):
        for lines, part in (('gearing = "internal"\nteeth = [60, 20]', "z1 < z2"),
                            ('gearing = "internal"\nteeth = [20, 60]\ncentre_distance = 41\nbacklash = 0.1', "leave one"),
                            ('gearing = "internal"\nteeth = [20, 60]\nhelix_deg = 10', "internal gears have none"),
                            ('gearing = "rack"\nteeth = [20, 60]', "pinion_teeth"),
                            ('gearing = "rack"\npinion_teeth = 20\ncentre_distance = 20', "expected rack_distance"),
                            ('gearing = "rack"\npinion_teeth = 20\n[solve]\ndesigns = 2', "not searched for")):
            text = f'kind = "gear-pair"\n[mechanism]\n{lines}'.replace("[mechanism]", "[mechanism]\nmodule = 2")
            done = self.run_it("check", self.problem(text))
            self.assertEqual(done.returncode, 2, lines)
            self.assertIn(part, done.stderr)
        narrow = 'kind = "gear-pair"\nmechanism = {gearing = "internal", teeth = [20, 40], module = 2, profile_shift = [2, -2]}\n'
        document = self.document_of(self.problem(narrow))
        self.assertEqual(document["status"], "no-solution")
        self.assertIn("greater shift of the ring", document["notes"][0])

    def test_a_rack_of_the_standard(self):
        rack = "rack = {clearance = 0.4, tip_radius = 0.39}\n"
        gear = 'kind = "gear"\nmechanism = {teeth = 30, module = 2}\n' + rack
        document = self.document_of(self.problem(gear))
        self.assertEqual(document["designs"][0]["mechanism"]["rack"]["tip_radius"], 0.39)
        # Where the rack's straight flank ends, its tangent to the base circle does.
        sine = math.sin(math.radians(20))
        tangent = 15 * sine - (1.4 - 0.39 * (1 - sine)) / sine
        form = 4 * math.hypot(15 * math.cos(math.radians(20)), tangent)
        self.assertAlmostEqual(document["designs"][0]["metrics"]["form_diameter"], form, places=10)
        done = self.run_it("analyze", self.problem(gear.replace("0.39", "0.4")))
        self.assertEqual(done.returncode, 2)
        self.assertIn("at most 0.39394", done.stderr)

    def test_a_pair_far_out_of_reach_can_be_read_again(self):
        pair = 'kind = "gear-pair"\nmechanism = {teeth = [20, 40], module = 2, centre_distance = 300}\n'
        self.run_it("solve", self.problem(pair))
        done = self.run_it("export", "asked.result.json", "--format", "svg")
        self.assertEqual((done.returncode, done.stderr), (0, done.stderr))
        self.assertTrue((self.folder / "asked.svg").exists(), done.stdout + done.stderr)

    def test_solve_sends_a_gear_to_analyze(self):
        done = self.run_it("solve", LIBRARY / "gear" / "standard-35.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'cognate analyze' evaluates this gear; expected a design problem", done.stderr)

    def sweep(self, **study):
        (self.folder / "study.toml").write_text(STUDY.format(**study))
        done = self.run_it("sweep", "study.toml", "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)["counts"]

    def test_studies_of_gears(self):
        limit = 1 - 9 / 2 * math.sin(math.radians(20)) ** 2  # a rack undercuts nine teeth below it
        counts = self.sweep(base=LIBRARY / "gear" / "shifted-9.toml", key="profile_shift",
                            values=[-0.2, limit - 1e-6, limit + 1e-6],
                            metrics=["tip_thickness", "undercut"])
        self.assertEqual((counts["infeasible"], counts["solved"]), (2, 1))

    def test_studies_of_pairs(self):
        counts = self.sweep(base=LIBRARY / "gear-pair" / "balanced-sliding.toml", key="centre_distance",
                   values=[86.5, 87, 87.5], metrics=["pinion.profile_shift", "sliding_max", "defects"])
        self.assertEqual(counts["solved"], 3)


if __name__ == "__main__":
    PROGRAM, LIBRARY, SCHEMA = os.path.abspath(sys.argv[1]), *map(
        lambda name: pathlib.Path(name).resolve(), sys.argv[2:4]
    )
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
