"""Paths of six-bars, eight-bars and chains of dyads, against closures computed here point by point,
by intersection of circles.

Run as: chain_test.py PROGRAM LIBRARY, the built program and the folder of library problems. With
`--points NAME` instead it prints the target points of a planted design, as library files have them.
"""

import cmath
import contextlib
import json
import math
import pathlib
import sqlite3
import subprocess
import sys
import tempfile
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from thinned import whole_only  # noqa: E402

PROGRAM = ""
LIBRARY = pathlib.Path()

SAMPLES = 4000


def intersection(p, q, a, b, left):
    """The point at distances a from p and b from q, to the left of the way from p to q or not."""
    way = q - p
    distance = abs(way)
    along = (a * a - b * b + distance * distance) / (2 * distance)
    height2 = a * a - along * along
    if height2 < 0:
        return None
    return p + way / distance * complex(along, math.sqrt(height2) * (1 if left else -1))


def guide_of(at, row):
    """The direction of a slider's guide, and the foot of the point from which its offset counts."""
    slide = row["slide"]
    direction = cmath.rect(1, math.radians(slide.get("direction_deg", 0)))
    through = slide["through"]
    through = at[through] if isinstance(through, str) else complex(*through)
    return direction, through + 1j * direction * slide.get("offset", 0)


def joined(row):
    """The points that a dyad joins."""
    return [row["joins"]] if isinstance(row["joins"], str) else row["joins"]


def slider_pin(at, row):
    """Where the link meets the guide; None where it does not."""
    direction, on = guide_of(at, row)
    (length,), start = row["lengths"] if "lengths" in row else [row["length"]], at[joined(row)[0]]
    away = (start - on) / direction
    if abs(away.imag) > length:
        return None
    along = math.sqrt(length * length - away.imag ** 2) * (1 if row["assembly"] == "open" else -1)
    return on + direction * (away.real + along)


class Chain:
    """A mechanism as result documents describe it: pivot, crank, dyad, point."""

    def __init__(self, mechanism):
        self.pivots = {row["name"]: complex(*row["at"]) for row in mechanism["pivot"]}
        self.crank = mechanism["crank"]
        self.dyads = mechanism["dyad"]
        self.points = mechanism.get("point", [])

    def places(self, angle):
        """Every point by name; None where the chain does not close."""
        at = dict(self.pivots)
        at[self.crank["pin"]] = at[self.crank["at"]] + cmath.rect(self.crank["length"], angle)
        waiting = list(self.points)

        def place_points():
            for row in list(waiting):
                first, second = row["on"]
                if first in at and second in at:
                    direction = (at[second] - at[first]) / abs(at[second] - at[first])
                    at[row["name"]] = at[first] + direction * complex(*row["at"])
                    waiting.remove(row)

        place_points()
        for row in self.dyads:
            joint = slider_pin(at, row) if "slide" in row else intersection(
                *(at[end] for end in row["joins"]), *row["lengths"], row["assembly"] == "open")
            if joint is None:
                return None
            at[row["new"]] = joint
            place_points()
        return at

    def closure(self, at):
        """The largest error of a length, relative to it."""
        return max(abs(abs(at[row["new"]] - at[end]) / length - 1) for row in self.dyads
                   for end, length in zip(joined(row), row.get("lengths") or [row["length"]]))

    def transmission(self, at):
        """The least angle between the links of a dyad, of a slider that between its link and the
        normal of its guide, and its supplement, in degrees."""
        least = 90.0
        for row in self.dyads:
            first, second = (at[end] - at[row["new"]] for end in (joined(row) * 2)[:2])
            if "slide" in row:
                second = 1j * guide_of(at, row)[0]
            angle = math.degrees(abs(cmath.phase(first / second)))
            least = min(least, angle, 180 - angle)
        return least

    def path(self, name, angles):
        return [self.places(angle)[name] for angle in angles]


def turn(count, start=0.0):
    return [math.radians(start) + 2 * math.pi * i / count for i in range(count)]


def six_bar(d, g, lengths, c, e, second, p, h=None):
    """Crank 1 at (0, 0); `c` and `second` say whether a dyad is open; h on DC makes it a Watt."""
    bc, dc, ef, gf = lengths
    word = {True: "open", False: "crossed"}
    pivots = [{"name": "A", "at": (0, 0)}, {"name": "D", "at": d}]
    points = [{"name": "E", "on": ["B", "C"], "at": e}]
    if h is None:
        pivots.append({"name": "G", "at": g})
    else:
        points.append({"name": "H", "on": ["D", "C"], "at": h})
    points.append({"name": "P", "on": ["E", "F"], "at": p})
    return Chain({"pivot": pivots, "crank": {"at": "A", "pin": "B", "length": 1},
                  "dyad": [{"joins": ["B", "D"], "lengths": (bc, dc), "assembly": word[c], "new": "C"},
                           {"joins": ["E", "G" if h is None else "H"], "lengths": (ef, gf),
                            "assembly": word[second], "new": "F"}],
                  "point": points})


def eight_bar():
    """Stephenson III b with a dyad from EF to the frame; the point on its first link."""
    chain = six_bar((3.5, 0), (-1.5, 4.5), (4, 4, 3.5, 3.5), True, (3, 0), True, (0, 0))
    chain.pivots["L"] = complex(0.5, 7.0)
    chain.dyads.append({"joins": ["K", "L"], "lengths": (4, 3.5), "assembly": "open", "new": "J"})
    chain.points = [row for row in chain.points if row["name"] != "P"]
    chain.points += [{"name": "K", "on": ["E", "F"], "at": (2.5, 1.5)},
                     {"name": "P", "on": ["K", "J"], "at": (2, 2)}]
    return chain


STEPHENSON_A = six_bar((4, 0), (0, 0.5), (4, 2, 3, 1.5), False, (1.5, 3), False, (-1, -2.5))
STEPHENSON_B = six_bar((3.5, 0), (-1.5, 4.5), (4, 4, 3.5, 3.5), True, (3, 0), True, (3.5, -3))
WATT_A = six_bar((3.5, 0), None, (3, 3.5, 3.5, 2.5), True, (-2, -0.5), False, (1.5, -3), (0, 0.5))
EIGHT_BAR = eight_bar()
SLIDER_CRANK = Chain({
    "pivot": [{"name": "A", "at": (0, 0)}], "crank": {"at": "A", "pin": "B", "length": 1},
    "dyad": [{"type": "RRP", "joins": "B", "length": 3, "assembly": "open", "new": "C",
              "slide": {"through": "A", "direction_deg": 12, "offset": 0.4}}],
    "point": [{"name": "P", "on": ["B", "C"], "at": (1.8, 0.9)}]})

# Of each library file its planted design, the traced point, its crank angles and the digits that
# the points have.
PLANTED = {"stephenson-path": (STEPHENSON_A, "P", turn(60), 9),
           "watt-path": (WATT_A, "P", turn(60), 9),
           "eight-bar-path": (EIGHT_BAR, "P", turn(60), 9),
           "timed-arc": (STEPHENSON_B, "P", [math.radians(20 + 5 * i) for i in range(31)], 9),
           "partly-fixed": (STEPHENSON_B, "P", turn(48), 9),
           "slider-crank-path": (SLIDER_CRANK, "P", turn(60), 9)}


def planted_points(name):
    chain, point, angles, digits = PLANTED[name]
    return [[round(place.real, digits), round(place.imag, digits)] for place in
            chain.path(point, angles)]


def size_of(points):
    """The diagonal of the box around the points."""
    x, y = zip(*points)
    return math.hypot(max(x) - min(x), max(y) - min(y))


def solve(file, *arguments):
    done = subprocess.run([PROGRAM, "solve", file, "--json", "--quiet", *arguments],
                          capture_output=True, text=True, timeout=600)
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


class Oracle(unittest.TestCase):
    """The closures of this file against published numbers of the same designs."""

    def test_places_and_boxes(self):
        for chain, box, start in (
                (STEPHENSON_A, (1.582795, 4.728419, 3.904168, 5.064650), 4.672811290 + 4.433700305j),
                (STEPHENSON_B, (-3.695795, -2.143496, 3.427059, 4.279017), -2.612305864 + 3.590878503j),
                (WATT_A, (-1.414650, 2.955716, -5.990570, -4.143728), 2.407932077 - 5.143872267j)):
            path = chain.path("P", turn(SAMPLES))
            found = (min(p.real for p in path), max(p.real for p in path),
                     min(p.imag for p in path), max(p.imag for p in path))
            for value, wanted in zip(found, box):
                self.assertAlmostEqual(value, wanted, delta=5e-6)
            self.assertLess(abs(path[0] - start), 2e-9)

    def test_transmission(self):
        slider_crank = math.degrees(math.acos(1.4 / 3))  # where the crank stands across the guide
        for chain, least in ((STEPHENSON_A, 36.619), (STEPHENSON_B, 36.420), (WATT_A, 44.415),
                             (SLIDER_CRANK, slider_crank)):
            found = min(chain.transmission(chain.places(angle)) for angle in turn(SAMPLES))
            self.assertAlmostEqual(found, least, delta=1e-3)

    def test_points_of_library_files_are_those_of_planted_designs(self):
        for name in PLANTED:
            with self.subTest(file=name):
                target = tomllib.loads((LIBRARY / "chain" / f"{name}.toml").read_text())["target"]
                self.assertEqual(target["points"], planted_points(name))


class Designs(unittest.TestCase):
    """Every design of every library file, computed again here."""

    def check_turn(self, chain, problem, stations):
        limits = problem["constraints"]
        angles = turn(SAMPLES)
        if limits["over"] == "range":
            first, last = math.radians(stations[0]), math.radians(stations[-1])
            angles = [first + (last - first) * i / SAMPLES for i in range(SAMPLES + 1)]
        places = [chain.places(angle) for angle in angles]
        self.assertNotIn(None, places, "the chain is assembled everywhere")
        self.assertLess(max(map(chain.closure, places)), 1e-12)
        low, high = limits["transmission_angle_deg"]
        self.assertGreaterEqual(min(map(chain.transmission, places)), max(low, 180 - high) - 1e-3)

    def check_errors(self, chain, point, target, design):
        reached = chain.path(point, map(math.radians, design["crank_deg"]))
        errors = [abs(place - complex(*wanted)) for place, wanted in zip(reached, target)]
        self.assertEqual(len(reached), len(target))
        size = size_of(target)
        self.assertAlmostEqual(max(errors), design["error"]["max"], delta=1e-9 * size)
        rms = math.sqrt(sum(e * e for e in errors) / len(errors))
        self.assertAlmostEqual(rms, design["error"]["rms"], delta=1e-9 * size)
        return max(errors) / size

    def check_timing(self, problem, design):
        target = problem["target"]
        if target["timing"] != "prescribed":
            return
        for found, wanted in zip(design["crank_deg"], target["crank_deg"]):
            step = found - design["crank_deg"][0] - (wanted - target["crank_deg"][0])
            self.assertAlmostEqual(math.remainder(step, 360), 0, delta=1e-9)

    def assert_kept(self, given, found):
        if isinstance(given, list):
            for own, reached in zip(given, found):
                self.assert_kept(own, reached)
        elif given != "free":
            self.assertEqual(found, given)

    def check_given(self, name, mechanism):
        file = tomllib.loads((LIBRARY / "chain" / f"{name}.toml").read_text())
        rows = {row[key]: row for table, key in (("pivot", "name"), ("dyad", "new"), ("point", "name"))
                for row in mechanism.get(table, [])}
        for table, key in (("pivot", "name"), ("dyad", "new"), ("point", "name")):
            for given in file.get(table, []):
                for dimension in ("at", "lengths", "length", "assembly"):
                    if dimension in given:
                        self.assert_kept(given[dimension], rows[given[key]][dimension])
        if "length" in file.get("crank", {}):
            self.assertEqual(mechanism["crank"]["length"], file["crank"]["length"])

    def check(self, name, share):
        result = solve(LIBRARY / "chain" / f"{name}.toml")
        self.assertEqual(result["status"], "solved", result["notes"])
        problem = result["problem"]
        point = problem["target"].get("point", "P")
        errors = []
        for design in result["designs"]:
            chain = Chain(design["mechanism"])
            self.check_turn(chain, problem, design["crank_deg"])
            errors.append(self.check_errors(chain, point, problem["target"]["points"], design))
            self.check_timing(problem, design)
            self.check_given(name, design["mechanism"])
        self.assertLess(errors[0], share, "the planted design or one as good is found")

    def test_stephenson(self):
        self.check("stephenson-path", 1e-4)

    @whole_only
    def test_watt(self):
        self.check("watt-path", 1e-4)

    @whole_only
    def test_eight_bar(self):
        self.check("eight-bar-path", 5e-3)

    def test_timed_arc(self):
        self.check("timed-arc", 1e-4)

    def test_partly_fixed(self):
        self.check("partly-fixed", 1e-4)

    def test_slider_crank(self):
        self.check("slider-crank-path", 1e-8)


class Files(unittest.TestCase):
    """What the commands make of a result."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments, "--out", self.folder], capture_output=True,
                              text=True, timeout=600)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr}")

    def test_exports_and_report(self):
        self.run_program("solve", LIBRARY / "chain" / "timed-arc.toml", "--quiet")
        result = self.folder / "timed-arc.result.json"
        page = (self.folder / "timed-arc.report.html").read_text()
        self.assertIn('"reached"', page)
        self.assertNotIn('"mechanism":null', page.replace(" ", ""), "every design is drawn")
        before = set(self.folder.iterdir())
        for form in ("csv", "svg", "dxf", "toml"):
            self.run_program("export", result, "--format", form)
        made = set(self.folder.iterdir()) - before
        self.assertEqual({file.suffix for file in made}, {".csv", ".svg", ".dxf", ".toml"})
        for file in made:
            if file.suffix == ".toml":
                self.run_program("analyze", file, "--quiet")

    def test_a_study_takes_the_transmission_of_each_joint(self):
        base = LIBRARY / "chain" / "timed-arc.toml"
        self.run_program("solve", base, "--quiet")
        result = json.loads((self.folder / "timed-arc.result.json").read_text())
        metrics = result["designs"][0]["metrics"]
        names = [name for name in metrics if name.startswith("transmission_") and name.endswith("_min_deg")]
        self.assertGreater(len(names), 1)
        self.assertAlmostEqual(min(metrics[name] for name in names),
                               metrics["transmission_angle_deg"]["acute_min"], 9)
        study = self.folder / "joints.toml"
        study.write_text(f"base = {json.dumps(str(base))}\n[[vary]]\n"
                         f'key = "constraints.transmission_angle_deg[0]"\nvalues = [35]\n'
                         f"[output]\nmetrics = {json.dumps(names)}\n")
        self.run_program("sweep", study, "--quiet")
        with contextlib.closing(sqlite3.connect(self.folder / "joints.study.db")) as database:
            columns = ", ".join(f'"{name}"' for name in names)
            (row,) = database.execute(f"SELECT {columns} FROM runs").fetchall()
        for value in row:  # the limit holds for every joint
            self.assertGreaterEqual(value, 35 - 1e-6)
            self.assertLessEqual(value, 90)
        study.write_text(study.read_text().replace(names[0], "transmission_Q_min_deg"))
        refused = subprocess.run([PROGRAM, "sweep", study], capture_output=True, text=True, timeout=60)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("transmission_Q_min_deg", refused.stderr)


if __name__ == "__main__":
    if sys.argv[1] == "--points":
        rows = planted_points(sys.argv[2])
        print(",\n".join("          " + ", ".join(map(str, rows[i:i + 3]))
                         for i in range(0, len(rows), 3)))
    else:
        PROGRAM, LIBRARY = sys.argv[1], pathlib.Path(sys.argv[2])
        unittest.main(argv=sys.argv[:1])
