"""`cognate check --certificate` from outside: proofs that hold, bounds that are wrong, refusals.

Run as: check_certificate_test.py PROGRAM LIBRARY, the built program and the worked problems.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
LIBRARY = pathlib.Path()

# Over few links, so that the proof is quickly done.
FEW_LINKS = """link_ratio_max = 4

[solve]
certify = true
certify_gap = 0.3
"""


class CheckCertificate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.at = pathlib.Path(cls.folder.name)
        text = (LIBRARY / "path" / "textbook-eight-points.toml").read_text()
        (cls.at / "eight.toml").write_text(text.replace('"either"', '"ccw"') + FEW_LINKS)
        cls.solved = cls.run_program("solve", "eight.toml")
        cls.document = json.loads((cls.at / "eight.result.json").read_text())

    @classmethod
    def run_program(cls, *words):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=cls.at, capture_output=True, text=True,
                              timeout=300, check=False)

    def check(self, *words, document=None, text=None):
        if text is None:
            text = json.dumps(document or self.document)
        (self.at / "changed.result.json").write_text(text)
        return self.run_program("check", "--certificate", "changed.result.json", *words)

    def changed(self, **members):
        document = json.loads(json.dumps(self.document))
        document["certificate"].update(members)
        return document

    def expect_refusal(self, what, **given):
        done = self.check(**given)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertTrue(done.stderr.startswith("changed.result.json:"), done.stderr)
        self.assertIn(what, done.stderr)

    def test_confirms_what_solve_proved(self):
        self.assertEqual(self.solved.returncode, 0, self.solved.stderr)
        done = self.check("--sample", 30)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("cover the domain", done.stdout)
        self.assertIn("30 confirmed, 0 undecided", done.stdout)
        self.assertTrue(done.stdout.endswith("\nconfirmed\n"), done.stdout)

    def test_says_the_same_as_a_document(self):
        documents = [json.loads(self.check("--sample", 20, "--json", "--seed", seed).stdout)
                     for seed in (1, 1, 2)]
        self.assertEqual(documents[0], documents[1])
        found = documents[0]["certificate"]
        self.assertEqual(documents[0]["format"], "cognate-check/1")
        self.assertTrue(documents[0]["valid"])
        self.assertEqual(found["boxes"], documents[2]["certificate"]["boxes"])
        # Each box that is divided makes two of one; the roots are the two assemblies.
        self.assertEqual(found["boxes"], 2 * found["discarded"] - 2)
        self.assertAlmostEqual(found["boxes"] / self.document["certificate"]["boxes"], 1, 2)
        self.assertEqual((found["sampled"], found["confirmed"], found["undecided"]), (20, 20, 0))

    def test_confirms_the_last_bound_of_a_run_that_time_ended(self):
        upper = self.document["certificate"]["upper_bound"]
        done = self.check("--sample", 10, document=self.changed(lower_bound=0.1 * upper, complete=False))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("the last bound that time allowed", done.stdout)
        nothing = self.check(document=self.changed(lower_bound=0, complete=False))
        self.assertEqual(nothing.returncode, 0, nothing.stdout)
        self.assertIn("a bound of 0 needs no proof", nothing.stdout)

    def test_refutes_a_bound_above_the_best_design(self):
        upper = self.document["certificate"]["upper_bound"]
        high = self.changed(lower_bound=1.02 * upper, upper_bound=1.02 * upper)
        done = self.check(document=high)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("REFUTED: a linkage has the sum of squares 0.60109453", done.stdout)
        found = json.loads(self.check("--json", document=high).stdout)
        self.assertFalse(found["valid"])
        self.assertAlmostEqual(found["certificate"]["refutation"]["error"], upper, 9)

    def test_is_not_confirmed_where_it_is_ended(self):
        done = self.check("--time-limit", "0.001")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("not confirmed", done.stdout)

    def test_refuses_what_has_no_certificate(self):
        without = json.loads(json.dumps(self.document))
        del without["certificate"]
        self.expect_refusal("has no certificate", document=without)
        self.expect_refusal("is damaged", document=self.changed(lower_bound="much"))
        self.expect_refusal("more than upper_bound", document=self.changed(lower_bound=7))
        self.expect_refusal("not valid JSON", text=json.dumps(self.document)[:1000])
        self.expect_refusal("no result of Cognate", text="{}")
        broken = json.loads(json.dumps(self.document))
        broken["problem"]["target"]["points"] = []
        self.expect_refusal("its problem is damaged", document=broken)
        other = json.loads(json.dumps(self.document))
        other["problem"]["kind"] = "function-generation"
        self.expect_refusal('certificates are checked of "path-generation"', document=other)

    def test_refuses_options_that_do_not_fit(self):
        for words, what in ((["--sample", "0", "--certificate"], "a whole number from 1"),
                            (["--sample", "5"], "add --certificate")):
            done = self.run_program("check", "eight.toml", *words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(what, done.stderr)


if __name__ == "__main__":
    PROGRAM, LIBRARY = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
