"""What the program does with problems: solve, analyze, check, list, export."""

from __future__ import annotations

import os
from pathlib import Path
from collections import abc
from typing import Any, Optional, Union

from . import _core
from ._errors import ProblemError
from ._progress import Progress, shown
from ._result import Checked, Exported, Result, exported

Problem = Union[None, str, "os.PathLike[str]", abc.Mapping[str, Any]]


def _name_of(problem: Problem) -> str:
    if isinstance(problem, (str, os.PathLike)):
        return Path(os.fspath(problem)).stem
    return "problem"


def _compute(
    command: str,
    problem: Problem,
    tables: dict[str, Any],
    seed: int,
    threads: Optional[int],
    time_limit: Optional[float],
    progress: Progress,
) -> Result:
    with shown(progress) as report:
        answer = _core.compute(command, problem, tables, seed, threads, time_limit, report)
    return Result(answer, _name_of(problem))


def solve(
    problem: Problem = None,
    *,
    seed: int = 1,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Finds the designs of a problem, as ``cognate solve`` does, bit for bit.

    Parameters
    ----------
    problem
        The name of a problem file, or a dictionary with the keys of one.
    seed
        Of the random numbers, 0 to 2**53 - 1: the same seed gives the same designs on any number of
        threads.
    threads
        1 to 1024; as many as the machine has where it is None.
    time_limit
        In seconds; the best designs until then are returned.
    progress
        True shows a bar; a function is called with the share done (0 to 1) and the best objective
        so far (which may be infinite), and where it has a third parameter with the part of the run.
    tables
        The keys at the top of a file: ``kind``, ``target={...}``, ``bounds={...}``. They replace
        those of ``problem``. Angles are in degrees under keys that end in ``_deg``. Lists may be
        arrays, mechanisms may be objects of :class:`Mechanism`. None leaves a key out.

    Ctrl-C ends the search; the designs found so far are returned with the status
    ``"interrupted"``. A second one raises KeyboardInterrupt.

    Raises :class:`ProblemError` with every fault of the problem.

    >>> import cognate
    >>> result = cognate.solve(
    ...     kind="function-generation",
    ...     target={"function": "log10(x)", "domain": [1, 2], "input_range_deg": 60,
    ...             "output_range_deg": 90, "precision_points": 3})
    >>> result.status
    'solved'
    """
    return _compute("solve", problem, tables, seed, threads, time_limit, progress)


def analyze(
    problem: Problem = None,
    *,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    progress: Progress = None,
    **tables: Any,
) -> Result:
    """Evaluates a given mechanism over its drive, as ``cognate analyze`` does, bit for bit.

    The arguments are those of :func:`solve`; ``result.columns`` are the columns of its table.

    >>> import cognate
    >>> bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3)
    >>> result = cognate.analyze(kind="analysis", mechanism=bar, drive={"steps": 90})
    >>> result.columns["C_x"].shape
    (91,)
    """
    return _compute("analyze", problem, tables, 1, threads, time_limit, progress)


def check(problem: Problem = None, **tables: Any) -> Checked:
    """Reads a problem without solving it: what it is, or :class:`ProblemError` with its faults.

    ``problem`` of what is returned has the tables of the file with every default filled in.
    """
    read = _core.check(problem, tables)
    return Checked(read["description"], read["problem"])


def list(kind: str = "", *, metrics: bool = False) -> dict[str, Any]:  # noqa: A001
    """What this version can do: the document of ``cognate list --json``.

    Of one ``kind`` of problem, or of all; with ``metrics`` every number of the results and its
    unit.

    >>> import cognate
    >>> "problem_kinds" in cognate.list()
    True
    """
    return _core.list(kind, metrics)


def load(file: Union[str, "os.PathLike[str]"]) -> Result:
    """The result in a file NAME.result.json that the program or :meth:`Result.save` wrote.

    It can be looked at, exported and analysed; only a report needs the run itself.
    """
    if not isinstance(file, (str, os.PathLike)):
        raise ProblemError([(None, None, None, "file", f"file is of the type {type(file).__name__}; "
                             "expected the name of a file NAME.result.json")])
    path = Path(os.fspath(file))
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ProblemError([(str(path), None, None, "", f"cannot be read: {error}")]) from None
    name = path.name
    for ending in (".json", ".result"):
        name = name[: -len(ending)] if name.endswith(ending) else name
    return Result(_core.answer_of_document(text, str(path)), name)


def export(
    result: Union[Result, str, "os.PathLike[str]"],
    format: str = "dxf",  # noqa: A002
    *,
    design: int = 1,
    out: Union[str, "os.PathLike[str]", None] = ".",
    **options: Any,
) -> Exported:
    """Writes a design for CAD, as ``cognate export`` does.

    Parameters
    ----------
    result
        A result, or the name of a file NAME.result.json.
    format
        ``"dxf"``, ``"svg"``, ``"csv"``, ``"json"``, ``"dot"``, ``"toml"``, ``"step"`` or ``"stl"``.
    design
        Its number, counted from 1 as files do.
    out
        The folder of the files; None writes none, and ``.texts`` holds them.
    options
        All those of the command, with underscores: ``chord_tolerance``, ``position``, ``steps``,
        ``length_unit``, ``parts=True`` with ``hole`` and ``width``, ``bore=[8, 10]``, ...
    """
    given = result if isinstance(result, Result) else load(result)
    return exported(given._answer, given.name, format, design, out, options)
