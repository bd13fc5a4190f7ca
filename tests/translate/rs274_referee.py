#!/usr/bin/env python3
"""What obrys writes for LinuxCNC runs in LinuxCNC's own rs274 to the same places as the program that it comes from.

usage: rs274_referee.py OBRYS SHARED [-v] [NAME...]      exit 77 (skipped) where SHARED or rs274 is missing

Of each RS-274 program of the corpora that rs274 runs to its end, and that obrys writes anew and calls the same: the ends of
all moves by rs274, of the program and of what was written, as far as rs274's four decimals tell (of inches 0.0025 mm).
"""
import argparse
import collections
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "linuxcnc"))
import endpoint  # noqa: E402
import runner  # noqa: E402

SECONDS = 10
KNOWN = {  # cycles of lathes whose start is where rs274's machine stands at first, which nobody knows else
    # … and a length that is compensated in the block of the tool change, by which rs274 moves Z with the next X and Y
    "rs274/LinuxCNC__linuxcnc/nc_files/skeleton.ngc",
    # … and G70 under compensation, where rs274 first goes to the end of the contour (docs/dialects/linuxcnc.md)
    "rs274/LinuxCNC__linuxcnc/nc_files/lathe_g70_71_demo.ngc",
    "rs274/LinuxCNC__linuxcnc/nc_files/lathe_g7x_face_boring.ngc", "rs274/LinuxCNC__linuxcnc/nc_files/lathe_g7x_quadrants.ngc"}
INCH = 25.4


def table(unit):
    return runner.Setting(tools=tuple((n, n, f"Z{n / 100 * unit:.4f} D{0.02 * unit:.4f}") for n in range(1, 100)))


TOOLS, TOOLS_IN_MM = table(1), table(INCH)  # the stand-alone rs274 reads its table in inches, obrys that of a mill in mm
PRINTED = 1e-4  # in the program's unit
SAME = 2e-4     # mm, of what is written


def places(text):
    """Machine positions behind the moves, each with how far it may be off by what was printed; repeated ones once."""
    machine, out = endpoint.Machine(), []
    for line in text.splitlines():
        found = endpoint.CALL.match(line)
        if not found or found[1] in ("COMMENT", "MESSAGE", "LOG"):
            continue
        machine.take(found[1], found[2])
        if found[1] in endpoint.STRAIGHT or found[1] == "ARC_FEED":
            at, off = machine.position()[:3], SAME + 3 * PRINTED * machine.unit
            out.append((at, off))
    return out


def difference(a, b):
    """Moves that lead nowhere, as far as the digits tell, may stand on one side alone."""
    i = j = 0
    while i < len(a) and j < len(b):
        off = max(a[i][1], b[j][1])
        if endpoint.close(a[i][0], b[j][0], off):
            i, j = i + 1, j + 1
        elif i > 0 and endpoint.close(a[i][0], a[i - 1][0], off):
            i += 1
        elif j > 0 and endpoint.close(b[j][0], b[j - 1][0], off):
            j += 1
        else:
            return f"move {i}: {endpoint.shown(a[i][0])}, written anew {endpoint.shown(b[j][0])}"
    rest = a[i:] or b[j:]
    last = (a if i else b)[-1 if not rest else max(i, j) - 1][0] if (i or j) else None
    return "" if all(last and endpoint.close(p, last, off) for p, off in rest) else f"{len(rest)} places are left over"


def compared(obrys, path):
    before = runner.run_referee(path, TOOLS, SECONDS)
    if before.code != 0:
        return "refused by rs274", ""
    with tempfile.TemporaryDirectory() as folder:
        tools, _, _ = runner.write_setting(TOOLS_IN_MM, folder, path)
        written = pathlib.Path(folder) / "written.ngc"
        done = subprocess.run([obrys, "translate", str(path), "--control", "linuxcnc", "--machine", "mill-generic", "--tools",
                               str(tools), "--to", "linuxcnc", "-o", str(written)], capture_output=True, check=False,
                              timeout=6 * SECONDS)
        if done.returncode not in (0, 3):
            return {1: "lost or otherwise", 2: "not read", 3: "not understood"}.get(done.returncode, "crash"), ""
        after = runner.run_referee(written, TOOLS, SECONDS)
    if after.code != 0 and done.returncode == 3:
        return "not understood", ""
    if after.code != 0:
        return "differ", f"rs274 refuses what was written: {after.refused or after.err.strip()[-150:]}"
    off = difference(places(before.out), places(after.out))
    if off and done.returncode == 3:
        return "not understood", off
    return ("differ", off) if off else ("same places", "")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("-v", action="store_true", dest="verbose")
    options = parser.parse_intermixed_args()
    corpus = options.shared / "corpus"
    if not corpus.is_dir() or not runner.REFEREE_HERE:
        print("skipped: needs ../shared" if runner.REFEREE_HERE else "skipped: needs rs274 of LinuxCNC")
        return 77
    kinds, faults = collections.Counter(), []
    for place in ("rs274", "gcode"):
        for path in sorted(p for p in (corpus / place).rglob("*") if p.is_file()):
            name = path.relative_to(corpus).as_posix()
            if options.names and not any(n in name for n in options.names):
                continue
            kind, said = compared(options.obrys, path)
            kinds[kind] += 1
            if kind in ("differ", "crash") and name not in KNOWN:
                faults.append(f"{name}: {said or kind}")
            if options.verbose:
                print(f"{kind:18} {name} {said}")
    print(", ".join(f"{kind} {count}" for kind, count in kinds.most_common()) + f" of {sum(kinds.values())} programs")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
