"""Synthesis and analysis of planar mechanisms.

    import cognate

    result = cognate.solve("path.toml")            # or a dictionary, or keywords
    result.best.mechanism.curve()                  # arrays in, arrays out
    result                                         # in a notebook: the design moves

The keys are those of problem files; numbers are bit for bit those of
the program. Mechanisms of given dimensions are classes (:class:`FourBar` ... :class:`Chain`),
many at once :mod:`cognate.batch`, synthesis in closed form :mod:`cognate.exact`, searches over
models of your own :mod:`cognate.model`, studies :func:`sweep`.
"""

import atexit as _atexit

from . import _core, batch, exact, model
from ._core import __version__
from ._errors import Fault, ProblemError
from ._problems import analyze, check, export, list, load, solve
from ._result import Checked, Constraint, Design, Designs, Exported, Result, Values
from ._study import Study, sweep
from .mechanisms import (
    Chain,
    EllipticTrammel,
    FixedBlock,
    FourBar,
    GuideBar,
    Mechanism,
    OldhamCoupling,
    OscillatingBlock,
    ScotchYoke,
    SliderCrank,
    TangentGenerator,
    mechanism_of,
)
from .model import Model

# Threads that compute while the interpreter ends would be torn down in the midst of it.
_atexit.register(_core.end_all)

__all__ = [
    "Chain", "Checked", "Constraint", "Design", "Designs", "EllipticTrammel", "Exported", "Fault",
    "FixedBlock", "FourBar", "GuideBar", "Mechanism", "Model", "OldhamCoupling",
    "OscillatingBlock", "ProblemError", "Result", "ScotchYoke", "SliderCrank", "Study",
    "TangentGenerator", "Values", "analyze", "batch", "check", "exact", "export", "list", "load",
    "mechanism_of", "model", "solve", "sweep",
]
