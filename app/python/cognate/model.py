"""Models of your own, for any of the solvers and for the search from many starts.

>>> import numpy as np
>>> ellipse = Model({"t": (-4, 4)}, lambda x: [3 * np.cos(x[0]) - 1, np.sin(x[0]) - 2])
>>> found = search(ellipse, starts=50, seed=7)
>>> found.status
'solved'
"""

from __future__ import annotations

import typing
from collections import abc
from typing import Any, Optional, Union

from . import _core
from ._errors import ProblemError
from ._progress import Progress, shown
from ._result import Values

Function = abc.Callable[[Any], Any]
SOLVERS: tuple[str, ...] = _core.SOLVERS
"""Names of the solvers."""


class Model:
    """A nonlinear program: least sum of squares, or greatest magnitude, of residuals.

    Parameters
    ----------
    variables
        ``{"name": (lower, upper)}`` or ``{"name": (lower, upper, scale)}``; bounds may be infinite.
    residuals
        A function of an array (n,) that returns (m,) numbers, or None where there is no value.
    jacobian
        Of the residuals, (m, n); central differences by default.
    constraints
        A function that returns (k,) numbers that must be at least 0, the first ``equalities`` of
        them 0. Defined everywhere within the bounds.
    constraint_jacobian
        (k, n); central differences by default.
    objective
        ``"sum-of-squares"`` or ``"max-abs"``.
    """

    def __init__(self, variables: abc.Mapping[str, abc.Sequence[float]], residuals: Function, *,
                 jacobian: Optional[Function] = None, constraints: Optional[Function] = None,
                 constraint_jacobian: Optional[Function] = None, equalities: int = 0,
                 objective: str = "sum-of-squares") -> None:
        if not isinstance(variables, abc.Mapping):
            raise _fault("variables", f"are of the type {type(variables).__name__}; expected "
                         '{"name": (lower, upper)}')
        self.variables = [_variable(name, bounds) for name, bounds in variables.items()]
        self.residuals, self.jacobian = residuals, jacobian
        self.constraints, self.constraint_jacobian = constraints, constraint_jacobian
        self.equalities = equalities
        self.objective = objective
        for name in ("residuals", "jacobian", "constraints", "constraint_jacobian"):
            function = getattr(self, name)
            if function is not None and not callable(function):
                raise _fault(name, "is no function; expected a function of an array")
        if not callable(residuals):
            raise _fault("residuals", "is no function; expected a function of an array")
        if objective not in ("sum-of-squares", "max-abs"):
            raise _fault("objective",
                         f'is {objective!r}; allowed are "sum-of-squares" and "max-abs"')

    def _tables(self) -> dict[str, Any]:
        return {**vars(self)}


class Minimum(typing.NamedTuple):
    """A local minimum of a model."""

    x: Any
    """(n,)"""
    objective: float
    """The sum of squares, or the greatest magnitude."""
    violation: float
    """The largest violation of a constraint or bound."""
    multipliers: Any
    """Of the constraints, (k,); empty where the solver has none."""
    stop: str
    """``"converged"``, ``"iteration-limit"``, ``"time-limit"``, ``"interrupted"``, ``"no-value"``,
    ``"infeasible"`` or ``"failed"``."""
    iterations: int
    evaluations: int
    hits: int
    """How many starts led here."""


class Search(typing.NamedTuple):
    """What a search found."""

    status: str
    minima: list[Minimum]
    """Different ones, best first, those within limits before others."""
    starts: int
    best_hits: int
    unseen: float
    """Estimated probability of a better minimum that was not seen (Good 1953)."""


def solve(model: Model, start: Any = None, *, solver: str = "auto", tolerance: float = 1e-12,
          iterations: int = 200, seed: int = 1, time_limit: Optional[float] = None) -> Minimum:
    """The local minimum that ``solver`` reaches from ``start`` (n,), the middle of the bounds without.

    What the model's functions raise is raised here. ``objective`` is NaN where the residuals have no
    value at the start (``stop`` is then ``"no-value"``).
    """
    run = {"seed": seed, "threads": None, "time_limit": time_limit}
    found = _core.solve_model(_tables(model), start, solver, tolerance, iterations, run)
    return Minimum(hits=1, **found)


def search(model: Model, *, start: Any = None, solver: str = "auto", starts: Optional[int] = None,
           designs: int = 10, seed: int = 1, threads: Optional[int] = 1,
           time_limit: Optional[float] = None, progress: Progress = None) -> Search:
    """Local minima from starts drawn evenly within the bounds, as many as the search's rule wants.

    The functions of the model hold the interpreter's lock, so that more ``threads`` seldom help.
    """
    with shown(progress) as report:
        run = {"seed": seed, "threads": threads, "time_limit": time_limit, "progress": report}
        found = _core.search_model(_tables(model), start, solver, starts, designs, run)
    found["minima"] = [Minimum(**minimum) for minimum in found["minima"]]
    return Search(**found)


def _variable(name: str, bounds: abc.Sequence[float]) -> tuple[str, float, float, float]:
    try:
        numbers = [float(number) for number in bounds]
    except (TypeError, ValueError):
        raise _fault(name, f"is {bounds!r}; expected (lower, upper) or (lower, upper, scale)") from None
    if len(numbers) not in (2, 3):
        raise _fault(name, f"has {len(numbers)} numbers; expected (lower, upper) or (lower, upper, "
                           "scale)")
    scale = numbers[2] if len(numbers) == 3 else 1.0
    return str(name), numbers[0], numbers[1], scale


def _tables(model: Union[Model, object]) -> dict[str, Any]:
    if not isinstance(model, Model):
        raise _fault("model", f"is of the type {type(model).__name__}; expected a cognate.Model")
    return model._tables()


def _fault(key: str, message: str) -> ProblemError:
    return ProblemError([(None, None, None, key, f"{key} {message}")])


__all__ = ["Minimum", "Model", "SOLVERS", "Search", "Values", "search", "solve"]
