"""Files of columns made by h5py from a study's database, and what their checksums are, without the program."""

import sqlite3
import struct

import h5py
import numpy

FORMAT = b"cognate-study-columns/2"
BLOCKS = ("first", "count", "kept", "filtered", "solved", "infeasible", "no_solution", "invalid")
ALL = (1 << 64) - 1


class Checksum:
    """64 bits of a sequence, as app/study/checksum.hpp says."""

    def __init__(self):
        self.sum = 0x243F6A8885A308D3

    def word(self, word):
        self.sum = (self.sum ^ (word & ALL)) * 0x9E3779B97F4A7C15 & ALL
        self.sum ^= self.sum >> 32

    def text(self, text):
        data = text.encode()
        self.word(len(data))
        for at in range(0, len(data), 8):
            self.word(int.from_bytes(data[at : at + 8], "little"))

    def cell(self, value):
        if value is None:
            self.word(0)
        elif isinstance(value, str):
            self.word(2)
            self.text(value)
        else:
            self.word(1)
            self.word(struct.unpack("<Q", struct.pack("<d", value))[0])

    def value(self):
        return self.sum - (1 << 64) if self.sum >> 63 else self.sum


def block_checksum(counts, rows):
    sum = Checksum()
    for number in counts:
        sum.word(number)
    for identity, *cells in rows:
        sum.word(identity)
        for value in cells:
            sum.cell(value)
    return sum.value()


def texts_checksum(texts):
    sum = Checksum()
    for name, text in texts:
        sum.text(name)
        sum.text(text)
    return sum.value()


def fixed(words):
    data = [word.encode() for word in words]
    return numpy.array(data, dtype=f"S{max(1, *map(len, data))}" if data else "S1")


def kind_of(value):
    return 0 if value is None else 2 if isinstance(value, str) else 1


def write_column(file, name, values, options, big_endian):
    if any(isinstance(value, str) for value in values):
        words = ["" if value is None else value if isinstance(value, str) else repr(value) for value in values]
        file.create_dataset(f"runs/{name}", data=fixed(words), **options)
        if any(kind_of(value) == 1 or value == "" for value in values):
            file[f"kinds/{name}"] = numpy.array([kind_of(value) for value in values], dtype="i1")
    else:
        numbers = [numpy.nan if value is None else value for value in values]
        file.create_dataset(f"runs/{name}", data=numpy.array(numbers, dtype=">f8" if big_endian else "<f8"), **options)


def tables_of(database):
    with sqlite3.connect(database) as connection:
        cursor = connection.execute("SELECT * FROM runs ORDER BY id")
        names = [column[0] for column in cursor.description]
        rows = cursor.fetchall()
        study = connection.execute("SELECT name, value FROM study ORDER BY rowid").fetchall()
        blocks = connection.execute(f"SELECT {', '.join(BLOCKS)} FROM blocks ORDER BY first").fetchall()
        front = [row[0] for row in connection.execute("SELECT id FROM front ORDER BY id")]
    return names, rows, study, blocks, front


def write_by_hand(path, tables, checksums=True, compressed=False, big_endian=False):
    """Writes the tables as columns; compressed and in the other order of bytes, too, which the program itself never does."""
    names, rows, study, blocks, front = tables
    options = {"compression": "gzip", "chunks": (7,)} if compressed and rows else {}
    with h5py.File(path, "w") as file:
        file.attrs["format"] = numpy.bytes_(FORMAT)
        file.create_group("kinds")
        group = file.create_group("study")
        for name, text in study:
            group[name] = numpy.array(text.encode(), dtype=f"S{max(1, len(text.encode()))}")
        group.attrs["checksum"] = numpy.int64(texts_checksum(study))
        integers = ">i8" if big_endian else "<i8"
        file.create_dataset("runs/id", data=numpy.array([row[0] for row in rows], dtype=integers), **options)
        for place, name in enumerate(names[1:], 1):
            write_column(file, name, [row[place] for row in rows], options, big_endian)
        for place, name in enumerate(BLOCKS):
            file[f"blocks/{name}"] = numpy.array([block[place] for block in blocks], dtype=integers)
        sums = [block_checksum(block, [row for row in rows if 0 <= row[0] - block[0] < block[1]]) for block in blocks]
        file["blocks/has_checksum"] = numpy.full(len(blocks), int(checksums), dtype=integers)
        file["blocks/checksum"] = numpy.array(sums, dtype=integers)
        file["front"] = numpy.array(front, dtype=integers)
