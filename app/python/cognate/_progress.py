"""A bar that shows how far a computation has come."""

from __future__ import annotations

import inspect
import sys
import typing
from collections import abc
from typing import Optional, Union

Progress = Union[None, bool, abc.Callable[[float, float], object], abc.Callable[[float, float, str], object]]


class Bar:
    """A line on standard error that overwrites itself; gone when the computation has ended."""

    WIDTH = 24

    def __init__(self, stream: Optional[typing.TextIO] = None) -> None:
        self._stream = stream or sys.stderr
        self._length = 0

    def __call__(self, share: float, best: float, part: str, words: str) -> None:
        share = min(max(share, 0.0), 1.0)
        done = round(share * self.WIDTH)
        self._write(f"[{'#' * done}{'.' * (self.WIDTH - done)}] {100 * share:3.0f} %  {words}".rstrip())

    def close(self) -> None:
        if self._length:
            self._write("")
            self._stream.write("\r")
            self._stream.flush()

    def _write(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._length))
        self._stream.flush()
        self._length = len(line)


def _takes(function: abc.Callable[..., object], *values: object) -> bool:
    try:
        inspect.signature(function).bind(*values)
    except (TypeError, ValueError):  # the latter where nothing is known of its parameters
        return False
    return True


def _called(function: abc.Callable[..., object]) -> abc.Callable[[float, float, str, str], object]:
    """What calls `function` with share and best, and with the part where it needs a third value."""
    if not _takes(function, 0.0, 0.0) and _takes(function, 0.0, 0.0, ""):
        return lambda share, best, part, _: function(share, best, part)
    return lambda share, best, _, __: function(share, best)


class shown:
    """The function to report progress to, while a computation runs."""

    def __init__(self, progress: Progress) -> None:
        self._bar = Bar() if progress is True else None
        given = None if progress is False else progress
        self._function = self._bar or (_called(given) if callable(given) else given)

    def __enter__(self) -> object:
        return self._function

    def __exit__(self, *raised: object) -> None:
        if self._bar is not None:
            self._bar.close()
