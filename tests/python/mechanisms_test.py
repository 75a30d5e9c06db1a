"""Mechanisms, batches, models and exact syntheses, held against formulas of their own.

Run as: mechanisms_test.py, with the module on PYTHONPATH.
"""

import ast
import copy
import pathlib
import pickle
import threading
import unittest

import cognate
import numpy as np

BAR = cognate.FourBar(fixed_pivots=[[0.5, -0.25], [4, 1]], crank=1, coupler=3.5, rocker=3,
                      coupler_point=[1.5, 0.75])
ALL = [
    BAR,
    cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3,
                    assembly="crossed", coupler_point=[1, -1]),
    cognate.SliderCrank(pivot=[1, 2], crank=1, coupler=3, offset=0.4, direction_deg=20),
    cognate.FixedBlock(pivot=[1, 2], crank=1, coupler=3, offset=0.4, direction_deg=20),
    cognate.GuideBar(fixed_pivots=[[0, 0], [3, 1]], crank=1, offset=0.2),
    cognate.OscillatingBlock(fixed_pivots=[[0, 0], [3, 1]], crank=1, offset=0.2),
    cognate.ScotchYoke(pivot=[0, 1], crank=1.5, offset=0.3, direction_deg=10, slot_deg=80),
    cognate.TangentGenerator(pivot=[0, 1], offset=2, direction_deg=10),
    cognate.EllipticTrammel(centre=[1, 1], length=2, direction_deg=15, second_line_deg=70),
    cognate.OldhamCoupling(fixed_pivots=[[0, 0], [0.5, 0.25]], slot_deg=80),
]


# Every dyad and both drives, points of links by one name and by two.
CHAINS = [
    (cognate.Chain(
        pivot=[{"name": "A", "at": [0.1, 3]}, {"name": "C", "at": [0, 0.2]}],
        crank={"at": "A", "pin": "B", "length": 1}, dyad=[
            {"type": "RPR", "joins": ["B", "C"], "offset": 0.1, "names": ["block", "bar"]},
            {"type": "RRP", "joins": ["D"], "length": 2, "new": "E",
             "slide": {"through": [0, 4.5], "direction_deg": 175, "offset": 0.1}}],
        point=[{"name": "D", "on": "bar", "at": [4.2, 0.1]}, {"name": "P", "on": ["D", "E"],
                                                             "at": [0.7, 0.4]}]),
     np.linspace(0.2, 1.2, 5)),
    (cognate.Chain(
        pivot=[{"name": "O", "at": [0.2, 0.1]}], crank={"at": "O", "pin": "B", "length": 1},
        dyad=[{"type": "RPP", "joins": ["B"], "new": "C", "slot_deg": 80,
               "slide": {"through": [0, -0.4], "direction_deg": 10, "offset": 0.2}}],
        point=[{"name": "P", "on": "C", "at": [0.5, 0.3]}]),
     np.linspace(0.2, 1.2, 5)),
    (cognate.Chain(
        pivot=[{"name": "D", "at": [4, 0.5]}],
        slider={"pin": "B", "slide": {"through": [0.3, 0], "direction_deg": 80}},
        dyad=[{"type": "RRR", "joins": ["B", "D"], "lengths": [3.5, 2], "new": "C",
               "assembly": "crossed"},
              {"type": "PRP", "new": "F", "slides": [
                  {"through": [0, -2], "direction_deg": 5},
                  {"through": [0.2, 0.1], "direction_deg": 70, "on": "BC", "offset": 0.3}]}],
        point=[{"name": "P", "on": "F2", "at": [0.5, 0.25]}]),
     np.linspace(0.2, 0.8, 5)),
]


def coupler_points(bar, angles):
    """Where two circles meet, in complex numbers."""
    (ax, ay), (dx, dy) = bar.fixed_pivots
    a, d = complex(ax, ay), complex(dx, dy)
    b = a + bar.crank * np.exp(1j * angles)
    gap = d - b
    along = (bar.coupler**2 - bar.rocker**2 + abs(gap) ** 2) / (2 * abs(gap))
    across = np.sqrt(bar.coupler**2 - along**2 + 0j).real
    side = -1 if bar.to_dict().get("assembly") == "crossed" else 1
    c = b + gap / abs(gap) * (along + 1j * side * across)
    u, v = bar.coupler_point
    return b, c, b + (c - b) / bar.coupler * (u + 1j * v)


def plane(array):
    return array[..., 0] + 1j * array[..., 1]


class MechanismTest(unittest.TestCase):
    ANGLES = np.linspace(0.1, 6.2, 97)

    def test_four_bar_by_circles(self):
        for bar in ALL[:2]:
            points = bar.positions(self.ANGLES)
            b, c, p = coupler_points(bar, self.ANGLES)
            for name, there in {"B": b, "C": c, "P": p}.items():
                np.testing.assert_allclose(plane(points[name]), there, atol=2e-14)
            np.testing.assert_array_equal(points["A"], np.tile(bar.fixed_pivots[0], (97, 1)))
            swing = bar.rotations(self.ANGLES)["rocker"]
            np.testing.assert_allclose(np.exp(1j * swing),
                                       (c - complex(*bar.fixed_pivots[1])) / bar.rocker, atol=1e-13)
            link = (b - c) * (complex(*bar.fixed_pivots[1]) - c).conj()
            np.testing.assert_allclose(bar.transmission(self.ANGLES)[:, 0], abs(np.angle(link)),
                                       atol=1e-12)

    def test_slider_crank_in_closed_form(self):
        slider = cognate.SliderCrank(crank=1, coupler=3, offset=0.4)
        x = np.cos(self.ANGLES) + np.sqrt(9 - (np.sin(self.ANGLES) - 0.4) ** 2)
        np.testing.assert_allclose(slider.positions(self.ANGLES)["C"][:, 0], x, atol=2e-15 * 8)

    def test_rates_by_differences(self):
        h = 1e-5
        for mechanism in ALL:
            angles = np.linspace(0.2, 1.2, 7)
            with self.subTest(mechanism):
                above, below = mechanism.positions(angles + h), mechanism.positions(angles - h)
                middle = mechanism.positions(angles)
                first = mechanism.velocities(angles, 2.0)
                second = mechanism.accelerations(angles, 2.0, 3.0)
                for name in mechanism.point_names:
                    by_angle = (above[name] - below[name]) / (2 * h)
                    twice = (above[name] - 2 * middle[name] + below[name]) / h**2
                    np.testing.assert_allclose(first[name], 2 * by_angle, rtol=1e-6, atol=1e-8)
                    np.testing.assert_allclose(second[name], 4 * twice + 3 * by_angle, rtol=1e-4, atol=1e-3)

    def test_gradients_by_differences(self):
        h = 1e-6
        angles = np.linspace(0.2, 1.2, 5)

        def with_number(value, place, change):
            if not place:
                return value + change
            value = copy.deepcopy(value)
            value[place[0]] = with_number(value[place[0]], place[1:], change)
            return value

        for mechanism in ALL:
            for key, gradient in mechanism.gradient(angles).items():
                name, *rest = key.replace("]", "").split("[")
                place = [int(index) for index in rest]
                tables = mechanism.to_dict()
                moved = [cognate.mechanism_of({**tables, name: with_number(tables[name], place, c)})
                         for c in (h, -h)]
                point = "P" if "P" in mechanism.point_names else mechanism.point_names[-1]
                by = (moved[0].curve(angles, point=point) - moved[1].curve(angles, point=point)) / (2 * h)
                with self.subTest(mechanism=mechanism, key=key):
                    np.testing.assert_allclose(gradient, by, atol=2e-8)

    def test_gradients_of_chains_are_those_of_classes(self):
        pivots = [{"name": "A", "at": BAR.fixed_pivots[0]}, {"name": "D", "at": BAR.fixed_pivots[1]}]
        chain = cognate.Chain(
            pivot=pivots, crank={"at": "A", "pin": "B", "length": BAR.crank},
            dyad=[{"type": "RRR", "joins": ["B", "D"], "lengths": [BAR.coupler, BAR.rocker],
                   "new": "C"}], point=[{"name": "P", "on": ["B", "C"], "at": BAR.coupler_point}])
        names = {"crank.length": "crank", "dyad[0].lengths[0]": "coupler",
                 "dyad[0].lengths[1]": "rocker", "pivot[0].at[0]": "fixed_pivots[0][0]",
                 "pivot[1].at[1]": "fixed_pivots[1][1]", "point[0].at[0]": "coupler_point[0]"}
        here, there = chain.gradient(self.ANGLES), BAR.gradient(self.ANGLES)
        self.assertEqual(len(here), len(there))
        for name, key in names.items():
            np.testing.assert_allclose(here[name], there[key], atol=2e-14)
        further = BAR.replace(point=[{"name": "Q", "on": "coupler", "at": BAR.coupler_point}])
        np.testing.assert_allclose(further.gradient(self.ANGLES, point="Q")["point[0].at[1]"],
                                   there["coupler_point[1]"], atol=2e-14)

    def test_gradients_of_chains_by_differences(self):
        h = 1e-6

        def set_in(value, path, change):
            if len(path) > 1:
                return set_in(value[path[0]], path[1:], change)
            value[path[0]] += change

        def moved(tables, key, change):
            tables = copy.deepcopy(tables)
            path = [int(part) if part.isdigit() else part
                    for part in key.replace("[", ".").replace("]", "").split(".")]
            set_in(tables, path, change)
            return cognate.mechanism_of(tables)

        for chain, drive in CHAINS:
            for key, gradient in chain.gradient(drive, point="P").items():
                by = [moved(chain.to_dict(), key, c).curve(drive, point="P") for c in (h, -h)]
                with self.subTest(chain=chain, key=key):
                    self.assertTrue(np.isfinite(gradient).all())
                    np.testing.assert_allclose(gradient, (by[0] - by[1]) / (2 * h), atol=1e-8)

    def test_replace(self):
        other = BAR.replace(crank=0.5, assembly=None)
        self.assertEqual(other.crank, 0.5)
        self.assertEqual(other.coupler_point, BAR.coupler_point)
        with self.assertRaisesRegex(AttributeError, "replace"):
            BAR.crank = 2
        self.assertEqual(BAR.crank, 1)

    def test_rates_of_the_drive_may_vary(self):
        speed = np.linspace(1, 2, 97)
        link = [{"name": "coupler", "mass": 1.0, "centre": [1, 0.5]}]
        velocity = BAR.velocities(self.ANGLES, speed)["P"]
        forces = BAR.forces(self.ANGLES, speed=speed, link=link)["drive"]
        for i in (0, 50):
            angle, rate = float(self.ANGLES[i]), float(speed[i])
            np.testing.assert_allclose(BAR.velocities(angle, rate)["P"], velocity[i], rtol=1e-12)
            one = BAR.forces(angle, speed=rate, link=link)["drive"]
            self.assertEqual(float(one), forces[i])

    def test_forces_by_virtual_work(self):
        """The drive's torque times its speed is the power of loads, weight and inertia."""
        links = [{"name": "coupler", "mass": 2.0, "centre": [1.0, 0.3], "inertia": 0.5}]
        load = [{"on": "rocker", "at": [1.0, 0.0], "force": [3.0, -4.0]}]
        speed, gravity = 3.0, np.array([0.0, -9.81])
        body = cognate.FourBar(**{**{k: v for k, v in BAR.to_dict().items() if k != "type"},
                                  "coupler_point": [1.0, 0.3]})
        forces = body.forces(self.ANGLES, speed=speed, link=links, load=load, gravity=gravity)
        centre = body.velocities(self.ANGLES, speed)["P"]
        pull = body.accelerations(self.ANGLES, speed)["P"] - gravity
        turn = body.rotations(self.ANGLES, order=1)["coupler"] * speed
        spin = body.rotations(self.ANGLES, order=2)["coupler"] * speed**2
        swing = body.rotations(self.ANGLES, order=1)["rocker"] * speed
        direction = np.exp(1j * body.rotations(self.ANGLES)["rocker"])
        at = 1j * direction * swing
        power = (2.0 * (centre * pull).sum(axis=1) + 0.5 * spin * turn
                 - (3.0 * at.real - 4.0 * at.imag))
        np.testing.assert_allclose(forces["drive"] * speed, power, rtol=1e-11, atol=1e-10)
        self.assertEqual(forces["A"].shape, (97, 2))
        milli = body.forces(self.ANGLES, speed=speed, link=links, load=load, gravity=gravity,
                            length_unit="m")
        np.testing.assert_array_equal(milli["drive"], forces["drive"])

    def test_what_does_not_close_is_nan(self):
        bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=3, coupler=1, rocker=2,
                              coupler_point=[1, 1])
        angles = np.linspace(0.01, 6.27, 50)
        closed = np.isfinite(bar.curve(angles)[:, 0])
        self.assertTrue(0 < closed.sum() < 50)
        np.testing.assert_array_equal(np.isfinite(bar.forces(angles)["drive"]), closed)
        np.testing.assert_array_equal(np.isfinite(bar.gradient(angles)["crank"][:, 0]), closed)
        self.assertTrue(np.isnan(bar.curve([np.nan, np.inf])).all())

    def test_shapes_and_views(self):
        for angles in (0.5, [0.5, 0.6], np.arange(12.0).reshape(3, 4), np.arange(24.0)[::3],
                       np.arange(12.0).reshape(3, 4).T, np.arange(5), np.arange(5, dtype=np.float32)):
            shape = np.shape(angles)
            points = BAR.positions(angles)
            self.assertEqual(points["P"].shape, (*shape, 2))
            flat = BAR.positions(np.ravel(angles).astype(float))
            np.testing.assert_array_equal(points["P"].reshape(-1, 2), flat["P"])
            self.assertFalse(points["A"].flags.writeable)
            self.assertTrue(points["P"].flags.writeable)

    def test_one_angle_is_an_angle_of_many(self):
        many = BAR.curve(self.ANGLES)
        for i in (0, 40, 96):
            np.testing.assert_allclose(BAR.curve(float(self.ANGLES[i])), many[i], atol=1e-15)

    def test_pickles_and_equality(self):
        for mechanism in ALL:
            again = pickle.loads(pickle.dumps(mechanism))
            self.assertEqual(again, mechanism)
            self.assertIs(type(again), type(mechanism))
            self.assertEqual(hash(again), hash(mechanism))
            same = eval(repr(mechanism), vars(cognate).copy())
            point = mechanism.point_names[-1]
            np.testing.assert_allclose(same.curve(1.0, point=point), mechanism.curve(1.0, point=point),
                                       rtol=1e-13)
            self.assertIn("<svg", mechanism._repr_svg_())

    def test_threads(self):
        there = BAR.curve(np.linspace(0, 9, 100_001))
        found = [None] * 4

        def work(i):
            for _ in range(20):
                found[i] = BAR.curve(np.linspace(0, 9, 100_001), threads=2)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for each in found:
            np.testing.assert_array_equal(each, there)

    def test_keys_are_those_of_files(self):
        stub = pathlib.Path(cognate.mechanisms.__file__).with_suffix(".pyi").read_text(encoding="utf-8")
        stubs = {part.name: part for part in ast.parse(stub).body if isinstance(part, ast.ClassDef)}
        for listed in cognate.list("analysis")["mechanisms"]:
            name = "".join(part.capitalize() for part in listed["name"].split("-"))
            self.assertIs(getattr(cognate, name), getattr(cognate.mechanisms, name))
            init = stubs.pop(name).body[0]
            if name != "Chain":  # whose keys are tables
                self.assertEqual([keyword.arg for keyword in init.args.kwonlyargs],
                                 [key["name"] for key in listed["keys"]] + ["point"], name)
        self.assertEqual(list(stubs), ["Mechanism"])


class BatchTest(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(5)
        m = 37
        self.designs = np.empty((m, 10), order="F")
        self.designs[:, :4] = random.normal(size=(m, 4))
        self.designs[:, 4:7] = random.uniform(0.5, 3, size=(m, 3))
        self.designs[:, 7] = random.choice([-1.0, 1.0], m)
        self.designs[:, 8:] = random.normal(size=(m, 2))
        self.angles = np.linspace(0, 6, 23)

    def test_against_single_mechanisms(self):
        found = cognate.batch.positions(self.designs, self.angles)
        self.assertEqual(found.shape, (37, 23, 2))
        for i, row in enumerate(self.designs):
            bar = cognate.FourBar(fixed_pivots=[row[:2], row[2:4]], crank=row[4], coupler=row[5],
                                  rocker=row[6], coupler_point=row[8:],
                                  assembly="open" if row[7] > 0 else "crossed")
            frame = np.arctan2(row[3] - row[1], row[2] - row[0])
            np.testing.assert_allclose(bar.curve(self.angles + frame), found[i], atol=1e-12)

    def test_forms_of_designs(self):
        found = cognate.batch.positions(self.designs, self.angles)
        by_name = {name: self.designs[:, i] for i, name in enumerate(cognate.batch.COLUMNS)}
        import pandas

        for form in (np.ascontiguousarray(self.designs), by_name, pandas.DataFrame(by_name),
                     self.designs.tolist()):
            np.testing.assert_array_equal(cognate.batch.positions(form, self.angles), found)
        bars = [BAR, ALL[1]]
        self.assertEqual(cognate.batch.positions(bars, self.angles).shape, (2, 23, 2))

    def test_quantities(self):
        all_of_them = cognate.batch.evaluate(self.designs, self.angles, cognate.batch.QUANTITIES)
        h = 1e-6
        with np.errstate(invalid="ignore"):
            by = (cognate.batch.positions(self.designs, self.angles + h)
                  - cognate.batch.positions(self.designs, self.angles - h)) / (2 * h)
        inside = np.abs(all_of_them["transmission_sin"]) > 0.1
        np.testing.assert_allclose(all_of_them["velocity"][inside], by[inside], atol=1e-6)
        one = all_of_them["transmission_sin"] ** 2 + all_of_them["transmission_cos"] ** 2
        np.testing.assert_allclose(one[inside], 1, atol=1e-12)
        changed = self.designs.copy(order="F")
        changed[:, 5] += h
        by = (cognate.batch.positions(changed, self.angles) - all_of_them["position"]) / h
        np.testing.assert_allclose(all_of_them["gradient"][..., 5][inside], by[inside], atol=1e-3)
        v, a = all_of_them["velocity"], all_of_them["acceleration"]
        curvature = (v[..., 0] * a[..., 1] - v[..., 1] * a[..., 0]) / np.hypot(*v.T).T ** 3
        np.testing.assert_allclose(all_of_them["curvature"][inside], curvature[inside], rtol=1e-8)

    def test_arrays_that_numpy_has_otherwise(self):
        """Read-only, with strides, big-endian, shared with the output's memory: never a wrong answer."""
        there = cognate.batch.positions(self.designs, self.angles)
        fixed = self.designs.copy()
        fixed.flags.writeable = False
        strided = np.repeat(self.designs, 2, axis=0)[::2]
        for form in (fixed, strided, self.designs.astype(">f8"), self.designs[::-1][::-1]):
            np.testing.assert_array_equal(cognate.batch.positions(form, self.angles), there)
        backwards = cognate.batch.positions(self.designs[::-1], self.angles[::-1])
        np.testing.assert_allclose(backwards[::-1, ::-1], there, atol=1e-13)

    def test_out_is_filled(self):
        out = np.full((37, 23, 2), 7.0, order="F")
        found = cognate.batch.positions(self.designs, self.angles, out=out)
        self.assertIs(found, out)
        np.testing.assert_array_equal(out, cognate.batch.positions(self.designs, self.angles, threads=0))


class ModelTest(unittest.TestCase):
    def model(self, **more):
        return cognate.Model({"x": (-2, 2), "y": (-2, 2)},
                             lambda x: [10 * (x[1] - x[0] ** 2), 1 - x[0]], **more)

    def test_every_solver(self):
        exact = self.model(jacobian=lambda x: [[-20 * x[0], 10], [-1, 0]])
        for solver in cognate.model.SOLVERS:
            with self.subTest(solver):
                found = cognate.model.solve(exact, [-1.2, 1], solver=solver, iterations=3000)
                self.assertLess(found.objective, 1e-3)
        found = cognate.model.solve(self.model(), [-1.2, 1])
        np.testing.assert_allclose(found.x, [1, 1], atol=1e-6)

    def test_constraints_and_minimax(self):
        bounded = self.model(constraints=lambda x: [0.5 - x[0]])
        found = cognate.model.search(bounded, starts=20)
        self.assertEqual(found.status, "solved")
        np.testing.assert_allclose(found.minima[0].x, [0.5, 0.25], atol=1e-6)
        level = cognate.Model({"a": (-9, 9)}, lambda x: [x[0] - 1, x[0] - 4], objective="max-abs")
        np.testing.assert_allclose(cognate.model.solve(level, [0.0]).x, [2.5], atol=1e-6)

    def test_a_mechanism_as_a_model(self):
        """The dimensions that a curve was made with are found again."""
        angles = np.linspace(0, 6, 24)
        target = BAR.curve(angles)
        fixed = dict(fixed_pivots=BAR.fixed_pivots, coupler_point=BAR.coupler_point)

        def residuals(x):
            return (cognate.FourBar(crank=x[0], coupler=x[1], rocker=x[2], **fixed).curve(angles)
                    - target).ravel()

        lengths = cognate.Model({"crank": (0.5, 1.5), "coupler": (3, 4), "rocker": (2.6, 3.5)}, residuals)
        found = cognate.model.solve(lengths, [0.9, 3.4, 3.1])
        np.testing.assert_allclose(found.x, [1, 3.5, 3], atol=1e-8)

    def test_a_start_without_a_value(self):
        found = cognate.model.solve(cognate.Model({"x": (0, 1)}, lambda x: [np.nan]))
        self.assertEqual(found.stop, "no-value")
        self.assertTrue(np.isnan(found.objective))

    def test_same_for_any_threads(self):
        one = cognate.model.search(self.model(), starts=30, threads=1)
        two = cognate.model.search(self.model(), starts=30, threads=3)
        np.testing.assert_array_equal(one.minima[0].x, two.minima[0].x)


class ExactTest(unittest.TestCase):
    def test_freudenstein_finds_the_linkage_again(self):
        bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3)
        crank = np.radians([20, 75, 130, 190])
        rocker = bar.rotations(crank)["rocker"]
        for count in (3, 4):
            found = cognate.exact.freudenstein(crank[:count], rocker[:count])
            np.testing.assert_allclose(found.links, [1, 3.5, 3, 4], rtol=1e-10)

    def test_precision_points(self):
        points = np.array([[0.0, 0.0], [0.3, 0.2], [0.6, 0.5], [0.9, 0.75], [1.2, 1.1]])
        for one in cognate.exact.precision_points(points):
            if one.outcome != "linkage":
                continue
            a, b, c, d = one.links
            th, ph = points[:, 0] + one.input_start, points[:, 1] + one.output_start
            gap = np.hypot(d + c * np.cos(ph) - a * np.cos(th), c * np.sin(ph) - a * np.sin(th))
            np.testing.assert_allclose(gap, b, rtol=1e-9)

    def test_dyads_keep_their_length(self):
        poses = np.array([[0, 0, 0], [1, 0.5, 0.3], [2, 0.3, 0.7], [2.5, -0.5, 1.2], [2.2, -1.5, 1.9]])

        def check(dyads, poses):
            for k, kind in enumerate(dyads["kind"]):
                if kind != "rr":
                    continue
                moved = (poses[:, 0] + 1j * poses[:, 1]
                         + np.exp(1j * poses[:, 2]) * complex(*dyads["in_body"][k]))
                gap = abs(moved - complex(*dyads["fixed"][k]))
                np.testing.assert_allclose(gap, dyads["length"][k], rtol=1e-8)

        five = cognate.exact.five_poses(poses)
        self.assertIn(len(five["kind"]), (0, 2, 4))
        check(five, poses)
        branches = cognate.exact.four_poses(poses[:4])
        self.assertGreater(len(branches), 0)
        for branch in branches:
            near = np.hypot(*branch["fixed"].T) < 50
            self.assertGreater(near.sum(), 10)
            check({key: np.asarray(value)[near] for key, value in branch.items()
                   if key != "status"}, poses[:4])
        check(cognate.exact.three_poses(poses[:3], in_body=[0.5, 0.5]), poses[:3])
        check(cognate.exact.three_poses(poses[:3], fixed=[0.5, 3]), poses[:3])

    def test_paths_through_poses(self):
        bar, angles = BAR, np.radians([10, 60, 120, 200, 290])
        points, turn = bar.curve(angles), bar.rotations(angles)["coupler"]
        found = cognate.exact.nine_points(points, turn)
        self.assertEqual(found.status, "solved")
        lengths = found.designs[:, 4:7]
        self.assertLess(abs(lengths - [1, 3.5, 3]).max(axis=1).min(), 1e-6)
        self.assertTrue(found.designs.flags.f_contiguous)

    def test_inflection_circle(self):
        """Points of the circle have paths without curvature."""
        centre, radius = cognate.exact.inflection_circle(BAR, 1.0)
        for turn in np.linspace(0, 6, 9):
            there = centre + radius * np.array([np.cos(turn), np.sin(turn)])
            b = BAR.positions(1.0)["B"]
            direction = np.exp(-1j * BAR.rotations(1.0)["coupler"])
            uv = complex(*(there - b)) * direction
            tables = {**BAR.to_dict(), "coupler_point": [uv.real, uv.imag]}
            moved = cognate.mechanism_of(tables)
            v, a = (moved.derivatives(1.0, order)["P"] for order in (1, 2))
            self.assertLess(abs(v[0] * a[1] - v[1] * a[0]), 1e-9)

    def test_cognates_trace_the_same_curve(self):
        found = cognate.exact.cognates(BAR, 1.0)
        self.assertEqual(len(found), 2)
        for bar, angle in found:
            np.testing.assert_allclose(bar.curve(angle), BAR.curve(1.0), atol=1e-10)

    def test_smallest_cam_keeps_the_angle(self):
        motion = [{"rise": 20, "over_deg": 120, "law": "cycloidal"}, {"law": "dwell", "over_deg": 60},
                  {"rise": -20, "over_deg": 120, "law": "cycloidal"}, {"law": "dwell", "over_deg": 60}]
        cam = cognate.exact.smallest_cam(motion, pressure_angle_deg=30)
        x = np.linspace(0, 1, 4001)
        s = 20 * (x - np.sin(2 * np.pi * x) / (2 * np.pi))
        rate = 20 * (1 - np.cos(2 * np.pi * x)) / np.radians(120)
        height = np.sqrt(cam.base_radius**2 - cam.offset**2)
        both = [np.arctan(abs(v - cam.offset) / (height + s)) for v in (rate, -rate)]
        self.assertAlmostEqual(np.degrees(np.max(both)), 30, places=4)

    def test_chebyshev(self):
        there = 1.5 - 0.5 * np.cos((2 * np.arange(1, 4) - 1) * np.pi / 6)
        np.testing.assert_allclose(cognate.exact.chebyshev_spacing(1, 2, 3), there, rtol=1e-15)


if __name__ == "__main__":
    unittest.main()
