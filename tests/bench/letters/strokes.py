"""Capitals of a single-stroke font as paths that a pen draws without being lifted.

The font is Hershey's Roman simplex of 1967 (Debian: hershey-fonts-data), in which a letter is a few
polylines. Where a letter has several, or a fork, the pen goes over some of its lines twice: over the
shortest that do (the route of Chinese postman's problem, open at its ends).
"""

import itertools
import pathlib

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import shortest_path

FONT = pathlib.Path("/usr/share/hershey-fonts/rowmans.jhf")
ORIGIN = ord("R")
# Ends that are so near to a line, of a height of 21, touch it.
TOUCHES = 1.1


def polylines(letter, font=FONT):
    """The polylines of a letter, y upward, its height 1."""
    line = font.read_text(encoding="ascii").splitlines()[ord(letter) - ord(" ")]
    codes = line[10:]
    lines = [[]]
    for x, y in zip(codes[::2], codes[1::2]):
        if (x, y) == (" ", "R"):
            lines.append([])
        else:
            lines[-1].append((ord(x) - ORIGIN, ORIGIN - ord(y)))
    lines = [np.array(one, float) for one in lines]
    low = min(one[:, 1].min() for one in lines)
    high = max(one[:, 1].max() for one in lines)
    return [(one - (0, low)) / (high - low) for one in lines], TOUCHES / (high - low)


def nearest_on(point, start, end):
    """The point of a segment next to a point."""
    along = end - start
    share = np.clip(np.dot(point - start, along) / np.dot(along, along), 0, 1)
    return start + share * along


def crossings(lines):
    """The points at which two polylines cross."""
    for one, other in itertools.combinations(lines, 2):
        for (a, b), (c, d) in itertools.product(itertools.pairwise(one), itertools.pairwise(other)):
            matrix = np.column_stack([b - a, c - d])
            if abs(np.linalg.det(matrix)) < 1e-12:
                continue
            shares = np.linalg.solve(matrix, c - a)
            if np.all((shares >= 0) & (shares <= 1)):
                yield a + shares[0] * (b - a)


def joined(lines, touches):
    """Points and edges of the letter as a graph: ends that touch a line become points of it."""
    ends = [one[k] for one in lines for k in (0, -1)] + list(crossings(lines))
    points = []

    def number(point):
        for i, known in enumerate(points):
            if np.hypot(*(known - point)) < touches:
                return i
        points.append(point)
        return len(points) - 1

    edges = set()
    for end in ends:
        number(end)
    for one in lines:
        row = [number(one[0])]
        for start, end in itertools.pairwise(one):
            between = [(np.hypot(*(near - start)), number(near)) for near in
                       (nearest_on(p, start, end) for p in ends)
                       if any(np.hypot(*(near - p)) < touches for p in ends)]
            row += [i for _, i in sorted(between, key=lambda pair: pair[0])] + [number(end)]
        edges |= {tuple(sorted(pair)) for pair in itertools.pairwise(row) if pair[0] != pair[1]}
    return np.array(points), sorted(edges)


def pairings(odd):
    """All ways to pair a list but for two."""
    if len(odd) == 2:
        yield []
        return
    for a, b in itertools.combinations(odd, 2):
        rest = [i for i in odd if i not in (a, b)]
        for more in pairings(rest):
            yield [(a, b)] + more


def doubled(points, edges):
    """The edges with those that the pen goes over twice."""
    count = len(points)
    lengths = [np.hypot(*(points[a] - points[b])) for a, b in edges]
    graph = csr_matrix((lengths, np.array(edges).T), (count, count))
    far, before = shortest_path(graph, directed=False, return_predecessors=True)
    degree = np.bincount(np.array(edges).ravel(), minlength=count)
    odd = [i for i in range(count) if degree[i] % 2]
    if len(odd) <= 2:
        return list(edges)
    best = min(pairings(odd), key=lambda pairs: sum(far[a, b] for a, b in pairs))
    route = list(edges)
    for a, b in best:
        while b != a:
            route.append((before[a, b], b))
            b = before[a, b]
    return route


def walk(edges):
    """The points of a walk over every edge once (Hierholzer)."""
    beside = {}
    for k, (a, b) in enumerate(edges):
        beside.setdefault(a, []).append((b, k))
        beside.setdefault(b, []).append((a, k))
    odd = [i for i, all_ in beside.items() if len(all_) % 2]
    used, stack, route = set(), [odd[0] if odd else min(beside)], []
    while stack:
        free = [pair for pair in beside[stack[-1]] if pair[1] not in used]
        if free:
            used.add(free[0][1])
            stack.append(free[0][0])
        else:
            route.append(stack.pop())
    return route


def pen_path(letter, count, font=FONT):
    """`count` points of the letter in the order of the pen, at equal distances; whether it is closed."""
    lines, touches = polylines(letter, font)
    points, edges = joined(lines, touches)
    corners = points[walk(doubled(points, edges))]
    steps = np.hypot(*np.diff(corners, axis=0).T)
    along = np.concatenate([[0], np.cumsum(steps)])
    closed = bool(np.hypot(*(corners[0] - corners[-1])) < 1e-9)
    at = np.linspace(0, along[-1], count + closed)[:count]
    return np.column_stack([np.interp(at, along, corners[:, k]) for k in (0, 1)]), closed
