"""The unit of lengths from outside: twins in different units have the same physics.

Run as: length_unit_test.py PROGRAM SCHEMA, the built program and the JSON schema of results.
"""

import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

try:
    import ezdxf
except ImportError:
    ezdxf = None
try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
SCHEMA = pathlib.Path()

METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254}

# Numbers in < > are lengths in m, those in << >> per m, in <<< >>> per m².
BODIES = """
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = <0.1>
coupler = <0.45>
offset = <0.02>
[[link]]
name = "crank"
mass = 2
centre = [<0.03>, <0.001>]
inertia = 0.8
[[link]]
name = "coupler"
mass = 3
centre = [<0.2>, 0]
inertia = 0.05
[[link]]
name = "slider"
mass = 6
[[load]]
on = "slider"
force = [-400, 60]
when = "advance"
[[load]]
on = "coupler"
torque = 7
"""

ANALYSIS = """
kind = "analysis"
gravity = [0, -<9.80665>]
[drive]
speed = 20
acceleration = 3
steps = 36
[output]
reactions = true
torque = true
""" + BODIES

SLIDER = """
kind = "analysis"
gravity = [<1>, -<9.80665>]
[mechanism]
type = "chain"
[[pivot]]
name = "D"
at = [0, <0.1>]
[slider]
pin = "P"
slide = {through = [0, 0], direction_deg = 0}
[[dyad]]
type = "RRR"
joins = ["P", "D"]
lengths = [<0.3>, <0.4>]
new = "C"
names = ["rod", "lever"]
[[link]]
name = "rod"
mass = 2
centre = [<0.1>, 0]
inertia = 0.02
[[load]]
on = "lever"
torque = -5
[drive]
start = <0.2>
end = <0.3>
speed = <0.4>
steps = 20
[output]
reactions = true
torque = true
"""

MACHINE = """
kind = "machine"
gravity = [0, -<9.80665>]
[motor]
line = {stall_torque = 900, no_load_speed = 157.08}
ratio = 20
[flywheel]
inertia = 3
[run]
tasks = ["steady", "start"]
start_speed = 1
time_max = 0.5
[[load]]
on = "slider"
force = [-1, 0]
value = "900*(s - <0.3>)*<<1>> + 20*v*<<1>>"
""" + BODIES

PATH = """
kind = "path-generation"
gravity = [0, -<9.80665>]
[target]
points = [[<0.20>, <0.20>], [<0.20>, <0.25>], [<0.20>, <0.30>], [<0.20>, <0.35>], [<0.20>, <0.40>]]
[constraints]
class = "crank-rocker"
torque_ripple_max = 30
peak_torque_max = 30
rms_torque_max = 30
motor_power_max = 500
flywheel_inertia_max = 90
[drive]
speed = 5
[flywheel]
fluctuation = 0.1
[[link]]
name = "coupler"
mass_per_length = <<0.5>>
[[link]]
between = ["D", "C"]
mass = 0.3
centre = [<0.1>, 0]
inertia = 0.02
[[load]]
on = "coupler-point"
force = [0, -2]
[solve]
starts = 12
designs = 1
"""

CAM = """
kind = "cam"
[follower]
type = "translating-roller"
mass = 0.3
spring_rate = <<4000>>
load = 20
[mechanism]
base_radius = <0.04>
roller_radius = <0.01>
offset = <0.004>
[[motion]]
law = "cycloidal"
over_deg = 120
rise = <0.02>
[[motion]]
law = "cycloidal"
over_deg = 100
rise = -<0.02>
[[motion]]
law = "dwell"
over_deg = 140
[drive]
speed = 60
[contact]
width = <0.01>
elasticity = [<<<2.06e11>>>, <<<2.06e11>>>]
"""

ARM = """
kind = "cam"
[follower]
type = "oscillating-roller"
inertia = 0.004
spring_rate = 30
preload = 9
[mechanism]
base_radius = <0.04>
roller_radius = <0.01>
centre_distance = <0.09>
arm = <0.08>
[[motion]]
law = "cycloidal"
over_deg = 180
rise_deg = 15
[[motion]]
law = "cycloidal"
over_deg = 180
rise_deg = -15
[drive]
speed = 60
[contact]
width = <0.01>
elasticity = [<<<2.06e11>>>, <<<2.06e11>>>]
"""


def in_unit(text, unit):
    """The file of a twin whose lengths are in `unit`."""
    def number(power):
        return lambda match: repr(float(match[1]) / METRES[unit] ** power)
    text = re.sub(r"<<<([^<>]+)>>>", number(-2), text)
    text = re.sub(r"<<([^<>]+)>>", number(-1), text)
    text = re.sub(r"<([^<>]+)>", number(1), text)
    return f'length_unit = "{unit}"\n{text}'


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=200,
                          check=False)


def numbers(values):
    return [value for value in values if value is not None]


class Units(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, text, name="file"):
        path = self.folder / f"{name}.toml"
        path.write_text(text, encoding="utf-8")
        return path

    def answer(self, command, text, *options):
        ended = run(command, self.file(text), "--json", *options)
        self.assertIn(ended.returncode, (0, 1), ended.stderr)
        document = json.loads(ended.stdout)
        if jsonschema:
            jsonschema.validate(document, json.loads(SCHEMA.read_text(encoding="utf-8")))
        return document

    def assert_alike(self, first, second, name, size=0.0, accuracy=1e-12):
        self.assertAlmostEqual(first, second, delta=accuracy * max(abs(first), abs(second), size, 1e-300),
                               msg=name)

    def compare_columns(self, metres, other, unit, accuracy=1e-12):
        # A column of nothing but rounding is measured by the others of its unit.
        sizes = {}
        for column in metres:
            largest = max(map(abs, numbers(column["values"])), default=0)
            sizes[column["unit"]] = max(sizes.get(column["unit"], 0), largest)
        for first, second in zip(metres, other, strict=True):
            self.assertEqual(first["name"], second["name"])
            power = {"length": 1, "length/s": 1, "length/s2": 1, "1/length": -1}.get(first["unit"], 0)
            scale = METRES[unit] ** power
            size = sizes[first["unit"]]
            for a, b in zip(first["values"], second["values"], strict=True):
                self.assertEqual(a is None, b is None, first["name"])
                if a is not None:
                    self.assert_alike(a, scale * b, first["name"], size, accuracy)

    def test_twins_of_an_analysis_have_the_same_physics(self):
        for text in (ANALYSIS, SLIDER):
            metres = self.answer("analyze", in_unit(text, "m"))
            self.assertTrue(any("_N_m" in c["name"] for c in metres["analysis"]["columns"]))
            for unit in ("mm", "cm", "in"):
                with self.subTest(unit=unit):
                    twin = self.answer("analyze", in_unit(text, unit))
                    self.assertEqual(twin["problem"]["length_unit"], unit)
                    self.compare_columns(metres["analysis"]["columns"], twin["analysis"]["columns"], unit)
                    first, second = metres["designs"][0]["metrics"], twin["designs"][0]["metrics"]
                    for name in ("torque_N_m", "drive_force_N", "reaction_max_N"):
                        for part, value in first.get(name, {}).items():
                            if "_at" not in part:
                                self.assert_alike(value, second[name][part], part)

    def test_a_weight_is_held_by_its_torque(self):
        # A crank of 200 mm with 3 kg at its end, held level: m g l = 3 · 9.80665 · 0.2 N m.
        held = """kind = "analysis"
length_unit = "mm"
gravity = [0, -9806.65]
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [500, 0]]
crank = 200
coupler = 500
rocker = 400
[[link]]
name = "crank"
mass = 3
centre = [200, 0]
[drive]
speed = 10
start_deg = 0
end_deg = 90
steps = 1
[output]
want = ["torque", "reactions"]
"""
        columns = {c["name"]: c["values"] for c in self.answer("analyze", held)["analysis"]["columns"]}
        self.assertAlmostEqual(columns["torque_N_m"][0], 3 * 9.80665 * 0.2, places=12)
        # It goes round at 10 rad/s: the pin draws it inwards with m r ω², 3 · 0.2 · 100 N.
        self.assertAlmostEqual(columns["A_on_crank_Fx_N"][0], -60, places=10)
        self.assertAlmostEqual(columns["A_on_crank_Fy_N"][1], 3 * 9.80665 - 60, places=10)

    def test_twins_of_a_machine_run_alike(self):
        metres = self.answer("analyze", in_unit(MACHINE, "m"))
        for unit in ("mm", "in"):
            twin = self.answer("analyze", in_unit(MACHINE, unit))
            for first, second in zip(metres["machine"]["motions"], twin["machine"]["motions"], strict=True):
                # What is integrated is the same to the rounding that steps add up.
                self.compare_columns(first["columns"], second["columns"], unit, 1e-10)
            first, second = metres["designs"][0]["metrics"], twin["designs"][0]["metrics"]
            for name in ("energy_swing_J", "motor_work_J", "motor_power_max_W", "speed_mean_rad_s"):
                self.assert_alike(first[name], second[name], name)

    def test_a_path_in_mm_keeps_limits_that_its_analysis_confirms(self):
        document = self.answer("solve", in_unit(PATH, "mm"))
        self.assertEqual(document["status"], "solved")
        design = document["designs"][0]
        mechanism, metrics = design["mechanism"], design["metrics"]
        # The rod weighs 0.5 kg/m, its moment of inertia is m l²/12 in kg m².
        length = mechanism["coupler"] / 1000
        mass = 0.5 * length
        pivots, point = mechanism["fixed_pivots"], mechanism["coupler_point"]
        analysed = f"""kind = "analysis"
length_unit = "mm"
gravity = [0, -9806.65]
[mechanism]
type = "four-bar"
fixed_pivots = {pivots}
crank = {mechanism["crank"]}
coupler = {mechanism["coupler"]}
rocker = {mechanism["rocker"]}
coupler_point = {point}
assembly = "{mechanism["assembly"]}"
[drive]
speed = 5
[output]
want = ["torque"]
[[link]]
name = "coupler"
mass = {mass}
centre = [{500 * length}, 0]
inertia = {mass * length**2 / 12}
[[link]]
between = ["D", "C"]
mass = 0.3
centre = [100, 0]
inertia = 0.02
[[load]]
on = "coupler"
at = {point}
force = [0, -2]
"""
        torque = self.answer("analyze", analysed)["designs"][0]["metrics"]["torque_N_m"]
        self.assert_alike(metrics["torque_ripple"], torque["max"] - torque["min"], "ripple", accuracy=1e-9)
        self.assert_alike(metrics["peak_torque"], torque["abs_max"], "peak", accuracy=1e-9)
        self.assertEqual(torque["abs_max"], max(torque["max"], -torque["min"]))
        # The search's linkage and the general mechanism are integrated by different programs.
        self.assert_alike(metrics["rms_torque"], torque["rms"], "rms", accuracy=1e-9)
        # What the drive gives is counted, not what it takes back.
        self.assertLess(torque["max"], 1)
        self.assert_alike(metrics["motor_power"], 5 * torque["max"], "power", accuracy=1e-9)

    def test_twins_of_a_cam_press_alike(self):
        for text in (CAM, ARM):
            metres = self.answer("solve", in_unit(text, "m"))["designs"][0]["metrics"]
            for unit in ("mm", "in"):
                twin = self.answer("solve", in_unit(text, unit))["designs"][0]["metrics"]
                for name in ("contact_force_max", "torque_max", "preload_min", "demand_min"):
                    self.assert_alike(metres[name], twin[name], name, 1e-3)
                self.assert_alike(metres["contact_stress_max"],
                                  twin["contact_stress_max"] / METRES[unit] ** 2, "stress")

    def test_the_torque_of_a_cam_does_the_work_of_its_follower(self):
        path = self.file(in_unit(CAM, "mm"), "cam")
        self.assertEqual(run("solve", path, "--steps", 3600, "--out", self.folder).returncode, 0)
        with (self.folder / "cam.csv").open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        force = [float(row["torque_N_m"]) for row in rows if float(row["cam_deg"]) <= 120]
        work = sum((a + b) / 2 for a, b in zip(force, force[1:])) * 3.14159265358979 / 1800
        preload = json.loads((self.folder / "cam.result.json").read_text())["designs"][0]["metrics"]["preload"]
        # The spring is pressed together by 20 mm, and the load is borne so far.
        self.assertAlmostEqual(work, 0.5 * 4000 * 0.02**2 + (preload + 20) * 0.02, places=6)

    def test_labels_name_the_unit(self):
        path = self.file(in_unit(ANALYSIS, "mm"), "twin")
        ended = run("analyze", path, "--out", self.folder)
        self.assertRegex(ended.stdout, r"output_stroke +200.\d+ +mm\n")
        self.assertIn("[mm]", ended.stdout)
        self.assertNotIn("length", ended.stdout)
        with (self.folder / "twin.csv").open(encoding="utf-8", newline="") as file:
            header = next(csv.reader(file))
        for name in ("crank_deg", "slider_s_mm", "C_x_mm", "C_vx_mm_per_s", "C_ax_mm_per_s2", "torque_N_m"):
            self.assertIn(name, header)
        self.assertIn('data-length-unit="mm"', (self.folder / "twin.report.html").read_text()[:400])
        without = run("analyze", self.file(in_unit(ANALYSIS, "m").split("\n", 1)[1]), "--out", self.folder)
        self.assertRegex(without.stdout, r"torque_N_m.max +51.\d+ +N m for lengths in m\n")
        self.assertIn("[length]", without.stdout)

    def test_the_option_gives_what_the_file_does_not(self):
        text = in_unit(ANALYSIS, "mm").split("\n", 1)[1]
        given = self.answer("analyze", text, "--length-unit", "mm")
        self.assertEqual(given["problem"]["length_unit"], "mm")
        written = self.answer("analyze", in_unit(ANALYSIS, "mm"))
        self.assertEqual(given["designs"], written["designs"])

    def test_contradictions_are_messages(self):
        path = self.file(in_unit(ANALYSIS, "mm"), "twin")
        ended = run("analyze", path, "--length-unit", "in", "--out", self.folder)
        self.assertEqual(ended.returncode, 2)
        self.assertIn(f'{path}:1:15: length_unit is "mm", but --length-unit says "in"', ended.stderr)
        self.assertEqual(run("analyze", path, "--length-unit", "mm", "--out", self.folder).returncode, 0)
        result = self.folder / "twin.result.json"
        for command in (("export", "--format", "svg"), ("analyze",)):
            ended = run(command[0], result, *command[1:], "--length-unit", "in", "--out", self.folder)
            self.assertEqual(ended.returncode, 2)
            self.assertIn("the lengths are in mm, but --length-unit says in", ended.stderr)
        ended = run("solve", path, "--length-unit", "feet")
        self.assertEqual(ended.returncode, 2)
        self.assertIn("allowed is mm, cm, m or in", ended.stderr)
        ended = run("check", self.file('length_unit = "ft"\n' + ANALYSIS.replace("<", "").replace(">", "")))
        self.assertEqual(ended.returncode, 2)
        self.assertIn('length_unit is "ft"; allowed are "mm", "cm", "m", "in"', ended.stderr)

    def notes(self, text):
        return " ".join(self.answer("analyze", text)["notes"])

    def test_doubtful_units_are_noted(self):
        metres, millimetres = (in_unit(ANALYSIS, unit) for unit in ("m", "mm"))
        for sound in (metres, millimetres, metres.split("\n", 1)[1]):
            self.assertEqual(self.notes(sound), "")
        self.assertIn("gravity is 9806.65, the Earth's in mm/s²", self.notes(millimetres.split("\n", 1)[1]))
        still = re.sub("gravity.*", "", millimetres.split("\n", 1)[1])
        self.assertIn("a link is 450 long", self.notes(still))
        weak = millimetres.replace("9806.65", "9.80665")
        self.assertIn("gravity is 9.80665 mm/s², far below the Earth's, which is 9806.65", self.notes(weak))

    def drawing(self, unit, *options):
        text = in_unit(ANALYSIS, unit) if unit else ANALYSIS.replace("<", "").replace(">", "")
        path = self.file(text, "drawn")
        self.assertEqual(run("analyze", path, "--out", self.folder).returncode, 0)
        ended = run("export", self.folder / "drawn.result.json", *options, "--out", self.folder)
        self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_svg_has_its_true_size(self):
        for unit in METRES:
            self.drawing(unit, "--format", "svg")
            root = xml.etree.ElementTree.parse(self.folder / "drawn.svg").getroot()
            _, _, width, height = map(float, root.get("viewBox").split())
            for name, length in (("width", width), ("height", height)):
                self.assertTrue(root.get(name).endswith("mm"))
                self.assertAlmostEqual(float(root.get(name)[:-2]), 1000 * METRES[unit] * length, places=5)
        self.drawing(None, "--format", "svg")
        self.assertIsNone(xml.etree.ElementTree.parse(self.folder / "drawn.svg").getroot().get("width"))

    def test_dxf_names_the_unit(self):
        for unit, index, metric in (("mm", 4, 1), ("cm", 5, 1), ("m", 6, 1), ("in", 1, 0)):
            for parts in ((), ("--parts", "--hole", 0.01 / METRES[unit], "--width", 0.05 / METRES[unit])):
                self.drawing(unit, "--format", "dxf", *parts)
                path = self.folder / ("drawn.parts.dxf" if parts else "drawn.dxf")
                self.assertIn(f"$INSUNITS\n70\n{index}\n", path.read_text())
                self.assertIn(f"$MEASUREMENT\n70\n{metric}\n", path.read_text())
                if ezdxf is None:
                    continue
                drawing = ezdxf.readfile(path)
                self.assertEqual(drawing.units, index)
                self.assertEqual(drawing.header["$MEASUREMENT"], metric)
                if not parts:
                    # The crank, a line of 100 mm, measured in the drawing's own unit.
                    lengths = [(e.dxf.end - e.dxf.start).magnitude * METRES[unit]
                               for e in drawing.modelspace().query("LINE")]
                    self.assertTrue(any(abs(length - 0.1) < 1e-12 for length in lengths), lengths)
        self.drawing(None, "--format", "dxf")
        self.assertIn("$INSUNITS\n70\n0\n", (self.folder / "drawn.dxf").read_text())

    def test_a_mechanism_goes_on_with_its_unit(self):
        path = self.file(in_unit(ANALYSIS, "in"), "drawn")
        self.assertEqual(run("analyze", path, "--out", self.folder).returncode, 0)
        result = self.folder / "drawn.result.json"
        self.assertEqual(run("export", result, "--format", "toml", "--out", self.folder).returncode, 0)
        self.assertIn('length_unit = "in"', (self.folder / "drawn.design1.toml").read_text())
        self.assertEqual(run("export", result, "--format", "json", "--out", self.folder).returncode, 0)
        self.assertEqual(json.loads((self.folder / "drawn.json").read_text())["length_unit"], "in")

    def test_gears_and_studies_name_it(self):
        path = self.file('kind = "gear"\nlength_unit = "mm"\n[mechanism]\nteeth = 35\nmodule = 5\n', "gear")
        ended = run("analyze", path, "--out", self.folder)
        self.assertRegex(ended.stdout, r"reference_diameter +d +175 +mm\n")
        self.assertIn("radius_mm,x_mm,y_mm,thickness_mm", (self.folder / "gear.csv").read_text())
        self.file(in_unit(ANALYSIS, "mm"), "base")
        study = self.file('base = "base.toml"\n[[vary]]\nkey = "mechanism.crank"\nrange = [90, 100]\nsteps = 3\n'
                          '[output]\nmetrics = ["output_stroke"]\n[objective]\nmaximize = "output_stroke"\n', "study")
        ended = run("sweep", study, "--out", self.folder)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertIn("[mm]", ended.stdout)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    SCHEMA = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
