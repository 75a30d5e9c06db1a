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


class Readme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        text = README.read_text(encoding="utf-8")
        self.files = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)

    def test_each_file_solves_or_analyses(self):
        self.assertGreaterEqual(len(self.files), 2)
        for number, content in enumerate(self.files):
            with self.subTest(number=number):
                file = self.folder / f"example-{number}.toml"
                file.write_text(content, encoding="utf-8")
                command = "analyze" if 'kind = "analysis"' in content else "solve"
                done = subprocess.run([PROGRAM, command, file.name], cwd=self.folder, text=True,
                                      timeout=120, capture_output=True)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    README = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
