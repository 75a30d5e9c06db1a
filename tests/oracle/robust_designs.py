"""Robust designs of results judged by samples, for the oracles of each kind."""

import json

import numpy as np


def variables_of(design, rest):
    """Pivot, logarithms of crank, coupler, rocker, frame, direction of the frame, the coupler's point, then
    `rest`; and the side of the assembly."""
    linkage = design["mechanism"]
    pivot, other = (complex(*at) for at in linkage["fixed_pivots"])
    lengths = [linkage[name] for name in ("crank", "coupler", "rocker")]
    frame = other - pivot
    x = np.array([pivot.real, pivot.imag, *np.log([*lengths, abs(frame)]), np.angle(frame),
                  *linkage["coupler_point"], *rest])
    return x, 1 if linkage["assembly"] == "open" else -1


def judge(path, seed, of_design, greatest_errors, pieces=20, count=50000):
    """Prints the 99 % quantile of the greatest error of the most robust design and of the nominal optimum."""
    with open(path, encoding="utf-8") as file:
        designs = json.load(file)["designs"]
    random = np.random.default_rng(seed)
    for name, design in (("robust", designs[0]), ("nominal", designs[-1])):
        x, side = of_design(design)
        errors = np.concatenate([greatest_errors(x, side, count, random) for _ in range(pieces)])
        print(f"{name}: 99 % quantile {np.quantile(errors, 0.99):.4f} of {errors.size} samples")
