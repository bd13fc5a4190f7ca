#!/usr/bin/env python3
"""The 2021 thesis' listing for Acramatic 2100 against the expansion of its cycles in ../shared, and written anew: from
itself, and from the cutter locations of its part (thesis.apt).

usage: thesis_test.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

NEAR = 1e-4  # mm, s: the listing's resolution


def call(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=60)
    return done.returncode, done.stdout, done.stderr


def brackets(stream):
    """The records of each cycle, from the end of the move before it on, by the source of its block."""
    found, open_cycle, before, at = [], None, [], [None, None, None]
    for line in stream.splitlines():
        words = line.split()
        if words[0] == "cycle":
            open_cycle = {"name": line.split('"')[1], "records": before[:], "start": at[:], "line": line}
            continue
        if words[0] == "cycle-end":
            found.append(open_cycle)
            open_cycle, before = None, []
            continue
        if open_cycle is not None:
            open_cycle["records"].append(words)
        elif words[0] == "rapid":
            before = [words]
    return found


def moves_of(cycle):
    """As expected.json says them: what the axis does, without moves of no length."""
    out, z, back = [], None, False
    for words in cycle["records"]:
        if words[0] == "dwell":
            out.append(["DWELL", float(words[1])])
        if words[0] == "spindle":
            back = words[3] == "ccw"
        if words[0] not in ("rapid", "linear", "thread"):
            continue
        x, y, to = map(float, words[1:4])
        if not out:
            out.append(["G0 XY", x, y])
        elif z is None or abs(to - z) > 1e-9:
            taps = cycle["name"].startswith("G84")
            kind = ("TAP Z reverse" if back else "TAP Z") if taps and words[0] != "rapid" else \
                   "G0 Z" if words[0] == "rapid" else "G1 Z"
            out.append([kind, to])
        z = to
    return out


def check_expansion(what, stream, expected):
    """The cycles of a run against expected.json."""
    faults, cycles = [], brackets(stream)
    if [c["name"] for c in cycles] != [c["code"] for c in expected["cycles"]]:
        faults.append(f"{what}: cycles: {[c['name'] for c in cycles]}")
    for got, want in zip(cycles, expected["cycles"]):
        moves = moves_of(got)
        # Where the tool stands at the clearance already the control has no way to go; expected.json lists it.
        wanted = [m for i, m in enumerate(want["moves"])
                  if not (i == 1 and m[0] == "G0 Z" and float(got["records"][0][3]) == m[1])]
        same = len(moves) == len(wanted) and all(
            a[0] == b[0] and all(abs(x - y) <= NEAR for x, y in zip(a[1:], b[1:])) for a, b in zip(moves, wanted))
        if not same:
            faults.append(f"{what}: {want['block']} {want['code']}:\n  {moves}\n  expected\n  {wanted}")
    lowest = min((float(w[3]) for c in cycles for w in c["records"] if w[0] in ("rapid", "linear", "thread")), default=None)
    if lowest is None or abs(lowest - expected["z_min"]) > NEAR:
        faults.append(f"{what}: the lowest point is {lowest}, expected {expected['z_min']}")
    return faults


def check_words(what, body, written):
    """The listing, word for word."""
    faults = [f"{what}: line {n + 1} behind the header: {b!r}, in the listing {a!r}"
              for n, (a, b) in enumerate(zip(body + [""] * 9, written.splitlines())) if a != b]
    if len(body) != len(written.splitlines()):
        faults.append(f"{what}: {len(written.splitlines())} lines, in the listing {len(body)}")
    return faults


def main():
    obrys, shared = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    listing = shared / "programs/acramatic/ACRAMATIC.NC"
    if not listing.exists():
        print(f"skipped: {listing} is missing")
        return 77
    expected = json.loads((listing.parent / "expected.json").read_text(encoding="utf-8"))
    faults = []
    code, stream, errors = call(obrys, "run", listing)
    if code != 0:
        faults.append(f"run: exit code {code}\n{errors}")
    if "read as acramatic-2100" not in errors:
        faults.append("the listing is not known by its text")
    faults += check_expansion("listing", stream, expected)

    text = listing.read_text(encoding="utf-8").splitlines()
    body = text[text.index(":"):]
    with tempfile.TemporaryDirectory() as folder:
        # Its comments are the post's own, which would stand beside those that it writes.
        bare = pathlib.Path(folder) / "bare.nc"
        bare.write_text("\n".join(line for line in body if not line.startswith(";")) + "\n", encoding="utf-8")
        code, written, errors = call(obrys, "translate", bare, "--to", "acramatic-2100", "--control", "acramatic-2100")
        if code != 0:
            faults.append(f"translate: exit code {code}\n{errors}")
        faults += check_words("listing", body, written)

    with tempfile.TemporaryDirectory() as folder:
        # Chapter 7.1: the part's cutter locations give the listing, and that gives the expansion.
        locations = pathlib.Path(__file__).resolve().parent / "thesis.apt"
        given = pathlib.Path(folder) / "given.nc"
        code, _, errors = call(obrys, "translate", locations, "--to", "acramatic-2100", "-o", given)
        if code != 0:
            faults.append(f"cutter locations: exit code {code}\n{errors}")
        faults += check_words("cutter locations", body, given.read_text(encoding="utf-8") if given.exists() else "")
        code, stream, errors = call(obrys, "run", given)
        if code != 0:
            faults.append(f"what was written from cutter locations: exit code {code}\n{errors}")
        faults += check_expansion("what was written from cutter locations", stream, expected)

        # Chapter 7.2: the five blocks as the control's own virtual machine writes them, in the listing's places.
        own = {"G82": "G82 G97 G94 G90 X40 Y20 Z50 R70 S500 F200 M3",
               "G83J13": "G83 G97 G94 G90 X40 Y20 Z53 R70 K10 J13 S500 F200 M3",
               "G83J11": "G83 G97 G94 G90 X60 Y20 Z53 R70 K10 J11 S500 F200 M3",
               "G84": "G84 G97 G94 G90 X80 Y20 Z35 R70 J1 S200 F100 M3",
               "G84.1": "G84.1 G97 G94 G90 X100 Y20 Z35 R70 J1 P1 K10 S200 F100 M3"}
        lines = []
        for line in body:
            m = re.match(r"N\d+ (G8[234][.1]*) ", line)
            key = (m.group(1) + (re.search(r"J1[13]", line).group(0) if "G83" in line else "")) if m else ""
            lines.append(own.get(key, line.replace("53.0043", "53.")))
        one, other = pathlib.Path(folder) / "one.nc", pathlib.Path(folder) / "other.nc"
        one.write_text("\n".join(line.replace("53.0043", "53.") for line in body) + "\n", encoding="utf-8")
        other.write_text("\n".join(lines) + "\n", encoding="utf-8")
        if sum(line in own.values() for line in lines) != 5:
            faults.append("the control's own blocks were not put in place")
        same = pathlib.Path(folder) / "same.apt"
        same.write_text(locations.read_text(encoding="utf-8").replace("53.0043", "53"), encoding="utf-8")
        for first in (one, same):
            code, said, errors = call(obrys, "compare", first, other)
            if code != 0:
                faults.append(f"the control's own five blocks and {first.name}: compare says {code}\n{said}{errors}")
    print("\n".join(faults) or f"{len(expected['cycles'])} cycles as expected, {len(body)} lines word for word, from the listing "
          "and from cutter locations")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
