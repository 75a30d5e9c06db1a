#!/usr/bin/env python3
"""How little four-bars through the ten-point ellipse can err if every length is off, by code of its own.

    robust_ellipse.py [LONGEST] [STARTS] [SEED]
    robust_ellipse.py RESULT.json [SEED]

Searched is the design whose mean square error over the tolerances is least, to first order: each
distance of a target from the curve, and what a deviation of each length adds to it along the normal,
are residuals of scipy's least squares, from random linkages. Lengths are 5 to LONGEST (30). Printed
are, of the best twenty, the designs with the least 99 % quantile of the greatest error over 20 000
samples, and the best where deviations do not count. To be compared with robust_quantile and nominal_quantile of

    cognate solve problems/library/path/ellipse-robust.toml

Of the result of such a run, its most robust design and its nominal optimum are judged by a million
samples of numpy's own.

Needs python3-numpy and python3-scipy.
"""

import sys

import numpy as np
from scipy.optimize import least_squares

from robust_designs import judge, variables_of

TARGETS = np.array([20 + 10j, 17.66 + 15.142j, 11.736 + 17.878j, 5 + 16.928j, 0.60307 + 12.736j,
                    0.60307 + 7.2638j, 5 + 3.0718j, 11.736 + 2.1215j, 17.66 + 4.8577j])
SHORTEST, TOLERANCE, SIGMAS = 5, 0.05, 3
POINTS = len(TARGETS)


def along(n, v):
    """The component of v along the unit vector n."""
    return (np.conj(n) * v).real


def coupler_point(pivot, frame, lengths, point, side, crank):
    """The point, the joints B and C, and the coupler's direction."""
    r2, r3, r4 = lengths
    b = pivot + r2 * np.exp(1j * crank)
    diagonal = pivot + frame - b
    square = np.abs(diagonal) ** 2
    k = (square + r3 * r3 - r4 * r4) / (2 * square)
    height = np.sqrt(np.maximum(r3 * r3 / square - k * k, 1e-12))
    coupler = (k + side * 1j * height) * diagonal / r3
    return b + point * coupler, b, b + r3 * coupler, coupler


def not_closed(x):
    """By how much each position fails to close with some room."""
    pivot, frame, lengths, _, crank = unpacked(x)
    square = np.abs(pivot + frame - (pivot + lengths[0] * np.exp(1j * crank))) ** 2
    k = (square + lengths[1] ** 2 - lengths[2] ** 2) / (2 * square)
    return np.maximum(0, 1e-3 - (lengths[1] ** 2 / square - k * k))


def unpacked(x):
    r2, r3, r4, r1 = np.exp(x[2:6])
    return x[0] + 1j * x[1], r1 * np.exp(1j * x[6]), (r2, r3, r4), x[7] + 1j * x[8], x[9:]


def slopes(x, side):
    """What crank, coupler, rocker, frame and both coordinates of the point move along the normal."""
    pivot, frame, lengths, point, crank = unpacked(x)
    p, b, c, coupler = coupler_point(pivot, frame, lengths, point, side, crank)
    q, s = c - b, c - (pivot + frame)
    det = q.real * s.imag - q.imag * s.real

    def moved(b_moves, by_coupler, by_rocker, d_moves):
        first = along(q, b_moves) + lengths[1] * by_coupler
        second = along(s, d_moves) + lengths[2] * by_rocker
        c_moves = ((first * s.imag - second * q.imag) + 1j * (second * q.real - first * s.real)) / det
        turns = along(1j * coupler, c_moves - b_moves) / lengths[1]
        return b_moves + point * 1j * coupler * turns

    still, turned = np.zeros(POINTS, complex), np.exp(1j * crank)
    tangent = moved(1j * lengths[0] * turned, 0, 0, still)
    normal = 1j * tangent / np.abs(tangent)
    by_length = [moved(turned, 0, 0, still), moved(still, 1, 0, still), moved(still, 0, 1, still),
                 moved(still, 0, 0, still + frame / np.abs(frame)), coupler, 1j * coupler]
    return p, np.array([along(normal, v) for v in by_length])


def residuals(x, side, sigma):
    p, by_length = slopes(x, side)
    error = p - TARGETS
    return np.concatenate([error.real, error.imag, (sigma * by_length).ravel(),
                           10 * not_closed(x)])


def greatest_errors(x, side, count, random):
    """Of each sample the greatest distance from the targets, cranks following."""
    pivot, frame, lengths, point, crank = unpacked(x)
    change = random.normal(size=(6, count, 1)) * TOLERANCE / SIGMAS
    frame = frame * (1 + change[3] / abs(frame))
    lengths = [length + by for length, by in zip(lengths, change)]
    point = point + change[4] + 1j * change[5]
    crank = np.tile(crank, (count, 1))
    for _ in range(4):
        p, h = (coupler_point(pivot, frame, lengths, point, side, crank + d)[0] for d in (0, 1e-6))
        tangent = (h - p) / 1e-6
        crank = crank - along(tangent, p - TARGETS) / np.abs(tangent) ** 2
    error = np.abs(coupler_point(pivot, frame, lengths, point, side, crank)[0] - TARGETS)
    return error.max(axis=1)


def quantile(x, side, share=0.99, count=20000):
    """The greatest distance from the targets that this share of samples keeps."""
    return np.quantile(greatest_errors(x, side, count, np.random.default_rng(5)), share)


def search(longest, starts, seed, sigma):
    random = np.random.default_rng(seed)
    low = np.array([-80, -80, *np.log([SHORTEST] * 4), -20, -80, -80, *[-50] * POINTS])
    high = np.array([80, 80, *np.log([longest] * 4), 20, 80, 80, *[50] * POINTS])
    found = []
    while len(found) < starts:
        lengths = np.exp(random.uniform(np.log(SHORTEST), np.log(longest), 4))
        side, sense = random.choice([-1, 1], 2)
        crank = random.uniform(0, 2 * np.pi) + sense * np.linspace(0, 2 * np.pi, POINTS, endpoint=False)
        x = np.array([0, 0, *np.log(lengths), random.uniform(-np.pi, np.pi),
                      *(random.normal(size=2) * lengths[1] * 0.7), *crank])
        off = TARGETS.mean() - slopes(x, side)[0].mean()
        x[:2] += off.real, off.imag
        fit = least_squares(residuals, np.clip(x, low + 1e-6, high - 1e-6), bounds=(low, high),
                            args=(side, sigma), max_nfev=150)
        found.append((fit.cost, side, fit.x))
    return sorted(found, key=lambda one: one[0])


def of_design(design):
    """The variables and the side of a design of a result."""
    return variables_of(design, np.radians(design["crank_deg"][:POINTS]))


def main():
    if sys.argv[1:] and sys.argv[1].endswith(".json"):
        judge(sys.argv[1], int((sys.argv[2:] + ["7"])[0]), of_design, greatest_errors)
        return
    longest, starts, seed = (int(word) for word in (sys.argv[1:] + ["30", "200", "2"][len(sys.argv) - 1:]))
    for name, sigma in (("robust", TOLERANCE / SIGMAS), ("nominal", 1e-4)):
        best = search(longest, starts, seed, sigma)[:20]
        best_first = sorted(best, key=lambda one: quantile(one[2], one[1])) if name == "robust" else best
        for _, side, x in best_first[:3]:
            worst = np.abs(slopes(x, side)[0] - TARGETS).max()
            print(f"{name}: nominal error {worst:.4f}, 99 % quantile {quantile(x, side):.4f}, "
                  f"crank, coupler, rocker, frame {np.round(np.exp(x[2:6]), 2)}")


if __name__ == "__main__":
    main()
