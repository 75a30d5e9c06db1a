"""Exported linkages from outside: drawings, tables and sketches, read by other programs.

Run as: export_linkages_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import csv
import json
import math
import random
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from exported_linkages import distance_to_segment, ExportedLinkages, run
from thinned import some

try:
    import ezdxf
except ImportError:
    ezdxf = None


class ExportLinkages(ExportedLinkages):
    def test_links_keep_their_lengths_at_every_position(self):
        """The table of positions against the lengths between the places of each link."""
        compared = 0
        for result in self.results:
            with self.subTest(result.name):
                document = self.document(result)
                columns = {column["name"]: column["values"] for column in document["positions"]}
                for link in document["links"]:
                    for length in link["lengths"]:
                        ends = [(columns.get(f"{length[end]}_x"), columns.get(f"{length[end]}_y"))
                                for end in ("from", "to")]
                        if None in (*ends[0], *ends[1]):
                            continue
                        for ax, ay, bx, by in list(zip(*ends[0], *ends[1]))[::20]:
                            if None not in (ax, ay, bx, by):
                                self.assertAlmostEqual(
                                    math.dist((ax, ay), (bx, by)) / max(length["length"], 1e-9), 1, 8)
                                compared += 1
        self.assertGreater(compared, 500)

    def test_dimensions_of_the_problem_are_in_the_document(self):
        document = self.document(self.named("crank-rocker"))
        given = json.loads(self.named("crank-rocker").read_text())["designs"][0]["mechanism"]
        places = document["position"]["places"]
        for key, ends in (("crank", "AB"), ("coupler", "BC"), ("rocker", "CD")):
            self.assertAlmostEqual(math.dist(*(places[end] for end in ends)), given[key], 12)
            self.assertEqual(document["dimensions"][key], given[key])
        self.assertEqual([places["A"], places["D"]], given["fixed_pivots"])

    def test_rows_are_those_of_the_analysis(self):
        for result in self.results:
            with self.subTest(result.name):
                with open(result.with_name(result.name.replace("result.json", "csv")), newline="") as file:
                    analysed = list(csv.DictReader(file))
                with open(self.export(result, "csv"), newline="") as file:
                    exported = list(csv.DictReader(file))
                self.assertEqual(len(exported), len(analysed))
                common = [name for name in exported[0] if name in analysed[0]]
                self.assertGreaterEqual(len(common), 3)
                for one, other in zip(exported, analysed):
                    self.assertEqual([one[name] for name in common], [other[name] for name in common])
        with open(self.export(self.named("crank-rocker"), "csv", "--steps", 8), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["crank_deg"]) for row in rows], [45 * i for i in range(9)])

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_drawings_show_the_positions_and_the_paths(self):
        for result in some(self.results):
            with self.subTest(result.name):
                document = self.document(result)
                drawing = ezdxf.readfile(self.export(result, "dxf"))
                self.assertEqual(drawing.audit().errors, [])
                self.assertEqual(drawing.dxfversion, "AC1015")
                space = drawing.modelspace()
                self.assertLessEqual(
                    {entity.dxf.layer for entity in space}, {layer.dxf.name for layer in drawing.layers}
                )
                centres = [tuple(circle.dxf.center)[:2] for circle in space.query("CIRCLE")]
                for place in document["position"]["places"].values():
                    self.assertLess(min(math.dist(place, centre) for centre in centres), 1e-9)
                paths = [[(x, y) for x, y, *_ in line.get_points()]
                         for line in space.query('LWPOLYLINE[layer=="PATHS"]')]
                self.assertEqual(paths, [[tuple(corner) for corner in path["corners"]]
                                         for path in document["paths"] if len(path["corners"]) > 2])
                old = ezdxf.readfile(self.export(result, "dxf", "--dxf-version", "r12"))
                self.assertEqual(old.dxfversion, "AC1009")
                self.assertEqual(old.audit().errors, [])
                self.assertEqual(
                    [tuple(circle.dxf.center)[:2] for circle in old.modelspace().query("CIRCLE")], centres
                )
                self.assertEqual(len(old.modelspace().query('POLYLINE[layer=="PATHS"]')), len(paths))

    def test_paths_hold_the_positions_of_the_table(self):
        """Every row lies on the polygon within the tolerance."""
        compared = 0
        for result in self.results:
            with self.subTest(result.name):
                tolerance = 0.001 * max(
                    (length["length"] for link in self.document(result)["links"]
                     for length in link["lengths"]), default=1)
                document = self.document(result, "--chord-tolerance", tolerance, "--steps", 100)
                columns = {column["name"]: column["values"] for column in document["positions"]}
                for path in document["paths"]:
                    polygons = [other for other in document["paths"] if other["point"] == path["point"]]
                    rows = zip(columns.get(f"{path['point']}_x", []), columns.get(f"{path['point']}_y", []))
                    for row in rows:
                        if None in row:
                            continue
                        least = math.inf
                        for polygon in polygons:
                            corners = polygon["corners"]
                            ends = corners[1:] + (corners[:1] if polygon["closed"] else [])
                            least = min(least, *(distance_to_segment(row, a, b)
                                                 for a, b in zip(corners, ends)))
                        self.assertLessEqual(least, tolerance * 1.01)
                        compared += 1
        self.assertGreater(compared, 1000)

    def test_links_are_drawn_on_their_layers(self):
        for name in ("klann-leg", "jansen-leg"):
            layers = json.loads(self.named(name).read_text())["designs"][0]["layers"]
            layer_of = {link["name"]: link["layer"] for link in layers["links"]}
            drawn = {link["name"]: link.get("layer") for link in self.document(self.named(name))["links"]}
            self.assertEqual(drawn, layer_of | {"frame": None})
            drawing = ezdxf.readfile(self.export(self.named(name), "dxf"))
            for layer in range(1, layers["count"] + 1):
                self.assertEqual(len(drawing.modelspace().query(f'*[layer=="LINKS_{layer}"]')),
                                 list(layer_of.values()).count(layer))
        self.assertNotIn("LINKS_1", self.export(self.named("shaper"), "dxf").read_text())

    def test_svg_shows_what_dxf_does(self):
        for result in self.results:
            with self.subTest(result.name):
                document = self.document(result)
                root = xml.etree.ElementTree.parse(self.export(result, "svg")).getroot()
                names = {"svg": "http://www.w3.org/2000/svg"}
                (group,) = root.findall("svg:g", names)
                self.assertEqual(group.get("transform"), "scale(1 -1)")
                paths = []
                for path in group.findall("svg:path[@class='paths']", names):
                    numbers = [float(text) for text in re.findall(r"[-+.\de]+", path.get("d"))]
                    paths.append([list(pair) for pair in zip(numbers[::2], numbers[1::2])])
                self.assertEqual(paths, [path["corners"] for path in document["paths"]])

    def test_sketches_have_a_box_for_each_link_and_an_edge_for_each_joint(self):
        text = r'"(?:[^"\\]|\\.)*"'
        node = re.compile(rf"  link\d+ \[label={text}(, \w+=\w+)*\];")
        edge = re.compile(rf"  link\d+ -- link\d+ \[label={text}(, style=dashed)?\];")
        for result in self.results:
            with self.subTest(result.name):
                document = self.document(result)
                file = self.export(result, "dot")
                lines = file.read_text().splitlines()
                self.assertRegex(lines[0], rf"^graph {text} {{$")
                self.assertEqual(lines[-1], "}")
                self.assertEqual(sum(bool(node.fullmatch(line)) for line in lines), len(document["links"]))
                self.assertEqual(sum(bool(edge.fullmatch(line)) for line in lines), len(document["joints"]))
                self.assertEqual(len(lines), len(document["links"]) + len(document["joints"]) + 4)
        if shutil.which("dot"):
            done = subprocess.run(["dot", "-Tsvg", file], capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_designs_of_a_synthesis(self):
        (self.folder / "quick.toml").write_text(
            'kind = "quick-return"\n[target]\ntime_ratio = 1.4\n[mechanism]\n'
            'type = "slider-crank"\nstroke = 100\noffset = 20\n')
        (self.folder / "path.toml").write_text(
            'kind = "path-generation"\n[target]\npoints = [[0, 0], [1, 0.4], [2, 0.5], [3, 0.2]]\n'
            '[solve]\nstarts = 2\n')
        for name in ("quick", "path"):
            done = run("solve", f"{name}.toml", "--quiet", cwd=self.folder)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            result = self.folder / f"{name}.result.json"
            positions = self.document(result)["positions"]
            self.assertGreater(len(positions), 3)
            for column in positions:
                self.assertNotIn(None, (column["values"][0], column["values"][-1]))
            if ezdxf is None:
                self.skipTest("ezdxf is not there: the drawings are not read")
            drawing = ezdxf.readfile(self.export(result, "dxf"))
            self.assertEqual(drawing.audit().errors, [])
            targets = [tuple(circle.dxf.center)[:2]
                       for circle in drawing.modelspace().query('CIRCLE[layer=="TARGET"]')]
            self.assertEqual(len(targets), 4 if name == "path" else 0)

    def test_drawings_and_sketches_carry_the_title(self):
        document = json.loads(self.named("crank-rocker").read_text())
        document["problem"]["title"] = "Presse <1> – 压力机"
        result = self.folder / "titled.result.json"
        result.write_text(json.dumps(document))
        parts = ("--parts", "--hole", ".01", "--width", ".02")
        for options, title in [((), "Presse <1> – 压力机"), (parts, "Presse <1> – 压力机: parts")]:
            root = xml.etree.ElementTree.parse(self.export(result, "svg", *options)).getroot()
            self.assertEqual(root.find("{http://www.w3.org/2000/svg}title").text, title)
        self.assertTrue(self.export(result, "dot").read_text().startswith('graph "Presse <1> – 压力机" {'))

    def test_a_table_that_the_time_limit_ended_is_reported(self):
        done = run("export", self.named("crank-rocker"), "--format", "csv", "--steps", 100000,
                   "--time-limit", "1e-9", "--out", "late", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        self.assertIn("note: the time limit ended the table after 0 of 100001 positions", done.stderr)

    def test_position(self):
        result = self.named("crank-rocker")
        places = self.document(result, "--position", 90)["position"]
        self.assertEqual(places["crank_deg"], 90)
        a, b = places["places"]["A"], places["places"]["B"]
        self.assertAlmostEqual(b[0], a[0], 12)
        self.assertGreater(b[1], a[1])
        self.assertEqual(self.document(result, "--position", 450)["position"]["places"], places["places"])

    def test_what_is_not_possible(self):
        result = self.named("crank-rocker")
        dxf = ("--format", "dxf")
        parts = (*dxf, "--parts")
        for options, message in [
            ((*dxf, "--curve", "pitch"), "--curve: is for cams"),
            (parts, "--parts: --hole and --width are missing; expected both with a LENGTH"),
            ((*parts, "--width", "5"), "--parts: --hole is missing; expected --hole LENGTH"),
            ((*parts, "--hole", "5"), "--parts: --width is missing"),
            ((*parts, "--hole", "5", "--width", "5"), "--width: 5 leaves nothing about a hole of 5"),
            ((*parts, "--hole", "500", "--width", "600"), "apart and would overlap; allowed is less"),
            ((*parts, "--hole", "0", "--width", "5"), "--hole: '0' is not possible"),
            ((*parts, "--hole", ".1", "--width", ".2", "--clearance", ".1"), "--clearance: 0.1 makes"),
            ((*parts, "--hole", ".1", "--width", ".2", "--gap", "-1"), "--gap: '-1'"),
            (("--format", "csv", "--parts", "--hole", ".1", "--width", ".2"), "--parts: are drawn"),
            ((*dxf, "--thickness", "3"), "--thickness: is that of parts; expected --parts"),
            ((*dxf, "--steps", "9"), "expected --format csv"),
            (("--format", "csv", "--position", "9"), "--position: is that of a drawing"),
            ((*dxf, "--position", "east"), "--position: 'east' is not possible"),
            ((*dxf, "--chord-tolerance", "1e9"), "--chord-tolerance: 1000000000 is not possible"),
            (("--format", "csv", "--chord-tolerance", "1"), "--chord-tolerance: is that of the paths"),
            (("--format", "dot", "--chord-tolerance", "1"), "--chord-tolerance: is that of the paths"),
            ((*parts, "--hole", ".1", "--width", ".2", "--chord-tolerance", "1"), "without --parts"),
            ((*dxf, "--design", "2"), "there is no design 2; allowed is --design from 1 to 1"),
        ]:
            with self.subTest(options):
                said = self.refusal(result, *options)
                self.assertIn(message, said)
                self.assertEqual(said.count("\n"), 1)
        self.assertIn("allowed is ", self.refusal(self.named("double-rocker"), *dxf, "--position", 180))

    def test_damaged_documents_end_in_a_message_or_a_drawing(self):
        """Numbers, words and tables of mechanisms replaced, of every type, with a fixed seed."""
        chance = random.Random(7)
        values = [None, 0, -1, 1e-300, 1e300, 1e99, "x", "frame", [], {}, [1e308, 1], True, "\u00e9\x01"]
        for result in some(self.results):
            document = json.loads(result.read_text())
            document["analysis"] = {}
            for _ in range(3):
                damaged = json.loads(json.dumps(document))
                mechanism = damaged["designs"][0]["mechanism"]
                table = mechanism if chance.random() < 0.7 else damaged["problem"]["drive"]
                table[chance.choice(sorted(table))] = chance.choice(values)
                file = self.folder / "damaged.result.json"
                file.write_text(json.dumps(damaged))
                options = chance.choice([["--format", "svg"], ["--format", "json"], ["--format", "dot"],
                                         ["--format", "dxf", "--parts", "--hole", "1e-3", "--width", "2e-3"]])
                done = run("export", file, *options, "--out", "made", cwd=self.folder)
                self.assertIn(done.returncode, (0, 2), (damaged["designs"], done.stderr))
                if done.returncode == 2:
                    self.assertRegex(done.stderr, "; |: ")


if __name__ == "__main__":
    del sys.argv[1:3]
    unittest.main()
