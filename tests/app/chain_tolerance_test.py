"""Tolerances and rasters of chains that are searched, against closures computed here: differences of
the output by each dimension, and every combination of a raster.

Run as: chain_tolerance_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import cmath
import copy
import itertools
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import Chain  # noqa: E402
from written_files import command, solved  # noqa: E402

LIBRARY = pathlib.Path()
STEP = 1e-6

FOUR_BAR = """
kind = "function-generation"
[target]
function = "x^2"
domain = [0, 1]
input_range_deg = 60
output_range_deg = 30
output = {output}
[mechanism]
type = "chain"
[[pivot]]
name = "A"
at = [0, 0]
[[pivot]]
name = "D"
[crank]
at = "A"
pin = "B"
length = 1
[[dyad]]
joins = ["B", "D"]
new = "C"
{point}
[bounds]
length = [0.4, 5]
[constraints]
transmission_angle_deg = [40, 140]
[solve]
starts = 48
designs = 1
[tolerance]
length = 0.002
samples = 20000
clearance = {{ A = 0.001, B = 0.001, C = 0.001, D = 0.001 }}
"""

POINT = """[[point]]
name = "E"
on = ["B", "C"]
at = [1, 0.8]"""

DWELL = """
kind = "function-generation"
[target]
dwell = [{ over_deg = 100 }]
swing_deg_min = 60
[mechanism]
type = "stephenson-3"
[constraints]
transmission_angle_deg = [40, 140]
[solve]
starts = 64
designs = 1
[tolerance]
length = 0.002
samples = 20000
"""


def lengths(mechanism):
    """Where a mechanism has the numbers that `length` of `[tolerance]` is of: (table, key) each."""
    places = [(mechanism["crank"], "length")]
    for dyad in mechanism["dyad"]:
        places += [(dyad["lengths"], i) for i in range(len(dyad["lengths"]))]
        if "slide" in dyad:
            places.append((dyad["slide"], "offset"))
    for point in mechanism.get("point", []):
        places += [(point["at"], i) for i in range(2)]
    return places


def way(mechanism, output, drive):
    at = Chain(mechanism).places(drive)
    return at[output[1]] - at[output[0]]


def rates(mechanism, output, drive):
    """Of the direction from one point of `output` to the other, in radians by each length."""
    found = []
    for k in range(len(lengths(mechanism))):
        ends = []
        for sign in (1, -1):
            changed = copy.deepcopy(mechanism)
            table, key = lengths(changed)[k]
            table[key] += sign * STEP
            ends.append(way(changed, output, drive))
        found.append(cmath.phase(ends[0] / ends[1]) / (2 * STEP))
    return found


def judged(table):
    return next(quantity for quantity in table["quantities"] if quantity["judged"])


class Angles(unittest.TestCase):
    def check(self, result, output, tolerance, every=1):
        self.assertEqual(result["status"], "solved")
        design = result["designs"][0]
        table = design["tolerance"]
        positions = judged(table)["positions"]
        for i in range(0, len(table["crank_deg"]), every):
            own = rates(design["mechanism"], output, math.radians(table["crank_deg"][i]))
            linear = math.degrees(tolerance * sum(map(abs, own)))
            rss = math.degrees(tolerance * math.hypot(*own))
            self.assertAlmostEqual(positions["linear"][i] / linear, 1, delta=1e-6)
            self.assertAlmostEqual(positions["rss"][i] / rss, 1, delta=1e-6)
            if i % 7 == 0:  # samples: normal, three standard deviations being the tolerance
                self.assertAlmostEqual(positions["sigma"][i] / (rss / 3), 1, delta=0.03)
        return table

    def test_a_link_whose_points_are_on_it_by_either_end(self):
        either = []
        for output in (["C", "D"], ["D", "C"]):
            table = self.check(solved(FOUR_BAR.format(output=output, point="")), output, 0.002)
            either.append(judged(table)["linear"])
            # The massless rod BC is longer by the clearance of either of its pins.
            pins = {pin["joint"]: pin["massless"] for pin in table["clearance"]}
            self.assertAlmostEqual(pins["B"], pins["C"], delta=1e-9)
            rod = next(row for row in judged(table)["contributions"] if row["dimension"] == "BC")
            self.assertAlmostEqual(pins["B"], 0.001 * abs(rod["largest"]), delta=1e-9)
        self.assertAlmostEqual(either[0], either[1], delta=1e-9)

    def test_a_link_by_a_point_that_is_given_on_it(self):
        """The point's own coordinates turn the direction, though not the link."""
        output = ["B", "E"]
        table = self.check(solved(FOUR_BAR.format(output=output, point=POINT)), output, 0.002)
        influence = {row["dimension"]: abs(row["largest"]) for row in judged(table)["contributions"]}
        self.assertGreater(influence["E.u"], 1)
        self.assertGreater(influence["E.v"], 1)

    def test_dwells_of_a_six_bar(self):
        result = solved(DWELL)
        table = self.check(result, result["problem"]["target"]["output"], 0.002, every=5)
        band = result["designs"][0]["metrics"]["half_band_deg"]
        nominal = [abs(value) for value in judged(table)["positions"]["nominal"]]
        self.assertLessEqual(max(nominal), band * (1 + 1e-6))


class Sliders(unittest.TestCase):
    def test_both_pins_of_the_rod_move_the_slider_alike(self):
        text = (LIBRARY / "chain-function" / "toleranced-square.toml").read_text()
        result = solved(text.replace("samples = 20000", "samples = 0\nclearance = { B = 0.1, C = 0.1 }"))
        table = result["designs"][0]["tolerance"]
        pins = {pin["joint"]: pin["massless"] for pin in table["clearance"]}
        rod = next(row for row in judged(table)["contributions"] if row["dimension"] == "BC")
        for pin in ("B", "C"):
            self.assertAlmostEqual(pins[pin] / (0.1 * abs(rod["largest"])), 1, delta=1e-9)


RASTER = """
kind = "path-generation"
[target]
points = {points}
closed = true
[mechanism]
type = "slider-crank"
[[pivot]]
name = "A"
at = [0, 0]
[[dyad]]
new = "C"
slide = {{ direction_deg = 10, offset = 0.5 }}
[raster]
crank = [1, 1.1]
length = [3]
coupler_point = [1, 2]
[solve]
starts = 64
"""
POINTS = [[2.28, 1.54], [2.40, 1.75], [2.06, 1.945], [1.27, 1.81], [0.59, 1.45], [0.36, 1.09],
          [0.82, 0.837], [1.78, 1.17]]
SAMPLES = 180


def least_in_order(curve, points):
    """The least mean square of distances from samples of a closed curve that are passed in order."""
    best = math.inf
    for begin in range(SAMPLES):
        row = [abs(curve[begin] - points[0]) ** 2] * SAMPLES
        for point in points[1:]:
            least, earlier = math.inf, math.inf
            for k in range(SAMPLES):
                least = min(least, earlier + abs(curve[(begin + k) % SAMPLES] - point) ** 2)
                earlier, row[k] = row[k], least
        best = min(best, row[-1])
    return best / len(points)


class Rasters(unittest.TestCase):
    def least(self, points):
        """Of all combinations and both assemblies."""
        guide, least = cmath.rect(1, math.radians(10)), math.inf
        for crank, u, v, side in itertools.product((1, 1.1), (1, 2), (1, 2), (1, -1)):
            curve = []
            for i in range(SAMPLES):
                b = cmath.rect(crank, 2 * math.pi * i / SAMPLES)
                away = b / guide - 0.5j
                c = guide * complex(away.real + side * math.sqrt(9 - away.imag ** 2), 0.5)
                curve.append(b + complex(u, v) * (c - b) / abs(c - b))
            least = min(least, least_in_order(curve, points), least_in_order(curve[::-1], points))
        return least

    def test_free_timing_is_sought_anew_for_every_combination(self):
        random_ = random.Random(4)
        for spread in (0, 0.1, 0.3):
            points = [[x + random_.uniform(-spread, spread), y + random_.uniform(-spread, spread)]
                      for x, y in POINTS]
            result = solved(RASTER.format(points=points))
            least = math.sqrt(self.least([complex(*point) for point in points]))
            rms = result["designs"][0]["error"]["rms"]
            # Between the samples a curve comes nearer still.
            self.assertLess(rms, least * (1 + 1e-12))
            self.assertGreater(rms, 0.97 * least)
            self.assertTrue(result["facts"]["raster_proven"])
            self.assertAlmostEqual(result["facts"]["raster_bound"], rms, delta=1e-6 * rms)

    def test_what_stays_free_beside_a_raster_is_no_proof(self):
        text = RASTER.format(points=POINTS).replace(", offset = 0.5 }", " }")
        text += "[bounds]\nlength = [0.1, 9]\npivots = [[-9, -9], [9, 9]]\n"
        result = solved(text)
        self.assertFalse(result["facts"]["raster_proven"])

    def test_values_out_of_bounds_are_refused(self):
        text = RASTER.format(points=POINTS) + "[bounds]\nB = [3, 4]\n"
        done = command(text, "check")
        self.assertEqual(done.returncode, 2)
        self.assertIn("raster has no value of crank within its bounds [3, 4]; expected at least one", done.stderr)


if __name__ == "__main__":
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
