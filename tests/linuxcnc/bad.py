#!/usr/bin/env python3
"""Bad programs are refused, at the right line: `bad.py OBRYS SHARED [-v] [--referee] [NAME...]`.

Each program has one fault (bad_programs.py); obrys has to end with an error whose first place is that line, and to run to
its end what LinuxCNC accepts. With --referee rs274 itself is held to the lines: it shows the text of the line it read last.
"""
import pathlib
import sys
import tempfile

import endpoint
import runner
from bad_programs import BAD, CORPUS_BAD, KNOWN_FAILURES, Bad

SECONDS = 20
# The machine of rs274 when it is told nothing: its default tool table, in inch, and six axes.
MACHINE = runner.Setting(tools=((1, 1, "Z0.511 D0.125"), (2, 2, "Z0.1 D0.0625"), (3, 3, "Z1.273 D0.201")),
                         ini={"TRAJ": {"COORDINATES": "X Y Z A B C", "LINEAR_UNITS": "inch"}})
PLACE = "corpus/rs274/LinuxCNC__linuxcnc/tests/interp"


def referee_line(path, text):
    """The line rs274 refuses; 0 when it accepts the program; a text when the line is not clear."""
    run = runner.run_referee(path, None, SECONDS)
    if run.code is None:
        return "no end"
    if run.code == 0:
        return 0
    if not run.refused:
        return f"exit {run.code}"
    shown = run.refused[1]
    lines = text.splitlines() or [""]
    places = [n for n, line in enumerate(lines, 1) if line.rstrip("\r") == shown or (len(shown) > 200 and line.startswith(shown))]
    return places[0] if len(places) == 1 else f"shown as {shown[:40]!r}"


def obrys_line(obrys, path, _text):
    """The line of the first error obrys tells; 0 when it accepts the program."""
    run = runner.run_obrys(obrys, path, MACHINE, SECONDS)
    if run.code is None:
        return "no end"
    if run.code == 0:
        return 0
    if "[file-empty]" in run.err:
        return 1
    found = endpoint.refusal(run.err)
    return int(found[2]) if found else f"exit {run.code}: {endpoint.first_error(run.err)}"


def check(bad, path, options):
    """What is wrong, or nothing."""
    if options.referee:
        wanted = bad.line if bad.referee < 0 else bad.referee
        got = referee_line(path, bad.text)
    else:
        wanted, got = bad.line, obrys_line(options.obrys, path, bad.text)
    if got == wanted:
        return ""
    names = {0: "accepted"}
    said = f"line {got}" if isinstance(got, int) else got
    return f"{names.get(got, said)}, wanted {names.get(wanted, f'line {wanted}')}"


def all_programs(options):
    """Our own ones, and those of the corpus where it is at hand."""
    programs = list(BAD)
    place = options.shared / PLACE
    if place.is_dir():
        programs += [Bad(name, (place / name).read_text(), line) for name, line in CORPUS_BAD.items()]
    else:
        print(f"skipped: {len(CORPUS_BAD)} programs of ../shared")
    return [p for p in programs if not options.names or any(n in p.name for n in options.names)]


def main():
    options = runner.arguments("--referee")
    if options.referee and not runner.REFEREE_HERE:
        print("skipped: needs rs274 of LinuxCNC")
        return 77
    faults, right = [], 0
    programs = all_programs(options)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "bad.ngc"
        for bad in programs:
            path.write_text(bad.text)
            said = check(bad, path, options)
            known = "" if options.referee else KNOWN_FAILURES.get(bad.name, "")
            right += not said
            if said and known:
                print(f"{bad.name}: {said} (known: {known})")
            elif said:
                faults.append(f"{bad.name}: {said}" + (f"\n    {bad.text!r}" if options.verbose else ""))
            elif known:
                faults.append(f"{bad.name}: right, but listed as a known failure")
    print(f"{right} right of {len(programs)} programs")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
