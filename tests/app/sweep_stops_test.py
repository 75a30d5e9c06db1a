"""Studies that end early, or whose file was changed: what survives, and what is refused.

Run as: sweep_stops_test.py PROGRAM, the built program.
"""

import json
import os
import pathlib
import pty
import resource
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import unittest

from sweeps import LONG, PROGRAM, SMALL, Sweeps
from thinned import some

MPI = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    ASAN_OPTIONS="detect_leaks=0",
)


class Interrupted(Sweeps):
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
        second = self.run_program("sweep", "../" + self.folder.name + "/long.toml", "--out", self.folder)
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

    def test_interrupted_and_continued(self):
        (self.folder / "some.toml").write_text(LONG.replace("4000000", "6000"))
        running = self.start("sweep", "some.toml", "--quiet")
        self.wait_for_rows("some.study.db")
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 0)
        self.assertRegex(errors, r"interrupted after [\d ]+ of 6 000 designs; the same command continues")
        part = self.rows("some.study.db")
        self.assertGreater(len(part), 0)
        self.assertLess(len(part), 6000)
        self.assertFalse((self.folder / "some.study.lock").exists())
        done = self.run_program("sweep", "some.toml", "--threads", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("continued after", done.stdout)
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
        more = self.run_program("sweep", "long.toml", "--time-limit", "2", "--json")
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


class ChangedStudyFile(Sweeps):
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
        chosen = some(enumerate(strokes))
        for number, stroke in chosen:
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
        self.assertEqual(found, len(chosen))
        first = self.rows("bits.study.db")[0][0]
        self.expect_refusal(
            self.run_program("export", "bits.study.db", "--row", first), "are not those that were stored"
        )
        file.write_bytes(whole)
        self.assertEqual(self.run_program("sweep", "bits.toml").returncode, 0)

    def test_file_of_before_checksums_is_continued(self):
        self.run_program("sweep", "small.toml", "--json")
        rows = self.rows("small.study.db")
        with sqlite3.connect(self.folder / "small.study.db") as database:
            database.execute("DROP TABLE checksums")
        again = self.run_program("sweep", "small.toml")
        self.assertEqual((again.returncode, again.stderr), (0, ""))
        self.assertIn("blocks of rows have no checksums", again.stdout)
        self.assertEqual(self.rows("small.study.db"), rows)


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

    def test_interrupted_and_continued(self):
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
    del sys.argv[1]
    unittest.main()
