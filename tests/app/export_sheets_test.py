"""Parts as a workshop cuts them: kerf, engraved names, layers, bearings, bill and sheets, from outside.

Run as: export_sheets_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import csv
import itertools
import json
import math
import random
import sys
import unittest

from drawn_outlines import apart, area, box, corners_of, holds, outline_of
from exported_linkages import CYLINDERS, distance_to_segment, ExportedLinkages, LIBRARY, run

try:
    import ezdxf
except ImportError:
    ezdxf = None

SIX_BARS = ("watt-six-bar", "stephenson-six-bar", "klann-leg", "jansen-leg")


def shortest(document):
    return min((length["length"] for link in document["links"] for length in link["lengths"]), default=1)


@unittest.skipIf(ezdxf is None, "needs ezdxf")
class ExportSheets(ExportedLinkages):
    def sizes(self, result, hole=0.25, width=0.5):
        least = shortest(self.document(result))
        return "--parts", "--hole", hole * least, "--width", width * least

    def sheet(self, result, *options):
        """The document and the drawing of parts."""
        document = json.loads(self.export(result, "json", *options).read_text())
        drawing = ezdxf.readfile(self.export(result, "dxf", *options))
        self.assertEqual(drawing.audit().errors, [])
        return document, drawing.modelspace()

    def outlines(self, space):
        return list(space.query('*[layer=="OUTLINES"]'))

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
        for result in self.plates:
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
        self.assertGreater(inside, 1000)

    def test_labels_can_be_left_out(self):
        _, space = self.sheet(self.named("klann-leg"), *self.sizes(self.named("klann-leg")), "--labels", "none")
        self.assertEqual({entity.dxf.layer for entity in space}, {"OUTLINES", "HOLES"})

    def test_layers_are_those_of_the_analysis(self):
        """With the frame as layer 1 below them, for each mechanism that the analysis can layer."""
        compared = blocked = 0
        for result in self.plates:
            problem = json.loads(result.read_text())["problem"]
            if "layers" in problem:
                continue
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

    def test_bill_of_material(self):
        for name in ("crank-rocker", "klann-leg", "jansen-leg", "shaper"):
            result = self.named(name)
            options = self.sizes(result)
            thick, washer = 0.1 * options[4], 0.02 * options[4]
            done = run("export", result, "--format", "json", *options, "--thickness", thick, "--washer", washer,
                       "--bill", "--out", "billed", "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(json.loads(done.stdout)["files"]), 2)
            document = json.loads((self.folder / "billed" / f"{name}.parts.json").read_text())
            with open(self.folder / "billed" / f"{name}.bill.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual([(row["item"], row["name"], int(row["quantity"])) for row in rows],
                             [(row["item"], row["name"], row["quantity"]) for row in document["bill"]])
            plates = {row["name"]: row for row in document["bill"] if row["item"] == "plate"}
            planes = {part["name"]: part["plane"] for part in document["parts"]}
            self.assertEqual({n: row["layers"] for n, row in plates.items()}, {n: [p] for n, p in planes.items()})
            for part in document["parts"]:
                spots = [hole["at"] for hole in part["holes"]]
                spots += [slot[end] for slot in part["slots"] for end in ("from", "to")]
                far = max((math.dist(a, b) for a, b in itertools.combinations(spots, 2)), default=0)
                row = plates[part["name"]]
                # A rectangle about the ends is no shorter than the longest distance in its direction.
                self.assertLessEqual(far / math.sqrt(2) + options[4], row["length"] * (1 + 1e-9))
                self.assertLessEqual(row["length"], far + options[4] * (1 + 1e-9))
                self.assertGreaterEqual(row["width"], options[4] * (1 - 1e-9))
            for pin in document["pins"]:
                held = sorted(planes[part] for part in pin["parts"])
                low, high = held[0], held[-1]
                (row,) = [r for r in document["bill"] if (r["item"], r["name"]) == ("pin", pin["name"])]
                self.assertAlmostEqual(row["length"], (high - low + 1) * thick + (high - low) * washer, 9)
                spacers = [r["quantity"] for r in document["bill"] if (r["item"], r["name"]) == ("spacer", pin["name"])]
                crossed = high - low + 1 - len(set(held))
                self.assertIn(spacers, ([crossed] if crossed else [], []))
                washers = [r["quantity"] for r in document["bill"] if (r["item"], r["name"]) == ("washer", pin["name"])]
                self.assertEqual(sum(washers), high - low)
            self.assertAlmostEqual(document["height"], document["planes"] * thick + (document["planes"] - 1) * washer, 9)

    def test_spacers_are_rings_that_pass_all_links(self):
        """At positions of the table, links as thick lines between all their holes."""
        seen = 0
        for result in self.plates:
            options = (*self.sizes(result), "--spacers", "--thickness", 1)
            done = run("export", result, "--format", "json", *options, "--out", "ringed", cwd=self.folder)
            if done.returncode != 0 or "needs shoulders" in done.stderr:
                continue
            document, space = self.sheet(result, *options)
            spacers = [row for row in document["bill"] if row["item"] == "spacer"]
            rings = [part for part in document["parts"] if part["name"].startswith("spacer ")]
            self.assertEqual(len(rings), sum(row["quantity"] for row in spacers))
            for row in spacers:
                drawn = [c for c in space.query('CIRCLE[layer=="OUTLINES"]')
                         if math.isclose(2 * c.dxf.radius, row["outside"], rel_tol=1e-9)]
                self.assertGreaterEqual(len(drawn), row["quantity"])
                seen += self.check_clear(result, document, row)
        self.assertGreaterEqual(seen, 1)

    def check_clear(self, result, document, row):
        linkage = self.document(result)
        columns = {column["name"]: column["values"] for column in linkage["positions"]}
        fixed = linkage["position"]["places"]

        def place(name, k):
            return (columns[f"{name}_x"][k], columns[f"{name}_y"][k]) if f"{name}_x" in columns else fixed[name]

        links = [part for part in document["parts"] if part["plane"] in row["layers"] and not part["slots"]
                 and not part["name"].startswith("spacer ") and len(part["holes"]) > 1]
        compared = 0
        for part in links:
            names = [hole["name"] for hole in part["holes"]]
            if not all(f"{name}_x" in columns or part["name"] == "frame" for name in names):
                continue
            for k in range(0, len(columns[next(iter(columns))]), 3):
                spots = [place(name, k) for name in names]
                at = place(row["name"], k)
                if None in at or any(None in spot for spot in spots):
                    continue
                near = min(distance_to_segment(at, a, b) for a, b in itertools.combinations(spots, 2))
                self.assertGreater(near, 0.5 * (row["outside"] + document["width"]) * (1 - 1e-9))
                compared += 1
        return compared > 0

    def in_millimetres(self):
        return self.analysed("mm", 'length_unit = "mm"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [80, 0]]\n'
                             "crank = 40\ncoupler = 90\nrocker = 80\n")

    def analysed(self, name, text):
        (self.folder / f"{name}.toml").write_text('kind = "analysis"\n' + text)
        done = run("analyze", f"{name}.toml", "--quiet", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / f"{name}.result.json"

    def test_bearings_take_the_place_of_holes(self):
        result = self.in_millimetres()
        # Of each: bore, outside diameter and width, from ISO 15.
        for number, (bore, outside, width) in {"608": (8, 22, 7), "623": (3, 10, 4), "619/5": (5, 13, 4),
                                               "61800": (10, 19, 5)}.items():
            document, space = self.sheet(result, "--parts", "--width", 26, "--bearing", number, "--thickness", 5)
            drawn = sorted(round(2 * c.dxf.radius, 9) for c in space.query('CIRCLE[layer=="HOLES"]'))
            self.assertEqual(drawn, 4 * [bore] + 4 * [outside])
            for pin in document["pins"]:
                holes = [h["diameter"] for p in document["parts"] for h in p["holes"] if h["name"] == pin["name"]]
                self.assertEqual(sorted(holes), [bore, outside])
            (row,) = [row for row in document["bill"] if row["item"] == "bearing"]
            self.assertEqual((row["name"], row["quantity"], row["bore"], row["outside"], row["thickness"]),
                             (number, 4, bore, outside, width))

    def test_bearings_that_do_not_fit(self):
        result = self.in_millimetres()
        parts = ("--format", "dxf", "--parts", "--width", 20, "--bearing")
        text = self.refusal(result, *parts, "608")
        for part in ("--width: 20 leaves nothing about the bearing 608", "619/8 with 19", "618/8 with 16"):
            self.assertIn(part, text)
        self.assertIn("such as 618/3", self.refusal(result, *parts, "609x"))
        self.assertIn("--hole: 6 is not the bore", self.refusal(result, *parts, "623", "--hole", 6))
        self.assertIn("--length-unit", self.refusal(self.named("crank-rocker"), *parts, "623"))

    def test_screws_take_the_place_of_pins(self):
        # Of each by its standard: hole, nut's height and width, washer's outside diameter and thickness, pitch.
        sizes = {"M5": (5.3, 6.8, 8, 10, 1, 0.8), "M6": (6.4, 8, 10, 12, 1.6, 1), "M10": (10.5, 11.9, 16, 20, 2, 1.5)}
        lengths = [10, 12, 16, 20, 25, 30, 35, 40, 45, 50, 55, 60]
        result = self.in_millimetres()
        for name, (hole, nut, flats, outside, washer, pitch) in sizes.items():
            document, space = self.sheet(result, "--parts", "--width", 26, "--screw", name, "--thickness", 4)
            self.assertEqual({2 * c.dxf.radius for c in space.query('CIRCLE[layer=="HOLES"]')}, {hole})
            rows = {(row["item"], row["name"]): row for row in document["bill"]}
            for pin in document["pins"]:
                low, high = pin["planes"]
                clamped = 4 * (high - low + 1) + washer * (high - low + 2)
                screw, turned, washers = (rows[item, pin["name"]] for item in ("screw", "nut", "washer"))
                wanted = next(length for length in lengths if length >= clamped + nut + pitch)
                self.assertEqual((screw["length"], screw["standard"]), (wanted, f"ISO 4762 {name}x{wanted}"))
                self.assertEqual((turned["thickness"], turned["width"], turned["standard"]), (nut, flats, f"ISO 7040 {name}"))
                self.assertEqual(washers["quantity"], high - low + 2)
                self.assertEqual([washers[key] for key in ("outside", "bore", "thickness", "standard")],
                                 [outside, hole, washer, f"ISO 7089 {name}"])
            self.assertFalse(any(row["item"] == "pin" for row in document["bill"]))
        document, _ = self.sheet(result, "--parts", "--width", 26, "--screw", "M8", "--bearing", "608", "--thickness", 7)
        self.assertEqual(document["hole"], 8)

    def test_screws_that_do_not_fit(self):
        result = self.in_millimetres()
        order = ("--format", "json", "--parts", "--width", 26)
        for more, message in [(("--screw", "M7", "--thickness", 4), "M3, M4, M5, M6, M8, M10, M12 or M16"),
                              (("--screw", "M5"), "expected --thickness T with it"),
                              (("--screw", "M5", "--thickness", 4, "--hole", 4.9), "too small for the screw M5; allowed is 5"),
                              (("--screw", "M5", "--thickness", 4, "--hole", 10), "washers of 10 fall through"),
                              (("--screw", "M5", "--thickness", 4, "--washer", 1), "expected --screw without --washer"),
                              (("--hole", 5, "--washer", "1x"), "an outside diameter such as 1x10"),
                              (("--hole", 5, "--washer", "1x5"), "washers of 5 fall through")]:
            self.assertIn(message, self.refusal(result, *order, *more))
        self.assertIn("--length-unit", self.refusal(self.named("crank-rocker"), *order, "--screw", "M5", "--thickness", 4))
        done = run("export", result, *order, "--screw", "M3", "--thickness", 20, "--out", "long", cwd=self.folder)
        self.assertIn("no screw M3 of ISO 4762 is so long", done.stdout + done.stderr)

    def test_nuts_and_heads_without_room_are_named(self):
        """Against samples of an own four-bar: the nut of A, which lies in the coupler's layer, and the others."""
        def noted(*options):
            done = run("export", self.in_millimetres(), "--format", "json", "--parts", "--width", 20, "--thickness", 6, *options,
                       "--out", "noted", "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            return " ".join(json.loads(done.stdout).get("notes", []))

        document, _ = self.sheet(self.in_millimetres(), "--parts", "--width", 20, "--thickness", 6, "--screw", "M6")
        plane = {part["name"]: part["plane"] for part in document["parts"]}
        least = math.inf
        for k in range(720):
            b = 40 * complex(math.cos(math.pi * k / 360), math.sin(math.pi * k / 360))
            way = 80 - b
            along = (90 ** 2 - 80 ** 2 + abs(way) ** 2) / (2 * abs(way))
            c = b + way / abs(way) * complex(along, math.sqrt(90 ** 2 - along ** 2))
            least = min(least, distance_to_segment((0, 0), (b.real, b.imag), (c.real, c.imag)))
        self.assertEqual((plane["frame"], plane["crank"], plane["coupler"]), (1, 2, 3))
        self.assertLess(least, 10 / math.sqrt(3) + 10)
        self.assertIn("the nut of A and coupler", noted("--screw", "M6"))
        self.assertNotIn("no room", noted("--hole", 6, "--washer", "1x12"))
        # The washers of A and D, both between the frame and the layer above, as wide as the pivots are apart.
        self.assertRegex(noted("--hole", 6, "--washer", "1x81"), "the washer of [AD] and the washer of [AD]")
        self.assertNotIn("no room", noted("--hole", 6, "--washer", "1x79"))

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
