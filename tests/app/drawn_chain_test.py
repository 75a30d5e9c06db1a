"""Chains that are given by their joints as drawn, against bodies under constraints that know nothing of dyads
(linked_bodies.py): planted mechanisms of random dyads, their joints and links in any order; what is refused.

Run as: drawn_chain_test.py PROGRAM LIBRARY SCHEMA.
"""

import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from drawn_mechanisms import DrawnTestCase, drawn, pinned, slid, table  # noqa: E402
from linked_bodies import is_determined  # noqa: E402
from thinned import some, WHOLE  # noqa: E402
from written_files import PROGRAM, command  # noqa: E402

try:
    import jsonschema
except ImportError:
    jsonschema = None

LIBRARY, SCHEMA = (pathlib.Path(path) for path in sys.argv[2:4])


class DrawnChains(DrawnTestCase):
    def test_planted_mechanisms_move_as_their_constraints_say(self):
        compared = [self.follow(seed) for seed in some(range(40))]
        self.assertGreater(sum(compared), len(compared) * 10, compared)

    def test_any_joints_are_a_mechanism_where_their_constraints_are_independent(self):
        said = [self.judged(soup(seed)) for seed in some(range(250))]
        self.assertGreater(said.count("taken"), len(said) / 25)
        for reason in REASONS[:-1] if WHOLE else ():
            self.assertGreater(said.count(reason), 0, reason)

    def judged(self, joints):
        """What the program says of joints, where it may: it takes them if and only if all bodies but the driven
        one are held by independent constraints, unless they are a truss."""
        done = command(drawn(joints, "drive"), "check")
        if done.returncode == 0:
            self.assertTrue(is_determined(joints), joints)
            return "taken"
        self.assertEqual(done.returncode, 2, (done.stderr, joints))
        reasons = [reason for reason in REASONS if reason in done.stderr]
        self.assertTrue(reasons, done.stderr)
        if reasons[0] == "no joint with the frame":
            return reasons[0]
        if reasons[0] == "both joined":  # a truss on a link: it moves with that
            return reasons[0]
        self.assertFalse(is_determined(joints), (done.stderr, joints))
        return reasons[0]

    def test_a_drawing_is_the_chain_of_its_dimensions(self):
        by_joints = drawn(FOUR_BAR, "crank", LOADED + "[drive]\nstart_deg = 0\n")
        by_lengths = """kind = "analysis"
[mechanism]
type = "chain"
pivot = [{name = "A", at = [0, 0]}, {name = "D", at = [4, 0]}]
crank = {at = "A", pin = "B", length = 1}
dyad = [{type = "RRR", joins = ["B", "D"], lengths = [%r, %r], new = "C", names = ["coupler", "rocker"]}]
point = [{name = "P", on = ["B", "C"], at = [%r, %r]}]
""" % (math.dist(B, C), math.dist(D, C), *within(B, C, P)) + LOADED
        for row, same in zip(table(by_joints), table(by_lengths), strict=True):
            self.assertEqual(row.keys(), same.keys())
            for key, value in row.items():
                self.assertAlmostEqual(float(value), float(same[key]), delta=1e-9 * (1 + abs(float(value))), msg=key)

    def test_results_hold_the_mechanism_for_the_program_to_read(self):
        done = command(drawn(FOUR_BAR, "crank"), "analyze", "--json")
        document = json.loads(done.stdout)
        self.assertEqual(document["problem"]["mechanism"]["type"], "chain")
        self.assertAlmostEqual(document["problem"]["drive"]["start_deg"], math.degrees(math.atan2(B[1], B[0])), delta=1e-9)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))

    def test_a_mechanism_of_slides_has_no_pivot(self):
        joints = [slid("S", 90, "frame", "wedge"), pinned("P", (0, 1), "wedge"), slid("T", 30, "wedge", "block"), slid("U", 0, "block2", "frame"), pinned("Q", (2, 1), "block", "block2")]
        rows = table(drawn(joints, "wedge", "[drive]\nend = 1\nsteps = 4\n"))
        self.assertEqual(len(rows), 5)
        for row in rows:  # up by s, the incline stays: along it by -s / tan 30
            self.assertAlmostEqual(float(row["Q_x"]), 2 - float(row["slide"]) * math.sqrt(3), delta=1e-12)
            self.assertAlmostEqual(float(row["Q_y"]), 1, delta=1e-12)

    def test_a_lever_without_a_pin_drives_by_its_slot(self):
        joints = [pinned("A", (0, 0), "frame", "lever"), slid("slot", 30, "lever", "block"), pinned("C", (3, math.sqrt(3)), "block", "bar"),
                  slid("guide", 90, "bar", "frame")]
        rows = table(drawn(joints, "lever", "[drive]\nend_deg = 60\nsteps = 6\n"))
        self.assertEqual(float(rows[0]["crank_deg"]), 30)
        self.assertEqual(command(drawn([{**joint, "name": joint["name"].replace("slot", "lever-end")} for joint in joints], "lever"), "check").returncode, 0)
        for row in rows:
            self.assertAlmostEqual(float(row["C_y"]), 3 * math.tan(math.radians(float(row["crank_deg"]))), delta=1e-12)

    def test_what_is_no_mechanism_is_refused_with_its_reason(self):
        bar, pin, slide = FOUR_BAR, pinned, slid
        on_coupler = [pin("Q", (2, 3), "coupler", "x"), pin("R", (3, 4), "x", "y"), pin("S", (2, 5), "y", "coupler")]
        for reason, joints in (
                ("mobility 3(n - 1) - 2j = 2 with n = 5 links and j = 5 joints; expected 1; join more",
                 [*bar[:3], pin("E", (1, 5), "rocker", "lever"), pin("D", D, "lever", "frame")]),
                ("one joint alone holds \"tail\"", [*bar, pin("T", (9, 9), "rocker", "tail")]),
                ("a joint or a link holds it", [*bar, pin("G", (0, 4), "coupler", "third"), pin("H", (1, 7), "third", "frame")]),
                ("moves the driven link alone", bar[:1]),
                ("both join \"coupler\" and \"rocker\"", [*bar, pin("C2", (2, 2), "coupler", "rocker")]),
                ("nothing joins \"x\", \"y\", \"z\" to the frame",
                 [*bar, pin("X", (8, 0), "x", "y"), pin("Y", (9, 2), "y", "z"), pin("Z", (7, 3), "z", "x")]),
                ("\"A\" and \"B\" of \"crank\" are at the same place", [bar[0], {**bar[1], "at": A}, *bar[2:]]),
                ("are drawn at a dead point", [bar[0], {**bar[1], "at": (1, 0)}, {**bar[2], "at": (2.5, 0)}, bar[3]]),
                ("are at the same place", [*bar[:2], {**bar[2], "at": B}, bar[3]]),
                ("which are both joined to \"coupler\"", [*bar, *on_coupler]),
                ("are slides, all three", [*bar, slide("Q", 10, "coupler", "x"), slide("R", 30, "x", "y"), slide("S", 80, "y", "frame")])):
            with self.subTest(reason):
                self.assertIn(reason, self.faults(drawn(joints, "crank")))

    def test_wrong_tables_are_refused_by_name(self):
        first = FOUR_BAR[0]
        for reason, joints, driven in (
                ("is missing; expected [x, y], or the direction_deg of a slide", [{"name": "A", "of": ["frame", "crank"]}, *FOUR_BAR[1:]], "crank"),
                ("is given for a slide", [{**first, "direction_deg": 3}, *FOUR_BAR[1:]], "crank"),
                ("a slide has two", [*FOUR_BAR, {"name": "S", "direction_deg": 3, "of": ["a", "b", "c"]}], "crank"),
                ("is the frame alone", [*FOUR_BAR, {"name": "Z", "at": (1, 1), "of": ["frame"]}], "crank"),
                ("twice", [*FOUR_BAR, {"name": "Z", "at": (1, 1), "of": ["crank", "crank"]}], "crank"),
                ("the name of another joint", [*FOUR_BAR, first], "crank"),
                ("the name of a link", [*FOUR_BAR, {"name": "rocker", "at": (1, 1), "of": ["crank"]}], "crank"),
                ("expected a link that joints join", FOUR_BAR, "handle"),
                ("which has no joint with the frame", FOUR_BAR, "coupler"),
                ("expected a name of", [{**first, "of": ["frame", "a b"]}, *FOUR_BAR[1:]], "crank")):
            with self.subTest(reason):
                self.assertIn(reason, self.faults(drawn(joints, driven)))
        self.assertIn("is given beside [[joint]]", self.faults(drawn(FOUR_BAR, "crank", '[crank]\nat = "A"')))

    def test_what_follows_from_a_fault_is_no_fault(self):
        joints = [pinned("A", (0, 0), "frame", "a"), pinned("B", (10, 0), "a", "b"), pinned("C", (20, 0), "b", "ram"), slid("S", 90, "ram", "frame")]
        rest = '[[link]]\nbetween = ["A", "B"]\nmass = 1\ncentre = [0, 0]\n[[load]]\non = "C"\nforce = [0, 1]\n[drive]\nend = 1\n'
        said = self.faults(drawn(joints, "ram", rest))
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertIn("are drawn at a dead point", said)

    def test_a_drawing_near_a_dead_point_begins_there(self):
        for sine in (2e-6, 1e-5, 1e-3):
            c = complex(1, 0.5) + 2.5 * complex(math.cos(0.6), math.sin(0.6))
            d = c + 2 * complex(math.cos(0.6 + sine), math.sin(0.6 + sine))
            joints = [pinned("A", (0, 0), "frame", "crank"), pinned("B", (1, 0.5), "crank", "bar"), pinned("C", (c.real, c.imag), "bar", "rocker"),
                      pinned("D", (d.real, d.imag), "rocker", "frame")]
            first = table(drawn(joints, "crank", "[drive]\nsteps = 6\n"))[0]
            self.assertAlmostEqual(float(first["C_y"]), c.imag, delta=1e-8)

    def test_pages_take_metres_where_a_file_without_a_unit_has_forces(self):
        for name, millimetres in (("analysis/pump-jack", "1000.0"), ("analysis/watt-six-bar", "1.0")):
            with tempfile.TemporaryDirectory() as folder:
                page = pathlib.Path(folder) / "page.html"
                subprocess.run([PROGRAM, "sketch", LIBRARY / f"{name}.toml", "--out", page, "--quiet"], check=True, timeout=60)
                self.assertIn(f'"millimetres":{millimetres}', page.read_text(encoding="utf-8"))


REASONS = ("both joined", "both join ", "no joint with the frame", "mobility 3", "has mobility 1", "dead point", "is loose", "same place", "slides, all three")


def soup(seed):
    """Joints of a few links at places of a coarse grid, mostly as many as mobility one takes."""
    chance = random.Random(seed)
    count = chance.choice((3, 3, 5, 5, 4))  # moving links
    links = ["drive", *(f"k{i}" for i in range(1, count))]
    joints = [pinned("J0", (0, 0), "frame", "drive")] if chance.random() < 0.95 else []
    wanted = (3 * count - 1) // 2 + chance.choice((0, 0, 0, 0, 1, -1))
    while len(joints) < wanted:
        fewest = min(links[1:], key=lambda link: (sum(link in joint["of"] for joint in joints), chance.random()))
        of = chance.choice(([fewest, chance.choice(["frame", *(link for link in links if link != fewest)])], chance.sample(["frame", *links], 2)))
        if any({*of} <= {*joint["of"]} for joint in joints) and chance.random() < 0.9:
            continue
        if of[0] in links[1:] or of[1] in links[1:]:
            name = f"J{len(joints)}"
            if chance.random() < 0.2:
                joints.append(slid(name, chance.choice((0, 30, 45, 90, 135)), *of))
            else:
                joints.append(pinned(name, (chance.randint(0, 4), chance.randint(0, 4)), *of))
    return joints + [pinned("P", (7, 5), "drive")]


A, B, C, D, P = (0.0, 0.0), (0.6, 0.8), (3.1, 2.9), (4.0, 0.0), (1.5, 3.0)
FOUR_BAR = [{"name": "A", "at": A, "of": ["frame", "crank"]}, {"name": "B", "at": B, "of": ["crank", "coupler"]},
            {"name": "C", "at": C, "of": ["coupler", "rocker"]}, {"name": "D", "at": D, "of": ["rocker", "frame"]},
            {"name": "P", "at": P, "of": ["coupler"]}]
LOADED = """
[[link]]
between = ["B", "C"]
mass = 2
centre = [1, 0.3]
inertia = 0.4
[[load]]
on = "P"
force = [3, -7]
"""


def within(first, second, at):
    """A place in the axes from one point towards another."""
    along = complex(second[0] - first[0], second[1] - first[1])
    inside = complex(at[0] - first[0], at[1] - first[1]) * along.conjugate() / abs(along)
    return (inside.real, inside.imag)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
