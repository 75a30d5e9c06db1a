"""Chains that are given by their joints as drawn, against bodies under constraints that know nothing of dyads
(linked_bodies.py): planted mechanisms of random dyads, their joints and links in any order; what is refused.

Run as: drawn_chain_test.py PROGRAM LIBRARY SCHEMA.
"""

import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from linked_bodies import Bodies, solve  # noqa: E402
from toml_text import toml_of  # noqa: E402
from written_files import PROGRAM, command  # noqa: E402

try:
    import jsonschema
except ImportError:
    jsonschema = None

LIBRARY, SCHEMA = (pathlib.Path(path) for path in sys.argv[2:4])
FORMS = ("RRR", "RRP", "PRR", "RPR", "PRP", "RPP", "PPR")
STEPS = 120


def toml(value):
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def drawn(joints, driven, rest=""):
    """A file of joints."""
    lines = ['kind = "analysis"', "[mechanism]", 'type = "chain"', f'driven = "{driven}"']
    for joint in joints:
        lines += ["[[mechanism.joint]]", *(f"{key} = {toml(value)}" for key, value in joint.items())]
    return "\n".join([*lines, rest]) + "\n"


def table(text):
    """The rows of an analysis, numbers where there are such."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "drawn.toml"
        file.write_text(text)
        done = subprocess.run([PROGRAM, "analyze", file, "--out", folder, "--quiet"], capture_output=True, text=True, timeout=60,
                              check=False)
        if done.returncode != 0:
            raise AssertionError(done.stderr + text)
        rows = list(csv.reader((pathlib.Path(folder) / "drawn.csv").read_text().splitlines()))
    return [dict(zip(rows[0], row)) for row in rows[1:]]


class Drawer:
    """Draws mechanisms of random dyads."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.joints, self.count = [], 0
        self.slides = self.random.random() < 0.25
        pivot = self.pin(["frame", "drive"]) if not self.slides else self.slide(["frame", "drive"])
        self.links = ["frame", "drive"]
        self.point("drive")
        self.drive = pivot

    def name(self, letter):
        self.count += 1
        return f"{letter}{self.count}"

    def place(self):
        return (round(self.random.uniform(-5, 5), 3), round(self.random.uniform(-5, 5), 3))

    def add(self, joint):
        self.joints.append(joint)
        return joint

    def pin(self, of):
        return self.add({"name": self.name("J"), "at": self.place(), "of": of})

    def point(self, link):
        return self.add({"name": self.name("P"), "at": self.place(), "of": [link]})

    def slide(self, of):
        return self.add({"name": self.name("S"), "direction_deg": round(self.random.uniform(-180, 180), 1), "of": of})

    def outer(self, kind, link, to):
        """Joins a new link to one that is there, now and then at a pin that it has already."""
        if kind == "P":
            return self.slide([link, to])
        pins = [joint for joint in self.joints if "at" in joint and to in joint["of"]]
        if pins and self.random.random() < 0.4:
            joint = self.random.choice(pins)
            joint["of"].append(link)
            return joint
        return self.pin([link, to])

    def dyad(self):
        form = self.random.choice(FORMS)
        first, second = self.name("link"), self.name("link")
        before = [[*joint["of"]] for joint in self.joints]
        while True:
            to = self.random.sample(self.links, 2)
            outer = [self.outer(form[0], first, to[0]), self.outer(form[2], second, to[1])]
            if not set(outer[0]["of"]) & set(outer[1]["of"]) and outer[0] is not outer[1]:
                break
            del self.joints[len(before):]
            for joint, of in zip(self.joints, before):
                joint["of"] = [*of]
        (self.slide if form[1] == "P" else self.pin)([first, second])
        self.links += [first, second]
        for link in (first, second):
            self.point(link)

    def group(self):
        """A link with three joints on three others: no two of the four close before the rest."""
        before = [[*joint["of"]] for joint in self.joints]
        plate, legs = self.name("plate"), [self.name("leg") for _ in range(3)]
        while True:
            for leg in legs:
                kinds = self.random.choice(("RR", "RR", "RR", "PR", "RP"))
                self.outer(kinds[0], leg, self.random.choice(self.links))
                (self.slide if kinds[1] == "P" else self.pin)([leg, plate])
            if is_determined(self.joints, "drive", 1e-3):
                break
            del self.joints[len(before):]
            for joint, of in zip(self.joints, before):
                joint["of"] = [*of]
        self.links += [*legs, plate]
        self.point(plate)

    def draw(self, dyads, group_after=None):
        for i in range(dyads + (group_after is not None)):
            self.group() if i == group_after else self.dyad()
        self.random.shuffle(self.joints)
        for joint in self.joints:
            self.random.shuffle(joint["of"])
        return self.joints


class DrawnChains(unittest.TestCase):
    def faults(self, text):
        done = command(text, "analyze")
        self.assertEqual(done.returncode, 2, done.stdout)
        return done.stderr

    def follow(self, seed, group_after=None):
        """Compares the motion of a planted mechanism from where it is drawn on, until it comes near a dead
        point. How many positions were compared."""
        drawer = Drawer(seed)
        joints = drawer.draw(1 + seed % 4 if group_after is None else seed % 3, group_after)
        span = drawer.random.choice((3.0, -3.0)) if drawer.slides else math.tau
        ends = f"end = {span}\n" if drawer.slides else ""
        rows = table(drawn(joints, "drive", f"[drive]\n{ends}steps = {STEPS}\n"))
        bodies = Bodies(joints, "drive")
        compared = 0
        for i, row in enumerate(rows[:STEPS // 5]):
            if bodies.move(i * span / STEPS) < 1e-5:
                break
            for name, at in bodies.points().items():
                for axis, value in zip("xy", at):
                    column = f"{name}_{axis}"
                    if column not in row:
                        continue  # of the frame
                    self.assertNotEqual(row[column], "", (seed, i, name))
                    self.assertAlmostEqual(float(row[column]), value, delta=1e-7, msg=(seed, i, name))
            compared += 1
        return compared

    def test_planted_mechanisms_move_as_their_constraints_say(self):
        compared = [self.follow(seed) for seed in range(40)]
        self.assertGreater(sum(compared), 40 * 10, compared)

    def test_planted_groups_of_four_links_move_as_their_constraints_say(self):
        compared = [self.follow(seed, min(seed % 2, seed % 3)) for seed in range(100, 116)]
        self.assertGreater(sum(compared), 16 * 8, compared)

    def test_a_group_is_measured_alike_wherever_its_sweep_begins(self):
        """From where it is drawn, and from the middle of the gap in which the crank cannot stand: rows, and the
        swing of the output, which is that of its rows."""
        compared = 0
        for seed in range(200, 220):
            drawer = Drawer(seed)
            if drawer.slides:
                continue
            joints = drawer.draw(0, 0)
            first = table(drawn(joints, "drive", "[drive]\nsteps = 720\n"))
            closed = [row["J1_x"] != "" if "J1_x" in row else any(row[key] for key in row if key.endswith("_x")) for row in first]
            if all(closed) or not closed[-1]:
                continue
            gap = [float(row["crank_deg"]) for row, is_closed in zip(first, closed) if not is_closed]
            if gap[-1] - gap[0] > 0.6 * len(gap):
                continue  # several gaps
            start = (gap[0] + gap[-1]) / 2
            drive = f"[drive]\nstart_deg = {start}\nend_deg = {start + 360}\nsteps = 720\n"
            results = [json.loads(command(drawn(joints, "drive", rest), "analyze", "--json").stdout) for rest in ("", drive)]
            metrics = [result["designs"][0]["metrics"] for result in results]
            for name in ("output_swing_deg", "circuit_swing_deg"):
                self.assertEqual(name in metrics[0], name in metrics[1], (seed, name))
                if name in metrics[0]:
                    self.assertAlmostEqual(metrics[0][name], metrics[1][name], delta=1e-4, msg=(seed, name))
            if "output_swing_deg" in metrics[1]:
                angles = [float(row[f"{metrics[1]['output']}_deg"]) for row in table(drawn(joints, "drive", drive)) if row[f"{metrics[1]['output']}_deg"]]
                self.assertGreater(metrics[0]["output_swing_deg"], max(angles) - min(angles) - 1e-6, seed)
                compared += 1
        self.assertGreater(compared, 2)

    def test_a_sweep_is_reached_from_the_drawing_in_either_turn(self):
        """The drawing stands beyond the end of the sweep, and nearer to its beginning by another turn."""
        pin = pinned
        joints = [pin("A", (0, 0), "frame", "crank"), pin("B", (0.27, -0.53), "crank", "leg1"), pin("P", (0.1, -3.5), "leg1", "plate"),
                  pin("Q", (3.5, -0.5), "leg2", "plate"), pin("R", (-1.4, -3.9), "leg3", "plate"), pin("C", (-0.9, 1.7), "leg2", "frame"),
                  pin("D", (0.9, -0.5), "leg3", "frame")]
        whole = table(drawn(joints, "crank", "[drive]\nsteps = 360\nstart_deg = -63\nend_deg = 297\n"))
        for start in (-700, -300, 100, 500):
            rows = table(drawn(joints, "crank", f"[drive]\nstart_deg = {start}\nend_deg = {start + 100}\nsteps = 100\n"))
            for row in rows:
                same = whole[round(float(row["crank_deg"]) + 63) % 360]
                self.assertAlmostEqual(float(row["Q_x"]), float(same["Q_x"]), delta=1e-9)

    def test_pins_of_one_name_are_one(self):
        group = json.loads(command((LIBRARY / "analysis" / "three-pin-link.toml").read_text(), "analyze", "--json").stdout)["problem"]
        joints = group["mechanism"]["dyad"][0]["joint"]
        for change, reason in (({"name": joints[2]["name"]}, "the name of a point at another place"), ({"name": "A"}, "the name of a"), ({"name": "T"}, "the name of another point")):
            other = json.loads(json.dumps(group))
            other["mechanism"]["dyad"][0]["joint"][1].update(change)
            self.assertIn(reason, self.faults(toml_of(other)))

    def test_any_joints_are_a_mechanism_where_their_constraints_are_independent(self):
        soups = [soup(seed) for seed in range(250)]
        said = [self.judged(joints) for joints in soups]
        self.assertGreater(said.count("taken"), 10)
        for reason in REASONS[:-1]:
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

    def test_a_six_bar_is_driven_in_its_five_bar_loop_too(self):
        """By the link that leaves a group of four, and by the one that leaves dyads: each sees the other move."""
        pin = pinned
        stephenson = [pin("A", (0, 0), "frame", "p"), pin("B", (1, 1.5), "p", "plate"), pin("D", (4, 0), "frame", "q"),
                      pin("C", (3.5, 2), "q", "plate"), pin("E", (2.5, 3), "plate", "r"), pin("F", (5, 4), "r", "s"),
                      pin("G", (6, 1), "s", "frame")]
        by_group = table(drawn(stephenson, "s", "[drive]\nend_deg = 130\nsteps = 1000\n"))
        by_dyads = table(drawn(stephenson, "p", "[drive]\nend_deg = 100\nsteps = 200\n"))
        compared = 0
        for row in by_dyads:
            if row["F_x"] == "":
                continue
            angle = math.degrees(math.atan2(float(row["F_y"]) - 1, float(row["F_x"]) - 6))
            before, after = neighbours(by_group, angle)
            if before is None or not all(other["B_x"] for other in (before, after)):
                continue
            share = (angle - float(before["crank_deg"])) / (float(after["crank_deg"]) - float(before["crank_deg"]))
            for name in ("B_x", "B_y", "C_x", "C_y", "E_x", "E_y"):
                between = (1 - share) * float(before[name]) + share * float(after[name])
                self.assertAlmostEqual(float(row[name]), between, delta=1e-4)
            compared += 1
        self.assertGreater(compared, 50)

    def test_links_that_only_count_as_a_group_are_refused(self):
        pin = pinned
        plate = [pin("P", (2, 3), "leg1", "plate"), pin("Q", (4, 3), "leg2", "plate"), pin("R", (3, 5), "leg3", "plate")]
        legs = [pin("A", (0, 0), "frame", "crank"), pin("B", (1, 1), "crank", "leg1"), pin("C", (5, 0), "frame", "leg2"), pin("D", (0, 6), "frame", "leg3")]
        self.assertEqual(command(drawn(legs + plate, "crank"), "check").returncode, 0)
        # All three legs meet in one point: the plate turns about it with the drive at rest.
        meet = [{**joint, "at": (3 + 2 * (x - 3), 3.5 + 2 * (y - 3.5))} for joint, (x, y) in zip(legs[1:], ((2, 3), (4, 3), (3, 5)))]
        self.assertIn("are drawn at a dead point", self.faults(drawn([legs[0], *meet, *plate], "crank")))
        held = [pin("X", (7, 7), "plate", "bar"), pin("Y", (8, 7), "bar", "frame"), pin("Z", (9, 9), "crank", "rod"), pin("W", (9, 8), "rod", "tail"),
                pin("V", (5, 9), "tail", "tip"), pin("U", (6, 9), "tip", "rod")]
        self.assertIn("is held beside one that is loose", self.faults(drawn(legs + plate + held, "crank")))


REASONS = ("both joined", "both join ", "no joint with the frame", "mobility 3", "has mobility 1", "dead point", "is loose", "same place", "slides, all three")


def neighbours(rows, angle):
    """The rows before and after an angle of the drive; None where there are none."""
    for before, after in zip(rows, rows[1:]):
        low, high = sorted((float(before["crank_deg"]), float(after["crank_deg"])))
        if low <= angle <= high:
            return before, after
    return None, None


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


def is_determined(joints, driven="drive", least=1e-6):
    """Whether the rates of all bodies follow from that of the driven one."""
    if not any({"frame", driven} <= {*joint["of"]} for joint in joints):
        return False
    bodies = Bodies(joints, driven)
    columns = bodies._slopes(bodies.poses)
    if len(columns) != len(columns[0] if columns else []):
        return False
    return solve([list(row) for row in zip(*columns)], [0.0] * len(columns))[1] > least


def pinned(name, at, *of):
    return {"name": name, "at": at, "of": of}


def slid(name, degrees, *of):
    return {"name": name, "direction_deg": degrees, "of": of}


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
