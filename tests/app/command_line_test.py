"""The program from outside: exit statuses, messages, and what lands on which stream.

Run as: command_line_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()


def run(*arguments, **options):
    """Runs the program in a folder of its own choice (`cwd`) and waits for its end."""
    options.setdefault("stdout", subprocess.PIPE)
    options.setdefault("stderr", subprocess.PIPE)
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=120, **options)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.problem = LIBRARY / "path" / "six-point-line.toml"

    def expect_refusal(self, done, *parts):
        """Exit status 2, nothing on standard output, and each of `parts` in the message."""
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        for part in parts:
            self.assertIn(part, done.stderr)

    def expect_one_line_refusal(self, done, *parts):
        self.expect_refusal(done, *parts)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_help_shows_each_command_and_an_example_of_it(self):
        general = run("--help")
        self.assertEqual(general.returncode, 0)
        self.assertEqual(general.stderr, "")
        for command in ("solve", "analyze", "sweep", "export", "check", "list"):
            self.assertIn("\n  cognate " + command, general.stdout)
            special = run(command, "--help")
            self.assertEqual(special.returncode, 0)
            self.assertIn("\n  cognate " + command, special.stdout)
            for option in ("--json", "--seed", "--threads", "--time-limit", "--quiet"):
                self.assertIn(option, special.stdout)

    def test_version(self):
        done = run("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^cognate \d+\.\d+\.\d+\n$")

    def test_a_command_is_needed(self):
        commands = "new, solve, analyze, sweep, export, sketch, studio, involute, check and list"
        self.expect_one_line_refusal(run(), commands)
        self.expect_one_line_refusal(run("--json"), commands)
        self.expect_one_line_refusal(run("sovle", "x"), "'sovle'", commands)

    def test_bad_options(self):
        for arguments, part in [
            (["--frobnicate"], "--frobnicate"),
            (["--seed", "-1"], "--seed: '-1'"),
            (["--seed", "1e3"], "--seed: '1e3'"),
            (["--seed", "99999999999999999999"], "9007199254740991"),
            (["--seed"], "--seed"),
            (["--threads", "0"], "--threads: '0'"),
            (["--threads", "-2"], "--threads: '-2'"),
            (["--time-limit", "nan"], "--time-limit: 'nan'"),
            (["--time-limit", "-1"], "--time-limit: '-1'"),
            (["--time-limit", "0"], "--time-limit: '0'"),
            (["--time-limit", "inf"], "--time-limit: 'inf'"),
            (["--out", ""], "--out"),
        ]:
            with self.subTest(arguments):
                done = run("solve", self.problem, *arguments, cwd=self.folder)
                self.expect_one_line_refusal(done, part)
                self.assertEqual(list(self.folder.iterdir()), [])
        self.expect_one_line_refusal(run("solve"), "FILE")
        both = run("solve", self.problem, "--seed", "x", "--threads", "x", cwd=self.folder)
        self.expect_refusal(both, "--seed", "--threads")

    def test_files_that_are_no_problems(self):
        empty = self.folder / "empty.toml"
        empty.touch()
        for command in ("solve", "check"):
            for file in (self.folder / "missing.toml", self.folder, empty):
                with self.subTest(command=command, file=file):
                    done = run(command, file, cwd=self.folder)
                    self.expect_one_line_refusal(done, f"{file}:1:1: ")
        self.assertEqual(list(self.folder.iterdir()), [empty])

    def test_a_file_may_be_a_pipe(self):
        pipe = self.folder / "pipe.toml"
        os.mkfifo(pipe)
        running = subprocess.Popen([PROGRAM, "check", pipe], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        pipe.write_bytes(self.problem.read_bytes())
        output, errors = running.communicate(timeout=60)
        self.assertEqual((running.returncode, errors), (0, b""))
        self.assertIn(b"no fault found", output)
        given = subprocess.run(
            [PROGRAM, "check", "/dev/stdin"], input=self.problem.read_bytes(), capture_output=True, timeout=60
        )
        self.assertEqual(given.returncode, 0, given.stderr)

    def test_waiting_for_a_pipe_ends_at_the_first_signal(self):
        pipe = self.folder / "pipe.toml"
        os.mkfifo(pipe)
        tested = 0
        for command in (["check"], ["solve"], ["analyze"], ["sweep"], ["export", "--format", "svg"]):
            for sent in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(command=command, sent=sent):
                    running = subprocess.Popen(
                        [PROGRAM, *command, pipe],
                        cwd=self.folder,
                        stdout=subprocess.DEVNULL,
                        stderr=subprocess.DEVNULL,
                    )
                    time.sleep(0.3)
                    self.assertIsNone(running.poll())
                    running.send_signal(sent)
                    try:
                        self.assertEqual(running.wait(timeout=20), -sent)
                    finally:
                        running.kill()
                        running.wait()
                    tested += 1
        self.assertEqual(tested, 15)

    def test_a_nul_is_a_fault_with_its_place(self):
        file = self.folder / "nul.toml"
        for text, place in (
            ('title = "a\\u0000b"\n', "1:9: this string"),
            ('kind = "path-generation"\n[target]\nsvg = "a.svg\\u0000b"\n', "3:7: this string"),
            ('kind = "path-generation"\n[target]\nlist = [["x"], ["\\U00000000"]]\n', "3:17: this string"),
            ('kind = "path-generation"\n"a\\u0000" = 1\n', "2:1: this key"),
            ('kind = "study"\nbase = "base.toml\\u0000"\n', "2:8: this string"),
        ):
            with self.subTest(text):
                file.write_text(text)
                self.expect_one_line_refusal(run("check", file), f"{file}:{place} holds the character U+0000")

    def test_every_fault_of_a_file_has_its_place(self):
        file = self.folder / "faults.toml"
        file.write_text(
            'kind = "path-generation"\n'
            "[target]\n"
            "points = [[0, 0], [1, 0], [1, 1]]\n"
            'timing = "fre"\n'
            "[solve]\n"
            "desings = 3\n"
        )
        done = run("check", file)
        self.expect_refusal(done, f"{file}:4:", f"{file}:6:", "designs")
        self.assertEqual(done.stderr.count("\n"), 2, done.stderr)

        documented = run("check", file, "--json")
        self.assertEqual(documented.returncode, 2)
        document = json.loads(documented.stdout)
        self.assertFalse(document["valid"])
        self.assertEqual([fault["line"] for fault in document["faults"]], [4, 6])

    def test_faults_of_results_are_a_document_too(self):
        damaged = self.folder / "damaged.result.json"
        damaged.write_text('{"format": "cognate-result/1"')
        for file in (damaged, self.folder / "missing.result.json"):
            for command in (["export", file, "--format", "dxf"], ["analyze", file, "--design", "1"]):
                with self.subTest(command):
                    done = run(*command, "--json")
                    self.assertEqual(done.returncode, 2)
                    document = json.loads(done.stdout)
                    self.assertEqual((document["file"], document["valid"]), (str(file), False))
                    message = document["faults"][0]["message"]
                    self.assertIn(message, done.stderr)

    def test_control_characters_of_a_file_stay_out_of_messages(self):
        file = self.folder / "escape.toml"
        file.write_text('kind = "path-\\u001b[31mgeneration"\n')
        done = run("check", file)
        self.expect_refusal(done)
        self.assertNotIn("\x1b", done.stderr)
        file.write_text('kind = "path-\\u009b31mé"\n')
        done = run("check", file)
        self.expect_refusal(done, "path-?31mé")
        self.assertNotIn("\x9b", done.stderr)

    def test_a_problem_may_come_through_a_pipe(self):
        pipe = self.folder / "pipe.toml"
        os.mkfifo(pipe)
        writer = threading.Thread(target=lambda: pipe.write_text(self.problem.read_text()))
        writer.start()
        done = run("check", pipe)
        writer.join()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("6 points", done.stdout)

    def test_check_says_what_the_problem_is(self):
        files = list(LIBRARY.rglob("*.toml"))
        self.assertGreater(len(files), 100)
        done = run("check", *files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), len(files))
        for file, line in zip(files, lines):
            self.assertTrue(line.startswith(f"{file}: ") and line.endswith("no fault found"), line)
        self.assertEqual(run("check", *files, "--quiet").stdout, "")
        rest, decoder = run("check", *files, "--json").stdout, json.JSONDecoder()
        for file in files:
            document, end = decoder.raw_decode(rest)
            rest = rest[end:].lstrip()
            self.assertEqual((document["file"], document["valid"]), (str(file), True))
            kind = {"chain": "path", "chain-function": "function", "dwell": "function"}.get(file.parent.name, file.parent.name)
            if kind in ("function", "motion", "path"):
                kind += "-generation"
            self.assertEqual(document["problem"]["kind"], kind)
        self.assertEqual(rest, "")

    def test_each_command_says_which_other_takes_a_file(self):
        mechanism = LIBRARY / "analysis" / "shaper.toml"
        for command, file, other in [
            ("solve", mechanism, "cognate analyze"),
            ("solve", LIBRARY / "gear" / "helical.toml", "cognate analyze"),
            ("analyze", LIBRARY / "gear-pair" / "helical.toml", "cognate solve"),
            ("analyze", self.problem, "cognate solve"),
            ("solve", LIBRARY / "study" / "cam-size.toml", "cognate sweep"),
            ("analyze", LIBRARY / "study" / "cam-size.toml", "cognate sweep"),
        ]:
            with self.subTest(command):
                done = run(command, file, cwd=self.folder)
                self.expect_one_line_refusal(done, f"{file}:", other)
                self.assertEqual(list(self.folder.iterdir()), [])

    def test_list(self):
        text = run("list")
        self.assertEqual((text.returncode, text.stderr), (0, ""))
        for name in ("function-generation", "analysis", "four-bar", "slsqp", "designs"):
            self.assertIn(name, text.stdout)
        for key in ("fixed_pivots", "second_line_deg", "RPP", "slot_deg", "between", "steps"):
            self.assertIn(key, text.stdout)
        self.assertIn("transmission_angle_deg.min", run("list", "--metrics").stdout)
        document = json.loads(run("list", "--json").stdout)
        self.assertIn("ipopt", [solver["name"] for solver in document["solvers"]])
        self.assertEqual(len(document["mechanisms"]), 10)
        for mechanism in document["mechanisms"]:
            self.assertTrue(mechanism["keys"], mechanism)
        metrics = json.loads(run("list", "--metrics", "--json").stdout)["metrics"]
        for metric in metrics:
            wants_degrees = "_deg" in metric["key"]
            self.assertEqual(metric["unit"] == "deg", wants_degrees, metric)

    def test_list_names_every_key_of_the_library(self):
        document = json.loads(run("list", "--json").stdout)
        problems = {kind["name"]: kind for kind in document["synthesis_problems"]}
        common = {
            f"{table['name'][1:-1]}.{name}"
            for table in document["common_tables"]
            for key in table["keys"]
            for name in key["name"].split(", ")
        }
        common |= {"solve." + option["name"] for option in document["solve_options"]}
        links = {f"{table}.{link}" for table in ("mechanism", "bounds")
                 for link in ("crank", "coupler", "rocker", "frame")}
        seen = 0
        for file in LIBRARY.rglob("*.toml"):
            read = tomllib.loads(file.read_text())
            if read["kind"] not in problems:
                continue
            listed = common | links | {"mechanism.type", "mechanism.pivot_d"}
            beside = {"chain": " (chains)", "chain-function": " (chains)", "dwell": " (dwells)"}
            name = read["kind"] + beside.get(file.parent.name, "")
            if name == "motion-generation" and "type" in read.get("mechanism", {}):
                name += " (chains)"
            keys = {key["name"]: key["meaning"] for key in problems[name]["keys"]}
            listed |= set(keys)
            if "bounds as of path-generation (chains)" in keys.get("mechanism.type", ""):
                chains = problems["path-generation (chains)"]["keys"]
                listed |= {key["name"] for key in chains if key["name"].startswith("bounds.")}
            for table in ("target", "mechanism", "bounds", "constraints", "solve"):
                for key in read.get(table, {}):
                    with self.subTest(file=file.name, key=key):
                        self.assertIn(f"{table}.{key}", listed)
                        seen += 1
        self.assertGreater(seen, 300)

    def test_pages_to_draw_on_are_written_once(self):
        for flags, name, title in ((), "sketch.html", "sketch."), (("--mechanism",), "mechanism.html", "build."):
            done = run("sketch", *flags, cwd=self.folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout, f"wrote {name}; open it in a browser\n")
            page = (self.folder / name).read_text()
            self.assertTrue(page.startswith("<!doctype html>"))
            self.assertNotRegex(page, r"@(DATA|STYLE|SCRIPT|WORDS|KERNEL)@")
            self.assertIn(f'data-say="{title}', page)
            self.expect_one_line_refusal(run("sketch", *flags, cwd=self.folder), name, "is there already")
            other = run("sketch", *flags, "--json", "--out", "other-" + name, cwd=self.folder)
            self.assertEqual(json.loads(other.stdout), {"format": "cognate-sketch/1", "files": ["other-" + name]})

    def test_output_that_cannot_be_written(self):
        with open("/dev/full", "w") as full:
            done = run("list", stdout=full)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot write to standard output", done.stderr)
        closed = subprocess.run(
            ["/bin/sh", "-c", '"$0" list >&-', PROGRAM], stderr=subprocess.PIPE, text=True
        )
        self.assertEqual(closed.returncode, 2)
        self.assertIn("cannot write to standard output", closed.stderr)

    def test_a_limit_on_the_size_of_files_is_reported(self):
        done = subprocess.run(
            ["/bin/sh", "-c", 'ulimit -f 1; "$0" analyze "$1" --quiet', PROGRAM,
             LIBRARY / "analysis" / "shaper.toml"],
            cwd=self.folder, capture_output=True, text=True, timeout=120)
        self.expect_one_line_refusal(done, "cannot write", "File too large")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_time_limit_that_ends_a_table_is_reported(self):
        done = run("analyze", LIBRARY / "analysis" / "shaper.toml", "--time-limit", "1e-9", "--json",
                   cwd=self.folder)
        notes = json.loads(done.stdout)["notes"]
        self.assertIn("the time limit ended the table after 0 of 361 positions", notes)

    def test_places_that_cannot_be_written_to(self):
        file = self.folder / "file"
        file.touch()
        below = run("solve", self.problem, "--out", file / "below")
        self.expect_one_line_refusal(below, str(file / "below"), "Not a directory")
        (self.folder / "six-point-line.result.json").mkdir()
        blocked = run("solve", self.problem, cwd=self.folder)
        self.expect_one_line_refusal(blocked, "six-point-line.result.json", "Is a directory")


if __name__ == "__main__":
    PROGRAM, LIBRARY = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
