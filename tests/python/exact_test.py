"""Exact syntheses for motions, quick returns and straight lines, held against what they promise.

Run as: exact_test.py, with the module on PYTHONPATH.
"""

import unittest

import cognate
import numpy as np
from cognate import exact

POSES = np.array([[0, 0, 0], [1, 0.5, 0.3], [2, 0.3, 0.7], [2.5, -0.5, 1.2], [2.2, -1.5, 1.9]])
BAR = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3,
                      coupler_point=[1, 1])


def plane(points):
    points = np.asarray(points)
    return points[..., 0] + 1j * points[..., 1]


def moved(poses, in_body):
    """Where a point of the body stands."""
    return plane(poses) + np.exp(1j * poses[:, 2]) * complex(*in_body)


class MotionTest(unittest.TestCase):
    def test_two_poses(self):
        two, pivot = POSES[:2], [0.25, 1.0]
        there = moved(two, pivot)
        one = exact.two_poses(two, in_body=pivot, line=[[0, -3], [2, 0]])
        np.testing.assert_allclose(abs(there - plane(one.fixed[0])), one.length[0], rtol=1e-12)
        self.assertAlmostEqual(one.fixed[0][1], -3)
        links = exact.two_poses(two, in_body=pivot, length=3)
        self.assertEqual(len(links.kind), 2)
        for fixed in links.fixed:
            np.testing.assert_allclose(abs(there - plane(fixed)), 3, rtol=1e-12)
        slider = exact.two_poses(two, in_body=pivot)
        along = (there[1] - there[0]) / abs(there[1] - there[0])
        self.assertAlmostEqual(abs((along.conjugate() * plane(slider.direction[0])).imag), 0)
        other = exact.two_poses(two, fixed=[0, -3], line=[[0, 0], [1, 1]])
        self.assertAlmostEqual(other.in_body[0][0], other.in_body[0][1])
        np.testing.assert_allclose(abs(moved(two, other.in_body[0]) - (-3j)), other.length[0])

    def test_pivot_line(self):
        point, direction = plane(exact.pivot_line(POSES[:2], in_body=[0, 1]))
        there = moved(POSES[:2], [0, 1])
        for along in (-2, 0, 5):
            near, far = abs(there - (point + along * direction))
            self.assertAlmostEqual(near, far)
        still = POSES[:2].copy()
        still[:, :2] = 0
        self.assertIsNone(exact.pivot_line(still, in_body=[0, 0]))

    def test_poles_do_not_move(self):
        for (i, j), pole in zip([(0, 1), (1, 2), (2, 0)], exact.pole_triangle(POSES[:3])):
            before, after = POSES[i], POSES[j]
            turn = np.exp(1j * (after[2] - before[2]))
            self.assertAlmostEqual(plane(after) + turn * (plane(pole) - plane(before)), plane(pole))

    def test_slides_of_three_poses(self):
        three = POSES[:3]
        slider = exact.three_poses(three, slide=[2, 0])
        np.testing.assert_allclose(np.ptp(moved(three, slider.in_body[0]).imag), 0, atol=1e-12)
        block = exact.three_poses(three, body_line=[0, 2])
        seen = (plane(block.fixed[0]) - plane(three)) * np.exp(-1j * three[:, 2])
        np.testing.assert_allclose(np.ptp(seen.real), 0, atol=1e-12)

    def test_guided_mechanism(self):
        dyads = exact.five_poses(POSES)
        tried = 0
        for i in range(len(dyads.kind)):
            for j in range(i):
                made = exact.guided_mechanism(POSES, dyads, i, j)
                for side in ("open", "crossed"):
                    here = [k for k in range(5) if made.assembly[k] == side]
                    bar = made.mechanism.replace(assembly=side)
                    np.testing.assert_allclose(bar.curve(made.drive[here], point="P"),
                                               POSES[here, :2], atol=1e-9)
                    tried += len(here)
        self.assertGreater(tried, 0)

    def test_slider_crank_points(self):
        points = np.array([[0, 0], [0.3, 0.4], [0.6, 0.9], [0.9, 1.2], [1.2, 1.4]])
        found = [one for one in exact.slider_crank_points(points) if one.outcome == "linkage"]
        self.assertTrue(found)
        for one in found:
            pin = one.crank * np.exp(1j * (points[:, 0] + one.input_start))
            slider = points[:, 1] + one.output_start + 1j * one.offset
            np.testing.assert_allclose(abs(slider - pin), one.coupler, rtol=1e-9)

    def test_slider_crank_points_of_an_offset(self):
        points = np.array([[0, 0], [0.3, 0.4], [0.6, 0.9], [0.9, 1.2]])
        for rows, given in ((points, {}), (points[:3], {"input_start": 0.4}),
                            (points[:3], {"output_start": 2.0})):
            found = [one for one in exact.slider_crank_points(rows, offset=0.1, **given)
                     if one.outcome == "linkage"]
            for one in found:
                pin = one.crank * np.exp(1j * (rows[:, 0] + one.input_start))
                slider = rows[:, 1] + one.output_start + 0.1j
                np.testing.assert_allclose(abs(slider - pin), one.coupler, rtol=1e-9)
            self.assertTrue(found or given)
        with self.assertRaises(Exception):
            exact.slider_crank_points(points, offset=0.1, input_start=0, output_start=0)

    def test_points_and_pivots(self):
        """Five points with both pivots given: 36 four-bars, complex ones among them."""
        points = BAR.curve(np.radians([10, 60, 120, 200, 290]))
        found = exact.nine_points(points, pivot_a=[0, 0], pivot_d=[4, 0])
        self.assertEqual((found.status, found.finite), ("solved", 36))
        self.assertLess(abs(found.designs[:, 4:7] - [1, 3.5, 3]).max(axis=1).min(), 1e-8)
        np.testing.assert_allclose(found.designs[:, :4], [[0, 0, 4, 0]] * len(found.designs),
                                   atol=1e-10)


def time_ratio(first, second):
    """Of two angles of the crank at the limits."""
    there = (second - first) % (2 * np.pi)
    return max(there, 2 * np.pi - there) / min(there, 2 * np.pi - there)


class QuickReturnTest(unittest.TestCase):
    TURN = np.linspace(0, 2 * np.pi, 20_001)

    def test_rockers(self):
        for given in ({}, {"crank": 1.0}, {"coupler": 4.0}, {"frame": 3.4}, {"line": [0, 1, 2.0]}):
            found = exact.quick_return_rockers(time_ratio=1.2, rocker=3, swing=0.8, **given)
            self.assertTrue(found.designs, given)
            for one in found.designs:
                swing = np.unwrap(one.mechanism.rotations(self.TURN)["rocker"])
                self.assertAlmostEqual(np.ptp(swing), 0.8, places=6)
                ends = self.TURN[[swing.argmax(), swing.argmin()]]
                self.assertAlmostEqual(time_ratio(*ends), 1.2, places=2)
                self.assertAlmostEqual(time_ratio(one.outer, one.inner), 1.2, places=9)
                angle = one.mechanism.transmission(self.TURN)
                self.assertAlmostEqual(angle.min(), one.transmission_min, places=6)
            if "line" in given:
                for one in found.designs:
                    self.assertAlmostEqual(one.mechanism.fixed_pivots[0][1], 2.0)

    def test_rockers_at_a_limit(self):
        """The rocker's angle from A to D, at the limit, by following it over the turn."""
        make = exact.quick_return_rockers
        by_frame = exact.quick_return_rockers_by_frame
        for found, name, angle in (
                (make(time_ratio=1.25, rocker=290, swing=0.6, outer_limit=1.5), "outer", 1.5),
                (make(time_ratio=1.25, rocker=290, swing=0.6, inner_limit=2.1), "inner", 2.1),
                (by_frame(time_ratio=1.5, rocker=75, frame=100, inner_limit=0.75 * np.pi), "inner",
                 0.75 * np.pi)):
            self.assertTrue(found.designs)
            for one in found.designs:
                points = one.mechanism.positions(np.array([one[name]]))
                a, d = np.array(one.mechanism.fixed_pivots)
                rocker, frame = points["C"][0] - d, d - a
                cosine = rocker @ frame / np.linalg.norm(rocker) / np.linalg.norm(frame)
                self.assertAlmostEqual(np.arccos(cosine), angle, places=9)
                self.assertAlmostEqual(time_ratio(one.outer, one.inner),
                                       1.5 if angle > 2.2 else 1.25, places=9)
        with self.assertRaises(Exception):
            make(time_ratio=1.2, rocker=1, swing=1, outer_limit=4)

    def test_sliders(self):
        for given in ({}, {"offset": 0.5}, {"crank": 1.45}, {"coupler": 3.0}):
            found = exact.quick_return_sliders(time_ratio=1.2, stroke=3, **given)
            self.assertTrue(found.designs, given)
            for one in found.designs:
                x = one.mechanism.positions(self.TURN)["C"][:, 0]
                self.assertAlmostEqual(np.ptp(x), 3, places=6)
                self.assertAlmostEqual(time_ratio(*self.TURN[[x.argmax(), x.argmin()]]), 1.2, places=2)
        self.assertEqual(exact.quick_return_sliders(time_ratio=1.2, stroke=3, offset=0).degeneracy,
                         "no-offset")

    def test_guides(self):
        """The bar swings by pi (K - 1)/(K + 1)."""
        for given in ({"frame": 3}, {"crank": 1}, {"frame": 3, "offset": 0.3}):
            found = exact.quick_return_guides(time_ratio=1.5, **given)
            self.assertTrue(found)
            for one in found:
                swing = np.unwrap(one.mechanism.rotations(self.TURN)["guide"])
                self.assertAlmostEqual(np.ptp(swing), np.pi / 5, places=6)
        self.assertEqual(exact.quick_return_guides(time_ratio=1, frame=3), [])

    def test_shaper(self):
        for given in ({"frame": 3, "rod": 2}, {"crank": 1, "pressure_angle": 0.2}):
            made = exact.quick_return_shaper(time_ratio=1.5, stroke=3, **given)
            self.assertEqual(made.outcome, "solved")
            x = made.mechanism.positions(self.TURN)["E"][:, 0]
            self.assertAlmostEqual(np.ptp(x), 3, places=6)
            self.assertAlmostEqual(time_ratio(*self.TURN[[x.argmax(), x.argmin()]]), 1.5, places=2)
        self.assertEqual(exact.quick_return_shaper(time_ratio=1, stroke=3, frame=3, rod=2).outcome,
                         "no-swing")


class StraightTest(unittest.TestCase):
    def bends(self, bar, angle):
        """The cross products of the first with further derivatives of the point's path."""
        rates = [bar.derivatives(angle, order)["P"] for order in (1, 2, 3)]
        h = 1e-4
        rates.append((bar.derivatives(angle + h, 3)["P"] - bar.derivatives(angle - h, 3)["P"]) / (2 * h))
        size = np.hypot(*rates[0])
        return [abs(rates[0][0] * r[1] - rates[0][1] * r[0]) / size**2 for r in rates[1:]]

    def test_points(self):
        for contact in (3, 4):
            found = exact.straight_points(BAR, 1.0, contact=contact)
            self.assertEqual(found.why, "none")
            for point in found.points:
                bar = BAR.replace(coupler_point=point.coupler_point)
                self.assertLess(max(self.bends(bar, 1.0)[:point.contact - 2]), 1e-9)
        self.assertEqual(exact.straight_points(BAR, 1.0, contact=5).why, "too-few")

    def test_positions_and_lengths(self):
        for found in (exact.straight_positions(BAR), exact.straight_lengths(BAR, 1.0, "coupler")):
            self.assertTrue(found)
            for one in found:
                self.assertGreaterEqual(one.contact, 5)
                self.assertLess(max(self.bends(one.mechanism, one.crank_angle)), 1e-5)


class EqualPeaksTest(unittest.TestCase):
    """Li & Xu 2011, example 3-7: largest error 0.58 degrees with Chebyshev's points."""

    SWEEP = np.radians(60)

    def wanted(self, inputs):
        return np.radians(90) * np.log10(1 + inputs / self.SWEEP) / np.log10(2)

    def errors(self, found, assembly, inputs):
        crank, coupler, rocker, frame = found.links
        b = crank * np.exp(1j * (found.input_start + inputs))
        diagonal = frame - b
        square = abs(diagonal) ** 2
        along = (coupler**2 - rocker**2 + square) / (2 * square)
        height = np.sqrt(coupler**2 / square - along**2) * (1 if assembly == "open" else -1)
        turned = np.angle((b + (along + 1j * height) * diagonal - frame)
                          * np.exp(-1j * (found.output_start + self.wanted(inputs))))
        return turned

    def test_levels_the_published_example(self):
        inputs = exact.chebyshev_spacing(0, self.SWEEP, 3)
        start = {"input_start": np.radians(86), "output_start": np.radians(23.5)}
        points = np.column_stack([inputs, self.wanted(inputs)])
        level = 0
        for each in exact.precision_points(points, **start):
            for assembly in ("open", "crossed"):
                found = exact.equal_peaks(self.wanted, [0, self.SWEEP], each.links,
                                          assembly=assembly, **start)
                if found.outcome != "level":
                    continue
                level += 1
                scan = np.linspace(0, self.SWEEP, 20001)
                before = abs(self.errors(each, assembly, scan)).max()
                self.assertAlmostEqual(np.degrees(before), 0.58291, places=4)
                self.assertLess(found.greatest, before)
                peaks = self.errors(found, assembly, found.peaks)
                np.testing.assert_allclose(peaks * np.array([1, -1, 1, -1]), peaks[0], rtol=1e-8)
                self.assertAlmostEqual(abs(self.errors(found, assembly, scan)).max(), found.greatest)
                zeros = self.errors(found, assembly, found.precision_inputs)
                np.testing.assert_allclose(zeros, 0, atol=1e-12)
        self.assertEqual(level, 1)

    def test_an_error_of_the_function_comes_through(self):
        def output(angle):
            raise ArithmeticError("of its own")

        with self.assertRaises(ArithmeticError):
            exact.equal_peaks(output, [0, 1], [1, 2, 2, 2], input_start=0, output_start=0)


class CamsAndGearsTest(unittest.TestCase):
    MOTION = [{"law": "cycloidal", "over_deg": 120, "rise_deg": 20}, {"law": "dwell", "over_deg": 60},
              {"law": "cycloidal", "over_deg": 120, "rise_deg": -20}, {"law": "dwell", "over_deg": 60}]

    def pressure(self, base, distance, arm, sign):
        """The greatest angle between the velocity of the roller's centre and its path's normal in
        the cam, by differences."""
        start = np.arccos((arm**2 + distance**2 - base**2) / (2 * arm * distance))
        x = np.linspace(0, 1, 8001)
        rise = np.radians(20) * (x - np.sin(2 * np.pi * x) / (2 * np.pi))
        greatest = 0
        for angle, lift in ((x * np.radians(120), rise), (x * np.radians(120) + np.pi, rise[::-1])):
            swing = start + lift
            # The arm hangs from (0, distance), to the right where it trails a cam turning left.
            centre = 1j * distance - 1j * arm * np.exp(1j * sign * swing)
            in_cam = centre * np.exp(-1j * angle)
            tangent = np.gradient(in_cam, angle) * np.exp(1j * angle)
            moves = sign * (centre - 1j * distance) * 1j
            across = tangent * 1j
            cosine = abs((np.conj(across) * moves).real) / (abs(across) * abs(moves))
            greatest = max(greatest, np.arccos(np.minimum(cosine[5:-5], 1)).max())
        return np.degrees(greatest)

    def test_smallest_oscillating_cam(self):
        for side, sign in (("trailing", 1), ("leading", -1)):
            with self.subTest(side=side):
                cam = exact.smallest_oscillating_cam(self.MOTION, pressure_angle_deg=35, arm=60,
                                                     side=side)
                base, distance = cam.base_radius, cam.centre_distance
                self.assertAlmostEqual(self.pressure(base, distance, 60, sign), 35, places=3)
                # No smaller one keeps the angle, whatever its centre distance.
                smaller = 0.995 * base
                least = min(self.pressure(smaller, d, 60, sign)
                            for d in np.linspace(60 - smaller + 0.5, 60 + smaller - 0.5, 120))
                self.assertGreater(least, 35)
                # Arm and cam grow together.
                double = exact.smallest_oscillating_cam(self.MOTION, pressure_angle_deg=35, arm=120,
                                                        side=side)
                self.assertAlmostEqual(double.base_radius, 2 * base, places=7)

    def test_involute(self):
        angles = np.array([[-1.2, -0.3, 0], [1e-3, np.radians(20), 1.5]])
        found = exact.involute(angles)
        self.assertEqual(found.shape, (2, 3))
        np.testing.assert_allclose(found, np.tan(angles) - angles, rtol=1e-9, atol=1e-15)
        np.testing.assert_allclose(exact.involute_angle(found), angles, rtol=1e-14)
        self.assertAlmostEqual(float(exact.involute(np.radians(20))), 0.0149043838673363, places=15)
        self.assertAlmostEqual(float(exact.involute(1e-4)) / (1e-12 / 3), 1, places=7)


if __name__ == "__main__":
    unittest.main()
