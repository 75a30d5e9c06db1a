"""The type stubs say what the module has, and what users write with it is checked by them.

Run as: stubs_test.py, with the module on PYTHONPATH; skipped without mypy and its stubtest.
"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import cognate

PACKAGE = pathlib.Path(cognate.__file__).parent

GOOD = """
import cognate
bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3)
cognate.solve("x.toml", seed=3, target={"points": [[0, 0]]}).best.error.rms
cognate.exact.cognates(bar)[0][0].curve([0.0, 1.0]).shape
bar.positions(1.0, points=["B"], threads=None)["B"]
"""

BAD = {
    'cognate.FourBar(crank=1)': "fixed_pivots",
    'cognate.SliderCrank(crank="1", coupler=3)': "crank",
    'cognate.solve("x.toml", sed=3.5).desings': "desings",
    'cognate.solve("x.toml", seed=3.5)': "seed",
}


@unittest.skipUnless(shutil.which("stubtest") and shutil.which("mypy"), "there is no mypy")
class StubsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def run_tool(self, *arguments):
        """All of them share mypy's cache, or each would read numpy's types again."""
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent),
                       "MYPY_CACHE_DIR": self.folder.name}
        return subprocess.run(arguments, cwd=self.folder.name, env=environment, capture_output=True,
                              text=True)

    def test_stubs_are_those_of_the_module(self):
        ran = self.run_tool("stubtest", "cognate")
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)

    def test_the_package_is_sound(self):
        ran = self.run_tool("mypy", "--strict", "-p", "cognate")
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)

    def test_users_get_the_types(self):
        ran = self.run_tool("mypy", "--strict", "-c", GOOD)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        ran = self.run_tool("mypy", "-c", "\n".join(["import cognate", *BAD]))
        self.assertEqual(ran.returncode, 1, ran.stdout + ran.stderr)
        for line, (code, named) in enumerate(BAD.items(), 2):
            errors = [said for said in ran.stdout.splitlines() if said.startswith(f"<string>:{line}:")]
            self.assertTrue(any(named in said for said in errors), f"{code}: {ran.stdout}")


if __name__ == "__main__":
    unittest.main()
