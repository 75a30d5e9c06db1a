"""The README's examples as they are printed: every file in it is sound, and does what it says.

Run as: readme_test.py PROGRAM README, the built program and the README's path.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
README = pathlib.Path()


def command_for(content):
    if content.startswith("base ="):
        return "sweep"
    return "analyze" if 'kind = "analysis"' in content else "solve"


class Readme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        text = README.read_text(encoding="utf-8")
        self.files = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)

    def test_each_file_runs(self):
        self.assertGreaterEqual(len(self.files), 2)
        for number, content in enumerate(self.files):
            with self.subTest(number=number):
                file = self.folder / f"example-{number}.toml"
                # The base of a study is given as seen from the README.
                placed = re.sub('^base = "', f'base = "{README.parent}/', content)
                file.write_text(placed, encoding="utf-8")
                done = subprocess.run([PROGRAM, command_for(content), file.name], text=True,
                                      cwd=self.folder, timeout=120, capture_output=True)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    README = pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1])
