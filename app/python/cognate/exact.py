"""Synthesis in closed form and by polynomial systems: arrays in, arrays out. Angles in radians.

>>> import numpy as np
>>> inputs = chebyshev_spacing(0, np.radians(60), 3)
>>> freudenstein(inputs, inputs**1.5).outcome
'linkage'
"""

from __future__ import annotations

from typing import Any, Optional

from . import _core
from ._progress import Progress, shown
from ._result import Values, _values
from .mechanisms import FourBar, Mechanism, mechanism_of


def chebyshev_spacing(first: float, last: float, count: int) -> Any:
    """Precision points on (first, last), the roots of Chebyshev's polynomial: (count,)."""
    return _core.chebyshev_spacing(first, last, count)


def freudenstein(input: Any, output: Any, weights: Any = None) -> Optional[Values]:  # noqa: A002
    """The four-bar with pairs of crank and rocker angles (n,), counted from A to D.

    Exact for three pairs, by least squares for more (``weights`` (n,)); Freudenstein 1955. ``links``
    (4,) are crank 1, coupler, rocker, frame; ``ratios`` (3,), ``residual``, ``condition``,
    ``outcome`` (``"linkage"`` or why there is none), ``input_turn`` and ``output_turn``, 0 or pi, are
    to be added to the angles. None where the pairs do not determine the ratios.
    """
    found = _core.freudenstein(input, output, weights)
    return None if found is None else _values(found)


def precision_points(points: Any, *, input_start: Optional[float] = None,
                     output_start: Optional[float] = None) -> list[Values]:
    """Every four-bar through three to five pairs (n, 2) of angles from the start angles.

    n is 3 with both start angles given, 4 with one, 5 with none. Of each solution ``links`` (4,)
    with the crank 1, ``input_start``, ``output_start``, ``outcome``, ``residual``, ``condition``.
    """
    return [_values(one) for one in _core.precision_points(points, input_start, output_start)]


def five_poses(poses: Any) -> Values:
    """All dyads that guide a body through five poses (5, 3), rows [x, y, angle]: 0, 2 or 4.

    ``kind`` (``"rr"``, ``"pr"``, ``"rp"``), ``fixed`` and ``moving`` pivots (k, 2) at the first pose,
    ``in_body`` (k, 2), ``direction`` (k, 2) of slides, ``length``, ``residual``, ``condition`` (k,),
    and ``status``, a sentence.
    """
    return Values(_core.five_poses(poses))


def four_poses(poses: Any, *, spacing: float = 0.05, reach: float = 10.0) -> list[Values]:
    """Burmester's curves of four poses (4, 3): for each branch its dyads in order, as columns.

    ``fixed`` is the centre-point curve, ``moving`` the circle-point curve, sampled so that points
    follow one another within ``spacing``, out to ``reach``, both times the extent of the poses.
    """
    return [Values(branch) for branch in _core.four_poses(poses, spacing, reach)]


def three_poses(poses: Any, *, in_body: Any = None, fixed: Any = None) -> Values:
    """The dyad through three poses (3, 3) with the moving pivot ``in_body`` (2,), or ``fixed`` (2,)."""
    return Values(_core.three_poses(poses, in_body, fixed))


def nine_points(points: Any, angles: Any = None, *, threads: Optional[int] = None,
                progress: Progress = None) -> Values:
    """Every four-bar whose coupler point passes through nine points (9, 2), by homotopy.

    With ``angles`` (n,) of the coupler at some of the points, NaN at the others, fewer points: M
    angles and N other points with 2 (M - 1) + N = 8. ``designs`` (m, 10) are the real four-bars, in
    the columns of :data:`cognate.batch.COLUMNS`, cognates included; ``residual`` and ``condition``
    (m,); ``finite`` counts the complex solutions. They may pass the points on two branches:
    ``cognate.solve(kind="path-generation", target={"method": "exact", ...})`` judges that.
    """
    with shown(progress) as report:
        return Values(_core.exact_path(points, angles, threads, report))


def smallest_cam(motion: Any, *, pressure_angle_deg: float,
                 offset: Optional[float] = None) -> Optional[Values]:
    """The smallest cam of a translating roller follower that keeps a pressure angle, exactly.

    ``motion`` is the list of tables ``[[motion]]`` of a cam file. ``base_radius`` of the pitch curve,
    ``offset`` (free unless given), and the ``binding_angles`` that force the size. None where no
    cam keeps it.
    """
    found = _core.smallest_cam(motion, pressure_angle_deg, offset)
    return None if found is None else _values(found)


def instant_geometry(mechanism: Mechanism, angle: float, body: str = "coupler") -> Optional[Values]:
    """Where a body turns at an angle of the drive, and how its points' paths curve.

    ``pole`` (2,), ``inflection_circle`` and ``return_circle`` with ``centre`` (2,) and ``radius``,
    ``inflection_pole`` (2,), ``ball_point`` (2,) or None. None where the body does not turn.
    """
    found = _core.instant_geometry(mechanism, angle, body)
    return None if found is None else _values(found)


def inflection_circle(mechanism: Mechanism, angle: float,
                      body: str = "coupler") -> Optional[tuple[Any, float]]:
    """Centre (2,) and radius of the circle of the points whose paths do not curve at ``angle``."""
    found = instant_geometry(mechanism, angle, body)
    return None if found is None else (found.inflection_circle.centre,
                                       found.inflection_circle.radius)


def cognates(mechanism: FourBar, angle: float = 0.0) -> list[tuple[Mechanism, float]]:  # type: ignore[valid-type]
    """Roberts' cognates of a four-bar with a coupler point, each with its crank angle.

    ``angle`` is that of the given crank; at the angles returned the cognates have the same coupler
    point.
    """
    return [(mechanism_of(tables), turned) for tables, turned in _core.cognates(mechanism, angle)]
