"""Mechanisms as bodies under constraints, moved by Newton's method on all poses at once: they know nothing of
dyads, lengths or assemblies. Every body's axes are the global ones in the position drawn.
"""

import math

FAST = 40  # iterations after which a position counts as not reached


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

    def move(self, moved):
        """Moves on to a position of the drive, from where the bodies are. How far the linear system is from a
        singular one, 0 where the position is not reached."""
        poses = {**self.poses, self.driven: self._driven_pose(moved)}
        for _ in range(FAST):
            gaps = self._residuals(poses)
            unknowns = [(name, k) for name in self.names for k in range(3)]
            columns = []
            for name, k in unknowns:
                step = 1e-6
                ahead, behind = ([*poses[name]] for _ in range(2))
                ahead[k] += step
                behind[k] -= step
                above = self._residuals({**poses, name: tuple(ahead)})
                below = self._residuals({**poses, name: tuple(behind)})
                columns.append([(a - b) / (2 * step) for a, b in zip(above, below)])
            change, pivots = solve([list(row) for row in zip(*columns)], [-gap for gap in gaps])
            if change is None:
                return 0.0
            for (name, k), delta in zip(unknowns, change):
                pose = [*poses[name]]
                pose[k] += delta
                poses[name] = tuple(pose)
            if max(map(abs, change)) < 1e-13:
                self.poses = poses
                return pivots
        return 0.0

    def points(self):
        """Where the pins and points of links are."""
        return {joint["name"]: self.place(self.poses, joint["of"][0], joint["at"]) for joint in self.joints if "at" in joint}
