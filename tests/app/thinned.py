"""Of many cases of one sort an ordinary run takes every third, of starts of a search fewer; with WHOLE in the
environment all."""

import os
import unittest

WHOLE = "WHOLE" in os.environ

whole_only = unittest.skipUnless(WHOLE, "with WHOLE in the environment alone")


def some(cases):
    cases = list(cases)
    return cases if WHOLE else cases[::3]


def ordinarily(few, many):
    """Of starts of a search few in an ordinary run, and many where its quality is looked at as well."""
    return many if WHOLE else few
