"""Studies in parts on several machines: their rows together are those of one run.

Run as: sweep_parts_test.py PROGRAM, the built program.
"""

import json
import pathlib
import random
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from sweeps import Sweeps  # noqa: E402

TABLES = ("runs ORDER BY id", "best", "front ORDER BY id", "study ORDER BY name")
DESIGNS = 63


class Parts(Sweeps):
    def sweep(self, out, *arguments, study="small.toml"):
        done = self.run_program("sweep", study, "--json", "--out", out, *arguments)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def file(self, out, study="small"):
        return f"{out}/{study}.study.db"

    def assert_same_rows(self, one, other, study="small"):
        for table in TABLES:
            rows = self.rows(self.file(one, study), table)
            self.assertEqual(rows, self.rows(self.file(other, study), table), table)
        self.assertTrue(self.rows(self.file(one, study)))
        counts = "count), sum(kept), sum(filtered), sum(solved), sum(infeasible), sum(no_solution), sum(invalid"
        query = f"(SELECT sum({counts}) FROM blocks)"
        self.assertEqual(self.rows(self.file(one, study), query), self.rows(self.file(other, study), query))

    def numbers(self, out):
        """The numbers of the designs whose blocks are stored."""
        blocks = self.rows(self.file(out), "blocks ORDER BY first")
        return [first + i for first, count, *_ in blocks for i in range(count)]

    def test_parts_have_each_design_once(self):
        for count in (1, 2, 5, 64, 100):
            found = []
            for number in range(1, count + 1):
                if count > 5 and number not in (1, 2, count // 2, count):
                    continue
                self.sweep(f"{count}-{number}", "--part", f"{number}/{count}")
                found += self.numbers(f"{count}-{number}")
            self.assertEqual(len(found), len(set(found)))
            if count <= 5:
                self.assertEqual(sorted(found), list(range(DESIGNS)))

    def test_merged_parts_are_the_whole_in_any_order(self):
        self.sweep("whole")
        rng = random.Random(5)
        for count in (2, 3, 7):
            for number in range(1, count + 1):
                self.sweep(f"{count}-{number}", "--part", f"{number}/{count}")
            others = [self.file(f"{count}-{number}") for number in range(1, count + 1)]
            rng.shuffle(others)
            merged = self.sweep(f"merged-{count}", *[word for other in others for word in ("--merge", other)])
            self.assertEqual(merged["work"]["designs"], 0)
            self.assert_same_rows("whole", f"merged-{count}")
            again = self.sweep(f"merged-{count}", "--merge", others[0])
            self.assertIn("0 designs taken over", " ".join(again["notes"]))
            self.assert_same_rows("whole", f"merged-{count}")

    def test_what_no_part_has_is_evaluated(self):
        whole = self.sweep("whole")
        self.sweep("two", "--part", "2/3")
        merged = self.sweep("merged", "--merge", self.file("two"))
        self.assert_same_rows("whole", "merged")
        self.assertEqual(merged["work"]["designs"], whole["work"]["designs"] - len(self.numbers("two")))
        # A part that is there already takes nothing over and goes on.
        self.sweep("two", "--merge", self.file("merged"))
        self.assert_same_rows("whole", "two")

    def test_a_front_of_two_objectives(self):
        text = (self.folder / "small.toml").read_text()
        text = text.replace('maximize = "output_stroke"', 'maximize = "output_stroke"\nminimize = "mechanism.coupler"')
        (self.folder / "two.toml").write_text(text)
        self.sweep("whole", study="two.toml")
        for number in (1, 2):
            self.sweep(f"{number}", "--part", f"{number}/2", study="two.toml")
        self.sweep("merged", "--merge", self.file("2", "two"), "--merge", self.file("1", "two"), study="two.toml")
        self.assertGreater(len(self.rows(self.file("whole", "two"), "front")), 1)
        self.assert_same_rows("whole", "merged", "two")

    def test_files_that_cannot_be_merged(self):
        self.sweep("sound", "--part", "1/2")
        self.sweep("seed", "--part", "2/2", "--seed", "2")
        other = (self.folder / "small.toml").read_text().replace("steps = 21", "steps = 20")
        (self.folder / "other").mkdir()
        (self.folder / "other" / "small.toml").write_text(other)
        shutil.copy(self.folder / "slider.toml", self.folder / "other")
        self.sweep("changed", study="other/small.toml")
        (self.folder / "text.study.db").write_text("no database")
        (self.folder / "empty.study.db").write_text("")
        damaged = bytearray((self.folder / self.file("sound")).read_bytes())
        place = damaged.rindex(b"solved")
        damaged[place - 3] ^= 0x10
        (self.folder / "damaged.study.db").write_bytes(damaged)
        before = {name: (self.folder / name).read_bytes() for name in ("text.study.db", "empty.study.db", "damaged.study.db")}
        for name, *words in ((self.file("seed"), "the seed (2 there, 1 here)"),
                             (self.file("changed"), "the study file (from line"),
                             ("text.study.db", "no study file"), ("empty.study.db", "is empty"), ("none.study.db", "is no file"),
                             ("damaged.study.db", "damaged"), ("sound", "is no file")):
            with self.subTest(name):
                done = self.run_program("sweep", "small.toml", "--json", "--out", "merged", "--merge", name)
                self.expect_refusal(done, *words)
        for name, content in before.items():
            self.assertEqual((self.folder / name).read_bytes(), content, name)
        own = self.run_program("sweep", "small.toml", "--json", "--out", "sound", "--merge", self.file("sound"))
        self.expect_refusal(own, "is the file of this run")

    def test_a_file_in_use_is_not_merged(self):
        running = self.start("sweep", "long.toml", "--quiet", "--out", "long")
        try:
            self.wait_for_rows("long/long.study.db")
            done = self.run_program("sweep", "long.toml", "--json", "--out", "other", "--merge", "long/long.study.db")
            self.expect_refusal(done, str(running.pid))
        finally:
            running.terminate()
            running.communicate(timeout=60)

    def test_parts_that_are_none(self):
        for part in ("0/2", "3/2", "a/2", "2", "1/0", "1/2/3", "-1/2", "1/", "/2", "", "1/1000001", "99999999999999999999/2"):
            with self.subTest(part):
                done = self.run_program("sweep", "small.toml", "--part", part)
                self.expect_refusal(done, "--part", "2/5")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
