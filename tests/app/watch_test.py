"""`--watch`: a file is solved again whenever it is saved.

Run as: watch_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()

ENDLESS = """kind = "path-generation"
[target]
points = [[0, 0], [1, 0.3], [2, 0.1], [3, 1], [2, 2], [1, 1.5], [0.5, 1]]
[constraints]
class = "crank-rocker"
peak_acceleration_max = 1
[solve]
starts = 10000
"""
RETURN = """kind = "quick-return"
title = "{}"
[target]
time_ratio = 1.25
[mechanism]
rocker = 290
swing_deg = 34
"""


class Watch:
    """The program watching `file`; what it writes is read as it comes."""

    def __init__(self, command, file, *options):
        self.process = subprocess.Popen(
            [PROGRAM, command, "--watch", *options, file.name], cwd=file.parent, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler))
        self.texts = {"stdout": "", "stderr": ""}
        self.threads = [threading.Thread(target=self.read, args=(name,)) for name in self.texts]
        for thread in self.threads:
            thread.start()

    def read(self, name):
        for line in getattr(self.process, name):
            self.texts[name] += line

    def wait(self, name, pattern, count=1, seconds=60):
        """Waits until `pattern` has come `count` times."""
        ends = time.monotonic() + seconds
        while len(re.findall(pattern, self.texts[name])) < count:
            if time.monotonic() > ends or self.process.poll() is not None:
                raise AssertionError(f"{pattern}: {self.texts}")
            time.sleep(0.02)

    def end(self):
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(timeout=20)
        finally:
            self.process.kill()
            for thread in self.threads:
                thread.join()
            self.process.stdout.close()
            self.process.stderr.close()
        return self.process.returncode


class WatchTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "problem.toml"

    def watch(self, *arguments):
        watch = Watch(*arguments)
        self.addCleanup(lambda: watch.process.poll() is None and watch.end())
        return watch

    def save_by_rename(self, text):
        new = self.folder / ".new"
        new.write_text(text)
        self.file.unlink()  # some editors leave a moment without the file
        time.sleep(0.3)
        new.rename(self.file)

    def test_every_save_is_solved_and_written(self):
        self.file.write_text(RETURN.format("First"))
        watch = self.watch("solve", self.file)
        watch.wait("stderr", "watching problem.toml", 1)
        self.assertIn("First", watch.texts["stdout"])
        report = self.folder / "problem.report.html"
        self.assertIn("First", report.read_text())
        self.file.write_text(RETURN.format("Second"))
        watch.wait("stderr", "watching", 2)
        self.save_by_rename(RETURN.format("Third"))
        watch.wait("stderr", "watching", 3)
        self.assertIn("Third", report.read_text())
        found = re.findall(r"First|Second|Third", watch.texts["stdout"])
        self.assertEqual(list(dict.fromkeys(found)), ["First", "Second", "Third"])
        # A save of the same text is one, too.
        self.file.write_text(RETURN.format("Third"))
        watch.wait("stderr", "watching", 4)
        time.sleep(0.5)  # and nothing is solved that was not saved
        self.assertEqual(watch.texts["stderr"].count("watching"), 4)
        self.assertEqual(watch.end(), 0)

    def test_faults_are_said_and_waited_over(self):
        self.file.write_text("kind = \"cam\"\n")
        watch = self.watch("solve", self.file, "--json")
        watch.wait("stderr", "follower.type is missing")
        watch.wait("stdout", '"valid": false')
        self.file.write_bytes(b"\0\xff")
        watch.wait("stderr", "watching", 2)
        self.file.write_text(RETURN.format("Sound"))
        watch.wait("stdout", '"format": "cognate-result/1"')
        watch.wait("stderr", "watching", 3)
        self.file.write_text("kind = \"gear\"\n")
        watch.wait("stderr", "watching", 4)
        self.assertEqual(watch.end(), 2)

    def test_a_save_ends_the_run_before_unreported(self):
        self.file.write_text(ENDLESS)
        watch = self.watch("solve", self.file, "--out", "there")
        time.sleep(1.5)
        self.file.write_text(RETURN.format("Short"))
        watch.wait("stderr", "watching")
        self.assertNotIn("path", watch.texts["stdout"])
        self.assertIn("Short", watch.texts["stdout"])
        self.assertNotIn("interrupted", watch.texts["stderr"])
        self.assertIn("Short", (self.folder / "there" / "problem.report.html").read_text())
        self.assertEqual(watch.end(), 0)

    def test_an_interrupt_ends_a_run_and_reports_it(self):
        self.file.write_text(ENDLESS)
        watch = self.watch("solve", self.file)
        time.sleep(2)
        self.assertIn(watch.end(), (0, 1))
        self.assertIn("interrupted; what was found", watch.texts["stderr"])
        self.assertTrue((self.folder / "problem.result.json").exists())

    def test_analyses_are_watched_too(self):
        self.file.write_text((LIBRARY / "gear" / "shifted-9.toml").read_text())
        watch = self.watch("analyze", self.file)
        watch.wait("stderr", "watching")
        self.assertTrue((self.folder / "problem.result.json").exists())
        self.assertEqual(watch.end(), 0)

    def test_what_cannot_be_watched_is_refused(self):
        self.file.write_text(RETURN.format("a"))
        for arguments in (["solve", "--watch", self.file, self.file],
                          ["analyze", "--watch", "a.result.json"], ["solve", "--watch", "none.toml"],
                          ["check", "--watch", self.file]):
            ran = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True,
                                 text=True, timeout=20)
            self.assertEqual((ran.returncode, ran.stdout), (2, ""), ran.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    LIBRARY = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
