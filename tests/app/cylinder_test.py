"""Chains driven by a cylinder, from outside: the worked files against closures, differences and an energy
balance of their own; faults of [cylinder].

Run as: cylinder_test.py PROGRAM LIBRARY SCHEMA.
"""

import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

from sampled_layers import SampledLayers

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

GRAVITY = 9.80665
G, A, D = (-2.1, 0.45), (-0.45, 0.05), (0.0, 0.0)

DUMP = """
kind = "analysis"
[mechanism]
type = "chain"
pivot = [{name = "A", at = [0, 0]}, {name = "G", at = [%s, 0]}]
[mechanism.cylinder]
at = "G"
about = "A"
pin = "P"
length = %s
[drive]
start = %s
end = %s
"""


def meet(p, of_p, q, of_q, side):
    """Where circles about p and q meet, to the left of the way from p to q where side is 1."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    d = math.hypot(dx, dy)
    along = (d * d + of_p * of_p - of_q * of_q) / (2 * d)
    across = side * math.sqrt(of_p * of_p - along * along)
    return (p[0] + (along * dx - across * dy) / d, p[1] + (along * dy + across * dx) / d)


def unit(p, q):
    d = math.dist(p, q)
    return ((q[0] - p[0]) / d, (q[1] - p[1]) / d)


def on(origin, along, u, v):
    return (origin[0] + u * along[0] - v * along[1], origin[1] + u * along[1] + v * along[0])


def slope(f, x, step=2e-3):
    """df/dx by central differences of the eighth order."""
    weights = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
    return sum(w * (f(x + k * step) - f(x - k * step)) for k, w in enumerate(weights, 1)) / step


class Bucket:
    """Bodies of the worked file as functions of the cylinder's length."""

    def places(self, length):
        pin = meet(G, length, A, 0.55, 1)
        top = meet(pin, 0.6, D, 0.42, 1)
        return pin, top

    def teeth(self, length):
        return on(D, unit(D, self.places(length)[1]), -0.75, -0.65)

    def bodies(self, length):
        """Mass, inertia, centre of mass, direction of each heavy body."""
        pin, top = self.places(length)
        along, bucket = unit(G, pin), unit(D, top)
        return [(55, 6, on(G, along, 0.5, 0), along), (25, 2, on(pin, along, -0.4, 0), along), (420, 60, on(D, bucket, -0.35, -0.25), bucket)]

    def inertia(self, length):
        """Twice the kinetic energy at a speed of one."""
        total = 0.0
        for i, (mass, moment, _, _) in enumerate(self.bodies(length)):
            x, y = (slope(lambda at, i=i, k=k: self.bodies(at)[i][2][k], length) for k in (0, 1))
            turn = slope(lambda at, i=i: math.atan2(*reversed(self.bodies(at)[i][3])), length)
            total += mass * (x * x + y * y) + moment * turn * turn
        return total

    def force(self, length, speed):
        """Of the oil, by the balance of energy: dT/dL + dU/dL - load."""
        kinetic = 0.5 * speed ** 2 * slope(self.inertia, length)
        potential = slope(lambda at: sum(m * GRAVITY * c[1] for m, _, c, _ in self.bodies(at)), length)
        load = slope(lambda at: 9000 * self.teeth(at)[0] + 6000 * self.teeth(at)[1], length)
        return kinetic + potential - load


class CylinderDrive(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, check=False)

    def write(self, text):
        file = self.folder / "written.toml"
        file.write_text(text)
        return file

    def analyze(self, file, status=0):
        done = self.run_program("analyze", file, "--json")
        self.assertEqual((done.returncode, done.stderr), (status, ""))
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        return document

    def rows(self, file):
        done = self.run_program("analyze", file, "--out", self.folder, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (self.folder / f"{pathlib.Path(file).stem}.csv").read_text()
        table = list(csv.reader(io.StringIO(text)))
        return [dict(zip(table[0], row)) for row in table[1:]]

    def test_the_bucket_moves_and_is_forced_as_its_circles_say(self):
        file, bucket, speed = LIBRARY / "analysis" / "excavator-bucket.toml", Bucket(), 0.25
        rows = self.rows(file)
        self.assertEqual(len(rows), 361)
        for row in rows[12:-12:16]:
            length = float(row["slide_m"])
            pin, teeth = bucket.places(length)[0], bucket.teeth(length)
            self.assertAlmostEqual(float(row["P_x_m"]), pin[0], delta=1e-9)
            self.assertAlmostEqual(float(row["T_y_m"]), teeth[1], delta=1e-9)
            there = slope(lambda at: bucket.teeth(at)[0], length) * speed
            self.assertAlmostEqual(float(row["T_vx_m_per_s"]), there, delta=1e-7 * (1 + abs(there)))
            force = bucket.force(length, speed)
            self.assertAlmostEqual(float(row["drive_force_N"]), force, delta=1e-6 * (1 + abs(force)))

    def test_results_are_read_again(self):
        for name in ("excavator-bucket", "dump-body"):
            document = self.analyze(LIBRARY / "analysis" / f"{name}.toml")
            self.assertIn("cylinder", document["problem"]["mechanism"])
            self.assertLess(document["designs"][0]["metrics"]["power_residual"], 1e-10)
            done = self.run_program("analyze", LIBRARY / "analysis" / f"{name}.toml", "--out", self.folder, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            again = self.run_program("export", self.folder / f"{name}.result.json", "--format", "toml", "--out", self.folder)
            self.assertEqual(again.returncode, 0, again.stderr)
            drawn = self.run_program("export", self.folder / f"{name}.result.json", "--format", "svg", "--out", self.folder)
            self.assertEqual(drawn.returncode, 0, drawn.stderr)

    def test_the_motion_ends_where_the_triangle_is_flat(self):
        document = self.analyze(self.write(DUMP % (2, 0.7, 1, 3)))
        self.assertTrue(any("dyad P does not close" in note for note in document["notes"]), document["notes"])
        landmarks = document["analysis"]["landmarks"]
        self.assertEqual([round(place["slide"], 12) for place in landmarks if place["kind"] == "dead point"], [1.3, 2.7])

    def refusal(self, text):
        done = self.run_program("check", self.write(text))
        self.assertEqual(done.returncode, 2)
        return done.stdout + done.stderr

    def test_faults(self):
        sound = DUMP % (2, 0.7, 1.5, 2.5)
        cases = [(sound.replace('about = "A"', 'about = "G"'), "about", "pivots apart"),
                 (sound.replace('at = "G"\n', 'at = "H"\n'), "cylinder.at", "no point"),
                 (sound.replace("length = 0.7\n", ""), "cylinder.length", "is missing"),
                 (sound.replace('pin = "P"', 'pin = "A"'), "A", ""),
                 (sound.replace("start = 1.5", "start = -1"), "drive.start", "above 0"),
                 (sound.replace("start = 1.5\n", ""), "drive.start", "is missing"),
                 (sound.replace("length = 0.7", 'length = 0.7\nnames = ["a"]'), "names", "3"),
                 (sound + '[crank]\nat = "A"\npin = "Q"\nlength = 1\n', "beside", "one drive"),
                 (sound.replace('"analysis"', '"machine"').partition("[drive]")[0], "mechanism.type", "cylinder drives")]
        for text, key, words in cases:
            with self.subTest(key=key, words=words):
                said = self.refusal(text)
                self.assertIn(key, said)
                self.assertIn(words, said)

    def with_layers(self, name, width, more=""):
        text = (LIBRARY / "analysis" / f"{name}.toml").read_text()
        return self.write(text + f"\n[layers]\nlink_width = {width}\npin_diameter = {width / 2}\nclearance = 0.005\n"
                                 f"thickness = 0.03\n{more}")

    def test_a_cylinder_with_its_rod_has_a_layer(self):
        counts = []
        for name, lengths in (("excavator-bucket", (1.25, 2.05)), ("dump-body", (1.45, 3.1))):
            for width, own in ((0.05, 0.05), (0.12, 0.3)):
                with self.subTest(name, width=width):
                    document = self.analyze(self.with_layers(name, width, f"widths = {{cylinder = {own}}}\n"))
                    layers = document["designs"][0]["layers"]
                    layer_of = {link["name"]: link["layer"] for link in layers["links"]}
                    self.assertNotIn("rod", layer_of)
                    samples = SampledLayers(document["problem"]["mechanism"], document["problem"]["layers"], 720, lengths)
                    self.assertEqual(set(layer_of), set(samples.links))
                    self.assertEqual(samples.fewest(1e-4), layers["count"])
                    if layers["count"]:
                        self.assertGreater(samples.least_room(layer_of), -1e-9)
                    counts.append(layers["count"])
        self.assertEqual(counts, [3, 3, 2, 2])
        self.assertIn("rod", self.refusal(self.with_layers("dump-body", 0.1, "widths = {rod = 0.05}\n").read_text()))

    def test_a_cylinder_is_bought(self):
        for name, lengths, links in (("excavator-bucket", (1.25, 2.05), {"rocker", "link", "bucket"}),
                                     ("dump-body", (1.45, 3.1), {"body"})):
            file = self.with_layers(name, 0.05)
            problem = self.analyze(file)["problem"]
            done = self.run_program("analyze", file, "--out", self.folder, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            made = self.folder / name
            done = self.run_program("export", self.folder / "written.result.json", "--format", "json", "--parts", "--bill",
                                    "--out", made)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("cylinder with rod is bought", done.stdout + done.stderr)
            document = json.loads((made / "written.parts.json").read_text())
            self.assertEqual({part["name"] for part in document["parts"]}, links | {"frame"})
            (cylinder,) = [row for row in document["bill"] if row["item"] == "cylinder"]
            self.assertAlmostEqual(cylinder["length"], lengths[0], 12)
            self.assertAlmostEqual(cylinder["stroke"], lengths[1] - lengths[0], 12)
            rows = list(csv.DictReader(io.StringIO((made / "written.bill.csv").read_text())))
            (row,) = [row for row in rows if row["item"] == "cylinder"]
            self.assertEqual(row["name"], "cylinder")
            self.assertAlmostEqual(float(row["stroke_m"]), cylinder["stroke"], 9)
            # Both eyes are on pins; with the frame as layer 1 nothing collides.
            self.assertEqual({pin["name"] for pin in document["pins"] if "cylinder" in pin["parts"]}, {"G", "P"})
            layer_of = {part["name"]: part["plane"] - 1 for part in document["parts"]} | {"cylinder": cylinder["layers"][0] - 1}
            samples = SampledLayers(problem["mechanism"], problem["layers"], 720, lengths)
            self.assertGreater(samples.least_room(layer_of), -1e-9)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    LIBRARY, SCHEMA = (pathlib.Path(path).resolve() for path in sys.argv[2:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
