"""Gear trains between motor and drive, from outside: files that a machine names, results, studies, and
an integration of its own of the motor's equation of motion.

Run as: machine_train_test.py PROGRAM LIBRARY SCHEMA.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

MACHINE = """
kind = "machine"
[equivalent]
inertia = 3
torque = "-2*w"
[motor]
line = {stall_torque = 10, no_load_speed = 50}
train = "%s"
"""

PAIR = """
kind = "gear-train"
[[mesh]]
gears = ["a", "b"]
teeth = [20, 60]
[[mesh]]
gears = ["b", "c"]
teeth = [20, 40]
efficiency = 0.9
[[input]]
member = "a"
[output]
member = "c"
"""


class Press:
    """The library's press with a planetary gear, in coordinates of its motor: dω/dθ = ω'/ω, by the
    classical Runge-Kutta method between the angles at which the load begins and ends."""

    ratio = 1 + 84 / 24
    meshes = 0.985 * 0.99
    forward = (1 + 84 / 24 * meshes) / ratio
    backward = ratio / (1 + 84 / 24 / meshes)
    crank, coupler, centre, gravity = 0.1, 0.45, 0.2, 9.80665
    stall, no_load, rotor = 595, 157.08, 0.03

    def __init__(self):
        planet = 1 - 84 / 30
        at_carrier = 0.03 + 3 * (0.0004 * planet ** 2 + 0.35 * 0.054 ** 2)
        self.constant = self.rotor + 0.002 + (4 + 0.3 + at_carrier) / self.ratio ** 2

    def places(self, phi):
        """The slider's x, the coupler's centre and angle."""
        sine = -self.crank * math.sin(phi) / self.coupler
        cosine = math.sqrt(1 - sine * sine)
        pin = (self.crank * math.cos(phi), self.crank * math.sin(phi))
        return (pin[0] + self.coupler * cosine, pin[0] + self.centre * cosine, pin[1] + self.centre * sine, math.asin(sine))

    def rates(self, phi):
        """First derivatives of these by phi, by differences of the sixth order."""
        step, weights = 1e-3, {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
        sums = [0.0] * 4
        for k, weight in weights.items():
            ahead, behind = self.places(phi + k * step), self.places(phi - k * step)
            sums = [s + weight * (a - b) / step for s, a, b in zip(sums, ahead, behind)]
        return sums

    def mechanism_inertia(self, phi):
        slider, x, y, angle = self.rates(phi)
        return 20 * slider ** 2 + 6 * (x * x + y * y) + 0.12 * angle ** 2

    def slope(self, theta, omega, load):
        """dω/dθ of the motor, `load` on the slider; theta and omega are the motor's."""
        phi = theta / self.ratio
        slider, x, _, _ = self.rates(phi)
        step = 1e-4
        change = (self.mechanism_inertia(phi + step) - self.mechanism_inertia(phi - step)) / (2 * step)
        inertia = self.constant + self.mechanism_inertia(phi) / self.ratio ** 2
        motor = self.stall * (1 - omega / self.no_load)
        motor = motor * self.forward if motor > 0 else motor / self.backward
        outer = (load * slider + self.gravity * (20 * slider + 6 * x)) / self.ratio
        return (motor + outer - 0.5 * omega ** 2 * change / self.ratio ** 3) / (inertia * omega)

    def turn(self, omega):
        """The speed after a turn of the crank from phi = 0, the extremes meanwhile."""
        # Advance is from phi = pi on; the load acts from 0.4 of the stroke, x = 0.35 + 0.08.
        x = self.coupler - self.crank + 0.4 * 2 * self.crank
        begin = math.acos((self.crank ** 2 + x * x - self.coupler ** 2) / (2 * self.crank * x))
        speeds = [omega]
        for start, end, load in ((0, math.pi, 0), (math.pi, 2 * math.pi - begin, 0), (2 * math.pi - begin, 2 * math.pi, -4000)):
            steps = 400
            h = (end - start) / steps * self.ratio
            for k in range(steps):
                theta = start * self.ratio + k * h
                a = self.slope(theta, omega, load)
                b = self.slope(theta + h / 2, omega + h / 2 * a, load)
                c = self.slope(theta + h / 2, omega + h / 2 * b, load)
                d = self.slope(theta + h, omega + h * c, load)
                omega += h / 6 * (a + 2 * b + 2 * c + d)
                speeds.append(omega)
        return omega, min(speeds), max(speeds)


class MachineTrain(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text, name="written.toml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, check=False)

    def analyze(self, file):
        done = self.run_program("analyze", file, "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = json.loads(done.stdout)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        return document

    def test_runs_as_its_motor_s_equation_of_motion_says(self):
        press = Press()
        omega = 150.0
        for _ in range(40):
            before = omega
            omega, least, greatest = press.turn(omega)
            if abs(omega - before) < 1e-12 * omega:
                break
        metrics = self.analyze(LIBRARY / "machine" / "planetary-press.toml")["designs"][0]["metrics"]
        self.assertAlmostEqual(metrics["speed_max_rad_s"], greatest / press.ratio, delta=3e-5)
        self.assertAlmostEqual(metrics["speed_min_rad_s"], least / press.ratio, delta=3e-5)
        self.assertAlmostEqual(metrics["train_efficiency"], press.forward, delta=1e-12)
        self.assertAlmostEqual(metrics["train_reverse_efficiency"], press.backward, delta=1e-12)
        self.assertEqual(metrics["train_ratio_exact"], "9/2")

    def test_a_result_holds_the_train_itself(self):
        self.write(PAIR, "pair.toml")
        document = self.analyze(self.write(MACHINE % "pair.toml"))
        train = document["problem"]["motor"]["train"]
        self.assertEqual([mesh["teeth"] for mesh in train["mesh"]], [[20, 60], [20, 40]])
        # 6 * 0.9 * 10 * (1 - 6 w/50) = 2 w
        self.assertAlmostEqual(document["designs"][0]["metrics"]["speed_mean_rad_s"], 54 / (2 + 54 * 6 / 50), delta=1e-9)

    def test_shafts_and_states_are_chosen(self):
        simpson = LIBRARY / "gear-train" / "simpson.toml"
        ratios = {}
        for state in ("1", "2", "3"):
            text = MACHINE % simpson + f'state = "{state}"\n'
            ratios[state] = self.analyze(self.write(text))["designs"][0]["metrics"]["train_ratio"]
        self.assertEqual({state: round(ratio, 3) for state, ratio in ratios.items()}, {"1": 2.452, "2": 1.452, "3": 1})
        self.write(PAIR, "pair.toml")
        turned = self.analyze(self.write(MACHINE % "pair.toml" + 'input = "c"\noutput = "a"\n'))
        self.assertEqual(turned["designs"][0]["metrics"]["train_ratio_exact"], "1/6")

    def refusal(self, text):
        done = self.run_program("check", self.write(text))
        self.assertEqual(done.returncode, 2)
        return done.stdout + done.stderr

    def test_a_file_that_is_no_train_is_refused(self):
        os.mkfifo(self.folder / "pipe.toml")
        (self.folder / "folder.toml").mkdir()
        (self.folder / "damaged.toml").write_bytes(b"kind = \"gear-train\"\n\x00\xff")
        (self.folder / "long.toml").write_text("# " + "x" * (8 << 20))
        self.write(PAIR.replace("20, 60", "20, 2"), "faulty.toml")
        self.write("kind = 3\n", "number.toml")
        self.write("", "empty.toml")
        search = 'kind = "gear-train"\n[target]\nratio = 3\n'
        self.write(search, "search.toml")
        cases = {"pipe.toml": "pipe, a device or a socket", "folder.toml": "directory", "missing.toml": "does not exist",
                 "damaged.toml": "fault of its own, at 2:1", "long.toml": "larger than 8 MiB", "written.toml": 'kind is "machine"',
                 "faulty.toml": "at 5:14: entry 2 of mesh[1].teeth", "number.toml": "kind", "empty.toml": "kind is missing",
                 "search.toml": "[target]", "": "the name is empty"}
        for name, words in cases.items():
            with self.subTest(name):
                said = self.refusal(MACHINE % name)
                self.assertIn("motor.train", said)
                self.assertIn(words, said)
                self.assertIn(f'"{name}"', said)

    def test_shafts_that_it_does_not_have_are_refused(self):
        self.write(PAIR, "pair.toml")
        simpson = LIBRARY / "gear-train" / "simpson.toml"
        cases = [(MACHINE % "pair.toml" + 'input = "aa"\n', "motor.input", "allowed are"),
                 (MACHINE % "pair.toml" + 'output = "a"\n', "motor.output", "the input too"),
                 (MACHINE % "pair.toml" + 'state = "1"\n', "motor.state", "no [[state]]"),
                 (MACHINE % "pair.toml" + "ratio = 6\n", "motor.ratio", "beside motor.train"),
                 (MACHINE % "pair.toml" + "efficiency = 1\n", "motor.efficiency", "beside motor.train"),
                 (MACHINE % simpson, "motor.state", "is missing"),
                 (MACHINE % simpson + 'state = "9"\n', "motor.state", "allowed are"),
                 (MACHINE.replace('train = "%s"', "reversed = true"), "motor.reversed", "without motor.train"),
                 (MACHINE.replace('"%s"', "3"), "motor.train", "neither a text nor a table")]
        for text, key, words in cases:
            with self.subTest(key=key, words=words):
                said = self.refusal(text)
                self.assertIn(key, said)
                self.assertIn(words, said)

    def test_a_study_varies_a_train_in_the_file_of_its_machine(self):
        self.write(PAIR, "pair.toml")
        study = '[[vary]]\nkey = "%s"\nvalues = [3, 6]\n[output]\nmetrics = ["train_ratio"]\n[objective]\nminimize = "train_ratio"\n'
        self.write(MACHINE % "pair.toml", "named.toml")
        done = self.run_program("check", self.write('base = "named.toml"\n' + study % "equivalent.inertia"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("motor.train is a file", done.stdout + done.stderr)
        inline = (MACHINE.replace('train = "%s"', "reversed = true") + "[motor.train]\n"
                  + 'input = [{member = "a"}]\noutput = {member = "b"}\nmesh = [{gears = ["a", "b"], teeth = [5, 60]}]\n')
        self.write(inline, "inline.toml")
        self.write('base = "inline.toml"\n' + study % "motor.train.mesh[0].teeth[0]")
        done = self.run_program("sweep", self.folder / "written.toml", "--out", self.folder, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        best = json.loads(done.stdout)["best"][0]
        self.assertEqual((best["motor.train.mesh[0].teeth[0]"], best["train_ratio"]), (3, -20))


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    LIBRARY, SCHEMA = (pathlib.Path(path).resolve() for path in sys.argv[2:4])
    unittest.main(argv=sys.argv[:1], verbosity=2)
