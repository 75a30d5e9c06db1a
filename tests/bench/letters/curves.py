"""The curves of designs by a closure of their own, and how far they are from letters.

Nothing of the program enters but the dimensions in its result: dyads are closed by circles that meet.
"""

import numpy as np


def dyad(first, second, lengths, assembly):
    """The joint of two links, to the left of the line from the first to the second where open."""
    along = second - first
    square = np.abs(along) ** 2
    share = (lengths[0] ** 2 - lengths[1] ** 2 + square) / (2 * square)
    height = np.sqrt(lengths[0] ** 2 / square - share ** 2)
    return first + along * (share + (1j if assembly == "open" else -1j) * height)


def trace(mechanism, angles, point="P"):
    """The places of a point of a chain as complex numbers at the angles of its crank; NaN where it does
    not close."""
    places = {pivot["name"]: np.full(len(angles), complex(*pivot["at"])) for pivot in mechanism["pivot"]}
    crank = mechanism["crank"]
    places[crank["pin"]] = places[crank["at"]] + crank["length"] * np.exp(1j * angles)
    waiting = [*mechanism["dyad"], *mechanism.get("point", [])]
    while waiting:
        part = next(one for one in waiting if set(one.get("joins", one.get("on"))) <= places.keys())
        waiting.remove(part)
        if "joins" in part:
            first, second = (places[name] for name in part["joins"])
            with np.errstate(invalid="ignore"):
                places[part["new"]] = dyad(first, second, part["lengths"], part["assembly"])
        else:
            origin, towards = (places[name] for name in part["on"])
            axis = (towards - origin) / np.abs(towards - origin)
            places[part["name"]] = origin + complex(*part["at"]) * axis
    return places[point]


def written(crank_deg, closed):
    """The crank's angles while it writes, in radians: the first and how far it turns."""
    steps = np.diff(crank_deg)
    forward, backward = np.sum((steps + 1e-6) % 360), -np.sum((-steps + 1e-6) % 360)
    turned = forward if forward < -backward else backward
    return np.radians(crank_deg[0]), np.radians(np.copysign(360, turned) if closed else turned)


def distances(points, line):
    """Of each point to the nearest of a polyline."""
    start, along = line[:-1], np.diff(line)
    square = np.maximum(np.abs(along) ** 2, 1e-300)
    offset = points[:, None] - start
    share = np.clip((offset * np.conj(along)).real / square, 0, 1)
    return np.abs(offset - share * along).min(axis=1)


def mean_distance(curve, letter):
    """The mean of the distances from the letter to the curve and from the curve to the letter, each taken
    at equal steps along the way."""
    return (distances(evenly(letter), curve).mean() + distances(evenly(curve), letter).mean()) / 2


def evenly(line, count=600):
    """Points at equal distances along a polyline."""
    along = np.concatenate([[0], np.cumsum(np.abs(np.diff(line)))])
    at = np.linspace(0, along[-1], count)
    return np.interp(at, along, line.real) + 1j * np.interp(at, along, line.imag)
