"""Legs of which a file gives every dimension, against closures by intersection of circles and a scan of
40 000 positions.

Run as: given_leg_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import copy
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import leg_test  # noqa: E402
from chain_test import Chain  # noqa: E402
from given_chain_test import mechanism  # noqa: E402
from written_files import solved  # noqa: E402


def published(name):
    """Klann's or Jansen's leg as the library has it."""
    text = (leg_test.LIBRARY / "analysis" / f"{name}.toml").read_text()
    chain = Chain(solved(text, "analyze")["designs"][0]["mechanism"])
    def kept(row, *keys):
        return {key: row[key] for key in keys}

    chain.crank = kept(chain.crank, "at", "pin", "length")
    chain.dyads = [kept(dyad, "joins", "new", "lengths", "assembly") for dyad in chain.dyads]
    chain.points = [kept(point, "name", "on", "at") for point in chain.points]
    return chain


def disturbed(rng, chain, share):
    """The same with other links; all else stays."""
    other = copy.copy(chain)
    other.dyads = [{**dyad, "lengths": [length * math.exp(rng.gauss(0, share)) for length in dyad["lengths"]]}
                   for dyad in chain.dyads]
    return other


def given_file(chain, foot, target):
    tables = mechanism(chain, chain.crank["length"])
    return f'kind = "leg"\n[target]\npoint = "{foot}"\n{target}{tables}'


class Given(unittest.TestCase):
    """Legs of which the file gives every dimension: nothing is searched for."""

    LEGS = {"klann-leg": "F", "jansen-leg": "P"}

    def path_of(self, chain, foot):
        path = []
        for i in range(leg_test.SAMPLES):
            at = chain.places(2 * math.pi * i / leg_test.SAMPLES)
            if at is None:
                return None
            path.append(at[foot])
        return path

    def legs(self, count):
        """Disturbed legs that are assembled all along, with the paths of their feet."""
        rng, made = random.Random(29), 0
        while made < count:
            name = rng.choice(list(self.LEGS))
            chain = disturbed(rng, published(name), 0.05)
            path = self.path_of(chain, self.LEGS[name])
            if path:
                made += 1
                yield rng, chain, self.LEGS[name], path

    def test_the_stance_of_the_duty_factor(self):
        for rng, chain, foot, path in self.legs(5):
            duty = round(rng.uniform(0.25, 0.7), 4)
            wanted = leg_test.gait(path, duty)
            stride = wanted["stride"] * rng.choice([1, 1.1])
            result = solved(given_file(chain, foot, f"duty = {duty}\nstride = {stride!r}\n"))
            (design,) = result["designs"]
            metrics = design["metrics"]
            self.assertEqual(design["origin"], "given")
            first, steps = round(metrics["stance_from_deg"] / 360 * leg_test.SAMPLES), round(duty * leg_test.SAMPLES)
            begun = leg_test.gait(path, duty, first)
            self.assertAlmostEqual(metrics["flatness"] * metrics["stride"], wanted["flatness"] * wanted["stride"],
                                   delta=1e-4 * stride)
            for key in ("stride", "step_height", "flatness"):
                self.assertAlmostEqual(metrics[key] / begun[key], 1, delta=3e-3, msg=key)
            checks = {check["name"]: check["satisfied"] for check in design["constraints"]}
            self.assertEqual(checks["stride"], abs(metrics["stride"] / stride - 1) < 3e-5)
            self.assertLess(abs(path[first % leg_test.SAMPLES].imag - path[(first + steps) % leg_test.SAMPLES].imag), 1e-3 * stride)

    def test_the_longest_stance_of_the_stride(self):
        for rng, chain, foot, path in self.legs(2):
            duty = round(rng.uniform(0.3, 0.7), 4)
            stride = leg_test.gait(path, duty)["stride"]
            result = solved(given_file(chain, foot, f'objective = "duty"\nduty = 0.2\nflatness_max = 1\n'
                                                    f"stride = {stride!r}\n"))
            metrics = result["designs"][0]["metrics"]
            self.assertEqual(result["status"], "solved", result["notes"])
            self.assertAlmostEqual(metrics["stride"], stride, delta=3e-5 * stride)
            self.assertGreater(metrics["duty"], duty - 2e-3)
            beyond = [leg_test.gait(path, k / 100)["stride"] - stride for k in range(20, 96, 2) if k / 100 > metrics["duty"] + 0.01]
            steady = [(a, b) for a, b in zip(beyond, beyond[1:]) if abs(a - b) < 0.06 * stride]
            self.assertTrue(all(a * b > 0 for a, b in steady), (metrics["duty"], beyond))

    def test_of_two_stances_the_longest_within_the_limits(self):
        """The foot of a changed leg of Jansen's rests elsewhere from a duty factor of 0.47 on: two stances have one
        stride, and between them it leaps over that."""
        chain = published("jansen-leg")
        lengths = [[50.22, 43.6], [58.09, 38.87], [38.38, 35.23]]
        chain.dyads = [{**dyad, "lengths": own} for dyad, own in zip(chain.dyads, lengths)]
        path, stride = self.path_of(chain, "P"), 40

        def duty_between(low, high):
            for _ in range(12):
                middle = (low + high) / 2
                low, high = (middle, high) if leg_test.gait(path, middle)["stride"] < stride else (low, middle)
            return low

        short, long = duty_between(0.38, 0.45), duty_between(0.475, 0.5)
        flatness = [leg_test.gait(path, duty)["flatness"] for duty in (short, long)]
        self.assertLess(flatness[0], 0.1)
        self.assertGreater(flatness[1], 0.1)
        for most, wanted, status in ((1, long, "solved"), (0.1, short, "solved"), (0.05, long, "infeasible")):
            result = solved(given_file(chain, "P", f'objective = "duty"\nduty = 0.3\nflatness_max = {most}\n'
                                                   f"stride = {stride}\n"))
            metrics = result["designs"][0]["metrics"]
            self.assertEqual(result["status"], status)
            self.assertAlmostEqual(metrics["duty"], wanted, delta=5e-4)
            self.assertAlmostEqual(metrics["stride"], stride, delta=1e-6 * stride)

    def test_a_stride_that_no_stance_has(self):
        chain = published("klann-leg")
        result = solved(given_file(chain, "F", 'objective = "duty"\nduty = 0.5\nflatness_max = 0.2\nstride = 9\n'))
        self.assertEqual(result["status"], "infeasible")
        self.assertEqual(result["designs"][0]["metrics"]["duty"], 0.5)

    def test_a_leg_that_does_not_turn(self):
        chain = published("klann-leg")
        chain.crank = {**chain.crank, "length": 0.9}
        result = solved(given_file(chain, "F", "duty = 0.5\nstride = 1\n"))
        self.assertEqual((result["status"], result["designs"]), ("no-solution", []))
        self.assertIn("The leg given is not assembled over the whole turn", " ".join(result["notes"]))

    def test_one_number_left_out_is_found(self):
        chain = published("klann-leg")
        text = given_file(chain, "F", "duty = 0.55\nstride = 1.0087\n")
        length = f"length = {chain.crank['length']!r}\n"
        self.assertIn(length, text)
        design = solved(text.replace(length, "") + "[solve]\nstarts = 32\n")["designs"][0]
        self.assertNotEqual(design["origin"], "given")


if __name__ == "__main__":
    leg_test.LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
