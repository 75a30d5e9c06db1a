"""Mechanisms that a test draws by their joints, and what the program makes of them."""

import csv
import math
import pathlib
import random
import subprocess
import tempfile
import unittest

from linked_bodies import Bodies, is_determined
from written_files import PROGRAM, command

STEPS = 120
FORMS = ("RRR", "RRP", "PRR", "RPR", "PRP", "RPP", "PPR")


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


def pinned(name, at, *of):
    return {"name": name, "at": at, "of": of}


def slid(name, degrees, *of):
    return {"name": name, "direction_deg": degrees, "of": of}


class DrawnTestCase(unittest.TestCase):
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
