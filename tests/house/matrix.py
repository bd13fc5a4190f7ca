#!/usr/bin/env python3
"""The support matrix of a dialect's page is what the program made from the tables prints.

usage: matrix.py [--update] <obrys_matrix> <page.md>

The matrix stands between the lines `<!-- matrix -->` and `<!-- /matrix -->`; --update writes it there.
"""
import difflib
import pathlib
import subprocess
import sys

BEGIN, END = "<!-- matrix -->\n", "<!-- /matrix -->\n"


def split(text):
    """What stands before, between and behind the marks; None where there is not one pair of them."""
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        return None
    before, rest = text.split(BEGIN)
    between, behind = rest.split(END)
    return before, between, behind


def main():
    arguments = [a for a in sys.argv[1:] if a != "--update"]
    program, page = arguments[0], pathlib.Path(arguments[1])
    printed = subprocess.run([program], check=True, capture_output=True, timeout=60).stdout.decode("utf-8")
    parts = split(page.read_text(encoding="utf-8"))
    if parts is None:
        print(f"{page}: needs one {BEGIN.strip()} and one {END.strip()} behind it")
        return 1
    if "--update" in sys.argv:
        page.write_text(parts[0] + BEGIN + printed + END + parts[2], encoding="utf-8")
        return 0
    if parts[1] == printed:
        print(f"{page.name}: {printed.count(chr(10))} lines of matrix")
        return 0
    sys.stdout.writelines(difflib.unified_diff(parts[1].splitlines(True), printed.splitlines(True), str(page), program))
    print(f"the matrix is not that of the tables: python3 tests/house/matrix.py --update {program} {page}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
