"""Exported solids for their tests: STEP read again by another program, STL by this one.

The third argument of a test is the program that reads STEP; without it solids are refused.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from exported_linkages import run

READER = sys.argv[3] if len(sys.argv) > 3 else None


def facets_of(text):
    corners = [tuple(map(float, line.split()[1:])) for line in text.splitlines() if line.startswith("vertex")]
    return [corners[i:i + 3] for i in range(0, len(corners), 3)]


def volume_of(facets):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
               for a, b, c in facets) / 6


class Solids(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def result(self, text, command="analyze"):
        """The result of a problem, by its text or the file of the library that has it."""
        file = text if isinstance(text, pathlib.Path) else self.folder / "one.toml"
        if file is not text:
            file.write_text(text)
        done = run(command, file, "--quiet", "--out", self.folder)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return self.folder / f"{file.stem}.result.json"

    def export(self, result, *options):
        done = run("export", result, *options, "--out", self.folder / "made", "--json", cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def refusal(self, result, *options):
        done = run("export", result, *options, "--out", self.folder / "refused")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def read(self, document):
        """The solids of the one STEP file of an export."""
        (file,) = [file for file in document["files"] if file.endswith(".step")]
        done = subprocess.run([READER, self.folder / file], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        (assembly,) = json.loads(done.stdout)
        self.assertTrue(all(solid["valid"] for solid in assembly["solids"]))
        return assembly

    def stl(self, document):
        return {file.split(".")[-2]: (self.folder / file).read_text() for file in document["files"]}

    def check_facets(self, text, volume, tolerance):
        facets = facets_of(text)
        edges = {}
        for facet in facets:
            for a, b in zip(facet, facet[1:] + facet[:1]):
                edges[a, b] = edges.get((a, b), 0) + 1
        self.assertTrue(all(edges.get((b, a)) == count == 1 for (a, b), count in edges.items()))
        self.assertAlmostEqual(volume_of(facets) / volume, 1, delta=tolerance)
        self.assertAlmostEqual(min(corner[2] for facet in facets for corner in facet), 0, 12)
