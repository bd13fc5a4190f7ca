#!/usr/bin/env python3
"""All RS-274 programs of the corpus end at the same point by obrys and by LinuxCNC's rs274.

usage: end_points.py OBRYS SHARED [-v] [--self] [NAME...]      exit 77 (skipped) where SHARED or rs274 is missing

Both run with the same tool table. The end point is the last commanded machine position, from the printed canonical calls:
program coordinates, offsets, rotation and tool offset, in mm; it has to agree to 1e-4. What rs274 refuses obrys has to
refuse at the same line. A fault that obrys tells of a line which is never reached, while all calls up to the program's end are
the same, is no difference: rs274 has only not come to it. With --self rs274 stands in for obrys, which tests this comparison.
"""
import collections
import pathlib
import re
import sys

import endpoint
import runner
from end_point_cases import KNOWN_FAILURES, NEWER

SECONDS = 10
TOLERANCE = 1e-4
TOOLS = runner.Setting(tools=tuple((n, n, f"Z{n / 100:.2f} D0.02") for n in range(1, 100)))


def compared(path, options):
    """(kind, what to print) of one program."""
    referee = runner.run_referee(path, TOOLS, SECONDS)
    if options.self:
        ours = runner.run_referee(path, TOOLS, SECONDS)
    else:
        ours = runner.run_obrys(options.obrys, path, TOOLS, SECONDS)
    if ours.code is not None and (ours.code < 0 or ours.code > 100):
        return "crash", f"exit {ours.code}: {ours.err.strip()[-200:]}"
    if referee.code is None or ours.code is None:
        return ("endless", "neither ends") if referee.code == ours.code else (
            "differ", "rs274 does not end" if referee.code is None else "obrys does not end")
    there, here = endpoint.end_point(referee.out), endpoint.end_point(ours.out)
    points = "" if endpoint.close(there, here, TOLERANCE) else f"{endpoint.shown(there)} by rs274, {endpoint.shown(here)}"
    if referee.code != 0:
        return refusals(referee, ours, points, options)
    same = runner.calls(referee.out) == runner.calls(ours.out)
    if same and "PROGRAM_END()" in ours.out:
        return "same calls", "" if ours.code == 0 or options.self else f"told besides: {endpoint.first_error(ours.err)}"
    if ours.code == 1 or (ours.code != 0 and endpoint.refusal(ours.err) and not options.self):
        first = endpoint.first_error(ours.err)
        return ("unsupported" if "unsupported" in first or "unknown-word" in first else "differ"), f"obrys refuses: {first}"
    if points:
        return "differ", points
    if ours.code != 0 and not options.self:
        return "unsupported", endpoint.first_error(ours.err)
    return "same calls" if same else "same point", ""


# What the installed rs274 refuses for what it is, not for the program: files of user M codes, HAL pins, axes it was built
# without, and words of 2.10.
LACKS = (r"Unknown m code used: M1\d\d", r"Named parameter #<_hal\[", r"Bad character '[uvw]' used", r"Unknown g code used .*G6\.[23]",
         r"You must specify both X and Y coordinates for Control Points")


def refusals(referee, ours, points, options):
    message, text = referee.refused or (referee.err.strip()[-100:], "")
    if any(re.match(pattern, f"{message} {text}") for pattern in LACKS):
        return "rs274 lacks", f"{message} ({text.strip()})"
    if ours.code == 0 and message.startswith("File ended") and not points:
        return "no end", "a file of subroutines, which rs274 refuses for its missing end"
    if ours.code == 0:
        return "differ", f"rs274 refuses: {message} ({text.strip()}); obrys accepts"
    if options.self:
        return "refused", message
    first = endpoint.first_error(ours.err)
    where = endpoint.error_line(ours.err)
    searched = "EOF in file" in message or message.startswith(("File ended", "Failed to find sub"))
    if not searched and (where is None or where.strip() != text.strip()):
        return "differ", f"rs274: {message} ({text.strip()}); obrys: {first}"
    if points and not searched:
        return "differ", f"before the refusal: {points}"
    return "refused", f"{message}; obrys: {first}"


def programs(options):
    corpus = options.shared / "corpus"
    for place in ("rs274", "fanuc_macro/LinuxCNC__linuxcnc", "gcode"):
        for path in sorted(p for p in (corpus / place).rglob("*") if p.is_file()):
            name = path.relative_to(corpus).as_posix()
            if not options.names or any(n in name for n in options.names):
                yield name, path


def main():
    options = runner.arguments("--self")
    if not (options.shared / "corpus").is_dir() or not runner.REFEREE_HERE:
        print("skipped: needs ../shared" if runner.REFEREE_HERE else "skipped: needs rs274 of LinuxCNC")
        return 77
    kinds, faults = collections.Counter(), []
    for name, path in programs(options):
        kind, said = compared(path, options)
        kinds[kind] += 1
        short = name.replace("LinuxCNC__linuxcnc", "…")
        known = "" if options.self else NEWER.get(name) or KNOWN_FAILURES.get(name, "")
        good = kind in ("rs274 lacks", "no end", "same calls", "same point", "refused", "endless")
        if options.verbose or not good:
            print(f"{kind:12} {short}  {said}" + (f" (known: {known})" if known else ""))
        if good == bool(known):
            faults.append(f"{short}: {said}" if known == "" else f"{short}: agrees, but is listed as a known failure")
    print(", ".join(f"{kind} {count}" for kind, count in kinds.most_common()) + f" of {sum(kinds.values())} programs")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
