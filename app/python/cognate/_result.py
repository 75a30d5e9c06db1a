"""Results: designs with what is known of them, as values, frames, pictures and files."""

from __future__ import annotations

import os
import typing
import zlib
from collections import abc
from pathlib import Path
from typing import Any, Optional, Union, overload

import numpy as np

from . import _core, _show
from ._errors import ProblemError
from .mechanisms import Mechanism, mechanism_of

PathLike = Union[str, "os.PathLike[str]"]


class Values(dict):  # type: ignore[type-arg]
    """Named values, also as attributes: ``error.rms`` is ``error["rms"]``."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r}; there are {', '.join(self)}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]


def _values(table: Any) -> Any:
    if isinstance(table, dict):
        return Values({key: _values(value) for key, value in table.items()})
    if isinstance(table, list) and table and isinstance(table[0], dict):
        return [_values(row) for row in table]
    return table


class Constraint(typing.NamedTuple):
    """A constraint of the file, checked on a finished design."""

    name: str
    value: Any
    bound: Any
    satisfied: bool


class Checked(typing.NamedTuple):
    """A problem that was read and has no fault."""

    description: str
    problem: dict[str, Any]


class Exported(typing.NamedTuple):
    """What an export wrote."""

    files: list[Path]
    texts: dict[str, bytes]
    notes: list[str]
    quantities: dict[str, Any]


def write_whole(path: Path, data: bytes) -> None:
    """Whoever reads sees the old file or the new one, never a part."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        beside.write_bytes(data)
        os.replace(beside, path)
    except OSError as error:
        beside.unlink(missing_ok=True)
        raise ProblemError([(str(path), None, None, "", f"cannot be written: {error}")]) from None


def make_folder(folder: Path) -> None:
    """The folder of files, with those above it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ProblemError([(None, None, None, "out", f"out: {error}")]) from None


def exported(
    answer: _core.Answer,
    name: str,
    format: str,  # noqa: A002
    design: int,
    out: Optional[PathLike],
    options: dict[str, Any],
) -> Exported:
    wanted = {"format": format, "design": design, **options}
    made = _core.export_files(answer.json(), "the result", name, wanted)
    files: list[Path] = []
    if out is not None:
        folder = Path(os.fspath(out))
        make_folder(folder)
        for file, text in made["files"].items():
            files.append(folder / file)
            write_whole(files[-1], text)
    return Exported(files, made["files"], made["notes"], made["quantities"])


def _flat(table: dict[str, Any], within: str, row: dict[str, Any]) -> None:
    for key, value in table.items():
        if isinstance(value, dict):
            _flat(value, f"{within}{key}.", row)
        elif not isinstance(value, list):
            row[within + key] = value
        elif len(value) == 2 and all(isinstance(part, float) for part in value):
            row[f"{within}{key}[0]"], row[f"{within}{key}[1]"] = value


class Design:
    """One design of a result."""

    def __init__(self, result: "Result", index: int) -> None:
        self._result = result
        self._index = index
        self._table = result.document["designs"][index]

    @property
    def number(self) -> int:
        """Counted from 1, as notes, tables and exports count."""
        return self._index + 1

    @property
    def document(self) -> dict[str, Any]:
        """Its entry of the result document."""
        return dict(self._table)

    @property
    def mechanism(self) -> Any:
        """A :class:`Mechanism` that can be moved; of cams and gears a dictionary."""
        table = self._table["mechanism"]
        return mechanism_of(table) if self.is_linkage else _values(table)

    @property
    def is_linkage(self) -> bool:
        """Whether :attr:`mechanism` can be moved."""
        return bool(self._table["mechanism"].get("type") in _core_types())

    @property
    def error(self) -> Any:
        """``rms``, ``max`` and ``sum_of_squares`` in the target's unit; of angles ``rms_deg`` too."""
        return _values(self._table.get("error", {}))

    @property
    def quantities(self) -> Any:
        """Every number and word that is reported of it: ``cognate.list(metrics=True)``."""
        return _values(self._table.get("metrics", {}))

    @property
    def constraints(self) -> list[Constraint]:
        """The constraints of the file, checked on this design."""
        return [Constraint(c["name"], c["value"], c["bound"], c["satisfied"])
                for c in self._table.get("constraints", [])]

    @property
    def is_feasible(self) -> bool:
        """Whether every constraint is satisfied."""
        return all(constraint.satisfied for constraint in self.constraints)

    @property
    def warnings(self) -> list[str]:
        """Why it is impractical although it meets the file, and constraints that it misses."""
        missed = [f"{c.name} is {c.value}; the bound is {c.bound}"
                  for c in self.constraints if not c.satisfied]
        return [*missed, *self._table.get("warnings", [])]

    @property
    def origin(self) -> str:
        """How it was found: ``"exact:..."``, ``"search + gauss-newton"``, ``"given"``."""
        return str(self._table.get("origin", "given"))

    @property
    def crank_angles(self) -> "np.ndarray[Any, np.dtype[np.float64]]":
        """At the target points, in radians, (n,); of a driving slider displacements."""
        if "slide" in self._table:
            return np.array(self._table["slide"], dtype=float)
        return np.asarray(np.radians(np.array(self._table.get("crank_deg", []), dtype=float)))

    def analyze(self, **options: Any) -> "Result":
        """The motion of this design over its drive: see :func:`analyze`."""
        from ._problems import analyze

        tables = _core.analysis_tables(self._result._answer.json(), self.number)
        return analyze(tables, **options)

    def export(self, format: str = "dxf", *, out: Optional[PathLike] = ".",  # noqa: A002
               **options: Any) -> Exported:
        """Writes this design for CAD: see :func:`export`."""
        return exported(self._result._answer, self._result.name, format, self.number, out, options)

    def row(self) -> dict[str, Any]:
        """Its numbers and words by their places: ``"mechanism.crank"``, ``"error.rms"``."""
        row: dict[str, Any] = {}
        for key in ("mechanism", "error", "metrics"):
            _flat(self._table.get(key, {}), "" if key == "metrics" else f"{key}.", row)
        row["feasible"] = self.is_feasible
        row["origin"] = self.origin
        return row

    def __repr__(self) -> str:
        rms = self._table.get("error", {}).get("rms")
        error = f", rms error {rms:.3g}" if isinstance(rms, float) else ""
        return f"<Design {self.number}: {self._table['mechanism'].get('type')}{error}>"

    def _repr_svg_(self) -> str:
        return _show.still_picture(self)

    def _repr_html_(self) -> str:
        return _show.design_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return Design, (self._result, self._index)


def _core_types() -> set[str]:
    return {word for word, _, _ in _core.mechanism_types()}


class Designs(abc.Sequence):  # type: ignore[type-arg]
    """The designs of a result, best first; the first has index 0 and the number 1."""

    def __init__(self, result: "Result") -> None:
        self._result = result

    def __len__(self) -> int:
        return len(self._result.document["designs"])

    @overload
    def __getitem__(self, index: int) -> Design: ...

    @overload
    def __getitem__(self, index: slice) -> list[Design]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Design, list[Design]]:
        if isinstance(index, slice):
            return [Design(self._result, i) for i in range(*index.indices(len(self)))]
        size = len(self)
        if not -size <= index < size:
            raise IndexError(f"there are {size} designs, and {index} is none of them")
        return Design(self._result, index % size)

    def __repr__(self) -> str:
        return f"<{len(self)} designs of {self._result.name}>"


class Result:
    """The answer to a problem. Never changes; can be pickled, and shared between threads."""

    def __init__(self, answer: _core.Answer, name: str = "problem") -> None:
        self._answer = answer
        self._document: Optional[dict[str, Any]] = None
        self.name = name
        """What files made of it are called."""

    @property
    def document(self) -> dict[str, Any]:
        """The document ``cognate-result/1``, as ``cognate solve --json`` prints it."""
        if self._document is None:
            self._document = self._answer.document()
        return self._document

    @property
    def status(self) -> str:
        """``"solved"``, ``"infeasible"``, ``"no-solution"``, ``"time-limit"``, ``"interrupted"``."""
        return str(self.document["status"])

    @property
    def designs(self) -> Designs:
        """Best first; those that meet every constraint before others."""
        return Designs(self)

    @property
    def best(self) -> Design:
        """The first design; IndexError where there is none."""
        return self.designs[0]

    @property
    def problem(self) -> dict[str, Any]:
        """The tables of the problem with every default filled in."""
        return dict(self.document["problem"])

    @property
    def notes(self) -> list[str]:
        """Sentences: degeneracies, why nothing was found, impractical designs."""
        return [str(note) for note in self.document["notes"]]

    @property
    def warnings(self) -> list[str]:
        """Those of the designs, with their numbers."""
        return [str(warning) for warning in self.document.get("warnings", [])]

    @property
    def facts(self) -> Any:
        """Single numbers of the whole: how many solutions the equations have, the best hits."""
        return _values(self.document.get("facts", {}))

    @property
    def work(self) -> Any:
        """What was evaluated, in how many seconds."""
        return _values(self.document["work"])

    @property
    def columns(self) -> dict[str, "np.ndarray[Any, np.dtype[np.float64]]"]:
        """Of an analysis or a gear, the columns of its table by name, (n,); NaN where it has none."""
        for table in ("analysis", "gear"):
            if "columns" in self.document.get(table, {}):
                return {str(column["name"]): np.array(column["values"], dtype=float)
                        for column in self.document[table]["columns"]}
        return {}

    def csv(self) -> str:
        """The table that ``cognate`` writes as NAME.csv, of kinds that have one."""
        if not self._answer.has_csv:
            raise ProblemError([(None, None, None, "", "this result has no table of numbers")])
        return self._answer.csv()

    def to_columns(self) -> dict[str, Any]:
        """A row for each design, as a dictionary of columns: arrays of numbers, lists of words."""
        if self.columns:
            return dict(self.columns)
        rows = [design.row() for design in self.designs]
        names = {name: None for row in rows for name in row}
        return {name: _column([row.get(name) for row in rows]) for name in names}

    def to_frame(self) -> Any:
        """The same as a DataFrame of pandas, which must be installed."""
        try:
            import pandas  # type: ignore[import]
        except ImportError:
            raise ImportError("to_frame needs pandas; to_columns() gives the same columns "
                              "without it") from None
        frame = pandas.DataFrame(self.to_columns())
        if not self.columns:
            frame.index = pandas.RangeIndex(1, len(frame) + 1, name="design")
        return frame

    def report(self, path: Optional[PathLike] = None) -> Path:
        """Writes the report page, NAME.report.html without a path; it opens from disk."""
        if not self._answer.has_report:
            raise ProblemError([(None, None, None, "", "this result was loaded from a file; a report "
                                 "is made of a result that was computed here")])
        target = Path(os.fspath(path)) if path is not None else Path(f"{self.name}.report.html")
        write_whole(target, self._answer.report().encode())
        return target

    def save(self, path: Optional[PathLike] = None) -> Path:
        """Writes the result document, NAME.result.json without a path; :func:`load` reads it."""
        target = Path(os.fspath(path)) if path is not None else Path(f"{self.name}.result.json")
        write_whole(target, self._answer.json().encode())
        return target

    def export(self, format: str = "dxf", *, design: int = 1,  # noqa: A002
               out: Optional[PathLike] = ".", **options: Any) -> Exported:
        """Writes a design for CAD: see :func:`export`."""
        return exported(self._answer, self.name, format, design, out, options)

    def __repr__(self) -> str:
        return f"<Result: {self.status}, {len(self.designs)} designs>"

    def _repr_svg_(self) -> str:
        return self.best._repr_svg_() if len(self.designs) else _show.no_picture(self.status)

    def _repr_html_(self) -> str:
        return _show.result_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        document, page, table = self._answer.state()
        return _restored, (self.name, zlib.compress(document), zlib.compress(page),
                           zlib.compress(table))


def _restored(name: str, document: bytes, page: bytes, table: bytes) -> Result:
    parts = [zlib.decompress(part) for part in (document, page, table)]
    return Result(_core.answer_of_state(*parts), name)


def _column(values: list[Any]) -> Any:
    numbers = (int, float, type(None))
    if all(isinstance(value, numbers) and not isinstance(value, bool) for value in values):
        return np.array([np.nan if value is None else value for value in values], dtype=float)
    return values


__all__ = ["Constraint", "Checked", "Design", "Designs", "Exported", "Mechanism", "Result", "Values"]
