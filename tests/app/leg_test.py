"""Walking legs, against closures by intersection of circles and a scan of 10 000 positions.

Run as: leg_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import json
import math
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import Chain  # noqa: E402
from thinned import ordinarily, some, WHOLE, whole_only  # noqa: E402
from written_files import command, solved  # noqa: E402

LIBRARY = pathlib.Path()
SAMPLES = 10000


def library(name):
    return (LIBRARY / "leg" / f"{name}.toml").read_text()


def eased(starts):
    """Klann's leg within limits that the published one meets, so that however few starts find one at least as flat."""
    text = library("klann")
    for old, new in (("starts = 768", f"starts = {starts}"), ("[35, 145]", "[10, 170]"), ("flatness_max = 0.03", "flatness_max = 0.09"),
                     ("foot_speed_min = -0.49", ""), ("height_min = 0.5273", "height_min = 0.5"), ("duty = 0.55", "duty = 0.5")):
        text = text.replace(old, new)
    return text


def foot_path(mechanism, foot):
    chain = Chain(mechanism)
    path = []
    for i in range(SAMPLES):
        at = chain.places(2 * math.pi * i / SAMPLES)
        if at is None:
            raise AssertionError("the chain does not close")
        path.append(at[foot])
    return path


def distances(mechanism):
    """What `near` limits, by the names of two points: each line of the file joins its point to two others."""
    at, crank = Chain(mechanism).places(0.4), mechanism["crank"]
    pairs = [(crank["at"], crank["pin"])] + [(crank["at"], pivot["name"]) for pivot in mechanism["pivot"]]
    pairs += [(end, dyad["new"]) for dyad in mechanism["dyad"] for end in dyad["joins"]]
    pairs += [(end, point["name"]) for point in mechanism["point"] for end in point["on"]]
    return {frozenset(pair): abs(at[pair[1]] - at[pair[0]]) for pair in pairs if pair[0] != pair[1]}


def lowest_window(path, steps):
    """Where the window of so many steps begins whose highest level is least, by a table of maxima over
    powers of two; of those below one peak, that whose ends are level, the lowest."""
    levels = [z.imag for z in path]
    best, width = levels * 2, 1
    while 2 * width <= steps + 1:
        best = [max(a, b) for a, b in zip(best, best[width:])]
        width *= 2
    tops = [max(best[i], best[i + steps + 1 - width]) for i in range(len(path))]
    least, count = min(tops), len(path)
    fall = [levels[i] - levels[(i + steps) % count] for i in range(count)]
    level = [i for i in range(count) if tops[i] == least and fall[i] * fall[(i + 1) % count] <= 0]
    return min(level, key=levels.__getitem__) if level else tops.index(least)


def gait(path, duty, first=None):
    steps = round(duty * SAMPLES)
    if first is None:
        first = lowest_window(path, steps)
    stance = [path[(first + i) % SAMPLES] for i in range(steps + 1)]
    levels = [z.imag for z in path]
    along = [z.real for z in stance]
    sense = -1 if along[-1] < along[0] else 1
    stride = max(along) - min(along)
    speeds = [sense * (b - a) * steps / stride for a, b in zip(along, along[1:])]
    return {"duty": steps / SAMPLES, "stride": stride, "step_height": max(levels) - min(levels),
            "flatness": (max(z.imag for z in stance) - min(levels)) / stride,
            "foot_speed_min": min(speeds), "foot_speed_max": max(speeds)}


class Designs(unittest.TestCase):
    """The best two designs, measured again here."""

    def check(self, result, **reached):
        self.assertEqual(result["status"], "solved", result["notes"])
        target, limits = result["problem"]["target"], result["problem"]["constraints"]
        foot = target.get("point") or {"klann": "F", "jansen": "P"}.get(result["problem"]["mechanism"]["type"], "P")
        low, high = limits["transmission_angle_deg"]
        for design in result["designs"][:2]:
            metrics = design["metrics"]
            path = foot_path(design["mechanism"], foot)
            found = gait(path, metrics["duty"])
            # Of windows below one peak, the stance is that whose ends are level.
            first, steps = round(metrics["stance_from_deg"] / 360 * SAMPLES), round(metrics["duty"] * SAMPLES)
            begun = gait(path, metrics["duty"], first)
            fall = path[first % SAMPLES].imag - path[(first + steps) % SAMPLES].imag
            self.assertAlmostEqual(fall / metrics["stride"], 0, delta=3e-4)
            self.assertAlmostEqual(found["flatness"] * found["stride"],
                                   metrics["flatness"] * metrics["stride"], delta=1e-4 * metrics["stride"])
            for key in ("duty", "stride", "step_height", "flatness"):
                self.assertAlmostEqual(begun[key] / metrics[key], 1, delta=3e-3, msg=key)
            for key in ("foot_speed_min", "foot_speed_max"):
                self.assertAlmostEqual(begun[key], metrics[key], delta=5e-3, msg=key)
            self.assertAlmostEqual(metrics["stride"], target["stride"], delta=1e-4 * target["stride"])
            self.assertGreaterEqual(metrics["step_height"], target.get("height_min", 0) * (1 - 1e-9))
            self.assertGreaterEqual(metrics["foot_speed_min"], limits.get("foot_speed_min", -99))
            self.assertGreaterEqual(metrics["duty"], target["duty"] - 1e-9)
            self.assertLessEqual(metrics["flatness"], target.get("flatness_max", 1) + 1e-9)
            chain = Chain(design["mechanism"])
            for i in range(0, 1000, 10):
                self.assertGreaterEqual(chain.transmission(chain.places(2 * math.pi * i / 1000)),
                                        max(low, 180 - high) - 1e-6)
            self.assertAlmostEqual(design["error"]["max"], metrics["flatness"] * metrics["stride"] / 2, delta=1e-9)
        best = result["designs"][0]["metrics"]
        for key, limit in reached.items():
            (self.assertLess if key == "flatness" else self.assertGreater)(best[key], limit)
        return result["designs"]

    def check_near(self, design, published, factor):
        """Links, sides of plates and distances of pivots, against the published leg in an analysis of the library."""
        text = (LIBRARY / "analysis" / f"{published}.toml").read_text()
        known = distances(solved(text, "analyze")["designs"][0]["mechanism"])
        own = distances(design["mechanism"])
        self.assertEqual(len(known), {"klann-leg": 11, "jansen-leg": 12}[published])
        for name, length in known.items():
            self.assertLessEqual(abs(math.log(own[name] / length)), math.log(factor) + 1e-5, name)

    def test_klann(self):
        text = library("klann").replace("starts = 768", "starts = 3072") if WHOLE else eased(24)
        designs = self.check(solved(text), flatness=ordinarily(0.06, 0.025))
        for design in designs:
            self.check_near(design, "klann-leg", 1.5)

    def test_jansen(self):
        text = library("jansen").replace("starts = 512", f"starts = {ordinarily(64, 512)}")
        designs = self.check(solved(text), flatness=ordinarily(0.05, 0.015), foot_speed_min=-1e-9)
        for design in designs:
            self.check_near(design, "jansen-leg", 1.5)

    def test_the_published_leg_is_not_lost(self):
        """It meets everything, so that there is a design at least as flat, however few starts there are."""
        for starts in some((1, 2, 48)):
            result = solved(f"""
kind = "leg"
[target]
duty = 0.5
stride = 1.0087
height_min = 0.5
[mechanism]
type = "klann"
near = 2
[solve]
starts = {starts}
""")
            designs = self.check(result, flatness=0.0547)
            self.assertEqual(result["facts"]["starts"], starts)
            self.check_near(designs[0], "klann-leg", 2)

    @whole_only
    def test_more_starts_find_no_less(self):
        for starts in (64, 256):
            result = solved(f"""
kind = "leg"
[target]
objective = "duty"
flatness_max = 0.3
duty = 0.6
stride = 100
height_min = 40
[mechanism]
type = "klann"
[constraints]
transmission_angle_deg = [30, 150]
[solve]
starts = {starts}
""")
            self.check(result, duty=0.84)
            self.assertEqual(result["facts"]["starts"], starts)

    def test_longest_stance(self):
        self.check(solved(library("longest-stance")), duty=0.55)

    def test_chain_given_point_by_point(self):
        self.check(solved("""
kind = "leg"
[target]
stride = 80
duty = 0.4
point = "Q"
[mechanism]
type = "chain"
crank = { at = "A", pin = "B", length = 20 }
pivot = [{ name = "A", at = [10, -5] }, { name = "D" }]
dyad = [{ joins = ["B", "D"], new = "C" }]
point = [{ name = "Q", on = ["B", "C"] }]
[bounds]
length = [10, 200]
[constraints]
transmission_angle_deg = [35, 145]
[solve]
starts = 96
"""), flatness=0.05)

    def test_same_for_any_number_of_threads(self):
        text = eased(8)
        found = []
        for threads in ("1", "2"):
            done = command(text, "solve", "--json", "--quiet", "--threads", threads)
            found.append([d["mechanism"] for d in json.loads(done.stdout)["designs"]])
        self.assertTrue(found[0])
        self.assertEqual(found[0], found[1])


class Analyses(unittest.TestCase):
    def test_published_legs(self):
        wanted = {"klann-leg": ("F", 0.539, 1.0087, 0.5273, 0.0784), "jansen-leg": ("P", 0.616, 67.88, 22.46, 0.0496)}
        for name, (foot, duty, stride, height, flatness) in wanted.items():
            text = (LIBRARY / "analysis" / f"{name}.toml").read_text()
            metrics = solved(f'{text}\n[output]\nfoot = "{foot}"\n', "analyze")["designs"][0]["metrics"]
            self.assertAlmostEqual(metrics["duty"], duty, delta=5e-4)
            self.assertAlmostEqual(metrics["stride"] / stride, 1, delta=1e-4)
            self.assertAlmostEqual(metrics["step_height"] / height, 1, delta=2e-4)
            self.assertAlmostEqual(metrics["flatness"], flatness, delta=1e-4)
            result = solved(f'{text}\n[output]\nfoot = "{foot}"\nduty = 0.5\n', "analyze")
            own = gait(foot_path(result["designs"][0]["mechanism"], foot), 0.5)
            for key, value in own.items():
                self.assertAlmostEqual(result["designs"][0]["metrics"][key], value, delta=2e-3 * abs(value), msg=key)

    def test_stance_begins_in_the_sense_of_the_crank(self):
        text = (LIBRARY / "analysis" / "klann-leg.toml").read_text() + '\n[output]\nfoot = "F"\nduty = 0.45\n'
        begins = [solved(f"{text}[drive]\nspeed = {speed}\n", "analyze")["designs"][0]["metrics"]
                  for speed in (1, -1)]
        self.assertAlmostEqual(begins[0]["stance_from_deg"], 8.862, delta=1e-3)
        self.assertAlmostEqual(begins[1]["stance_from_deg"], 8.862 + 0.45 * 360, delta=1e-3)
        self.assertEqual(begins[0]["stride"], begins[1]["stride"])

    def test_a_rocker_has_no_gait(self):
        text = ('kind = "analysis"\n[mechanism]\ntype = "four-bar"\ncrank = 3\ncoupler = 2.5\nrocker = 2\n'
                'fixed_pivots = [[0, 0], [3, 0]]\ncoupler_point = [1, 1]\n[output]\nfoot = "P"\n')
        notes = " ".join(solved(text, "analyze")["notes"])
        self.assertIn("has no gait", notes)

    def test_faults(self):
        four_bar = ('kind = "analysis"\n[mechanism]\ntype = "four-bar"\ncrank = 1\ncoupler = 2.5\nrocker = 2.5\n'
                    'fixed_pivots = [[0, 0], [2, 0]]\ncoupler_point = [5, 0]\n[output]\n')
        self.assertEqual(command(four_bar + 'foot = "P"\nduty = 0.5\n', "check").returncode, 0)
        for lines, word in (('foot = "Z"', "Z"), ('foot = "A"', "point of the frame"), ("duty = 0.5", "without foot"),
                            ('foot = "P"\nduty = 1', "from 0.05 to 0.95"), ("foot = 3", "foot")):
            with self.subTest(lines):
                done = command(four_bar + lines + "\n", "check")
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(word, done.stdout + done.stderr)


class Faults(unittest.TestCase):
    """What is refused, and in which words."""

    FILE = """
kind = "leg"
[target]
stride = 100
duty = 0.5
[mechanism]
type = "klann"
[constraints]
foot_speed_min = 0
"""

    def test_sound(self):
        self.assertEqual(command(self.FILE, "check").returncode, 0)

    def test_faults(self):
        for old, new, *words in (
                ("stride = 100", "", "stride is missing"),
                ("stride = 100", "stride = 0", "stride is 0", "a length"),
                ("stride = 100", "stride = inf", "stride"),
                ("stride = 100", "stride = 1e60", "from 1e-50 to 1e50"),
                ("duty = 0.5", "duty = 1", "from 0.05 to 0.95"),
                ("duty = 0.5", "height_min = 3\nheight_max = 2", "height_min is above height_max"),
                ("duty = 0.5", 'objective = "duty"', "flatness_max is missing"),
                ("duty = 0.5", 'objective = "speed"', "objective", "flatness"),
                ("duty = 0.5", "flatness_max = 0", "flatness_max is 0"),
                ("duty = 0.5", 'point = "F"', "point", 'type = "chain"'),
                ("duty = 0.5", "dwell = 3", "dwell"),
                ('"klann"', '"klan"', "klan", "klann"),
                ('"klann"', '"klann"\nnear = 1', "near is 1", "above 1"),
                ('"klann"', '"stephenson-3"\nnear = 2', "near", "published"),
                ("foot_speed_min = 0", "foot_speed_min = 1", "below 1"),
                ("foot_speed_min = 0", "foot_speed_max = 1", "above 1"),
                ("foot_speed_min = 0", "class = \"crank-rocker\"", "four-bars")):
            with self.subTest(new=new):
                self.assertIn(old, self.FILE)
                done = command(self.FILE.replace(old, new), "check")
                self.assertNotEqual(done.returncode, 0, "accepted")
                for word in words:
                    self.assertIn(word, done.stdout + done.stderr)

    def test_an_unknown_limit_is_answered_with_those_of_legs(self):
        done = command(self.FILE.replace("foot_speed_min = 0", "wobble = 1"), "check")
        self.assertIn('unknown key "wobble" in [constraints]; allowed are', done.stderr)
        listed = set(re.findall(r'"(\w+)"', done.stderr.split("allowed are")[1]))
        self.assertEqual(listed, {"transmission_angle_deg", "foot_speed_min", "foot_speed_max", "layers_max"})

    def test_limits_that_no_leg_meets(self):
        result = solved(self.FILE.replace("duty = 0.5", "duty = 0.9\nheight_min = 400") + "[solve]\nstarts = 8\n")
        self.assertIn(result["status"], ("no-solution", "infeasible"))
        self.assertTrue(result["notes"] or result["designs"])


if __name__ == "__main__":
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
