"""Blocks of sliders as parts, from outside: in their slots at every position, on the sheet, in the bill, refused ones.

Run as: export_blocks_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import cmath
import csv
import json
import math
import sys
import unittest

from drawn_outlines import area, holds, outline_of
from exported_linkages import ExportedLinkages, run
from thinned import some

try:
    import ezdxf
except ImportError:
    ezdxf = None

HOLE, WIDTH, THICKNESS, CLEARANCE = 0.1, 0.5, 0.2, 0.02  # of the shortest link
LENGTH, ACROSS = 0.3, 0.2

# How many blocks each has, and in which part.
BLOCKS = {"slider-crank-offset": {"slider": "frame"},
          "shaper": {"block": "bar", "ram": "frame"},
          "toggle-press": {"ram": "frame"},
          "oscillating-block": {"block": "rod"},
          "guide-bar-rotating": {"slider": "guide"},
          "scotch-yoke": {"block": "yoke"},
          "oldham-coupling": {"driven": "disc"},
          "elliptic-trammel": {"first-block": "frame", "second-block": "frame"}}


class Blocks(ExportedLinkages):
    def sizes(self, result):
        links = self.document(result)["links"]
        least = min(length["length"] for link in links for length in link["lengths"])
        return least, ("--parts", "--hole", HOLE * least, "--width", WIDTH * least, "--thickness", THICKNESS * least,
                       "--clearance", CLEARANCE * least, "--block", f"{LENGTH * least}x{ACROSS * least}")

    def solids(self, result, position, *options):
        done = run("export", result, "--format", "step", *options, "--position", position, "--length-unit", "m",
                   "--out", "solid", "--json",
                   cwd=self.folder)
        if "libocct" in done.stderr:
            self.skipTest("built without OpenCASCADE")
        self.assertEqual(done.returncode, 0, done.stderr)
        return {solid["name"]: solid for solid in json.loads(done.stdout)["solids"]}

    def test_each_block_is_in_its_slot_at_every_position(self):
        """By places and turns of the solids, and the ways of the pins: the straight part of the slot holds all corners."""
        for name, expected in some(BLOCKS.items()):
            result = self.named(name)
            least, options = self.sizes(result)
            ways = {(slot["slider"], link["name"]): [complex(*slot[end]) for end in ("from", "to")]
                    for link in self.document(result)["links"] for slot in link["slots"]}
            drive = self.document(result)["positions"][0]["values"]
            for k in range(0, len(drive), max(1, len(drive) // 5)):
                made = self.solids(result, drive[k], *options)
                for block, bearer in expected.items():
                    with self.subTest(name, block=block, position=drive[k]):
                        self.check_block(made[block], made[bearer], ways[block, bearer], least)

    def check_block(self, block, bearer, way, least):
        self.assertEqual((block["low"], block["high"]), (bearer["low"], bearer["high"]))
        bulk = (LENGTH * ACROSS - math.pi / 4 * HOLE**2) * THICKNESS * least**3
        self.assertAlmostEqual(block["volume"] / bulk, 1, 9)

        def place(solid, at):
            return complex(*solid["at"]) + at * cmath.rect(1, math.radians(solid["turned_deg"]))

        turn = cmath.rect(1, -math.radians(bearer["turned_deg"]))
        along = (way[1] - way[0]) / abs(way[1] - way[0])
        for x in (-0.5, 0.5):
            for y in (-0.5, 0.5):
                corner = place(block, complex(x * LENGTH, y * ACROSS) * least)
                from_start = ((corner - complex(*bearer["at"])) * turn - way[0]) / along
                self.assertLessEqual(abs(from_start.imag), ACROSS / 2 * least * (1 + 1e-6))
                self.assertGreaterEqual(from_start.real, -(LENGTH / 2 + 1e-6) * least)
                self.assertLessEqual(from_start.real, abs(way[1] - way[0]) + (LENGTH / 2 + 1e-6) * least)

    @unittest.skipIf(ezdxf is None, "needs ezdxf")
    def test_slots_and_blocks_on_the_sheet(self):
        """An offset slider-crank, its stroke by Pythagoras; with a kerf blocks are larger by it, and slots narrower."""
        result = self.named("slider-crank-offset")
        least, options = self.sizes(result)
        crank, rod, offset = 40, 120, 25
        stroke = math.sqrt((rod + crank)**2 - offset**2) - math.sqrt((rod - crank)**2 - offset**2)
        kerf = 0.05 * HOLE * least
        for beam in (0, kerf):
            cut = ("--kerf", beam) if beam else ()
            sheet = json.loads(self.export(result, "json", *options, *cut).read_text())
            parts = {part["name"]: part for part in sheet["parts"]}
            (slot,) = parts["frame"]["slots"]
            self.assertAlmostEqual(math.dist(slot["from"], slot["to"]) / (stroke + LENGTH * least), 1, 6)
            self.assertAlmostEqual(slot["width"], (ACROSS + CLEARANCE) * least, 9)
            self.assertEqual(parts["slider"]["plane"], parts["frame"]["plane"])
            space = ezdxf.readfile(self.export(result, "dxf", *options, *cut)).modelspace()
            outlines = [outline_of(entity) for entity in space.query('*[layer=="OUTLINES"]')]
            self.assertEqual(len(outlines), len(sheet["parts"]))
            drawn = dict(zip((part["name"] for part in sheet["parts"]), outlines))
            long, wide = LENGTH * least + beam, ACROSS * least + beam
            corners = (1 - math.pi / 4) * beam**2
            self.assertAlmostEqual(abs(area(drawn["slider"])) / (long * wide - corners), 1, 4)
            (hole,) = parts["slider"]["holes"]
            self.assertTrue(holds(drawn["slider"], hole["at"]))
            slots = list(space.query('LWPOLYLINE[layer=="SLOTS"]'))
            self.assertEqual(len(slots), 1)
            straight = math.dist(slot["from"], slot["to"])
            across = (ACROSS + CLEARANCE) * least - beam
            self.assertAlmostEqual(abs(area(outline_of(slots[0]))) / (straight * across + math.pi / 4 * across**2), 1, 3)

    def test_the_bill_has_the_blocks(self):
        for name, expected in BLOCKS.items():
            with self.subTest(name):
                result = self.named(name)
                least, options = self.sizes(result)
                done = run("export", result, "--format", "json", *options, "--bill", "--out", "bill", cwd=self.folder)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("is no part but the pin", done.stderr)
                (file,) = (self.folder / "bill").glob(f"{name}*.bill.csv")
                with open(file, newline="") as table:
                    rows = [row for row in csv.DictReader(table) if row["item"] == "block"]
                self.assertEqual({row["name"] for row in rows}, set(expected))
                for row in rows:
                    sizes = [float(value) for key, value in row.items()
                             if key.split("_")[0] in ("length", "width", "thickness", "bore")]
                    for size, share in zip(sizes, (LENGTH, ACROSS, THICKNESS, HOLE), strict=True):
                        self.assertAlmostEqual(size / (share * least), 1, 9)

    def test_what_is_refused(self):
        result = self.named("slider-crank-offset")
        base = ("--format", "json", "--parts", "--hole", 5, "--width", 20)
        for text, word in (("20", "such as 20x12"), ("20x", "such as 20x12"), ("-20x12", "such as 20x12"),
                           ("nanx12", "such as 20x12"), ("20x5", "leaves nothing about a hole of 5"),
                           ("8x12", "would turn in its slot"), ("30x20", "as wide as the bars; allowed is less than 20")):
            self.assertIn(word, self.refusal(result, *base, "--block", text), text)
        self.assertIn("expected --parts", self.refusal(result, "--format", "json", "--block", "20x12"))
        trammel = self.named("elliptic-trammel")
        links = {link["name"]: link["lengths"] for link in self.document(trammel)["links"]}
        (pins,) = [length["length"] for length in links["link"] if {length["from"], length["to"]} == {"A", "B"}]
        # Where one pin is on the crossing of the slots, the other is `pins` away: blocks of that length meet.
        message = self.refusal(trammel, "--format", "json", "--parts", "--hole", 0.02 * pins, "--width", 0.1 * pins,
                               "--block", f"{1.99 * pins}x{0.06 * pins}")
        self.assertIn("first-block and second-block would meet", message)
        done = run("export", self.named("crank-rocker"), *base[:3], "--hole", 0.1, "--width", 0.2, "--block", "0.3x0.15",
                   "--out", "none", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no slider of this linkage", done.stderr + done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
