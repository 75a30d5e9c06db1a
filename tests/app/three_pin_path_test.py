"""Paths of mechanisms with a three-pin link: planted ones are found again, exact and with noise, and
what results say of them is so by a closure of its own.

Run as: three_pin_path_test.py PROGRAM, the built program.
"""

import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import three_pin_paths
from thinned import ordinarily, some, whole_only

PROGRAM = ""
SAMPLES = 2880

CHAIN = """
[[pivot]]
name = "A"
[[pivot]]
name = "D"
[[pivot]]
name = "G"
[crank]
at = "A"
pin = "B"
[[dyad]]
joins = ["B", "D"]
new = "C"
[[point]]
name = "E"
on = ["B", "C"]
[[dyad]]
type = "three-pin"
joins = ["B", "E", "G"]
new = ["K", "L", "M"]
[[point]]
name = "T"
on = ["K", "L"]
"""


def problem(points, kind, rest=""):
    rows = ", ".join(f"[{p.real:.15g}, {p.imag:.15g}]" for p in points)
    return (f'kind = "path-generation"\n[target]\nclosed = true\npoints = [{rows}]\n'
            f'[mechanism]\ntype = "{kind}"\n{rest}')


def run(text, *arguments, command="solve"):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "problem.toml"
        path.write_text(text, encoding="utf-8")
        return subprocess.run([PROGRAM, "--quiet", "--json", *arguments, command, path],
                              capture_output=True, text=True, check=False)


def designs(text, *arguments):
    return json.loads(run(text, *arguments).stdout)["designs"]


def target(kind, seed):
    return three_pin_paths.at_equal_arcs(three_pin_paths.planted(kind, random.Random(seed), 35), 72)


class Found(unittest.TestCase):
    def check(self, design, points, name="P"):
        """What the result says is so."""
        moved = three_pin_paths.Design(design["mechanism"]).path(name, SAMPLES)
        self.assertIsNotNone(moved)
        path, least = moved
        rms = three_pin_paths.rms_distance(path, points)
        size = three_pin_paths.size_of(points)
        self.assertLess(abs(rms - design["error"]["rms"]), 2e-5 * size)
        stated = design["metrics"]["transmission_angle_deg"]["acute_min"]
        self.assertAlmostEqual(least, stated, delta=0.01)
        self.assertGreaterEqual(least, 30 - 0.001)

    def test_planted_paths_are_found_again(self):
        for kind, seed in some(((1, 3), (2, 4))):
            points = target(kind, seed)
            best = designs(problem(points, f"three-pin-{kind}", "[solve]\nstarts = 2048\n"
                                   "[constraints]\ntransmission_angle_deg = [30, 150]\n"))[0]
            diagonal = max(abs(p - q) for p in points for q in points)
            self.assertLess(best["error"]["rms"], 1e-4 * diagonal)
            self.check(best, points)

    @whole_only
    def test_noise_is_not_exceeded(self):
        rng = random.Random(7)
        path = three_pin_paths.planted(1, rng, 35)
        points = three_pin_paths.at_equal_arcs(path, 72)
        noise = 0.001 * three_pin_paths.size_of(points)
        points = [p + noise * complex(rng.gauss(0, 1), rng.gauss(0, 1)) for p in points]
        best = designs(problem(points, "three-pin-1", "[solve]\nstarts = 1024\n"
                               "[constraints]\ntransmission_angle_deg = [30, 150]\n"))[0]
        self.assertLess(best["error"]["rms"], three_pin_paths.rms_distance(path, points))
        self.check(best, points)

    def test_timed_path_has_its_times(self):
        path = three_pin_paths.planted(1, random.Random(9), 35)
        points = path[::30]
        degrees = ", ".join(str(15 * i) for i in range(len(points)))
        text = problem(points, "three-pin-1", "[solve]\nstarts = 1024\n"
                       "[constraints]\ntransmission_angle_deg = [30, 150]\n").replace(
                           "closed = true", f'timing = "prescribed"\ncrank_deg = [{degrees}]')
        best = designs(text)[0]
        self.assertLess(best["error"]["rms"], 1e-4 * three_pin_paths.size_of(points))
        crank = best["crank_deg"]
        steps = [(after - before) % 360 for before, after in zip(crank, crank[1:])]
        for step in steps:
            self.assertAlmostEqual(min(step, 360 - step), 15, delta=1e-6)

    def test_same_for_any_number_of_threads(self):
        text = problem(target(1, 3), "three-pin-1", f"[solve]\nstarts = {ordinarily(16, 256)}\n")
        one, two = (json.loads(run(text, "--threads", threads).stdout)["designs"]
                    for threads in "12")
        self.assertEqual(one, two)

    def test_bounds_and_given_places_are_kept(self):
        points = target(1, 3)
        a, b = points[0], points[36]
        rest = (f'[solve]\nstarts = {ordinarily(64, 512)}\n[bounds]\nlength = [0.1, 60]\nC = [0.5, 55]\nGF-link = [0.5, 50]\n'
                f'E = [[0.5, 50], [0.25, 45]]\n[[pivot]]\nname = "D"\n'
                f'at = [{a.real + 2 * abs(b - a)}, {a.imag}]\n')
        for design in designs(problem(points, "three-pin-1", rest)):
            joints = design["mechanism"]["dyad"][0]["joint"]
            pivots = {row["name"]: row["at"] for row in design["mechanism"]["pivot"]}
            self.assertEqual(pivots["D"], [a.real + 2 * abs(b - a), a.imag])
            lengths = [joint["at"][0][0] for joint in joints[3:]]
            self.assertTrue(0.5 <= lengths[0] <= 55 and 0.5 <= lengths[2] <= 50)
            self.assertTrue(0.25 <= joints[4]["at"][1][0] <= 45)

    def test_a_chain_of_the_file_has_such_a_link(self):
        points = target(2, 4)
        text = problem(points, "chain", "") + CHAIN + "[solve]\nstarts = 16\n"
        text = text.replace("closed = true", 'closed = true\npoint = "T"')
        best = designs(text)[0]
        dyad, group = best["mechanism"]["dyad"]
        self.assertEqual(group["names"], ["BK", "EL", "GM", "KLM"])
        self.assertEqual([joint["name"] for joint in group["joint"]], list("BEGKLM"))
        self.assertEqual(dyad["new"], "C")
        self.assertIsNotNone(best["error"]["rms"])


    def test_points_of_every_link_and_joints_are_traced(self):
        text = problem(target(1, 3), "chain") + CHAIN.replace(
            '["B", "E", "G"]', '["B", "D", "G"]').replace("""[[dyad]]
joins = ["B", "D"]
new = "C"
[[point]]
name = "E"
on = ["B", "C"]
""", "")
        for on in (["B", "K"], ["D", "L"], ["G", "M"], ["K", "L"], ["L", "M"]):
            named = text.replace('on = ["K", "L"]', f"on = {json.dumps(on)}")
            self.assertEqual(run(named, command="check").returncode, 0, on)
        bare = text[:text.index('[[point]]\nname = "T"')]
        for point in ("", '\npoint = "K"', '\npoint = "M"'):
            chosen = bare.replace("closed = true", "closed = true" + point)
            self.assertEqual(run(chosen, command="check").returncode, 0, point)
        hung = bare + """[[dyad]]
joins = ["K", "A"]
new = "N"
"""
        self.assertEqual(run(hung, command="check").returncode, 0)

    @whole_only
    def test_size_does_not_matter(self):
        points = target(1, 3)
        text = problem([1e60 * p for p in points], "three-pin-1", "[solve]\nstarts = 256\n")
        self.assertLess(designs(text)[0]["error"]["rms"],
                        0.05e60 * three_pin_paths.size_of(points))


class Refused(unittest.TestCase):
    def check(self, text, *words):
        result = run(text, command="check")
        self.assertEqual(result.returncode, 2, text)
        for word in words:
            self.assertIn(word, result.stderr + result.stdout)

    def test_what_is_of_dyads_alone(self):
        points = target(1, 3)
        for rest, word in (('[tolerance]\nlengths = "m"\n', "tolerance is for chains of dyads"),
                           ("[layers]\nlink = 1\n", "layers is for chains of dyads"),
                           ("[raster]\nstep = 1\n", "raster is for chains of dyads"),
                           ('[constraints]\nover = "range"\n', "turns fully")):
            self.check(problem(points, "three-pin-1", rest), word)

    def test_faulty_links(self):
        text = problem(target(1, 3), "chain") + CHAIN
        for old, new, word in (
                ('["K", "L", "M"]', '["K", "L"]', "has 2 names"),
                ('["K", "L", "M"]', '["K", "L", "K"]', "name of another point"),
                ('["B", "E", "G"]', '["B", "B", "G"]', "twice"),
                ('["B", "E", "G"]', '["A", "D", "G"]', "one body"),
                ('["B", "E", "G"]', '["B", "Q", "G"]', "no point of the chain"),
                ('type = "three-pin"', 'type = "three-pin"\nlengths = [1, 2]', "are found"),
                ('["B", "E", "G"]', '["B", "E", "GM-link"]', "GM-link"),
                ('["B", "E", "G"]', '["B", "C-drawn", "G"]', "no point of the chain"),
                ('type = "three-pin"', 'type = "three_pin"', "perhaps for"),
                ('"M"]', '"frame"]', "that of a body"),
                ('name = "D"', 'name = "K-drawn"', "rename")):
            self.check(text.replace(old, new), word)

    def test_its_dimensions_are_not_given(self):
        """One message says so, whatever is given."""
        chain, known = problem(target(1, 3), "chain") + CHAIN, problem(target(1, 3), "three-pin-1")
        for given in ("lengths = [1, 2]", "lengths = [1, 2, 3]", 'lengths = "free"', "lengths = 3", "length = 3",
                      'assembly = "open"', 'assembly = "left"', "slide = 1"):
            with self.subTest(given):
                self.check_alone(chain.replace('type = "three-pin"', f'type = "three-pin"\n{given}'), "given of a three-pin link")
        for row in ('new = ["C", "E", "F"]\nlengths = [1, 2, 3]', 'new = "F"\nlengths = [1, 2]',
                    'type = "three-pin"\njoins = ["B", "D", "G"]\nnew = ["C", "E", "F"]', "lengths = 3"):
            with self.subTest(row):
                self.check_alone(f"{known}[[dyad]]\n{row}\n", "given of a three-pin link")
        self.check_alone(chain.replace('"M"]', '"M"]\nnames = ["k", "l"]'), "named by their points")

    def check_alone(self, text, words):
        result = run(text, command="check")
        messages = [line for line in result.stderr.splitlines() if "problem.toml:" in line]
        self.assertEqual((result.returncode, len(messages)), (2, 1), result.stderr)
        self.assertIn(words, messages[0])


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
