"""Problems from Python: bit for bit the program's numbers, faults, pictures, pickles, threads.

Run as: problems_test.py PROGRAM LIBRARY, with the module on PYTHONPATH.
"""

import contextlib
import io
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
import unittest
import xml.etree.ElementTree

import cognate
import numpy as np

PROGRAM, LIBRARY = "", pathlib.Path()

QUICK = ["path/five-point-arc", "path/five-points-given-pivots", "function/log10", "motion/five-poses",
         "motion/two-poses-lengths", "quick-return/crank-rocker-best", "straight-line/evans",
         "cam/translating-roller", "cam/smallest-cam"]
ANALYSED = ["analysis/crank-rocker", "analysis/stephenson-six-bar", "analysis/slider-crank-forces",
            "machine/flywheel-of-table-loads", "gear/standard-35", "gear/undercut-9"]
PATH = {"kind": "path-generation",
        "target": {"points": [[0, 0], [1, 1.2], [2, 1.9], [3, 1.1], [2.5, 0.2]]},
        "solve": {"starts": 40}}


def program(*arguments):
    ran = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    return ran.stdout


def without_time(document):
    return {**document, "work": {**document["work"], "seconds": 0, "threads": 0}}


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.at = pathlib.Path(folder.name)
        before = os.getcwd()
        os.chdir(self.at)
        self.addCleanup(os.chdir, before)


class SameNumbersTest(InFolder):
    def compare(self, command, names):
        for name in names:
            with self.subTest(name):
                file = LIBRARY / f"{name}.toml"
                there = json.loads(program(command, file, "--json", "--threads", "2"))
                here = getattr(cognate, command)(file, threads=1)
                self.assertEqual(without_time(here.document), without_time(there))
                saved = json.loads(here.save("x.result.json").read_text())
                self.assertEqual(saved, here.document)

    def test_solve(self):
        self.compare("solve", QUICK)

    def test_analyze(self):
        self.compare("analyze", ANALYSED)

    def test_dictionaries_and_arrays_are_files(self):
        for name in ["path/five-point-arc", "motion/five-poses", "cam/translating-roller"]:
            with self.subTest(name):
                file = LIBRARY / f"{name}.toml"
                tables = tomllib.loads(file.read_text())
                by_file = without_time(cognate.solve(file).document)
                self.assertEqual(without_time(cognate.solve(tables).document), by_file)
                if "points" in tables.get("target", {}):
                    tables["target"]["points"] = np.array(tables["target"]["points"])
                self.assertEqual(without_time(cognate.solve(**tables).document), by_file)

    def test_keywords_replace_tables_of_a_file(self):
        file = LIBRARY / "analysis/crank-rocker.toml"
        result = cognate.analyze(file, drive={"steps": 8})
        self.assertEqual(len(next(iter(result.columns.values()))), 9)

    def test_a_mechanism_is_a_table(self):
        bar = cognate.FourBar(fixed_pivots=[[0, 0], [4, 0]], crank=1, coupler=3.5, rocker=3,
                              coupler_point=[1, 1])
        result = cognate.analyze(kind="analysis", mechanism=bar, drive={"steps": 36})
        points = bar.positions(np.radians(np.linspace(0, 360, 37)))
        for name in ("C", "P"):
            for axis, key in enumerate("xy"):
                np.testing.assert_allclose(result.columns[f"{name}_{key}"], points[name][:, axis],
                                           rtol=0, atol=1e-13)

    def test_check_and_list(self):
        for name in ["path/bean", "machine/press"]:
            there = json.loads(program("check", LIBRARY / f"{name}.toml", "--json"))
            self.assertEqual(cognate.check(LIBRARY / f"{name}.toml").problem, there["problem"])
        study = cognate.check(LIBRARY / "study/crank-rocker-map.toml")
        self.assertIn("961 designs", study.description)
        self.assertEqual(cognate.list(), json.loads(program("list", "--json")))
        self.assertEqual(cognate.list("cam", metrics=True),
                         json.loads(program("list", "cam", "--metrics", "--json")))

    def test_export_and_reports(self):
        file = LIBRARY / "quick-return/crank-rocker-best.toml"
        result = cognate.solve(file)
        result.save()
        program("export", "crank-rocker-best.result.json", "--format", "dxf", "--out", "there")
        made = result.export("dxf", out="here")
        self.assertEqual([f.read_bytes() for f in made.files],
                         [f.read_bytes() for f in pathlib.Path("there").iterdir()])
        page = result.report().read_text()
        self.assertIn("<!doctype html>", page.lower())
        again = cognate.load("crank-rocker-best.result.json")
        self.assertEqual(again.document, result.document)
        self.assertEqual(again.export("csv", out=None).texts, result.export("csv", out=None).texts)
        with self.assertRaises(cognate.ProblemError):
            again.report()
        self.assertEqual(result.best.analyze().status, "solved")

    def test_exports_take_every_option_of_the_command(self):
        result = cognate.solve(LIBRARY / "gear-pair/standard.toml")
        result.save()
        program("export", "standard.result.json", "--format", "dxf", "--length-unit", "mm", "--bore", "8,10",
                "--keyway", "--hub", "14,20", "--out", "there")
        made = result.export("dxf", out=None, length_unit="mm", bore=[8, 10], keyway=True, hub=(14, 20))
        self.assertEqual(list(made.texts.values()), [f.read_bytes() for f in pathlib.Path("there").iterdir()])
        for wrong, message in [({"bores": 8}, "bores: is no option of an export; allowed are bearing, bill, block,"),
                               ({"keyway": "yes"}, "keyway: expected True or False"),
                               ({"keyway": True}, "expected bore"), ({"bore": [1, 2, 3]}, "bore")]:
            with self.assertRaises(cognate.ProblemError) as caught:
                result.export("dxf", out=None, **wrong)
            self.assertIn(message, str(caught.exception))


class ResultTest(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.results = {name: cognate.solve(LIBRARY / f"{name}.toml")
                       for name in ["quick-return/crank-rocker-best", "cam/translating-roller"]}
        cls.results["analysis"] = cognate.analyze(LIBRARY / "analysis/crank-rocker.toml")
        cls.results["none"] = cognate.solve(PATH, constraints={"link_ratio_max": 1.0001},
                                            solve={"starts": 1})

    def test_designs(self):
        result = self.results["quick-return/crank-rocker-best"]
        best = result.designs[0]
        self.assertEqual(best.number, 1)
        self.assertIsInstance(best.mechanism, cognate.FourBar)
        self.assertEqual(best.mechanism.crank, best.document["mechanism"]["crank"])
        self.assertEqual(best.quantities.time_ratio, best.document["metrics"]["time_ratio"])
        self.assertEqual(best.error.rms, best.document["error"]["rms"])
        self.assertTrue(best.is_feasible)
        self.assertEqual(len(result.designs[:1]), 1)
        with self.assertRaises(IndexError):
            result.designs[len(result.designs)]

    def test_warnings(self):
        result = cognate.solve(LIBRARY / "quick-return/crank-rocker-best.toml",
                               constraints={"transmission_angle_deg": [89, 91]})
        for design in result.designs:
            self.assertEqual(any(name in text for text in design.warnings
                                 for name in ["transmission_angle_deg"]), not design.is_feasible)

    def test_frames(self):
        import pandas

        frame = self.results["quick-return/crank-rocker-best"].to_frame()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(frame.index[0], 1)
        self.assertEqual(frame["mechanism.crank"].iloc[0],
                         self.results["quick-return/crank-rocker-best"].best.mechanism.crank)
        self.assertEqual(len(self.results["analysis"].to_frame()), 361)

    def test_pictures(self):
        for name, result in self.results.items():
            with self.subTest(name):
                self.assertIn(result.status, result._repr_html_())
                if len(result.designs):
                    xml.etree.ElementTree.fromstring(result._repr_svg_())
        moving = self.results["quick-return/crank-rocker-best"]._repr_html_()
        self.assertIn("<animate ", moving)
        self.assertIn("<iframe srcdoc=", self.results["cam/translating-roller"]._repr_html_())

    def test_results_without_a_picture(self):
        for name in ["gear-pair/bevel", "gear-pair/worm", "machine/run-up"]:
            with self.subTest(name):
                run = cognate.analyze if name == "machine/run-up" else cognate.solve
                result = run(LIBRARY / f"{name}.toml")
                self.assertIn("no picture", result._repr_svg_())
                self.assertIn(result.status, result._repr_html_())

    def test_designs_are_read_again(self):
        """Dimensions that rounding has left near 0 are 0: files take nothing below 1e-30."""
        for design in cognate.solve(LIBRARY / "straight-line/slider-crank.toml").designs:
            self.assertIn("P", design.mechanism.point_names)
            self.assertEqual(design.analyze().status, "solved")

    def test_text_of_users_is_no_markup(self):
        result = cognate.solve(PATH, title="<script>alert(1)</script>", solve={"starts": 1})
        self.assertNotIn("<script>alert", result._repr_html_())

    def test_pickles(self):
        for name, result in self.results.items():
            with self.subTest(name):
                copy = pickle.loads(pickle.dumps(result))
                self.assertEqual(copy.document, result.document)
                self.assertEqual(copy.report("a.html").read_text(), result.report("b.html").read_text())
                self.assertEqual([d.row() for d in copy.designs], [d.row() for d in result.designs])
        design = pickle.loads(pickle.dumps(self.results["quick-return/crank-rocker-best"].best))
        self.assertEqual(design.mechanism, self.results["quick-return/crank-rocker-best"].best.mechanism)


class RunTest(InFolder):
    def test_progress_and_time_limit(self):
        seen = []
        result = cognate.solve(LIBRARY / "path/bean.toml", time_limit=0.6,
                               progress=lambda share, best: seen.append(share))
        self.assertIn(result.status, ("time-limit", "solved"))
        self.assertTrue(seen and all(0 <= share <= 1 for share in seen))

    def test_progress_names_the_part_of_the_run(self):
        seen = []
        cognate.solve(LIBRARY / "path/bean.toml", time_limit=0.4,
                      progress=lambda share, best, part: seen.append(part))
        self.assertEqual(set(seen), {"search"})
        terminal = io.StringIO()
        with contextlib.redirect_stderr(terminal):
            cognate.solve(LIBRARY / "path/bean.toml", time_limit=0.6, progress=True)
        self.assertRegex(terminal.getvalue(), r"\] +\d+ %  search, (\d+:\d\d (left|so far)|best)")
        self.assertTrue(terminal.getvalue().endswith("\r"))

    def test_what_progress_raises_is_raised(self):
        def stop(share, best):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            cognate.solve(LIBRARY / "path/bean.toml", time_limit=60, progress=stop)

    def test_ctrl_c_loses_nothing(self):
        found = threading.Event()
        sent = threading.Thread(target=lambda: (found.wait(60), os.kill(os.getpid(), signal.SIGINT)))
        sent.start()

        def progress(share, best):
            if np.isfinite(best):
                found.set()
                sent.join()  # it may come in the midst of this

        begun = time.monotonic()
        result = cognate.solve(LIBRARY / "path/bean.toml", solve={"starts": 1_000_000},
                               time_limit=60, progress=progress)
        self.assertEqual(result.status, "interrupted")
        self.assertLess(time.monotonic() - begun, 50)
        self.assertGreater(len(result.designs), 0)

    def test_other_threads_run_meanwhile(self):
        counted = [0]
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.001)

        other = threading.Thread(target=count)
        other.start()
        cognate.solve(LIBRARY / "path/bean.toml", time_limit=0.5, threads=1)
        stop.set()
        other.join()
        self.assertGreater(counted[0], 20)

    def test_threads_and_processes(self):
        from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

        alone = without_time(cognate.solve(PATH).document)
        with ThreadPoolExecutor(4) as pool:
            for result in pool.map(cognate.solve, [PATH] * 4):
                self.assertEqual(without_time(result.document), alone)
        with ProcessPoolExecutor(2) as pool:  # forked
            for result in pool.map(cognate.solve, [PATH] * 2):
                self.assertEqual(without_time(result.document), alone)

    def test_a_fork_does_not_wait_for_threads_it_has_not(self):
        code = ("import cognate, os, threading, time\n"
                "threading.Thread(target=cognate.solve, args=(%r,), kwargs={'time_limit': 6}).start()\n"
                "time.sleep(0.5)\nchild = os.fork()\nif child == 0: raise SystemExit\n"
                "begun = time.monotonic()\nos.waitpid(child, 0)\n"
                "raise SystemExit(time.monotonic() - begun > 5)" % str(LIBRARY / "path/bean.toml"))
        ran = subprocess.run([sys.executable, "-c", code], timeout=60, capture_output=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def test_ctrl_c_ends_a_search_of_a_model(self):
        wavy = cognate.Model({"x": (-9, 9)}, lambda x: [np.sin(9 * x[0]) + x[0] - 1])
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        found = cognate.model.search(wavy, starts=10**8)
        self.assertEqual(found.status, "interrupted")
        self.assertGreater(len(found.minima), 0)

    def test_the_end_of_the_interpreter(self):
        code = ("import cognate, threading, time\n"
                "threading.Thread(target=cognate.solve, args=(%r,), kwargs={'time_limit': 60}, "
                "daemon=True).start()\ntime.sleep(0.5)" % str(LIBRARY / "path/bean.toml"))
        ran = subprocess.run([sys.executable, "-c", code], timeout=45, capture_output=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)


class StudyTest(InFolder):
    STUDY = {"base": {"kind": "analysis",
                      "mechanism": {"type": "four-bar", "fixed_pivots": [[0, 0], [4, 0]], "crank": 1.0,
                                    "coupler": 3.5, "rocker": 3.0, "coupler_point": [1.0, 1.0]}},
             "vary": [{"key": "mechanism.coupler", "range": [2, 5], "steps": 31}],
             "output": {"metrics": ["class", "time_ratio"], "rows": "all"}}

    def test_rows(self):
        study = cognate.sweep(self.STUDY, name="s")
        columns = study.columns()
        self.assertEqual(len(columns["id"]), 31)
        np.testing.assert_allclose(columns["mechanism.coupler"], np.linspace(2, 5, 31), rtol=1e-15)
        self.assertIn("crank-rocker", columns["class"])
        self.assertEqual(list(study.to_frame()["class"]), columns["class"])
        blocks = list(study.blocks(10))
        self.assertEqual([len(block["id"]) for block in blocks], [10, 10, 10, 1])
        np.testing.assert_array_equal(np.concatenate([b["time_ratio"] for b in blocks]),
                                      columns["time_ratio"])
        self.assertEqual(cognate.Study(study.file).columns(["class"])["class"], columns["class"])
        again = cognate.sweep(self.STUDY, name="s")
        self.assertEqual(again.document["work"]["designs"], 0)
        study.report("s.html")
        self.assertIn("crank-rocker", study._repr_html_())

    def test_ctrl_c_keeps_the_rows(self):
        vary = [{"key": f"mechanism.{key}", "range": [2, 5], "steps": 1000} for key in ("coupler", "rocker")]
        threading.Timer(0.7, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        study = cognate.sweep(self.STUDY, vary=vary, name="long")
        self.assertEqual(study.document["status"], "interrupted")
        self.assertEqual(len(study.columns(["time_ratio"])["id"]), study.counts.evaluated)
        self.assertEqual(pickle.loads(pickle.dumps(study)).counts, study.counts)

    def test_blocks_and_names(self):
        study = cognate.sweep(self.STUDY, name="s")
        self.assertEqual(list(study.columns("time_ratio")), ["id", "status", "time_ratio"])
        for do, key in ((lambda: list(study.blocks(0)), "rows"), (lambda: study.columns(["x"]), "names"),
                        (lambda: study.columns(first=-1), "first")):
            with self.assertRaises(cognate.ProblemError) as raised:
                do()
            self.assertEqual(raised.exception.key, key)

    def test_the_program_s_rows(self):
        program("sweep", LIBRARY / "study/crank-rocker-map.toml", "--quiet", "--out", "there")
        study = cognate.sweep(LIBRARY / "study/crank-rocker-map.toml", out="here")
        here = study.columns()
        there = cognate.Study("there/crank-rocker-map.study.db").columns()
        self.assertEqual(list(here), list(there))
        for name in here:
            np.testing.assert_array_equal(here[name], there[name])

    def test_columns_in_hdf5(self):
        program("sweep", LIBRARY / "study/crank-rocker-map.toml", "--quiet", "--out", "there", "--format", "hdf5")
        if not pathlib.Path("there/crank-rocker-map.study.h5").exists():
            self.skipTest("the program writes no columns")
        rows, columns = (cognate.Study(f"there/crank-rocker-map.study.{ending}") for ending in ("db", "h5"))
        for name, values in rows.columns().items():
            np.testing.assert_array_equal(columns.columns()[name], values)
        self.assertEqual([len(block["id"]) for block in columns.blocks(2000)],
                         [len(block["id"]) for block in rows.blocks(2000)])
        pathlib.Path("bad.study.h5").write_bytes(b"\x89HDF\r\n\x1a\n")
        with self.assertRaises(cognate.ProblemError):
            cognate.Study("bad.study.h5").columns()


if __name__ == "__main__":
    PROGRAM, LIBRARY = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
