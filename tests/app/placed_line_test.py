"""Straight lines that have a place in the plane, and pivots that have a region beside them, from outside.

Run as: placed_line_test.py PROGRAM, the built program.

What designs do is computed again from the dimensions in the result, by the intersections of two
circles, or of a circle and a line, in complex numbers. A place (x, y) is x + iy.
"""

import cmath
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

from thinned import some, whole_only
from toml_text import toml_of

PROGRAM = ""

FINE = 4000
# What the program's checks allow, in shares of the line's length.
SLACK = 1e-6


def place(pair):
    return complex(*pair)


def pair(at):
    return [at.real, at.imag]


def circle_point(b, coupler, d, rocker, side):
    """Where the circles about b and d meet, to the left of b -> d for side 1."""
    base = abs(d - b)
    along = (coupler**2 - rocker**2 + base**2) / (2 * base)
    return b + (d - b) / base * complex(along, side * math.sqrt(coupler**2 - along**2))


def traced(mechanism, angle):
    """The coupler point of a mechanism of a result, its crank at an angle."""
    side = 1 if mechanism["assembly"] == "open" else -1
    point = place(mechanism.get("coupler_point") or mechanism["point"][0]["at"])
    if mechanism["type"] == "four-bar":
        a, d = map(place, mechanism["fixed_pivots"])
        b = a + cmath.rect(mechanism["crank"], angle)
        c = circle_point(b, mechanism["coupler"], d, mechanism["rocker"], side)
    else:
        a, guide = place(mechanism["pivot"]), cmath.rect(1, math.radians(mechanism["direction_deg"]))
        b = a + cmath.rect(mechanism["crank"], angle)
        rise = mechanism["offset"] - ((b - a) / guide).imag
        c = b + guide * complex(side * math.sqrt(mechanism["coupler"]**2 - rise**2), rise)
    return b + (c - b) / abs(c - b) * point


def pivots(mechanism):
    return list(map(place, mechanism.get("fixed_pivots") or [mechanism["pivot"]]))


def path_of(mechanism, low, high):
    return [traced(mechanism, low + (high - low) * k / FINE) for k in range(FINE + 1)]


def best_line(points):
    """Both feet of the ends on the middle of the narrowest strip, and half its width."""
    chord = points[-1] - points[0]

    def strip(turn):
        heights = [((p - points[0]) / (chord / abs(chord)) * cmath.exp(-1j * turn)).imag for p in points]
        return min(heights), max(heights)

    low, high = -0.1, 0.1
    for _ in range(60):  # the width is convex in the direction
        one, other = low + (high - low) / 3, high - (high - low) / 3
        widths = [top - bottom for bottom, top in map(strip, (one, other))]
        low, high = (low, other) if widths[0] < widths[1] else (one, high)
    bottom, top = strip(low)
    way = chord / abs(chord) * cmath.exp(1j * low)
    feet = [points[0] + way * complex(((p - points[0]) / way).real, (bottom + top) / 2)
            for p in (points[0], points[-1])]
    return feet, (top - bottom) / 2


# Hoeken's linkage with its point, and between which crank angles it is looked at.
HOEKEN = {"type": "four-bar", "fixed_pivots": [[0, 0], [2, 0]], "crank": 1, "coupler": 2.5, "rocker": 2.5,
          "coupler_point": [5, 0], "assembly": "open"}
REACH = math.radians(80)
SIZE = 5  # its largest dimension, B-P


def moved(mechanism, move, mirror):
    """The mechanism in another place; `mirror`: its image in the x axis, moved."""
    image = (lambda z: z.conjugate()) if mirror else (lambda z: z)
    u, v = mechanism["coupler_point"]
    return mechanism | {"fixed_pivots": [pair(move(image(p))) for p in pivots(mechanism)],
                        "coupler_point": [u, -v] if mirror else [u, v],
                        "assembly": "crossed" if mirror else "open"}


def placed_between(mechanism, ends, mirror, reverse):
    """Hoeken's linkage enlarged and moved so that its line goes from end to end; its deviation."""
    own, deviation = best_line(path_of(mechanism, math.pi - REACH, math.pi + REACH))
    feet = [p.conjugate() for p in own] if mirror else own
    wanted = ends[::-1] if reverse else ends
    turn = (wanted[1] - wanted[0]) / (feet[1] - feet[0])
    scale = abs(turn)
    larger = mechanism | {key: scale * mechanism[key] for key in ("crank", "coupler", "rocker")}
    larger["coupler_point"] = [scale * x for x in mechanism["coupler_point"]]
    return moved(larger, lambda z: wanted[0] + turn * (z - feet[0]), mirror), scale * deviation


def box_of(places, margin):
    return [[min(p.real for p in places) - margin, min(p.imag for p in places) - margin],
            [max(p.real for p in places) + margin, max(p.imag for p in places) + margin]]


def document(ends, constraints=None, solve=None, **tables):
    return {"kind": "straight-line", "target": {"ends": [pair(p) for p in ends]}, **tables,
            "constraints": constraints or {}, "solve": {"designs": 1, **(solve or {})}}


def run(command, text, *options):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "line.toml")
        file.write_text(text)
        return subprocess.run([PROGRAM, command, str(file), *options], capture_output=True, text=True,
                              check=False)


def solved(problem):
    done = run("solve", toml_of(problem), "--json")
    return json.loads(done.stdout)


LINES = {"at the origin": (-0.5 + 0j, 0.5 + 0j), "aslant": (20 + 10j, 27 - 14j),
         "upwards": (3 + 4j, 3 + 9j), "small and far away": (1000 + 500j, 1000.02 + 500.01j)}


class Placed(unittest.TestCase):
    """Every design is looked at again by its dimensions alone."""

    def assert_on_line(self, design, ends):
        low, high = (math.radians(design["metrics"][f"crank_{name}_deg"]) for name in ("from", "to"))
        length = abs(ends[1] - ends[0])
        way = (ends[1] - ends[0]) / length
        seen = [(p - ends[0]) / way for p in path_of(design["mechanism"], low, high)]
        first, last = sorted((seen[0].real, seen[-1].real))
        self.assertLess(abs(first), 2 * SLACK * length)
        self.assertLess(abs(last - length), 2 * SLACK * length)
        deviation = max(abs(p.imag) for p in seen)
        reported = design["metrics"]["deviation"]
        self.assertLess(abs(deviation - reported), 1e-3 * reported + 1e-9 * (length + abs(ends[0])))

    def assert_in_region(self, design, region):
        size = max(abs(x) for corner in region for x in corner)
        for at in pivots(design["mechanism"]):
            for k, x in enumerate(pair(at)):
                self.assertGreaterEqual(x, region[0][k] - 1e-8 * size)
                self.assertLessEqual(x, region[1][k] + 1e-8 * size)

    def best_of(self, problem):
        result = solved(problem)
        self.assertEqual(result["status"], "solved", result.get("notes"))
        design = result["designs"][0]
        ends = list(map(place, problem["target"]["ends"]))
        self.assert_on_line(design, ends)
        names = {check["name"] for check in design["constraints"]}
        self.assertIn("target.ends", names)
        if region := problem["constraints"].get("pivot_region"):
            self.assert_in_region(design, region)
            self.assertTrue(any(name.startswith("pivot_region.") for name in names))
        return design


class Lines(Placed):
    def test_without_limits_of_the_place_designs_are_those_of_the_length(self):
        rest = {"constraints": {"class": "crank-rocker"}, "solve": {"starts": 40}}
        for name, ends in some(LINES.items()):
            with self.subTest(name):
                design = self.best_of(document(ends, **rest))
                alone = document(ends, **rest)
                alone["target"] = {"length": abs(ends[1] - ends[0])}
                other = solved(alone)["designs"][0]
                for key in ("crank", "coupler", "rocker"):
                    self.assertAlmostEqual(design["mechanism"][key] / other["mechanism"][key], 1, 6)

    @whole_only
    def test_either_end_may_be_the_first(self):
        p, q = LINES["aslant"]
        region = box_of([p, p + 20j], 10)
        found = [self.best_of(document(ends, {"pivot_region": region})) for ends in ((p, q), (q, p))]
        one, other = (design["metrics"]["deviation"] for design in found)
        self.assertLess(abs(one / other - 1), 0.1)

    @whole_only
    def test_the_smallest_linkage_too(self):
        p, q = LINES["aslant"]
        length = abs(q - p)
        problem = document((p, q), {"pivot_region": box_of([p, q], 0.6 * length)})
        problem["target"]["deviation_relative"] = 0.005
        design = self.best_of(problem)
        self.assertLessEqual(design["metrics"]["deviation"], 0.005 * length * (1 + SLACK))

    @whole_only
    def test_dimensions_on_a_raster(self):
        ends = LINES["upwards"]
        problem = document(ends, {"class": "crank-rocker"}, {"starts": 40}, raster={"crank": 0.5})
        crank = self.best_of(problem)["mechanism"]["crank"]
        self.assertAlmostEqual(2 * crank, round(2 * crank), 9)

    @whole_only
    def test_a_region_beside_the_line_that_nothing_else_limits(self):
        """The pivots stand on one side, far from where the best linkage without a region has them."""
        p, q = LINES["at the origin"]
        free = self.best_of(document((p, q)))
        side = 1 if sum(at.imag for at in pivots(free["mechanism"])) < 0 else -1
        low, high = sorted((side * 0.3, side * 2))
        region = [[-2, low], [2, high]]
        design = self.best_of(document((p, q), {"pivot_region": region}))
        # The image of the free design in the line is as good, as far as it is in the region.
        image = [at.conjugate() for at in pivots(free["mechanism"])]
        if all(low <= at.imag <= high and abs(at.real) <= 2 for at in image):
            self.assertLess(design["metrics"]["deviation"], 1.02 * free["metrics"]["deviation"])


    @whole_only
    def test_no_design_that_is_found_without_the_region_is_better_in_it(self):
        """Of many designs each is put in its four places, and those in the region are compared."""
        ends = (-60 + 5j, 10 + 20j)
        middle, way = (ends[0] + ends[1]) / 2, (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        region = [[-130, -215], [30, -60]]
        limits = {"class": "crank-rocker", "transmission_angle_deg": [40, 140]}
        best = self.best_of(document(ends, limits | {"pivot_region": region}))["metrics"]["deviation"]
        images = [lambda z: z, lambda z: -z, lambda z: z.conjugate(), lambda z: -z.conjugate()]
        compared = 0
        for design in solved(document(ends, limits, {"designs": 30}))["designs"]:
            own = [(at - middle) / way for at in pivots(design["mechanism"])]
            for image in images:
                places = [middle + way * image(at) for at in own]
                if all(region[0][k] <= pair(at)[k] <= region[1][k] for at in places for k in (0, 1)):
                    compared += 1
                    self.assertLessEqual(best, design["metrics"]["deviation"] * (1 + SLACK))
        self.assertGreater(compared, 0)


class Planted(Placed):
    """Hoeken's linkage in each of its four places on a line, its pivots barely in the region."""

    def found(self, ends, planted, tables):
        scale = planted["crank"]
        constraints = {"class": "crank-rocker", "size_over_length_max": 1.001 * SIZE * scale / abs(ends[1] - ends[0]),
                       "crank_range_deg": [120, 200]} | tables.pop("constraints", {})
        return self.best_of(document(ends, constraints, **tables))

    def test_a_design_as_good_is_found_in_every_place(self):
        apart = []
        turned = [(mirror, reverse) for mirror in (False, True) for reverse in (False, True)]
        cases = [(name, *two) for name in list(LINES)[1:] for two in turned]
        for name, mirror, reverse in some(some(cases)):
            with self.subTest(name, mirror=mirror, reverse=reverse):
                ends = LINES[name]
                planted, deviation = placed_between(HOEKEN, ends, mirror, reverse)
                region = box_of(pivots(planted), 0.01 * planted["crank"])
                apart.append(tuple(region[0]))
                design = self.found(ends, planted, {"constraints": {"pivot_region": region}})
                self.assertLessEqual(design["metrics"]["deviation"], 1.001 * deviation)
        self.assertEqual(len(set(apart)), len(apart))

    def test_pivots_that_are_given(self):
        ends = LINES["aslant"]
        planted, deviation = placed_between(HOEKEN, ends, True, False)
        given = planted["fixed_pivots"]
        design = self.found(ends, planted, {"mechanism": {"fixed_pivots": given}})
        self.assertEqual(design["mechanism"]["fixed_pivots"], given)
        self.assertLessEqual(design["metrics"]["deviation"], 1.001 * deviation)

    def test_one_pivot_and_the_direction_of_the_frame(self):
        ends = LINES["upwards"]
        planted, deviation = placed_between(HOEKEN, ends, False, True)
        a, d = pivots(planted)
        given = {"pivot_d": pair(d), "frame_angle_deg": math.degrees(cmath.phase(d - a))}
        design = self.found(ends, planted, {"mechanism": given})
        self.assertLess(abs(pivots(design["mechanism"])[1] - d), 1e-8)
        self.assertLessEqual(design["metrics"]["deviation"], 1.001 * deviation)

    def test_scott_russells_slider_crank(self):
        """Crank, coupler and B-P equal: exact, on a line across the slide line through the pivot."""
        p, q = LINES["aslant"]
        length = abs(q - p)
        pivot = (p + q) / 2
        region = box_of([pivot], 0.02 * length)
        design = self.best_of(document((p, q), {"pivot_region": region}, mechanism={"type": "slider-crank"}))
        self.assertLess(design["metrics"]["deviation"], 1e-9 * length)

    def test_no_pivot_can_stand_so_far_away(self):
        result = solved(document((0j, 1 + 0j), {"pivot_region": [[50, 50], [51, 51]]}, {"starts": 10}))
        self.assertEqual(result["status"], "infeasible")
        failed = [check["name"] for check in result["designs"][0]["constraints"] if not check["satisfied"]]
        self.assertTrue(failed)


class Files(unittest.TestCase):
    REFUSED = {
        "ends = [[1, 2], [1, 2]]": "apart; expected two places",
        "ends = [[1, 2]]": "has 1 end; expected 2",
        "ends = [[1, 2], [3]]": "[[x1, y1], [x2, y2]]",
        "ends = [[0, 0], [3, 4]]\nlength = 6": "is 6, but the ends given are 5 apart",
        "ends = [[0, 0], [3, 3]]\ndirection_deg = 44": "whose direction is 45 degrees",
        "ends = [[0, 0], [3, 4]]\ndeviation = 0.6": "more than a tenth of the length 5",
        'ends = [[0, 0], [3, 4]]\nmethod = "exact"': "knows curvature alone",
        "ends = [[0, 0], [1, 0]]\n[constraints]\npivot_region = [[0, 0], [1, 1]]\n[raster]\nlength = 0.1":
            "dimensions on a raster do not meet",
        "length = 1\n[mechanism]\ntype = \"slider-crank\"\n[constraints]\npivot_region = [[0, 0], [1, 1]]":
            "add target.ends",
        "ends = [[0, 0], [1, 0]]\n[mechanism]\npivot_a = [5, 5]\n[constraints]\npivot_region = [[0, 0], [1, 1]]":
            "does not contain the given pivot",
    }

    def test_what_contradicts_itself_is_refused(self):
        for target, message in self.REFUSED.items():
            with self.subTest(target):
                done = run("check", f'kind = "straight-line"\n[target]\n{target}\n')
                self.assertEqual(done.returncode, 2)
                self.assertIn(message, done.stderr)

    def test_what_is_the_same_may_be_said_twice(self):
        for more in ("length = 5", "direction_deg = 53.13010235415598", "direction_deg = -126.86989764584402"):
            text = f'kind = "straight-line"\n[target]\nends = [[0, 0], [3, 4]]\n{more}\n'
            self.assertEqual(run("check", text).returncode, 0, more)

    def test_a_problem_is_written_as_it_is_read(self):
        region = [[-3, -2], [4, 5]]
        problem = document((1 + 2j, 4 + 6j), {"pivot_region": region})
        written = solved(problem | {"solve": {"starts": 2, "designs": 1}})["problem"]
        self.assertEqual(written["target"], {"ends": [[1, 2], [4, 6]]})
        self.assertEqual(written["constraints"]["pivot_region"], region)
        again = solved(written)["problem"]
        self.assertEqual(again, written)

    def test_the_key_is_listed(self):
        done = subprocess.run([PROGRAM, "list", "straight-line"], capture_output=True, text=True, check=True)
        self.assertIn("target.ends", done.stdout)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
