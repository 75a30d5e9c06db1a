"""Layers of designs, and designs that need no more of them than a file allows, from outside.

Run as: design_layers_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems
and the JSON schema of results.
"""

import contextlib
import csv
import json
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
import unittest

from sampled_layers import SampledLayers
from thinned import some, whole_only

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

# What samples may miss between two of them, and rounding, in shares of a link's width.
SLACK = 1e-3

ELLIPSE = """
kind = "path-generation"
[target]
points = [[20, 10], [17.66, 15.142], [11.736, 17.878], [5, 16.928], [0.60307, 12.736],
          [0.60307, 7.2638], [5, 3.0718], [11.736, 2.1215], [17.66, 4.8577], [20, 10]]
[bounds]
length = [5, {longest}]
coupler_point = [[-80, -80], [80, 80]]
pivot_a = [[-80, -80], [80, 80]]
[constraints]
class = "crank-rocker"
{limit}
[layers]
link_width = {width}
pin_diameter = 0.8
clearance = 0.1
thickness = 3
"""

# A file of each kind, how wide its links are, and further keys of [solve] that make it quick.
KINDS = [("path/semicircle", 0.05, ""), ("path/nine-points-1", 0.02, "designs = 4"),
         ("function/three-angle-pairs", 0.1, ""), ("function/square", 0.1, ""),
         ("function/slider-crank-square", 0.1, ""), ("motion/three-poses-fixed-pivots", 0.1, ""),
         ("motion/slider-crank", 0.1, ""), ("motion/four-poses", 0.05, ""),
         ("straight-line/hoeken", 0.1, ""), ("straight-line/search-hoeken", 0.1, "starts = 40"),
         ("quick-return/crank-rocker-best", 10, ""), ("quick-return/slider-crank", 10, ""),
         ("quick-return/guide-bar", 5, ""), ("quick-return/shaper", 5, ""),
         ("chain/watt-path", 0.3, "starts = 60"), ("dwell/six-bar-dwell", 0.1, "starts = 64"),
         ("leg/klann", 0.05, "starts = 48"), ("chain-function/six-bar-logarithm", 0.05, "starts = 48")]


def with_lines(text, table, lines):
    """The file with lines at the beginning of a table, which it need not have."""
    if f"\n[{table}]\n" not in text:
        text += f"\n[{table}]\n"
    for line in lines.splitlines():
        text = re.sub(f"(?m)^{line.split()[0]} = .*$", "", text)
    return text.replace(f"\n[{table}]\n", f"\n[{table}]\n{lines}\n")


def sampled_layers(mechanism, sizes):
    """None of types that the samples do not know, and where the crank does not turn fully."""
    if mechanism["type"] not in ("four-bar", "chain") or any(
            dyad["type"] != "RRR" for dyad in mechanism.get("dyad", [])):
        return None
    try:
        return SampledLayers(mechanism, sizes)
    except ValueError:
        return None


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300,
                          **options)


class DesignLayers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="written.toml"):
        file = self.folder / name
        file.write_text(text)
        return file

    def solved(self, file, *options, status=0):
        done = run("solve", file, "--json", *options, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        return document

    def check_by_samples(self, document, fewest=True):
        """The layers reported hold at the samples, and no fewer do."""
        sizes = document["problem"]["layers"]
        slack = SLACK * sizes["link_width"]
        count = 0
        for design in document["designs"]:
            sampled = sampled_layers(design["mechanism"], sizes)
            if sampled is None:
                continue
            count += 1
            layers = design["layers"]
            self.assertEqual({link["name"] for link in layers["links"]}, set(sampled.links))
            self.assertEqual(design["metrics"].get("layers", {}).get("count"), layers["count"])
            if layers["count"] is not None:
                held = {link["name"]: link["layer"] for link in layers["links"]}
                self.assertEqual(max(held.values()), layers["count"])
                self.assertGreaterEqual(sampled.least_room(held), 0)
            if fewest:
                self.assertEqual(layers["count"], sampled.fewest(slack))
        return count

    def test_every_kind_reports_layers(self):
        sampled = 0
        for i, (name, width, lines) in enumerate(some(KINDS)):
            with self.subTest(name):
                text = with_lines((LIBRARY / f"{name}.toml").read_text(), "solve", lines)
                text += f"\n[layers]\nlink_width = {width}\npin_diameter = {width / 2}\n"
                done = run("solve", self.write(text), "--json", cwd=self.folder)
                self.assertLess(done.returncode, 2, done.stderr)
                document = json.loads(done.stdout)
                if jsonschema is not None:
                    jsonschema.validate(document, json.loads(SCHEMA.read_text()))
                self.assertGreater(len(document["designs"]), 0)
                for design in document["designs"]:
                    self.assertIn("layers", design)
                    self.assertFalse([check for check in design["constraints"] if check["name"] == "layers_max"])
                sampled += self.check_by_samples(document)
                if i % 3 > 0:
                    continue
                # The same file without layers has the same designs.
                plain = json.loads(run("solve", self.write(text.partition("\n[layers]")[0]), "--json",
                                       cwd=self.folder).stdout)
                self.assertEqual([design["mechanism"] for design in plain["designs"]],
                                 [design["mechanism"] for design in document["designs"]])
        self.assertGreater(sampled, 5)

    def limited(self, longest, width, limit="", status=0):
        text = ELLIPSE.format(longest=longest, width=width, limit=limit)
        return self.solved(self.write(text), status=status)

    def checks_of(self, document):
        return [next(check for check in design["constraints"] if check["name"] == "layers_max")
                for design in document["designs"]]

    def test_what_cannot_be_stacked_is_passed_over(self):
        free = self.limited(16, 1.5)
        self.assertIsNone(free["designs"][0]["layers"]["count"])
        self.assertTrue(any("block each other in every order" in note for note in free["notes"]))
        self.check_by_samples(free)
        best = self.limited(16, 1.5, "layers_max = 2")
        self.check_by_samples(best)
        for check in self.checks_of(best):
            self.assertEqual((check["label"], check["relation"], check["value"], check["bound"],
                              check["satisfied"]), ("layers", "<=", 2, 2, True))
        self.assertGreater(best["designs"][0]["error"]["rms"], free["designs"][0]["error"]["rms"])
        self.assertTrue(any("passed over" in note for note in best["notes"]), best["notes"])

    def test_six_bars_in_two_layers(self):
        text = (LIBRARY / "chain" / "watt-path-in-two-layers.toml").read_text()
        two = self.solved(self.write(with_lines(text, "solve", "starts = 24\ndesigns = 1")))
        self.assertEqual([design["layers"]["count"] for design in two["designs"]], [2])
        self.assertGreater(self.check_by_samples(two), 0)

    @whole_only
    def test_fewer_layers_cost_accuracy(self):
        """Six-bars that meet a path need more than two layers; in two the error is larger."""
        file = LIBRARY / "chain" / "watt-path-in-two-layers.toml"
        free = self.solved(self.write(file.read_text().replace("layers_max = 2", "")))
        self.assertGreater(free["designs"][0]["layers"]["count"], 2)
        two = self.solved(file)
        self.assertEqual({design["layers"]["count"] for design in two["designs"]}, {2})
        self.assertGreater(two["designs"][0]["error"]["rms"], 100 * free["designs"][0]["error"]["rms"])
        self.assertGreater(self.check_by_samples(two), 0)
        self.assertEqual(self.solved(file, "--threads", 3)["designs"], two["designs"])

    def test_two_layers_in_place_of_three(self):
        file = LIBRARY / "path" / "ellipse-in-two-layers.toml"
        free = self.solved(self.write(file.read_text().replace("layers_max = 2", "")))
        self.check_by_samples(free)
        self.assertEqual(free["designs"][0]["layers"]["count"], 3)
        two = self.solved(file)
        self.check_by_samples(two)
        self.assertEqual({design["layers"]["count"] for design in two["designs"]}, {2})
        cost = two["designs"][0]["error"]["rms"] / free["designs"][0]["error"]["rms"]
        self.assertTrue(1.02 < cost < 1.05, cost)

    def test_a_limit_that_all_meet_changes_nothing(self):
        free, limited = self.limited(80, 4), self.limited(80, 4, "layers_max = 14")
        self.assertAlmostEqual(limited["designs"][0]["error"]["rms"] / free["designs"][0]["error"]["rms"], 1, 3)
        self.assertFalse(any("passed over" in note for note in limited["notes"]))
        self.assertEqual(len(limited["designs"]), len(free["designs"]))

    def test_where_none_fits_the_fewest_are_reported(self):
        document = self.limited(12, 4, "transmission_angle_deg = [30, 150]\nlayers_max = 2", status=1)
        self.assertEqual(document["status"], "infeasible")
        self.check_by_samples(document)
        counts = [design["layers"]["count"] or 99 for design in document["designs"]]
        self.assertEqual(counts, sorted(counts))
        self.assertEqual(counts[0], 3)
        self.assertTrue(all(not check["satisfied"] for check in self.checks_of(document)))
        (note,) = [note for note in document["notes"] if note.startswith("No design was found whose links")]
        self.assertRegex(note, r"lie in 2 layers: of \d+ looked at none needs fewer than 3\.")
        self.assertTrue(any("keep design 1 from fewer layers" in note for note in document["notes"]))
        # Where the first of these collisions is, the parts touch.
        first = next(c for c in document["designs"][0]["layers"]["conflicts"] if c["why"] == "collision")
        self.assertGreaterEqual(first["first_at_deg"], 0)

    @whole_only
    def test_where_none_can_be_stacked(self):
        document = self.limited(8.5, 4, "layers_max = 14", status=1)
        self.check_by_samples(document)
        self.assertTrue(any("none has layers at all" in note for note in document["notes"]), document["notes"])
        self.assertEqual({check["value"] for check in self.checks_of(document)}, {"none"})

    def refusal(self, text):
        done = run("check", self.write(text), cwd=self.folder)
        self.assertEqual(done.returncode, 2, text)
        return done.stderr

    def test_bad_limits_and_sizes(self):
        good = ELLIPSE.format(longest=16, width=1.5, limit="layers_max = 2")
        self.assertEqual(run("check", self.write(good), cwd=self.folder).returncode, 0)
        for wrong in ("0", "1", "1.5", "15", "-2", '"two"', "true"):
            self.assertIn("from 2 to 14", self.refusal(good.replace("layers_max = 2", f"layers_max = {wrong}")))
        self.assertIn("constraints.layers_max is given without [layers]",
                      self.refusal(good.partition("[layers]")[0]))
        self.assertIn("wider than a link", self.refusal(good.replace("pin_diameter = 0.8", "pin_diameter = 3")))
        self.assertIn("crank", self.refusal(good + "widths = { crnk = 2 }"))
        self.assertIn("layers.thickness", self.refusal(good.replace("thickness = 3", "thickness = 0")))
        self.assertIn("layers.link_width is missing", self.refusal(good.replace("link_width = 1.5", "")))
        self.assertIn("layers_max", self.refusal(good + '[solve]\nobjectives = ["error", "transmission_angle"]'))
        timed = (LIBRARY / "path" / "eighteen-points.toml").read_text()
        timed = with_lines(timed, "solve", "certify = true").replace("[constraints]", "[constraints]\nlayers_max = 2")
        self.assertIn("certify", self.refusal(timed + "\n[layers]\nlink_width = 0.1\npin_diameter = 0.1\n"))
        cam = (LIBRARY / "cam" / "smallest-cam.toml").read_text()
        self.assertIn("layers", self.refusal(cam + "\n[layers]\nlink_width = 1\npin_diameter = 1\n"))
        front = (LIBRARY / "straight-line" / "search-front.toml").read_text()
        self.assertIn("front", self.refusal(with_lines(front, "constraints", "layers_max = 2")
                                            + "\n[layers]\nlink_width = 0.1\npin_diameter = 0.1\n"))

    def test_widths_of_single_links(self):
        text = ELLIPSE.format(longest=16, width=1, limit="") + "widths = { coupler = 2.5, rocker = 1.5 }\n"
        document = self.solved(self.write(text))
        self.check_by_samples(document)
        widths = {link["name"]: link["width"] for link in document["designs"][0]["layers"]["links"]}
        self.assertEqual(widths, {"crank": 1, "coupler": 2.5, "rocker": 1.5})

    def test_studies_know_the_metric(self):
        self.write(ELLIPSE.format(longest=16, width=1.5, limit="layers_max = 2"), "base.toml")
        study = self.write("""
kind = "study"
base = "base.toml"
[[vary]]
key = "layers.link_width"
values = [0.8, 1.5]
[output]
metrics = ["layers.count", "error.rms"]
""", "small.toml")
        done = run("sweep", study, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with contextlib.closing(sqlite3.connect(self.folder / "small.study.db")) as base:
            rows = base.execute('select "layers.count" from runs').fetchall()
        self.assertEqual(rows, [(2,), (2,)])

    def bill_of_page(self, name):
        page = (self.folder / f"{name}.report.html").read_text(encoding="utf-8")
        return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)[1])

    def check_bill(self, bill, *options):
        """The rows of a page are those of the CSV that an export writes."""
        done = run("export", *options, "--format", "json", "--parts", "--bill", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        (file,) = self.folder.glob("*.bill.csv")
        with open(file, newline="", encoding="utf-8") as opened:
            written = list(csv.DictReader(opened))
        file.unlink()
        self.assertEqual(len(written), len(bill["rows"]))
        self.assertGreater(len(written), 4)
        for row, cells in zip(bill["rows"], written):
            layers = "-".join(map(str, sorted({row["layers"][0], row["layers"][-1]})))
            self.assertEqual((cells["item"], cells["name"], int(cells["quantity"]), cells["layers"]),
                             (row["item"], row["name"], row["quantity"], layers))
            for name, cell in cells.items():
                if name in ("item", "name", "quantity", "layers"):
                    continue
                length = row.get(name.partition("_")[0])
                self.assertEqual(cell == "", length is None)
                if length is not None:
                    self.assertAlmostEqual(float(cell) / length, 1, 9)

    def test_bills_of_pages_are_those_of_exports(self):
        file = LIBRARY / "path" / "ellipse-in-two-layers.toml"
        self.assertEqual(run("solve", file, cwd=self.folder).returncode, 0)
        data = self.bill_of_page(file.stem)
        result = f"{file.stem}.result.json"
        self.assertGreater(len(data["designs"]), 1)
        for i, design in enumerate(data["designs"]):
            self.check_bill(design["bill"], result, "--design", i + 1)
        self.check_bill(data["designs"][0]["bill"], result, "--hole", 2, "--width", 4, "--thickness", 1.5)
        # Layers above the frame are those of the design.
        layers = {link["name"]: link["layer"] for link in data["result"]["designs"][0]["layers"]["links"]}
        self.assertEqual(layers, {row["name"]: row["layers"][0] - 1 for row in data["designs"][0]["bill"]["rows"]
                                  if row["item"] == "plate" and row["name"] != "frame"})

    def test_bills_of_analyses(self):
        file = LIBRARY / "analysis" / "klann-leg.toml"
        text = file.read_text() + "thickness = 0.05\nwidths = { crank = 0.3 }\n"
        written = self.write(text, "leg.toml")
        self.assertEqual(run("analyze", written, cwd=self.folder).returncode, 0)
        data = self.bill_of_page("leg")
        self.check_bill(data["bill"], "leg.result.json")
        self.assertTrue(any(row["item"] == "spacer" for row in data["bill"]["rows"]))
        crank = next(row for row in data["bill"]["rows"] if row["name"] == "crank")
        self.assertAlmostEqual(crank["width"], 0.3, 12)

    def test_a_design_can_be_analysed_with_its_layers(self):
        file = LIBRARY / "path" / "ellipse-in-two-layers.toml"
        self.assertEqual(run("solve", file, cwd=self.folder).returncode, 0)
        done = run("analyze", f"{file.stem}.result.json", "--design", 1, "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        designed = json.loads((self.folder / f"{file.stem}.result.json").read_text())["designs"][0]
        analysed = json.loads(done.stdout)["designs"][0]
        self.assertEqual(analysed["layers"]["links"], designed["layers"]["links"])


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    LIBRARY = pathlib.Path(sys.argv[2]).resolve()
    SCHEMA = pathlib.Path(sys.argv[3]).resolve()
    unittest.main(argv=sys.argv[:1])
