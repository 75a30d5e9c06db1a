"""Study files that something has changed: none of them is gone on with, and files that are merged stay as they are.

Run as: sweep_damage_test.py PROGRAM, the built program.
"""

import hashlib
import pathlib
import shutil
import sqlite3
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from sweeps import Sweeps  # noqa: E402


class Damage(Sweeps):
    def setUp(self):
        super().setUp()
        self.run_program("sweep", "small.toml", "--out", "out", "--json")
        self.file = self.folder / "out/small.study.db"
        with sqlite3.connect(self.file) as database:
            database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        database.close()

    def change(self, statement):
        with sqlite3.connect(self.file) as database:
            database.execute("PRAGMA writable_schema = ON")
            self.assertGreater(database.execute(statement).rowcount, 0, statement)
            database.commit()
            database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        database.close()

    def expect_damaged(self):
        before = self.file.read_bytes()
        done = self.run_program("sweep", "small.toml", "--out", "out")
        self.expect_refusal(done, "small.study.db", "is damaged")
        self.assertEqual(self.file.read_bytes(), before)

    def expect_damaged_by(self, statement):
        """The file is then as it was."""
        whole = self.folder / "whole.db"
        shutil.copy(self.file, whole)
        self.change(statement)
        self.expect_damaged()
        shutil.move(whole, self.file)

    def test_a_changed_view_or_table_is_noticed(self):
        for old, new in {
            "ORDER BY \"output_stroke\"": "ORDER BY \"output_strokd\"",
            "status = ''solved''": "status < ''solved''",
            "\"class\"": "\"clasr\"",
            "\"time_ratio\"": "\"time_ratia\"",
        }.items():
            with self.subTest(old):
                self.expect_damaged_by(f"UPDATE sqlite_master SET sql = replace(sql, '{old}', '{new}') WHERE instr(sql, '{old}')")

    def test_words_that_are_bytes_are_noticed(self):
        for column in ("class", "status"):
            with self.subTest(column):
                first = "id = (SELECT min(id) FROM runs)"
                self.expect_damaged_by(f"UPDATE runs SET {column} = CAST({column} AS BLOB) WHERE {first}")

    def test_a_changed_index_is_noticed(self):
        with sqlite3.connect(self.file) as database:
            (page,) = database.execute("SELECT rootpage FROM sqlite_master WHERE name = 'sqlite_autoindex_study_1'").fetchone()
            (size,) = database.execute("PRAGMA page_size").fetchone()
        database.close()
        data = bytearray(self.file.read_bytes())
        at = data.index(b"objectives", (page - 1) * size, page * size)
        data[at] ^= 1
        self.file.write_bytes(data)
        self.expect_damaged()

    def merge(self, *files):
        named = [argument for file in files for argument in ("--merge", str(file))]
        return self.run_program("sweep", "small.toml", "--json", "--out", "new", *named)

    def test_other_databases_are_refused_and_unchanged(self):
        foreign = self.folder / "foreign.db"
        with sqlite3.connect(foreign) as database:
            database.execute("PRAGMA user_version = 5")
            database.execute("PRAGMA application_id = 77")
        database.close()
        before = foreign.read_bytes()
        self.expect_refusal(self.merge(foreign), "foreign.db", "is no study file")
        self.assertEqual(foreign.read_bytes(), before)
        self.assertFalse((self.folder / "new/small.study.db").exists())

        shutil.copy(foreign, self.folder / "out/small.study.db")
        self.expect_refusal(self.run_program("sweep", "small.toml", "--out", "out"), "is no study file")

    def test_merged_files_stay_as_they_are(self):
        for statement in ("PRAGMA journal_mode = DELETE", "DROP TABLE checksums"):
            with self.subTest(statement):
                with sqlite3.connect(self.file) as database:
                    database.execute(statement)
                database.close()
                before = hashlib.md5(self.file.read_bytes()).hexdigest()
                done = self.merge(self.file)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(hashlib.md5(self.file.read_bytes()).hexdigest(), before)
                self.assertEqual("no checksums" in done.stdout, "checksums" in statement)
                shutil.rmtree(self.folder / "new")

    def test_a_file_is_merged_once(self):
        self.expect_refusal(self.merge(self.file, self.folder / "out/../out/small.study.db"), "named twice")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
