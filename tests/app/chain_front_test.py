"""Fronts of chains: the error against the number of links, the transmission angle, or the size.

Every design is computed again by the closure of chain_test.py. Run as: chain_front_test.py PROGRAM.
"""

import functools
import json
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import STEPHENSON_A, STEPHENSON_B, Chain, turn  # noqa: E402
from thinned import ordinarily, WHOLE, whole_only  # noqa: E402
from written_files import command, solved  # noqa: E402

FILE = """kind = "path-generation"
[target]
points = {points}
closed = true
[mechanism]
type = "{type}"
[bounds]
length = [0.2, 12]
pivots = [[-12, -12], [12, 12]]
point = [[-12, -12], [12, 12]]
[constraints]
transmission_angle_deg = [{least}, {greatest}]
[solve]
objectives = ["error", "{against}"]
{more}
"""


def file_of(points, kind, against, least=30, more=""):
    return FILE.format(points=[[z.real, z.imag] for z in points], type=kind, against=against, least=least,
                       greatest=180 - least, more=more)


def noisy(points, seed, share):
    """The points moved at random by a share of their size."""
    generator = random.Random(seed)
    size = max(abs(a - b) for a in points for b in points)
    return [z + share * size * complex(generator.gauss(0, 1), generator.gauss(0, 1)) for z in points]


FOUR_BAR = Chain({"pivot": [{"name": "A", "at": (0, 0)}, {"name": "D", "at": (4, 0.5)}],
                  "crank": {"at": "A", "pin": "B", "length": 1},
                  "dyad": [{"joins": ["B", "D"], "lengths": (3.5, 3), "assembly": "open", "new": "C"}],
                  "point": [{"name": "P", "on": ["B", "C"], "at": (2, 1.5)}]})
NOISY = noisy(STEPHENSON_B.path("P", turn(24)), 5, 0.003)
BY_TRANSMISSION = file_of(NOISY, "stephenson-3", "transmission_angle", 20, f"designs = 4\nstarts = {ordinarily(8, 256)}")


@functools.cache
def front_by_transmission():
    return solved(BY_TRANSMISSION)


def front_of(result):
    (family,) = result["families"]
    return [column["values"] for column in family["columns"]]


def unrolled(cranks):
    """Angles of one turn as they follow one another, in the sense in which they turn less."""
    ways = []
    for sense in (1, -1):
        ways.append([cranks[0]])
        for before, after in zip(cranks, cranks[1:]):
            step = (sense * (after - before) + 1e-7) % (2 * math.pi) - 1e-7
            ways[-1].append(ways[-1][-1] + sense * step)
    return min(ways, key=lambda way: abs(way[-1] - way[0]))


def to_segment(point, start, end):
    share = ((point - start) / (end - start)).real if end != start else 0
    return abs(point - start - min(1, max(0, share)) * (end - start))


def stray(chain, points, cranks):
    """What the closed curve strays between points beyond what it misses and half of the ways beside."""
    angles = unrolled(cranks)
    count = len(points)
    angles.append(angles[0] + math.copysign(2 * math.pi, angles[-1] - angles[0]))
    missed = [abs(a - b) for a, b in zip(chain.path("P", angles[:-1]), points)]
    ways = [abs(points[(i + 1) % count] - points[i]) for i in range(count)]
    squares = []
    for i in range(count):
        following = (i + 1) % count
        free = max(ways[i - 1], ways[i], ways[following]) / 2 + max(missed[i], missed[following])
        for share in (0.25, 0.5, 0.75):
            point = chain.places(angles[i] + share * (angles[i + 1] - angles[i]))["P"]
            squares.append(max(0, to_segment(point, points[i], points[following]) - free) ** 2)
    return math.sqrt(sum(squares) / len(squares))


class ChainFronts(unittest.TestCase):
    def check_errors(self, result, points):
        """The error of each design is that of its closure, and the front's."""
        errors = front_of(result)[1]
        self.assertEqual(len(errors), len(result["designs"]))
        for design, error in zip(result["designs"], errors):
            chain = Chain(design["mechanism"])
            reached = chain.path("P", [math.radians(angle) for angle in design["crank_deg"]])
            rms = math.sqrt(sum(abs(a - b) ** 2 for a, b in zip(reached, points)) / len(points))
            self.assertAlmostEqual(rms, error, delta=1e-6 * abs(points[0]) + 1e-6 * error)
            self.assertEqual(design["error"]["rms"], error)
            strays = stray(chain, points, [math.radians(angle) for angle in design["crank_deg"]])
            self.assertAlmostEqual(design["metrics"].get("stray_between_points", 0), strays,
                                   delta=1e-6 * max(abs(z) for z in points))
            self.assertTrue(all(check["satisfied"] for check in design["constraints"]))

    def check_is_front(self, measures, errors, greatest_is_best):
        """Along a front what gets better in one gets worse in the other."""
        for a, b in zip(range(len(errors)), range(1, len(errors))):
            self.assertLess(errors[a], errors[b])
            better = measures[b] > measures[a] if greatest_is_best else measures[b] < measures[a]
            self.assertTrue(better, (measures, errors))

    def test_no_more_links_than_a_target_needs(self):
        points = FOUR_BAR.path("P", turn(24))
        result = solved(file_of(points, "any", "links"))
        links, errors = front_of(result)
        self.assertEqual(links, [4])
        self.assertLess(errors[0], 1e-9)
        self.check_errors(result, points)

    @whole_only
    def test_links_are_worth_what_they_cost(self):
        points = noisy(STEPHENSON_A.path("P", turn(36)), 3, 0.002)
        result = solved(file_of(points, "any", "links", more="starts = 256"))
        links, errors = front_of(result)
        self.assertEqual(links, [8, 6, 4])
        self.check_is_front(links, errors, False)
        self.check_errors(result, points)
        self.assertEqual([design["metrics"]["link_count"] for design in result["designs"]], links)
        for design, count in zip(result["designs"], links):
            self.assertEqual(2 + 2 * len(design["mechanism"]["dyad"]), count)

    def test_of_designs_that_meet_the_points_the_first_strays_least(self):
        half = [1.3, 0.707 + 0.407j, -0.3 + 1j, -0.707 + 1.007j]
        points = [*half, -0.7, *(z.conjugate() for z in half[:0:-1])]
        text = file_of([complex(z) for z in points], "six-bar", "size", 0, "designs = 12\nstarts = 64")
        text = text.replace("[0.2, 12]", "[0.1, 3]").replace('objectives = ["error", "size"]', "")
        designs = solved(text)["designs"]
        self.assertGreater(len(designs), 2)
        strays = [design["metrics"].get("stray_between_points", 0) for design in designs
                  if design["error"]["rms"] < 1e-11]
        self.assertGreater(len(strays), 1)
        self.assertGreater(strays[-1], 0)
        self.assertEqual(strays, sorted(strays))

    def test_better_transmission_costs_error(self):
        result = front_by_transmission()
        angles, errors = front_of(result)
        self.assertGreaterEqual(len(errors), ordinarily(3, 4))
        self.check_is_front(angles, errors, True)
        self.check_errors(result, NOISY)
        for design, angle in zip(result["designs"], angles):
            chain = Chain(design["mechanism"])
            least = min(chain.transmission(chain.places(crank)) for crank in turn(3600))
            self.assertAlmostEqual(least, angle, delta=0.01)
            self.assertGreaterEqual(angle, 20 - 1e-6)

    def test_smaller_chains_have_greater_errors(self):
        points = noisy(STEPHENSON_B.path("P", turn(24)), 6, 0.003)
        text = file_of(points, "watt-1", "size", 30, f"designs = 4\nstarts = {ordinarily(16, 256)}")
        result = solved(text)
        sizes, errors = front_of(result)
        self.assertGreaterEqual(len(errors), 3)
        self.check_is_front(sizes, errors, False)
        self.check_errors(result, points)
        for design, size in zip(result["designs"], sizes):
            lengths = [design["mechanism"]["crank"]["length"]]
            lengths += [length for dyad in design["mechanism"]["dyad"] for length in dyad["lengths"]]
            self.assertAlmostEqual(max(lengths), size, delta=1e-9 * size)
            self.assertEqual(design["metrics"]["longest_link"], size)
        if not WHOLE:
            return
        # The front goes on to sizes below which hardly anything is found, and is as good as a search of many more starts
        # within the bounds of a size.
        def alone_below(most):
            within = text.replace("[0.2, 12]", f"[0.2, {most}]").replace("starts = 256", "starts = 2048")
            return solved(within.replace('objectives = ["error", "size"]', ""))["designs"]
        self.assertLess(sizes[-1], sizes[0] / 3)
        self.assertTrue(all(design["error"]["rms"] > errors[-1] for design in alone_below(0.9 * sizes[-1])))
        alone = alone_below(sizes[1])[0]
        self.assertLessEqual(errors[1], 1.1 * alone["error"]["rms"])

    @whole_only
    def test_no_design_of_a_front_is_worse_than_the_error_allowed(self):
        most = front_of(front_by_transmission())[1][-2]
        limited = solved(BY_TRANSMISSION.replace("[constraints]", f"[constraints]\nrms_error_max = {most}"))
        self.assertLessEqual(max(front_of(limited)[1]), most * (1 + 1e-9))

    @whole_only
    def test_the_same_seed_gives_the_same_front_for_any_threads(self):
        points = noisy(STEPHENSON_B.path("P", turn(16)), 8, 0.01)
        text = file_of(points, "stephenson-3", "transmission_angle", 30, "designs = 3\nstarts = 64")
        one, three = (json.loads(command(text, "solve", "--json", "--quiet", "--threads", threads).stdout)
                      for threads in ("1", "3"))
        self.assertEqual(front_of(one), front_of(three))

    def test_time_is_shared_among_the_numbers_of_links(self):
        points = noisy(STEPHENSON_B.path("P", turn(36)), 9, 0.02)
        done = command(file_of(points, "any", "links"), "solve", "--json", "--quiet", "--time-limit", "3")
        result = json.loads(done.stdout)
        self.assertIn(result["status"], ("solved", "time-limit"))
        self.assertGreaterEqual(len(front_of(result)[0]), 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
