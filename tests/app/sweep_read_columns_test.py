"""Rows of studies read from columns in HDF5: the answers are those from the database, and what is no file of columns is refused.

Run as: sweep_read_columns_test.py PROGRAM, the built program.
"""

import json
import os
import pathlib
import random
import re
import shutil
import sqlite3
import subprocess
import sys
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from sweeps import PROGRAM, SMALL, Sweeps  # noqa: E402
from thinned import some  # noqa: E402

try:
    import h5py
    import numpy

    import columns_by_hand as by_hand
except ImportError:
    h5py = None

MODULE = pathlib.Path(PROGRAM).resolve().parent / "cognate-columns.so"

FRONT = SMALL.replace('maximize = "output_stroke"', 'maximize = ["output_stroke", "time_ratio"]')
STUDIES = {
    "one": SMALL,
    "front": FRONT,
    "all": FRONT.replace("[output]", '[output]\nrows = "all"'),
    "none": SMALL.replace("{ min = 30 }", "{ min = 89.9999 }"),
    "free": 'title = "Größe, 尺寸"\n' + SMALL[: SMALL.index("[objective]")],
}
TABLES = ("runs ORDER BY id", "best", "front ORDER BY id", "study ORDER BY rowid", "blocks", "checksums")
DATA = re.compile(r'<script type="application/json" id="data">(.*?)</script>', re.DOTALL)


@unittest.skipUnless(h5py, "python3-h5py is missing")
@unittest.skipUnless(MODULE.exists(), "built without HDF5")
class ReadColumns(Sweeps):
    def sweep(self, name, text, out="out", *arguments):
        (self.folder / f"{name}.toml").write_text(text)
        done = self.run_program("sweep", f"{name}.toml", "--out", out, "--format", "hdf5", "--json", *arguments)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def merge(self, name, *files, out="again"):
        named = [word for file in files for word in ("--merge", file)]
        return self.run_program("sweep", f"{name}.toml", "--json", "--out", out, *named)

    def merged(self, name, *files, out="again"):
        done = self.merge(name, *files, out=out)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def export(self, file, row):
        return self.run_program("export", file, "--row", row, "--out", "exported", "--json")

    def exported(self, file, row):
        done = self.export(file, row)
        self.assertEqual(done.returncode, 0, done.stderr)
        document = json.loads(done.stdout)
        self.assertEqual((document["study"], document["row"]), (file, row))
        return (self.folder / document["files"][0]).read_bytes()

    def tables(self, file):
        return [self.rows(file, table) for table in TABLES]

    def page(self, file):
        """What the page shows, without how long it took and the file that it names."""
        data = json.loads(DATA.search((self.folder / file).read_text()).group(1))
        for key in ("work", "notes"):
            data.pop(key, None), data.get("result", {}).pop(key, None)
        return {key: value for key, value in data.items() if key != "database"}

    def test_exported_rows_are_those_of_the_database(self):
        for name in ("front", "all", "free"):
            self.sweep(name, STUDIES[name])
            with h5py.File(self.folder / f"out/{name}.study.h5") as file:
                runs = {key: file["runs"][key][:] for key in ("id", "mechanism.coupler", "mechanism.offset")}
            for place, row in enumerate(map(int, runs["id"])):
                if place % 5 == 0:
                    text = self.exported(f"out/{name}.study.h5", row)
                    self.assertEqual(text, self.exported(f"out/{name}.study.db", row))
                    mechanism = tomllib.loads(text.decode())["mechanism"]
                    self.assertEqual(mechanism["coupler"], runs["mechanism.coupler"][place])
                    self.assertEqual(mechanism["offset"], runs["mechanism.offset"][place])

    def test_rows_that_were_not_kept_are_missed_in_both(self):
        self.sweep("one", SMALL)
        kept = {row[0] for row in self.rows("out/one.study.db")}
        missing = next(row for row in range(63) if row not in kept)
        for row in (missing, 63, 10**15):
            for ending in ("db", "h5"):
                self.expect_refusal(self.export(f"out/one.study.{ending}", row), f"one.study.{ending}", f"has no row {row}")

    def test_rows_of_many_blocks_are_found(self):
        text = (self.folder / "long.toml").read_text().replace("4000000", "2000").replace("[output]", '[filter]\noutput_stroke = [2.005, 9]\n[output]')
        self.sweep("long", text)
        file = "out/long.study"
        blocks = self.rows(f"{file}.db", "blocks ORDER BY first")
        self.assertGreater(len(blocks), 5)
        kept = [row[0] for row in self.rows(f"{file}.db")]
        self.assertLess(len(kept), 2000)
        for first, count, *_ in blocks[:: len(blocks) // 5]:
            for row in (first, first + count // 2, first + count - 1):
                if row in kept:
                    self.assertEqual(self.exported(f"{file}.h5", row), self.exported(f"{file}.db", row))
                else:
                    self.expect_refusal(self.export(f"{file}.h5", row), f"has no row {row}")
        self.merged("long", f"{file}.h5")
        self.assertEqual(self.tables(f"{file}.db"), self.tables("again/long.study.db"))

    def test_a_study_taken_over_is_the_same_in_tables_front_and_page(self):
        for name, text in STUDIES.items():
            with self.subTest(name):
                first = self.sweep(name, text)
                again = self.merged(name, f"out/{name}.study.h5", out=f"again-{name}")
                self.assertEqual(again["work"]["designs"], 0)
                for key in ("study", "counts", "best", "status", "seed"):
                    self.assertEqual(first[key], again[key])
                self.assertEqual(self.tables(f"out/{name}.study.db"), self.tables(f"again-{name}/{name}.study.db"))
                self.assertEqual(self.page(f"out/{name}.report.html"), self.page(f"again-{name}/{name}.report.html"))

    def test_parts_of_both_kinds_are_the_whole(self):
        self.sweep("all", STUDIES["all"], "whole")
        for number in (1, 2, 3):
            self.sweep("all", STUDIES["all"], f"part-{number}", "--part", f"{number}/4")
        files = ["part-3/all.study.h5", "part-1/all.study.db", "part-2/all.study.h5"]
        merged = self.merged("all", *files)
        self.assertEqual(merged["work"]["designs"], 63 - sum(len(self.rows(file.replace("h5", "db"))) for file in files))
        for table in TABLES[:3]:
            self.assertEqual(self.rows("whole/all.study.db", table), self.rows("again/all.study.db", table))

    def test_columns_can_be_where_no_lock_can_be_made(self):
        self.sweep("one", SMALL, "there")
        os.chmod(self.folder / "there", 0o555)
        self.addCleanup(os.chmod, self.folder / "there", 0o755)
        before = sorted(os.listdir(self.folder / "there"))
        self.assertEqual(self.merged("one", "there/one.study.h5")["work"]["designs"], 0)
        self.assertEqual(sorted(os.listdir(self.folder / "there")), before)

    def test_files_made_by_hand_are_read(self):
        for name in ("all", "one", "none"):
            self.sweep(name, STUDIES[name])
            tables = by_hand.tables_of(self.folder / f"out/{name}.study.db")
            for compressed in (False, True):
                by_hand.write_by_hand(self.folder / "hand.study.h5", tables, compressed=compressed, big_endian=compressed)
                self.merged(name, "hand.study.h5", out=f"hand-{name}-{compressed}")
                self.assertEqual(self.tables(f"out/{name}.study.db"), self.tables(f"hand-{name}-{compressed}/{name}.study.db"))
                for row in tables[1][::20]:
                    text = self.exported("hand.study.h5", row[0])
                    self.assertEqual(text, self.exported(f"out/{name}.study.db", row[0]))

    def test_rows_without_checksums_are_said_to_be_so(self):
        self.sweep("all", STUDIES["all"])
        tables = by_hand.tables_of(self.folder / "out/all.study.db")
        by_hand.write_by_hand(self.folder / "hand.study.h5", tables, checksums=False)
        self.assertIn("no checksums", " ".join(self.merged("all", "hand.study.h5")["notes"]))
        self.assertEqual(self.rows("out/all.study.db"), self.rows("again/all.study.db"))

    def test_numbers_and_empty_words_among_words_keep_their_kind(self):
        self.sweep("all", STUDIES["all"])
        names, rows, study, blocks, front = by_hand.tables_of(self.folder / "out/all.study.db")
        values = ["", None, -0.0, 1 / 3, 5e-324, "1.5", "é尺", "nan", 1e300, "x" * 40]
        place = names.index("class")
        rows = [row[:place] + (values[row[0] % len(values)],) + row[place + 1 :] for row in rows]
        by_hand.write_by_hand(self.folder / "hand.study.h5", (names, rows, study, blocks, front))
        # Taken over by the program, and written by it again.
        (self.folder / "again").mkdir()
        done = self.run_program("sweep", "all.toml", "--json", "--out", "again", "--merge", "hand.study.h5", "--format", "hdf5")
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(self.folder / "again/all.study.h5") as file:
            kinds = list(file["kinds/class"][:])
            words = [word.decode() for word in file["runs/class"][:]]
        stored = [(row[0], row[place]) for row in self.rows("again/all.study.db")]
        self.assertEqual([repr(value) for _, value in stored], [repr(row[place]) for row in rows])
        self.assertEqual(kinds, [by_hand.kind_of(value) for _, value in stored])
        for word, kind, (_, value) in zip(words, kinds, stored):
            self.assertEqual(repr(float(word)) if kind == 1 else word or None, repr(value) if kind == 1 else value or None)
        self.merged("all", "again/all.study.h5", out="third")
        self.assertEqual(self.tables("again/all.study.db"), self.tables("third/all.study.db"))

    def test_an_atlas_may_be_columns(self):
        base = """kind = "analysis"\n[mechanism]\ntype = "four-bar"\nfixed_pivots = [[0, 0], [3, 0]]\ncrank = 1.0
coupler = 3.0\nrocker = 2.5\ncoupler_point = [1, 1]\n"""
        names = [f'"fourier.{sign}{k}"' for sign in "mp" for k in range(1, 5)]
        names += [f'"fourier_phase_deg.{sign}{k}"' for sign in "mp" for k in range(2, 5)]
        vary = "".join(
            f'[[vary]]\nkey = "mechanism.{key}"\nrange = [{low}, {high}]\nsteps = 6\n'
            for key, low, high in (("coupler", 2, 4), ("rocker", 2, 4), ("coupler_point[0]", -1, 3), ("coupler_point[1]", 0, 3))
        )
        (self.folder / "base.toml").write_text(base)
        self.sweep("atlas", f'base = "base.toml"\n{vary}[output]\nmetrics = [{", ".join(names)}]\n', ".")
        points = "[[0, 0], [2, 0.5], [3, 2], [2, 3], [0, 2.5], [-1, 1]]"
        results = []
        for ending in ("db", "h5"):
            (self.folder / "path.toml").write_text(
                f'kind = "path-generation"\n[target]\ncurve = {points}\n'
                f'[solve]\natlas = "atlas.study.{ending}"\nstarts = 1\n'
            )
            done = self.run_program("solve", "path.toml", "--json", "--threads", "1")
            self.assertEqual(done.returncode, 0, done.stderr)
            results.append(json.loads(done.stdout)["designs"])
        self.assertEqual(*results)

    def test_no_run_goes_on_with_columns(self):
        self.sweep("one", SMALL)
        for ending in ("h5", "db"):
            done = self.run_program("sweep", f"out/one.study.{ending}")
            self.expect_refusal(done, f"out/one.study.{ending}' holds rows", "NAME.toml", "--merge")
        (self.folder / "out/one.study.db").unlink()
        before = (self.folder / "out/one.study.h5").read_bytes()
        done = self.run_program("sweep", "one.toml", "--out", "out", "--format", "hdf5")
        self.expect_refusal(done, "one.study.h5' may hold rows", "--merge", "remove it")
        self.assertEqual((self.folder / "out/one.study.h5").read_bytes(), before)
        self.assertFalse((self.folder / "out/one.study.db").exists())
        done = self.run_program("sweep", "one.toml", "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "note: '.*one.study.h5' may hold rows")
        (self.folder / "out/one.study.db").unlink()
        again = self.sweep("one", SMALL, "out", "--merge", "out/one.study.h5")
        self.assertEqual(again["work"]["designs"], 0)

    def test_a_program_without_the_module_says_what_is_missing(self):
        self.sweep("one", SMALL)
        (self.folder / "alone").mkdir()
        shutil.copy(PROGRAM, self.folder / "alone")
        for arguments in (["export", "out/one.study.h5", "--row", "1"], ["sweep", "one.toml", "--out", "x", "--merge", "out/one.study.h5"]):
            done = subprocess.run([self.folder / "alone/cognate", *arguments], cwd=self.folder, capture_output=True, text=True)
            self.expect_refusal(done, "one.study.h5", "libhdf5-dev")

    def expect_both_refuse(self, file, row, *parts):
        self.expect_refusal(self.export(file, row), file, *parts)
        self.expect_refusal(self.merge("all", file, out="refused"), file, *parts)
        self.assertFalse((self.folder / "refused/all.study.db").exists())

    def test_what_is_no_file_of_columns_is_refused(self):
        self.sweep("all", STUDIES["all"])
        valid = (self.folder / "out/all.study.h5").read_bytes()
        row = self.rows("out/all.study.db")[0][0]
        rng = random.Random(1)
        for size in [0, 1, 8, 48, 96, len(valid) - 1, *some(rng.randrange(len(valid)) for _ in range(20))]:
            (self.folder / "cut.study.h5").write_bytes(valid[:size])
            self.expect_refusal(self.export("cut.study.h5", row), "cut.study.h5", "HDF5")
        (self.folder / "text.study.h5").write_text('base = "slider.toml"\n' * 10)
        self.expect_both_refuse("text.study.h5", row, "is no file of HDF5")
        with h5py.File(self.folder / "other.h5", "w") as file:
            file["temperature"] = numpy.arange(10)
        self.expect_both_refuse("other.h5", row, "has no columns of a study")
        (self.folder / "folder.study.h5").mkdir()
        self.expect_refusal(self.export("folder.study.h5", row), "folder.study.h5", "is no regular file")
        os.mkfifo(self.folder / "pipe.study.h5")
        self.expect_refusal(self.export("pipe.study.h5", row), "pipe.study.h5", "is no regular file")
        self.expect_refusal(self.export("absent.study.h5", row), "absent.study.h5", "is not there")
        # What is not what its name says is what it is.
        shutil.copy(self.folder / "out/all.study.h5", self.folder / "named.study.db")
        self.assertEqual(self.exported("named.study.db", row), self.exported("out/all.study.h5", row))

    def change(self, change):
        shutil.copy(self.folder / "out/all.study.h5", self.folder / "bad.study.h5")
        with h5py.File(self.folder / "bad.study.h5", "r+") as file:
            change(file)

    def test_columns_that_are_not_as_they_must_be_are_refused(self):
        self.sweep("all", STUDIES["all"])
        row = self.rows("out/all.study.db")[0][0]

        def replaced(name, data):
            def change(file):
                del file[name]
                file[name] = data

            return change

        def without(name):
            return lambda file: file.__delitem__(name)

        def changed(name, place, value):
            return lambda file: file[name].__setitem__(place, value)

        def version(word):
            return lambda file: file.attrs.__setitem__("format", numpy.bytes_(word))

        numbers = numpy.arange(63.0)
        rows = len(self.rows("out/all.study.db"))
        self.assertEqual(rows, 63)
        text = next(text for name, text in self.rows("out/all.study.db", "study") if name == "base")
        cases = [
            (lambda file: file.attrs.__delitem__("format"), "cognate-study-columns/1", "cognate-study-columns/2"),
            (version(b"cognate-study-columns/3"), "cognate-study-columns/3"),
            (version(b"something"), "no columns of a study"),
            (lambda file: file.attrs.__setitem__("format", 2), "its format"),
            (without("runs/id"), "no dataset runs/id"),
            (without("runs/time_ratio"), "no dataset runs/time_ratio"),
            (without("runs/status"), "no dataset runs/status"),
            (without("runs"), "no dataset runs/id"),
            (without("kinds"), "no group kinds"),
            (without("blocks/kept"), "no dataset blocks/kept"),
            (without("blocks"), "no dataset blocks/first"),
            (without("study/base"), "no dataset study/base"),
            (without("study"), "study"),
            (lambda file: file["study"].attrs.__delitem__("checksum"), "study@checksum"),
            (lambda file: file["study"].attrs.__setitem__("checksum", "a"), "study@checksum"),
            (replaced("runs/time_ratio", numbers[:62]), "has 62 rows in runs/time_ratio, and 63"),
            (replaced("runs/id", numpy.arange(62)), "63"),
            (replaced("runs/status", numpy.array([b"solved"] * 64)), "64 rows"),
            (replaced("blocks/kept", numpy.arange(500)), "different lengths"),
            (replaced("runs/time_ratio", numbers.astype("f4")), "doubles"),
            (replaced("runs/time_ratio", numbers.astype("i8")), "doubles"),
            (replaced("runs/time_ratio", numbers.reshape(7, 9)), "no list"),
            (replaced("runs/time_ratio", 1.0), "no list"),
            (replaced("runs/class", ["word"] * 63), "words of fixed length"),
            (replaced("runs/id", numbers), "64-bit integers"),
            (replaced("runs/id", numpy.arange(63, dtype="u8")), "64-bit integers"),
            (replaced("runs/id", numpy.arange(63, dtype="i4")), "64-bit integers"),
            (replaced("study/seed", 1), "one text"),
            (replaced("study/seed", "1"), "one text"),
            (replaced("study/seed", numpy.array([b"1", b"1"])), "one text"),
            (replaced("study/base", numpy.bytes_(text.replace("3", "4").encode())), "not that which was stored"),
            (replaced("study/variables", numpy.bytes_(b"[1]")), "not that which was stored"),
            (changed("runs/mechanism.coupler", 0, numpy.nan), "not those that were stored"),
            (changed("runs/mechanism.coupler", 0, numpy.inf), "infinite mechanism.coupler"),
            (changed("runs/time_ratio", 0, -numpy.inf), "infinite time_ratio"),
            (changed("runs/time_ratio", 0, 0.5), "not those that were stored"),
            (changed("runs/status", 0, b"solvent"), "status"),
            (changed("runs/id", 0, 1), "not those of its blocks"),
            (changed("runs/id", 0, -1), "not those of its blocks"),
            (changed("blocks/count", 0, 0), "blocks overlap"),
            (changed("blocks/count", 0, 2**62), "blocks overlap"),
            (changed("blocks/first", 0, -(2**63)), "blocks overlap"),
            (changed("blocks/kept", 0, -1), "not those of its blocks"),
            (changed("blocks/solved", 0, 77), "not those that were stored"),
        ]
        for change, *parts in some(cases):
            with self.subTest(parts):
                self.change(change)
                if parts == ["status"]:
                    parts = ["bad.study.h5"]
                self.expect_both_refuse("bad.study.h5", row, *parts)
        self.change(changed("front", 0, 5))
        self.expect_refusal(self.merge("all", "bad.study.h5", out="refused"), "front is not that of its rows")

    def test_definitions_that_are_no_study_are_refused(self):
        self.sweep("all", STUDIES["all"])
        names, rows, study, blocks, front = by_hand.tables_of(self.folder / "out/all.study.db")
        for name, text in {
            "variables": "{", "metrics": '{"a": 1}', "objectives": '["a"]', "designs": "-5", "base": "",
            "format": "cognate-study-file/9", "study": "other", "seed": "2", "version": "0.0.0",
        }.items():
            with self.subTest(name):
                changed = [(key, text if key == name else value) for key, value in study]
                try:
                    by_hand.write_by_hand(self.folder / "bad.study.h5", (names, rows, changed, blocks, front))
                except ValueError:
                    continue
                self.expect_refusal(self.merge("all", "bad.study.h5", out="refused"), "bad.study.h5")
                done = self.export("bad.study.h5", rows[0][0])
                self.assertIn(done.returncode, (0, 2), done.stderr)

    def test_changed_bytes_give_the_same_answer_or_a_refusal(self):
        self.sweep("all", STUDIES["all"])
        valid = (self.folder / "out/all.study.h5").read_bytes()
        row = self.rows("out/all.study.db")[7][0]
        right = self.exported("out/all.study.db", row)
        rng = random.Random(7)
        for number in some(range(100)):
            data = bytearray(valid)
            for _ in range(rng.choice([1, 1, 2, 8])):
                data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
            (self.folder / "bad.study.h5").write_bytes(data)
            done = self.export("bad.study.h5", row)
            if done.returncode == 0:
                self.assertEqual((self.folder / json.loads(done.stdout)["files"][0]).read_bytes(), right)
            else:
                self.expect_refusal(done, "bad.study.h5")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
