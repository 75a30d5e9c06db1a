"""The installed package reads the columns that the installed program wrote.

Run as: columns_test.py PROGRAM LIBRARY, the installed program and the folder of library problems.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import cognate
import numpy


class Columns(unittest.TestCase):
    def test_columns(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "sweep", LIBRARY / "study/cam-size.toml", "--quiet", "--format", "hdf5",
                            "--out", folder], check=True, stdout=subprocess.DEVNULL)
            rows, columns = (cognate.Study(pathlib.Path(folder) / f"cam-size.study.{ending}").columns()
                             for ending in ("db", "h5"))
            self.assertEqual(list(rows), list(columns))
            for name, values in rows.items():
                numpy.testing.assert_array_equal(columns[name], values)


if __name__ == "__main__":
    PROGRAM, LIBRARY = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
