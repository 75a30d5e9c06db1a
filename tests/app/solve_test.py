"""Solving from outside: files, documents, exit statuses, interruption, the same designs again.

Run as: solve_test.py PROGRAM LIBRARY SCHEMA, the built program, the folder of library problems and
the JSON schema of results.
"""

import json
import math
import os
import pathlib
import pty
import re
import signal
import subprocess
import sys
import tempfile
import unittest

from thinned import some

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
LIBRARY = pathlib.Path()
SCHEMA = pathlib.Path()

PATH = "path/six-point-line.toml"
FUNCTION = "function/three-angle-pairs.toml"

# Solvable, but asked to go through so many starts that it does not end within the test.
ENDLESS = """
kind = "path-generation"
[target]
points = [[0, 0], [1, 2], [2, 2.5], [3, 2], [4, 0], [3.5, -2], [2, -1.5], [1, -2.5]]
[bounds]
length = [0.5, 20]
[solve]
starts = {starts}
"""

IMPOSSIBLE = """
kind = "path-generation"
[target]
points = [[0, 0], [100, 0], [200, 0], [300, 0], [200, 100], [100, 100]]
[bounds]
length = [1, 2]
pivot_a = [[0, 0], [1, 1]]
pivot_d = [[0, 0], [3, 3]]
coupler_point = [[-1, -1], [1, 1]]
[constraints]
class = "crank-rocker"
transmission_angle_deg = [89.9, 90.1]
[solve]
starts = 20
"""


def refuse_constant(name):
    raise AssertionError(f"{name} is no JSON")


# Seconds for each worked problem: a search that is cut goes all the same ways, and tests of the kinds
# let the long ones end.
BOUND = "0.25"


def parse(text):
    """The document in `text`, which holds neither NaN nor Infinity."""
    return json.loads(text, parse_constant=refuse_constant)


def spelled_out(key):
    """The keys that one of the catalogue stands for: "a_at_1, _at_2" for a_at_1 and a_at_2."""
    first, *others = key.split(", ")
    stem = first.split("_at_")[0]
    return [first, *(stem + other if other.startswith("_") else other for other in others)]


def keys_of(table):
    """The keys of a table and its tables, levels separated by dots; numbered ones as 1, those
    of a joint as NAME."""
    keys = set()
    for key, value in table.items():
        key = re.sub(r"^slide_\d+$", "slide_1", key)
        key = re.sub(r"^transmission_\w+_min_deg$", "transmission_NAME_min_deg", key)
        below = keys_of(value) if isinstance(value, dict) else None
        keys |= {f"{key}.{name}" for name in below} if below else {key}
    return keys


def run(*arguments, **options):
    """Runs the program; drops the lines of progress, which only a slow machine gets to see."""
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options
    )
    done.stderr = re.sub(r"^cognate: +\d+ %.*\n", "", done.stderr, flags=re.MULTILINE)
    return done


def setUpModule():
    """Start sets are kept for the tests alone, not in the user's own cache."""
    cache = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(cache.cleanup)
    os.environ["XDG_CACHE_HOME"] = cache.name


class Solve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text):
        file = self.folder / "written.toml"
        file.write_text(text)
        return file

    def check_document(self, document):
        """What holds for every result, apart from its schema."""
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        problem = document["problem"]
        slides = problem.get("mechanism", {}).get("type", "").endswith(("slider-crank", "-slider"))
        angles = problem["kind"] == "function-generation" and not slides
        if problem["kind"] in ("cam", "gear-pair", "gear-train"):  # which have no error
            for design in document["designs"]:
                self.assertEqual(set(design["error"].values()), {0})
            return
        for design in document["designs"]:
            error, count = design["error"], len(design["crank_deg"])
            self.assertLessEqual(error["rms"], error["max"] * (1 + 1e-12))
            self.assertEqual("rms_deg" in error, angles)
            if "precision_residual" in design["metrics"]:
                continue  # the error of an exact design is taken beside its precision points
            self.assertAlmostEqual(
                error["rms"], math.sqrt(error["sum_of_squares"] / count), delta=1e-9 * error["max"]
            )

    def test_writes_both_files_and_prints_a_table(self):
        for problem in (PATH, FUNCTION):
            with self.subTest(problem):
                done = run("solve", LIBRARY / problem, "--out", "new/deeper", cwd=self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                name = pathlib.Path(problem).stem
                self.assertIn("solved: ", done.stdout)
                self.assertIn(f"wrote new/deeper/{name}.result.json", done.stdout)
                self.assertNotIn("\x1b", done.stdout)
                out = self.folder / "new/deeper"
                document = parse((out / f"{name}.result.json").read_text())
                self.check_document(document)
                self.assertEqual(document["status"], "solved")
                report = (out / f"{name}.report.html").read_text()
                self.assertIn("</html>", report)
        self.assertEqual(len(list(out.iterdir())), 4)

    def test_json_is_the_document_and_nothing_else(self):
        done = run("solve", LIBRARY / FUNCTION, "--json", "--seed", "5", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = parse(done.stdout)
        self.check_document(document)
        self.assertEqual(document["seed"], 5)
        self.assertEqual(list(self.folder.iterdir()), [])
        again = run("solve", LIBRARY / FUNCTION, "--json", "--seed=5", "--out", self.folder)
        written = parse((self.folder / "three-angle-pairs.result.json").read_text())
        self.assertEqual(written, parse(again.stdout))
        self.assertEqual(written["designs"], document["designs"])

    def test_every_problem_of_the_library(self):
        listed = parse(run("list", "--metrics", "--json").stdout)
        metrics = {name for part in ("metrics", "tolerance_metrics", "layers_metrics")
                   for metric in listed[part]
                   for name in spelled_out(metric["key"])}
        of_cams = {name for metric in listed["cam_metrics"] for name in spelled_out(metric["key"])}
        facts = {name for fact in listed["facts"] for name in spelled_out(fact["key"])}
        words = json.loads((SCHEMA.parent / "../report/page/words/zh.json").read_text(encoding="utf-8"))["terms"]
        of_gears = {name for part in ("gear_metrics", "gear_pair_metrics")
                    for metric in listed[part] for name in spelled_out(metric["key"])}
        solved = 0
        for file in some(sorted(LIBRARY.rglob("*.toml"))):
            if file.parent.name in ("analysis", "gear", "machine", "study"):
                continue
            with self.subTest(file.name):
                done = run("solve", file, "--json", "--time-limit", BOUND, "--threads", "1")
                self.assertEqual(done.stderr, "")
                document = parse(done.stdout)
                self.assertIn(done.returncode, (0, 1))
                if document["status"] != "time-limit":
                    self.assertEqual(done.returncode, 0 if document["status"] == "solved" else 1)
                self.check_document(document)
                self.assertLessEqual(document.get("facts", {}).keys(), facts)
                for design in document["designs"]:
                    for check in design["constraints"]:
                        self.assertIn(check["label"].split(" (")[0], words, check["name"])
                    if design["mechanism"]["type"] == "gear-train":
                        continue  # its metrics are those of its members: gear_train_test.py
                    keys = keys_of(design["metrics"])
                    if design["mechanism"]["type"] == "cam":
                        keys = {key.removesuffix("_at_deg") for key in keys} - of_cams
                    if design["mechanism"]["type"] == "gear-pair":
                        keys = {re.sub(r"^(pinion|wheel|worm|rack)\.", "", key) for key in keys} - of_gears
                        keys.discard("transmission_angle_deg")  # null of a worm
                    self.assertLessEqual(keys, metrics)
                    solved += 1
        self.assertGreater(solved, 50)

    def test_certifies_what_the_file_asks_for(self):
        text = (LIBRARY / "path/semicircle.toml").read_text() + "[solve]\ncertify = true\n"
        done = run("solve", self.write(text), "--out", "out", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = parse((self.folder / "out/written.result.json").read_text())
        self.check_document(document)
        proof = document["certificate"]
        self.assertTrue(proof["complete"])
        self.assertAlmostEqual(proof["upper_bound"], 2.580355625505, delta=1e-9)
        self.assertAlmostEqual(proof["lower_bound"], 2.580355625505, delta=3e-3)
        self.assertLessEqual(proof["lower_bound"], proof["upper_bound"])
        self.assertIn("certified: sum of squares 2.58035562", done.stdout)
        report = (self.folder / "out/written.report.html").read_text()
        self.assertIn('"lower_bound"', report)

    def test_quiet_prints_nothing(self):
        done = run("solve", LIBRARY / FUNCTION, "--quiet", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(len(list(self.folder.iterdir())), 2)

    def test_the_number_of_threads_changes_no_design(self):
        for problem in (PATH, "path/five-point-arc.toml", "function/log10-refined.toml"):
            with self.subTest(problem):
                texts = [
                    json.dumps(
                        parse(run("solve", LIBRARY / problem, "--json", "--threads", n).stdout)[
                            "designs"
                        ]
                    )
                    for n in (1, 2)
                ]
                self.assertEqual(texts[0], texts[1])

    def test_no_design_meets_the_constraints(self):
        done = run("solve", self.write(IMPOSSIBLE), "--out", self.folder)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        document = parse((self.folder / "written.result.json").read_text())
        self.check_document(document)
        self.assertIn(document["status"], ("infeasible", "no-solution"))
        for design in document["designs"]:
            self.assertFalse(all(check["satisfied"] for check in design["constraints"]))
        if document["designs"]:
            self.assertRegex(done.stdout, r"designs? 1( .*)? violates? ")

    def test_a_time_limit_ends_the_run(self):
        file = self.write(ENDLESS.format(starts=self.most_starts()))
        done = run("solve", file, "--json", "--time-limit", "0.5")
        document = parse(done.stdout)
        self.check_document(document)
        self.assertEqual(document["status"], "time-limit")
        self.assertIn(done.returncode, (0, 1))

    def test_ctrl_c_reports_what_was_found(self):
        file = self.write(ENDLESS.format(starts=self.most_starts()))
        program, screen = self.start_on_terminal(file)
        program.send_signal(signal.SIGINT)
        text, _ = program.communicate(timeout=120)
        self.assertIn(program.returncode, (0, 1))
        self.assertIn(b"interrupted; what was found", self.read_rest(screen))
        self.assertIn("interrupted: ", text)
        document = parse((self.folder / "written.result.json").read_text())
        self.check_document(document)
        self.assertEqual(document["status"], "interrupted")
        feasible = any(
            all(check["satisfied"] for check in design["constraints"])
            for design in document["designs"]
        )
        self.assertEqual(program.returncode, 0 if feasible else 1)

    def most_starts(self):
        """The greatest number of starts that a file may ask for."""
        for starts in (10**9, 10**6, 10**5, 10**4):
            if run("check", self.write(ENDLESS.format(starts=starts))).returncode == 0:
                return starts
        raise AssertionError("no number of starts is allowed")

    def start_on_terminal(self, file):
        """The program solving `file`, its standard error a terminal that already shows the bar."""
        screen, terminal = pty.openpty()
        self.addCleanup(os.close, screen)
        program = subprocess.Popen(
            [PROGRAM, "solve", file, "--out", self.folder],
            stdout=subprocess.PIPE,
            stderr=terminal,
            env={**os.environ, "TERM": "xterm"},
            text=True,
        )
        os.close(terminal)
        shown = b""
        while b" %" not in shown:
            shown += os.read(screen, 1000)
        self.assertRegex(shown, rb"\r\x1b\[K\[[#.]+\]")
        return program, screen

    @staticmethod
    def read_rest(screen):
        """What a terminal still shows until the program at its other end is gone."""
        text = b""
        while True:
            try:
                part = os.read(screen, 1000)
            except OSError:  # how Linux says that the other end is closed
                return text
            if not part:
                return text
            text += part


if __name__ == "__main__":
    PROGRAM, LIBRARY, SCHEMA = os.path.abspath(sys.argv[1]), *map(
        lambda name: pathlib.Path(name).resolve(), sys.argv[2:4]
    )
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
