"""Mechanisms as bodies under constraints, moved by Newton's method on all poses at once: they know nothing of
dyads, lengths or assemblies. Every body's axes are the global ones in the position drawn.
"""

import math

MOST_ITERATIONS = 20  # after which a position counts as not reached
LARGE_MOVE = 0.1      # of a body at a time: beyond it Newton's method may find another assembly
MOST_HALVINGS = 8


def solve(matrix, right):
    """The solution of a linear system by elimination with pivots, and the smallest pivot's share of the
    largest."""
    n = len(right)
    rows = [row[:] + [value] for row, value in zip(matrix, right)]
    pivots = []
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        pivots.append(abs(rows[k][k]))
        if pivots[-1] == 0:
            return None, 0.0
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            if factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(rows[i][j] * x[j] for j in range(i + 1, n))) / rows[i][i]
    return x, min(pivots) / max(pivots)


class Bodies:
    """`joints`: {"name", "of", "at"} or {"name", "of", "direction_deg"}, as in a file."""

    def __init__(self, joints, driven):
        self.joints, self.driven = joints, driven
        self.names = sorted({link for joint in joints for link in joint["of"]} - {"frame", driven})
        self.poses = {name: (0.0, 0.0, 0.0) for name in [*self.names, "frame", driven]}
        self.at = 0.0
        self.drive = next(joint for joint in joints if driven in joint["of"] and "frame" in joint["of"])

    def place(self, poses, body, at):
        x, y, angle = poses[body]
        c, s = math.cos(angle), math.sin(angle)
        return (x + c * at[0] - s * at[1], y + s * at[0] + c * at[1])

    def _driven_pose(self, moved):
        """Turned by an angle about its pivot, or moved along its guide."""
        if "direction_deg" in self.drive:
            along = math.radians(self.drive["direction_deg"])
            return (moved * math.cos(along), moved * math.sin(along), 0.0)
        x, y = self.drive["at"]
        c, s = math.cos(moved), math.sin(moved)
        return (x - c * x + s * y, y - s * x - c * y, moved)

    def _residuals(self, poses):
        gaps = []
        for joint in self.joints:
            first = joint["of"][0]
            for other in joint["of"][1:]:
                if {first, other} == {"frame", self.driven}:
                    continue
                if "direction_deg" not in joint:
                    a, b = (self.place(poses, body, joint["at"]) for body in (first, other))
                    gaps += [a[0] - b[0], a[1] - b[1]]
                    continue
                (ax, ay, turn), (bx, by, other_turn) = poses[first], poses[other]
                along = math.radians(joint["direction_deg"]) + turn
                gaps += [other_turn - turn, math.cos(along) * (by - ay) - math.sin(along) * (bx - ax)]
        return gaps

    def _slopes(self, poses):
        """The rates of all residuals by each coordinate of each body, in columns."""
        step, columns = 1e-6, []
        for name in self.names:
            for k in range(3):
                ahead, behind = ([*poses[name]] for _ in range(2))
                ahead[k] += step
                behind[k] -= step
                above = self._residuals({**poses, name: tuple(ahead)})
                below = self._residuals({**poses, name: tuple(behind)})
                columns.append([(a - b) / (2 * step) for a, b in zip(above, below)])
        return columns

    def _reach(self, moved):
        """The poses at a position of the drive, by Newton's method from where the bodies are, and how far its
        linear system is from a singular one; None where it finds none nearby."""
        poses = {**self.poses, self.driven: self._driven_pose(moved)}
        for _ in range(MOST_ITERATIONS):
            rows = [list(row) for row in zip(*self._slopes(poses))]
            change, pivots = solve(rows, [-gap for gap in self._residuals(poses)])
            if change is None:
                return None
            for i, name in enumerate(self.names):
                poses[name] = tuple(x + dx for x, dx in zip(poses[name], change[3 * i:3 * i + 3]))
            far = max(abs(x - was) for name in self.names for x, was in zip(poses[name], self.poses[name]))
            if far > LARGE_MOVE:
                return None
            if max(map(abs, change)) < 1e-13:
                return poses, pivots
        return None

    def move(self, moved, halvings=0):
        """Moves on to a position of the drive, in short steps from where the bodies are. How far the linear
        system is from a singular one there, 0 where the position is not reached."""
        reached = self._reach(moved)
        if reached:
            self.poses, pivots = reached
            self.at = moved
            return pivots
        if halvings == MOST_HALVINGS or self.move((self.at + moved) / 2, halvings + 1) == 0:
            return 0.0
        return self.move(moved, halvings + 1)

    def points(self):
        """Where the pins and points of links are."""
        return {joint["name"]: self.place(self.poses, joint["of"][0], joint["at"]) for joint in self.joints if "at" in joint}


def is_determined(joints, driven="drive", least=1e-6):
    """Whether the rates of all bodies follow from that of the driven one."""
    if not any({"frame", driven} <= {*joint["of"]} for joint in joints):
        return False
    bodies = Bodies(joints, driven)
    columns = bodies._slopes(bodies.poses)
    if len(columns) != len(columns[0] if columns else []):
        return False
    return solve([list(row) for row in zip(*columns)], [0.0] * len(columns))[1] > least
