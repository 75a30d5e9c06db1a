"""Faults of problems and of arguments."""

from __future__ import annotations

import typing
from collections import abc
from typing import Optional


class Fault(typing.NamedTuple):
    """One fault: what is wrong and what is allowed, and where."""

    file: Optional[str]
    """Name of the file; None where the problem came as a dictionary or keywords."""
    line: Optional[int]
    """In the file, counted from 1; None without a file."""
    column: Optional[int]
    """In characters, counted from 1; None without a file."""
    key: str
    """The key, ``"target.points[2]"``, entries counted from 0; empty where it is the whole."""
    message: str
    """What is wrong; what is allowed. Messages count entries from 1, as files do."""

    def __str__(self) -> str:
        if self.file is None:
            return self.message
        if self.line is None:
            return f"{self.file}: {self.message}"
        return f"{self.file}:{self.line}:{self.column}: {self.message}"


class ProblemError(ValueError):
    """A problem, or arguments, with faults: all of them at once.

    >>> import cognate
    >>> try:
    ...     cognate.check(kind="path-generation", target={"points": [[0, 0], [1, 1]]}, solver="x")
    ... except cognate.ProblemError as error:
    ...     print([fault.key for fault in error.faults])
    ['target.points', 'solver']
    """

    def __init__(self, faults: abc.Sequence[abc.Sequence[object]]) -> None:
        self.faults = tuple(Fault(*fault) for fault in faults)  # type: ignore[arg-type]
        super().__init__("\n".join(str(fault) for fault in self.faults))

    def __reduce__(self) -> tuple[type, tuple[list[tuple[object, ...]]]]:
        return type(self), ([tuple(fault) for fault in self.faults],)

    @property
    def file(self) -> Optional[str]:
        """Of the first fault."""
        return self.faults[0].file

    @property
    def line(self) -> Optional[int]:
        """Of the first fault."""
        return self.faults[0].line

    @property
    def column(self) -> Optional[int]:
        """Of the first fault."""
        return self.faults[0].column

    @property
    def key(self) -> str:
        """Of the first fault."""
        return self.faults[0].key

    @property
    def message(self) -> str:
        """Of the first fault."""
        return self.faults[0].message
