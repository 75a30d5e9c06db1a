"""Studies from outside: files, documents, what is refused, what survives being stopped.

Run as: sweep_test.py PROGRAM SCHEMA, the built program and the JSON schema of summaries.
"""

import cmath
import json
import math
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = ""
SCHEMA = pathlib.Path()

SLIDER = """
kind = "analysis"
[mechanism]
type = "slider-crank"
pivot = [0, 0]
crank = 1
coupler = 3
offset = 0.25
[drive]
speed = 1
steps = 36
[output]
position = true
"""

SMALL = """
base = "slider.toml"
[[vary]]
key = "mechanism.coupler"
range = [0.5, 5.5]
steps = 21
[[vary]]
key = "mechanism.offset"
values = [0, 0.25, 0.5]
[output]
metrics = ["class", "output_stroke", "time_ratio"]
[filter]
"transmission_angle_deg.acute_min" = { min = 30 }
[objective]
maximize = "output_stroke"
"""

# Analysed one by one for longer than any test lasts.
LONG = """
base = "slider.toml"
[[vary]]
key = "mechanism.coupler"
range = [2, 5]
sampling = "sobol"
count = 4000000
[[vary]]
key = "mechanism.offset"
range = [0, 0.5]
sampling = "sobol"
count = 4000000
[output]
metrics = ["output_stroke"]
"""

ATLAS_BASE = """
kind = "analysis"
[mechanism]
type = "four-bar"
fixed_pivots = [[0, 0], [3, 0]]
crank = 1
coupler = 3
rocker = 2.5
coupler_point = [1, 1]
[output]
curve = true
"""

HARMONICS = ["m4", "m3", "m2", "m1", "p1", "p2", "p3", "p4"]
DESCRIPTORS = [f"fourier.{name}" for name in HARMONICS] + [
    f"fourier_phase_deg.{name}" for name in HARMONICS if name[1] != "1"
]

ATLAS = """
base = "four-bar.toml"
[[vary]]
key = "mechanism.coupler_point[0]"
values = [0.5, 1.5, 2.5]
[[vary]]
key = "mechanism.coupler_point[1]"
values = [-1, 0.5, 2]
[output]
metrics = {metrics}
"""

CLOSED = """kind = "path-generation"
[target]
curve = {curve}
[bounds]
length = [0.1, 50]
[solve]
starts = 1
atlas = "atlas.study.db"
"""

# MPI keeps some memory to its end, which a sanitized program would count as leaked.
MPI = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    ASAN_OPTIONS="detect_leaks=0",
)


def refuse_constant(name):
    raise AssertionError(f"{name} is no JSON")


def planted_curve():
    """Of the linkage of ATLAS with its point at (1.5, 2), twice as large and turned by 90 degrees."""
    points = []
    for step in range(72):
        b = cmath.rect(1, step * math.pi / 36)
        to_d = 3 - b
        # The triangle B, C, D of coupler 3 and rocker 2.5; C left of B–D is the open assembly.
        angle = math.acos((9 + abs(to_d) ** 2 - 2.5**2) / (6 * abs(to_d)))
        coupler = to_d / abs(to_d) * cmath.exp(1j * angle)
        point = 2j * (b + (1.5 + 2j) * coupler)
        points.append([point.real, point.imag])
    return points


class Sweeps(unittest.TestCase):
    """A folder with a base file and studies of it."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "slider.toml").write_text(SLIDER)
        (self.folder / "small.toml").write_text(SMALL)
        (self.folder / "long.toml").write_text(LONG)

    def run_program(self, *arguments, **options):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=120,
            **options,
        )

    def start(self, *arguments, **options):
        return subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            **options,
        )

    def rows(self, file, table="runs ORDER BY id"):
        with sqlite3.connect(self.folder / file) as database:
            return database.execute(f"SELECT * FROM {table}").fetchall()

    def wait_for_rows(self, file):
        """Queries the study file while the study runs, until there are rows."""
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            try:
                if (self.folder / file).exists() and self.rows(file, "runs LIMIT 1"):
                    return
            except sqlite3.OperationalError:
                pass  # its tables are not there yet
            time.sleep(0.02)
        self.fail("no rows within a minute")

    def expect_refusal(self, done, *parts):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)


class SweepTest(Sweeps):
    def test_rows_table_and_report(self):
        done = self.run_program("sweep", "small.toml", "--seed", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("done: 63 designs evaluated", done.stdout)
        self.assertIn("wrote small.study.db and small.report.html", done.stdout)
        self.assertEqual(
            sorted(path.name for path in self.folder.iterdir()),
            ["long.toml", "slider.toml", "small.report.html", "small.study.db", "small.toml"],
        )
        with sqlite3.connect(self.folder / "small.study.db") as database:
            columns = [row[1] for row in database.execute("PRAGMA table_info(runs)")]
            study = dict(database.execute("SELECT name, value FROM study"))
        self.assertEqual(
            columns,
            ["id", "mechanism.coupler", "mechanism.offset", "class", "output_stroke", "time_ratio", "status"],
        )
        self.assertEqual(study["study"], SMALL)
        self.assertEqual(study["base"], SLIDER)
        self.assertEqual(study["seed"], "3")
        rows = self.rows("small.study.db")
        # By hand: the crank turns fully where coupler − crank ≥ offset, and its transmission angle
        # is least at cos = (crank + offset) / coupler; the grid's last variable is the fastest.
        for number, coupler, offset, _, stroke, _, status in rows:
            self.assertEqual(coupler, 0.5 + number // 3 * 0.25)
            self.assertEqual(offset, [0, 0.25, 0.5][number % 3])
            self.assertEqual(status, "solved")
            outer, inner = ((coupler + sign) ** 2 - offset**2 for sign in (1, -1))
            self.assertAlmostEqual(stroke, outer**0.5 - inner**0.5, delta=1e-9)
        kept = [
            number
            for number in range(63)
            if 0.5 + number // 3 * 0.25 >= (1 + [0, 0.25, 0.5][number % 3]) / (3**0.5 / 2)
        ]
        self.assertEqual([row[0] for row in rows], kept)
        best = self.rows("small.study.db", "best")
        self.assertEqual(sorted(best), rows)
        self.assertEqual(best, sorted(best, key=lambda row: (-row[4], row[0])))

    def test_numbers_of_layers_are_metrics(self):
        """Cranks that sweep over each other's pivots have no layers, those of a longer frame two."""
        (self.folder / "linkage.toml").write_text(
            'kind = "analysis"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [4, 0]]\n'
            "crank = 3\ncoupler = 2.5\nrocker = 3\n"
            "[layers]\nlink_width = 0.3\npin_diameter = 0.15\n")
        (self.folder / "layers.toml").write_text(
            'base = "linkage.toml"\n[[vary]]\nkey = "mechanism.fixed_pivots[1][0]"\nvalues = [1, 5.2]\n'
            '[output]\nmetrics = ["layers.count"]\nrows = "all"\n[filter]\n"layers.count" = {max = 2}\n')
        done = self.run_program("sweep", "layers.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([row[2:] for row in self.rows("layers.study.db")],
                         [(None, "filtered"), (2, "solved")])

    def test_document(self):
        done = self.run_program("sweep", "small.toml", "--json", "--out", "deep/er")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = json.loads(done.stdout, parse_constant=refuse_constant)
        if jsonschema is not None:
            jsonschema.validate(document, json.loads(SCHEMA.read_text()))
        rows = self.rows("deep/er/small.study.db")
        best = self.rows("deep/er/small.study.db", "best LIMIT 10")
        self.assertEqual([list(row.values()) for row in document["best"]], [list(row) for row in best])
        self.assertEqual(document["status"], "done")
        self.assertEqual(document["counts"]["evaluated"], 63)
        self.assertEqual(document["counts"]["kept"], len(rows))
        self.assertEqual(document["counts"]["filtered"], 63 - len(rows))
        self.assertTrue((self.folder / "deep/er/small.report.html").exists())
        self.run_program("sweep", "small.toml", "--json")
        self.assertFalse((self.folder / "small.report.html").exists())

    def test_again_there_is_nothing_to_do(self):
        self.run_program("sweep", "small.toml")
        (self.folder / "small.report.html").unlink()
        rows = self.rows("small.study.db")
        again = self.run_program("sweep", "small.toml")
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        self.assertIn("nothing was left to do", again.stdout)
        self.assertEqual(self.rows("small.study.db"), rows)
        self.assertTrue((self.folder / "small.report.html").exists())

    def test_nothing_passes(self):
        (self.folder / "none.toml").write_text(SMALL.replace("min = 30", "min = 89.9"))
        done = self.run_program("sweep", "none.toml")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("0 kept", done.stdout)

    def test_faults_of_the_file(self):
        (self.folder / "bad.toml").write_text(SMALL.replace("coupler", "cuopler"))
        done = self.run_program("sweep", "bad.toml")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^bad\.toml:\d+:\d+: ")
        self.assertFalse((self.folder / "bad.study.db").exists())
        self.expect_refusal(self.run_program("sweep", "nowhere.toml"), "nowhere.toml:1:1: ")

    def test_other_input_is_refused(self):
        self.run_program("sweep", "small.toml")
        rows = self.rows("small.study.db")
        self.expect_refusal(self.run_program("sweep", "small.toml", "--seed", "2"), "the seed (1 there, 2 here)")
        (self.folder / "slider.toml").write_text(SLIDER.replace("speed = 1", "speed = 2"))
        self.expect_refusal(self.run_program("sweep", "small.toml"), "the base file (from line 10 on)")
        (self.folder / "slider.toml").write_text(SLIDER)
        (self.folder / "small.toml").write_text("# other\n" + SMALL)
        self.expect_refusal(self.run_program("sweep", "small.toml"), "the study file (from line 1 on)", "--out")
        self.assertEqual(self.rows("small.study.db"), rows)
        (self.folder / "small.toml").write_text(SMALL)
        (self.folder / "small.study.db").write_text("no database, but long enough to be looked at")
        self.expect_refusal(self.run_program("sweep", "small.toml"), "is no study file")

    def test_a_search_begins_with_an_atlas(self):
        (self.folder / "four-bar.toml").write_text(ATLAS_BASE)
        (self.folder / "atlas.toml").write_text(ATLAS.format(metrics=json.dumps(DESCRIPTORS)))
        (self.folder / "closed.toml").write_text(CLOSED.format(curve=planted_curve()))
        place = "closed.toml:8:9: solve.atlas is "
        for command in ("check", "solve"):
            done = self.run_program(command, "closed.toml")
            self.expect_refusal(done, place + '"atlas.study.db", where there is no file')
        self.assertEqual(self.run_program("sweep", "atlas.toml").returncode, 0)

        self.assertIn("from the atlas atlas.study.db", self.run_program("check", "closed.toml").stdout)
        done = self.run_program("solve", "closed.toml", "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        document = json.loads(done.stdout, parse_constant=refuse_constant)
        if jsonschema is not None:
            schema = SCHEMA.with_name("cognate-result-1.schema.json")
            jsonschema.validate(document, json.loads(schema.read_text()))
        self.assertEqual(document["problem"]["solve"]["atlas"], "atlas.study.db")
        self.assertTrue(any("9 curves of the atlas" in note for note in document["notes"]))
        self.assertLess(document["designs"][0]["error"]["max"], 5e-3)  # a polygon is wanted

        (self.folder / "of-closed.toml").write_text(
            'base = "closed.toml"\n[[vary]]\nkey = "bounds.length[1]"\nvalues = [40, 50]\n'
            '[output]\nmetrics = ["error.rms"]\n'
        )
        self.expect_refusal(
            self.run_program("sweep", "of-closed.toml"), "of-closed.toml:1:8: ", "which has solve.atlas"
        )
        for content, why in (("", "it is no study file"), ("x" * 5000, "it cannot be read")):
            (self.folder / "atlas.study.db").write_text(content)
            for command in ("check", "solve"):
                self.expect_refusal(self.run_program(command, "closed.toml"), place, why)
        (self.folder / "atlas.study.db").unlink()
        (self.folder / "atlas.toml").write_text(ATLAS.format(metrics=json.dumps(DESCRIPTORS[1:])))
        self.run_program("sweep", "atlas.toml")
        for command in ("check", "solve"):
            done = self.run_program(command, "closed.toml")
            self.expect_refusal(done, place, "it has no column fourier.m4; an atlas is")

    def test_study_file_changed_by_hand_is_refused(self):
        self.run_program("sweep", "small.toml", "--json")
        whole = (self.folder / "small.study.db").read_bytes()
        for change in (
            "DELETE FROM runs WHERE id = 20",
            "DROP TABLE blocks",
            "DROP TABLE front",
            "UPDATE blocks SET first = first + 5",
            "UPDATE blocks SET count = count + 1000",
            "UPDATE blocks SET count = -count",
            "UPDATE blocks SET first = -1",
            "INSERT INTO blocks VALUES (62, 1, 0, 1, 0, 0, 0, 0)",
        ):
            with self.subTest(change):
                for ending in ("-wal", "-shm"):
                    (self.folder / ("small.study.db" + ending)).unlink(missing_ok=True)
                (self.folder / "small.study.db").write_bytes(whole)
                database = sqlite3.connect(self.folder / "small.study.db")
                database.execute(change)
                database.commit()
                database.close()
                self.expect_refusal(self.run_program("sweep", "small.toml"), "is damaged", "move it away")

    def test_changed_bits_of_rows_are_found(self):
        (self.folder / "bits.toml").write_text(SMALL)
        self.run_program("sweep", "bits.toml", "--json")
        file = self.folder / "bits.study.db"
        whole = file.read_bytes()
        strokes = [row[4] for row in self.rows("bits.study.db")]
        self.assertGreater(len(strokes), 10)
        found = 0
        for number, stroke in enumerate(strokes):
            at = whole.find(struct.pack(">d", stroke))
            self.assertGreater(at, 0)
            bit = 7 * number % 64
            changed = bytearray(whole)
            changed[at + bit // 8] ^= 1 << bit % 8
            file.write_bytes(changed)
            done = self.run_program("sweep", "bits.toml")
            self.expect_refusal(done, "is damaged (the rows of the designs ", "are not those that were stored")
            self.assertEqual(file.read_bytes(), changed)
            found += 1
        self.assertEqual(found, len(strokes))
        first = self.rows("bits.study.db")[0][0]
        self.expect_refusal(
            self.run_program("export", "bits.study.db", "--row", first), "are not those that were stored"
        )
        file.write_bytes(whole)
        self.assertEqual(self.run_program("sweep", "bits.toml").returncode, 0)

    def test_file_of_before_checksums_is_gone_on_with(self):
        self.run_program("sweep", "small.toml", "--json")
        rows = self.rows("small.study.db")
        with sqlite3.connect(self.folder / "small.study.db") as database:
            database.execute("DROP TABLE checksums")
        again = self.run_program("sweep", "small.toml")
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        self.assertIn("blocks of rows have no checksums", again.stdout)
        self.assertEqual(self.rows("small.study.db"), rows)

    def test_one_study_by_two_names_has_one_lock(self):
        (self.folder / "other").mkdir()
        (self.folder / "third").mkdir()
        (self.folder / "other/long.study.db").symlink_to("../long.study.db")
        (self.folder / "third/long.study.db").symlink_to(self.folder / "other/long.study.db")
        running = self.start("sweep", "long.toml", "--quiet")
        self.wait_for_rows("long.study.db")
        for folder in ("other", "third"):
            second = self.run_program("sweep", "long.toml", "--out", folder)
            self.expect_refusal(second, f"process {running.pid} on ", "is running this study")
        running.send_signal(signal.SIGHUP)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 0)
        self.assertIn("interrupted after", errors)
        before = len(self.rows("long.study.db"))
        done = self.run_program("sweep", "long.toml", "--time-limit", "0.5", "--out", "third")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "third/long.study.db").is_symlink())
        self.assertGreater(len(self.rows("long.study.db")), before)

    def test_pipes(self):
        os.mkfifo(self.folder / "pipe")
        for base in ("pipe", "/dev/zero", "/dev/tty"):
            (self.folder / "piped.toml").write_text(SMALL.replace("slider.toml", base))
            for command in ("check", "sweep"):
                with self.subTest(base=base, command=command):
                    self.expect_refusal(
                        self.run_program(command, "piped.toml"), "piped.toml:", "expected a regular file"
                    )
        os.mkfifo(self.folder / "small.study.db")
        self.expect_refusal(self.run_program("sweep", "small.toml"), "is no study file")
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "1"), "no regular file")
        os.unlink(self.folder / "small.study.db")
        # The text of a study that comes by a pipe is stored like that of a file.
        text = SMALL.replace("slider.toml", str(self.folder / "slider.toml"))
        read = self.run_program("sweep", "/dev/stdin", input=text)
        self.assertEqual(read.returncode, 0, read.stderr)
        with sqlite3.connect(self.folder / "stdin.study.db") as database:
            self.assertEqual(
                database.execute("SELECT value FROM study WHERE name = 'study'").fetchone()[0], text
            )

    def test_interrupted_and_gone_on_with(self):
        (self.folder / "some.toml").write_text(LONG.replace("4000000", "20000"))
        running = self.start("sweep", "some.toml", "--quiet")
        self.wait_for_rows("some.study.db")
        second = self.run_program("sweep", "../" + self.folder.name + "/some.toml", "--out", self.folder)
        if running.poll() is None:
            self.expect_refusal(second, f"process {running.pid} on ", "is running this study")
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 0)
        self.assertRegex(errors, r"interrupted after [\d ]+ of 20 000 designs; the same command goes on")
        part = self.rows("some.study.db")
        self.assertGreater(len(part), 0)
        self.assertLess(len(part), 20000)
        self.assertFalse((self.folder / "some.study.lock").exists())
        done = self.run_program("sweep", "some.toml", "--threads", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("went on from", done.stdout)
        self.run_program("sweep", "some.toml", "--threads", "1", "--out", "whole")
        rows = self.rows("some.study.db")
        self.assertEqual(rows, self.rows("whole/some.study.db"))
        self.assertEqual([row for row in rows if row[0] in {row[0] for row in part}], part)

    def test_time_limit(self):
        done = self.run_program("sweep", "long.toml", "--time-limit", "0.3")
        self.assertIn("time limit reached after", done.stderr)
        self.assertIn("stopped at the time limit", done.stdout)
        self.assertEqual(done.returncode, 0)

    def test_disk_is_full(self):
        limit = 400_000  # bytes; the file of a limit and the end of a disk are one error of writing

        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        done = self.run_program("sweep", "long.toml", "--quiet", preexec_fn=limited)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("cannot store rows in", done.stderr)
        self.assertIn("the rows so far are there", done.stderr)
        with sqlite3.connect(self.folder / "long.study.db") as database:
            self.assertEqual(database.execute("PRAGMA integrity_check").fetchone(), ("ok",))
            kept = database.execute("SELECT sum(kept) FROM blocks").fetchone()[0]
            self.assertEqual(database.execute("SELECT count(*) FROM runs").fetchone()[0], kept)
        self.assertGreater(kept, 0)
        more = self.run_program("sweep", "long.toml", "--time-limit", "0.3", "--json")
        self.assertGreater(json.loads(more.stdout)["counts"]["kept"], kept)

    def test_place_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        self.expect_refusal(self.run_program("sweep", "small.toml", "--out", "file"), "'file'")
        if os.geteuid() != 0:
            (self.folder / "shut").mkdir(mode=0o500)
            self.expect_refusal(self.run_program("sweep", "small.toml", "--out", "shut"), "'shut'")

    def test_study_file_is_removed(self):
        running = self.start("sweep", "long.toml", "--quiet")
        self.wait_for_rows("long.study.db")
        (self.folder / "long.study.db").unlink()
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 2)
        self.assertIn("was removed or replaced while the study ran", errors)

    def test_progress_on_a_terminal(self):
        controller, terminal = pty.openpty()
        self.addCleanup(os.close, controller)
        with os.fdopen(terminal, "w") as error:
            running = subprocess.Popen(
                [PROGRAM, "sweep", "long.toml", "--time-limit", "1.5", "--json"],
                cwd=self.folder,
                stdout=subprocess.DEVNULL,
                stderr=error,
                env=dict(os.environ, TERM="xterm"),
            )
        shown = b""
        while running.poll() is None:
            try:
                shown += os.read(controller, 1000)
            except OSError:
                break
        running.wait()
        self.assertRegex(shown.decode(), r"\[\.*#*\.*\] +\d+ %  [\d ]+ of 4 000 000 designs, [\d ]+/s, .* left")

    def test_design_of_a_row(self):
        self.run_program("sweep", "small.toml")
        number, coupler, offset, _, stroke, *_ = self.rows("small.study.db", "best")[0]
        done = self.run_program("export", "small.study.db", "--row", number, "--out", "designs")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        file = f"designs/small.{number}.toml"
        self.assertEqual(done.stdout, f"wrote {file}\n")
        text = (self.folder / file).read_text()
        self.assertEqual(float(re.search(r"coupler = (\S+)", text)[1]), coupler)
        self.assertEqual(float(re.search(r"offset = (\S+)", text)[1]), offset)
        result = json.loads(self.run_program("analyze", file, "--json").stdout)
        self.assertAlmostEqual(result["designs"][0]["metrics"]["output_stroke"], stroke, delta=1e-12)
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "0"), "has no row 0")
        self.expect_refusal(self.run_program("export", "small.study.db", "--row", "-1"), "--row: '-1'")
        self.expect_refusal(self.run_program("export", "small.toml", "--row", "1"), "study file")
        self.expect_refusal(self.run_program("export", "small.study.db"), "--format is required")
        self.expect_refusal(
            self.run_program("export", "small.study.db", "--row", "1", "--format", "svg"), "--format"
        )


@unittest.skipUnless(shutil.which("mpirun"), "mpirun is not there")
class MpiTest(Sweeps):
    def setUp(self):
        if not pathlib.Path(PROGRAM).with_name("cognate-mpi").exists():
            self.skipTest("built without MPI")
        super().setUp()

    def run_many(self, count, *arguments):
        return subprocess.run(
            ["mpirun", "--oversubscribe", "-n", str(count), PROGRAM, *arguments],
            cwd=self.folder,
            capture_output=True,
            text=True,
            env=MPI,
            timeout=120,
        )

    def test_rows_are_those_of_one_process(self):
        (self.folder / "some.toml").write_text(LONG.replace("4000000", "3000"))
        many = self.run_many(3, "sweep", "some.toml", "--out", "many")
        self.assertEqual(many.returncode, 0, many.stderr)
        self.assertEqual(many.stdout.count("3 000 designs evaluated"), 1, many.stdout)
        self.assertIn("on 3 threads", many.stdout)
        self.run_program("sweep", "some.toml", "--out", "one")
        for table in ("runs ORDER BY id", "best", "front ORDER BY id", "study ORDER BY name"):
            self.assertEqual(
                self.rows("many/some.study.db", table), self.rows("one/some.study.db", table)
            )

    def test_faults_are_said_once(self):
        (self.folder / "bad.toml").write_text(SMALL.replace("coupler", "cuopler"))
        done = self.run_many(3, "sweep", "bad.toml")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("bad.toml:"), 1, done.stderr)
        done = self.run_many(2, "sweep", "small.toml", "--seed", "x")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("--seed: 'x'"), 1, done.stderr)

    def test_interrupted_and_gone_on_with(self):
        running = subprocess.Popen(
            ["mpirun", "--oversubscribe", "-n", "2", PROGRAM, "sweep", "long.toml"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=MPI,
        )
        self.wait_for_rows("long.study.db")
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=60)
        self.assertRegex(errors, r"interrupted after [\d ]+ of 4 000 000 designs")
        kept = len(self.rows("long.study.db"))
        more = self.run_many(2, "sweep", "long.toml", "--json", "--time-limit", "0.3")
        self.assertGreater(json.loads(more.stdout)["counts"]["kept"], kept)


if __name__ == "__main__":
    SCHEMA = pathlib.Path(sys.argv.pop(2))
    PROGRAM = sys.argv.pop(1)
    unittest.main()
