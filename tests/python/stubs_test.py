"""The type stubs agree with the module, the examples of docstrings do what they say.

Run as: stubs_test.py, with the module on PYTHONPATH.
"""

import doctest
import importlib
import os
import pkgutil
import subprocess
import sys
import tempfile
import unittest

import cognate


class StubsTest(unittest.TestCase):
    def test_stubtest(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "MYPYPATH": os.path.dirname(os.path.dirname(cognate.__file__))}
            ran = subprocess.run([sys.executable, "-m", "mypy.stubtest", "cognate",
                                  "--ignore-missing-stub"], cwd=folder, env=environment,
                                 capture_output=True, text=True, timeout=300)
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)

    def test_examples(self):
        tried = 0
        for module in pkgutil.iter_modules(cognate.__path__):
            if module.name == "_core":
                continue
            results = doctest.testmod(importlib.import_module(f"cognate.{module.name}"))
            self.assertEqual(results.failed, 0, module.name)
            tried += results.attempted
        self.assertGreater(tried, 10)

    def test_everything_public_has_a_docstring(self):
        for name in cognate.__all__:
            self.assertTrue(getattr(cognate, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
