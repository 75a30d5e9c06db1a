"""Bodies carried by six-bars and other chains, against closures computed point by point, and by
four-bars against the designs of the kind that knows no chain.

Run as: chain_motion_test.py PROGRAM, the built program.
"""

import cmath
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

import chain_test
import three_pin_paths
from thinned import ordinarily, some

PROGRAM = ""

FOUR_BAR = """
[[pivot]]
name = "A"
[[pivot]]
name = "D"
[crank]
at = "A"
pin = "B"
[[dyad]]
joins = ["B", "D"]
new = "C"
[[point]]
name = "P"
on = ["B", "C"]
"""


def run(text, *arguments, command="solve"):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        return subprocess.run([PROGRAM, "--quiet", "--json", *arguments, command, path],
                              capture_output=True, text=True, check=False)


def report_of(text):
    """What the report page of a file shows, and its result."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        subprocess.run([PROGRAM, "--quiet", "solve", path], cwd=folder, check=False)
        page = path.with_suffix(".report.html").read_text(encoding="utf-8")
        shown = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
        return json.loads(shown[1]), json.loads(path.with_suffix(".result.json").read_text())


def designs(text, *arguments):
    return json.loads(run(text, *arguments).stdout)["designs"]


def rows(poses):
    return [[at.real, at.imag, math.degrees(angle)] for at, angle in poses]


def problem(poses, kind, rest="", target="closed = true"):
    return (f'kind = "motion-generation"\n[target]\nposes = {rows(poses)}\n{target}\n'
            f'[mechanism]\ntype = "{kind}"\n{rest}')


def carried(chain, link, own, angles):
    """The poses of a body that lies in `link` (two points) at the angle `own`, its origin at P."""
    poses = []
    for angle in angles:
        at = chain.places(angle)
        poses.append((at["P"], cmath.phase(at[link[1]] - at[link[0]]) + own))
    return poses


def stephenson():
    return chain_test.six_bar((3.5, 0), (-1.5, 4.5), (4, 4, 3.5, 3.5), True, (3, 0), True, (1, -2))


def watt():
    return chain_test.six_bar((3.5, 0), None, (3, 3.5, 3.5, 2.5), True, (-2, -0.5), True,
                              (1.5, -3), h=(0, 0.5))


def four_bar():
    return chain_test.Chain({
        "pivot": [{"name": "A", "at": (0, 0)}, {"name": "D", "at": (3.5, 0.4)}],
        "crank": {"at": "A", "pin": "B", "length": 1},
        "dyad": [{"joins": ["B", "D"], "lengths": (3, 2.6), "assembly": "open", "new": "C"}],
        "point": [{"name": "P", "on": ["B", "C"], "at": (1.2, 2)}]})


def size_of(poses):
    return three_pin_paths.size_of([at for at, _ in poses])


def noisy(poses, share, rng):
    size = share * size_of(poses)
    return [(at + size * complex(rng.gauss(0, 1), rng.gauss(0, 1)) / math.sqrt(3),
             angle + share * rng.gauss(0, 1) / math.sqrt(3)) for at, angle in poses]


def misses(design, poses, link):
    """Distances and angles (radians) by which a design misses poses at its own crank angles."""
    chain = chain_test.Chain(design["mechanism"])
    own = math.radians(design["metrics"]["body_angle_in_link_deg"])
    reached = carried(chain, link, own, [math.radians(a) for a in design["crank_deg"]])
    return [(abs(here - at), abs(math.remainder(turned - angle, 2 * math.pi)))
            for (here, turned), (at, angle) in zip(reached, poses)]


def slopes(design, poses, link, weight):
    """Of each pose's squared error by its own crank angle: none where the body is nearest."""
    def squares(step):
        moved = dict(design, crank_deg=[a + math.degrees(step) for a in design["crank_deg"]])
        return [place**2 + (weight * angle)**2 for place, angle in misses(moved, poses, link)]
    step = 1e-5
    return [(above - below) / (2 * step) for above, below in zip(squares(step), squares(-step))]


def rms(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


class Found(unittest.TestCase):
    def check(self, design, poses, link, weight=None):
        """What the result says is so."""
        missed = misses(design, poses, link)
        size = size_of(poses)
        weight = weight or size
        together = rms([math.hypot(place, weight * angle) for place, angle in missed])
        metrics = design["metrics"]
        self.assertAlmostEqual(design["error"]["rms"], together, delta=1e-8 * size)
        self.assertAlmostEqual(metrics["position_error_rms"], rms([p for p, _ in missed]),
                               delta=1e-8 * size)
        self.assertAlmostEqual(metrics["angle_error_max_deg"],
                               math.degrees(max(a for _, a in missed)), delta=1e-6)
        self.assertAlmostEqual(metrics["angle_error_rms_deg"],
                               math.degrees(rms([a for _, a in missed])), delta=1e-6)
        chain = chain_test.Chain(design["mechanism"])
        least = min(chain.transmission(chain.places(angle)) for angle in chain_test.turn(3600))
        self.assertAlmostEqual(metrics["transmission_angle_deg"]["acute_min"], least, delta=0.01)

    def test_planted_motions_are_found_again(self):
        for kind, chain in some((("stephenson-3", stephenson()), ("watt-1", watt()))):
            poses = carried(chain, "EF", 0.7, chain_test.turn(36))
            best = designs(problem(poses, kind, "[constraints]\n"
                                   "transmission_angle_deg = [30, 150]\n"))[0]
            self.assertLess(best["error"]["rms"], 1e-4 * size_of(poses), kind)
            self.check(best, poses, "EF")

    def test_noise_is_not_exceeded(self):
        rng = random.Random(5)
        for target, angles in some((("closed = true", chain_test.turn(48)),
                                    ("", [math.radians(200 - 4 * i) for i in range(36)]))):
            poses = carried(stephenson(), "EF", -2.0, angles)
            moved = noisy(poses, 0.01, rng)
            best = designs(problem(moved, "stephenson-3", target=target))[0]
            own = rms([math.hypot(abs(a - b), size_of(moved) * (s - t))
                       for (a, s), (b, t) in zip(poses, moved)])
            self.assertLess(best["error"]["rms"], own)
            self.check(best, moved, "EF")

    def test_errors_are_those_of_the_poses_at_any_scale(self):
        rng = random.Random(3)
        small = noisy(carried(stephenson(), "EF", 0.7, chain_test.turn(12)), 1e-3, rng)
        for scale, away in some(((1e13, 0), (1e-9, 0), (1e7, 1e9))):
            poses = [(scale * at + away, angle) for at, angle in small]
            for design in designs(problem(poses, "stephenson-3", "[solve]\nstarts = 128\n")):
                self.check(design, poses, "EF")

    def test_longest_chain(self):
        """24 points, and the heading of the body beside them."""
        parts, last = FOUR_BAR.split("[[point]]")[0], ("B", "C")
        for i in range(6):
            parts += (f'[[point]]\nname = "E{i}"\non = ["{last[0]}", "{last[1]}"]\n'
                      f'[[pivot]]\nname = "G{i}"\n[[dyad]]\nnew = "F{i}"\n')
            parts += (f'joins = ["E{i}", "G{i}"]\n' if i else
                      f'type = "RRP"\njoins = "E{i}"\nslide = {{through = "G{i}"}}\n')
            last = f"E{i}", f"F{i}"
        parts += f'[[point]]\nname = "P"\non = ["{last[0]}", "{last[1]}"]\n'
        poses = carried(stephenson(), "EF", 0.7, chain_test.turn(12))
        text = problem(poses, "chain", parts + f"[solve]\nstarts = {ordinarily(12, 32)}\n")
        for design in designs(text):
            self.check(design, poses, last)
        more = text.replace("[solve]", '[[point]]\nname = "Q"\non = ["A", "B"]\n[solve]')
        self.assertIn("at most 24", run(more, command="check").stderr)

    def test_report_shows_the_body_at_its_origin(self):
        """Whatever its name is, and that of another point of its link."""
        poses = carried(stephenson(), "EF", 0.7, chain_test.turn(12))
        text = problem(poses, "chain", FOUR_BAR + """
[[point]]
name = "Q"
on = ["P", "C"]
[solve]
starts = 64
""", target='closed = true\npoint = "Q"')
        shown, result = report_of(text)
        for drawn, design in zip(shown["designs"], result["designs"], strict=True):
            places = chain_test.Chain(design["mechanism"]).places(1)
            axis = (places["C"] - places["B"]) / abs(places["C"] - places["B"])
            u, v, angle = drawn["guided"]["axes"]
            self.assertLess(abs(complex(u, v) - (places["Q"] - places["B"]) / axis), 1e-9)
            self.assertAlmostEqual(angle, design["metrics"]["body_angle_in_link_deg"], delta=1e-9)
            reached = [complex(*at) for at in drawn["reached"]]
            error = rms([abs(at - pose) for at, (pose, _) in zip(reached, poses, strict=True)])
            self.assertAlmostEqual(error, design["metrics"]["position_error_rms"], delta=1e-9)

    def test_timed_motion_has_its_times(self):
        angles = chain_test.turn(24)
        poses = carried(watt(), "EF", 3.0, angles)
        degrees = [math.degrees(angle) for angle in angles]
        best = designs(problem(poses, "watt-1", target='timing = "prescribed"\n'
                               f"crank_deg = {degrees}"))[0]
        self.assertLess(best["error"]["rms"], 1e-4 * size_of(poses))
        self.check(best, poses, "EF")
        for before, after in zip(best["crank_deg"], best["crank_deg"][1:]):
            step = (after - before) % 360
            self.assertAlmostEqual(min(step, 360 - step), 15, delta=1e-6)

    def test_four_bars_are_those_of_the_kind_without_chains(self):
        rng = random.Random(11)
        poses = noisy(carried(four_bar(), "BC", 0.3, chain_test.turn(24)[:20]), 0.02, rng)
        for weight in some((0.4, None)):
            given = f"angle_weight = {weight}\n" if weight else ""
            best = designs(problem(poses, "chain", FOUR_BAR, target=given))[0]
            self.check(best, poses, "BC", weight)
            other = designs(f'kind = "motion-generation"\n[target]\nposes = {rows(poses)}\n{given}'
                            '[mechanism]\ndyads = ["RR"]\n'
                            '[constraints]\nclass = "crank-rocker"\n')[0]
            self.assertAlmostEqual(best["error"]["rms"] / other["error"]["rms"], 1, delta=1e-6)

    def test_each_design_is_nearest_to_each_pose(self):
        """Also those that are not the best, and from few starts."""
        poses = noisy(carried(stephenson(), "EF", 0.3, chain_test.turn(20)), 0.003,
                      random.Random(8))
        text = problem(poses, "stephenson-3", "[solve]\nstarts = 256\ndesigns = 6\n",
                       target="closed = true\nangle_weight = 1")
        for design in designs(text):
            steep = max(map(abs, slopes(design, poses, "EF", 1)))
            self.assertLess(steep, 1e-5 * design["error"]["rms"])

    def test_link_with_three_pins(self):
        path = three_pin_paths.planted(2, random.Random(4), 35, body=0.4)
        poses = path[::10]
        best = designs(problem(poses, "three-pin-2", "[constraints]\n"
                               "transmission_angle_deg = [30, 150]\n[solve]\nstarts = 512\n"))[0]
        self.assertLess(best["error"]["rms"], 1e-4 * size_of(poses))
        moved = three_pin_paths.Design(best["mechanism"])
        link = moved.names[3:5]
        own = math.radians(best["metrics"]["body_angle_in_link_deg"])
        for (at, angle), crank in zip(poses, best["crank_deg"]):
            places = moved.places_after(math.radians(crank))
            turned = cmath.phase(places[link[1]] - places[link[0]]) + own
            self.assertLess(abs(places["P"] - at), 1e-3 * size_of(poses))
            self.assertLess(abs(math.remainder(turned - angle, 2 * math.pi)), 1e-3)

    def test_same_for_any_number_of_threads(self):
        poses = carried(stephenson(), "EF", 0.7, chain_test.turn(36))
        text = problem(poses, "stephenson-3", "[solve]\nstarts = 256\n")
        one, two = (json.loads(run(text, "--threads", threads).stdout)["designs"]
                    for threads in "12")
        self.assertEqual(one, two)

    def test_bounds_given_pivots_and_limits_are_kept(self):
        poses = carried(stephenson(), "EF", 0.7, chain_test.turn(36))
        rest = ('[[pivot]]\nname = "D"\nat = [3, 0.5]\n[bounds]\nlength = [0.5, 6]\n'
                'pivots = [[-3, -3], [4, 5]]\n[constraints]\ntransmission_angle_deg = [35, 145]\n'
                "rms_error_max = 0.001\n[solve]\nstarts = 512\n")
        for design in designs(problem(poses, "stephenson-3", rest)):
            mechanism = design["mechanism"]
            pivots = {row["name"]: row["at"] for row in mechanism["pivot"]}
            self.assertEqual(pivots["D"], [3, 0.5])
            for x, y in pivots.values():
                self.assertTrue(-3 <= x <= 4 and -3 <= y <= 5)
            for row in mechanism["dyad"]:
                self.assertTrue(all(0.5 - 1e-9 <= length <= 6 + 1e-9 for length in row["lengths"]))
            by_name = {row["name"]: row for row in design["constraints"]}
            self.assertEqual(by_name["rms_error_max"]["satisfied"], design["error"]["rms"] <= 0.001)


class Written(unittest.TestCase):
    """What files may say."""

    POSES = carried(stephenson(), "EF", 0.7, chain_test.turn(12))

    def faults(self, text):
        done = run(text, command="check")
        self.assertEqual(done.returncode, 2, done.stdout)
        return done.stderr

    def test_segments_are_poses(self):
        segments = [[[at.real, at.imag],
                     [(at + 2 * cmath.exp(1j * angle)).real, (at + 2 * cmath.exp(1j * angle)).imag]]
                    for at, angle in self.POSES]
        by_poses = problem(self.POSES, "stephenson-3", "[solve]\nstarts = 128\n")
        by_segments = by_poses.replace(f"poses = {rows(self.POSES)}", f"segments = {segments}")
        one, two = (designs(text)[0]["error"]["rms"] for text in (by_poses, by_segments))
        self.assertAlmostEqual(one, two, delta=1e-6 * size_of(self.POSES))

    def test_last_pose_that_is_the_first_closes_the_motion(self):
        text = problem([*self.POSES, self.POSES[0]], "six-bar", target="")
        checked = json.loads(run(text, command="check").stdout)
        self.assertTrue(checked["problem"]["target"]["closed"])
        self.assertEqual(len(checked["problem"]["target"]["poses"]), 12)

    def test_pose_a_whole_turn_on_is_the_first_again(self):
        (at, _), *others = self.POSES
        rng = random.Random(1)
        for _ in range(12):
            angle = round(rng.uniform(-180, 180), 1)
            first, again = ((at, math.radians(angle + more)) for more in (0, rng.choice((-360, 720))))
            text = problem([first, *others, again], "six-bar", target="")
            checked = json.loads(run(text, command="check").stdout)
            self.assertTrue(checked["problem"]["target"]["closed"])
            self.assertEqual(len(checked["problem"]["target"]["poses"]), 12)
            text = problem([first, again, *others], "six-bar")
            self.assertIn("pose 2 of target.poses repeats pose 1", self.faults(text))

    def test_faults_are_named(self):
        one = self.POSES[0]
        turned = [(one[0], one[1] + 0.1 * i) for i in range(4)]
        for text, message in (
                (problem(self.POSES[:2], "six-bar"), "expected 3 to 10000"),
                (problem([one, one, *self.POSES], "six-bar"), "repeats pose 1"),
                (problem(turned, "six-bar"), "at one place"),
                (problem([(at + 1e-15 * i, angle) for i, (at, angle) in enumerate(turned)], "six-bar"),
                 "at one place"),
                (problem(self.POSES, "sixbar"), '"six-bar"'),
                (problem(self.POSES, "four-bar"), "mechanism.type"),
                (problem(self.POSES, 5).replace('"5"', "5"), "mechanism.type is an integer"),
                (problem(self.POSES, "six-bar", FOUR_BAR).replace('type = "six-bar"', ""),
                 "mechanism.type is missing"),
                (problem([one, *self.POSES[4:5], one], "six-bar"), "two different poses"),
                (problem(self.POSES, "chain", FOUR_BAR.split("[[point]]")[0]), "joint of two links"),
                (problem(self.POSES, "six-bar", target='method = "exact"'), "least squares"),
                (problem(self.POSES, "six-bar", target="crank_deg = [0, 30]"), "12 poses"),
                (problem(self.POSES, "six-bar", target='timing = "prescribed"'), "for each pose"),
                (problem(self.POSES, "six-bar", target="angle_weight = 0"), "angle_weight"),
                (problem(self.POSES, "three-pin", '[constraints]\nover = "range"\n'), "over"),
                (problem(self.POSES, "six-bar", '[solve]\nobjectives = ["size"]\n'), "objectives"),
                (problem(self.POSES, "six-bar", '[constraints]\nclass = "crank-rocker"\n'),
                 "class"),
                (problem(self.POSES, "six-bar", "[raster]\nlength = 1\n"), "raster"),
                (problem(self.POSES, "six-bar", "[solve]\nrobust = 0.9\n"), "robust")):
            self.assertIn(message, self.faults(text))


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
