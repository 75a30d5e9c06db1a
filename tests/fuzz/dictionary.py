#!/usr/bin/env python3
"""The dictionary of the fuzzers: every key and word that the program lists, and what it does not list.

Run as: dictionary.py PROGRAM > read.dict
"""

import json
import re
import subprocess
import sys

# Syntax, values of other kinds than words, names that examples use, and words that no list of the program has.
FURTHER = ["M0 0h1v1z", "A1 1 0 0 1 ", "C1 1 2 2 3 3", "nan", "inf", "1e300", "sqrt(", "A", "E", "IT8",
           "through", "end", "rise_deg", "at_deg", "displacement", "displacement_deg", "jerk",
           "stall_torque", "no_load_speed", "phi", "w", "t", "s", "v", "max_error", "max_error_deg",
           "limit", "limit_deg", "cost", "plus", "minus", "uniform", "normal"]


def words_of(value):
    """Names with their parts, and what stands in quotes."""
    if isinstance(value, list):
        for part in value:
            yield from words_of(part)
    elif isinstance(value, dict):
        for key, part in value.items():
            if isinstance(part, (list, dict)):
                yield from words_of(part)
            elif key == "name":
                yield part
                yield from re.findall(r"[\w-]+", part)
            elif isinstance(part, str):
                yield from re.findall(r'"([^"]+)"', part)


def main():
    listed = subprocess.run([sys.argv[1], "list", "--json"], capture_output=True, text=True, check=True)
    for word in sorted({*FURTHER, *words_of(json.loads(listed.stdout))}):
        if word.isascii():
            print(f'"{word}"')


if __name__ == "__main__":
    main()
