"""`cognate involute` from outside: published tables, ranges, the inverse, CSV, JSON, and what is refused.

Run as: involute_test.py PROGRAM, the built program.
"""

import csv
import decimal
import io
import json
import os
import random
import subprocess
import sys
import unittest

PROGRAM = ""

# inv of degrees as handbooks print it (Buckingham; Dudley; ISO/TR 4467).
PUBLISHED = {"10": "0.0017941", "14.5": "0.0055448", "15": "0.0061498", "20": "0.0149044",
             "20.5": "0.0160922", "22.5": "0.0215145", "25": "0.0299753", "30": "0.0537515",
             "40": "0.1409679", "45": "0.2146018"}


def run(*words):
    return subprocess.run([PROGRAM, "involute", *map(str, words)], text=True, timeout=60,
                          capture_output=True, check=False)


def rows(*words):
    return list(csv.DictReader(io.StringIO(run(*words, "--csv").stdout)))


def exact(degrees):
    """tan - id of a Decimal of degrees, by the series of sine and cosine with 80 digits."""
    with decimal.localcontext() as context:
        context.prec = 80
        pi = sum(sign * 4 * arctan(decimal.Decimal(1) / n) * k
                 for k, n, sign in ((4, 5, 1), (1, 239, -1)))
        x = degrees * pi / 180
        sine, cosine, term, k = x * 0, x * 0, x * 0 + 1, 0
        while abs(term) > decimal.Decimal(10) ** -78 * abs(x) ** 3:
            if k % 2:
                sine += term if k % 4 == 1 else -term
            else:
                cosine += term if k % 4 == 0 else -term
            k += 1
            term = term * x / k
        return sine / cosine - x


def arctan(x):
    total, power, k = x, x, 1
    while abs(power) > decimal.Decimal(10) ** -79:
        power = -power * x * x
        k += 2
        total += power / k
    return total


class Involute(unittest.TestCase):
    def test_published_values(self):
        for row in rows(*PUBLISHED):
            angle = float(row["angle_deg"])
            published = next(value for key, value in PUBLISHED.items() if float(key) == angle)
            self.assertAlmostEqual(float(row["involute"]), float(published), delta=5.1e-8)
        self.assertAlmostEqual(float(rows(20)[0]["involute"]), 0.014904383867336446, delta=1e-17)

    def test_every_digit(self):
        chance = random.Random(1)
        words = [repr(10 ** chance.uniform(-9, 1)) for _ in range(40)]
        words += [repr(chance.uniform(0, 90)) for _ in range(60)]
        words += [repr(90 - 10 ** chance.uniform(-9, 0)) for _ in range(40)]
        found = rows(*words)
        self.assertEqual(len(found), len(words))
        for word, row in zip(words, found):
            truth = exact(decimal.Decimal(word))
            miss = abs(decimal.Decimal(row["involute"]) / truth - 1)
            # A double near 90 degrees is the word only to its rounding, which counts there.
            rounding = abs(decimal.Decimal(float(word)) / decimal.Decimal(word) - 1) * 90
            allowed = decimal.Decimal("1.3e-15") + 4 * rounding / (90 - decimal.Decimal(word))
            self.assertLess(miss, allowed, word)
        back = rows("--inverse", *(row["involute"] for row in found))
        for word, row in zip(words, back):
            self.assertAlmostEqual(float(row["angle_deg"]), float(word), delta=1.2e-15 * float(word))

    def test_the_table_of_textbooks(self):
        table = rows()
        self.assertEqual([float(row["angle_deg"]) for row in table], list(range(10, 46)))
        fine = rows("10:45:0.5")
        self.assertEqual(len(fine), 71)
        self.assertEqual(float(fine[-1]["angle_deg"]), 45)
        tenths = rows("0:1:0.1", "20:20")
        self.assertEqual(len(tenths), 12)
        self.assertEqual(rows("10:10.95:0.1")[-1]["angle_deg"], "10.9")

    def test_what_is_printed(self):
        text = run(20).stdout
        self.assertRegex(text, r"20 +0\.0149043838673")
        self.assertRegex(run("--inverse", "0.014904383867336446").stdout, r" 20 +0\.0149043838673")
        document = json.loads(run("20:22", "--json").stdout)
        self.assertEqual(document["format"], "cognate-involute/1")
        self.assertEqual(document["angle_deg"], [20, 21, 22])
        self.assertEqual(run(20, "--quiet").stdout, "")
        self.assertEqual(run("--inverse", 0, 1e300).returncode, 0)

    def test_what_is_refused(self):
        for words, part in [(["90"], "less than 90"), (["x"], "'x' is no angle"), (["20:"], "no angle"),
                            (["nan"], "no angle"), (["inf", "--inverse"], "no involute"),
                            (["30:20"], "FROM <= TO"), (["10:20:0"], "STEP > 0"),
                            (["0:80:1e-9"], "at most 100000"), (["1:2:3:4"], "no angle"),
                            (["--inverse"], "missing"), (["1:2", "--inverse"], "FROM:TO:STEP"),
                            (["0:80:0.001", "0:80:0.001"], "at most 100000")]:
            with self.subTest(words):
                done = run(*words)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(part, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
