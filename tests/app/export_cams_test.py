"""Exported cams from outside, against formulas of this file's own.

Run as: export_cams_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import bisect
import csv
import json
import math
import os
import pathlib
import re
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

HARMONIC = "harmonic"
CYCLOIDAL = "cycloidal"
DWELL = "dwell"

# Of every cam here: rise, dwell, return, dwell.
PROGRAMME = ((HARMONIC, 110, 1), (DWELL, 50, 0), (CYCLOIDAL, 100, -1), (DWELL, 100, 0))


def displacement(degrees, stroke):
    """The follower's displacement at a cam angle, by textbook formulas."""
    height = 0.0
    degrees %= 360
    for law, over, sense in PROGRAMME:
        if degrees > over:
            degrees -= over
            height += sense * stroke
            continue
        share = degrees / over
        if law == HARMONIC:
            return height + sense * stroke * (1 - math.cos(math.pi * share)) / 2
        if law == CYCLOIDAL:
            wave = math.sin(2 * math.pi * share) / (2 * math.pi)
            return height + sense * stroke * (share - wave)
        return height
    return height


def translating_pitch(degrees, base, offset, stroke):
    height = math.sqrt(base**2 - offset**2) + displacement(degrees, stroke)
    angle = math.radians(degrees)
    return (
        height * math.sin(angle) + offset * math.cos(angle),
        height * math.cos(angle) - offset * math.sin(angle),
    )


def oscillating_pitch(degrees, base, centre, arm, swing):
    start = math.acos((centre**2 + arm**2 - base**2) / (2 * centre * arm))
    angle = math.radians(degrees)
    turned = angle + start + math.radians(displacement(degrees, swing))
    return (
        centre * math.sin(angle) - arm * math.sin(turned),
        centre * math.cos(angle) - arm * math.cos(turned),
    )


def flat_profile(degrees, base, stroke):
    step = 1e-5
    slope = (displacement(degrees + step, stroke) - displacement(degrees - step, stroke)) / (
        2 * math.radians(step)
    )
    height = base + displacement(degrees, stroke)
    angle = math.radians(degrees)
    return (
        height * math.sin(angle) + slope * math.cos(angle),
        height * math.cos(angle) - slope * math.sin(angle),
    )


def distance_to_curve(point, curve, turn=360.0):
    """Least distance of a point from a curve given by the cam angle: a grid, then thirds."""
    count = 720
    best = min(range(count), key=lambda i: math.dist(point, curve(turn * i / count)))
    low, high = turn * (best - 1) / count, turn * (best + 1) / count
    for _ in range(60):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        if math.dist(point, curve(a)) < math.dist(point, curve(b)):
            high = b
        else:
            low = a
    return math.dist(point, curve((low + high) / 2))


def distance_to_segment(point, a, b):
    ab = (b[0] - a[0], b[1] - a[1])
    ap = (point[0] - a[0], point[1] - a[1])
    square = ab[0] ** 2 + ab[1] ** 2
    share = min(1.0, max(0.0, (ap[0] * ab[0] + ap[1] * ab[1]) / square)) if square else 0.0
    return math.hypot(ap[0] - share * ab[0], ap[1] - share * ab[1])


def distance_to_polygon(point, polygon):
    return min(
        distance_to_segment(point, polygon[i - 1], polygon[i]) for i in range(len(polygon))
    )


def run(*arguments, cwd=None):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, timeout=60
    )


def problem(follower, stroke, dimensions, swings=False):
    """The text of a problem file with PROGRAMME."""
    lines = ['kind = "cam"', "[follower]", *follower]
    for law, over, sense in PROGRAMME:
        lines += ["[[motion]]", f'law = "{law}"', f"over_deg = {over}"]
        if sense:
            lines.append(f"{'rise_deg' if swings else 'rise'} = {sense * stroke}")
    lines.append("[mechanism]")
    lines += [f"{key} = {json.dumps(value)}" for key, value in dimensions.items()]
    return "\n".join(lines) + "\n"


ROLLER = {"base_radius": 40, "offset": 12, "roller_radius": 9}
ROLLER_STROKE = 25


def roller_problem(*follower, **dimensions):
    return problem(
        ['type = "translating-roller"', *follower], ROLLER_STROKE, {**ROLLER, **dimensions}
    )


def roller_pitch(degrees):
    return translating_pitch(degrees, ROLLER["base_radius"], ROLLER["offset"], ROLLER_STROKE)


class ExportCams(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def solve(self, text, name="cam"):
        """The result file of a problem."""
        (self.folder / f"{name}.toml").write_text(text)
        done = run("solve", f"{name}.toml", "--quiet", cwd=self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return self.folder / f"{name}.result.json"

    def export(self, result, form, *options):
        done = run("export", result, "--format", form, *options, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def table(self, result, *options, name="cam.profile.csv"):
        """The rows of an exported table as numbers; None for an empty cell."""
        self.export(result, "csv", *options)
        if "--curve" in options:
            name = name.replace(".profile", f".{options[options.index('--curve') + 1]}")
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        unit = "_mm" if rows[0][1].endswith("_mm") else ""
        self.assertEqual(
            rows[0],
            ["cam_deg", f"x{unit}", f"y{unit}", "normal_x", "normal_y", f"radius_of_curvature{unit}"]
        )
        return [[float(cell) if cell else None for cell in row] for row in rows[1:]]

    def points(self, result, *options, name="cam.profile.csv"):
        return [(row[1], row[2]) for row in self.table(result, *options, name=name)]

    def expect_refusal(self, done, *parts):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def test_pitch_curves_are_those_of_the_formulas(self):
        cases = [
            (roller_problem(), roller_pitch),
            (
                problem(
                    ['type = "oscillating-roller"', 'side = "trailing"'],
                    18,
                    {"base_radius": 30, "centre_distance": 70, "arm": 55, "roller_radius": 6},
                    swings=True,
                ),
                lambda degrees: oscillating_pitch(degrees, 30, 70, 55, 18),
            ),
        ]
        for text, formula in cases:
            rows = self.table(self.solve(text), "--curve", "pitch")
            self.assertGreater(len(rows), 100)
            for degrees, x, y, *_ in rows:
                self.assertLess(math.dist((x, y), formula(degrees)), 1e-10)

    def test_flat_profile_is_that_of_the_formula(self):
        flat = problem(['type = "translating-flat"'], 10, {"base_radius": 40})
        for degrees, x, y, *_ in self.table(self.solve(flat)):
            self.assertLess(math.dist((x, y), flat_profile(degrees, 40, 10)), 1e-6)

    def test_curves_keep_their_distance_from_the_pitch_curve_as_a_whole(self):
        result = self.solve(roller_problem())
        for options, distance in [
            ([], ROLLER["roller_radius"]),
            (["--curve", "cutter", "--cutter-radius", "4"], ROLLER["roller_radius"] - 4),
            (["--curve", "cutter", "--cutter-radius", "15"], 15 - ROLLER["roller_radius"]),
        ]:
            rows = self.table(result, *options)
            for degrees, x, y, normal_x, normal_y, _ in rows[:: len(rows) // 40]:
                self.assertAlmostEqual(distance_to_curve((x, y), roller_pitch), distance, 9)
                foot = roller_pitch(degrees)
                across = (foot[0] - x) * normal_y - (foot[1] - y) * normal_x
                self.assertAlmostEqual(across, 0, 9)
                self.assertAlmostEqual(math.hypot(normal_x, normal_y), 1, 12)

    def test_radius_of_curvature_is_that_of_circles_through_three_points(self):
        rows = self.table(self.solve(roller_problem()), "--chord-tolerance", "1e-6")
        for before, here, after in zip(rows[5::150], rows[6::150], rows[7::150]):
            a, b, c = ((row[1], row[2]) for row in (before, here, after))
            area = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
            radius = math.dist(a, b) * math.dist(b, c) * math.dist(c, a) / (-2 * area)
            self.assertAlmostEqual(here[5] / radius, 1, 1)

    def test_polygons_keep_their_tolerance_with_few_points(self):
        result = self.solve(roller_problem())
        for tolerance in (0.5, 0.01, 0.001):
            polygon = self.points(result, "--curve", "pitch", "--chord-tolerance", tolerance)
            angles = [
                row[0]
                for row in self.table(result, "--curve", "pitch", "--chord-tolerance", tolerance)
            ]
            needed, last = 0.0, None
            for i in range(2000):
                degrees = 0.18 * i + 0.07
                at = bisect.bisect(angles, degrees)
                near = [polygon[k % len(polygon)] for k in range(at - 3, at + 3)]
                point = roller_pitch(degrees)
                distance = min(distance_to_segment(point, *near[k : k + 2]) for k in range(5))
                self.assertLessEqual(distance, tolerance)
                direction = math.atan2(
                    *(p - q for p, q in zip(roller_pitch(degrees + 1e-4), point))
                )
                if last:
                    turn = abs(math.remainder(direction - last[1], 2 * math.pi))
                    needed += math.sqrt(math.dist(point, last[0]) * turn / (8 * tolerance))
                last = (point, direction)
            self.assertLessEqual(len(polygon), 3 * needed + 24)
        default = self.points(result)
        explicit = self.points(result, "--chord-tolerance", 1e-4 * ROLLER["base_radius"])
        self.assertEqual(default, explicit)

    def test_clockwise_cams_are_mirror_images(self):
        ccw = self.table(self.solve(roller_problem()))
        cw = self.table(self.solve(roller_problem(rotation="cw")))
        mirrored = [[deg, -x, y, -nx, ny, radius] for deg, x, y, nx, ny, radius in ccw]
        self.assertEqual(cw, mirrored)

    def test_groove_has_two_walls(self):
        result = self.solve(roller_problem('closure = "groove"'))
        for wall, sense in (("inner", -1), ("outer", 1)):
            polygon = self.points(result, name=f"cam.{wall}-wall.csv")
            for x, y in polygon[:: len(polygon) // 40]:
                self.assertAlmostEqual(distance_to_curve((x, y), roller_pitch), 9, 9)
            reach = max(math.hypot(*point) for point in polygon)
            pitch = max(math.hypot(*roller_pitch(i)) for i in range(360))
            self.assertAlmostEqual(reach, pitch + 9 * sense, 2)
        self.expect_refusal(
            self.refused(result, "--curve", "cutter", "--cutter-radius", "9.5"),
            "--cutter-radius: 9.5 does not fit into the groove; allowed is at most 9",
        )
        self.export(result, "csv", "--curve", "cutter", "--cutter-radius", "9", "--out", "exact")
        self.assertEqual([file.name for file in (self.folder / "exact").iterdir()], ["cam.cutter.csv"])

    def test_conjugate_cams_touch_both_rollers_of_a_translating_follower(self):
        result = self.solve(roller_problem('closure = "conjugate"'))
        breadth = json.loads(result.read_text())["designs"][0]["mechanism"]["breadth"]
        self.export(result, "csv", "--chord-tolerance", "1e-4")
        for cam, below in ((1, 0), (2, breadth)):
            polygon = self.points(
                result, "--chord-tolerance", "1e-4", name=f"cam.cam-{cam}.csv"
            )
            for degrees in range(0, 360, 20):
                height = math.sqrt(40**2 - 12**2) + displacement(degrees, 25) - below
                angle = math.radians(degrees)
                centre = (
                    height * math.sin(angle) + 12 * math.cos(angle),
                    height * math.cos(angle) - 12 * math.sin(angle),
                )
                self.assertAlmostEqual(distance_to_polygon(centre, polygon), 9, 3)

    def test_conjugate_cams_touch_both_rollers_of_an_arm(self):
        arms = 75
        text = problem(
            ['type = "oscillating-roller"', 'closure = "conjugate"', f"arms_deg = {arms}"],
            18,
            {"base_radius": 35, "centre_distance": 80, "arm": 65, "roller_radius": 6},
            swings=True,
        )
        result = self.solve(text)
        self.export(result, "csv", "--chord-tolerance", "1e-4")
        start = math.acos((80**2 + 65**2 - 35**2) / (2 * 80 * 65))
        for cam, turned in ((1, 0), (2, math.radians(arms))):
            polygon = self.points(
                result, "--chord-tolerance", "1e-4", name=f"cam.cam-{cam}.csv"
            )
            for degrees in range(0, 360, 20):
                swing = start + math.radians(displacement(degrees, 18)) - turned
                x, y = -65 * math.sin(swing), 80 - 65 * math.cos(swing)
                angle = math.radians(degrees)
                centre = (
                    x * math.cos(angle) + y * math.sin(angle),
                    y * math.cos(angle) - x * math.sin(angle),
                )
                self.assertAlmostEqual(distance_to_polygon(centre, polygon), 6, 3)

    @unittest.skipIf(ezdxf is None, "ezdxf is not there")
    def test_dxf_holds_the_points_of_the_table(self):
        result = self.solve(roller_problem())
        for options, layer in [
            ([], "PROFILE"),
            (["--curve", "pitch"], "PITCH"),
            (["--curve", "cutter", "--cutter-radius", "5"], "CUTTER"),
        ]:
            points = self.points(result, *options)
            self.export(result, "dxf", *options)
            name = "cam.dxf" if layer == "PROFILE" else f"cam.{layer.lower()}.dxf"
            self.export(result, "dxf", *options, "--dxf-version", "r12", "--out", "old")
            old = ezdxf.readfile(self.folder / "old" / name)
            self.assertEqual(old.dxfversion, "AC1009")
            self.assertEqual(old.audit().errors, [])
            (line,) = old.modelspace().query("POLYLINE")
            self.assertEqual([tuple(vertex)[:2] for vertex in line.points()], points)
            drawing = ezdxf.readfile(self.folder / name)
            self.assertEqual(drawing.audit().errors, [])
            self.assertEqual(drawing.dxfversion, "AC1015")
            self.assertEqual(drawing.header["$INSUNITS"], 0)
            space = drawing.modelspace()
            (line,) = space.query("LWPOLYLINE")
            self.assertTrue(line.closed)
            self.assertEqual(line.dxf.layer, layer)
            self.assertEqual([(x, y) for x, y, *_ in line.get_points()], points)
            circles = {c.dxf.layer: c.dxf.radius for c in space.query("CIRCLE")}
            self.assertEqual(circles, {"BASE_CIRCLE": 31, "PRIME_CIRCLE": 40})
            self.assertEqual({mark.dxf.layer for mark in space.query("LINE")}, {"CENTRE"})
            self.assertLessEqual(
                {entity.dxf.layer for entity in space}, {e.dxf.name for e in drawing.layers}
            )

    def test_svg_shows_the_points_of_the_table(self):
        result = self.solve(roller_problem())
        self.export(result, "svg")
        root = xml.etree.ElementTree.parse(self.folder / "cam.svg").getroot()
        names = {"svg": "http://www.w3.org/2000/svg"}
        self.assertEqual(root.find("svg:title", names).text, "Cam")
        self.assertIsNone(root.find("svg:desc", names))
        (group,) = root.findall("svg:g", names)
        self.assertEqual(group.get("transform"), "scale(1 -1)")
        (path,) = group.findall("svg:path[@class='profile']", names)
        numbers = [float(text) for text in re.findall(r"[-+.\de]+", path.get("d"))]
        points = self.points(result)
        self.assertEqual(list(zip(numbers[::2], numbers[1::2])), points)
        left, top, width, height = map(float, root.get("viewBox").split())
        reach = max(max(abs(x), abs(y)) for x, y in points)
        self.assertLess(left, -reach)
        self.assertEqual((top, width, height), (left, -2 * left, -2 * left))

    def test_pictures_of_tiny_and_huge_cams_are_scaled_by_a_power_of_ten(self):
        names = {"svg": "http://www.w3.org/2000/svg"}
        for scale in (1e-7, 1e8):
            result = self.solve(problem(['type = "translating-flat"'], 10 * scale, {"base_radius": 40 * scale}))
            self.export(result, "svg")
            root = xml.etree.ElementTree.parse(self.folder / "cam.svg").getroot()
            power = float(re.search(r"times (1e-?\d+)", root.find("svg:desc", names).text).group(1))
            side = float(root.get("viewBox").split()[2])
            self.assertTrue(100 <= side <= 1100, side)
            path = root.find("svg:g/svg:path[@class='profile']", names)
            numbers = [float(text) for text in re.findall(r"[-+.e\d]+", path.get("d"))]
            points = self.points(result)
            self.assertEqual(len(numbers), 2 * len(points))
            for drawn, true in zip(numbers, (number for point in points for number in point)):
                self.assertAlmostEqual(drawn, power * true, 9)

    def test_files_and_words(self):
        result = self.solve(roller_problem())
        done = self.export(result, "dxf", "--out", "drawings")
        self.assertIn("wrote drawings/cam.dxf\n", done.stdout)
        done = self.export(result, "csv", "--json")
        document = json.loads(done.stdout)
        self.assertEqual(document["format"], "cognate-export/1")
        self.assertEqual(document["files"], ["cam.profile.csv"])
        self.assertEqual(document["points"], len(self.points(result)))
        self.assertEqual(self.export(result, "svg", "--quiet").stdout, "")

    def test_undercut_is_reported(self):
        result = self.solve(problem(['type = "translating-flat"'], 25, {"base_radius": 5}))
        done = self.export(result, "svg")
        self.assertIn("crosses itself", done.stderr)

    def test_every_cam_of_the_library(self):
        files = sorted((LIBRARY / "cam").glob("*.toml"))
        self.assertGreaterEqual(len(files), 9)
        for file in files:
            with self.subTest(file.name):
                result = self.solve(file.read_text(), file.stem)
                before = json.loads(result.read_text())["designs"][0]
                polygon = self.points(result, name=f"{file.stem}.profile.csv")
                least = min(
                    distance_to_segment((0, 0), polygon[i - 1], polygon[i])
                    for i in range(len(polygon))
                )
                told = before["metrics"]["profile_radius_min"]
                self.assertAlmostEqual(least / told, 1, 3)

    def refused(self, result, *options, form="csv"):
        return run("export", result, "--format", form, *options, cwd=self.folder)

    def test_cutters_that_would_gouge(self):
        # A steep rise from a small base circle: hollow where it begins.
        text = roller_problem(base_radius=25, offset=0, roller_radius=5)

        def pitch(degrees):
            return translating_pitch(degrees, 25, 0, ROLLER_STROKE)

        hollow = math.inf
        for i in range(36000):
            a, b, c = (pitch(0.01 * i + step) for step in (-0.05, 0, 0.05))
            area = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
            if area > 0:
                radius = math.dist(a, b) * math.dist(b, c) * math.dist(c, a) / (2 * area)
                hollow = min(hollow, radius + 5)
        result = self.solve(text)
        done = self.refused(result, "--curve", "cutter", "--cutter-radius", hollow + 1)
        self.expect_refusal(done, "would gouge the profile, whose least concave radius is ")
        told = float(re.search(r"concave radius is ([-+.\de]+),", done.stderr).group(1))
        self.assertAlmostEqual(told / hollow, 1, 2)
        self.export(result, "dxf", "--curve", "cutter", "--cutter-radius", told * 0.999)

    def test_options_that_are_not_possible(self):
        result = self.solve(roller_problem())
        for options, part in [
            (["--curve", "spiral"], "--curve: 'spiral' is not possible; allowed is profile, pitch"),
            (["--curve", "cutter"], "--cutter-radius R is missing"),
            (["--cutter-radius", "3"], "expected --curve cutter"),
            (["--curve", "cutter", "--cutter-radius", "0"], "--cutter-radius: '0'"),
            (["--curve", "cutter", "--cutter-radius", "1e9"],
             "--cutter-radius: 1000000000 is too large for a base radius of 40; allowed is at most 4e+07"),
            (["--chord-tolerance", "nan"], "--chord-tolerance: 'nan'"),
            (["--chord-tolerance", "1e-12"], "allowed is a length from 4e-08 to 40"),
            (["--chord-tolerance", "50"], "--chord-tolerance: 50"),
            (["--design", "0"], "--design: '0'"),
            (["--design", "2"], "there is no design 2; allowed is --design from 1 to 1"),
            (["--out", ""], "--out"),
            (["--steps", "9"], "--steps: is for linkages; of a cam --curve,"),
            (["--dxf-version", "r13"], "--dxf-version: 'r13' is not possible; allowed is r12 or 2000"),
            (["--dxf-version", "r12"], "expected --format dxf with it"),
        ]:
            with self.subTest(options):
                self.expect_refusal(self.refused(result, *options), part)
        self.expect_refusal(self.refused(result, form="iges"), "--format: 'iges'", "dxf, svg, csv, step or stl")
        self.expect_refusal(self.refused(result, form="dot"), "--format: json, dot", "are for linkages")
        self.expect_refusal(
            self.refused(result, "--parts", "--hole", "2", "--width", "5", form="dxf"),
            "--parts: is for linkages",
        )
        self.expect_refusal(run("export", result), "--format")
        self.assertFalse((self.folder / "cam.profile.csv").exists())
        flat = self.solve(problem(['type = "translating-flat"'], 10, {"base_radius": 40}))
        self.expect_refusal(self.refused(flat, "--curve", "pitch"), "no roller", "profile or cutter")

    def test_tolerances_that_cannot_be_kept(self):
        # The tolerance left out is 1e-4 of the base radius, far below what the rise allows.
        result = self.solve(problem(['type = "translating-flat"'], 25, {"base_radius": 1e-9}))
        done = self.refused(result)
        self.expect_refusal(done, "--chord-tolerance: 1e-13 would take more than 2000000 points")
        self.assertFalse((self.folder / "cam.profile.csv").exists())
        self.export(result, "csv", "--chord-tolerance", "1e-9")

    def test_files_that_are_no_cams(self):
        good = json.loads(self.solve(roller_problem()).read_text())

        def changed(**members):
            document = json.loads(json.dumps(good))
            document["designs"][0]["mechanism"].update(members)
            return json.dumps(document)

        where = "designs[0].mechanism: "
        for text, part in [
            ("", ":1:1: not valid JSON"),
            ('{\n  "format": nonsense}', ":2:14: not valid JSON"),
            ('{"format": 1e999}', "not valid JSON"),
            ("[" * 100000 + "]" * 100000, "nested too deep"),
            ("[]", "no result of Cognate"),
            ('{"format": "cognate-result/2"}', "no result of Cognate"),
            ('{"format": "cognate-result/1"}', "no design"),
            (json.dumps({**good, "designs": []}), "no design"),
            (json.dumps({**good, "designs": [{}]}), "no mechanism with a type"),
            (changed(type="can"), 'mechanism.type'),
            (changed(base_radius=-1), where + "mechanism.base_radius"),
            (changed(base_radius="wide"), where + "mechanism.base_radius"),
            (changed(base_radius=None), where),
            (changed(frobnicate=1), where + 'unknown key "frobnicate"'),
            (changed(motion=[]), where + "motion"),
            (changed(offset=41), where),
            (changed(follower="hovering"), where + "follower.type"),
        ]:
            with self.subTest(part):
                file = self.folder / "bad.result.json"
                file.write_text(text)
                self.expect_refusal(self.refused(file), f"{file}", part)
        self.expect_refusal(self.refused(self.folder / "missing.json"), "does not exist")
        self.expect_refusal(self.refused(self.folder), "directory")
        self.assertEqual(list(self.folder.glob("bad*.csv")), [])


if __name__ == "__main__":
    PROGRAM, LIBRARY = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
