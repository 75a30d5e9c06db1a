"""What the program, the first argument of a test, says of problem files that the test writes."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])


def command(text, *arguments):
    """Runs a command on a file with this text."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "problem.toml"
        file.write_text(text)
        return subprocess.run([PROGRAM, *arguments[:1], file, *arguments[1:]], capture_output=True,
                              text=True, timeout=600)


def solved(text, how="solve"):
    """The result of a sound file, whether feasible or not."""
    done = command(text, how, "--json", "--quiet")
    if done.returncode not in (0, 1):
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


def analysed(result):
    """The metrics of the analysis of the first design, exported as a file for it."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "found.result.json"
        path.write_text(json.dumps(result), encoding="utf-8")
        written = subprocess.run([PROGRAM, "--json", "export", path, "--format", "toml", "--out", folder],
                                 capture_output=True, text=True, check=True)
        (file,) = json.loads(written.stdout)["files"]
        done = subprocess.run([PROGRAM, "--quiet", "--json", "analyze", file], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)["designs"][0]["metrics"]
