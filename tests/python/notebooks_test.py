"""The notebooks of the documentation are executed, and hold no outputs.

Run as: notebooks_test.py NOTEBOOKS, with the module on PYTHONPATH.
"""

import pathlib
import sys
import tempfile
import unittest

NOTEBOOKS = pathlib.Path()


class NotebooksTest(unittest.TestCase):
    def test_each_runs(self):
        import nbformat
        from nbconvert.preprocessors import ExecutePreprocessor

        found = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(found), 2)
        for file in found:
            with self.subTest(file.name), tempfile.TemporaryDirectory() as folder:
                notebook = nbformat.read(file, as_version=4)
                codes = [cell for cell in notebook.cells if cell.cell_type == "code"]
                self.assertFalse(any(cell.outputs for cell in codes), "outputs are not committed")
                ExecutePreprocessor(timeout=120, kernel_name="python3").preprocess(
                    notebook, {"metadata": {"path": folder}})
                shown = [output.get("data", {}) for cell in codes for output in cell.outputs]
                pages = [data["text/html"] for data in shown if "text/html" in data]
                self.assertTrue(any("<animate " in page for page in pages), "nothing moves")

    def test_the_first_is_short(self):
        """From a first problem to a study in twelve statements."""
        import ast

        import nbformat

        notebook = nbformat.read(NOTEBOOKS / "first.ipynb", as_version=4)
        code = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "code")
        self.assertLessEqual(len(ast.parse(code).body), 12)


if __name__ == "__main__":
    NOTEBOOKS = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
