"""Chains of which a file gives every dimension: their errors and where the crank is at the targets,
against closures computed here point by point, also where limits are missed.

Run as: given_chain_test.py PROGRAM, the built program.
"""

import cmath
import math
import pathlib
import random
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from chain_test import Chain, planted_points, six_bar, turn  # noqa: E402
from written_files import solved  # noqa: E402

SIX_BAR = six_bar((3.5, 0), None, (4, 4, 3.5, 4.2), True, (3, 0.4), True, (3.5, -3), h=(-0.8, 1.5))
SLIDER_CRANK = Chain({
    "pivot": [{"name": "A", "at": (0.2, -0.1)}], "crank": {"at": "A", "pin": "B", "length": 1},
    "dyad": [{"type": "RRP", "joins": "B", "new": "C", "length": 3.2, "assembly": "open",
              "slide": {"through": "A", "direction_deg": 12, "offset": 0.3}}],
    "point": [{"name": "P", "on": ["B", "C"], "at": (1.6, 0.9)}]})


def toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml(part)}" for key, part in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def mechanism(chain, crank):
    """The tables of a chain with another length of the crank."""
    lists = {"pivot": [{"name": name, "at": (at.real, at.imag)} for name, at in chain.pivots.items()],
             "crank": [{**chain.crank, "length": crank}], "dyad": chain.dyads, "point": chain.points}
    lines = ["[mechanism]", 'type = "chain"']
    for name, rows in lists.items():
        for row in rows:
            lines.append("[crank]" if name == "crank" else f"[[{name}]]")
            lines += [f"{key} = {toml(value)}" for key, value in row.items()]
    return "\n".join(lines) + "\n"


def changed(chain, crank):
    """The same chain with another crank."""
    other = Chain({"pivot": [], "crank": {**chain.crank, "length": crank}, "dyad": chain.dyads,
                   "point": chain.points})
    other.pivots = chain.pivots
    return other


def without_points(chain):
    other = changed(chain, chain.crank["length"])
    other.points = []
    return other


def path_file(points, chain, crank, target="", constraints=""):
    rows = [[point.real, point.imag] for point in points]
    return (f'kind = "path-generation"\n[target]\npoints = {toml(rows)}\npoint = "P"\n{target}\n'
            f"{mechanism(chain, crank)}\n[constraints]\n{constraints}\n")


def nearest(chain, point):
    """The distance from the path, by a scan and golden section."""
    def distance(angle):
        return abs(chain.path("P", [angle])[0] - point)
    scan = turn(720)
    best = min(scan, key=distance)
    low, high = best - scan[1], best + scan[1]
    share = (math.sqrt(5) - 1) / 2
    for _ in range(60):
        a, b = high - share * (high - low), low + share * (high - low)
        low, high = (low, b) if distance(a) < distance(b) else (a, high)
    return distance((low + high) / 2)


class Paths(unittest.TestCase):
    def check_free(self, chain, constraints=""):
        crank = 1.02
        noise = random.Random(3)
        points = [at + complex(noise.gauss(0, 0.01), noise.gauss(0, 0.01))
                  for at in chain.path("P", turn(40))]
        result = solved(path_file(points, chain, crank, "closed = true", constraints))
        (design,) = result["designs"]
        distances = [nearest(changed(chain, crank), point) for point in points]
        self.assertAlmostEqual(design["error"]["max"], max(distances), delta=1e-8)
        self.assertAlmostEqual(design["error"]["sum_of_squares"], sum(d * d for d in distances),
                               delta=1e-8)
        self.assertEqual(design["origin"], "given")
        return result

    def test_nearest_points_of_the_path(self):
        for chain in (SIX_BAR, SLIDER_CRANK):
            self.assertEqual(self.check_free(chain)["status"], "solved")

    def test_a_limit_that_is_missed_is_said(self):
        result = self.check_free(SIX_BAR, "transmission_angle_deg = [60, 120]")
        self.assertEqual(result["status"], "infeasible")

    def test_points_where_the_path_comes_by_twice(self):
        """A fit of points in whose middle the path turns back upon itself; nearest to them all, it is in order."""
        chain = six_bar((3.5, 0), (-2.138634665, 4.176896838), (4, 4, 4.089928586, 3.873855746), True,
                        (3.283573366, 1.191443726), True, (2.095396177, -2.709387579))
        points = [complex(*at) for at in planted_points("partly-fixed")]
        (design,) = solved(path_file(points, chain, 1.0, "closed = true"))["designs"]
        least = sum(nearest(chain, point) ** 2 for point in points)
        self.assertAlmostEqual(design["error"]["sum_of_squares"], least, delta=1e-8)

    def test_many_points(self):
        points = SIX_BAR.path("P", turn(2000))
        (design,) = solved(path_file(points, SIX_BAR, 1.0, "closed = true"))["designs"]
        self.assertLess(design["error"]["max"], 1e-8)

    def test_timed(self):
        crank, angles = 0.97, turn(24, 20)
        points = SIX_BAR.path("P", angles)
        degrees = [math.degrees(angle) for angle in angles]
        target = f'timing = "prescribed"\ncrank_deg = {toml(degrees)}'
        (design,) = solved(path_file(points, SIX_BAR, crank, target))["designs"]
        other = changed(SIX_BAR, crank)

        def squares(phase):
            return sum(abs(at - point) ** 2 for at, point in
                       zip(other.path("P", [angle + phase for angle in angles]), points))
        own = math.radians(design["crank_deg"][0]) - angles[0]
        self.assertAlmostEqual(squares(own), design["error"]["sum_of_squares"], delta=1e-10)
        self.assertLessEqual(squares(own), min(map(squares, turn(3600))) + 1e-10)

    def test_out_of_reach(self):
        result = solved(path_file(SIX_BAR.path("P", turn(12)), SIX_BAR, 60.0, "closed = true"))
        self.assertEqual((result["status"], result["designs"]), ("no-solution", []))
        self.assertIn("cannot be assembled", result["notes"][0])


class Functions(unittest.TestCase):
    """The slider of the slider-crank as the output."""

    FILE = f"""kind = "function-generation"
[target]
output = "C"
%s
{mechanism(without_points(SLIDER_CRANK), 1.0)}
"""

    @staticmethod
    def outputs(angles):
        direction = complex(math.cos(math.radians(12)), math.sin(math.radians(12)))
        return [(SLIDER_CRANK.places(angle)["C"] / direction).real for angle in angles]

    def test_the_start_of_the_least_error(self):
        turns = [math.radians(5) * i for i in range(13)]
        wanted = [0.9 * x * x for x in turns]
        pairs = [[math.degrees(angle), way] for angle, way in zip(turns, wanted)]
        (design,) = solved(self.FILE % f"pairs = {toml(pairs)}")["designs"]

        def rms(start):
            found = [way - aim for way, aim in zip(self.outputs([start + a for a in turns]), wanted)]
            mean = sum(found) / len(found)
            return math.sqrt(sum((one - mean) ** 2 for one in found) / len(found))
        own = math.radians(design["metrics"]["input_start_deg"])
        self.assertAlmostEqual(rms(own), design["error"]["rms"], delta=1e-9)
        self.assertLessEqual(rms(own), min(map(rms, turn(3600))) + 1e-9)

    def test_the_start_within_limits_that_only_few_starts_meet(self):
        turns = [math.radians(5) * i for i in range(13)]
        pairs = [[math.degrees(angle), 0.9 * angle * angle] for angle in turns]
        text = self.FILE % f"pairs = {toml(pairs)}"

        def transmission(start):
            return min(SLIDER_CRANK.transmission(SLIDER_CRANK.places(start + i * turns[-1] / 60)) for i in range(61))
        best = max(turn(720), key=transmission)
        best = max((best + math.radians(i) / 2000 for i in range(-1000, 1001)), key=transmission)
        (free,) = solved(text)["designs"]
        for slack in (0.1, 1e-3):
            limit = transmission(best) - slack
            limits = f"[constraints]\ntransmission_angle_deg = [{limit!r}, {180 - limit!r}]\n"
            (design,) = solved(f"{text}\n{limits}")["designs"]
            with self.subTest(slack=slack):
                self.assertLess(free["metrics"]["transmission_angle_deg"]["min"], limit - 1)
                self.assertGreater(transmission(math.radians(design["metrics"]["input_start_deg"])), limit - 1e-6)
                self.assertGreater(design["error"]["rms"], free["error"]["rms"])

    def test_the_dwell_of_the_narrowest_band(self):
        dwell = "[[target.dwell]]\nover_deg = 60"
        (design,) = solved(self.FILE % f"stroke_min = 1\n{dwell}")["designs"]

        def half_band(start):
            found = self.outputs([start + math.radians(0.25) * i for i in range(241)])
            return (max(found) - min(found)) / 2
        own = math.radians(design["metrics"]["dwell_from_deg"])
        self.assertAlmostEqual(half_band(own), design["error"]["max"], delta=1e-6)
        self.assertLessEqual(half_band(own), min(map(half_band, turn(720))) + 1e-6)


class CranksThatDoNotTurn(unittest.TestCase):
    """Targets over most of the range of a crank, also of a narrow one: they are reached exactly."""

    @staticmethod
    def planted(noise, share, is_narrow):
        """A four-bar as a chain, and crank angles over a share of its range, −reach to reach."""
        reach = math.radians(noise.uniform(10, 25) if is_narrow else noise.uniform(60, 160))
        crank, frame = noise.uniform(1, 3), noise.uniform(1, 3)
        longest = abs(frame - cmath.rect(crank, reach))  # of coupler and rocker in line
        difference = noise.uniform(-0.9, 0.9) * abs(crank - frame)
        coupler, rocker = (longest + difference) / 2, (longest - difference) / 2
        chain = Chain({
            "pivot": [{"name": "A", "at": (0, 0)}, {"name": "D", "at": (frame, 0)}],
            "crank": {"at": "A", "pin": "B", "length": crank},
            "dyad": [{"joins": ["B", "D"], "new": "C", "lengths": [coupler, rocker],
                      "assembly": noise.choice(["open", "crossed"])}],
            "point": [{"name": "P", "on": ["B", "C"], "at": (noise.uniform(-1, 3), noise.uniform(-2, 2))}]})
        first = -reach + noise.uniform(0.01, 0.99) * 2 * reach * (1 - share)
        return chain, [first + 2 * reach * share * i / 12 for i in range(13)]

    def test_targets_over_most_of_the_range(self):
        noise, worst = random.Random(5), 0
        for share in (0.5, 0.9, 0.99):
            for i in range(4):
                chain, angles = self.planted(noise, share, i % 2 == 0)
                points = chain.path("P", angles)
                degrees = [math.degrees(angle - angles[0]) + 37 for angle in angles]
                crank, over = chain.crank["length"], 'over = "range"'
                timed = f'timing = "prescribed"\ncrank_deg = {toml(degrees)}'
                at = [chain.places(angle) for angle in angles]
                turns = [math.atan2((here["C"] - here["D"]).imag, (here["C"] - here["D"]).real) for here in at]
                pairs = [[math.degrees(angle - angles[0]), math.degrees(math.remainder(turn - turns[0], math.tau))]
                         for angle, turn in zip(angles, turns)]
                function = (f'kind = "function-generation"\n[target]\noutput = ["D", "C"]\npairs_deg = {toml(pairs)}\n'
                            f"{mechanism(without_points(chain), crank)}\n[constraints]\n{over}\n")
                for text in (path_file(points, chain, crank, timed, over),
                             path_file(points, chain, crank, "", over), function):
                    (design,) = solved(text)["designs"]
                    worst = max(worst, design["error"]["rms"])
        self.assertLess(worst, 1e-7)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
