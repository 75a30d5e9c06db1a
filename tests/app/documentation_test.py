"""README.md and docs/*.md as they are printed: links lead somewhere, every key that the program
knows stands on its page, every file is sound and does what it says, the guide's commands run.

Run as: documentation_test.py PROGRAM ROOT [CLASS...], the built program and the repository's root.
"""

import contextlib
import json
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
import tomllib
import unittest

from thinned import some

PROGRAM = ""
ROOT = pathlib.Path()

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.DOTALL | re.MULTILINE)
SAVED_AS = re.compile(r"[Ss]ave this as `([^`]+)`[^`]*```toml\n(.*?)```", re.DOTALL)

# Which page has the keys of which part of `cognate list`, where README.md does not say it: that of kinds
# that share their word with another.
PAGE_OF_KIND = {"function-generation (chains)": "chain-functions", "function-generation (dwells)": "dwells",
                "motion-generation (chains)": "motion-generation", "path-generation (chains)": "chains"}
PAGES_OF_TABLES = {"common_tables": ["constraints"], "cam_tables": ["cams"], "cam_followers": ["cams"],
                   "gear_tables": ["gears"], "gear_pair_tables": ["gears"],
                   "gear_train_tables": ["gear-trains"],
                   "machine_tables": ["machines"], "mechanisms": ["analysis"], "dyads": ["analysis"],
                   "analysis_tables": ["analysis"],
                   "study_tables": ["studies"]}
# What stands for something else.
NO_KEY = {"METRIC or KEY", "DIMENSION", "[crank] or [slider]"}


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def text_of(page):
    return page.read_text(encoding="utf-8")


def without_blocks(text):
    return BLOCK.sub("", text)


def anchors_of(page):
    """The anchors that GitHub gives a page's headings."""
    anchors = set()
    for heading in re.findall(r"^#+ +(.*)$", without_blocks(text_of(page)), re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").strip().lower()
        anchors.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return anchors


def command_for(content):
    tables = tomllib.loads(content)
    if "base" in tables:
        return ["sweep"]
    if tables["kind"] in ("analysis", "gear", "machine"):
        return ["analyze"]
    return ["solve", "--time-limit", "3"]  # that a file runs is shown, not how good its answer is


def run(folder, *words):
    return subprocess.run([PROGRAM, *words], text=True, cwd=folder, timeout=240, capture_output=True,
                          check=False)


class Links(unittest.TestCase):
    def test_each_leads_somewhere(self):
        count = 0
        for page in pages():
            for target in re.findall(r"\]\(([^)\s]+)\)", without_blocks(text_of(page))):
                if "://" in target:
                    continue
                with self.subTest(page=page.name, target=target):
                    count += 1
                    path, _, anchor = target.partition("#")
                    file = (page.parent / path).resolve() if path else page
                    self.assertTrue(file.exists(), "no such file")
                    if anchor:
                        self.assertIn(anchor, anchors_of(file))
        self.assertGreater(count, 50)

    def test_worked_files_are_there(self):
        """Names in code under that heading, but for endings (`-2`) and groups (`logarithm-…`)."""
        count = 0
        for page in pages():
            section = re.search(r"^## Worked files\n(.*?)(^## |\Z)", text_of(page), re.DOTALL | re.MULTILINE)
            if not section:
                continue
            folder = page.parent / re.search(r"\]\((\.\./problems/library/[^)]*)\)", section[1])[1]
            for name in re.findall(r"`([a-z][a-z0-9-]*)`", section[1]):
                with self.subTest(page=page.name, name=name):
                    count += 1
                    self.assertTrue((folder / f"{name}.toml").exists(), "no such worked file")
        self.assertGreater(count, 60)

    def test_each_page_is_in_the_index(self):
        index = text_of(ROOT / "docs" / "README.md")
        self.assertGreater(len(pages()), 15)
        for page in (ROOT / "docs").glob("*.md"):
            if page.name != "README.md":
                self.assertIn(f"({page.name})", index)

    def test_each_picture_is_shown(self):
        shown = "".join(text_of(page) for page in pages())
        pictures = list((ROOT / "docs" / "pictures").iterdir())
        self.assertGreater(len(pictures), 5)
        for picture in pictures:
            self.assertIn(f"pictures/{picture.name}", shown)


class Keys(unittest.TestCase):
    def setUp(self):
        self.catalogue = json.loads(run(ROOT, "list", "--json").stdout)

    def expect(self, page, names):
        """Every name stands in code on the page; `a, b` are two, `target.a` is a. How many were
        looked for."""
        count = 0
        text = text_of(ROOT / "docs" / f"{page}.md")
        code = "\n".join(re.findall(r"```.*?```|`[^`\n]+`", text, re.DOTALL))
        for listed in names:
            if listed in NO_KEY:
                continue
            for name in re.split(r", ", listed):
                key = name.rpartition(".")[2].strip("[]")
                count += 1
                with self.subTest(page=page, key=name):
                    found = re.search(rf"(?<![\w-]){re.escape(key)}(?![\w-])", code)
                    self.assertTrue(found, "is on no such page, or not in code")
        return count

    def page_of(self, kind):
        """The first to which README.md leads from its word."""
        return PAGE_OF_KIND.get(kind) or re.search(rf"\[`{kind}`\]\(docs/([\w-]+)\.md\)", text_of(ROOT / "README.md"))[1]

    def test_keys_of_each_kind_are_on_its_page(self):
        counts = [self.expect(self.page_of(kind["name"]), [key["name"] for key in kind["keys"]])
                  for kind in self.catalogue["synthesis_problems"]]
        self.assertGreater(min(counts), 0)
        self.assertGreater(sum(counts), 50)

    def test_keys_of_tables_are_on_their_pages(self):
        for part, its_pages in PAGES_OF_TABLES.items():
            count = sum(self.expect(page, [key["name"] for key in table["keys"]])
                        for table in self.catalogue[part] for page in its_pages)
            self.assertGreater(count, 0, part)

    def test_options_of_solve_and_names(self):
        names = lambda part: [entry["name"] for entry in self.catalogue[part]]
        self.expect("constraints", names("solve_options"))
        self.expect("studies", names("samplings"))
        self.expect("cams", names("motion_laws") + names("cam_followers"))
        self.expect("analysis", names("mechanisms") + names("dyads"))


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_each_file_runs(self):
        seen = set()
        ran = 0
        for page in some(pages()):
            text = text_of(page)
            files_of_commands = {content for _, content in SAVED_AS.findall(text)}
            for language, content in BLOCK.findall(text):
                if language != "toml" or content in seen or content in files_of_commands:
                    continue
                seen.add(content)
                tables = tomllib.loads(content)  # a fragment is TOML too
                if "kind" not in tables and "base" not in tables:
                    continue
                with self.subTest(page=page.name, begins=content[:60]):
                    file = self.folder / f"example-{len(seen)}.toml"
                    # The base of a study is given as seen from its page.
                    placed = re.sub('^base = "', f'base = "{page.parent}/', content, flags=re.MULTILINE)
                    file.write_text(placed, encoding="utf-8")
                    done = run(self.folder, *command_for(content), file.name, "--json")
                    if json.loads(done.stdout)["status"] != "time-limit":
                        self.assertEqual(done.returncode, 0, done.stderr)
                    ran += 1
        self.assertGreaterEqual(len(seen), 10)
        self.assertGreaterEqual(ran, 8)

    def test_the_guide_from_end_to_end(self):
        text = text_of(ROOT / "docs" / "guide.md")
        for name, content in SAVED_AS.findall(text):
            (self.folder / name).write_text(content, encoding="utf-8")
        commands = 0
        for language, block in BLOCK.findall(text):
            for line in block.splitlines() if language == "sh" else []:
                if not line.startswith("cognate "):
                    continue
                words, _, remark = line.partition("#")
                wanted = re.search(r"exit status (\d)", remark)
                with self.subTest(line=line):
                    commands += 1
                    done = run(self.folder, *words.split()[1:])
                    self.assertEqual(done.returncode, int(wanted[1]) if wanted else 0, done.stderr)
        self.assertGreaterEqual(commands, 10)
        # A front by the torque's magnitude is a choice, not a pair of ends.
        with contextlib.closing(sqlite3.connect(self.folder / "sizes.study.db")) as database:
            front = database.execute("SELECT * FROM best").fetchall()
            self.assertGreater(len(front), 2)
        for left in ["walk.report.html", "arm.csv", "feed.dxf", "walk-2.parts.dxf", "sizes.273.toml"]:
            self.assertTrue((self.folder / left).exists(), left)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    ROOT = pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
