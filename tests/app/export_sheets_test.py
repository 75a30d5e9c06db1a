"""Parts as a workshop cuts them: kerf, engraved names, layers and sheets, from outside.

Run as: export_sheets_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import itertools
import json
import random
import sys
import unittest

from drawn_outlines import apart, area, box, corners_of, holds, outline_of
from exported_linkages import CYLINDERS, LIBRARY, run
from part_sheets import PartSheets, shortest
from thinned import some

try:
    import ezdxf
except ImportError:
    ezdxf = None

SIX_BARS = ("watt-six-bar", "stephenson-six-bar", "klann-leg", "jansen-leg")


@unittest.skipIf(ezdxf is None, "needs ezdxf")
class ExportSheets(PartSheets):
    def test_kerf_moves_lines_and_arcs(self):
        """The same corners and radii as without, moved by half of it."""
        for result in map(self.named, ("crank-rocker", "shaper", "klann-leg", "oscillating-block")):
            with self.subTest(result.name):
                options = self.sizes(result)
                kerf = 0.1 * options[2]
                plain, plain_space = self.sheet(result, *options, "--labels", "none")
                cut, cut_space = self.sheet(result, *options, "--labels", "none", "--kerf", kerf)
                self.assertEqual(cut["kerf"], kerf)
                self.assertEqual(cut["bill"], plain["bill"])
                self.assertEqual([h["diameter"] for p in cut["parts"] for h in p["holes"]],
                                 [h["diameter"] for p in plain["parts"] for h in p["holes"]])
                for one, other in zip(plain_space.query('CIRCLE[layer=="HOLES"]'),
                                      cut_space.query('CIRCLE[layer=="HOLES"]')):
                    self.assertAlmostEqual(other.dxf.radius, one.dxf.radius - kerf / 2, 12)
                for layer, by in (("OUTLINES", kerf / 2), ("SLOTS", -kerf / 2)):
                    pairs = list(zip(plain_space.query(f'LWPOLYLINE[layer=="{layer}"]'),
                                     cut_space.query(f'LWPOLYLINE[layer=="{layer}"]')))
                    for one, other in pairs:
                        self.check_moved(corners_of(one), corners_of(other), by)

    def check_moved(self, plain, cut, by):
        """Arcs about the same corners of the hull, whose radii differ by that."""
        self.assertEqual(len(plain), len(cut))

        def arcs(corners):
            return [ezdxf.math.bulge_to_arc(a[:2], b[:2], a[2]) for a, b in
                    zip(corners, corners[1:] + corners[:1]) if a[2]]

        (x0, y0), (x1, y1) = (tuple(arcs(corners)[0][0])[:2] for corners in (plain, cut))
        for one, other in zip(arcs(plain), arcs(cut)):
            self.assertAlmostEqual(other[3] - one[3], by, 9)
            self.assertAlmostEqual(one[0].x - x0, other[0].x - x1, 8)
            self.assertAlmostEqual(one[0].y - y0, other[0].y - y1, 8)

    def test_kerfs_as_wide_as_holes(self):
        result = self.named("crank-rocker")
        self.assertIn("--kerf: 0.3 leaves nothing of holes of 0.3",
                      self.refusal(result, "--format", "dxf", "--parts", "--hole", 0.3, "--width", 0.8, "--kerf", 0.3))
        self.assertIn("--kerf: of a linkage only parts are cut",
                      self.refusal(result, "--format", "dxf", "--kerf", 0.3))
        self.assertIn("--bore: is for gears and cams", self.refusal(result, "--format", "dxf", "--bore", 3))

    def test_engraved_names(self):
        """Open strokes, on the part clear of its cuts or all of them off every part."""
        inside = 0
        for result in some(self.plates):
            with self.subTest(result.name):
                options = (*self.sizes(result), "--labels", "stroke")
                document, space = self.sheet(result, *options)
                self.assertEqual(len(space.query("TEXT")), 0)
                strokes = [corners_of(line) if line.dxftype() == "LWPOLYLINE" else
                           [(end.x, end.y, 0) for end in (line.dxf.start, line.dxf.end)]
                           for line in space.query('*[layer=="ENGRAVE"]')]
                points = [point[:2] for stroke in strokes for point in stroke]
                self.assertGreater(len(points), 30 * len(document["parts"]))
                self.assertFalse(any(line.closed for line in space.query('LWPOLYLINE[layer=="ENGRAVE"]')))
                outlines = list(map(outline_of, self.outlines(space)))
                cuts = [outline_of(cut) for cut in space.query('*[layer=="HOLES"]')]
                cuts += [outline_of(cut) for cut in space.query('*[layer=="SLOTS"]')]
                for x, y in points:
                    around = [o for o in outlines if box(o)[0] <= x <= box(o)[2] and box(o)[1] <= y <= box(o)[3]]
                    if any(holds(outline, (x, y)) for outline in around):
                        inside += 1
                    for cut in cuts:
                        low_x, low_y, high_x, high_y = box(cut)
                        if low_x <= x <= high_x and low_y <= y <= high_y:
                            self.assertFalse(holds(cut, (x, y)))
        self.assertGreater(inside, 500)

    def test_labels_can_be_left_out(self):
        _, space = self.sheet(self.named("klann-leg"), *self.sizes(self.named("klann-leg")), "--labels", "none")
        self.assertEqual({entity.dxf.layer for entity in space}, {"OUTLINES", "HOLES"})

    def test_layers_are_those_of_the_analysis(self):
        """With the frame as layer 1 below them, for each mechanism that the analysis can layer."""
        compared = blocked = 0
        for result in self.plates:
            problem = json.loads(result.read_text())["problem"]
            if "layers" in problem or any(dyad["type"] == "group" for dyad in problem["mechanism"].get("dyad", ())):
                continue  # layers are not computed of groups
            least = shortest(self.document(result))
            source = LIBRARY / "analysis" / f"{result.name.split('.')[0]}.toml"
            again = self.folder / f"layered-{source.name}"
            again.write_text(
                f"{source.read_text()}\n[layers]\nlink_width = {0.5 * least}\npin_diameter = {0.25 * least}\n")
            done = run("analyze", again.name, "--quiet", "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            layers = json.loads(done.stdout)["designs"][0].get("layers")
            parts = self.document(result, *self.sizes(result))
            names = {part["name"] for part in parts["parts"]} - {"frame"}
            guided = any("guide" in pin["name"] for pin in parts["pins"])
            if layers is None or guided or {link["name"] for link in layers["links"]} != names:
                continue
            with self.subTest(result.name):
                if layers["count"] is None:
                    self.assertFalse(parts["fewest"])
                    blocked += 1
                    continue
                self.assertTrue(parts["fewest"])
                self.assertEqual(parts["planes"], layers["count"] + 1)
                self.assertEqual({p["name"]: p["plane"] for p in parts["parts"] if p["name"] != "frame"},
                                 {link["name"]: link["layer"] + 1 for link in layers["links"]})
                compared += 1
        self.assertGreaterEqual(compared, 8)
        self.assertGreaterEqual(blocked, 1)

    def test_what_blocks_layers_is_named(self):
        result = self.named("double-crank")
        done = run("export", result, "--format", "json", *self.sizes(result), "--out", "blocked", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no number of layers suffices", done.stderr)
        self.assertIn("the pin", done.stderr)

    def check_sheet(self, result, *options):
        """No two outlines nearer than the gap; all in the sheets, clear of their edges or on them."""
        document, space = self.sheet(result, *options)
        sheets = [box([c[:2] for c in corners_of(line)]) for line in space.query('*[layer=="SHEETS"]')]
        self.assertEqual(len(sheets), document["sheets"]["count"])
        outlines = [outline_of(entity, 12) for entity in self.outlines(space)]
        gap = options[options.index("--gap") + 1]
        hair = 1e-9 * document["sheets"]["width"]
        taken = {}
        for part, outline in zip(document["parts"], outlines):
            low_x, low_y, high_x, high_y = sheets[part["sheet"] - 1]
            a, b, c, d = box(outline)
            self.assertTrue(low_x - hair <= a and low_y - hair <= b and c <= high_x + hair and d <= high_y + hair)
            taken.setdefault(part["sheet"], []).append(outline)
        for one, other in itertools.combinations(outlines, 2):
            self.assertGreaterEqual(apart(one, other), gap - hair)
        self.assertEqual(sorted(taken), list(range(1, len(sheets) + 1)))
        if "kerf" in document:
            return document
        whole = sum(map(area, outlines)) / (len(sheets) * document["sheets"]["width"] * document["sheets"]["height"])
        self.assertAlmostEqual(document["sheets"]["utilisation"], whole, delta=0.01 * whole)
        return document

    def test_sheets_of_random_mechanisms(self):
        draw = random.Random(11)
        several = 0
        for number in range(10):
            name = draw.choice(SIX_BARS)
            result = self.named(name)
            hole, width = self.sizes(result)[2], self.sizes(result)[4] * draw.uniform(1, 1.5)
            lengths = [length["length"] for link in self.document(result)["links"] for length in link["lengths"]]
            largest = max(lengths) + 1.2 * width
            labels = draw.choice(("none", "text", "stroke"))
            # A short part with a long name beside it may be longer than the longest part.
            least, most = (1.01, 1.4) if labels == "none" else (1.3, 3)
            size = f"{largest * draw.uniform(least, most):.9g}x{largest * draw.uniform(least, most):.9g}"
            with self.subTest(number=number, name=name, size=size, labels=labels):
                document = self.check_sheet(result, "--parts", "--hole", hole, "--width", width, "--labels", labels,
                                            "--sheet", size, "--gap", width * draw.uniform(0, 0.5),
                                            *draw.choice(((), ("--spacers",), ("--kerf", 0.2 * hole))))
                several += document["sheets"]["count"] > 1
        self.assertGreaterEqual(several, 1)

    def test_packing_is_dense_where_that_is_possible(self):
        """Four bars that just fit side by side on a sheet, turned by a right angle."""
        result = self.in_millimetres()
        document, _ = self.sheet(result, "--parts", "--hole", 4, "--width", 10, "--labels", "none", "--gap", 2,
                                 "--sheet", "46x100")
        self.assertEqual(document["sheets"]["count"], 1)
        wider, _ = self.sheet(result, "--parts", "--hole", 4, "--width", 10, "--labels", "none", "--gap", 2,
                              "--sheet", "45x100")
        self.assertEqual(wider["sheets"]["count"], 2)

    def test_a_driving_cylinder_is_on_no_sheet(self):
        """Parts beside one that is bought, on a sheet that holds the longest upright only."""
        for name in CYLINDERS:
            with self.subTest(name):
                result = self.named(name)
                hole, width = self.sizes(result)[2], self.sizes(result)[4]
                options = ("--parts", "--hole", hole, "--width", width, "--labels", "none", "--gap", 0)
                boxes = [box(outline_of(line)) for line in self.outlines(self.sheet(result, *options)[1])]
                longest = max(max(c - a, d - b) for a, b, c, d in boxes)
                across = max(min(c - a, d - b) for a, b, c, d in boxes)
                self.check_sheet(result, *options, "--sheet", f"{1.2 * across:.9g}x{1.01 * longest:.9g}")
                self.assertIn("too small for the part",
                              self.refusal(result, "--format", "json", *options, "--sheet",
                                           f"{1.2 * across:.9g}x{0.99 * longest:.9g}"))

    def test_parts_larger_than_the_sheet(self):
        result = self.in_millimetres()
        text = self.refusal(result, "--format", "dxf", "--parts", "--hole", 4, "--width", 10, "--sheet", "95x95")
        for part in ("--sheet: 95x95 is too small for the part coupler", "100x10"):
            self.assertIn(part, text)
        for size in ("10", "10x", "x10", "10x-3", "axb", "10x20x30"):
            self.assertIn("a width and a height such as 600x400",
                          self.refusal(result, "--format", "dxf", "--parts", "--hole", 4, "--width", 10, "--sheet", size))

    def test_sizes_beyond_all_measure(self):
        result = self.named("crank-rocker")
        for option, value in (("--width", 1e30), ("--gap", 1e12), ("--sheet", "1e20x5")):
            sizes = {"--hole": 0.1, "--width": 0.5, option: value}
            self.assertIn(f"{option}: ", self.refusal(
                result, "--format", "dxf", "--parts", *(word for pair in sizes.items() for word in pair)))

    def test_options_of_parts_alone(self):
        result = self.named("crank-rocker")
        for option in (("--sheet", "10x10"), ("--labels", "none"), ("--bearing", "608"), ("--washer", 1), ("--bill",),
                       ("--spacers",)):
            self.assertIn("expected --parts with it", self.refusal(result, "--format", "dxf", *option))
        self.assertIn("none, text or stroke", self.refusal(
            result, "--format", "dxf", "--parts", "--hole", 0.1, "--width", 0.5, "--labels", "big"))


if __name__ == "__main__":
    del sys.argv[1:3]
    unittest.main()
