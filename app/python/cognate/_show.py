"""How results and mechanisms look in a notebook: pictures that move without a script."""

from __future__ import annotations

import html
import math
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ._errors import ProblemError

if TYPE_CHECKING:
    from . import _result
    from . import mechanisms as _mechanisms

_STEPS = 72
_SECONDS = 4
_MOST_ROWS = 10
_COLOURS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#8c564b", "#e377c2", "#17becf", "#7f7f7f")


def _closed_run(closed: Any) -> Any:
    """The indices of the longest run of True, which may pass the end."""
    if closed.all():
        return np.arange(len(closed))
    if not closed.any():
        return np.array([], dtype=int)
    start = int(np.argmin(closed))  # a gap: the run does not pass it
    order = (start + np.arange(len(closed))) % len(closed)
    best: list[int] = []
    run: list[int] = []
    for index in order:
        run = [*run, int(index)] if closed[index] else []
        best = run if len(run) > len(best) else best
    return np.array(best, dtype=int)


def _is_driven_by_length(mechanism: "_mechanisms.Mechanism") -> bool:
    tables = mechanism.tables()
    return tables.get("slider") is not None or tables.get("cylinder") is not None


def _frames(mechanism: "_mechanisms.Mechanism", stations: Any) -> dict[str, Any]:
    """Where the points are, frame by frame: over the turn, or to and fro where that is not closed."""
    if _is_driven_by_length(mechanism):
        ends = (min(stations), max(stations)) if stations is not None and len(stations) else (0, 0)
        angles = np.linspace(*ends, _STEPS)
    else:
        angles = np.linspace(0, 2 * math.pi, _STEPS, endpoint=False)
    points = mechanism.positions(angles)
    closed = np.all([np.isfinite(p).all(axis=1) for p in points.values()], axis=0)
    run = _closed_run(closed)
    if len(run) < _STEPS or _is_driven_by_length(mechanism):
        run = np.concatenate([run, run[-2:0:-1]]) if len(run) > 2 else run
    return {name: place[run] for name, place in points.items()}


def _text(number: float) -> str:
    return f"{number:.5g}"


def _points(rows: Any) -> str:
    return " ".join(f"{_text(x)},{_text(-y)}" for x, y in rows)


class _Picture:
    """The elements of a drawing whose y axis points upwards."""

    def __init__(self, frames: dict[str, Any], moving: bool) -> None:
        self.frames = frames
        self.moving = moving and len(next(iter(frames.values()))) > 1
        everything = np.concatenate(list(frames.values()))
        self.low, self.high = everything.min(axis=0), everything.max(axis=0)
        self.size = float(max(self.high - self.low)) or 1.0
        self.parts: list[str] = []

    def _moved(self, attribute: str, values: list[str]) -> str:
        if not self.moving:
            return ""
        return (f'<animate attributeName="{attribute}" dur="{_SECONDS}s" repeatCount="indefinite" '
                f'values="{";".join([*values, values[0]])}"/>')

    def path(self, name: str) -> None:
        self.parts.append(f'<polyline points="{_points(self.frames[name])}" fill="none" '
                          f'stroke="#999" stroke-width="{_text(self.size / 300)}"/>')

    def link(self, names: list[str], colour: str, dashed: bool = False) -> None:
        shapes = [_points([self.frames[name][i] for name in names])
                  for i in range(len(self.frames[names[0]]))]
        dash = f' stroke-dasharray="{_text(self.size / 50)}"' if dashed else ""
        self.parts.append(
            f'<polygon points="{shapes[0]}" fill="{colour}" fill-opacity="0.15" stroke="{colour}" '
            f'stroke-linejoin="round" stroke-width="{_text(self.size / 100)}"{dash}>'
            f'{self._moved("points", shapes)}</polygon>')

    def joint(self, name: str, fixed: bool) -> None:
        rows = self.frames[name]
        fill = "#333" if fixed else "white"
        xs, ys = [_text(x) for x, _ in rows], [_text(-y) for _, y in rows]
        moved = "" if fixed else self._moved("cx", xs) + self._moved("cy", ys)
        self.parts.append(f'<circle cx="{xs[0]}" cy="{ys[0]}" r="{_text(self.size / 80)}" '
                          f'fill="{fill}" stroke="#333" stroke-width="{_text(self.size / 250)}">'
                          f"{moved}<title>{html.escape(name)}</title></circle>")

    def target(self, points: Any) -> None:
        for x, y in points:
            self.low, self.high = np.minimum(self.low, (x, y)), np.maximum(self.high, (x, y))
            self.parts.append(f'<circle cx="{_text(x)}" cy="{_text(-y)}" '
                              f'r="{_text(self.size / 120)}" fill="#e07b00"/>')

    def svg(self) -> str:
        margin = self.size / 15
        x, y = self.low[0] - margin, -self.high[1] - margin
        width, height = self.high - self.low + 2 * margin
        scale = 420 / max(width, height)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{_text(scale * width)}" '
                f'height="{_text(scale * height)}" viewBox="{_text(x)} {_text(y)} {_text(width)} '
                f'{_text(height)}">{"".join(self.parts)}</svg>')


def mechanism_svg(mechanism: "_mechanisms.Mechanism", stations: Any = None, targets: Any = (),
                  moving: bool = True) -> str:
    """A mechanism with the paths of its points, moving over its drive."""
    frames = _frames(mechanism, stations)
    if not len(next(iter(frames.values()))):
        return no_picture("it cannot be assembled")
    picture = _Picture(frames, moving)
    for name in mechanism.point_names[2:]:
        picture.path(name)
    picture.target(targets)
    links, slides = mechanism.skeleton()
    for i, names in enumerate(links[1:]):
        if len(names) > 1:
            picture.link(names, _COLOURS[i % len(_COLOURS)])
    for slide in slides:
        picture.link(list(slide), "#555", dashed=True)
    for name in mechanism.point_names:
        picture.joint(name, name in links[0])
    return picture.svg()


def no_picture(why: str) -> str:
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="320" height="40"><text x="4" y="24" '
            f'font-family="sans-serif" font-size="13">no picture: {html.escape(why)}</text></svg>')


def _targets(design: "_result.Design") -> Any:
    points = design._result.document["problem"].get("target", {})
    rows = points.get("points", ()) if isinstance(points, dict) else ()
    return [row for row in rows if isinstance(row, list) and len(row) == 2]


def moving_picture(design: "_result.Design", moving: bool = True) -> Optional[str]:
    """The design in motion where it is a linkage."""
    if not design.is_linkage:
        return None
    return mechanism_svg(design.mechanism, design.crank_angles, _targets(design), moving)


def still_picture(design: "_result.Design") -> str:
    """The design in one position: of cams and gears the drawing that an export makes."""
    picture = moving_picture(design, moving=False)
    if picture is not None:
        return picture
    try:
        texts = design.export("svg", out=None).texts
    except ProblemError as error:  # bevel gears, machines without a shape
        return no_picture(error.message)
    return next(iter(texts.values())).decode() if texts else no_picture("nothing to draw")


def _number(value: Any) -> str:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return html.escape(str(value))
    return f"{value:.5g}"


def _table(rows: list[dict[str, Any]]) -> str:
    names = list({name: None for row in rows for name in row})
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{_number(row.get(name, ''))}</td>" for name in names)
                   + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _brief(design: "_result.Design") -> dict[str, Any]:
    row = design.row()
    wanted = ("class", "error.rms", "error.rms_deg", "error.max", "transmission_angle_deg.acute_min",
              "time_ratio")
    short = {name: row[name] for name in wanted if row.get(name) is not None}
    links = {name.split(".", 1)[1]: row[name] for name in row
             if name.startswith("mechanism.") and isinstance(row[name], float)
             and "[" not in name}
    return {"design": design.number, **links, **short, "feasible": row["feasible"]}


def result_html(result: "_result.Result") -> str:
    """The best design moving, the table of the designs, and the notes."""
    count = len(result.designs)
    head = f"<p><b>{html.escape(result.status)}</b>, {count} design{'s' if count != 1 else ''}</p>"
    rows = [_brief(design) for design in result.designs[:_MOST_ROWS]]
    notes = "".join(f"<li>{html.escape(note)}</li>" for note in result.notes)
    return (head + (_moving(result.best) if count else "") + (_table(rows) if rows else "")
            + (f"<ul>{notes}</ul>" if notes else ""))


def _moving(design: "_result.Design") -> str:
    picture = moving_picture(design)
    if picture is not None:
        return picture
    if design.number == 1 and design._result._answer.has_report:
        page = html.escape(design._result._answer.report(), quote=True)
        return f'<iframe srcdoc="{page}" width="100%" height="560" style="border:0"></iframe>'
    return still_picture(design)


def design_html(design: "_result.Design") -> str:
    """The design moving, its numbers, and its warnings."""
    warnings = "".join(f"<li>{html.escape(text)}</li>" for text in design.warnings)
    return _moving(design) + _table([_brief(design)]) + (f"<ul>{warnings}</ul>" if warnings else "")
