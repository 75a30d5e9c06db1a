"""The program at a terminal: help, completion, the manual page, tables, the bar, and mistakes.

Run as: terminal_test.py PROGRAM LIBRARY, the built program and the folder of library problems.
"""

import fcntl
import functools
import os
import pathlib
import pty
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unicodedata
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()
COMMANDS = ("new", "solve", "analyze", "sweep", "export", "sketch", "studio", "involute", "check", "list")
ENDLESS = """kind = "path-generation"
title = "没有尽头的搜索"
[target]
points = [[0, 0], [1, 0.3], [2, 0.1], [3, 1], [2, 2], [1, 1.5], [0.5, 1]]
[constraints]
class = "crank-rocker"
peak_acceleration_max = 1
[solve]
starts = 10000
"""


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=120,
                          capture_output=True, **options)


@functools.cache
def completion(shell):
    return run("completion", shell).stdout


class Terminal:
    """The program with a terminal of `columns` for its input, output and errors."""

    def __init__(self, *arguments, columns=80, cwd=None, **environment):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(cwd or ".")
            fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
            known = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
            os.execve(PROGRAM, [PROGRAM, *map(str, arguments)],
                      {**known, "TERM": "xterm", **environment})
        self.written = ""

    def read_until(self, pattern):
        """Reads on until `pattern` has been written."""
        ends = time.monotonic() + 60
        while not re.search(pattern, self.written) and time.monotonic() < ends:
            self.written += os.read(self.terminal, 4096).decode()
        return self.written

    def read(self):
        """All that is written until the program ends."""
        try:
            while part := os.read(self.terminal, 1 << 16):
                self.written += part.decode(errors="replace")
        except OSError:  # Linux's way to say that the other side is closed
            pass
        os.close(self.terminal)
        self.status = os.waitstatus_to_exitcode(os.waitpid(self.process, 0)[1])
        return self.written


def shown(text):
    """The lines that stand on the terminal in the end: without colours and what was wiped."""
    text = re.sub(r"\x1b\[[0-9]*m", "", text).replace("\r\n", "\n")
    return re.sub(r"[^\n]*\r\x1b\[K", "", text).split("\n")


def columns_of(line):
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in line)


class AtTheTerminal(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.problem = LIBRARY / "path" / "six-point-line.toml"

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text)
        return file

    # Help, completion, the manual page

    def test_help_fits_and_has_an_example_of_each_command(self):
        for arguments in ([], *([command] for command in (*COMMANDS, "completion", "manual"))):
            with self.subTest(arguments):
                text = run(*arguments, "--help").stdout
                for line in text.splitlines():
                    self.assertLessEqual(len(line), 80, line)
                self.assertRegex(text, r"Examples?:\n(.*\n)*? +.*cognate " + "".join(arguments))

    def complete(self, *words):
        """What bash offers for the last of `words`."""
        script = completion("bash")
        quoted = " ".join("'" + word + "'" for word in words)
        script += f"COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}\n"
        script += '_cognate 2>&1; printf "%s\\n" "${COMPREPLY[@]}"\n'
        done = subprocess.run(["bash", "--norc", "-c", script], cwd=self.folder, text=True,
                              capture_output=True)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split("\n")) - {""}

    def test_bash_completes(self):
        for name in ("a.toml", "b file.toml", "c.result.json", "d.study.db", "d.study.h5", "e.txt"):
            self.write(name, "")
        (self.folder / "folder").mkdir()
        problems = {"a.toml", "b file.toml", "folder"}
        for words, offered in [
            (["cognate", ""], {*COMMANDS, "completion", "manual"}),
            (["cognate", "completion", ""], {"bash", "zsh", "fish"}),
            (["cognate", "completion", "f"], {"fish"}),
            (["cognate", "completion", "--"], {"--help"}),
            (["cognate", "manual", ""], set()),
            (["cognate", "s"], {"solve", "sweep", "sketch", "studio"}),
            (["cognate", "--ver"], {"--version"}),
            (["cognate", "solve", ""], problems),
            (["cognate", "solve", "b"], {"b file.toml"}),
            (["cognate", "--seed", "1", "check", ""], {*problems, "c.result.json"}),
            (["cognate", "export", ""], {"c.result.json", "d.study.db", "d.study.h5", "folder"}),
            (["cognate", "sweep", "a.toml", "--merge", ""], {"d.study.db", "d.study.h5", "folder"}),
            (["cognate", "solve", "--t"], {"--threads", "--time-limit"}),
            (["cognate", "list", "--m"], {"--metrics"}),
            (["cognate", "solve", "--m"], set()),
            (["cognate", "solve", "--out", ""], {"folder"}),
            (["cognate", "solve", "--out", "=", "f"], {"folder"}),
            (["cognate", "solve", "--seed", ""], set()),
            (["cognate", "export", "c.result.json", "--curve", ""],
             {"profile", "pitch", "cutter"}),
            (["cognate", "export", "--curve", "=", "c"], {"cutter"}),
            (["cognate", "list", "g"], {"gear", "gear-pair", "gear-train"}),
            (["cognate", "new", "m"], {"machine", "motion-generation"}),
            (["cognate", "analyze", "c"], {"c.result.json"}),
        ]:
            with self.subTest(words):
                self.assertEqual(self.complete(*words), offered)
        self.assertLessEqual({"dxf", "svg", "csv"},
                             self.complete("cognate", "export", "--format", ""))

    def test_completion_knows_every_option_that_help_knows(self):
        scripts = {shell: completion(shell) for shell in ("bash", "zsh", "fish")}
        for command in COMMANDS:
            offered = self.complete("cognate", command, "--")
            for option in re.findall(r"^  (?:-h,)?--([\w-]+)", run(command, "--help").stdout, re.M):
                with self.subTest(command=command, option=option):
                    self.assertIn("--" + option, offered)
                    self.assertIn("--" + option, scripts["zsh"])
                    self.assertIn(f"__fish_seen_subcommand_from {command}' ", scripts["fish"])
                    self.assertIn(f"-l {option} ", scripts["fish"])

    def test_each_shell_can_read_its_script(self):
        for shell in ("bash", "zsh", "fish"):
            done = run("completion", shell)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            if shutil.which(shell):
                read = subprocess.run([shell, "-n", "/dev/stdin"], input=done.stdout, text=True,
                                      capture_output=True)
                self.assertEqual((read.returncode, read.stderr), (0, ""), shell)
        refused = run("completion", "csh")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("bash, zsh or fish", refused.stderr)

    def test_the_manual_page_is_sound_and_whole(self):
        page = run("manual").stdout
        self.assertTrue(page.isascii())
        plain = page.replace("\\-", "-")
        for command in COMMANDS:
            self.assertIn(f".SS cognate {command}", plain)
            for option in re.findall(r"--[a-z-]+", run(command, "--help").stdout):
                self.assertIn(option, plain)
        if not shutil.which("groff"):
            self.skipTest("groff is missing")
        set_ = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-rLL=80n"], input=page, text=True,
                              capture_output=True)
        self.assertEqual((set_.returncode, set_.stderr), (0, ""))
        text = re.sub(r".\x08|\x1b\[[0-9;]*m", "", set_.stdout)
        for part in ("cognate solve rocker.toml --out results", "SYNOPSIS", "Exit status:",
                     "cognate list --metrics"):
            self.assertIn(part, text)
        common = text[text.index("Every command takes"):text.index("Without a command")]
        for option in re.findall(r"--[a-z-]+", common):
            for command in COMMANDS:
                self.assertIn(option, run(command, "--help").stdout)
        self.assertIn("--version", text)

    # Tables and progress

    def test_nothing_is_wider_than_the_terminal(self):
        title = "六个点，在一条直线上"
        chinese = self.write("chinese.toml", self.problem.read_text().replace(
            "Six points on a line", title))
        for command, file in [
            ("solve", chinese),
            ("solve", LIBRARY / "path" / "five-points-given-pivots.toml"),
            ("solve", LIBRARY / "cam" / "translating-roller.toml"),
            ("analyze", LIBRARY / "analysis" / "four-bar-forces.toml"),
            ("solve", LIBRARY / "quick-return" / "slider-crank-best.toml"),
        ]:
            for columns in (60, 80, 120):
                with self.subTest(file=file.name, columns=columns):
                    terminal = Terminal(command, file, columns=columns, cwd=self.folder)
                    lines = shown(terminal.read())
                    self.assertEqual(terminal.status, 0)
                    for line in lines:
                        self.assertLessEqual(columns_of(line), columns, line)
                    whole = run(command, file, cwd=self.folder).stdout
                    heads = set(re.findall(r"\[[^]]*\]", whole)) if command == "solve" else set()
                    self.assertLessEqual(heads, set(re.findall(r"\[[^]]*\]", "\n".join(lines))))
        self.assertIn(title, run("solve", chinese, cwd=self.folder).stdout)

    def test_colours_are_for_terminals_that_want_them(self):
        colour = "\x1b[32msolved"
        mechanism = LIBRARY / "analysis" / "shaper.toml"
        for environment, wanted in [({}, True), ({"NO_COLOR": "1"}, False), ({"TERM": "dumb"}, False)]:
            with self.subTest(environment):
                text = Terminal("analyze", mechanism, cwd=self.folder, **environment).read()
                self.assertEqual(colour in text, wanted)
        self.assertNotIn("\x1b", run("analyze", mechanism, cwd=self.folder).stdout)

    def test_the_bar_shows_rate_and_time_left_and_is_wiped(self):
        terminal = Terminal("solve", self.write("endless.toml", ENDLESS), cwd=self.folder)
        bar = terminal.read_until(r"\] +\d+ %  search, \d+:\d\d left, [0-9.]+ %/s")
        self.assertIn("\r\x1b[K[", bar)
        os.kill(terminal.process, signal.SIGINT)
        lines = shown(terminal.read())
        self.assertEqual(lines[0], "cognate: interrupted; what was found until then is reported")
        self.assertNotIn("left, ", "\n".join(lines))

    def test_a_terminal_that_is_stopped_does_not_stop_the_run(self):
        terminal = Terminal("solve", self.write("endless.toml", ENDLESS), "--time-limit", "2",
                            cwd=self.folder)
        terminal.read_until(r"left, ")
        os.write(terminal.terminal, b"\x13")  # Ctrl-S
        result = self.folder / "endless.result.json"
        ends = time.monotonic() + 60
        while not result.exists() and time.monotonic() < ends:
            time.sleep(0.05)
        written = result.exists()
        os.write(terminal.terminal, b"\x11")  # Ctrl-Q
        self.assertIn("wrote ", terminal.read())
        self.assertTrue(written)

    def test_the_second_interrupt_leaves_a_clean_line(self):
        terminal = Terminal("solve", self.write("endless.toml", ENDLESS), cwd=self.folder)
        terminal.read_until(r"left, ")
        os.kill(terminal.process, signal.SIGINT)
        os.kill(terminal.process, signal.SIGINT)
        text = terminal.read()
        self.assertIn(terminal.status, (-signal.SIGINT, 0, 1))
        if terminal.status == -signal.SIGINT:
            self.assertEqual(text[text.rfind("\r\x1b[K"):], "\r\x1b[K")

    # Mistakes

    def test_first_mistakes_are_reported_with_what_to_do(self):
        def solved(*arguments):
            return ("solve", self.problem, *arguments)

        result = self.write("line.result.json", '{"format": "cognate-result/1"}')
        page = self.write("page.html", "<!doctype html>")
        self.write("line.toml", self.problem.read_text())
        unquoted = self.write("unquoted.toml", "kind = path-generation\n")
        open_bracket = self.write("open.toml", 'kind = "cam"\n[target]\npoints = [[0, 1]\n')
        text = self.write("text.toml", '[target]\nkind = "cam\n')
        binary = self.write("a.study.db", "SQLite format 3\0")
        for arguments, part in [
            (["sovle", "line.toml"], "did you mean solve"),
            (["line.toml"], "'cognate solve line.toml'"),
            (["help"], "--help"),
            (["solve"], "FILE is required"),
            (["solve", "line"], "line.toml is there"),
            (["solve", "missing.toml"], "does not exist"),
            (["solve", self.folder], "directory"),
            (["solve", result], "a result of Cognate; 'cognate export'"),
            (["solve", page], "HTML"),
            (["solve", binary], "not text"),
            (["solve", unquoted], "quotes"),
            (["solve", open_bracket], "bracket"),
            (["solve", text], "quotes"),
            (["export", "line.toml", "--format", "dxf"], "'cognate solve"),
            (["export", page, "--format", "dxf"], "expected a cognate-result/1"),
            (["export", result], "--format"),
            (solved("--sed", "3"), "did you mean --seed"),
            (solved("--timelimit=3"), "did you mean --time-limit"),
            (solved("-o", "x"), "-o is not an option of solve"),
            (["--sed", "solve", self.problem], "did you mean --seed"),
            (solved("--seed="), "--seed needs a value"),
            (solved("--seed"), "--seed needs a value"),
            (solved("--time-limit", "3s"), "number of seconds"),
            (["list", "solvers"], "no kind of problem"),
            (["sweep", "--", "line.toml", "b"], "'b' is an unexpected argument: sweep takes one FILE"),
            (["check", "--weird.toml"], "--weird.toml is not an option of check; for a file write ./--"),
            (["export", "-weird.result.json", "--format", "dxf"], "-weird.result.json is not an option"),
            (["check", "--sed", "--", "line.toml", "b"], "did you mean --seed"),
        ]:
            with self.subTest(arguments):
                done = run(*arguments, cwd=self.folder)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn(part, done.stderr)


if __name__ == "__main__":
    PROGRAM, LIBRARY = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
