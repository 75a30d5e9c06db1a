"""The examples of docstrings do what they say.

Run as: examples_test.py, with the module on PYTHONPATH.
"""

import doctest
import importlib
import pkgutil
import unittest

import cognate


class ExamplesTest(unittest.TestCase):
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
