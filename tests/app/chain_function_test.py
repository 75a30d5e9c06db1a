"""Functions of six-bars and chains of dyads, against closures computed here point by point.

Run as: chain_function_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import cmath
import math
import pathlib
import random
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import Chain  # noqa: E402
from thinned import ordinarily, some, whole_only  # noqa: E402
from three_pin_paths import unrolled  # noqa: E402
from written_files import analysed, command, solved  # noqa: E402

LIBRARY = pathlib.Path()


class Function:
    """Increments of input and output in radians, by a problem's target."""

    def __init__(self, target, y=None):
        self.y = y
        if "pairs_deg" in target:
            self.pairs = [tuple(map(math.radians, pair)) for pair in target["pairs_deg"]]
            self.samples = self.pairs
            return
        (self.x0, self.x1), self.pairs = target["domain"], None
        self.angles = target.get("relation") == "angles"
        if not self.angles:
            self.input = math.radians(target["input_range_deg"])
            self.output = math.radians(target["output_range_deg"])
        self.samples = [self.at(x) for x in target["sample_at"]]

    def at(self, x):
        if self.angles:
            return x, self.y(x)
        rise = (self.y(x) - self.y(self.x0)) / (self.y(self.x1) - self.y(self.x0))
        return self.input * (x - self.x0) / (self.x1 - self.x0), self.output * rise

    def dense(self, count=2000):
        if self.pairs:
            return self.pairs
        return [self.at(self.x0 + (self.x1 - self.x0) * i / count) for i in range(count + 1)]


def errors(chain, output, start, pairs):
    """What the output errs by, from the direction it has at the first pair."""
    found, reference = [], None
    for turned, wanted in pairs:
        at = chain.places(start + turned)
        if at is None:
            raise AssertionError("the chain does not close")
        way = (at[output[1]] - at[output[0]]) * cmath.exp(-1j * wanted)
        reference = reference or way
        found.append(cmath.phase(way / reference))
    return found


class Designs(unittest.TestCase):
    """Every design, computed again here."""

    def check(self, result, y=None, rms_deg=None, max_deg=None):
        self.assertEqual(result["status"], "solved", result["notes"])
        problem = result["problem"]
        target, limits = problem["target"], problem["constraints"]
        function = Function(target, y)
        low, high = limits.get("transmission_angle_deg", (0, 180))
        for design in result["designs"]:
            chain, output = Chain(design["mechanism"]), target["output"]
            start = math.radians(design["metrics"]["input_start_deg"])
            self.check_errors(design, chain, output, start, function, target["objective"])
            inputs = [turned for turned, _ in function.dense()]
            first, last = ((min(inputs), max(inputs)) if limits["over"] == "range" else (0, 2 * math.pi))
            acute = min(chain.transmission(chain.places(start + first + (last - first) * i / 1500))
                        for i in range(1501))
            self.assertGreaterEqual(acute, max(low, 180 - high) - 1e-5)
            self.assertAlmostEqual(acute, design["metrics"]["transmission_angle_deg"]["acute_min"], delta=2e-3)
        if rms_deg:
            self.assertLess(result["designs"][0]["error"]["rms_deg"], rms_deg)
        if max_deg:
            self.assertLess(result["designs"][0]["error"]["max_deg"], max_deg)

    def check_errors(self, design, chain, output, start, function, objective):
        found = errors(chain, output, start, function.samples)
        if objective == "minimax":
            level = (max(found) + min(found)) / 2
        else:
            level = sum(found) / len(found)
        rms = math.sqrt(sum((one - level) ** 2 for one in found) / len(found))
        self.assertAlmostEqual(rms, design["error"]["rms"], delta=1e-10 + 1e-6 * rms)
        dense = errors(chain, output, start, function.dense())
        # From the first sample, which both begin with.
        greatest = max(abs(one - level) for one in dense)
        self.assertAlmostEqual(greatest, design["error"]["max"], delta=1e-10 + 1e-3 * greatest)
        self.assertGreaterEqual(design["error"]["max"], greatest - 1e-12)
        turned, wanted = function.samples[0]
        at = chain.places(start + turned)
        way = math.degrees(cmath.phase(at[output[1]] - at[output[0]]))
        expected = design["metrics"]["output_start_deg"] + math.degrees(wanted + found[0] - level)
        self.assertAlmostEqual(math.remainder(way - expected, 360), 0, delta=1e-6)

    def library(self, name, starts):
        text = (LIBRARY / "chain-function" / f"{name}.toml").read_text()
        return text.split("\n[solve]")[0] + f"\n[solve]\nstarts = {starts}\ndesigns = 3\n"

    def test_logarithm(self):
        self.check(solved(self.library("six-bar-logarithm", ordinarily(192, 768))), math.log10,
                   rms_deg=ordinarily(0.05, 0.0005))

    def test_minimax_of_the_other_sense(self):
        text = self.library("six-bar-logarithm", ordinarily(256, 512)).replace("output_range_deg = 90", "output_range_deg = -90")
        text = text.replace("[target]", '[target]\nobjective = "minimax"').replace("six-bar\"", "stephenson-3\"")
        result = solved(text)
        self.check(result, math.log10, max_deg=0.05)
        # By the errors' equal height on both sides, at more places than there are in a four-bar.
        design = result["designs"][0]
        self.assertLess(design["error"]["max"], 2.5 * design["error"]["rms"])

    def test_limits_over_the_whole_turn(self):
        text = self.library("six-bar-logarithm", 256).replace("[40, 140]", '[30, 150]\nover = "turn"')
        result = solved(text)
        self.assertEqual(result["problem"]["constraints"]["over"], "turn")
        self.check(result, math.log10, rms_deg=2)

    @whole_only
    def test_two_strokes_in_a_turn(self):
        text = self.library("two-strokes", 768)
        self.check(solved(text), lambda x: 0.3 * math.cos(2 * x), rms_deg=0.056)

    def test_given_parts(self):
        text = self.library("six-bar-logarithm", 256).replace("six-bar\"", "watt-2\"").replace("[40, 140]", "[30, 150]")
        text = re.sub(r"\[bounds\]\n.*\n", "", text)
        text = text.replace("[constraints]", """[crank]
length = 30
[[pivot]]
name = "A"
at = [10, 20]
[bounds]
length = [10, 200]
[constraints]""")
        result = solved(text)
        self.check(result, math.log10, rms_deg=1)
        for design in result["designs"]:
            mechanism = design["mechanism"]
            self.assertEqual(mechanism["crank"]["length"], 30)
            self.assertEqual(mechanism["pivot"][0]["at"], [10, 20])
            lengths = [length for row in mechanism["dyad"] for length in row["lengths"]]
            self.assertTrue(all(10 - 1e-6 <= length <= 200 + 1e-6 for length in lengths), lengths)

    def test_the_mechanism_is_not_turned_about_the_only_pivot_given(self):
        """What differs by that alone is one design: the crank's pivot stands level with the one given."""
        for given, expected in (('name = "D"\nat = [10, 5]', 10 + 5j), ('name = "D"\nat = ["free", 5]', 5j)):
            result = solved(f"""kind = "function-generation"
[target]
function = "1/x"
domain = [1, 2]
input_range_deg = 80
output_range_deg = 45
[mechanism]
type = "stephenson-3"
[[mechanism.pivot]]
{given}
[constraints]
over = "turn"
transmission_angle_deg = [30, 150]
[solve]
designs = 10
starts = 384
""")
            self.check(result, lambda x: 1 / x)
            shapes = []
            for design in result["designs"]:
                pivots = {row["name"]: complex(*row["at"]) for row in design["mechanism"]["pivot"]}
                self.assertEqual(pivots["D"], expected)
                self.assertEqual(pivots["A"].imag, 5)
                along = (pivots["A"] - pivots["D"]) / abs(pivots["A"] - pivots["D"])
                places = [abs(pivots["A"] - pivots["D"]), (pivots["G"] - pivots["D"]) / along]
                dyads = design["mechanism"]["dyad"]
                shapes.append(([row["assembly"] for row in dyads], places + [length for row in dyads for length in row["lengths"]]))
            for i, (sides, shape) in enumerate(shapes):
                for others, other in shapes[:i]:
                    apart = max(abs(a - b) / max(1, abs(a)) for a, b in zip(shape, other))
                    self.assertTrue(sides != others or apart > 0.01, (shape, other))

    def test_chain_given_point_by_point(self):
        self.check(solved("""
kind = "function-generation"
[target]
table = [[0, 0], [1, 0.3], [2, 0.9], [3, 1.8], [4, 2.2]]
input_range_deg = 100
output_range_deg = -40
output = ["O", "Q"]
[mechanism]
type = "chain"
crank = { at = "A", pin = "B" }
pivot = [{ name = "A" }, { name = "D" }, { name = "O" }]
dyad = [{ joins = ["B", "D"], new = "C" }, { joins = ["E", "O"], new = "Q" }]
point = [{ name = "E", on = ["B", "C"] }]
[constraints]
transmission_angle_deg = [35, 145]
[solve]
starts = 192
""".replace("table", "pairs_deg").replace("input_range_deg = 100\noutput_range_deg = -40\n", "")
   .replace("[1, 0.3], [2, 0.9], [3, 1.8], [4, 2.2]", "[25, -6], [50, -17], [75, -33], [100, -40]")), rms_deg=0.05)

    def test_the_first_link_of_the_last_dyad_is_the_output(self):
        """The analysis of what is exported names it, and its swing is that of this closure."""
        result = solved("""kind = "function-generation"
[target]
pairs_deg = [[0, 0], [20, 9], [40, 20], [60, 30]]
output = ["E", "F"]
[mechanism]
type = "chain"
crank = { at = "A", pin = "B" }
pivot = [{ name = "A" }, { name = "D" }, { name = "G" }]
dyad = [{ joins = ["B", "D"], new = "C" }, { joins = ["E", "G"], new = "F" }]
point = [{ name = "E", on = ["B", "C"] }]
[constraints]
over = "turn"
transmission_angle_deg = [30, 150]
[solve]
designs = 1
starts = 16
""")
        self.check(result)
        chain, metrics = Chain(result["designs"][0]["mechanism"]), analysed(result)
        places = [chain.places(2 * math.pi * i / 2880) for i in range(2881)]
        angles = unrolled([cmath.phase(at["F"] - at["E"]) for at in places])
        self.assertEqual(metrics["output"], "EF")
        self.assertAlmostEqual(metrics["output_swing_deg"], math.degrees(max(angles) - min(angles)), delta=1e-3)


class Planted(unittest.TestCase):
    """Angles measured on a six-bar, with noise: what is found errs by less than the one measured."""

    def plant(self, random, kind):
        while True:
            lengths = [random.uniform(0.8, 4) for _ in range(4)]
            side = [random.choice(["open", "crossed"]) for _ in range(2)]
            chain = Chain({
                "pivot": [{"name": "A", "at": (0, 0)}, {"name": "D", "at": (random.uniform(1.5, 4), 0)},
                          {"name": "G", "at": (random.uniform(-4, 5), random.uniform(-4, 4))}],
                "crank": {"at": "A", "pin": "B", "length": 1},
                "dyad": [{"joins": ["B", "D"], "lengths": lengths[:2], "assembly": side[0], "new": "C"},
                         {"joins": ["E", "G"], "lengths": lengths[2:], "assembly": side[1], "new": "F"}],
                "point": [{"name": "E", "on": ["B", "C"] if kind == "stephenson-3" else ["D", "C"],
                           "at": (random.uniform(-1.5, 3), random.uniform(-2, 2))}]})
            start, span = random.uniform(0, 2 * math.pi), math.radians(random.uniform(60, 180))
            places = [chain.places(start + span * i / 200) for i in range(201)]
            if None in places or min(map(chain.transmission, places)) < 25:
                continue
            ways = [at["F"] - at["G"] for at in places]
            angles = [0.0]
            for before, after in zip(ways, ways[1:]):
                angles.append(angles[-1] + cmath.phase(after / before))
            if max(angles) - min(angles) > math.radians(20):
                return [(math.degrees(span) * i / 200, math.degrees(angles[i])) for i in range(0, 201, 10)]

    def test_noise(self):
        random_numbers = random.Random(20)
        for kind in ("stephenson-3", "watt-2"):
            for noise in some((0.02, 0.001, 1)):
                with self.subTest(kind=kind, noise=noise):
                    true = self.plant(random_numbers, kind)
                    errors = [random_numbers.gauss(0, noise) for _ in true]
                    rows = [[turned, angle + error] for (turned, angle), error in zip(true, errors)]
                    mean = sum(errors) / len(errors)
                    planted = math.sqrt(sum((error - mean) ** 2 for error in errors) / len(errors))
                    result = solved(f"""kind = "function-generation"
[target]
pairs_deg = {rows}
[mechanism]
type = "{kind}"
[constraints]
transmission_angle_deg = [20, 160]
[solve]
starts = 512
""")
                    Designs.check(self, result, rms_deg=planted)

    check_errors = Designs.check_errors


class Faults(unittest.TestCase):
    """What is refused, and in which words."""

    FILE = """
kind = "function-generation"
[target]
function = "x^2"
domain = [0, 1]
input_range_deg = 90
output_range_deg = 60
[mechanism]
type = "stephenson-3"
[constraints]
rms_error_deg_max = 1
[solve]
designs = 2
"""

    def test_sound(self):
        done = command(self.FILE, "check")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("y = x^2", done.stdout)

    def test_faults(self):
        for old, new, *words in (
                ("x^2", "1/x", "target.function"),
                ("input_range_deg = 90", "", "input_range_deg is missing"),
                ("input_range_deg = 90", "input_range_deg = 0", "input_range_deg is 0"),
                ("[mechanism]", "precision_points = 3\n[mechanism]", "precision_points is for exact"),
                ("[mechanism]", 'objective = "exact"\n[mechanism]', "expected", "minimax"),
                ("[mechanism]", 'spacing = "equal-peaks"\n[mechanism]', "spacing is for exact"),
                ("[mechanism]", 'output = ["G", "Z"]\n[mechanism]', "output is", 'type = "chain"'),
                ("stephenson-3", "watt-1", "watt-1", "stephenson-3", "four-bar"),
                ("stephenson-3", "stefenson-3", "stefenson-3"),
                ("rms_error", "max_error", "expected constraints.rms_error_deg_max"),
                ("rms_error_deg_max = 1", 'class = "crank-rocker"', "four-bars"),
                ("rms_error_deg_max = 1", 'over = "half"', "over", "range"),
                ("rms_error_deg_max = 1", "transmission_angle_deg = [90, 95]", "no dyad"),
                ("designs = 2", 'solver = "slsqp"', "solver"),
                ("designs = 2", "starts = 0", "starts"),
                ("[solve]", "[raster]\nlength = 1\n[solve]", "raster"),
                ('"stephenson-3"', '"stephenson-3"\ninput_start_deg = 3', "input_start_deg")):
            with self.subTest(new=new):
                self.assertIn(old, self.FILE)
                done = command(self.FILE.replace(old, new), "check")
                self.assertNotEqual(done.returncode, 0, "accepted")
                for word in words:
                    self.assertIn(word, done.stdout + done.stderr)

    def test_error_that_cannot_be_met(self):
        text = self.FILE.replace("rms_error_deg_max = 1", "rms_error_deg_max = 1e-9").replace(
            "x^2", "sin(9*x) + x").replace("designs = 2", "starts = 128")
        result = solved(text)
        self.assertEqual(result["status"], "infeasible")
        missed = [one for one in result["designs"][0]["constraints"] if not one["satisfied"]]
        self.assertEqual([one["name"] for one in missed], ["rms_error_deg_max"])


if __name__ == "__main__":
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
