#!/usr/bin/env python3
"""Compares what two builds of the program say of every library file, byte for byte.

    golden.py BEFORE AFTER [--library FOLDER] [--only WORD] [--seed N]

BEFORE is a program, or a commit: that is built in a folder of its own first. Compared are
`list --json`, `check --json` of every file, and `solve`, `analyze` or `sweep` with the seed, without
times. A difference is printed as the places where the documents differ. Exit status: 0 all the same,
1 some differ, 2 wrong usage.

For a change of the code's structure, which must not change a figure. Nothing is stored: the program
before the change is the reference.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_SHOWN = 12
COMMANDS = {"analysis": "analyze", "gear": "analyze", "machine": "analyze", "study": "check"}


def built(revision, folder):
    """The program of a commit, built in `folder`."""
    for command in (
        ["git", "clone", "--quiet", "--shared", "--no-checkout", ROOT, folder],
        ["git", "-C", folder, "checkout", "--quiet", "--detach", revision],
        ["cmake", "--preset", "release", "-DBUILD_TESTING=OFF", "-S", folder],
        ["cmake", "--build", folder / "build/release", "--target", "cognate"],
    ):
        subprocess.run(command, cwd=folder.parent, check=True, stdout=subprocess.DEVNULL)
    return folder / "build/release/app/cognate"


def kind_of(file):
    named = re.search(r'^kind\s*=\s*"([^"]*)"', file.read_text(), re.MULTILINE)
    return named.group(1) if named else ""


def calls(library, word):
    """The calls to compare, the files relative to the library."""
    yield ["list"]
    for file in sorted(library.rglob("*.toml")):
        name = str(file.relative_to(library))
        if word not in name:
            continue
        yield ["check", name]
        command = COMMANDS.get(kind_of(file), "solve")
        if command != "check":
            yield [command, name]


def without_times(value):
    """The document without what differs from run to run."""
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k != "seconds"}
    if isinstance(value, list):
        return [without_times(v) for v in value]
    return value


def answer(program, call, library, seed):
    """Exit status, standard error and document of one call."""
    with tempfile.TemporaryDirectory() as out:
        options = ["--json", "--seed", str(seed), "--threads", "2"]
        if call[0] in ("solve", "analyze"):
            options += ["--out", out, "--quiet"]
        done = subprocess.run(
            [program, *call, *options], cwd=library, text=True, capture_output=True, timeout=3600
        )
    try:
        document = without_times(json.loads(done.stdout))
    except json.JSONDecodeError:
        document = done.stdout
    return {"exit": done.returncode, "stderr": done.stderr, "document": document}


def differences(a, b, place=""):
    """The places where two documents differ, with both values."""
    if isinstance(a, dict) and isinstance(b, dict):
        if list(a) != list(b):
            yield f"{place}: keys {sorted(set(a) ^ set(b)) or 'in another order'}"
        for key in a.keys() & b.keys():
            yield from differences(a[key], b[key], f"{place}.{key}")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for i, (x, y) in enumerate(zip(a, b)):
            yield from differences(x, y, f"{place}[{i}]")
    elif json.dumps(a) != json.dumps(b):
        yield f"{place}: {str(a)[:100]} -> {str(b)[:100]}"


def compare(before, after, library, word, seed):
    """Prints what differs; the numbers of calls compared and of those that differ."""
    compared = differing = 0
    for call in calls(library, word):
        found = sorted(differences(*(answer(p, call, library, seed) for p in (before, after))))
        compared += 1
        if not found:
            continue
        differing += 1
        print(f"cognate {' '.join(call)}: {len(found)} differences")
        for line in found[:MOST_SHOWN]:
            print(f"    {line}")
    return compared, differing


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("before")
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("--library", type=pathlib.Path, default=ROOT / "problems/library")
    parser.add_argument("--only", default="", help="files whose names contain this")
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        before = pathlib.Path(asked.before)
        if not before.is_file():
            before = built(asked.before, pathlib.Path(folder) / "before")
        compared, differing = compare(
            before.resolve(), asked.after.resolve(), asked.library, asked.only, asked.seed
        )
    print(f"{compared} calls compared, {differing} differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
