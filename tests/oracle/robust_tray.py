#!/usr/bin/env python3
"""How little four-bars that guide the tipping tray can err if every length is off, by code of its own.

    robust_tray.py [STARTS] [SEED]
    robust_tray.py RESULT.json [SEED]

Searched is the design whose mean square error over the tolerances is least, to first order: the
errors of place and angle at each pose, and what a deviation of each length adds to them, both
without what the crank can take away, are residuals of scipy's least squares, from random linkages.
Printed are, of the best twenty, the designs with the least 99 % quantile of the greatest error over
20 000 samples, and the best where deviations do not count. To be compared with robust_quantile and
nominal_quantile of

    cognate solve problems/library/motion/tipping-tray-robust.toml

Of the result of such a run, its most robust design and its nominal optimum are judged by a million
samples of numpy's own.

Needs python3-numpy and python3-scipy.
"""

import sys

import numpy as np
from scipy.optimize import least_squares

from robust_designs import judge, variables_of

PLACES = np.array([0, 12 + 9j, 23 + 14j, 32 + 15j, 41 + 12j, 48 + 6j])
ANGLES = np.radians([0, 8, 21, 38, 55, 70])
WEIGHT = np.sqrt(np.mean(np.abs(PLACES - PLACES.mean()) ** 2))  # what a radian counts
SHORTEST, LONGEST, TOLERANCE, SIGMAS = 3, 80, 0.6, 3
POSES = len(PLACES)
LENGTHS = slice(2, 6)  # crank, coupler, rocker, frame
STEP = 1e-5


def body(x, side, changes=np.zeros((6, 1)), crank=None):
    """Place and angle of the body at every pose, and by how much the linkage fails to close with
    some room; a row for each column of changes. x: pivot, logarithms of the lengths, direction of
    the frame, place and angle of the body in the coupler, crank angles unless others are given."""
    crank = x[10:] if crank is None else crank
    r2, r3, r4, r1 = (np.exp(x[LENGTHS])[:, None] + changes[:4])[:, :, None]
    b = x[0] + 1j * x[1] + r2 * np.exp(1j * crank)
    diagonal = x[0] + 1j * x[1] + r1 * np.exp(1j * x[6]) - b
    square = np.abs(diagonal) ** 2
    k = (square + r3 * r3 - r4 * r4) / (2 * square)
    room = r3 * r3 / square - k * k
    coupler = (k + side * 1j * np.sqrt(np.maximum(room, 1e-12))) * diagonal
    coupler = coupler / np.abs(coupler)
    point = (x[7] + changes[4] + 1j * (x[8] + changes[5]))[:, None]
    return b + point * coupler, np.angle(coupler) + x[9], np.maximum(0, 1e-3 - room)


def errors(place, angle):
    """Three components at each pose."""
    off = place - PLACES
    turned = np.remainder(angle - ANGLES + np.pi, 2 * np.pi) - np.pi
    return np.stack([off.real, off.imag, WEIGHT * turned])


def residuals(x, side, sigma):
    place, angle, opened = body(x, side)
    error = errors(place, angle)
    tangent = (errors(*body(x, side, crank=x[10:] + STEP)[:2]) - error) / STEP
    tangent /= np.sqrt((tangent ** 2).sum(axis=0)) + 1e-12
    made = [error]
    for i in range(6 if sigma else 0):
        changes = np.zeros((6, 1))
        changes[i] = STEP
        by = (errors(*body(x, side, changes)[:2]) - error) / STEP
        made.append(sigma * (by - tangent * (tangent * by).sum(axis=0)))
    return np.concatenate([np.ravel(made), 100 * np.ravel(opened)])


def greatest_errors(x, side, count, random):
    """Of each sample the greatest error over the poses, the crank following; infinite where it
    cannot be assembled."""
    changes = random.normal(size=(6, count)) * TOLERANCE / SIGMAS
    crank = np.tile(x[10:], (count, 1))
    for _ in range(5):
        now = errors(*body(x, side, changes, crank)[:2])
        tangent = (errors(*body(x, side, changes, crank + 1e-6)[:2]) - now) / 1e-6
        crank = crank - (tangent * now).sum(axis=0) / (tangent ** 2).sum(axis=0)
    place, angle, opened = body(x, side, changes, crank)
    error = np.sqrt((errors(place, angle) ** 2).sum(axis=0))
    return np.where(opened >= 1e-3, np.inf, error).max(axis=1)


def quantile(x, side, share=0.99, count=20000):
    return np.quantile(greatest_errors(x, side, count, np.random.default_rng(5)), share)


def search(starts, seed, sigma):
    random = np.random.default_rng(seed)
    low = np.array([-300, -300, *np.log([SHORTEST] * 4), -20, -300, -300, -20, *[-50] * POSES])
    high = np.array([300, 300, *np.log([LONGEST] * 4), 20, 300, 300, 20, *[50] * POSES])
    found = []
    while len(found) < starts:
        lengths = np.exp(random.uniform(np.log(15), np.log(LONGEST), 4))
        side, sense = random.choice([-1, 1], 2)
        crank = random.uniform(0, 2 * np.pi) + sense * np.linspace(0, random.uniform(0.5, 3), POSES)
        x = np.array([0, 0, *np.log(lengths), random.uniform(-np.pi, np.pi),
                      *(random.normal(size=2) * lengths[1] * 0.7), 0, *crank])
        place, angle, opened = body(x, side)
        if opened.max() > 0:
            continue
        off = (PLACES - place).mean()
        x[:2] += off.real, off.imag
        x[9] = np.angle(np.exp(1j * (ANGLES - angle)).mean())
        fit = least_squares(residuals, np.clip(x, low + 1e-6, high - 1e-6), bounds=(low, high),
                            args=(side, sigma), max_nfev=120)
        if body(fit.x, side)[2].max() == 0:
            found.append((fit.cost, side, fit.x))
    return sorted(found, key=lambda one: one[0])


def of_design(design):
    """The variables and the side of a design of a result."""
    return variables_of(design, [np.radians(design["metrics"]["body_angle_in_link_deg"]), *np.radians(design["crank_deg"])])


def main():
    if sys.argv[1:] and sys.argv[1].endswith(".json"):
        judge(sys.argv[1], int((sys.argv[2:] + ["7"])[0]), of_design, greatest_errors)
        return
    starts, seed = (int(word) for word in (sys.argv[1:] + ["200", "2"][len(sys.argv) - 1:]))
    for name, sigma in (("robust", TOLERANCE / SIGMAS), ("nominal", 0)):
        best = search(starts, seed, sigma)[:20]
        best_first = sorted(best, key=lambda one: quantile(one[2], one[1])) if name == "robust" else best
        for _, side, x in best_first[:3]:
            worst = np.sqrt((errors(*body(x, side)[:2]) ** 2).sum(axis=0)).max()
            print(f"{name}: nominal error {worst:.4f}, 99 % quantile {quantile(x, side):.4f}, "
                  f"crank, coupler, rocker, frame {np.round(np.exp(x[LENGTHS]), 2)}")


if __name__ == "__main__":
    main()
