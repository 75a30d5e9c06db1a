"""Exported linkages for their tests: the results of the library, and what exports make of them."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
CYLINDERS = ("dump-body", "excavator-bucket")


def run(*arguments, cwd=None):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, text=True, timeout=60
    )


def distance_to_segment(p, a, b):
    p, a, b = complex(*p), complex(*a), complex(*b)
    way = b - a
    share = ((p - a) * way.conjugate()).real / abs(way) ** 2 if way else 0
    return abs(p - a - min(1, max(0, share)) * way)


class ExportedLinkages(unittest.TestCase):
    """Tests of what is exported of every analysis of the library."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.results, cls.made = [], {}
        for file in sorted((LIBRARY / "analysis").glob("*.toml")):
            done = run("analyze", file, "--quiet", "--out", "results", cwd=cls.folder)
            assert done.returncode == 0, done.stderr
            cls.results.append(cls.folder / "results" / f"{file.stem}.result.json")
        # A driving cylinder is no plate: tests of its own have its parts.
        cls.plates = [result for result in cls.results if result.name.split(".")[0] not in CYLINDERS]
        assert len(cls.plates) >= 20, cls.plates

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def export(self, result, form, *options):
        """The file that an export makes, once for all tests."""
        asked = (result, form, *options)
        if asked not in self.made:
            done = run("export", result, "--format", form, *options, "--out", f"made{len(self.made)}",
                       "--json", cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            (file,) = json.loads(done.stdout)["files"]
            self.made[asked] = self.folder / file
        return self.made[asked]

    def analysed(self, name, text):
        """The result of an analysis of this text."""
        (self.folder / f"{name}.toml").write_text('kind = "analysis"\n' + text)
        done = run("analyze", f"{name}.toml", "--quiet", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / f"{name}.result.json"

    def document(self, result, *options):
        return json.loads(self.export(result, "json", *options).read_text())

    def refusal(self, result, *options):
        done = run("export", result, *options, "--out", "refused", cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def named(self, name):
        return self.folder / "results" / f"{name}.result.json"
