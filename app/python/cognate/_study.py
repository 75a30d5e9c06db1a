"""Studies: a problem evaluated for many values of its numbers."""

from __future__ import annotations

import os
from pathlib import Path
from collections import abc
from typing import Any, Optional, Union

from . import _core, _show
from ._errors import ProblemError
from ._problems import Problem
from ._progress import Progress, shown
from ._result import Values, _values, make_folder, write_whole


class Study:
    """The rows of a study, kept in its file NAME.study.db, or as columns in NAME.study.h5.

    They are read when they are needed.
    """

    def __init__(self, file: Union[str, "os.PathLike[str]"], document: Optional[dict[str, Any]] = None,
                 page: str = "") -> None:
        self.file = Path(os.fspath(file))
        """The study file, an SQLite database, or columns in HDF5."""
        self.document = document or {}
        """``cognate-study/1``: what it varies, counts, and the best rows; empty where it was opened."""
        self._page = page

    @property
    def counts(self) -> Any:
        """How many designs were evaluated, kept, solved, ..."""
        found = {key: value for key, value in self.document.items() if isinstance(value, int)}
        return _values({**found, **self.document.get("counts", {})})

    def columns(self, names: abc.Sequence[str] = (), *, first: int = 0,
                most: Optional[int] = None) -> dict[str, Any]:
        """The rows by columns: ``id``, ``status``, the varied keys and the metrics.

        Numbers are arrays (n,), NaN where a row has none; words are lists. ``names`` chooses
        columns, ``first`` the least id, ``most`` the number of rows.
        """
        wanted = [names] if isinstance(names, str) else [*names]
        return _core.read_rows(str(self.file), first, most, wanted)

    def blocks(self, rows: int = 100_000, names: abc.Sequence[str] = ()) -> abc.Iterator[dict[str, Any]]:
        """The same in blocks of so many rows, for studies that are larger than the memory."""
        if rows == 0:
            raise _fault("rows", "is 0; 1 or more are allowed")
        first = 0
        while True:
            block = self.columns(names, first=first, most=rows)
            if not len(block["id"]):
                return
            yield block
            first = int(block["id"][-1]) + 1

    def to_frame(self, names: abc.Sequence[str] = ()) -> Any:
        """The rows as a DataFrame of pandas, which must be installed, by ``id``."""
        try:
            import pandas  # type: ignore[import]
        except ImportError:
            raise ImportError("to_frame needs pandas; columns() gives the same columns without "
                              "it") from None
        frame = pandas.DataFrame(self.columns(names))
        frame["id"] = frame["id"].astype("int64")
        return frame.set_index("id")

    def report(self, path: Union[str, "os.PathLike[str]", None] = None) -> Path:
        """Writes the report page of the sweep, NAME.report.html without a path."""
        name = self.file.name.removesuffix(".study.db")
        target = Path(os.fspath(path)) if path is not None else Path(f"{name}.report.html")
        if not self._page:
            raise ValueError("this study was opened; sweep() makes the report")
        write_whole(target, self._page.encode())
        return target

    def __repr__(self) -> str:
        return f"<Study {self.file}>"

    def _repr_html_(self) -> str:
        columns = self.columns(most=10)
        names = list(columns)
        rows = [{name: columns[name][i] for name in names} for i in range(len(columns["id"]))]
        return f"<p><b>{self.file.name}</b></p>" + _show._table(rows)


def sweep(
    study: Problem = None,
    *,
    out: Union[str, "os.PathLike[str]"] = ".",
    name: Optional[str] = None,
    seed: int = 1,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    progress: Progress = None,
    **tables: Any,
) -> Study:
    """Evaluates the designs of a study that are not yet in its file, as ``cognate sweep`` does.

    ``study`` is the name of a study file or a dictionary with its keys; ``tables`` are its keys as
    keywords: ``vary=[{...}]``, ``output={...}``, ``filter={...}``, ``objective={...}``. ``base`` is
    the name of a file, relative to the study file or to the working folder, or a dictionary, which
    is written to NAME.base.toml in the folder ``out``. Rows are stored in NAME.study.db there;
    Ctrl-C and the time limit lose none of them, and the same call continues.
    """
    if name is not None and (not isinstance(name, str) or Path(name).name != name):
        raise _fault("name", f"is {name!r}; expected what files are to be called, without a folder")
    if not isinstance(out, (str, os.PathLike)):
        raise _fault("out", f"is of the type {type(out).__name__}; expected a folder")
    stem = name or (Path(os.fspath(study)).stem if isinstance(study, (str, os.PathLike)) else "study")
    folder = Path(os.fspath(out))
    keys = dict(tables)
    if isinstance(study, abc.Mapping):
        keys, study = {**study, **keys}, None
    if isinstance(keys.get("base"), abc.Mapping):
        make_folder(folder)
        base = folder / f"{stem}.base.toml"
        write_whole(base, _core.toml_text(dict(keys["base"])).encode())
        keys["base"] = str(base.resolve())
    run = {"seed": seed, "threads": threads, "time_limit": time_limit}
    with shown(progress) as report:
        document, page, file = _core.sweep(study, keys, stem, str(folder), {**run, "progress": report})
    return Study(file, document, page)


def _fault(key: str, message: str) -> ProblemError:
    return ProblemError([(None, None, None, key, f"{key} {message}")])


__all__ = ["Study", "Values", "sweep"]
