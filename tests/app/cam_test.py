"""The table of a cam over its turn, against closed forms and the geometry of roller and profile.

Run as: cam_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()

CAM = """
kind = "cam"
[follower]
type = "translating-roller"
mass = 2
spring_rate = 500
preload = 40
[[motion]]
law = "cycloidal"
over_deg = 120
rise = 0.03
[[motion]]
law = "dwell"
over_deg = 60
[[motion]]
law = "harmonic"
over_deg = 180
rise = -0.03
[mechanism]
base_radius = 0.06
offset = 0.01
roller_radius = 0.015
{more}
[drive]
speed_rpm = 120
"""

SPEED = 4 * math.pi


def motion(angle):
    """Displacement and its derivatives by the cam angle, from the laws' definitions."""
    rise, over = 0.03, math.radians(120)
    if angle < over:
        u, w = angle / over, 2 * math.pi
        return (rise * (u - math.sin(w * u) / w), rise / over * (1 - math.cos(w * u)),
                rise / over**2 * w * math.sin(w * u))
    if angle < math.pi:
        return (rise, 0, 0)
    u = angle - math.pi
    return (rise / 2 * (1 + math.cos(u)), -rise / 2 * math.sin(u), -rise / 2 * math.cos(u))


class CamTable(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def table(self, text, *options, status=0):
        (self.at / "cam.toml").write_text(text)
        ran = subprocess.run([PROGRAM, "solve", "cam.toml", "--quiet", *options], cwd=self.at,
                             capture_output=True, text=True, timeout=60)
        self.assertEqual(ran.returncode, status, ran.stderr)
        if status == 2:
            return ran.stderr
        with open(self.at / "cam.csv", newline="") as file:
            return [{key: float(cell) for key, cell in row.items() if cell}
                    for row in csv.DictReader(file)]

    def test_rows_follow_the_laws(self):
        rows = self.table(CAM.format(more=""))
        self.assertEqual([row["cam_deg"] for row in rows], list(range(361)))
        for row in rows:
            s, v, a = motion(math.radians(row["cam_deg"] % 360))
            self.assertAlmostEqual(row["displacement"], s, delta=1e-15)
            self.assertAlmostEqual(row["velocity_per_rad"], v, delta=1e-15)
            if row["cam_deg"] != 360:
                self.assertAlmostEqual(row["acceleration_per_rad2"], a, delta=1e-15)
            self.assertAlmostEqual(row["velocity_per_s"], SPEED * v, delta=1e-14)
            self.assertAlmostEqual(row["acceleration_per_s2"],
                                   SPEED**2 * row["acceleration_per_rad2"], delta=1e-13)

    def test_the_roller_touches_the_profile(self):
        """At each row the roller's centre is where the follower has it, the contact a radius off,
        square to the profile; force and torque agree with virtual work."""
        for more, sense in (("", 1), ('rotation = "cw"', -1)):
            rows = self.table(CAM.format(more=more), "--steps", "1440")
            self.assertEqual(len(rows), 1441)
            start = math.sqrt(0.06**2 - 0.01**2)
            for before, row, after in zip(rows, rows[1:], rows[2:]):
                angle = math.radians(row["cam_deg"])
                s, v, a = motion(angle)
                # The follower in the frame, the cam turned back by its angle.
                x, y = 0.01, start + s
                centre = (sense * (x * math.cos(angle) + y * math.sin(angle)),
                          y * math.cos(angle) - x * math.sin(angle))
                self.assertLess(math.dist(centre, (row["centre_x"], row["centre_y"])), 1e-15)
                contact = (row["profile_x"], row["profile_y"])
                self.assertAlmostEqual(math.dist(centre, contact), 0.015, delta=1e-15)
                chord = (after["profile_x"] - before["profile_x"],
                         after["profile_y"] - before["profile_y"])
                normal = (centre[0] - contact[0], centre[1] - contact[1])
                along = chord[0] * normal[0] + chord[1] * normal[1]
                self.assertLess(abs(along), 1e-3 * math.hypot(*chord) * math.hypot(*normal))
                push = 2 * SPEED**2 * a + 500 * s + 40
                self.assertAlmostEqual(row["torque_N_m"], push * v, delta=1e-13)
                self.assertAlmostEqual(
                    row["contact_force_N"] * math.cos(math.radians(row["pressure_angle_deg"])), push,
                    delta=1e-11)

    def test_the_greatest_rows_are_the_metrics(self):
        rows = self.table(CAM.format(more=""), "--steps", "7200")
        metrics = json.loads((self.at / "cam.result.json").read_text())["designs"][0]["metrics"]
        greatest = max(abs(row["pressure_angle_deg"]) for row in rows)
        reported = max(abs(metrics[key]) for key in ("pressure_angle_deg_max_rise",
                                                 "pressure_angle_deg_max_return"))
        self.assertLessEqual(greatest, reported * (1 + 1e-12))
        self.assertGreater(greatest, reported * (1 - 1e-6))
        least = min(row["curvature_radius"] for row in rows if row.get("curvature_radius", -1) > 0)
        self.assertAlmostEqual(least, metrics["curvature_radius_min"], delta=1e-6)
        # At rest at displacement 0 the normal leads to the cam's centre.
        for curve, circle in (("centre", "prime_radius"), ("profile", "base_radius")):
            radius = math.hypot(rows[0][curve + "_x"], rows[0][curve + "_y"])
            self.assertAlmostEqual(radius, metrics[circle], delta=1e-15)
        self.assertEqual(metrics["prime_radius"], 0.06)

    def test_both_walls_of_a_groove_keep_to_the_limit(self):
        """A load that presses the outer wall counts as one that presses the inner does."""
        text = """
kind = "cam"
[follower]
type = "translating-roller"
closure = "groove"
load = {load}
[[motion]]
law = "cycloidal"
over_deg = 180
rise = 20
[[motion]]
law = "cycloidal"
over_deg = 180
rise = -20
[mechanism]
base_radius = 50
offset = 0
roller_radius = 8
[constraints]
pressure_angle_deg_max = 60
contact_force_max = {limit}
[drive]
speed = 1
"""
        for load in (-1000, 1000):
            self.table(text.format(load=load, limit=500), status=1)
            self.table(text.format(load=load, limit=1500))
            design = json.loads((self.at / "cam.result.json").read_text())["designs"][0]
            self.assertGreater(design["metrics"]["contact_force_max"], 1000)

    def test_a_straight_profile_has_no_radius(self):
        rows = self.table((LIBRARY / "cam" / "pressure-angle.toml").read_text())
        self.assertNotIn("curvature_radius", rows[0])
        self.assertTrue(all(abs(row.get("curvature_radius", 0)) < 1e12 for row in rows))

    def test_laws_have_the_factors_and_names_of_the_guideline(self):
        """C_v, C_a, C_j of VDI 2143 in closed form."""
        pi = math.pi
        closed = {"Gerade": (1, 0, 0), "quadratische Parabel": (2, 4, None),
                  "einfache Sinuslinie": (pi / 2, pi**2 / 2, pi**3 / 2),
                  "geneigte Sinuslinie (Bestehorn)": (2, 2 * pi, 4 * pi**2),
                  "Polynom 5. Grades": (15 / 8, 10 / math.sqrt(3), 60),
                  "modifizierte Sinuslinie": (4 * pi / (4 + pi), 4 * pi**2 / (4 + pi), 16 * pi**3 / (4 + pi)),
                  "modifiziertes Beschleunigungstrapez": (2, 8 * pi / (2 + pi), 32 * pi**2 / (2 + pi))}
        listed = json.loads(subprocess.run([PROGRAM, "list", "cam", "--json"], capture_output=True, check=True).stdout)
        laws = {law["vdi_2143"]: law["peak_factors"] for law in listed["motion_laws"] if "vdi_2143" in law}
        self.assertEqual(laws.pop("Rast"), None)
        self.assertEqual(laws.keys(), closed.keys())
        for name, wanted in closed.items():
            for factor, value in zip(("velocity", "acceleration", "jerk"), wanted):
                with self.subTest(name, factor=factor):
                    found = laws[name][factor]
                    if value is None:
                        self.assertIsNone(found)
                    else:
                        self.assertAlmostEqual(found, value, delta=1e-9 * max(1, value))
        text = subprocess.run([PROGRAM, "list"], capture_output=True, text=True, check=True).stdout
        for dyad, name in (("RRR", "DDD"), ("RRP", "DDS"), ("RPR", "DSD"), ("PRP", "SDS"), ("RPP", "DSS")):
            self.assertRegex(text, rf"{dyad}: .*{name}\)")
        self.assertRegex(text, r"velocity C_v +acceleration C_a +jerk C_j +VDI 2143")

    def test_steps_are_for_cams(self):
        text = (LIBRARY / "quick-return" / "guide-bar.toml").read_text()
        self.assertIn("--steps: divides the turn of a cam",
                      self.table(text, "--steps", "10", status=2))

    def test_steps_are_checked(self):
        for steps in ("0", "-3", "2.5", "many", "100001", ""):
            self.assertIn("--steps", self.table(CAM.format(more=""), "--steps", steps, status=2))


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    LIBRARY = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
