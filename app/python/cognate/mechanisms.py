"""Mechanisms of given dimensions: positions, motion, forces.

There is a class for each ``mechanism.type`` of files, with the keys of its table as keywords.
Angles are in radians from the x axis, but degrees under keys that end in ``_deg``; a driving
slider is moved by displacements, a driving cylinder by its length. Arrays of points have x and y
last, ``(..., 2)`` for angles of shape ``(...)``; they are NaN where the mechanism cannot be
assembled. The assemblies stay as the mechanism says; :func:`cognate.analyze` follows a motion
through change points.

>>> import numpy as np
>>> bar = FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3,
...               coupler_point=[1, 1])
>>> bar.positions(np.linspace(0, 2 * np.pi, 100))["P"].shape
(100, 2)
"""

from __future__ import annotations

import copy
import inspect
from collections import abc
from typing import Any, Optional

import numpy as np

from . import _core
from ._errors import ProblemError


class Mechanism(_core.Mechanism):
    """Any mechanism, by the keys of ``[mechanism]`` of a file; never changes.

    >>> Mechanism(type="slider-crank", crank=1, coupler=3).point_names
    ['A', 'B', 'C']
    """

    _word = ""

    def __init__(self, **keys: Any) -> None:
        if self._word:
            if "type" in keys:
                raise ProblemError([(None, None, None, "type",
                                     f"type is given; a {type(self).__name__} has its own")])
            keys = {"type": self._word, **keys}
        super().__init__(keys)
        object.__setattr__(self, "_given", copy.deepcopy(keys))

    def to_dict(self) -> dict[str, Any]:
        """The keys of ``[mechanism]``, with every default."""
        return dict(self.tables())

    __cognate_tables__ = to_dict

    def replace(self, **keys: Any) -> "Mechanism":
        """The same mechanism with other values of some keys, None for the default.

        >>> bar = FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3)
        >>> bar.replace(crank=0.5).crank
        0.5
        """
        return mechanism_of({**self.to_dict(), **keys})

    def positions(self, angles: Any, *, points: Optional[abc.Sequence[str]] = None,
                  threads: Optional[int] = 1) -> dict[str, Any]:
        """Where the points are: a dictionary of arrays (..., 2) in the unit of the lengths.

        ``points`` names the points, None all of them; ``threads`` is for large arrays, None
        or 0 as many as the machine has. Points of the frame are arrays that cannot be written to.
        """
        return self._positions(angles, 0, points, threads)

    def velocities(self, angles: Any, speed: Any = 1.0, *,
                   points: Optional[abc.Sequence[str]] = None,
                   threads: Optional[int] = 1) -> dict[str, Any]:
        """Velocities (..., 2) while the drive moves at ``speed`` (rad/s, a number or an array)."""
        rates = self._positions(angles, 1, points, threads)
        factor = _factor(speed, "speed", angles)
        return {name: factor * rate for name, rate in rates.items()}

    def accelerations(self, angles: Any, speed: Any = 1.0, acceleration: Any = 0.0, *,
                      points: Optional[abc.Sequence[str]] = None,
                   threads: Optional[int] = 1) -> dict[str, Any]:
        """Accelerations (..., 2) for a drive of such ``speed`` and ``acceleration`` (rad/s2)."""
        seconds = self._positions(angles, 2, points, threads)
        square = _factor(speed, "speed", angles) ** 2
        along = _factor(acceleration, "acceleration", angles)
        if not np.any(along):
            return {name: square * second for name, second in seconds.items()}
        rates = self._positions(angles, 1, points, threads)
        return {name: square * second + along * rates[name] for name, second in seconds.items()}

    def derivatives(self, angles: Any, order: int, *, points: Optional[abc.Sequence[str]] = None,
                    threads: Optional[int] = 1) -> dict[str, Any]:
        """The derivative ``order`` (0 to 3) of the points by the drive: arrays (..., 2)."""
        return self._positions(angles, order, points, threads)

    def curve(self, angles: Any = None, *, point: Optional[str] = None,
              threads: Optional[int] = 1) -> "np.ndarray[Any, np.dtype[np.float64]]":
        """The path of one point, (..., 2): over a whole turn in 360 steps without ``angles``.

        ``point`` is the coupler point P, where there is one, else the last point.
        """
        if angles is None:
            angles = np.linspace(0, 2 * np.pi, 360, endpoint=False)
        return self._point(self._drawn_point() if point is None else point, angles, threads)

    def rotations(self, angles: Any, *, order: int = 0, threads: Optional[int] = 1) -> dict[str, Any]:
        """Angles of the moving bodies in (-pi, pi], (...), or their derivatives by the drive."""
        return self._bodies(angles, order, threads)

    def transmission(self, angles: Any, *, threads: Optional[int] = 1) -> Any:
        """The transmission angle of each dyad in [0, pi], (..., dyads)."""
        return self._transmission(angles, threads)

    def gradient(self, angles: Any, *, point: Optional[str] = None) -> dict[str, Any]:
        """Derivatives of a point by each number of the dimensions: arrays (..., 2) by its place.

        ``"crank"``, ``"fixed_pivots[0][1]"``, ``"coupler_point[0]"``, of a chain
        ``"dyad[1].lengths[0]"``; those by ``"..._deg"`` are for a degree. The angles of the drive
        stay as they are. Exact but for roundings.
        """
        return self._gradient(self._drawn_point() if point is None else point, angles)

    def forces(self, angles: Any, *, speed: Any = 1.0, acceleration: Any = 0.0,
               link: Optional[abc.Sequence[abc.Mapping[str, Any]]] = None,
               load: Optional[abc.Sequence[abc.Mapping[str, Any]]] = None,
               gravity: Any = None, length_unit: Optional[str] = None) -> dict[str, Any]:
        """Forces of the moving mechanism, by inverse dynamics.

        ``link`` (masses) and ``load`` are the tables ``[[link]]`` and ``[[load]]`` of an analysis
        file, ``gravity`` is [x, y]; ``speed`` (rad/s) and ``acceleration`` (rad/s2) are those of
        the drive, numbers or arrays of the shape of ``angles``. Lengths are in metres unless
        ``length_unit`` says otherwise.

        ``"drive"`` (...) is the driving torque in N m (of a slider the force in N); under the names
        of the joints are the forces in N, (..., 2), from the body nearer to the frame or the drive
        on the other one; ``"shaking_force"`` (..., 2) and ``"shaking_moment"`` (...) are those on
        the frame. NaN where the mechanism cannot be assembled or stands at a dead point.

        >>> bar = SliderCrank(crank=0.05, coupler=0.2)
        >>> load = [{"on": "slider", "force": [-100, 0]}]
        >>> round(float(bar.forces(np.pi / 2, load=load)["drive"]), 12)
        -5.0
        """
        tables = {"link": link, "load": load, "gravity": gravity, "length_unit": length_unit}
        wanted = {name: value for name, value in tables.items() if value is not None}
        return _core.forces(self, angles, speed, acceleration, wanted)

    def _drawn_point(self) -> str:
        names = self.point_names
        return "P" if "P" in names else names[-1]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        tables = self.tables()
        if name in tables:
            return tables[name]
        raise AttributeError(f"{type(self).__name__} has no {name!r}; its keys are "
                             f"{', '.join(tables)}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name} cannot be set, a mechanism never changes; "
                             f"replace({name}=...) makes another one")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.tables()]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mechanism) and self.tables() == other.tables()

    def __hash__(self) -> int:
        return hash(repr(self.tables()))

    def __repr__(self) -> str:
        tables = self.to_dict()
        word = tables.pop("type")
        keys = ", ".join(f"{key}={value!r}" for key, value in tables.items())
        return f"{_name(word)}({keys})"

    def _repr_svg_(self) -> str:
        from . import _show

        return _show.mechanism_svg(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return mechanism_of, (self._given,)


def _factor(value: Any, name: str, angles: Any) -> Any:
    if isinstance(value, float):
        return value
    try:
        if value is None:
            raise TypeError("None")
        array = np.asarray(value, dtype=float)
        np.broadcast_shapes(array.shape, np.shape(angles))
    except (TypeError, ValueError) as error:
        message = f"{name} is no number ({error}); expected a number, or one for each of the angles"
        raise ProblemError([(None, None, None, name, message)]) from None
    return array[..., np.newaxis] if array.ndim else float(array)


def _name(word: str) -> str:
    return "".join(part.capitalize() for part in word.split("-"))


_FORMS = {"length": "float", "number": "float", "place": "[x, y]", "pivots": "[[x, y], [x, y]]",
          "direction": "float, degrees", "assembly": "str", "point": "[u, v]"}


def _class_of(word: str, meaning: str,
              keys: abc.Sequence[tuple[str, str, str, bool]]) -> type[Mechanism]:
    lines = [f"{meaning[0].upper()}{meaning[1:]}.", "", "Keywords", "--------"]
    for key, form, text, _ in keys:
        lines += [f"{key} : {_FORMS[form]}", f"    {text[0].upper()}{text[1:]}."]
    lines += ["point : list of dictionaries", "    ``[[point]]``: further points of its links."]

    def __init__(self: Mechanism, *unnamed: Any, **values: Any) -> None:
        if unnamed:
            raise TypeError(f"{_name(word)} takes keywords alone: "
                            f"{', '.join(key for key, _, _, _ in keys)}")
        Mechanism.__init__(self, **values)

    kind = inspect.Parameter.KEYWORD_ONLY
    parameters = [inspect.Parameter(key, kind) if required
                  else inspect.Parameter(key, kind, default=None) for key, _, _, required in keys]
    parameters.append(inspect.Parameter("point", kind, default=None))
    own = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)
    __init__.__signature__ = inspect.Signature([own, *parameters])  # type: ignore[attr-defined]
    return type(_name(word), (Mechanism,), {"__doc__": "\n".join(lines), "_word": word,
                                            "__module__": __name__, "__init__": __init__})


_CLASSES = {word: _class_of(word, meaning, keys)
            for word, meaning, keys in _core.mechanism_types() if keys}


class Chain(Mechanism):
    """A drive and any number of dyads.

    Keywords: ``pivot``, ``crank``, ``slider`` or ``cylinder``, ``dyad``, ``point``: the tables of
    the same names in a file, as dictionaries or lists of these.
    """

    _word = "chain"


_CLASSES["chain"] = Chain
# Each under its name, as the stub lists them.
globals().update({made.__name__: made for made in _CLASSES.values()})


def mechanism_of(tables: abc.Mapping[str, Any]) -> Mechanism:
    """The mechanism with these keys of ``[mechanism]``, as an object of the class of its type."""
    if not isinstance(tables, abc.Mapping):
        raise ProblemError([(None, None, None, "mechanism", "mechanism is of the type "
                             f"{type(tables).__name__}; expected a dictionary")])
    keys = dict(tables)
    made = _CLASSES.get(str(keys.get("type")))
    if made is None:
        return Mechanism(**keys)
    del keys["type"]
    return made(**keys)


__all__ = ["Mechanism", "mechanism_of", *sorted(made.__name__ for made in _CLASSES.values())]
