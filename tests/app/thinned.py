"""Of many cases of one sort an ordinary run takes every third; with WHOLE in the environment all."""

import os
import unittest

WHOLE = "WHOLE" in os.environ

whole_only = unittest.skipUnless(WHOLE, "with WHOLE in the environment alone")


def some(cases):
    cases = list(cases)
    return cases if WHOLE else cases[::3]
