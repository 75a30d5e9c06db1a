"""Parts of exported linkages from outside: their holes, slots, planes and labels, by drawings read again.

Run as: export_parts_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import itertools
import json
import math
import re
import sys
import unittest
import xml.etree.ElementTree

from drawn_outlines import box, holds, outline_of
from exported_linkages import distance_to_segment, ExportedLinkages, run

try:
    import ezdxf
except ImportError:
    ezdxf = None

# Small enough for every linkage of the library, whose shortest link is this many times longer.
HOLE_SHARE, WIDTH_SHARE = 0.25, 0.5


class ExportParts(ExportedLinkages):
    def cut(self, result, form, *options):
        lengths = [length["length"] for link in self.document(result)["links"]
                   for length in link["lengths"]]
        least = min(lengths, default=1)
        return self.export(result, form, "--parts", "--hole", HOLE_SHARE * least, "--width",
                           WIDTH_SHARE * least, "--thickness", 3, *options)

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_parts_have_their_holes_at_the_lengths_of_the_links(self):
        for result in self.plates:
            with self.subTest(result.name):
                lengths = {link["name"]: link["lengths"] for link in self.document(result)["links"]}
                sheet = json.loads(self.cut(result, "json").read_text())
                drawing = ezdxf.readfile(self.cut(result, "dxf"))
                self.assertEqual(drawing.audit().errors, [])
                space = drawing.modelspace()
                holes = [circle for circle in space.query('CIRCLE[layer=="HOLES"]')]
                self.assertTrue(all(math.isclose(2 * hole.dxf.radius, sheet["hole"]) for hole in holes))
                self.assertEqual(len(holes), sum(len(part["holes"]) for part in sheet["parts"]))
                drawn = [tuple(hole.dxf.center)[:2] for hole in holes]
                for part in sheet["parts"]:
                    at = {hole["name"]: hole["at"] for hole in part["holes"]}
                    for hole in at.values():
                        self.assertLess(min(math.dist(hole, centre) for centre in drawn), 1e-9)
                    for length in lengths[part["name"]]:
                        if length["from"] in at and length["to"] in at:
                            self.assertAlmostEqual(
                                math.dist(at[length["from"]], at[length["to"]]) / length["length"], 1, 8)

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_parts_keep_apart_and_hold_their_holes(self):
        for result in self.plates:
            with self.subTest(result.name):
                sheet = json.loads(self.cut(result, "json").read_text())
                space = ezdxf.readfile(self.cut(result, "dxf")).modelspace()
                outlines = [outline_of(entity) for entity in space.query('*[layer=="OUTLINES"]')]
                self.assertEqual(len(outlines), len(sheet["parts"]))
                gap = 0.5 * sheet["width"]
                for one, other in itertools.combinations(map(box, outlines), 2):
                    apart = max(one[0] - other[2], other[0] - one[2], one[1] - other[3], other[1] - one[3])
                    self.assertGreaterEqual(apart, gap * (1 - 1e-9))
                # About every hole and slot there is half the width, less half the hole.
                for part, outline in zip(sheet["parts"], outlines):
                    spots = [hole["at"] for hole in part["holes"]]
                    spots += [slot[end] for slot in part["slots"] for end in ("from", "to")]
                    for spot in spots:
                        self.assertTrue(holds(outline, spot))
                        rim = min(distance_to_segment(spot, a, b)
                                  for a, b in zip(outline, outline[1:] + outline[:1]))
                        self.assertGreaterEqual(rim, 0.5 * sheet["width"] * 0.995)
                xml.etree.ElementTree.parse(self.cut(result, "svg"))
                old = ezdxf.readfile(self.cut(result, "dxf", "--dxf-version", "r12"))
                self.assertEqual(old.audit().errors, [])
                bulges = [vertex.dxf.bulge for line in old.modelspace().query("POLYLINE")
                          for vertex in line.vertices]
                self.assertTrue(any(bulges))

    def test_parts_pass_one_another_in_their_planes(self):
        """Bars of a crank-rocker as thick lines, at positions of the table."""
        sheet = json.loads(self.cut(self.named("crank-rocker"), "json").read_text())
        planes = {part["name"]: part["plane"] for part in sheet["parts"]}
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
                self.assertGreater(near, sheet["width"])
                compared += 1
        self.assertGreaterEqual(compared, 37)
        self.assertEqual((planes["frame"], sheet["height"]), (1, 3 * sheet["planes"]))
        self.assertTrue(all(low >= 1 and high <= sheet["planes"] and high > low
                            for low, high in (pin["planes"] for pin in sheet["pins"])))

    def slots(self, result):
        document = self.document(result)
        return [slot for link in document["links"] for slot in link["slots"]]

    def test_slots_are_as_long_as_the_stroke(self):
        """No shorter, as the pin would jam, against what the analysis tells of the output."""
        seen = 0
        for result in self.plates:
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

    def test_a_slot_that_takes_the_hole_of_a_point_is_noted(self):
        """K of the rod is 0.02 beyond the end of the block's way: a hole and a slot of that width meet."""
        result = self.named("oscillating-block")
        for hole, has in ((0.019, True), (0.021, False)):
            done = run("export", result, "--format", "json", "--parts", "--hole", hole, "--width", 0.08, "--out", "point",
                       cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            parts = json.loads((self.folder / "point" / "oscillating-block.parts.json").read_text())["parts"]
            rod = next(part for part in parts if part["name"] == "rod")
            self.assertEqual("K" in [hole["name"] for hole in rod["holes"]], has)
            self.assertEqual("the point K of rod has no hole" in done.stderr + done.stdout, not has)

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
                document = json.loads(self.cut(self.named(name), "json").read_text())
                frame = next(part for part in document["parts"] if part["name"] == "frame")
                self.assertLess(1, frame["plane"])
                self.assertLess(frame["plane"], document["planes"])

    def test_labels_keep_off_holes_and_cuts(self):
        """Texts as boxes of 0.6 of their height for each letter, against all that is cut."""
        for result in self.plates:
            with self.subTest(result.name):
                document = json.loads(self.cut(result, "json").read_text())
                root = xml.etree.ElementTree.parse(self.cut(result, "svg")).getroot()
                labels = [text for text in root.iter("{http://www.w3.org/2000/svg}text")]
                self.assertEqual(len(labels), len(document["parts"]))
                view = [float(number) for number in root.get("viewBox").split()]
                for label in labels:
                    x, y, scale = map(float, re.match(
                        r"translate\((\S+) (\S+)\) scale\((\S+) ", label.get("transform")).groups())
                    height, width = 16 * scale, 9.6 * scale * len(label.text)
                    self.assertLessEqual(x + width, view[0] + view[2])
                    for part in document["parts"]:
                        for hole in part["holes"]:
                            dx = max(x - hole["at"][0], 0, hole["at"][0] - x - width)
                            dy = max(y - hole["at"][1], 0, hole["at"][1] - y - height)
                            self.assertGreaterEqual(math.hypot(dx, dy), 0.5 * document["hole"])

    def test_names_of_parts_are_each_once(self):
        for result in self.plates:
            with self.subTest(result.name):
                document = json.loads(self.cut(result, "json").read_text())
                for table in (document["pins"], *(part["holes"] for part in document["parts"])):
                    names = [entry["name"] for entry in table]
                    self.assertEqual(len(names), len(set(names)))

    def test_every_place_is_named_in_the_drawing(self):
        """Also what lies at another's position, as C of a scotch yoke."""
        for result in self.plates:
            with self.subTest(result.name):
                root = xml.etree.ElementTree.parse(self.export(result, "svg")).getroot()
                labels = [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")]
                self.assertEqual(sorted(labels), sorted(self.document(result)["position"]["places"]))

    def test_thin_walls_are_reported(self):
        done = run("export", self.named("crank-rocker"), "--format", "svg", "--parts", "--hole", 0.1,
                   "--width", 0.119, "--out", "thin", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("less than a tenth of the hole", done.stdout + done.stderr)


if __name__ == "__main__":
    del sys.argv[1:3]
    unittest.main()
