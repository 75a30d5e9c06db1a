"""Synthesis in closed form and by polynomial systems: arrays in, arrays out. Angles in radians.

>>> import numpy as np
>>> inputs = chebyshev_spacing(0, np.radians(60), 3)
>>> freudenstein(inputs, inputs**1.5).outcome
'linkage'
"""

from __future__ import annotations

from typing import Any, Callable, Optional

from . import _core
from ._errors import ProblemError
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


def slider_crank_points(points: Any, *, input_start: Optional[float] = None,
                        output_start: Optional[float] = None,
                        offset: Optional[float] = None) -> list[Values]:
    """Every slider-crank through three to five pairs (n, 2) of crank angle and displacement.

    n as in :func:`precision_points`; with the ``offset`` given one pair less, and not both starts.
    Of each ``crank``, ``coupler``, ``offset`` (positive to the
    left of the slide) in the unit of the displacements, ``input_start`` (the crank's angle from the
    slide at input 0), ``output_start`` (the slider from the foot of the perpendicular at output 0),
    ``outcome`` (``"linkage"``, ``"scotch-yoke"``, ...), ``residual``, ``condition``.
    """
    return [_values(one) for one in _core.slider_crank_points(points, input_start, output_start,
                                                                  offset)]


def equal_peaks(output: Callable[[float], float], interval: Any, links: Any, *,
                input_start: float, output_start: float, assembly: str = "open",
                input_start_free: bool = False, output_start_free: bool = False) -> Values:
    """A function generator whose peaks of the structural error are level, by exchange.

    ``output`` is the angle wanted at an input angle of the ``interval`` (2,), both counted from the
    start angles. The exchange begins with a four-bar, ``links`` (4,) being crank, coupler, rocker,
    frame, whose error changes sign once for each precision point: 3 of them, 4 or 5 where start
    angles are free. ``outcome`` is ``"level"`` or why the peaks are not: ``"not-alternating"``,
    ``"not-closing"``, ``"stalled"``, and the four-bar the best one met. ``links`` (4,),
    ``input_start``, ``output_start``, ``greatest`` error, ``unevenness`` of the peaks, the inputs of
    the ``peaks`` (n + 1,) and the ``precision_inputs`` (n,), ``exchanges``. Freudenstein 1959.
    """
    return Values(_core.equal_peaks(output, interval, links, input_start, output_start, assembly,
                                    input_start_free, output_start_free))


def two_poses(poses: Any, *, in_body: Any = None, fixed: Any = None, line: Any = None,
              length: Optional[float] = None) -> Values:
    """Dyads through two poses (2, 3) with the moving pivot ``in_body`` (2,), or ``fixed`` (2,).

    The other pivot on ``line`` (2, 2), a point and the direction, in the frame for a given
    ``in_body``, in body axes for ``fixed``; or a link of the ``length``; or, with neither, the
    slider that carries ``in_body`` straight. Columns as of :func:`five_poses`.
    """
    return Values(_core.two_poses(poses, in_body, fixed, line, length))


def pivot_line(poses: Any, *, in_body: Any = None, fixed: Any = None) -> Any:
    """Where the other pivot of two poses (2, 3) may stand: a point and the direction, (2, 2).

    In the frame for a given ``in_body``, in body axes for ``fixed``; None: anywhere.
    """
    return _core.pivot_line(poses, in_body, fixed)


def pole_triangle(poses: Any) -> Any:
    """The poles of the displacements 1 to 2, 2 to 3 and 3 to 1 of poses (3, 3): (3, 2).

    NaN for a displacement that does not turn.
    """
    return _core.pole_triangle(poses)


def guided_mechanism(poses: Any, dyads: Values, first: int = 0, second: int = 1) -> Values:
    """The mechanism of two of the dyads that guide a body through ``poses`` (n, 3).

    ``dyads`` is what :func:`five_poses` and the others return, ``first`` and ``second`` are rows of
    it; the first link is driven where it is a crank. ``mechanism``, the guided ``body``, which
    carries the poses' origin as point P, ``drive`` (n,), the angles or displacements of the drive at
    the poses, and ``assembly`` at each: where these differ, the mechanism has to be taken apart.

    >>> import numpy as np
    >>> poses = [[0, 0, 0], [1, 0.5, 0.3], [2, 0.3, 0.7]]
    >>> one, other = (three_poses(poses, in_body=at) for at in ([0, 0.5], [1, -0.5]))
    >>> both = {key: [*one[key], *other[key]] for key in one if key != "status"}
    >>> bar = guided_mechanism(poses, both)
    >>> np.allclose(bar.mechanism.curve(bar.drive[0]), poses[0][:2])
    True
    """
    made: Values = _values(_core.guided_mechanism(poses, _row(dyads, first), _row(dyads, second)))
    made["mechanism"] = mechanism_of(made["mechanism"])
    return made


def _row(dyads: Any, index: int) -> dict[str, Any]:
    keys = ("kind", "in_body", "fixed", "direction")
    try:
        return {key: dyads[key][index] for key in keys}
    except (TypeError, KeyError, IndexError, ValueError) as error:
        raise ProblemError([(None, None, None, "dyads", f"dyads have no row {index} ({error}); "
                             f"expected a table with {', '.join(keys)}")]) from None


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


def three_poses(poses: Any, *, in_body: Any = None, fixed: Any = None, slide: Any = None,
                body_line: Any = None) -> Values:
    """The dyad through three poses (3, 3): one of its parts is given.

    The moving pivot ``in_body`` (2,), the ``fixed`` pivot (2,), the direction ``slide`` (2,) of a
    slide of the frame, or the direction ``body_line`` (2,), in body axes, of a line through a block.
    """
    return Values(_core.three_poses(poses, in_body, fixed, slide, body_line))


def nine_points(points: Any, angles: Any = None, *, pivot_a: Any = None, pivot_d: Any = None,
                coupler_point: Any = None, frame_angle: Optional[float] = None,
                crank: Optional[float] = None, coupler: Optional[float] = None,
                rocker: Optional[float] = None, frame: Optional[float] = None,
                threads: Optional[int] = None, progress: Progress = None) -> Values:
    """Every four-bar whose coupler point passes through nine points (9, 2), by homotopy.

    With ``angles`` (n,) of the coupler at some of the points, NaN at the others, or parts of the
    four-bar given, fewer points: M angles, N other points and G conditions by parts (a pivot 2, the
    coupler point, which goes with the coupler, 2, a length or the frame's angle 1) with
    2 (M - 1) + N + G = 8: five points with both pivots. The first problem of a kind takes longest.
    ``designs`` (m, 10) are the real four-bars, in
    the columns of :data:`cognate.batch.COLUMNS`, cognates included; ``residual`` and ``condition``
    (m,); ``finite`` counts the complex solutions. They may pass the points on two branches:
    ``cognate.solve(kind="path-generation", target={"method": "exact", ...})`` judges that.
    """
    given = {"pivot_a": pivot_a, "pivot_d": pivot_d, "coupler_point": coupler_point,
             "frame_angle": frame_angle, "crank": crank, "coupler": coupler, "rocker": rocker,
             "frame": frame}
    with shown(progress) as report:
        return Values(_core.exact_path(points, angles, given, threads, report))


def smallest_cam(motion: Any, *, pressure_angle_deg: float,
                 offset: Optional[float] = None) -> Optional[Values]:
    """The smallest cam of a translating roller follower that keeps a pressure angle, exactly.

    ``motion`` is the list of tables ``[[motion]]`` of a cam file. ``base_radius`` of the pitch curve,
    ``offset`` (free unless given), and the ``binding_angles`` that force the size. None where no
    cam keeps it.
    """
    found = _core.smallest_cam(motion, pressure_angle_deg, offset)
    return None if found is None else _values(found)


def smallest_oscillating_cam(motion: Any, *, pressure_angle_deg: float, arm: float,
                             side: str = "trailing") -> Optional[Values]:
    """The smallest cam of an oscillating roller follower that keeps a pressure angle, exactly.

    ``motion`` is the list of tables ``[[motion]]`` of a cam file, ``arm`` the follower's length,
    ``side`` ``"trailing"`` or ``"leading"``. ``base_radius`` of the pitch curve,
    ``centre_distance``, in the unit of the arm, and the ``binding_angles`` in radians that force the
    size. None where no cam keeps it.

    >>> motion = [{"law": "cycloidal", "over_deg": 120, "rise_deg": 20},
    ...           {"law": "dwell", "over_deg": 60},
    ...           {"law": "cycloidal", "over_deg": 120, "rise_deg": -20},
    ...           {"law": "dwell", "over_deg": 60}]
    >>> cam = smallest_oscillating_cam(motion, pressure_angle_deg=35, arm=60)
    >>> bool(0 < cam.base_radius < cam.centre_distance)
    True
    """
    found = _core.smallest_oscillating_cam(motion, pressure_angle_deg, arm, side)
    return None if found is None else _values(found)


def involute(angle: Any) -> Any:
    """The involute function tan(a) - a of angles (...) in radians, within (-pi/2, pi/2): (...).

    >>> round(float(involute(0.3490658503988659)), 9)
    0.014904384
    """
    return _core.involute(angle)


def involute_angle(value: Any) -> Any:
    """The angles in radians whose involute is ``value`` (...), of either sign: (...).

    >>> round(float(involute_angle(0.014904384)), 6)
    0.349066
    """
    return _core.involute_angle(value)


def quick_return_rockers(*, time_ratio: float, rocker: float, swing: float,
                         crank: Optional[float] = None, coupler: Optional[float] = None,
                         frame: Optional[float] = None, line: Any = None,
                         outer_limit: Optional[float] = None,
                         inner_limit: Optional[float] = None) -> Values:
    """Crank-rockers of a time ratio (1 and more), rocker and swing in (0, pi).

    All those with the ``crank``, ``coupler`` or ``frame``, with the crank's pivot on the ``line``
    a x + b y = c, (3,), or with the rocker's angle from A to D, in (0, pi), at the limit with crank
    and coupler extended (``outer_limit``) or folded (``inner_limit``); with none of them the best
    transmission on each arc. The rocker's pivot is the origin, the bisector of its swing the y axis. Of ``designs`` each has ``mechanism``,
    ``outer`` and ``inner``, the crank's angles at the limits, ``transmission_min``,
    ``transmission_max``, ``arc``, ``mirror``, ``residual``, ``condition``; ``degeneracy`` says what
    leaves infinitely many. Li & Xu 2011, section 3; VDI 2130.

    >>> found = quick_return_rockers(time_ratio=1.2, rocker=3, swing=0.8)
    >>> round(found.designs[0].mechanism.rocker, 9)
    3.0
    """
    given, value = _one_of(crank=crank, coupler=coupler, frame=frame, line=line,
                           outer_limit=outer_limit, inner_limit=inner_limit)
    return _designs(_core.quick_return_rockers(time_ratio, rocker, swing, given, value))


def quick_return_rockers_by_frame(*, time_ratio: float, rocker: float, frame: float,
                                  outer_limit: Optional[float] = None,
                                  inner_limit: Optional[float] = None) -> Values:
    """Crank-rockers of a time ratio, rocker and frame whose rocker has an angle at a limit.

    As :func:`quick_return_rockers`, with the frame in place of the swing; one of ``outer_limit`` and
    ``inner_limit`` is given.

    >>> found = quick_return_rockers_by_frame(time_ratio=1.5, rocker=75, frame=100,
    ...                                       inner_limit=2.356194490192345)
    >>> round(found.designs[0].mechanism.crank, 2)
    49.31
    """
    given, value = _one_of(outer_limit=outer_limit, inner_limit=inner_limit)
    return _designs(_core.quick_return_rockers_by_frame(time_ratio, rocker, frame, given, value))


def quick_return_sliders(*, time_ratio: float, stroke: float, offset: Optional[float] = None,
                         crank: Optional[float] = None, coupler: Optional[float] = None) -> Values:
    """Slider-cranks of a time ratio and stroke, the pivot in the origin, the slide along x.

    All those with the ``offset``, ``crank`` or ``coupler``; with none of them those whose steepest
    ``pressure_angle`` is least. Of ``designs`` each as of :func:`quick_return_rockers`.
    """
    given, value = _one_of(offset=offset, crank=crank, coupler=coupler)
    return _designs(_core.quick_return_sliders(time_ratio, stroke, given, value))


def quick_return_guides(*, time_ratio: float, frame: Optional[float] = None,
                        crank: Optional[float] = None, offset: float = 0.0) -> list[Values]:
    """Guide-bars of a time ratio with the ``frame`` or the ``crank`` given; none where it cannot be.

    The guide's pivot is the origin, the crank's on the positive y axis. Of each ``mechanism``,
    ``left`` and ``right``, the crank's angles where the bar turns back, ``mirror``, ``residual``,
    ``condition``.
    """
    found = _core.quick_return_guides(time_ratio, frame, crank, offset)
    return [_with_mechanism(one) for one in found]


def quick_return_shaper(*, time_ratio: float, stroke: float, frame: Optional[float] = None,
                        crank: Optional[float] = None, rod: Optional[float] = None,
                        pressure_angle: Optional[float] = None,
                        ram_height: Optional[float] = None) -> Values:
    """The shaper's six-bar of a time ratio and stroke: a guide-bar that pushes a ram.

    One of ``frame`` and ``crank``, one of the ``rod`` and the steepest ``pressure_angle`` of the ram
    are given; the ram's line stands at ``ram_height`` over the bar's pivot, where the rod leans
    least without. ``outcome`` is ``"solved"`` or says why there is none; ``mechanism`` (a
    :class:`Chain`), ``crank``, ``frame``, ``bar``, ``rod``, ``ram_height``, ``pressure_angle``.
    """
    found = _core.quick_return_shaper(time_ratio, stroke, frame, crank, rod, pressure_angle,
                                      ram_height)
    return _with_mechanism(found)


def straight_points(mechanism: Mechanism, angle: float, *, contact: int = 4) -> Values:
    """Coupler points of a four-bar or slider-crank that move straight at an ``angle`` of its crank.

    ``points`` whose paths have contact of at least ``contact`` points (3 to 5) with their tangents:
    of each ``kind`` (``"ball-point"``, ``"inflection-pole"``, ...), ``coupler_point`` (2,),
    ``contact``, ``tangent`` (2,), ``coefficient`` of the deviation, ``condition``. ``why`` is
    ``"none"``, or why there is no such point.
    """
    found: Values = _values(_core.straight_points(mechanism, angle, contact))
    return found


def straight_positions(mechanism: Mechanism, *, contact: int = 5) -> list[Values]:
    """Where over its turn a linkage has coupler points of such ``contact`` (4 or 5).

    As of :func:`straight_points`, and of each ``mechanism``, a four-bar with its coupler point, and
    ``crank_angle``.
    """
    return [_with_mechanism(one) for one in _core.straight_positions(mechanism, contact)]


def straight_lengths(mechanism: Mechanism, angle: float, length: str) -> list[Values]:
    """The four-bars that differ in one ``length`` and have contact of five points at ``angle``.

    ``length`` is ``"crank"``, ``"coupler"``, ``"rocker"`` or ``"frame"``.
    """
    return [_with_mechanism(one) for one in _core.straight_lengths(mechanism, angle, length)]


def _one_of(**given: Any) -> tuple[str, Any]:
    there = {name: value for name, value in given.items() if value is not None}
    if len(there) > 1:
        raise ProblemError([(None, None, None, name, f"{name} is given beside others of "
                             f"{', '.join(given)}; expected one of them at most") for name in there])
    return next(iter(there.items()), ("best", None))


def _with_mechanism(table: dict[str, Any]) -> Values:
    made: Values = _values(table)
    if "mechanism" in made:
        made["mechanism"] = mechanism_of(made["mechanism"])
    return made


def _designs(found: dict[str, Any]) -> Values:
    made: Values = _values(found)
    made["designs"] = [_with_mechanism(one) for one in found["designs"]]
    return made


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


def cognates(mechanism: FourBar, angle: float = 0.0) -> list[tuple[Mechanism, float]]:  
    """Roberts' cognates of a four-bar with a coupler point, each with its crank angle.

    ``angle`` is that of the given crank; at the angles returned the cognates have the same coupler
    point.
    """
    return [(mechanism_of(tables), turned) for tables, turned in _core.cognates(mechanism, angle)]
