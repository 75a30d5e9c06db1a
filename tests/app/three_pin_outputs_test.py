"""Functions, dwells and legs of mechanisms with a three-pin link: planted functions are found again, and what results say of
outputs and feet is so by a closure of its own.

Run as: three_pin_outputs_test.py PROGRAM, the built program.
"""

import cmath
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import three_pin_paths
from thinned import ordinarily, WHOLE
from three_pin_paths import unrolled
from written_files import analysed

PROGRAM = ""
SAMPLES = 3600
LIMITS = "[constraints]\ntransmission_angle_deg = [30, 150]\n"


SLIDER = """kind = "function-generation"
[target]
function = "x"
domain = [0, 1]
input_range_deg = 140
output_range = 100
output = "S"
objective = "minimax"
[mechanism]
type = "chain"
[[pivot]]
name = "A"
at = [0, 0]
[[pivot]]
name = "D"
[[pivot]]
name = "G"
[crank]
at = "A"
pin = "B"
[[dyad]]
type = "three-pin"
joins = ["B", "D", "G"]
new = ["C", "E", "F"]
[[point]]
name = "K"
on = ["G", "F"]
[[dyad]]
type = "RRP"
joins = "K"
new = "S"
[bounds]
length = [20, 300]
pivots = [[-400, -400], [400, 400]]
point = [[-300, -300], [300, 300]]
[constraints]
transmission_angle_deg = [30, 150]
[solve]
designs = 1
starts = STARTS
"""


def run(text, command="solve"):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        return subprocess.run([PROGRAM, "--quiet", "--json", command, path], capture_output=True, text=True, check=False)


def solved(text):
    done = run(text)
    return json.loads(done.stdout)


class Moved:
    """A design over the turn of its crank."""

    def __init__(self, design):
        self.design = design
        self.of = three_pin_paths.Design(design["mechanism"])
        moved = self.of.joints(SAMPLES)
        assert moved is not None, "it does not come round"
        self.joints, self.least = moved

    def outputs(self):
        """Radians, from G to F."""
        return unrolled([cmath.phase(at["F"] - at["G"]) for at in self.joints])

    def output_at(self, degrees):
        at = self.of.places_after(math.radians(degrees % 360))
        return cmath.phase(at["F"] - at["G"])


class Outputs(unittest.TestCase):
    def check_transmission(self, moved):
        stated = moved.design["metrics"]["transmission_angle_deg"]["acute_min"]
        self.assertAlmostEqual(moved.least, stated, delta=0.01)
        self.assertGreaterEqual(moved.least, 30 - 0.001)

    def check_function(self, pairs, best):
        """Its errors are those of this closure from the start that it states."""
        moved = Moved(best)
        self.check_transmission(moved)
        start = best["metrics"]["input_start_deg"]
        missed = [math.remainder(moved.output_at(start + x) - math.radians(y), three_pin_paths.TURN) for x, y in pairs]
        missed = unrolled(missed)
        middle = sum(missed) / len(missed)
        rms = math.sqrt(sum((x - middle)**2 for x in missed) / len(missed))
        self.assertAlmostEqual(rms, best["error"]["rms"], delta=1e-7)

    def test_planted_functions_are_found_again(self):
        for kind, seed in [(1, 3)] + ([(2, 5), (1, 6), (2, 8), (1, 9)] if WHOLE else []):
            pairs = three_pin_paths.planted_pairs(kind, random.Random(seed), 35)
            rows = ", ".join(f"[{x}, {y:.15g}]" for x, y in pairs)
            best = solved(f'kind = "function-generation"\n[target]\npairs_deg = [{rows}]\n[mechanism]\n'
                          f'type = "three-pin-{kind}"\n{LIMITS}[solve]\nstarts = {1024 if WHOLE else 256}\ndesigns = 1\n')["designs"][0]
            swing = math.radians(max(y for _, y in pairs) - min(y for _, y in pairs))
            self.assertLess(best["error"]["rms"], 3e-4 * swing, (kind, seed))
            self.check_function(pairs, best)

    def test_dwells(self):
        result = solved(f'kind = "function-generation"\n[target]\ndwell = [{{ over_deg = 100 }}]\nswing_deg_min = 40\n'
                        f'[mechanism]\ntype = "three-pin"\n{LIMITS}[solve]\nstarts = {ordinarily(32, 128)}\ndesigns = 1\n')
        best = result["designs"][0]
        moved, metrics = Moved(best), best["metrics"]
        self.check_transmission(moved)
        outputs = moved.outputs()
        self.assertAlmostEqual(math.degrees(max(outputs) - min(outputs)), metrics["swing_deg"], delta=1e-3)
        self.assertGreaterEqual(metrics["swing_deg"], 40 - 1e-4)
        start = metrics["dwell_from_deg"]
        still = unrolled([moved.output_at(start + 100 * i / 200) for i in range(201)])
        self.assertAlmostEqual(math.degrees(max(still) - min(still)) / 2, metrics["half_band_deg"], delta=1e-5)
        self.assertLess(metrics["half_band_deg"], ordinarily(3, 0.5))

    def test_analyses_of_what_is_exported_report_the_output(self):
        """And not the link that the design has last: its swing is that of this closure."""
        pairs = three_pin_paths.planted_pairs(1, random.Random(3), 35)
        rows = ", ".join(f"[{x}, {y:.15g}]" for x, y in pairs)
        result = solved(f'kind = "function-generation"\n[target]\npairs_deg = [{rows}]\n[mechanism]\ntype = "three-pin"\n{LIMITS}'
                        "[solve]\nstarts = 32\ndesigns = 1\n")
        metrics = analysed(result)
        self.assertEqual(metrics["output"], "GF")
        outputs = Moved(result["designs"][0]).outputs()
        self.assertAlmostEqual(metrics["output_swing_deg"], math.degrees(max(outputs) - min(outputs)), delta=1e-3)

    def test_legs(self):
        height = ordinarily(0.02, 0.3)
        best = solved(f'kind = "leg"\n[target]\nduty = 0.55\nstride = 1\nheight_min = {height}\n[mechanism]\n'
                      f'type = "three-pin"\n{LIMITS}[solve]\nstarts = {ordinarily(5, 32)}\ndesigns = 1\n')["designs"][0]
        moved, metrics = Moved(best), best["metrics"]
        self.check_transmission(moved)
        path = moved.of.path("P", SAMPLES)[0]
        low = min(p.imag for p in path)
        first = round(metrics["stance_from_deg"] * SAMPLES / 360)
        stance = [path[(first + i) % SAMPLES] for i in range(round(0.55 * SAMPLES) + 1)]
        self.assertAlmostEqual(max(p.imag for p in path) - low, metrics["step_height"], delta=1e-4)
        self.assertGreaterEqual(metrics["step_height"], height - 1e-6)
        self.assertAlmostEqual(max(p.real for p in stance) - min(p.real for p in stance), 1, delta=2e-3)
        self.assertAlmostEqual(max(p.imag for p in stance) - low, metrics["flatness"], delta=2e-3)

    def test_a_slider_after_the_link(self):
        """Its displacement is recomputed from where the link's pin stands."""
        text = SLIDER.replace("STARTS", "48")
        best = solved(text)["designs"][0]
        rows = {row["new"]: row for row in best["mechanism"]["dyad"] if row.get("type") == "RRP"}
        self.assertEqual(list(rows), ["S"])
        self.assertTrue(math.isfinite(best["error"]["max"]))
        self.assertLess(best["error"]["max"], 20)
        group = next(row for row in best["mechanism"]["dyad"] if row["type"] == "group")
        moved = three_pin_paths.Design({**best["mechanism"], "dyad": [group]})
        slide, (length,) = rows["S"]["slide"], rows["S"]["lengths"]
        along = cmath.rect(1, math.radians(slide["direction_deg"]))
        foot = complex(*next(row["at"] for row in best["mechanism"]["pivot"] if row["name"] == slide["through"]))
        missed, sign = [], 1 if rows["S"]["assembly"] == "open" else -1
        for i in range(15):
            share = i / 14
            carrier = moved.places_after(math.radians((best["metrics"]["input_start_deg"] + 140 * share) % 360))["K"]
            away = ((carrier - foot) / along).imag - slide["offset"]
            self.assertLess(abs(away), length)
            missed.append(((carrier - foot) / along).real + sign * math.sqrt(length**2 - away**2) - 100 * share)
        self.assertLessEqual((max(missed) - min(missed)) / 2, best["error"]["max"] * (1 + 1e-6))
        self.assertGreater((max(missed) - min(missed)) / 2, 0.5 * best["error"]["max"])

    def test_what_is_not_for_them_is_refused(self):
        function = ('kind = "function-generation"\n[target]\nfunction = "x"\ndomain = [0, 1]\ninput_range_deg = 90\n'
                    'output_range_deg = 40\n[mechanism]\ntype = "three-pin-1"\n')
        dwell = ('kind = "function-generation"\n[target]\ndwell = [{ over_deg = 90 }]\n[mechanism]\ntype = "three-pin-2"\n')
        leg = 'kind = "leg"\n[target]\nduty = 0.55\nstride = 1\n[mechanism]\ntype = "three-pin"\n'
        for text, more, why in ((function, '[constraints]\nover = "range"\n', "the crank of a mechanism with a three-pin link turns fully"),
                                (function, "[layers]\nbar_width = 0.1\n", "not for links with three pins"),
                                (dwell, "[raster]\nlength = 1\n", "not for links with three pins"),
                                (dwell, "[tolerance]\nlength = 0.1\n", "not for links with three pins"),
                                (leg, "[tolerance]\nlength = 0.1\n", "not for links with three pins"),
                                (leg, "[constraints]\nlayers_max = 3\n", "not for links with three pins")):
            with self.subTest(more):
                done = run(text + more)
                self.assertEqual(done.returncode, 2)
                self.assertIn(why, done.stderr + done.stdout)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
