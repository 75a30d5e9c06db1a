"""Samples of tolerances against a second method: linkages by complex numbers, cams by the points of
their profile, both drawn by numpy. Means and standard deviations agree within four standard errors.

Run as: tolerances_test.py, with the module on PYTHONPATH.
"""

import unittest

import cognate
import numpy as np

OWN = 200_000
ELLIPSE = [[50, 0], [40.45, 11.76], [15.45, 19.02], [-15.45, 19.02], [-40.45, 11.76],
           [-50, 0], [-40.45, -11.76], [-15.45, -19.02], [15.45, -19.02], [40.45, -11.76]]
MOTION = [{"law": "cycloidal", "rise": 20, "over_deg": 120}, {"law": "dwell", "over_deg": 60},
          {"law": "cycloidal", "rise": -20, "over_deg": 120}, {"law": "dwell", "over_deg": 60}]


def normal(seed, tolerance, count, samples=OWN):
    """Changes of so many dimensions, the tolerance being three standard deviations: (count, n, 1)."""
    return np.random.default_rng(seed).normal(size=(count, samples, 1)) * tolerance / 3


def dyad(b, d, first, second):
    """Where two links on b and d meet, to the left of the line from b to d."""
    diagonal = d - b
    square = np.abs(diagonal) ** 2
    along = (first ** 2 - second ** 2 + square) / (2 * square)
    return b + (along + 1j * np.sqrt(first ** 2 / square - along ** 2)) * diagonal


def wrapped(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


class SamplesTest(unittest.TestCase):
    def agree(self, positions, samples, own, at=slice(None)):
        """`own`: deviations (n, positions)."""
        count = len(own)
        mean, sigma = own.mean(axis=0), own.std(axis=0, ddof=1)
        kurtosis = ((own - mean) ** 4).mean(axis=0) / sigma ** 4
        both = np.sqrt(1 / count + 1 / samples)
        off = np.abs(np.array(positions["mean"])[at] - mean) / (sigma * both)
        self.assertLess(off.max(), 4, "standard errors of the mean")
        spread = np.abs(np.array(positions["sigma"])[at] - sigma)
        off = spread / (sigma * both * np.sqrt((kurtosis - 1) / 4))
        self.assertLess(off.max(), 4, "standard errors of the standard deviation")

    def judged(self, table):
        return next(one["positions"] for one in table["quantities"] if one["judged"])

    def test_path(self):
        result = cognate.solve(
            kind="path-generation", target={"points": ELLIPSE},
            bounds={"length": [10, 200], "pivot_a": [[-150, -150], [150, 150]],
                    "pivot_d": [[-150, -150], [150, 150]]},
            constraints={"class": "crank-rocker"}, tolerance={"length": 0.1, "samples": 100_000},
            threads=1)
        linkage, table = result.best.mechanism, result.document["designs"][0]["tolerance"]
        pivots = np.array(linkage.fixed_pivots) @ [1, 1j]
        u = complex(*linkage.coupler_point)
        mirrored = linkage.assembly == "crossed"
        angles = np.radians(table["crank_deg"])

        def point(change, crank_angle):
            a, frame = pivots[0], pivots[1] - pivots[0]
            d = a + frame * (1 + change[3] / abs(frame))
            b = a + (linkage.crank + change[0]) * np.exp(1j * crank_angle)
            first, second = linkage.coupler + change[1], linkage.rocker + change[2]
            c = (np.conj(dyad(np.conj(b), np.conj(d), first, second)) if mirrored
                 else dyad(b, d, first, second))
            return b + (u + change[4] + 1j * change[5]) * (c - b) / first

        nominal = point(np.zeros((6, 1, 1)), angles)
        tangent = point(np.zeros((6, 1, 1)), angles + 1e-6) - point(np.zeros((6, 1, 1)), angles - 1e-6)
        across = 1j * tangent / np.abs(tangent)
        own = (np.conj(across) * (point(normal(1, 0.1, 6), angles) - nominal)).real
        self.agree(self.judged(table), table["samples"], own)

    def test_function(self):
        result = cognate.solve(
            kind="function-generation",
            target={"function": "log10(x)", "domain": [1, 10], "input_range_deg": 60,
                    "output_range_deg": 60, "objective": "least-squares", "samples": 21},
            mechanism={"frame": 1},
            bounds={"crank": [0.1, 10], "coupler": [0.1, 10], "rocker": [0.1, 10]},
            tolerance={"length": 0.002, "samples": 100_000}, threads=1)
        linkage, table = result.best.mechanism, result.document["designs"][0]["tolerance"]
        pivots = np.array(linkage.fixed_pivots) @ [1, 1j]
        frame = pivots[1] - pivots[0]
        angles = np.radians(table["crank_deg"])

        def rocker(change):
            b = (linkage.crank + change[0]) * np.exp(1j * angles)
            d = frame * (1 + change[3] / abs(frame))
            first, second = linkage.coupler + change[1], linkage.rocker + change[2]
            if linkage.assembly == "crossed":
                return np.angle(np.conj(dyad(np.conj(b), np.conj(d), first, second)) - d)
            return np.angle(dyad(b, d, first, second) - d)

        own = wrapped(rocker(normal(2, 0.002, 4)) - rocker(np.zeros((4, 1, 1))))
        self.agree(self.judged(table), table["samples"], np.degrees(own))

    def test_what_a_follower_has_not_is_not_off(self):
        for follower, given, names in (("translating-knife", {"offset": 5}, ["base_radius", "offset"]),
                                       ("translating-roller", {"offset": 5, "roller_radius": 8},
                                        ["base_radius", "offset", "roller_radius"]),
                                       ("translating-flat", {}, ["base_radius"])):
            file = {"kind": "cam", "follower": {"type": follower}, "motion": MOTION,
                    "mechanism": {"base_radius": 50, **given}}
            table = cognate.solve(file, tolerance={"length": 0.1, "samples": 0}).document["designs"][0]["tolerance"]
            self.assertEqual([one["name"] for one in table["dimensions"]], names)
            for missing in {"offset", "roller_radius"} - set(names):
                with self.assertRaises(cognate.ProblemError) as caught:
                    cognate.solve(file, tolerance={missing: 0.1})
                self.assertIn(missing, str(caught.exception))

    def test_slider_of_a_function(self):
        """A slider-crank's slider along its guide, from the one equation of its triangle."""
        result = cognate.solve(
            kind="function-generation", length_unit="mm",
            target={"function": "x^2", "domain": [0, 1], "input_range_deg": 60, "output_range": 100,
                    "objective": "minimax", "output": "C"},
            mechanism={"type": "chain"}, pivot=[{"name": "A", "at": [0, 0]}], crank={"at": "A", "pin": "B"},
            dyad=[{"type": "RRP", "joins": "B", "new": "C", "slide": {"direction_deg": 30, "offset": "free"}}],
            bounds={"length": [10, 1000]}, constraints={"transmission_angle_deg": [30, 150]}, solve={"designs": 1},
            tolerance={"length": 0.3, "samples": 100_000}, threads=1)
        design = result.document["designs"][0]
        table, chain = design["tolerance"], design["mechanism"]
        dyad_of_slider = chain["dyad"][0]
        slide = dyad_of_slider["slide"]
        self.assertEqual((slide["through"], chain["pivot"][0]["at"]), ("A", [0, 0]))
        side = 1 if dyad_of_slider["assembly"] == "open" else -1
        angles = np.radians(np.array(table["crank_deg"]) - slide["direction_deg"])

        def way(change):
            crank, rod = chain["crank"]["length"] + change[0], dyad_of_slider["lengths"][0] + change[1]
            high = slide["offset"] + change[2] - crank * np.sin(angles)
            return crank * np.cos(angles) + side * np.sqrt(rod ** 2 - high ** 2)

        self.assertEqual([one["name"] for one in table["dimensions"]], ["crank", "BC", "slider-C"])
        errors = way(normal(6, 0.3, 3)) - way(np.zeros((3, 1, 1)))
        self.agree(self.judged(table), table["samples"], errors)
        judged = next(one for one in table["quantities"] if one["judged"])
        extremes = np.abs(errors + np.array(judged["positions"]["nominal"])).max(axis=1)
        for quantile in judged["quantiles"][:4]:
            self.assertAlmostEqual(quantile["error"] / np.quantile(extremes, quantile["share"]), 1, delta=0.02)

    def test_six_bar_through_timed_points(self):
        """Distances from the targets of a chain that was found, its second dyad on a point of the first."""
        crank_angles = np.arange(40, 161, 20)

        def foot(pivots, lengths, angles, e, p, flip):
            a, d, g = pivots
            crank, bc, cd, ef, fg = lengths
            b = a + crank * np.exp(1j * angles)
            c = np.conj(dyad(np.conj(b), d, bc, cd)) if flip[0] else dyad(b, d, bc, cd)
            at = b + e * (c - b) / bc
            f = np.conj(dyad(np.conj(at), np.conj(g), ef, fg)) if flip[1] else dyad(at, g, ef, fg)
            return at + p * (f - at) / ef

        targets = foot((2.625, 3.5, -1.5 + 4.5j), (0.25, 1, 1, 3.5, 3.5), np.radians(crank_angles), -3, 3.5 - 3j,
                       (True, False))
        result = cognate.solve(
            kind="path-generation",
            target={"points": [[at.real, at.imag] for at in targets], "crank_deg": [float(x) for x in crank_angles]},
            mechanism={"type": "stephenson-3"},
            bounds={"length": [0.1, 6], "pivots": [[-6, -6], [6, 6]], "point": [[-6, -6], [6, 6]]},
            constraints={"over": "range"}, solve={"designs": 1, "starts": 256},
            tolerance={"length": 0.001, "samples": 100_000}, threads=1)
        design = result.document["designs"][0]
        table, chain = design["tolerance"], design["mechanism"]
        self.assertEqual([one["name"] for one in table["dimensions"]],
                         ["crank", "BC", "CD", "EF", "FG", "E.u", "E.v", "P.u", "P.v"])
        first, second = chain["dyad"]
        lengths = [chain["crank"]["length"], *first["lengths"], *second["lengths"]]
        e, p = (complex(*point["at"]) for point in chain["point"])
        pivots = [complex(*pivot["at"]) for pivot in chain["pivot"]]
        self.assertEqual([pivot["name"] for pivot in chain["pivot"]], ["A", "D", "G"])
        flip = [one["assembly"] == "crossed" for one in (first, second)]
        change = normal(7, 0.001, 9)
        angles = np.radians(table["crank_deg"])
        places = foot(pivots, [length + by for length, by in zip(lengths, change)], angles,
                      e + change[5] + 1j * change[6], p + change[7] + 1j * change[8], flip)
        self.agree(self.judged(table), table["samples"], np.abs(places - targets))

    def test_chain_of_two_dyads(self):
        chain = {"type": "chain",
                 "pivot": [{"name": "A", "at": [0, 0]}, {"name": "D", "at": [110, 0]},
                           {"name": "G", "at": [260, 0]}],
                 "crank": {"at": "A", "pin": "B", "length": 40},
                 "dyad": [{"type": "RRR", "joins": ["B", "D"], "lengths": [120, 80], "new": "C"},
                          {"type": "RRR", "joins": ["C", "G"], "lengths": [150, 90], "new": "E"}]}
        result = cognate.analyze(kind="analysis", mechanism=chain, drive={"steps": 12},
                                 tolerance={"length": 0.1, "samples": 100_000}, threads=1)
        table = result.document["designs"][0]["tolerance"]
        angles = np.radians(table["crank_deg"])

        def arm(change):
            b = (40 + change[0]) * np.exp(1j * angles)
            c = dyad(b, 110, 120 + change[1], 80 + change[2])
            return np.angle(dyad(c, 260, 150 + change[3], 90 + change[4]) - 260)

        own = wrapped(arm(normal(3, 0.1, 5)) - arm(np.zeros((5, 1, 1))))
        self.agree(self.judged(table), table["samples"], np.degrees(own))

    def test_cam(self):
        samples = 4000
        result = cognate.solve(
            kind="cam", follower={"type": "translating-roller"}, motion=MOTION,
            mechanism={"base_radius": 50, "roller_radius": 8, "offset": 5},
            tolerance={"base_radius": 0.3, "roller_radius": 0.2, "offset": 0.5,
                       "samples": 20_000}, threads=1)
        table = result.document["designs"][0]["tolerance"]
        turn = np.linspace(0, 2 * np.pi, 72_000, endpoint=False)

        def lift(angle):
            share = np.clip(np.where(angle < np.pi, angle, 5 * np.pi / 3 - angle) * 1.5 / np.pi, 0, 1)
            return 20 * (share - np.sin(2 * np.pi * share) / (2 * np.pi))

        def pitch(angle):
            """Of the roller's centre, in the cam, which turns counterclockwise."""
            return np.exp(-1j * angle) * (5 + 1j * (np.sqrt(50 ** 2 - 5 ** 2) + lift(angle)))

        tangent = pitch(turn + 1e-5) - pitch(turn - 1e-5)
        profile = pitch(turn) - 8j * -tangent / np.abs(tangent)  # towards the centre
        if np.abs(profile).min() > 50:
            profile = 2 * pitch(turn) - profile
        change = np.random.default_rng(4).normal(size=(3, samples)) / 3
        radius = 8 + 0.3 * change[0] + 0.2 * change[1]
        offset = 5 + 0.5 * change[2]
        at = np.arange(0, 360, 24)
        own = np.empty((samples, len(at)))
        for k, degrees in enumerate(np.array(table["crank_deg"])[at]):
            turned = profile * np.exp(1j * np.radians(degrees))
            near = turned[(np.abs(turned.real - 5) < 7.5) & (turned.imag > 0)]
            reach = radius[:, None] ** 2 - (near.real - offset[:, None]) ** 2
            top = (near.imag + np.sqrt(np.maximum(reach, 0))).max(axis=1)
            own[:, k] = top - (np.sqrt(50 ** 2 - 5 ** 2) + lift(np.radians(degrees)))
        self.agree(self.judged(table), table["samples"], own, at)


if __name__ == "__main__":
    unittest.main()
