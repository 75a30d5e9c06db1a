"""Exported gears from outside, against formulas of this file's own.

Run as: export_gears_test.py PROGRAM, the built program.
"""

import csv
import json
import math
import pathlib
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
ALPHA = math.radians(20)
ADDENDUM, CLEARANCE = 1, 0.25


def inv(angle):
    return math.tan(angle) - angle


def gear(teeth, shift=0, module=5):
    return f'kind = "gear"\nmechanism = {{teeth = {teeth}, module = {module}, profile_shift = {shift}}}\n'


def pair(distance, teeth="[20, 80]", more=""):
    return (f'kind = "gear-pair"\nmechanism = {{teeth = {teeth}, module = 5, '
            f"profile_shift = [0, 0], centre_distance = {distance}{more}}}\n")


def involute_distance(x, y, teeth, shift, module):
    """How far a point on the left of the y axis is from the left flank's involute: two points of one
    involute differ by the arc of the base circle between their strings."""
    base = module * teeth / 2 * math.cos(ALPHA)
    half = (math.pi / 2 + 2 * shift * math.tan(ALPHA)) / teeth + inv(ALPHA)
    radius = math.hypot(x, y)
    return base * (math.atan2(-x, y) + inv(math.acos(min(1, base / radius))) - half)


def corner_distance(x, y, teeth, shift, module):
    """The least distance of the rack's round tip corner from a point while it rolls past."""
    corner = CLEARANCE / (1 - math.sin(ALPHA)) * module
    across = (math.pi / 4 - ADDENDUM * math.tan(ALPHA)) * module - corner * math.cos(ALPHA)
    depth = (shift - ADDENDUM - CLEARANCE) * module + corner
    reference = module * teeth / 2

    def away(turn):
        along = -math.pi * module / 2 + across - reference * turn
        cosine, sine = math.cos(-turn), math.sin(-turn)
        height = reference + depth
        return math.hypot(x - cosine * along + sine * height,
                          y - sine * along - cosine * height) - corner

    count, span = 400, 1.2
    best = min(range(count + 1), key=lambda i: away(span * (2 * i / count - 1)))
    low, high = (span * (2 * (best + k) / count - 1) for k in (-1, 1))
    for _ in range(50):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (low, b) if away(a) < away(b) else (a, high)
    return away((low + high) / 2)


def segments_cross(a, b, c, d):
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def crossings(polygon, cell):
    """Pairs of edges that cross, found by a grid."""
    grid, found = {}, 0
    edges = [(polygon[i - 1], polygon[i]) for i in range(len(polygon))]
    for i, (a, b) in enumerate(edges):
        cells = {(math.floor((a[0] + t * (b[0] - a[0]) / 4) / cell),
                  math.floor((a[1] + t * (b[1] - a[1]) / 4) / cell)) for t in range(5)}
        near = set().union(*(grid.get((u + k, v + l), ()) for u, v in cells
                             for k in (-1, 0, 1) for l in (-1, 0, 1)))
        found += sum(segments_cross(a, b, *edges[j]) for j in near)
        for place in cells:
            grid.setdefault(place, []).append(i)
    return found


def inside(point, polygon):
    x, y = point
    is_inside = False
    for i, (x1, y1) in enumerate(polygon):
        x0, y0 = polygon[i - 1]
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            is_inside = not is_inside
    return is_inside


def to_edges(point, edges):
    def to_edge(a, b):
        u, v = b[0] - a[0], b[1] - a[1]
        square = u * u + v * v
        t = ((point[0] - a[0]) * u + (point[1] - a[1]) * v) / square if square else 0
        t = min(1, max(0, t))
        return math.hypot(point[0] - a[0] - t * u, point[1] - a[1] - t * v)

    return min(to_edge(a, b) for a, b in edges)


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=60)


class ExportGearsTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def result(self, text, name="gears"):
        file = self.folder / f"{name}.toml"
        file.write_text(text)
        done = run("analyze", file, "--quiet", "--out", self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return self.folder / f"{name}.result.json"

    def export(self, result, form, *options, status=0):
        done = run("export", result, "--format", form, "--out", self.folder, *options)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def rows(self, name="gears.csv"):
        with open(self.folder / name, newline="") as file:
            return [(float(row["x"]), float(row["y"]), float(row["radius"]), row["part"])
                    for row in csv.DictReader(file)]

    def first_tooth(self, rows, teeth):
        """The left flank of the upright tooth: rows, each with the one before it."""
        return [(before, row) for before, row in zip(rows, rows[1:])
                if 0 <= math.atan2(-row[0], row[1]) <= math.pi / teeth + 1e-9 and row[1] > 0
                and 0 <= math.atan2(-before[0], before[1])]

    def test_outlines_are_those_of_the_formulas(self):
        for teeth, shift in ((35, 0), (9, 0), (9, 0.5), (12, -0.2), (120, 0.3)):
            with self.subTest(teeth=teeth, shift=shift):
                self.export(self.result(gear(teeth, shift)), "csv", "--chord-tolerance", 1e-3)
                flank = self.first_tooth(self.rows(), teeth)
                counts = {"tip": 0, "involute": 0, "fillet": 0, "root": 0}
                for before, (x, y, radius, part) in flank:
                    counts[part] += 1
                    self.assertAlmostEqual(radius, math.hypot(x, y), 9)
                    middle = ((x + before[0]) / 2, (y + before[1]) / 2)
                    if part == "involute":
                        self.assertLess(abs(involute_distance(x, y, teeth, shift, 5)), 1e-8)
                        self.assertLess(abs(involute_distance(*middle, teeth, shift, 5)), 1.01e-3)
                    elif part == "fillet":
                        self.assertLess(abs(corner_distance(x, y, teeth, shift, 5)), 1e-7)
                        self.assertLess(abs(corner_distance(*middle, teeth, shift, 5)), 1.01e-3)
                    else:
                        wanted = (teeth / 2 + shift + (1 if part == "tip" else -1.25)) * 5
                        self.assertAlmostEqual(radius, wanted, 9)
                self.assertTrue(all(counts.values()), counts)

    def test_outlines_are_closed_and_do_not_cross_themselves(self):
        for teeth, shift in ((35, 0), (9, 0), (200, -0.3)):
            with self.subTest(teeth=teeth):
                self.export(self.result(gear(teeth, shift)), "csv")
                polygon = [row[:2] for row in self.rows()]
                self.assertEqual(crossings(polygon, 1), 0)
                twice = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(polygon, polygon[1:] + polygon[:1]))
                root, tip = (teeth / 2 + shift - 1.25) * 5, (teeth / 2 + shift + 1) * 5
                self.assertGreater(twice / 2, math.pi * root**2)
                self.assertLess(twice / 2, math.pi * tip**2)
                steps = [math.dist(a, b) for a, b in zip(polygon, polygon[1:] + polygon[:1])]
                self.assertLess(max(steps), 5)

    def test_a_finer_tolerance_takes_more_points(self):
        result = self.result(gear(35))
        count = {}
        for tolerance in (0.1, 1e-3, 1e-4):
            self.export(result, "csv", "--chord-tolerance", tolerance)
            count[tolerance] = len(self.rows())
        # Chords of a curve: ten times as fine takes √10 times as many, or one more of each part.
        self.assertAlmostEqual(count[1e-4] / count[1e-3], math.sqrt(10), delta=1)
        self.assertLess(count[0.1], count[1e-3])

    def depth_and_gap(self, distance):
        """How deep the pinion's corners are in the wheel, and their least distance from it."""
        self.export(self.result(pair(distance)), "csv", "--chord-tolerance", 5e-3)
        pinion, wheel = ([row[:2] for row in self.rows(f"gears.{name}.csv")]
                         for name in ("pinion", "wheel"))
        near = [p for p in pinion if math.dist(p, (0, 50)) < 15]
        edges = [(wheel[i - 1], p) for i, p in enumerate(wheel) if math.dist(p, (0, 50)) < 20]
        away = [to_edges(p, edges) for p in near]
        return max((a for p, a in zip(near, away) if inside(p, wheel)), default=0), min(away)

    def test_gears_of_a_pair_touch_and_do_not_overlap(self):
        for distance in (250, 252, 255):
            with self.subTest(distance=distance):
                depth, gap = self.depth_and_gap(distance)
                self.assertLess(depth, 0.011)
                self.assertLess(gap, 0.02)
        self.assertGreater(self.depth_and_gap(249)[0], 0.1)

    @unittest.skipIf(ezdxf is None, "needs ezdxf")
    def test_dxf_has_closed_outlines_with_arcs(self):
        for version in ("2000", "r12"):
            self.export(self.result(pair(250)), "dxf", "--dxf-version", version)
            space = ezdxf.readfile(self.folder / "gears.dxf").modelspace()
            outlines = [e for e in space.query("LWPOLYLINE POLYLINE") if e.dxf.layer == "OUTLINE"]
            self.assertEqual(len(outlines), 2)
            for outline, teeth, centre in zip(outlines, (20, 80), ((0, 0), (0, 250))):
                self.assertTrue(outline.is_closed)
                corners = (list(outline.get_points("xyb")) if outline.dxftype() == "LWPOLYLINE" else
                           [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0)) for v in outline.vertices])
                arcs = [(a, b) for a, b in zip(corners, corners[1:] + corners[:1]) if a[2] != 0]
                self.assertEqual(len(arcs), 2 * teeth)
                radii = []
                for a, b in arcs:
                    found = ezdxf.math.bulge_to_arc(a[:2], b[:2], a[2])
                    self.assertLess(math.dist(tuple(found[0])[:2], centre), 1e-6)
                    radii.append(round(found[3] - 2.5 * teeth, 6))
                self.assertEqual(sorted(set(radii)), [-6.25, 5])
            circles = {(c.dxf.layer, round(c.dxf.radius, 4)) for c in space.query("CIRCLE")}
            for teeth in (20, 80):
                self.assertIn(("PITCH_CIRCLE", 2.5 * teeth), circles)
                self.assertIn(("BASE_CIRCLE", round(2.5 * teeth * math.cos(ALPHA), 4)), circles)
                self.assertIn(("TIP_CIRCLE", 2.5 * teeth + 5), circles)
                self.assertIn(("ROOT_CIRCLE", 2.5 * teeth - 6.25), circles)

    def test_svg_and_json(self):
        result = self.result(pair(250))
        self.export(result, "svg")
        root = xml.etree.ElementTree.parse(self.folder / "gears.svg").getroot()
        names = {"svg": "http://www.w3.org/2000/svg"}
        paths = root.findall("svg:g/svg:path[@class='outline']", names)
        self.assertEqual([path.get("d").count("A") for path in paths], [40, 160])
        self.assertTrue(all(path.get("d").endswith("Z") for path in paths))
        self.export(result, "json")
        document = json.loads((self.folder / "gears.gears.json").read_text())
        self.assertEqual(document["format"], "cognate-gears/1")
        pinion, wheel = document["gears"]
        self.assertEqual((pinion["name"], pinion["teeth"], wheel["teeth"]), ("pinion", 20, 80))
        self.assertEqual(wheel["centre"], [0, 250])
        self.assertAlmostEqual(wheel["pitch_radius"], 200)
        self.export(result, "csv")
        self.assertEqual([tuple(point[:2]) for point in wheel["outline"]],
                         [row[:2] for row in self.rows("gears.wheel.csv")])

    def test_helical_gears_by_their_transverse_section(self):
        text = ('kind = "gear"\nmechanism = {gearing = "helical", teeth = 20, module = 5, '
                "helix_deg = 15}\n")
        self.export(self.result(text), "json")
        (gear,) = json.loads((self.folder / "gears.gears.json").read_text())["gears"]
        transverse = 5 / math.cos(math.radians(15))
        angle = math.atan(math.tan(ALPHA) / math.cos(math.radians(15)))
        self.assertAlmostEqual(gear["transverse_module"], transverse)
        self.assertAlmostEqual(gear["base_radius"], 10 * transverse * math.cos(angle))
        self.assertAlmostEqual(gear["tip_radius"], 10 * transverse + 5)

    def test_what_is_wrong_is_noted(self):
        for text, part in ((gear(9), "undercut"), (pair(255), "contact ratio"), (pair(249), "overlap")):
            self.assertIn(part, self.export(self.result(text), "csv").stderr)

    def refused(self, result, *parts, form="dxf", options=()):
        done = self.export(result, form, *options, status=2)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assertFalse(list(self.folder.glob("*.dxf")))

    def test_refusals(self):
        bevel = self.result('kind = "gear-pair"\nmechanism = {gearing = "bevel", teeth = [20, 40], module = 4}\n', "bevel")
        self.refused(bevel, "bevel.result.json: designs[0].mechanism: ", "cones", "virtual_teeth")
        worm = self.result('kind = "gear-pair"\nmechanism = {gearing = "worm", wheel_teeth = 40, module = 4}\n', "worm")
        self.refused(worm, "no outline in a plane", "wheel_teeth")
        result = self.result(gear(35))
        self.refused(result, "--format: dot", "dxf, svg, csv, json, step or stl", form="dot")
        self.refused(result, "--curve: is for cams", options=("--curve", "pitch"))
        self.refused(result, "--position: is for linkages", options=("--position", 3))
        self.refused(result, "--parts: is for linkages", options=("--parts", "--hole", 1, "--width", 3))
        for tolerance in (1e-9, 3):
            self.refused(result, "--chord-tolerance", "from 5e-05 to 0.5", options=("--chord-tolerance", tolerance))
        self.refused(result, "--design from 1 to 1", options=("--design", 2))

    def test_results_that_were_changed(self):
        original = json.loads(self.result(pair(250)).read_text())
        for change, part in (({"teeth": [20]}, "teeth"), ({"teeth": "many"}, "teeth"),
                             ({"profile_shift": ["free", 0]}, "not whole"),
                             ({"centre_distance": 200}, "base circles overlap"),
                             ({"module": None}, "module is missing"), ({"module": -1}, "module"),
                             ({"teeth": [3, 80], "profile_shift": [-0.6, 0]}, "no outline"),
                             ({"rack": {"addendum": 4}}, "rack"), ({"colour": 1}, "colour")):
            with self.subTest(change=change):
                changed = json.loads(json.dumps(original))
                changed["designs"][0]["mechanism"].update(change)
                file = self.folder / "changed.result.json"
                file.write_text(json.dumps(changed))
                self.refused(file, "changed.result.json: designs[0].mechanism: ", part)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
