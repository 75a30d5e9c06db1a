"""Chains with sliders: coupler curves, functions and dwells whose output is a slider, against closures
computed here point by point.

Run as: slider_chain_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import Chain, guide_of, size_of  # noqa: E402
from thinned import ordinarily, some  # noqa: E402
from written_files import command, solved  # noqa: E402

LIBRARY = pathlib.Path()


def turned(count, first, last):
    return [first + (last - first) * i / count for i in range(count + 1)]


def displacement(chain, pin, angle):
    """Along the guide, from the foot of the pivot from which its offset counts."""
    at = chain.places(angle)
    (row,) = (row for row in chain.dyads if row["new"] == pin)
    direction, on = guide_of(at, row)
    return ((at[pin] - on) / direction).real


def errors(chain, pin, start, pairs):
    """Less what is wanted, and their mean."""
    found = [displacement(chain, pin, start + turn) - wanted for turn, wanted in pairs]
    return found, sum(found) / len(found)


class Functions(unittest.TestCase):
    """Every design, computed again here."""

    def check(self, result, pairs, within):
        self.assertEqual(result["status"], "solved", result["notes"])
        problem = result["problem"]
        pin, limits = problem["target"]["output"], problem["constraints"]
        low, high = limits.get("transmission_angle_deg", (0, 180))
        for design in result["designs"]:
            chain = Chain(design["mechanism"])
            start = math.radians(design["metrics"]["input_start_deg"])
            found, mean = errors(chain, pin, start, pairs)
            if problem["target"]["objective"] == "minimax":
                mean = (max(found) + min(found)) / 2
            rms = math.sqrt(sum((one - mean) ** 2 for one in found) / len(found))
            size = max(wanted for _, wanted in pairs) - min(wanted for _, wanted in pairs)
            self.assertAlmostEqual(rms, design["error"]["rms"], delta=1e-9 * size)
            self.assertAlmostEqual(mean, design["metrics"]["output_start"], delta=1e-9 * size)
            inputs = [turn for turn, _ in pairs]
            first, last = (min(inputs), max(inputs)) if limits["over"] == "range" else (0, 2 * math.pi)
            acute = min(chain.transmission(chain.places(start + angle))
                        for angle in turned(1500, first, last))
            self.assertGreaterEqual(acute, max(low, 180 - high) - 1e-5)
            self.assertAlmostEqual(acute, design["metrics"]["transmission_angle_deg"]["acute_min"], delta=2e-3)
        best = result["designs"][0]["error"]
        self.assertLess(best["max" if problem["target"]["objective"] == "minimax" else "rms"], within)

    def samples(self, result, y):
        target = result["problem"]["target"]
        (x0, x1), travel = target["domain"], target["output_range"]
        sweep = math.radians(target["input_range_deg"])
        rise = y(x1) - y(x0)
        return [(sweep * (x - x0) / (x1 - x0), travel * (y(x) - y(x0)) / rise) for x in target["sample_at"]]

    def library(self, name, starts):
        text = (LIBRARY / "chain-function" / f"{name}.toml").read_text()
        return text + f"\n[solve]\nstarts = {starts}\ndesigns = 3\n"

    def test_ram_at_constant_speed(self):
        result = solved(self.library("ram-at-constant-speed", ordinarily(256, 512)))
        self.check(result, self.samples(result, lambda x: x), 0.5)
        for design in result["designs"]:
            lengths = [length for row in design["mechanism"]["dyad"]
                       for length in row.get("lengths", [row.get("length")])]
            self.assertTrue(all(20 - 1e-6 <= length <= 250 + 1e-6 for length in lengths), lengths)

    def test_square_beside_the_exact_one(self):
        """The least greatest error is below that of the design which is exact at four places."""
        result = solved(self.library("slider-crank-square", 256))
        self.check(result, self.samples(result, lambda x: x * x), math.inf)
        exact = solved((LIBRARY / "function" / "slider-crank-in-line.toml").read_text())
        greatest = min(design["error"]["max"] for design in exact["designs"])
        self.assertLess(result["designs"][0]["error"]["max"], greatest)

    def test_planted_slider_cranks(self):
        """Displacements measured on a slider-crank, with noise: the error is below the measured one,
        and without noise next to nothing."""
        draw = random.Random(5)
        for case in some(range(6)):
            with self.subTest(case=case):
                crank, offset = draw.uniform(5, 40), draw.uniform(-20, 20)
                rod = (crank + abs(offset)) * draw.uniform(1.3, 3)
                start, sweep = draw.uniform(0, 2 * math.pi), math.radians(draw.uniform(80, 330))
                noise = (0, 0, 0.1, 0.1, 1, 1)[case]
                pairs, planted = [], []
                for turn in turned(24, 0, sweep):
                    height = offset - crank * math.sin(start + turn)
                    at = crank * math.cos(start + turn) + math.sqrt(rod * rod - height * height)
                    planted.append(draw.gauss(0, noise) if noise else 0)
                    pairs.append((turn, at + planted[-1]))
                begun = pairs[0][1]
                rows = [[math.degrees(turn), at - begun] for turn, at in pairs]
                pairs = [(math.radians(deg), at) for deg, at in rows]
                mean = sum(planted) / len(planted)
                rms = math.sqrt(sum((one - mean) ** 2 for one in planted) / len(planted))
                result = solved(f"""kind = "function-generation"
[target]
pairs = {rows}
objective = "least-squares"
[mechanism]
type = "slider-crank"
[constraints]
transmission_angle_deg = [20, 160]
[solve]
starts = 256
""")
                self.check(result, pairs, max(rms * (1 + 1e-9), 1e-7 * crank))

    def test_chain_with_a_slider_that_is_given_in_part(self):
        """Steps as a die wants them; the guide is vertical and 30 beside the crank's pivot."""
        rows = [[0, 0], [30, 9], [60, 30], [90, 52], [120, 60], [150, 58], [180, 50]]
        result = solved(f"""kind = "function-generation"
[target]
pairs = {rows}
output = "Q"
[mechanism]
type = "chain"
crank = {{ at = "A", pin = "B" }}
pivot = [{{ name = "A", at = [10, 5] }}, {{ name = "D" }}]
dyad = [{{ joins = ["B", "D"], new = "C" }},
        {{ type = "RRP", joins = "C", new = "Q", slide = {{ direction_deg = 90, offset = -30 }} }}]
[constraints]
transmission_angle_deg = [30, 150]
[solve]
starts = 256
""")
        self.check(result, [(math.radians(deg), at) for deg, at in rows], 1.5)
        for design in result["designs"]:
            row = design["mechanism"]["dyad"][1]
            self.assertEqual(row["slide"]["direction_deg"], 90)
            self.assertEqual(row["slide"]["offset"], -30)
            chain = Chain(design["mechanism"])
            self.assertAlmostEqual(chain.places(0.3)["Q"].real, 40, delta=1e-9)


class Dwells(unittest.TestCase):
    """Half bands, strokes and levels by dense samples."""

    def check(self, result):
        self.assertEqual(result["status"], "solved", result["notes"])
        problem = result["problem"]
        target, (low, high) = problem["target"], problem["constraints"]["transmission_angle_deg"]
        for design in result["designs"]:
            chain, metrics, pin = Chain(design["mechanism"]), design["metrics"], target["output"]
            turn = [displacement(chain, pin, angle) for angle in turned(7200, 0, 2 * math.pi)]
            stroke = max(turn) - min(turn)
            self.assertAlmostEqual(stroke, metrics["stroke"], delta=1e-5 * stroke)
            self.assertGreaterEqual(metrics["stroke"], target["stroke_min"] * (1 - 1e-7))
            bands, middles = [], []
            for k, dwell in enumerate(target["dwell"]):
                start, over = math.radians(design["crank_deg"][2 * k]), math.radians(dwell["over_deg"])
                there = [displacement(chain, pin, angle) for angle in turned(7200, start, start + over)]
                bands.append((max(there) - min(there)) / 2)
                middles.append((max(there) + min(there)) / 2)
            self.assertAlmostEqual(max(bands), metrics["half_band"], delta=1e-3 * max(bands) + 1e-9 * stroke)
            self.assertEqual(metrics["half_band"], design["error"]["max"])
            if len(middles) == 2:
                self.assertAlmostEqual(abs(middles[1] - middles[0]), metrics["apart"], delta=1e-5 * stroke)
                self.assertGreaterEqual(metrics["apart"], target["apart"] - 1e-5 * stroke)
            acute = min(chain.transmission(chain.places(angle)) for angle in turned(1500, 0, 2 * math.pi))
            self.assertGreaterEqual(acute, max(low, 180 - high) - 1e-5)
        return result["designs"][0]["metrics"]

    def test_press(self):
        text = (LIBRARY / "dwell" / "press-with-dwell.toml").read_text()
        metrics = self.check(solved(f"{text}\n[solve]\nstarts = {ordinarily(96, 256)}\n"))
        self.assertLess(metrics["half_band"], ordinarily(0.5, 0.05))

    def test_two_dwells_of_a_chain_with_a_given_guide(self):
        metrics = self.check(solved("""kind = "function-generation"
[target]
dwell = [{ over_deg = 40 }, { over_deg = 40 }]
apart = 30
stroke_min = 40
output = "Q"
[mechanism]
type = "chain"
crank = { at = "A", pin = "B" }
pivot = [{ name = "A", at = [3, 1] }, { name = "D" }]
dyad = [{ joins = ["B", "D"], new = "C" },
        { type = "RRP", joins = "E", new = "Q", slide = { direction_deg = 90, offset = "free" } }]
point = [{ name = "E", on = ["B", "C"] }]
[constraints]
transmission_angle_deg = [25, 155]
[solve]
starts = %d
designs = 2
""" % ordinarily(64, 192)))
        self.assertLess(metrics["half_band"], 2)


class Paths(unittest.TestCase):
    """Coupler curves of planted chains with sliders, with noise."""

    def plant(self, draw):
        while True:
            sides = [draw.choice(["open", "crossed"]) for _ in range(2)]
            chain = Chain({
                "pivot": [{"name": "A", "at": (0, 0)}, {"name": "D", "at": (draw.uniform(2, 4), 0)}],
                "crank": {"at": "A", "pin": "B", "length": 1},
                "dyad": [{"joins": ["B", "D"], "lengths": (draw.uniform(2, 4), draw.uniform(2, 4)),
                          "assembly": sides[0], "new": "C"},
                         {"type": "RRP", "joins": "C", "length": draw.uniform(3, 6), "new": "F",
                          "assembly": sides[1],
                          "slide": {"through": "A", "direction_deg": draw.uniform(-90, 90),
                                    "offset": draw.uniform(-2, 2)}}],
                "point": [{"name": "P", "on": ["C", "F"], "at": (draw.uniform(-1, 4), draw.uniform(1, 3))}]})
            places = [chain.places(angle) for angle in turned(180, 0, 2 * math.pi)]
            if None not in places and min(map(chain.transmission, places)) > 30:
                return chain

    def test_noise(self):
        draw = random.Random(3)
        for noise in some((0.02, 0)):
            with self.subTest(noise=noise):
                chain = self.plant(draw)
                true = [chain.places(angle)["P"] for angle in turned(48, 0, 2 * math.pi)[:-1]]
                points = [[at.real + draw.gauss(0, noise), at.imag + draw.gauss(0, noise)] for at in true]
                planted = math.sqrt(sum(abs(at - complex(*point)) ** 2
                                        for at, point in zip(true, points)) / len(true))
                result = solved(f"""kind = "path-generation"
[target]
points = {points}
closed = true
point = "P"
[mechanism]
type = "chain"
crank = {{ at = "A", pin = "B" }}
pivot = [{{ name = "A" }}, {{ name = "D" }}]
dyad = [{{ joins = ["B", "D"], new = "C" }}, {{ type = "RRP", joins = "C", new = "F" }}]
point = [{{ name = "P", on = ["C", "F"] }}]
[constraints]
transmission_angle_deg = [20, 160]
""")
                self.assertEqual(result["status"], "solved", result["notes"])
                found = Chain(result["designs"][0]["mechanism"])
                stations = result["designs"][0]["crank_deg"]
                distances = [abs(found.places(math.radians(deg))["P"] - complex(*point))
                             for deg, point in zip(stations, points)]
                rms = math.sqrt(sum(one * one for one in distances) / len(distances))
                self.assertAlmostEqual(rms, result["designs"][0]["error"]["rms"], delta=1e-9)
                self.assertLess(rms, max(planted, 1e-3 * size_of(points)))
                acute = min(found.transmission(found.places(angle)) for angle in turned(720, 0, 2 * math.pi))
                self.assertGreaterEqual(acute, 20 - 1e-3)


class Faults(unittest.TestCase):
    """What is refused, and in which words."""

    FILE = """
kind = "function-generation"
[target]
function = "x^2"
domain = [0, 1]
input_range_deg = 90
output_range = 60
output = "Q"
[mechanism]
type = "chain"
crank = { at = "A", pin = "B" }
pivot = [{ name = "A" }, { name = "D" }]
dyad = [{ joins = ["B", "D"], new = "C" },
        { type = "RRP", joins = "C", new = "Q", length = 50, slide = { offset = 10 } }]
[bounds]
Q-slide = [5, 20]
[constraints]
rms_error_max = 1
"""

    def test_sound(self):
        done = command(self.FILE, "check")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_faults(self):
        for old, new, *words in (
                ('type = "RRP", ', "", "slide"),
                ("RRP", "RPR", "RPR", "RRR and RRP"),
                ('joins = "C"', 'joins = "A"', "frame"),
                ('joins = "C"', 'joins = ["B", "C"]', "joins"),
                ('joins = "C"', 'joins = "X"', "X"),
                ("length = 50", "length = -1", "length"),
                ("offset = 10", "offset = 30", "outside its bounds"),
                ("offset = 10", "offset = 10, direction_deg = 1e9", "direction_deg"),
                ("offset = 10", 'offset = 10, through = "C"', "through", "no pivot"),
                ("offset = 10", "offset = 10, on = 3", "slide", "on"),
                ('output = "Q"', 'output = "C"', "no slider", "RRP"),
                ('output = "Q"', 'output = ["C", "Q"]', "output_range"),
                ("output_range = 60", "output_range_deg = 60", "output_range"),
                ("rms_error_max", "rms_error_deg_max", "rms_error_max"),
                ("rms_error_max", "max_error_max", "rms_error_max"),
                ('name = "D"', 'name = "Q-slide"', "goes with it"),
                ("Q-slide = [5", "Q-slide = [50", "Q-slide")):
            with self.subTest(new=new):
                self.assertIn(old, self.FILE)
                done = command(self.FILE.replace(old, new), "check")
                self.assertNotEqual(done.returncode, 0, "accepted")
                for word in words:
                    self.assertIn(word, done.stdout + done.stderr)

    def test_faults_of_dwells(self):
        sound = """kind = "function-generation"
[target]
dwell = [{ over_deg = 40, half_band_max = 1 }]
stroke_min = 40
[mechanism]
type = "watt-2-slider"
"""
        self.assertEqual(command(sound, "check").returncode, 0)
        for old, new, *words in (("stroke_min = 40", "", "stroke_min", "missing"),
                                 ("stroke_min = 40", "stroke_min = -4", "stroke_min"),
                                 ("stroke_min = 40", "stroke_min = 40\nswing_deg_min = 40", "swing_deg_min"),
                                 ("half_band_max", "half_band_deg_max", "half_band_max"),
                                 ("stroke_min = 40", 'stroke_min = 40\noutput = "C"', "slider", "chain"),
                                 ("[mechanism]", "[raster]\nlength = 1\n[mechanism]", "raster", "slider"),
                                 ("half_band_max = 1 }", "half_band_max = 1 }, { over_deg = 9 }", "apart")):
            with self.subTest(new=new):
                self.assertIn(old, sound)
                done = command(sound.replace(old, new), "check")
                self.assertNotEqual(done.returncode, 0, "accepted")
                for word in words:
                    self.assertIn(word, done.stdout + done.stderr)

    def test_slider_cranks_by_name(self):
        sound = """kind = "path-generation"
[target]
points = [[0, 0], [2, 0], [1, 1], [0, 0]]
[mechanism]
type = "slider-crank"
dyad = [{ new = "C", length = "free", slide = { direction_deg = 0, offset = "free" } }]
"""
        self.assertEqual(command(sound, "check").returncode, 0)
        for old, new, word in (('new = "C"', 'new = "F"', "no dyad"),
                               ("direction_deg = 0", 'through = "A"', "through"),
                               ('new = "C"', 'new = "C", type = "RRP"', "type")):
            with self.subTest(new=new):
                done = command(sound.replace(old, new), "check")
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(word, done.stderr)


if __name__ == "__main__":
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
