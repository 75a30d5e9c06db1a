"""The server of `cognate studio` from outside: what it does.

Run as: studio_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

from studios import ENDLESS, PROGRAM, SHORT, Studio, Studios
from thinned import some

LIBRARY = pathlib.Path(sys.argv[2])


class StudioTest(Studios):
    def test_a_text_is_checked_as_the_program_checks_a_file(self):
        studio = self.serve()
        for text in (SHORT, "kind = \"cam\"\nfoot = 1\n", "", "kind = ", "\0", "kind = \"cam\"\n\x07",
                     (LIBRARY / "path" / "ten-point-ellipse.toml").read_text()):
            with self.subTest(text[:30]):
                answer = studio.document("/check", {"text": text})
                self.file.write_text(text)
                ran = subprocess.run([PROGRAM, "check", "--json", self.file], capture_output=True,
                                     text=True)
                expected = json.loads(ran.stdout)
                self.assertEqual(answer["valid"], ran.returncode == 0)
                self.assertEqual(answer["faults"], expected["faults"])
        self.ends_well(studio)

    def test_every_kind_is_solved_and_shown(self):
        studio = self.serve()
        names = [each for each in json.loads(re.search(
            r'id="data">(.*?)</script>', studio.ask("/")[2])[1])["templates"]]
        kinds = [each["name"] for each in names if each["name"].startswith("new/")]
        listed = json.loads(subprocess.run([PROGRAM, "list", "--json"], capture_output=True, text=True).stdout)
        self.assertEqual({f"new/{kind['name']}" for kind in listed["problem_kinds"]}, {*kinds, "new/study"})
        self.assertGreater(len(names), 60)
        for name in some(kinds):
            with self.subTest(name):
                text = studio.document(f"/template?name={name}")["text"]
                run = studio.document("/solve", {"text": text})["run"]
                state = studio.wait_until(lambda state: state["phase"] != "solving")
                self.assertEqual((state["run"], state["phase"]), (run, "done"), state)
                self.assertIn(state["status"], ("solved", "done"))
                self.assertEqual(state["report"], run)
                page = studio.ask("/report")[2]
                title = re.search(r'^title = "(.*?)"', text, re.M)
                self.assertIn(title[1] if title else "cognate-result/1", page)
        self.ends_well(studio)

    def test_the_result_is_that_of_solve(self):
        text = (LIBRARY / "path" / "ten-point-ellipse.toml").read_text()
        studio = self.serve(text, "--seed", "7", "--threads", "1")
        studio.document("/solve", {"text": text})
        studio.wait_until(lambda state: state["phase"] == "done")
        page = studio.ask("/report")[2]
        shown = json.loads(re.search(r'id="data">(.*?)</script>', page)[1])["result"]
        ran = subprocess.run([PROGRAM, "solve", "--json", "--seed", "7", self.file],
                             capture_output=True, text=True)
        expected = json.loads(ran.stdout)
        for document in (shown, expected):
            for name in ("seconds", "threads"):
                document["work"].pop(name)
        self.assertEqual(shown["seed"], 7)
        self.assertEqual(shown, expected)

    def test_a_fault_begins_nothing(self):
        studio = self.serve()
        status, _, text = studio.ask("/solve", {"text": "kind = \"cam\"\n"})
        self.assertEqual(status, 200)
        self.assertIn("follower.type is missing", text)
        self.assertNotIn("run", json.loads(text))
        status, _, text = studio.ask("/solve", {"text": 'kind = "study"\nbase = "problem.toml"\n'})
        self.assertEqual(status, 200)
        self.assertIn("cognate sweep", text)
        self.assertEqual(studio.document("/state")["phase"], "idle")
        self.assertEqual(studio.status("/report"), 404)

    def test_a_stopped_run_reports_what_it_found(self):
        studio = self.serve(ENDLESS)
        studio.document("/solve", {"text": ENDLESS})
        state = studio.wait_until(lambda state: state["best"] is not None)
        self.assertEqual(state["phase"], "solving")
        self.assertEqual((state["part"]["name"], state["part"]["is_last"]), ("search", True))
        self.assertGreaterEqual(state["part"]["seconds"], 0)
        left = studio.wait_until(lambda state: state["part"]["left"] is not None)["part"]["left"]
        self.assertGreater(left, 0)
        begun = time.monotonic()
        self.assertEqual(studio.status("/stop", {}), 200)
        state = studio.wait_until(lambda state: state["phase"] != "solving")
        self.assertLess(time.monotonic() - begun, 15)
        self.assertEqual((state["phase"], state["status"]), ("done", "interrupted"))
        self.assertIn("cognate-result/1", studio.ask("/report")[2])
        self.assertEqual(studio.status("/stop", {}), 200)  # of nothing
        self.ends_well(studio)

    def test_the_newest_request_ends_the_one_before(self):
        studio = self.serve(ENDLESS)
        for _ in range(4):
            studio.document("/solve", {"text": ENDLESS})
        last = studio.document("/solve", {"text": SHORT})["run"]
        self.assertEqual(last, 5)
        state = studio.wait_until(lambda state: state["phase"] != "solving")
        self.assertEqual((state["run"], state["phase"], state["report"]), (5, "done", 5))
        self.ends_well(studio)

    def test_a_time_limit_ends_a_run(self):
        studio = self.serve(ENDLESS, "--time-limit", "0.5")
        studio.document("/solve", {"text": ENDLESS})
        state = studio.wait_until(lambda state: state["phase"] == "done")
        self.assertEqual(state["status"], "time-limit")

    # The file

    def test_a_text_is_saved_as_it_stands(self):
        studio = self.serve()
        self.file.chmod(0o600)
        text = SHORT + "# Zähne – 齿数\r\n\t# end without a line's end"
        saved = studio.document("/save", {"text": text, "version": 1})
        self.assertEqual(saved, {"version": 2})
        self.assertEqual(self.file.read_bytes(), text.encode())
        self.assertEqual(self.file.stat().st_mode & 0o777, 0o600)
        self.assertEqual(os.listdir(self.folder), ["problem.toml"])
        self.assertEqual(studio.status("/save", {"text": "", "version": 1}), 409)
        self.assertEqual(self.file.read_bytes(), text.encode())

    def test_a_link_stays_one(self):
        real = self.folder / "real.toml"
        real.write_text(SHORT)
        link = self.folder / "link.toml"
        link.symlink_to("real.toml")
        studio = self.started(Studio(link))
        self.assertEqual(studio.status("/save", {"text": "a", "version": 1}), 200)
        self.assertTrue(link.is_symlink())
        self.assertEqual(real.read_text(), "a")

    def test_what_others_save_is_seen_and_not_overwritten(self):
        studio = self.serve()
        new = self.folder / "new"
        new.write_text(SHORT + "# by rename\n")
        new.rename(self.file)
        studio.wait_until(lambda state: state["file_version"] == 2, 10)
        self.assertEqual(studio.document("/file"), {"version": 2, "text": SHORT + "# by rename\n"})
        # Saved before anybody looked.
        self.file.write_text(SHORT + "# in place\n")
        self.assertEqual(studio.status("/save", {"text": "mine", "version": 2}), 409)
        self.assertEqual(self.file.read_text(), SHORT + "# in place\n")
        self.assertEqual(studio.document("/file")["version"], 3)
        # What cannot be edited leaves the version.
        self.file.write_bytes(b"\xff\xfe")
        time.sleep(0.5)
        self.assertEqual(studio.document("/file")["version"], 3)
        self.file.unlink()
        self.assertEqual(studio.status("/save", {"text": "again", "version": 3}), 200)
        self.assertEqual(self.file.read_text(), "again")

    def test_without_a_file_nothing_on_the_disk_is_touched(self):
        studio = self.started(Studio(cwd=self.folder))
        self.assertEqual(studio.status("/file"), 404)
        self.assertEqual(studio.status("/save", {"text": "a", "version": 0}), 404)
        (self.folder / "drawing.svg").write_text("<svg/>")
        (self.folder / "base.toml").write_text(SHORT)
        for text in ('kind = "path-generation"\n[target]\nsvg = "drawing.svg"\n',
                     'kind = "study"\nbase = "base.toml"\n'):
            faults = studio.document("/check", {"text": text})["faults"]
            self.assertIn("there is none", faults[0]["message"])
        self.assertEqual(sorted(os.listdir(self.folder)), ["base.toml", "drawing.svg"])

    def test_what_cannot_be_edited_is_refused(self):
        for name, content in (("binary.toml", b"\0\1\2"), ("latin.toml", b"# \xe9\n"),
                              ("large.toml", b"# x\n" * 200000)):
            (self.folder / name).write_bytes(content)
        for file in ("missing.toml", ".", "binary.toml", "latin.toml", "large.toml", "/dev/zero"):
            with self.subTest(file):
                ran = subprocess.run([PROGRAM, "studio", file, "--no-open"], cwd=self.folder,
                                     capture_output=True, text=True, timeout=20)
                self.assertEqual((ran.returncode, ran.stdout), (2, ""))
                self.assertIn("cannot edit", ran.stderr)

    def test_ports(self):
        taken = self.serve()
        for port in ("0", "-1", "65536", "x", str(taken.port)):
            with self.subTest(port):
                ran = subprocess.run([PROGRAM, "studio", "--no-open", "--port", port],
                                     capture_output=True, text=True, timeout=20)
                self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        taken.end()
        again = self.started(Studio(None, "--port", str(taken.port)))
        self.assertEqual(again.port, taken.port)
        self.assertNotEqual(again.token, taken.token)

    def test_an_interrupt_ends_it_while_it_solves(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            studio = self.serve(ENDLESS)
            studio.document("/solve", {"text": ENDLESS})
            studio.wait_until(lambda state: state["best"] is not None)
            begun = time.monotonic()
            self.assertEqual(studio.end(number), 0, studio.errors)
            self.assertLess(time.monotonic() - begun, 10)
            with self.assertRaises(OSError):
                studio.status("/state")


if __name__ == "__main__":
    del sys.argv[1:3]
    unittest.main()
