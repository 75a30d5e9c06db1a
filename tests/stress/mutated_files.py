"""For any file, a command ends with an answer or with what is wrong and where.

Run as: mutated_files.py PROGRAM LIBRARY [--count N] [--seed N] [--keep DIR] [--only WORD] [--slack S]

Takes files of the library, changes one to three things in each (numbers to extremes, lines deleted,
doubled and exchanged, sections exchanged, words of another file, nested arrays, cut ends) and runs
`check`, then the command of the file's kind with files written, then an export. --count 0 takes the
files as they are, each with every format of export. It is a fault if a command

- ends by a signal, or with another exit status than documented,
- refuses a file without a line `FILE:LINE:COLUMN: what is wrong; what is allowed` for each fault,
- passes `check` and is then refused without such a line,
- writes a document that is not JSON, or a NaN or an infinity into a document, table or drawing,
- has a line of a sanitizer in its output, or hangs for two minutes,
- takes more processor time than its limit and --slack seconds (0, the default: not looked at).

Prints every fault with the file that shows it (kept in --keep) and the counts; ends with status 1 if
there was a fault.
"""

import argparse
import collections
import json
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

NUMBER = re.compile(r"(?<![\w.\"-])-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?(?![\w.\"])")
STRING = re.compile(r'"[^"\n]*"')
EXTREMES = ["0", "-1", "1e-300", "1e300", "nan", "inf", "-inf", "-0.0", "1e-9", "1e9", "1e17", "5e-324",
            "1.7976931348623157e308", "9223372036854775807", "1", "2", "0.5", "90", "180", "360", "1e5"]
TOKENS = ["[]", "[[]]", "{}", "true", '""', "[1, [2]]", "1979-05-27", "'\\u0000'", '"\\u0000"', '"x"', "[nan, 1]"]
FAULT = re.compile(r"^[^\n]*?:\d+:\d+: .+; .+$")
SANITIZER = re.compile(r"Sanitizer|runtime error|Assertion|terminate called")
NOT_FINITE = re.compile(r"(?<![\w.])[-+]?(?:nan|inf|infinity)(?![\w.])", re.IGNORECASE)
FORMATS = ["dxf", "svg", "csv", "json", "dot"]
PARTS = ["--parts", "--hole", "0.1", "--width", "0.3"]
CUTS = ["--kerf", "0.02", "--labels", "stroke", "--sheet", "40x40", "--thickness", "0.1", "--spacers"]
COMMANDS = {"analysis": "analyze", "machine": "analyze", "gear": "analyze", "gear-pair": "solve", "study": "sweep"}
HANG = 120


def changed_number(rng, text):
    numbers = list(NUMBER.finditer(text))
    if not numbers:
        return text
    place = rng.choice(numbers)
    old = place.group()
    scaled = f"{float(old) * rng.choice([-1, 0.01, 0.1, 0.5, 0.9, 1.1, 2, 10, 100]):.17g}"
    return text[: place.start()] + rng.choice([scaled, rng.choice(EXTREMES)]) + text[place.end() :]


def changed_token(rng, text):
    places = list(NUMBER.finditer(text)) + list(STRING.finditer(text))
    if not places:
        return text
    place = rng.choice(places)
    return text[: place.start()] + rng.choice(TOKENS) + text[place.end() :]


def changed_word(rng, text, words):
    places = list(STRING.finditer(text))
    if not places:
        return text
    place = rng.choice(places)
    return text[: place.start()] + rng.choice(words) + text[place.end() :]


def changed_lines(rng, text):
    lines = text.split("\n")
    here, there = rng.randrange(len(lines)), rng.randrange(len(lines))
    change = rng.randrange(4)
    if change == 0:
        del lines[here]
    elif change == 1:
        lines.insert(there, lines[here])
    elif change == 2:
        lines[here], lines[there] = lines[there], lines[here]
    else:
        lines = lines[:here]
    return "\n".join(lines)


def changed_sections(rng, text):
    """Sections put in another order, one left out or doubled."""
    sections = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    if len(sections) < 2:
        return text
    here, there = rng.randrange(1, len(sections)), rng.randrange(1, len(sections))
    change = rng.randrange(3)
    if change == 0:
        sections[here], sections[there] = sections[there], sections[here]
    elif change == 1:
        del sections[here]
    else:
        sections.insert(there, sections[here])
    return "".join(sections)


def changed_array(rng, text):
    """An array with an entry fewer, or with one twice."""
    places = list(re.finditer(r",\s*(-?[\d.]+|\[[^\[\]]*\])(?=\s*[,\]])", text))
    if not places:
        return text
    place = rng.choice(places)
    return text[: place.start()] + place.group() * rng.choice([0, 2]) + text[place.end() :]


def mutated(rng, text, words):
    """`text` with one to three changes; titles and comments, which change nothing, are left out."""
    text = re.sub(r"^(title\b|#).*\n", "", text, flags=re.MULTILINE)
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        change = rng.randrange(10)
        if change < 4:
            text = changed_number(rng, text)
        elif change == 4:
            text = changed_token(rng, text)
        elif change == 5:
            text = changed_word(rng, text, words)
        elif change == 6:
            text = changed_lines(rng, text)
        elif change == 7:
            text = changed_sections(rng, text)
        elif change == 8:
            text = changed_array(rng, text)
        else:
            text = changed_number(rng, changed_number(rng, text))
    return text


def refuse_constant(name):
    raise ValueError(f"{name} in a document")


class Runner:
    """Runs commands in a copy of the library and collects what is wrong."""

    def __init__(self, program, folder, limit, slack):
        self.program, self.folder, self.limit, self.slack = program, folder, limit, slack
        self.counts = collections.Counter()
        self.faults = []
        self.longest = 0.0

    def fault(self, command, what):
        self.faults.append(f"{' '.join(map(str, command))}: {what}")

    def run(self, *arguments, statuses):
        """The exit status and standard output; None as status where a fault was noted."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            ended = subprocess.run([self.program, *map(str, arguments)], cwd=self.folder,
                                   capture_output=True, timeout=HANG, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            self.fault(arguments, f"still running after {HANG} s")
            return None, ""
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        output = ended.stdout.decode(errors="replace")
        errors = ended.stderr.decode(errors="replace")
        self.counts[f"{arguments[0]} {ended.returncode}"] += 1
        self.longest = max(self.longest, used)
        if SANITIZER.search(errors):
            self.fault(arguments, errors[:3000])
        elif ended.returncode not in statuses:
            self.fault(arguments, f"status {ended.returncode}: {errors[:500]}")
        elif ended.returncode == 2 and not self.is_clear(errors, arguments[0]):
            self.fault(arguments, f"unclear message: {errors[:500]}")
        elif self.slack and used > self.limit + self.slack:
            self.fault(arguments, f"{used:.1f} s of processor time")
        else:
            return ended.returncode, output
        return None, output

    def is_clear(self, errors, command):
        """Whether every line is a fault at its place; an export may say what it lacks in words."""
        lines = [line for line in errors.splitlines() if line.strip()]
        if command == "export":
            return bool(lines) and all("; " in line for line in lines)
        return bool(lines) and all(FAULT.match(line) or line.startswith("  ") for line in lines)

    def document(self, command, text):
        try:
            return json.loads(text, parse_constant=refuse_constant)
        except ValueError as error:
            self.fault(command, f"no JSON: {error}: {text[:200]}")
            return None

    def written(self, command, folder):
        """Looks at the files that a command wrote; returns the result, if there is one."""
        result = None
        for file in sorted(folder.iterdir()):
            if file.suffix == ".db" or not file.is_file():
                continue
            text = file.read_text(errors="replace")
            self.counts[f"files {file.suffix}"] += 1
            if file.suffix == ".html":
                found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
                self.document(command, found.group(1) if found else "")
            elif file.suffix == ".json":
                self.document(command, text)
                result = file if file.name.endswith(".result.json") else result
            elif NOT_FINITE.search(re.sub(r'"[^"]*"|\(.*?\)', "", text)):
                self.fault(command, f"not a number in {file.name}")
        return result

    def export(self, result, row, options):
        out = self.folder / "exported"
        command = ["export", result, *options, "--out", out, *row]
        status, _ = self.run(*command, statuses=(0, 2))
        if status == 0:
            self.written(command, out)
        shutil.rmtree(out, ignore_errors=True)

    def exports(self, out, result, rng):
        chosen = [["--format", name] for name in FORMATS]
        for name in ("dxf", "svg", "json"):
            chosen += [["--format", name, *options] for options in (PARTS, PARTS + CUTS, ["--kerf", "0.02", "--bore", "0.2"])]
        source = result or next(out.glob("*.study.db"), None)
        if source is None:
            return
        row = [] if result else ["--row", "1"]
        for options in [rng.choice(chosen)] if rng else chosen:
            self.export(source, row, options)

    def file(self, path, rng):
        """All commands for one file; returns whether it was a sound one."""
        status, _ = self.run("check", path, statuses=(0, 2))
        if status != 0:
            return False
        kind = re.search(r'^\s*kind\s*=\s*["\'](.*?)["\']', path.read_text(errors="replace"), re.MULTILINE)
        kind = kind.group(1) if kind else ("study" if "[[vary]]" in path.read_text() else "")
        out = self.folder / "out"
        command = [COMMANDS.get(kind, "solve"), path, "--json", "--threads", "1", "--time-limit", self.limit,
                   "--out", out]
        status, text = self.run(*command, statuses=(0, 1, 2))
        if status in (0, 1):
            self.document(command, text)
            self.exports(out, self.written(command, out), rng)
        shutil.rmtree(out, ignore_errors=True)
        return True


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--limit", type=float, default=0.5, help="seconds each command is given")
    parser.add_argument("--slack", type=float, default=0, help="processor seconds above the limit")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files that show faults")
    parser.add_argument("--only", default="", help="files whose path holds this word")
    return parser.parse_args()


def main():
    given = arguments()
    rng = random.Random(given.seed)
    sound = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "library"
        shutil.copytree(given.library, folder)
        texts = {path: path.read_text() for path in sorted(folder.rglob("*.toml"))}
        words = sorted({word for text in texts.values() for word in STRING.findall(text)})
        chosen = [path for path in texts if given.only in str(path.relative_to(folder))]
        runner = Runner(str(pathlib.Path(given.program).absolute()), folder, given.limit, given.slack)
        for number in range(given.count or len(chosen)):
            path = rng.choice(chosen) if given.count else chosen[number]
            if given.count:
                text = mutated(rng, texts[path], words)
                path = path.with_name(f"mutated-{number}.toml")
                path.write_text(text)
            before = len(runner.faults)
            sound += runner.file(path, rng if given.count else None)
            for fault in runner.faults[before:]:
                print(f"{path.relative_to(folder)}: {fault}", flush=True)
            if given.keep and len(runner.faults) > before:
                given.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, given.keep / f"{path.parent.name}-{path.name}")
            if given.count:
                path.unlink()
    for what, count in sorted(runner.counts.items()):
        print(f"{what}: {count}")
    tested = given.count or len(chosen)
    print(f"{tested} files, {sound} of them sound, {len(runner.faults)} faults, "
          f"longest command {runner.longest:.2f} s of processor time")
    return 1 if runner.faults or not tested or not sound else 0


if __name__ == "__main__":
    sys.exit(main())
