"""What holds parts together, from outside: bill, spacers, bearings, screws with nuts and washers.

Run as: export_hardware_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import csv
import itertools
import json
import math
import sys
import unittest

from exported_linkages import distance_to_segment, run
from part_sheets import PartSheets
from thinned import some

try:
    import ezdxf
except ImportError:
    ezdxf = None


@unittest.skipIf(ezdxf is None, "needs ezdxf")
class ExportHardware(PartSheets):
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
        for result in some(self.plates):
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
