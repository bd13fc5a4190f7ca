#!/usr/bin/env python3
"""Holds numbers to the one checked way from a double to an integer, base/whole.hpp.

usage: casts.py <src> [<build> <nm> <objdump>]

A cast of a double that does not fit its target is undefined, and a text search cannot see which casts are of doubles. The
compiler can: with -fsanitize=float-cast-overflow it calls a handler for each one. So, where the sanitizer build is given, no
object of ours may name that handler; which source does is told by the line that the call belongs to, as an object may hold
many sources (OBRYS_UNITY). What a header of others brings in stands in FOREIGN with its reason. The functions
that round or read straight to an integer, and hide what does not fit, are found by their names.
"""
import pathlib
import re
import subprocess
import sys

# With -fno-sanitize-recover it ends in _abort.
HANDLER = re.compile(r"__ubsan_handle_float_cast_overflow(?:_abort)?\b")
BY_NAME = re.compile(r"\b(?:l?lround|l?lrint)[fl]?\s*\(|\b(?:std::)?(?:stoi|stoll?|stoull?|atoi|atoll?|strtoll?|strtoull?|sscanf)\s*\(")
OBJECT = re.compile(r"(\S+):\s+file format ")
SECTION = re.compile(r"RELOCATION RECORDS FOR \[(.*)\]:$")
LINE = re.compile(r"(/[^\s()]*:\d+)(?: \(discriminator \d+\))?$")
COMMENT = re.compile(r"//[^\n]*")

# End of the path of the file that holds the cast -> why a header of others does so.
FOREIGN = {"/bits/chrono.h": "driver/guarded.cpp bounds the seconds before it"}


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
    """Objects that name the handler, from the lines of `nm -A -u`: "…/toa.cpp.o: U name"."""
    return {line.split(":")[0] for line in symbols.split("\n") if HANDLER.search(line)}


def sections(relocations):
    """Sections from which the handler is called, from `objdump -r`: to disassemble all of an object takes a minute."""
    found, section = set(), None
    for line in relocations.split("\n"):
        if match := SECTION.match(line):
            section = match.group(1)
        elif HANDLER.search(line):
            found.add(section)
    return sorted(found)


def places(listing):
    """File and line of each call of the handler, from `objdump -dlr`; the object where it has no lines."""
    found, member, place = set(), "?", None
    for line in listing.split("\n"):
        if match := OBJECT.match(line):
            member, place = match.group(1), None
        elif match := LINE.match(line):
            place = match.group(1)
        elif "R_" in line and HANDLER.search(line):
            found.add(place or member)
    return found


def in_source(place, src):
    """A place with its path from the sources' folder on, where it lies below that. A compiler cache may have written
    another way to that folder."""
    own = place.rpartition(f"/{src.name}/")[2]
    return own if (src / own.partition(":")[0]).is_file() else place


def by_object(src, build, nm, objdump):
    objects = sorted(o for o in build.glob("src/**/*.o") if "/obrys" in str(o).partition(".dir/")[0].rpartition("/CMakeFiles")[2])
    if not objects:
        return [f"{build}: no objects"], 0

    def said_by(*command):
        return subprocess.run([*map(str, command)], capture_output=True, text=True, check=True).stdout

    found = set()
    for one in sorted(casting(said_by(nm, "-A", "-u", *objects))):
        for section in sections(said_by(objdump, "-r", one)):
            found |= {in_source(p, src.resolve()) for p in places(said_by(objdump, "-dlr", "-j", section, one)) or {one}}
    found = {p for p in found if not p.split(":")[0].endswith(tuple(FOREIGN))}
    return [f"{p}: casts a double to an integer: use base/whole.hpp" for p in sorted(found)], len(objects)


def main():
    src, *rest = sys.argv[1:]
    complaints, objects = by_name(pathlib.Path(src)), 0
    if rest:
        more, objects = by_object(pathlib.Path(src), pathlib.Path(rest[0]), *rest[1:])
        complaints += more
    print("\n".join([*complaints, f"{objects} objects, {len(complaints)} complaints"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
