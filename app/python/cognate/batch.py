"""Many four-bars at many crank angles at once, on vector instructions.

Designs are one of

- a list of :class:`cognate.FourBar` with coupler points;
- an array (m, 10) with the columns of :data:`COLUMNS` (fastest in Fortran's order, of which nothing
  is copied; ``assembly`` is +1 for open and -1 for crossed);
- a dictionary, or a frame, with these columns.

Angles are counted from the directed line from A to D of each design, in radians. Results are arrays
in Fortran's order, the designs fastest: the kernel writes into them, and nothing is copied.

>>> import numpy as np
>>> designs = np.array([[0, 0, 4, 0, 1, 3.5, 3, 1, 1, 1], [0, 0, 4, 0, 1, 3.6, 3, 1, 1, 1]])
>>> positions(designs, np.linspace(0, 6, 50)).shape
(2, 50, 2)
"""

from __future__ import annotations

from collections import abc
from typing import Any, Optional

import numpy as np

from . import _core
from ._errors import ProblemError
from .mechanisms import Mechanism

COLUMNS: tuple[str, ...] = _core.DESIGN_COLUMNS
"""``pivot_a_x, pivot_a_y, pivot_d_x, pivot_d_y, crank, coupler, rocker, assembly, point_u,
point_v``"""

QUANTITIES: tuple[str, ...] = ("position", "velocity", "acceleration", "curvature",
                               "transmission_sin", "transmission_cos", "gradient")
"""What :func:`evaluate` computes."""

GRADIENT: tuple[str, ...] = ("pivot_a_x", "pivot_a_y", "pivot_d_x", "pivot_d_y", "crank", "coupler",
                             "rocker", "point_u", "point_v")
"""By what the columns of ``gradient`` are derivatives."""


def columns(designs: Any) -> dict[str, Any]:
    """The designs as a dictionary of columns (m,)."""
    if isinstance(designs, Mechanism):
        designs = [designs]
    if isinstance(designs, abc.Mapping) or hasattr(designs, "columns"):
        return {str(name): designs[name] for name in designs}
    if isinstance(designs, (list, tuple)) and not designs:
        designs = np.empty((0, len(COLUMNS)))
    if isinstance(designs, (list, tuple)) and isinstance(designs[0], Mechanism):
        designs = np.array([_row(i, design) for i, design in enumerate(designs)], order="F")
    try:
        array = np.asarray(designs, dtype=float)
    except (TypeError, ValueError) as error:
        raise _fault(f"designs are no array of numbers ({error}); expected shape "
                     f"(m, {len(COLUMNS)})") from None
    if array.ndim != 2 or array.shape[1] != len(COLUMNS):
        raise _fault(f"designs have the shape {array.shape}; expected (m, {len(COLUMNS)}), the "
                     f"columns {', '.join(COLUMNS)}")
    return {name: array[:, i] for i, name in enumerate(COLUMNS)}


def positions(designs: Any, angles: Any, *, out: Any = None, threads: Optional[int] = 1) -> Any:
    """The coupler points, (m, n, 2) for m designs and n angles.

    ``out`` is an array to be filled, ``numpy.empty((m, n, 2), order="F")``; ``threads`` None or 0
    means as many as the machine has. NaN where a design cannot be assembled.
    """
    given = {} if out is None else {"position": out}
    return evaluate(designs, angles, ["position"], out=given, threads=threads)["position"]


def evaluate(designs: Any, angles: Any, quantities: abc.Sequence[str] = ("position",), *,
             out: Optional[abc.Mapping[str, Any]] = None,
             threads: Optional[int] = 1) -> dict[str, Any]:
    """The requested quantities of m designs at n angles; no others are computed.

    ``position``, ``velocity`` and ``acceleration`` are (m, n, 2), the last two derivatives by the
    crank angle; ``curvature`` of the coupler curve, ``transmission_sin`` and ``transmission_cos``
    of the angle BCD are (m, n); ``gradient`` is (m, n, 2, 9), by the dimensions :data:`GRADIENT`.
    """
    wanted = [quantities] if isinstance(quantities, str) else quantities
    if not isinstance(wanted, (list, tuple, set, frozenset)):
        raise _fault(f"quantities are of the type {type(wanted).__name__}; expected a list of names",
                     "quantities")
    if out is not None and not isinstance(out, abc.Mapping):
        raise _fault(f"out is of the type {type(out).__name__}; expected a dictionary of arrays",
                     "out")
    return _core.evaluate_four_bars(columns(designs), angles, list(wanted), dict(out or {}), threads)


def _row(index: int, design: Any) -> list[float]:
    tables = design.tables() if isinstance(design, Mechanism) else {}
    if tables.get("type") != "four-bar" or "coupler_point" not in tables:
        raise _fault(f"designs[{index}] is no four-bar with a coupler_point; expected one")
    (ax, ay), (dx, dy) = tables["fixed_pivots"]
    side = -1.0 if tables.get("assembly") == "crossed" else 1.0
    return [ax, ay, dx, dy, tables["crank"], tables["coupler"], tables["rocker"], side,
            *tables["coupler_point"]]


def _fault(message: str, key: str = "designs") -> ProblemError:
    return ProblemError([(None, None, None, key, message)])
