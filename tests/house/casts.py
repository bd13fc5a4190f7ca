#!/usr/bin/env python3
"""Holds numbers to the one checked way from a double to an integer, base/whole.hpp.

usage: casts.py <src> [<build> <nm>]

A cast of a double that does not fit its target is undefined, and a text search cannot see which casts are of doubles. The
compiler can: with -fsanitize=float-cast-overflow it calls a handler for each one. So, where the sanitizer build is given, no
object of ours may name that handler; what a header of others brings in stands in FOREIGN with its reason. The functions
that round or read straight to an integer, and hide what does not fit, are found by their names.
"""
import pathlib
import re
import subprocess
import sys

HANDLER = "__ubsan_handle_float_cast_overflow"
BY_NAME = re.compile(r"\b(?:l?lround|l?lrint)[fl]?\s*\(|\b(?:std::)?(?:stoi|stoll?|stoull?|atoi|atoll?|strtoll?|strtoull?|sscanf)\s*\(")
COMMENT = re.compile(r"//[^\n]*")

# Object -> why a header of others casts a double there.
FOREIGN = {}


def by_name(src):
    """Complaints about names that round or read to an integer; tests may."""
    found = []
    for path in sorted(src.rglob("*.[ch]pp")):
        if "_test" in path.stem or "_testing" in path.stem:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            for match in BY_NAME.finditer(COMMENT.sub("", line)):
                found.append(f"{path.relative_to(src)}:{number}: {match.group().rstrip('( ')}: use base/whole.hpp or base/number.hpp")
    return found


def casting(symbols):
    """Objects that name the handler, from the lines of `nm -A -u`: "libobrys_shop.a:toa.cpp.o: U name"."""
    found = set()
    for line in symbols.split("\n"):
        if line.endswith(HANDLER):
            archive, member = line.split(":")[:2]
            found.add(f"{pathlib.PurePath(archive).stem.removeprefix('libobrys_')}/{member.removesuffix('.o')}")
    return found


def by_object(build, nm):
    archives = sorted(build.glob("src/**/libobrys_*.a"))
    if not archives:
        return [f"{build}: no libraries"], 0
    done = subprocess.run([nm, "-A", "-u", *map(str, archives)], capture_output=True, text=True, check=True)
    found = casting(done.stdout)
    return [f"{o}: casts a double to an integer: use base/whole.hpp" for o in sorted(found - set(FOREIGN))], len(archives)


def main():
    src, *rest = sys.argv[1:]
    complaints, archives = by_name(pathlib.Path(src)), 0
    if rest:
        more, archives = by_object(pathlib.Path(rest[0]), rest[1])
        complaints += more
    print("\n".join([*complaints, f"{archives} libraries, {len(complaints)} complaints"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
