"""Rows of studies as columns in HDF5: those of the database, value by value, as h5py reads them.

Run as: sweep_columns_test.py PROGRAM, the built program.
"""

import json
import math
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from sweeps import PROGRAM, SLIDER, SMALL, Sweeps  # noqa: E402

try:
    import h5py

    import columns_by_hand as by_hand
except ImportError:
    h5py = None

MODULE = pathlib.Path(PROGRAM).resolve().parent / "cognate-columns.so"

FRONT = SMALL.replace('maximize = "output_stroke"', 'maximize = ["output_stroke", "time_ratio"]')
ALL = FRONT.replace("[output]", '[output]\nrows = "all"')
NONE = SMALL.replace("{ min = 30 }", "{ min = 89.9999 }")
TITLED = 'title = "Größe, 尺寸"\n' + ALL


@unittest.skipUnless(h5py, "python3-h5py is missing")
@unittest.skipUnless(MODULE.exists(), "built without HDF5")
class Columns(Sweeps):
    def sweep(self, text, *arguments, name="study"):
        (self.folder / f"{name}.toml").write_text(text)
        return self.run_program("sweep", f"{name}.toml", "--out", "out", "--format", "hdf5", "--json", *arguments)

    def assert_same_as_database(self, name="study"):
        rows = self.rows(f"out/{name}.study.db")
        stored = dict(self.rows(f"out/{name}.study.db", "study ORDER BY rowid"))
        with h5py.File(self.folder / f"out/{name}.study.h5") as file:
            runs = file["runs"]
            columns = [[decoded(value) for value in column[:]] for column in runs.values()]
            self.assertEqual(list(runs)[0], "id")
            self.assertEqual(list(runs)[-1], "status")
            variables, metrics = (json.loads(stored[key]) for key in ("variables", "metrics"))
            self.assertEqual(list(runs)[1:-1], variables + metrics)
            self.assertEqual({len(column) for column in columns}, {len(rows)})
            for row, values in zip(rows, zip(*columns)):
                self.assertEqual([exact(v) for v in row], [exact(v) for v in values])
            self.assertEqual({key: decoded(text[()]) for key, text in file["study"].items()}, stored)
            self.assertEqual("front" in file, len(json.loads(stored["objectives"])) > 1)
            if "front" in file:
                front = [row[0] for row in self.rows(f"out/{name}.study.db", "front ORDER BY id")]
                self.assertEqual([int(row) for row in file["front"]], front)
            self.assert_blocks(file, rows, self.rows(f"out/{name}.study.db", "blocks ORDER BY first"))
            self.assertEqual(int(file["study"].attrs["checksum"]), by_hand.texts_checksum(stored.items()))
            self.assertEqual(decoded(file.attrs["format"]), "cognate-study-columns/2")
            self.assertEqual(list(file["kinds"]), [])
            units = {key: decoded(column.attrs["unit"]) for key, column in runs.items() if "unit" in column.attrs}
        return len(rows), units

    def assert_blocks(self, file, rows, blocks):
        names = [*by_hand.BLOCKS, "has_checksum", "checksum"]
        self.assertEqual(list(file["blocks"]), names)
        expected = [
            (*block, 1, by_hand.block_checksum(block, [row for row in rows if 0 <= row[0] - block[0] < block[1]]))
            for block in blocks
        ]
        self.assertEqual(list(zip(*(map(int, file["blocks"][name][:]) for name in names))), expected)

    def test_columns_have_every_value_of_the_rows(self):
        counts = {}
        for name, text in {"small": SMALL, "front": FRONT, "all": ALL, "none": NONE, "titled": TITLED}.items():
            done = self.sweep(text, name=name)
            self.assertEqual(done.returncode, 1 if name == "none" else 0, done.stderr)
            counts[name], units = self.assert_same_as_database(name)
        self.assertEqual(counts["none"], 0)
        self.assertEqual(counts["all"], 63)
        self.assertGreater(counts["small"], 10)
        self.assertLess(counts["small"], 63)

    def test_units_are_those_of_the_base(self):
        (self.folder / "slider.toml").write_text('length_unit = "mm"\n' + SLIDER)
        text = SMALL.replace('"time_ratio"]', '"time_ratio", "transmission_angle_deg.acute_min"]')
        self.assertEqual(self.sweep(text).returncode, 0)
        _, units = self.assert_same_as_database()
        lengths = ("mechanism.coupler", "mechanism.offset", "output_stroke")
        self.assertEqual(units, {**dict.fromkeys(lengths, "mm"), "transmission_angle_deg.acute_min": "deg"})

    def test_a_study_that_goes_on_has_new_columns(self):
        long = (self.folder / "long.toml").read_text().replace("4000000", "40000")
        self.assertEqual(self.sweep(long, "--time-limit", "0.3", name="long").returncode, 0)
        first, _ = self.assert_same_as_database("long")
        self.assertLess(first, 40000)
        self.assertEqual(self.sweep(long, "--time-limit", "0.3", name="long").returncode, 0)
        second, _ = self.assert_same_as_database("long")
        self.assertGreater(second, first)

    def test_without_the_option_there_are_none(self):
        (self.folder / "study.toml").write_text(SMALL)
        for more in ([], ["--format", "sqlite"]):
            self.run_program("sweep", "study.toml", "--out", "out", *more)
            self.assertEqual(sorted(os.listdir(self.folder / "out")), ["study.report.html", "study.study.db"])

    def test_what_cannot_be_written_leaves_the_file_that_was_there(self):
        long = (self.folder / "long.toml").read_text().replace("4000000", "3000")
        done = self.sweep(long)
        self.assertEqual(done.returncode, 0, done.stderr)
        file = self.folder / "out/study.study.h5"
        before = file.read_bytes()
        (self.folder / "out/study.report.html").unlink()

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (65536, 65536))

        done = subprocess.run(
            [PROGRAM, "sweep", "../study.toml", "--format", "hdf5", "--json"],
            cwd=self.folder / "out",
            capture_output=True,
            text=True,
            preexec_fn=small_files,
        )
        self.expect_refusal(done, "study.study.h5", "File too large")
        self.assertEqual(file.read_bytes(), before)
        self.assertEqual(sorted(os.listdir(self.folder / "out")), ["study.study.db", "study.study.h5"])

    def test_a_folder_in_its_place_is_refused_before_the_run(self):
        (self.folder / "out/study.study.h5").mkdir(parents=True)
        self.expect_refusal(self.sweep(SMALL), "study.study.h5", "Is a directory")
        self.assertFalse((self.folder / "out/study.study.db").exists())
        done = self.run_program("sweep", "study.toml", "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_bad_formats_are_refused(self):
        for word in ("csv", "", "HDF5"):
            done = self.run_program("sweep", "small.toml", "--format", word)
            self.expect_refusal(done, "--format", "hdf5")

    def test_a_program_without_the_module_says_what_is_missing(self):
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy(PROGRAM, alone)
        done = subprocess.run(
            [alone / "cognate", "sweep", "small.toml", "--format", "hdf5"],
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.expect_refusal(done, "libhdf5-dev")
        self.assertFalse((self.folder / "small.study.db").exists())


def decoded(value):
    return value.decode() if isinstance(value, bytes) else value


def exact(value):
    """With the sign of zero; nothing, an empty word and no number are the same."""
    if value is None or value == "" or (isinstance(value, float) and math.isnan(value)):
        return None
    return float(value).hex() if isinstance(value, float) else value if isinstance(value, str) else int(value)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
