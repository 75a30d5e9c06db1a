"""Fronts of functions, dwells, legs and motions of chains: the error against the transmission angle
or the size. Every design is computed again as the tests of its kind do.

Run as: kind_fronts_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import json
import math
import pathlib
import random
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import chain_function_test  # noqa: E402
import chain_motion_test  # noqa: E402
import chain_test  # noqa: E402
import dwell_test  # noqa: E402
import leg_test  # noqa: E402
from thinned import ordinarily, some, WHOLE, whole_only  # noqa: E402
from written_files import command, solved  # noqa: E402

LIBRARY = pathlib.Path()
POSES = chain_motion_test.noisy(
    chain_motion_test.carried(chain_motion_test.stephenson(), "EF", 0.7, chain_test.turn(24)), 0.01,
    random.Random(2))


def library(name, against, starts, designs=4):
    text = (LIBRARY / f"{name}.toml").read_text().split("\n[solve]")[0]
    return text + f'\n[solve]\nobjectives = ["error", "{against}"]\nstarts = {starts}\ndesigns = {designs}\n'


def motion(against, starts=256):
    return chain_motion_test.problem(
        POSES, "stephenson-3", "[bounds]\nlength = [0.2, 30]\n[constraints]\n"
        f'transmission_angle_deg = [20, 160]\n[solve]\nobjectives = ["error", "{against}"]\n'
        f"starts = {starts}\ndesigns = 4\n")


def without_front(text, least):
    """The problem of the error alone, its transmission angles at least so many degrees."""
    text = re.sub(r"objectives = .*\n", "", text)
    limit = f"transmission_angle_deg = [{least!r}, {180 - least!r}]"
    return re.sub(r"transmission_angle_deg = .*", limit, text)


class Fronts(unittest.TestCase):
    def front(self, text, measure, error, error_of):
        """The designs of a front: what is said of them holds, and none is as good as another in both."""
        result = solved(text)
        self.assertEqual(result["status"], "solved", result["notes"])
        (family,) = result["families"]
        names, columns = zip(*((column["name"], column["values"]) for column in family["columns"]))
        self.assertEqual((family["name"], names), ("Pareto front", (measure, error)))
        measures, errors = columns
        self.assertEqual(len(errors), len(result["designs"]))
        self.assertGreaterEqual(len(errors), 3)
        sense = 1 if "transmission" in measure else -1
        for before, after in zip(zip(*columns), list(zip(*columns))[1:]):
            self.assertLess(before[1], after[1])
            self.assertLess(sense * before[0], sense * after[0])
        for design, value in zip(result["designs"], errors):
            self.assertAlmostEqual(error_of(design), value, delta=1e-9 * abs(value))
            self.assertTrue(all(check["satisfied"] for check in design["constraints"]))
        return result, measures, errors

    def by_transmission(self, text, error, error_of, share=1.05, compared=True):
        """Such a front; a search of the error alone finds no design that is much better than it."""
        result, least, errors = self.front(text, "transmission_angle_deg.acute_min", error, error_of)
        for design, value in zip(result["designs"], least):
            self.assertEqual(design["metrics"]["transmission_angle_deg"]["acute_min"], value)
        if not compared:
            return result
        alone = solved(without_front(text, least[1] - 1e-6))["designs"]
        self.assertTrue(alone)
        self.assertLess(errors[1], share * error_of(alone[0]))
        return result

    def test_function(self):
        for objective, error in some((("least-squares", "rms"), ("minimax", "max"))):
            text = library("chain-function/six-bar-logarithm", "transmission_angle", ordinarily(16, 64))
            text = text.replace("[target]", f'[target]\nobjective = "{objective}"')
            result = self.by_transmission(text, f"{error}_error_deg",
                                          lambda design: design["error"][f"{error}_deg"], 1.3, compared=WHOLE)
            chain_function_test.Designs().check(result, math.log10)

    def test_size_of_a_slider(self):
        text = library("chain-function/slider-crank-square", "size", ordinarily(64, 128))
        name = "max_error" if "minimax" in text else "rms_error"
        result, sizes, _ = self.front(text, "longest_link", name,
                                      lambda design: design["error"][name.split("_")[0]])
        for design, size in zip(result["designs"], sizes):
            mechanism = design["mechanism"]
            links = [mechanism["crank"]["length"]]
            for row in mechanism["dyad"]:
                links += row.get("lengths") or [row["length"]]
            self.assertAlmostEqual(max(links), size, delta=1e-9 * size)

    @whole_only
    def test_dwell(self):
        text = library("dwell/six-bar-dwell", "transmission_angle", 192)
        result = self.by_transmission(text, "half_band_deg",
                                      lambda design: design["metrics"]["half_band_deg"], 1.5)
        dwell_test.Designs().check(result, 60)

    @whole_only
    def test_leg(self):
        text = library("leg/klann", "transmission_angle", 192)
        text = text.replace("[35, 145]", "[25, 155]").replace("flatness_max = 0.03", "flatness_max = 0.06")
        result = self.by_transmission(text, "flatness", lambda design: design["metrics"]["flatness"],
                                      1.3)
        leg_test.Designs().check(result)

    @whole_only
    def test_a_front_shorter_than_the_first_step(self):
        """Of legs as flat as this none has 40 degrees."""
        text = library("leg/klann", "transmission_angle", 256).replace("flatness_max = 0.03", "flatness_max = 0.009")
        _, least, _ = self.front(text, "transmission_angle_deg.acute_min", "flatness",
                                 lambda design: design["metrics"]["flatness"])
        self.assertLess(least[-1], 40)

    def test_motion(self):
        result = self.by_transmission(motion("transmission_angle", ordinarily(8, 256)), "rms_error",
                                      lambda design: design["error"]["rms"], compared=WHOLE)
        for design in result["designs"]:
            chain_motion_test.Found().check(design, POSES, "EF")

    @whole_only
    def test_same_again_and_for_any_number_of_threads(self):
        text = library("chain-function/six-bar-logarithm", "transmission_angle", 32, 3)
        one, two = (json.loads(command(text, "solve", "--json", "--quiet", "--threads", threads).stdout)
                    for threads in "12")
        self.assertEqual(one["designs"], two["designs"])

    def test_faults_are_named(self):
        for text, message in (
                (library("chain-function/six-bar-logarithm", "size", 64), "any size"),
                (library("chain-function/six-bar-logarithm", "links", 64), "links"),
                (library("dwell/six-bar-dwell", "length", 64), "allowed of chains are"),
                (library("leg/klann", "links", 64), '"links"'),
                (motion("links"), 'type = "any"')):
            done = command(text, "check")
            self.assertEqual(done.returncode, 2, text)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    chain_motion_test.PROGRAM = sys.argv[1]
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
