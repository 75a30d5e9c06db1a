"""What people get wrong in Python: every message names the key, and nothing crashes.

Run as: mistakes_test.py, with the module on PYTHONPATH.
"""

import math
import pathlib
import pickle
import tempfile
import unittest

import cognate
import numpy as np

POINTS = [[0, 0], [1, 1], [2, 0]]
BAR = {"fixed_pivots": [[0, 0], [4, 0]], "crank": 1, "coupler": 3.5, "rocker": 3}
KIND = "path-generation"


def check(**tables):
    return lambda: cognate.check(**tables)


cyclic = {"kind": KIND}
cyclic["target"] = cyclic

def analyzed_with(tolerance):
    return cognate.analyze(kind="analysis", mechanism=dict(type="four-bar", **BAR), tolerance=tolerance)


SWING = [{"law": "cycloidal", "over_deg": 180, "rise_deg": 20},
         {"law": "cycloidal", "over_deg": 180, "rise_deg": -20}]
MISTAKES = [  # what is done, the key, a part of the message
    (check(target={"points": POINTS}), "kind", "missing"),
    (check(kind="path"), "kind", "path-generation"),
    (check(kind=KIND, target={"point": POINTS}), "target.point", "points"),
    (check(kind=KIND, target={"points": POINTS}, solver="slsqp"), "solver", ""),
    (check(kind=KIND, target={"points": POINTS}, solve={"solver": "bfgs"}), "solve.solver", "slsqp"),
    (check(kind=KIND, target={"points": [[0, 0], [1, float("nan")], [2, 0]]}), "target.points[1]", ""),
    (check(kind=KIND, target={"points": [[0, 0], [1], [2, 0]]}), "target.points[1]", "[x, y]"),
    (check(kind=KIND, target={"points": np.zeros((3, 3))}), "target.points[0]", "[x, y]"),
    (check(kind=KIND, target={"points": "0 0 1 1"}), "target.points", "array"),
    (check(kind=KIND, target={"points": {1, 2}}), "target.points", "set"),
    (check(kind=KIND, target={"points": np.array([1 + 2j])}), "target.points", "complex"),
    (check(kind=KIND, target={"points": POINTS, "timing": "prescribed"}), "target.timing", "crank_deg"),
    (check(kind=KIND, target=POINTS), "target", "table"),
    (check(kind=KIND, target={"points": POINTS}, bounds={"length": [5, 1]}), "bounds.length", ""),
    (check(kind=KIND, target={"points": POINTS}, solve={"designs": 2.5}), "solve.designs", "integer"),
    (check(kind=KIND, target={"points": POINTS}, solve={"designs": 10**30}), "solve.designs", "bits"),
    (check(kind=KIND, target={1: 2}), "target", "strings"),
    (check(**cyclic), "target", "nested"),
    (check(kind=KIND, target={"svg": "missing.svg"}), "target.svg", "missing.svg"),
    (check(kind=KIND, target={"points": [[0, 0], None, [1, 1]]}), "target.points[1]", "None"),
    (check(kind=KIND, title="a\0b", target={"points": POINTS}), "title", "U+0000"),
    (lambda: cognate.solve(kind=KIND, target={"points": POINTS}, seed=-1), "seed", "whole number"),
    (lambda: cognate.solve(kind=KIND, target={"points": POINTS}, threads=0), "threads", "1 to 1024"),
    (lambda: cognate.solve(kind=KIND, target={"points": POINTS}, time_limit="soon"), "time_limit",
     "seconds"),
    (lambda: cognate.solve(kind=KIND, target={"points": POINTS}, progress=3), "progress", "function"),
    (lambda: cognate.solve(17), "", "name of a file"),
    (lambda: cognate.solve("nowhere.toml"), "", "nowhere.toml"),
    (lambda: cognate.solve(kind="analysis", mechanism={"type": "four-bar", **BAR}), "kind", "analyze"),
    (lambda: cognate.FourBar(**{**BAR, "crank": -1}), "mechanism.crank", ""),
    (lambda: cognate.FourBar(**BAR, ground=4), "mechanism.ground", ""),
    (lambda: cognate.FourBar(crank=1), "mechanism", "missing"),
    (lambda: cognate.Mechanism(type="five-bar"), "mechanism.type", "four-bar"),
    (lambda: cognate.FourBar(**BAR).positions("x"), "angles", "numbers"),
    (lambda: cognate.FourBar(**BAR).positions([1, 1j]), "angles", "numbers"),
    (lambda: cognate.FourBar(**BAR).positions([[1, 2], [3]]), "angles", "numbers"),
    (lambda: cognate.FourBar(**BAR).positions(1.0, points=["Q"]), "point", '"A"'),
    (lambda: cognate.FourBar(**BAR).positions(1.0, threads=-3), "threads", ""),
    (lambda: cognate.FourBar(**BAR).forces(1.0, load=[{"on": "wheel", "force": [1, 0]}]), "load", ""),
    (lambda: cognate.batch.positions(np.zeros((3, 4)), [0.0]), "designs", "(3, 4)"),
    (lambda: cognate.batch.positions({"crank": [1.0]}, [0.0]), "designs", "pivot_a_x"),
    (lambda: cognate.batch.evaluate(np.zeros((1, 10)), [0.0], ["speed"]), "quantities", "velocity"),
    (lambda: cognate.batch.positions(np.zeros((2, 10)), [0.0], out=np.zeros((2, 1, 2))), "out", "order"),
    (lambda: cognate.exact.five_poses(np.zeros((4, 3))), "poses", "(5, 3)"),
    (lambda: cognate.exact.freudenstein([0, 1, math.nan], [0, 1, 2]), "input", "finite"),
    (lambda: cognate.exact.nine_points(np.zeros((4, 2))), "points", "nine"),
    (lambda: cognate.Model({"x": 3}, abs), "x", "lower"),
    (lambda: cognate.model.search(cognate.Model({"x": (0, 1)}, lambda x: x), solver="bfgs"), "solver",
     "slsqp"),
    (lambda: cognate.FourBar(**BAR).positions(None), "angles", "None"),
    (lambda: cognate.FourBar(**BAR).positions([1.0, None]), "angles", "None"),
    (lambda: cognate.FourBar(**BAR).positions(1.0, threads="all"), "threads", "whole number"),
    (lambda: cognate.FourBar(**BAR).positions(1.0, points=3), "points", "list of names"),
    (lambda: cognate.FourBar(**BAR).derivatives(1.0, 4), "order", "0 to 3"),
    (lambda: cognate.FourBar(**BAR).curve(1.0, point=3), "point", "string"),
    (lambda: cognate.FourBar(**BAR).velocities([1.0, 2.0], [1.0, 2.0, 3.0]), "speed", "angles"),
    (lambda: cognate.FourBar(**BAR).accelerations(1.0, 1.0, None), "acceleration", "None"),
    (lambda: cognate.FourBar(**BAR).forces(1.0, speed="fast"), "speed", "numbers"),
    (lambda: cognate.FourBar(**BAR).forces(1.0, speed=math.nan), "speed", "finite"),
    (lambda: cognate.FourBar(**BAR).forces([1.0, 2.0], speed=[1.0]), "speed", "one for each"),
    (lambda: cognate.FourBar.__new__(cognate.FourBar).positions(1.0), "mechanism", "__init__"),
    (lambda: cognate.mechanism_of(None), "mechanism", "dictionary"),
    (lambda: cognate.batch.evaluate(np.zeros((1, 10)), [0.0], 3), "quantities", "list"),
    (lambda: cognate.batch.evaluate(np.zeros((1, 10)), [0.0], out={"velocity": np.zeros(3)}), "out",
     "velocity"),
    (lambda: cognate.batch.evaluate(np.zeros((1, 10)), [0.0], out=3), "out", "dictionary"),
    (lambda: cognate.exact.cognates(3), "mechanism", "FourBar"),
    (lambda: cognate.exact.inflection_circle(cognate.FourBar(**BAR), "x"), "angle", "number"),
    (lambda: cognate.exact.chebyshev_spacing(0, 1, 2.5), "count", "whole number"),
    (lambda: cognate.exact.smallest_cam([], pressure_angle_deg="30"), "pressure_angle_deg", "number"),
    (lambda: cognate.exact.two_poses(np.zeros((2, 3))), "in_body", "exactly one"),
    (lambda: cognate.exact.guided_mechanism(np.zeros((3, 3)), {}, 0, 1), "dyads", "row 0"),
    (lambda: cognate.exact.quick_return_rockers(time_ratio=0.5, rocker=1, swing=1), "time_ratio", "1"),
    (lambda: cognate.exact.quick_return_rockers(time_ratio=2, rocker=1, swing=1, crank=1, frame=1),
     "crank", "one of them"),
    (lambda: cognate.exact.quick_return_guides(time_ratio=2), "frame", "one of them"),
    (lambda: cognate.exact.straight_lengths(cognate.FourBar(**BAR), 1.0, "ground"), "length", "frame"),
    (lambda: cognate.exact.nine_points(np.zeros((5, 2)), pivot_a=[0, 0, 0]), "pivot_a", "[x, y]"),
    (lambda: cognate.Model([1, 2], abs), "variables", "lower"),
    (lambda: cognate.model.solve(cognate.Model({"x": (0, 1)}, abs), iterations=-1), "iterations", ""),
    (lambda: cognate.model.solve(cognate.Model({"x": (0, 1)}, abs), tolerance=0), "tolerance", ""),
    (lambda: cognate.model.search(cognate.Model({"x": (0, 1)}, abs), starts="many"), "starts", ""),
    (lambda: cognate.model.search(cognate.Model({"x": (0, 1)}, abs), starts=2**40), "starts", ""),
    (lambda: cognate.model.solve(cognate.Model({"x": (0, 1)}, abs, equalities="x")), "equalities", ""),
    (lambda: cognate.load(None), "file", "name of a file"),
    (lambda: cognate.sweep({}, name="../x"), "name", "without a folder"),
    (lambda: cognate.sweep({"base": {}}, out="/proc/nowhere"), "out", ""),
    (lambda: cognate.list(3), "kind", "string"),
    (lambda: cognate.list("cars"), "kind", "cam"),
    (lambda: cognate.exact.equal_peaks(3, [0, 1], [1, 1, 1, 1], input_start=0, output_start=0),
     "output", "function"),
    (lambda: cognate.exact.equal_peaks(abs, [1, 1], [1, 1, 1, 1], input_start=0, output_start=0),
     "interval", "two different"),
    (lambda: cognate.exact.equal_peaks(abs, [0, 1], [1, 1, 1], input_start=0, output_start=0),
     "links", "(4,)"),
    (lambda: cognate.exact.equal_peaks(abs, [0, 1], [1, 1, -1, 1], input_start=0, output_start=0),
     "links", "above 0"),
    (lambda: cognate.exact.equal_peaks(abs, [0, 1], [1, 1, 1, 1], input_start=None, output_start=0),
     "input_start", "number"),
    (lambda: cognate.exact.equal_peaks(abs, [0, 1], [1, 1, 1, 1], input_start=0, output_start=0,
                                       assembly="up"), "assembly", "crossed"),
    (lambda: cognate.exact.equal_peaks(lambda x: "y", [0, 1], [1, 2, 2, 2], input_start=0,
                                       output_start=0), "output(input)", "number"),
    (lambda: cognate.exact.equal_peaks(lambda x: math.nan, [0, 1], [1, 2, 2, 2], input_start=0,
                                       output_start=0), "output(input)", "finite"),
    (lambda: cognate.exact.smallest_oscillating_cam([], pressure_angle_deg=30, arm=50), "motion", ""),
    (lambda: cognate.exact.smallest_oscillating_cam(SWING, pressure_angle_deg=90, arm=50),
     "pressure_angle_deg", "below 90"),
    (lambda: cognate.exact.smallest_oscillating_cam(SWING, pressure_angle_deg=30, arm=-1), "arm", ""),
    (lambda: cognate.exact.smallest_oscillating_cam(SWING, pressure_angle_deg=30, arm=50, side="up"),
     "side", "leading"),
    (lambda: cognate.exact.smallest_oscillating_cam([{"law": "cycloidal", "over_deg": 360, "rise": 3}],
                                                    pressure_angle_deg=30, arm=50), "motion", ""),
    (lambda: cognate.exact.involute(2), "angle", "between"),
    (lambda: cognate.exact.involute([0.1, math.nan]), "angle", "between"),
    (lambda: cognate.exact.involute("x"), "angle", "numbers"),
    (lambda: cognate.exact.involute_angle(None), "value", "None"),
    (lambda: cognate.exact.involute_angle([1, math.inf]), "value", "finite"),
    (lambda: cognate.solve(kind="path-generation", target={"points": [[0, 0], [1, 1]]},
                           tolerance={"lenght": 0.1}), "tolerance", "length"),
    (lambda: analyzed_with({"length": "IT99"}), "tolerance.length", "IT8"),
    (lambda: analyzed_with({"length": -0.1}), "tolerance.length", "length"),
    (lambda: analyzed_with({}), "tolerance", ""),
    (lambda: cognate.load("nowhere.result.json"), "", "nowhere"),
    (lambda: cognate.sweep(base="nowhere.toml", vary=[]), "base", ""),
]


class MistakesTest(unittest.TestCase):
    def test_each_names_its_key(self):
        for number, (do, key, part) in enumerate(MISTAKES):
            with self.subTest(number=number, key=key):
                with self.assertRaises(cognate.ProblemError) as raised:
                    do()
                keys = [fault.key for fault in raised.exception.faults]
                self.assertTrue(any(found.startswith(key) for found in keys),
                                f"{keys}: {raised.exception}")
                self.assertIn(part, str(raised.exception))
                if key:
                    self.assertIn(key.split("[")[0].split(".")[-1], str(raised.exception))

    def test_all_faults_at_once(self):
        with self.assertRaises(cognate.ProblemError) as raised:
            cognate.check(kind=KIND, target={"points": [[0, 0], [1, "x"], [2, 0]], "order": "odd"},
                          bounds={"length": [3, 2]}, colour="red")
        error = raised.exception
        self.assertEqual([fault.key for fault in error.faults],
                         ["target.points[1][1]", "target.order", "bounds.length", "colour"])
        self.assertEqual(error.key, error.faults[0].key)
        self.assertIsNone(error.line)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual(again.faults, error.faults)
        self.assertEqual(str(again), str(error))

    def test_faults_of_a_file_have_places(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "x.toml"
            file.write_text('kind = "path-generation"\n[target]\npoints = [[0, 0], [1], [2, 0]]\n')
            with self.assertRaises(cognate.ProblemError) as raised:
                cognate.check(file)
        error = raised.exception
        self.assertEqual((error.file, error.line, error.column, error.key),
                         (str(file), 3, 19, "target.points[1]"))
        self.assertTrue(str(error).startswith(f"{file}:3:19: "))


class AttackTest(unittest.TestCase):
    """Any input gives an answer or an exception."""

    STRANGE = [None, True, 0, -1, 2**70, 1.5, math.nan, math.inf, "", "x", b"x", [], [[]], {}, {1: 2},
               set(), object(), lambda: 0, np.array(3), np.array([]), np.zeros((0, 2)),
               np.zeros((2, 3, 4, 5)), np.full(3, np.nan), np.array(["a"]), np.array([None]),
               np.arange(10)[::2], np.arange(6).reshape(2, 3).T, np.float32(1), np.int8(3),
               np.ma.masked_array([1.0, 2.0], mask=[0, 1]), np.datetime64("2020"),
               np.zeros(3, dtype=[("a", float)]), memoryview(b"abc"), range(3), 1j,
               np.zeros((1,) * 30)]

    def survive(self, do, *arguments, **keywords):
        try:
            do(*arguments, **keywords)
        except (cognate.ProblemError, TypeError, ValueError, OverflowError, AttributeError, KeyError,
                IndexError, MemoryError):
            pass

    def test_arguments(self):
        bar = cognate.FourBar(**BAR, coupler_point=[1, 1])
        for value in self.STRANGE:
            for do in (bar.positions, bar.velocities, bar.accelerations, bar.curve, bar.rotations,
                       bar.transmission, bar.gradient, bar.forces, cognate.check, cognate.load,
                       cognate.exact.five_poses, cognate.exact.four_poses, cognate.exact.three_poses,
                       cognate.exact.precision_points, cognate.exact.nine_points,
                       cognate.batch.columns, cognate.mechanism_of, cognate.Study):
                with self.subTest(value=repr(value)[:40], do=do):
                    self.survive(do, value)
            self.survive(cognate.batch.positions, np.zeros((2, 10)), value)
            self.survive(cognate.batch.positions, value, [0.0])
            self.survive(cognate.batch.positions, np.zeros((2, 10)), [0.0], out=value)
            self.survive(cognate.exact.freudenstein, value, value, value)
            self.survive(bar.positions, 1.0, points=value, threads=1)
            self.survive(bar.velocities, [1.0, 2.0], value)
            self.survive(bar.curve, [0.0], point=value)
            self.survive(cognate.exact.inflection_circle, bar, value)
            self.survive(cognate.exact.inflection_circle, value, 0.0)
            self.survive(cognate.exact.cognates, value)
            self.survive(cognate.exact.smallest_cam, value, pressure_angle_deg=30)
            for key in ("seed", "threads", "time_limit", "progress"):
                self.survive(cognate.solve, {"kind": KIND}, **{key: value})
            for kind in ("path-generation", "cam", "analysis", "machine", "gear"):
                for key in ("target", "mechanism", "motion", "solve", "title", "load", "length_unit"):
                    self.survive(cognate.check, {"kind": kind, key: value})
            self.survive(cognate.Model, {"x": value}, lambda x: x)
            self.survive(cognate.Model, value, lambda x: x)

    def test_models_that_misbehave(self):
        def shrinking(x, count=[0]):
            count[0] += 1
            return np.zeros(max(0, 5 - count[0]))

        def raising(x):
            raise KeyError("mine")

        for residuals in (shrinking, lambda x: None, lambda x: "x", lambda x: [math.nan],
                          lambda x: [[1.0]], lambda x: 1.0, lambda x: []):
            self.survive(cognate.model.search, cognate.Model({"x": (0, 1)}, residuals), starts=5)
            self.survive(cognate.model.solve, cognate.Model({"x": (0, 1)}, residuals))
        with self.assertRaisesRegex(KeyError, "mine"):
            cognate.model.search(cognate.Model({"x": (0, 1)}, raising))
        late = iter([1.0] * 20)
        with self.assertRaises((StopIteration, RuntimeError)):
            cognate.model.search(cognate.Model({"x": (-9, 9)}, lambda x: [x[0] + next(late)]),
                                 threads=3)

    def test_sizes(self):
        bar = cognate.FourBar(**BAR, coupler_point=[1, 1])
        self.assertEqual(bar.positions([])["P"].shape, (0, 2))
        self.assertEqual(bar.positions(np.zeros((3, 0, 2)))["B"].shape, (3, 0, 2, 2))
        self.assertEqual(cognate.batch.positions(np.zeros((0, 10)), [1.0]).shape, (0, 1, 2))
        self.assertEqual(cognate.batch.positions(np.zeros((2, 10)), []).shape, (2, 0, 2))
        many = bar.curve(np.linspace(0, 100, 2_000_001), threads=0)
        self.assertEqual(many.shape, (2_000_001, 2))
        with self.assertRaises(MemoryError):
            cognate.batch.positions(np.zeros((10**6, 10)), np.zeros(10**7))


if __name__ == "__main__":
    unittest.main()
