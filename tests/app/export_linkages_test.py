"""Exported linkages from outside: drawings, tables, sketches and parts, read by other programs.

Run as: export_linkages_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import csv
import itertools
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

try:
    import ezdxf
except ImportError:
    ezdxf = None

PROGRAM = ""
LIBRARY = pathlib.Path()

# Small enough for every linkage of the library, whose shortest link is this many times longer.
HOLE_SHARE, WIDTH_SHARE = 0.25, 0.5


def run(*arguments, cwd=None):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, timeout=60
    )


def arc_points(start, end, bulge, count=24):
    """Points of the arc of a DXF bulge, by its definition: tan of a quarter of the angle."""
    if bulge == 0:
        return [start]
    a, b = complex(*start), complex(*end)
    angle = 4 * math.atan(bulge)
    centre = (a + b) / 2 + 1j * (b - a) / (2 * math.tan(angle / 2)) if abs(bulge) != 1 else (a + b) / 2
    turn = [complex(math.cos(angle * i / count), math.sin(angle * i / count)) for i in range(count)]
    return [((centre + (a - centre) * t).real, (centre + (a - centre) * t).imag) for t in turn]


def outline_of(entity):
    """The polygon of a closed polyline with bulges, or of a circle."""
    if entity.dxftype() == "CIRCLE":
        x, y, _ = entity.dxf.center
        radius = entity.dxf.radius
        return [
            (x + radius * math.cos(i * math.pi / 36), y + radius * math.sin(i * math.pi / 36))
            for i in range(72)
        ]
    points = [(x, y, bulge) for x, y, _, _, bulge in entity.get_points()]
    polygon = []
    for (x, y, bulge), (nx, ny, _) in zip(points, points[1:] + points[:1]):
        polygon += arc_points((x, y), (nx, ny), bulge)
    return polygon


def distance_to_segment(p, a, b):
    p, a, b = complex(*p), complex(*a), complex(*b)
    way = b - a
    share = ((p - a) * way.conjugate()).real / abs(way) ** 2 if way else 0
    return abs(p - a - min(1, max(0, share)) * way)


def box(polygon):
    xs, ys = zip(*polygon)
    return min(xs), min(ys), max(xs), max(ys)


def holds(polygon, point):
    """Whether a polygon holds a point: an odd number of its sides is passed on the way out."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            inside = not inside
    return inside


class ExportLinkagesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.results, cls.made = [], {}
        for file in sorted((LIBRARY / "analysis").glob("*.toml")):
            done = run("analyze", file, "--quiet", "--out", "results", cwd=cls.folder)
            assert done.returncode == 0, done.stderr
            cls.results.append(cls.folder / "results" / f"{file.stem}.result.json")
        assert len(cls.results) >= 20, cls.results

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def export(self, result, form, *options):
        """The file that an export makes, once for all tests."""
        asked = (result, form, *options)
        if asked not in self.made:
            done = run("export", result, "--format", form, *options, "--out", f"made{len(self.made)}",
                       "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            (file,) = json.loads(done.stdout)["files"]
            self.made[asked] = self.folder / file
        return self.made[asked]

    def document(self, result, *options):
        return json.loads(self.export(result, "json", *options).read_text())

    def refusal(self, result, *options):
        done = run("export", result, *options, "--out", "refused", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def named(self, name):
        return self.folder / "results" / f"{name}.result.json"

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
        for result in self.results:
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

    def cut(self, result, form, *options):
        lengths = [length["length"] for link in self.document(result)["links"]
                   for length in link["lengths"]]
        least = min(lengths, default=1)
        return self.export(result, form, "--parts", "--hole", HOLE_SHARE * least, "--width",
                           WIDTH_SHARE * least, "--thickness", 3, *options)

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_parts_have_their_holes_at_the_lengths_of_the_links(self):
        for result in self.results:
            with self.subTest(result.name):
                lengths = {link["name"]: link["lengths"] for link in self.document(result)["links"]}
                told = json.loads(self.cut(result, "json").read_text())
                drawing = ezdxf.readfile(self.cut(result, "dxf"))
                self.assertEqual(drawing.audit().errors, [])
                space = drawing.modelspace()
                holes = [circle for circle in space.query('CIRCLE[layer=="HOLES"]')]
                self.assertTrue(all(math.isclose(2 * hole.dxf.radius, told["hole"]) for hole in holes))
                self.assertEqual(len(holes), sum(len(part["holes"]) for part in told["parts"]))
                drawn = [tuple(hole.dxf.center)[:2] for hole in holes]
                for part in told["parts"]:
                    at = {hole["name"]: hole["at"] for hole in part["holes"]}
                    for hole in at.values():
                        self.assertLess(min(math.dist(hole, centre) for centre in drawn), 1e-9)
                    for length in lengths[part["name"]]:
                        if length["from"] in at and length["to"] in at:
                            self.assertAlmostEqual(
                                math.dist(at[length["from"]], at[length["to"]]) / length["length"], 1, 8)

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_parts_keep_apart_and_hold_their_holes(self):
        for result in self.results:
            with self.subTest(result.name):
                told = json.loads(self.cut(result, "json").read_text())
                space = ezdxf.readfile(self.cut(result, "dxf")).modelspace()
                outlines = [outline_of(entity) for entity in space.query('*[layer=="OUTLINES"]')]
                self.assertEqual(len(outlines), len(told["parts"]))
                gap = 0.5 * told["width"]
                for one, other in itertools.combinations(map(box, outlines), 2):
                    apart = max(one[0] - other[2], other[0] - one[2], one[1] - other[3], other[1] - one[3])
                    self.assertGreaterEqual(apart, gap * (1 - 1e-9))
                # About every hole and slot there is half the width, less half the hole.
                for part, outline in zip(told["parts"], outlines):
                    spots = [hole["at"] for hole in part["holes"]]
                    spots += [slot[end] for slot in part["slots"] for end in ("from", "to")]
                    for spot in spots:
                        self.assertTrue(holds(outline, spot))
                        rim = min(distance_to_segment(spot, a, b)
                                  for a, b in zip(outline, outline[1:] + outline[:1]))
                        self.assertGreaterEqual(rim, 0.5 * told["width"] * 0.995)
                xml.etree.ElementTree.parse(self.cut(result, "svg"))
                old = ezdxf.readfile(self.cut(result, "dxf", "--dxf-version", "r12"))
                self.assertEqual(old.audit().errors, [])
                bulges = [vertex.dxf.bulge for line in old.modelspace().query("POLYLINE")
                          for vertex in line.vertices]
                self.assertTrue(any(bulges))

    def test_parts_pass_one_another_in_their_planes(self):
        """Bars of a crank-rocker as thick lines, at positions of the table."""
        told = json.loads(self.cut(self.named("crank-rocker"), "json").read_text())
        planes = {part["name"]: part["plane"] for part in told["parts"]}
        document = self.document(self.named("crank-rocker"))
        columns = {column["name"]: column["values"] for column in document["positions"]}
        bars = {"crank": "AB", "coupler": "BC", "rocker": "CD", "frame": "AD"}
        fixed = document["position"]["places"]

        def place(name, row):
            if f"{name}_x" not in columns:
                return fixed[name]
            return columns[f"{name}_x"][row], columns[f"{name}_y"][row]

        compared = 0
        for row in range(0, 361, 10):
            ends = {link: [place(name, row) for name in bar] for link, bar in bars.items()}
            for one, other in itertools.combinations(bars, 2):
                if planes[one] != planes[other]:
                    continue
                near = min(*(distance_to_segment(p, *ends[other]) for p in ends[one]),
                           *(distance_to_segment(p, *ends[one]) for p in ends[other]))
                self.assertGreater(near, told["width"])
                compared += 1
        self.assertGreaterEqual(compared, 37)
        self.assertEqual((planes["frame"], told["height"]), (1, 3 * told["planes"]))
        self.assertTrue(all(low >= 1 and high <= told["planes"] and high > low
                            for low, high in (pin["planes"] for pin in told["pins"])))

    def analysed(self, name, text):
        """The result of an analysis of this text."""
        (self.folder / f"{name}.toml").write_text('kind = "analysis"\n' + text)
        done = run("analyze", f"{name}.toml", "--quiet", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / f"{name}.result.json"

    def slots(self, result):
        document = self.document(result)
        return [slot for link in document["links"] for slot in link["slots"]]

    def test_slots_are_as_long_as_the_stroke(self):
        """No shorter, as the pin would jam, against what the analysis tells of the output."""
        seen = 0
        for result in self.results:
            stroke = json.loads(result.read_text())["designs"][0]["metrics"].get("output_stroke")
            lengths = [math.dist(slot["from"], slot["to"]) for slot in self.slots(result)]
            if stroke is None or not lengths:
                continue
            with self.subTest(result.name):
                nearest = min(lengths, key=lambda length: abs(length - stroke))
                self.assertGreaterEqual(nearest, stroke)
                self.assertLessEqual(nearest, stroke * (1 + 1e-6))
                seen += 1
        self.assertGreaterEqual(seen, 2)

    def test_slots_of_many_turns(self):
        """The stroke of an offset slider-crank by Pythagoras, for any number of turns."""
        stroke = math.sqrt(230**2 - 25**2) - math.sqrt(30**2 - 25**2)
        for start, end in [(0, 360), (0, 36000), (-32400, 32400), (7200, -100)]:
            with self.subTest((start, end)):
                result = self.analysed(
                    "turns", '[mechanism]\ntype = "slider-crank"\npivot = [0, 0]\ncrank = 100\n'
                    f'coupler = 130\noffset = 25\n[drive]\nstart_deg = {start}\nend_deg = {end}\n')
                (slot,) = self.slots(result)
                length = math.dist(slot["from"], slot["to"])
                self.assertGreaterEqual(length, stroke * (1 - 1e-12))
                self.assertLessEqual(length, stroke * (1 + 1e-8))
                paths = [path["point"] for path in self.document(result)["paths"]]
                self.assertEqual(len(paths), len(set(paths)))

    def test_planes_with_the_frame_between(self):
        """Cranks that turn fully on both sides of the frame: none meets a pin."""
        for name in ("double-crank", "guide-bar-rotating"):
            with self.subTest(name):
                told = json.loads(self.cut(self.named(name), "json").read_text())
                frame = next(part for part in told["parts"] if part["name"] == "frame")
                self.assertLess(1, frame["plane"])
                self.assertLess(frame["plane"], told["planes"])

    def test_labels_keep_off_holes_and_cuts(self):
        """Texts as boxes of 0.6 of their height for each letter, against all that is cut."""
        for result in self.results:
            with self.subTest(result.name):
                told = json.loads(self.cut(result, "json").read_text())
                root = xml.etree.ElementTree.parse(self.cut(result, "svg")).getroot()
                labels = [text for text in root.iter("{http://www.w3.org/2000/svg}text")]
                self.assertEqual(len(labels), len(told["parts"]))
                view = [float(number) for number in root.get("viewBox").split()]
                for label in labels:
                    x, y, scale = map(float, re.match(
                        r"translate\((\S+) (\S+)\) scale\((\S+) ", label.get("transform")).groups())
                    height, width = 16 * scale, 9.6 * scale * len(label.text)
                    self.assertLessEqual(x + width, view[0] + view[2])
                    for part in told["parts"]:
                        for hole in part["holes"]:
                            dx = max(x - hole["at"][0], 0, hole["at"][0] - x - width)
                            dy = max(y - hole["at"][1], 0, hole["at"][1] - y - height)
                            self.assertGreaterEqual(math.hypot(dx, dy), 0.5 * told["hole"])

    def test_names_of_parts_are_each_once(self):
        for result in self.results:
            with self.subTest(result.name):
                told = json.loads(self.cut(result, "json").read_text())
                for table in (told["pins"], *(part["holes"] for part in told["parts"])):
                    names = [entry["name"] for entry in table]
                    self.assertEqual(len(names), len(set(names)))

    def test_every_place_is_named_in_the_drawing(self):
        """Also what lies at another's position, as C of a scotch yoke."""
        for result in self.results:
            with self.subTest(result.name):
                root = xml.etree.ElementTree.parse(self.export(result, "svg")).getroot()
                labels = [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")]
                self.assertEqual(sorted(labels), sorted(self.document(result)["position"]["places"]))

    def test_thin_walls_are_reported(self):
        done = run("export", self.named("crank-rocker"), "--format", "svg", "--parts", "--hole", 0.1,
                   "--width", 0.119, "--out", "thin", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("less than a tenth of the hole", done.stdout + done.stderr)

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
            (parts, "--parts: --hole is missing; expected --hole LENGTH"),
            ((*parts, "--hole", "5"), "--parts: --width is missing"),
            ((*parts, "--hole", "5", "--width", "5"), "--width: 5 leaves nothing about a hole of 5"),
            ((*parts, "--hole", "500", "--width", "600"), "apart and would overlap; allowed is less"),
            ((*parts, "--hole", "0", "--width", "5"), "--hole: '0' is not possible"),
            ((*parts, "--hole", ".1", "--width", ".2", "--clearance", ".1"), "--clearance: 0.1 makes"),
            ((*parts, "--hole", ".1", "--width", ".2", "--gap", "-1"), "--gap: '-1'"),
            (("--format", "csv", "--parts", "--hole", ".1", "--width", ".2"), "--parts: are drawn"),
            ((*dxf, "--thickness", "3"), "--thickness: is that of parts; expected --parts"),
            ((*dxf, "--steps", "9"), "expected --format csv or json"),
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
                self.assertEqual(said.count("\n"), 2 if options == parts else 1)
        self.assertIn("allowed is ", self.refusal(self.named("double-rocker"), *dxf, "--position", 180))

    def test_damaged_documents_end_in_a_message_or_a_drawing(self):
        """Numbers, words and tables of mechanisms replaced, of every type, with a fixed seed."""
        chance = random.Random(7)
        values = [None, 0, -1, 1e-300, 1e300, 1e99, "x", "frame", [], {}, [1e308, 1], True, "\u00e9\x01"]
        for result in self.results:
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
    PROGRAM, LIBRARY = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
