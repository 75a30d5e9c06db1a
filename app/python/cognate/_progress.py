"""A bar that shows how far a computation has come."""

from __future__ import annotations

import math
import sys
import time
import typing
from collections import abc
from typing import Optional, Union

Progress = Union[None, bool, abc.Callable[[float, float], object]]


class Bar:
    """A line on standard error that overwrites itself; gone when the computation has ended."""

    WIDTH = 24

    def __init__(self, stream: Optional[typing.TextIO] = None) -> None:
        self._stream = stream or sys.stderr
        self._begun = time.monotonic()
        self._length = 0

    def __call__(self, share: float, best: float) -> None:
        share = min(max(share, 0.0), 1.0)
        done = round(share * self.WIDTH)
        seconds = time.monotonic() - self._begun
        line = f"[{'#' * done}{'.' * (self.WIDTH - done)}] {100 * share:3.0f} %  {seconds:.1f} s"
        if share > 0.02:
            line += f", {seconds * (1 - share) / share:.1f} s left"
        if math.isfinite(best):
            line += f", best {best:.3g}"
        self._write(line)

    def close(self) -> None:
        if self._length:
            self._write("")
            self._stream.write("\r")
            self._stream.flush()

    def _write(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._length))
        self._stream.flush()
        self._length = len(line)


class shown:
    """The function to report progress to, while a computation runs."""

    def __init__(self, progress: Progress) -> None:
        self._bar = Bar() if progress is True else None
        self._function = self._bar or (None if progress is False else progress)

    def __enter__(self) -> object:
        return self._function

    def __exit__(self, *raised: object) -> None:
        if self._bar is not None:
            self._bar.close()
