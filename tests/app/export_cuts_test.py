"""What a beam of some width cuts of gears and cams, and their bores, by drawings read again.

Run as: export_cuts_test.py PROGRAM, the built program.
"""

import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

from drawn_outlines import area, around, corners_of, distance_to, holds, outline_of, sides
from wheel_files import gear, ROLLER_CAM

try:
    import ezdxf
except ImportError:
    ezdxf = None

PROGRAM = ""

# Width and depth in the hub of keyways of DIN 6885-1, by bores in millimetres.
KEYWAYS = {8: (2, 1.0), 10: (3, 1.4), 12: (4, 1.8), 14: (5, 2.3), 20: (6, 2.8), 30: (8, 3.3), 31: (10, 3.3)}

def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60)


def pair(teeth, distance, more=""):
    return (f'kind = "gear-pair"\nlength_unit = "mm"\nmechanism = {{teeth = {teeth}, module = 5, '
            f"profile_shift = [0, 0], centre_distance = {distance}{more}}}\n")


def near(polygon, point, reach):
    """The sides of a polygon that a point may be near to."""
    return [(a, b) for a, b in sides(polygon)
            if abs(a[0] - point[0]) < reach and abs(a[1] - point[1]) < reach]


@unittest.skipIf(ezdxf is None, "needs ezdxf")
class ExportCuts(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def result(self, text, command="analyze"):
        file = self.folder / "made.toml"
        file.write_text(text)
        done = run(command, file, "--quiet", "--out", self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return self.folder / "made.result.json"

    def drawing(self, result, *options):
        done = run("export", result, "--format", "dxf", "--out", self.folder, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawing = ezdxf.readfile(self.folder / "made.dxf")
        self.assertEqual(drawing.audit().errors, [])
        return drawing.modelspace()

    def refused(self, result, *parts, options=()):
        done = run("export", result, "--format", "dxf", "--out", self.folder / "none", *options)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def outlines(self, space, layer):
        return list(space.query(f'LWPOLYLINE[layer=="{layer}"]'))

    def check_offset(self, nominal, cut, distance, tolerance, reach):
        """Every point of the cut has that distance from the nominal outline, on the right side, and
        the areas differ as those of parallel curves do."""
        points = cut[::max(1, len(cut) // 150)]
        for point in points:
            away = min(distance_to([a, b], point) for a, b in near(nominal, point, reach))
            self.assertAlmostEqual(away, abs(distance), delta=tolerance)
            self.assertEqual(holds(nominal, point), distance < 0)
        steiner = area(nominal) + around(nominal) * distance + math.pi * distance**2
        self.assertAlmostEqual(area(cut), steiner, delta=around(nominal) * tolerance)

    def test_gears_are_cut_at_half_the_kerf(self):
        for teeth, shift, kerf in ((35, 0, 0.2), (9, 0, 0.3), (9, 0.5, 0.1), (120, 0.3, 0.25), (17, -0.1, 1.5)):
            with self.subTest(teeth=teeth, shift=shift, kerf=kerf):
                result = self.result(gear(teeth, shift))
                (nominal,) = self.outlines(self.drawing(result), "OUTLINE")
                (cut,) = self.outlines(self.drawing(result, "--kerf", kerf), "OUTLINE")
                self.check_offset(outline_of(nominal), outline_of(cut), kerf / 2, 0.011, 12)

    def test_arcs_stay_true_arcs(self):
        kerf, teeth = 0.4, 20
        space = self.drawing(self.result(gear(teeth)), "--kerf", kerf)
        (cut,) = self.outlines(space, "OUTLINE")
        corners = corners_of(cut)
        radii = {}
        for a, b in zip(corners, corners[1:] + corners[:1]):
            if a[2] == 0:
                continue
            centre, _, _, radius = ezdxf.math.bulge_to_arc(a[:2], b[:2], a[2])
            kind = "gear" if math.hypot(*tuple(centre)[:2]) < 1e-6 else "corner"
            radii.setdefault((kind, round(radius, 6)), []).append(a)
        self.assertEqual({key: len(arcs) for key, arcs in radii.items()},
                         {("gear", 55 + kerf / 2): teeth, ("gear", 43.75 + kerf / 2): teeth,
                          ("corner", kerf / 2): 2 * teeth})

    def test_rings_are_cut_inside(self):
        for kerf in (0.2, 0.8):
            result = self.result(pair("[20, 60]", 100, ', gearing = "internal"'))
            nominal = self.outlines(self.drawing(result), "OUTLINE")
            cut = self.outlines(self.drawing(result, "--kerf", kerf), "OUTLINE")
            shift = cut[0].get_points()[0][1] - nominal[0].get_points()[0][1]
            self.assertLess(shift, -100)
            # What is concave is cut with corners of the beam's radius: no farther than that.
            ring = outline_of(nominal[1])
            for point in outline_of(cut[1])[::20]:
                away = min(distance_to([a, b], point) for a, b in near(ring, point, 15))
                self.assertGreaterEqual(away, kerf / 2 - 0.011)
                self.assertTrue(holds(ring, point))

    def test_gears_of_a_pair_lie_apart(self):
        cut = self.outlines(self.drawing(self.result(pair("[20, 30]", 125)), "--kerf", 0.2), "OUTLINE")
        pinion, wheel = map(outline_of, cut)
        self.assertGreater(min(y for _, y in wheel), max(y for _, y in pinion) + 1)
        rack = self.result('kind = "gear-pair"\nmechanism = {gearing = "rack", pinion_teeth = 20, module = 5}\n')
        pinion, rack = map(outline_of, self.outlines(self.drawing(rack, "--kerf", 0.2), "OUTLINE"))
        self.assertGreater(min(y for _, y in rack), max(y for _, y in pinion) + 1)

    def test_kerfs_that_do_not_fit_into_the_spaces(self):
        result = self.result(gear(20))
        self.refused(result, "--kerf: 5 ", "tooth spaces", "allowed is less than", options=("--kerf", 5))
        done = run("export", result, "--format", "dxf", "--kerf", 5, "--out", self.folder)
        most = float(done.stderr.rsplit(" ", 1)[1])
        self.drawing(result, "--kerf", 0.99 * most)
        self.refused(result, "--kerf", options=("--kerf", 1.02 * most))
        self.refused(self.result(pair("[20, 30]", 125)), "spaces of the pinion", f"less than {most:.3g}",
                     options=("--kerf", 1e30))

    def test_keyways_are_those_of_the_standard(self):
        result = self.result(gear(40))
        for bore, (width, depth) in KEYWAYS.items():
            for kerf in (0, 0.3):
                options = ("--bore", bore, "--keyway") + (("--kerf", kerf) if kerf else ())
                (outline,) = self.outlines(self.drawing(result, *options), "BORE")
                polygon = outline_of(outline, 200)
                left, low, right, high = (min(x for x, _ in polygon), min(y for _, y in polygon),
                                          max(x for x, _ in polygon), max(y for _, y in polygon))
                self.assertAlmostEqual(low, -(bore - kerf) / 2, 2)
                self.assertAlmostEqual(right - left, bore - kerf, 2)
                self.assertAlmostEqual(high, bore / 2 + depth - kerf / 2, 9)
                top = [x for x, y, _ in corners_of(outline) if abs(y - high) < 1e-9]
                self.assertAlmostEqual(max(top) - min(top), width - kerf, 9)

    def test_keyways_in_inches(self):
        result = self.result(gear(40, module=0.2).replace('"mm"', '"in"'))
        (outline,) = self.outlines(self.drawing(result, "--bore", 1, "--keyway"), "BORE")
        self.assertAlmostEqual(max(y for _, y in outline_of(outline)), 0.5 + 3.3 / 25.4, 9)

    def test_bores_and_hubs(self):
        space = self.drawing(self.result(pair("[20, 30]", 125)), "--bore", "12,20", "--hub", "24,40", "--kerf", 0.2)
        self.assertEqual(sorted(round(c.dxf.radius, 9) for c in space.query('CIRCLE[layer=="BORE"]')), [5.9, 9.9])
        self.assertEqual(sorted(round(c.dxf.radius, 9) for c in space.query('CIRCLE[layer=="HUB"]')), [12, 20])

    def test_bores_that_reach_the_root(self):
        result = self.result(gear(20))  # root radius 43.75
        self.drawing(result, "--bore", 87)
        self.refused(result, "root radius is 43.75", options=("--bore", 88))
        self.refused(result, "with its keyway", options=("--bore", 84, "--keyway"))
        self.refused(result, "--hub: 20 ", "more than 20", options=("--bore", 20, "--hub", 20))
        self.refused(result, "two lengths are those of a pair", options=("--bore", "10,20"))
        self.refused(result, "DIN 6885", options=("--bore", 5, "--keyway"))
        self.refused(result, "--kerf: 9 leaves nothing of the bore", options=("--bore", 8, "--kerf", 9))
        self.refused(result, "--kerf: 2.5 leaves nothing of the keyway", options=("--bore", 8, "--keyway", "--kerf", 2.5))
        self.refused(result, "--timing-mark: is for cams", options=("--timing-mark",))
        no_unit = self.result(gear(20).replace('length_unit = "mm"\n', ""))
        self.refused(no_unit, "--length-unit mm", options=("--bore", 20, "--keyway"))
        self.drawing(no_unit, "--bore", 20, "--keyway", "--length-unit", "mm")

    def profile(self, result, name="made.profile.csv"):
        done = run("export", result, "--format", "csv", "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / name, newline="") as file:
            return [(float(row["x_mm"]), float(row["y_mm"])) for row in csv.DictReader(file)]

    def test_cams_are_cut_at_half_the_kerf(self):
        for turns in ("", 'rotation = "cw"\n'):
            result = self.result(ROLLER_CAM.format(more="") + turns, "solve")
            nominal = self.profile(result)[::-1]
            nominal = nominal if area(nominal) > 0 else nominal[::-1]
            (cut,) = self.outlines(self.drawing(result, "--kerf", 0.5), "PROFILE")
            cut = outline_of(cut)
            self.check_offset(nominal, cut if area(cut) > 0 else cut[::-1], 0.25, 0.009, 20)

    def test_grooves_become_narrower(self):
        result = self.result(ROLLER_CAM.format(more='closure = "groove"'), "solve")
        walls = [self.profile(result, f"made.{name}.csv") for name in ("inner-wall", "outer-wall")]
        cut = [outline_of(line) for line in self.outlines(self.drawing(result, "--kerf", 0.5), "PROFILE")]
        for nominal, drawn, inside in ((walls[0], cut[0], False), (walls[1], cut[1], True)):
            for point in drawn[::7]:
                self.assertAlmostEqual(distance_to(nominal, point), 0.25, delta=0.009)
                self.assertEqual(holds(nominal, point), inside)
        self.refused(result, "--kerf: 18.5 does not fit into the groove", "at most 18", options=("--kerf", 18.5))

    def test_bores_and_marks_of_cams(self):
        result = self.result(ROLLER_CAM.format(more=""), "solve")
        least = min(math.hypot(*point) for point in self.profile(result))
        for kerf in ((), ("--kerf", 0.4)):
            space = self.drawing(result, "--bore", 2 * least - 0.1, *kerf)
            (bore,) = space.query('CIRCLE[layer=="BORE"]')
            self.assertAlmostEqual(bore.dxf.radius, least - 0.05 - (0.2 if kerf else 0), 6)
            self.refused(result, "least radius", options=("--bore", 2 * least + 0.1, *kerf))
        space = self.drawing(result, "--bore", 20, "--keyway", "--timing-mark")
        (mark,) = space.query('LINE[layer=="ENGRAVE"]')
        (x0, y0, _), (x1, y1, _) = mark.dxf.start, mark.dxf.end
        self.assertEqual((x0, x1), (0, 0))
        self.assertLess(10 + 2.8, y0)
        self.assertLess(y0, y1)
        self.assertLess(y1, least)
        self.refused(result, "--kerf: is that of a profile", options=("--kerf", 1, "--curve", "pitch"))

    def test_cams_that_a_wide_beam_would_gouge(self):
        text = ROLLER_CAM.format(more="").replace("roller_radius = 9", "roller_radius = 1").replace(
            "over_deg = 120\nrise = 25", "over_deg = 40\nrise = 25").replace("over_deg = 60\n[[motion]]",
                                                                          "over_deg = 140\n[[motion]]", 1)
        result = self.result(text, "solve")
        self.refused(result, "--kerf: 100 would gouge", "twice that", options=("--kerf", 100))

    def test_random_gears(self):
        """Of any size that can be cut."""
        draw = random.Random(5)
        for _ in range(3):
            teeth, shift = draw.randint(8, 60), draw.uniform(-0.1, 0.5)
            kerf = draw.uniform(0.05, 1.5)
            result = self.result(gear(teeth, shift))
            (nominal,) = self.outlines(self.drawing(result), "OUTLINE")
            (cut,) = self.outlines(self.drawing(result, "--kerf", kerf), "OUTLINE")
            self.check_offset(outline_of(nominal), outline_of(cut), kerf / 2, 0.011, 12)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
