#!/usr/bin/env python3
"""LinuxCNC's interpreter tests: does `obrys run --canon` print the expected canonical calls?

usage: canon.py OBRYS SHARED [-v] [--referee] [NAME...]      exit 77 (skipped) where SHARED is missing

Compared are all lines of standard output: same calls, same order, coordinates as printed; only the counter in front of a line
is left out. With --referee LinuxCNC's own rs274 is held to the files, which tests this comparison; OBRYS may be "-" then.
"""
import argparse
import difflib
import pathlib
import re
import sys
import tempfile

import runner
from cases import CASES, EXCLUDED, KNOWN_FAILURES, NO_PROGRAM

PLACE = "LinuxCNC__linuxcnc/tests/interp"
SECONDS = 20


def viewed(text, case):
    """What the test script made of the output."""
    lines = runner.calls(text)
    if case.view == "fields":
        lines = [" " + " ".join(line.split()[1:]) for line in text.splitlines()]
    if case.only:
        lines = [line for line in lines if case.only in line]
    # A coordinate of zero has no sign worth comparing.
    return [re.sub(r"-(0\.0+)(?![0-9])", r"\1", line) for line in lines]


NUMBER = re.compile(r"-?[0-9]+\.[0-9]+")


def same_but_ties(expected, printed):
    """How many numbers differ by one in their last digit; None where anything else differs.

    LinuxCNC computes in the unit of the program, obrys in millimetres: a number that lies half way between two that can be
    printed comes out as the other one.
    """
    if len(expected) != len(printed):
        return None
    ties = 0
    for a, b in zip(expected, printed):
        if a == b:
            continue
        if NUMBER.sub("#", a) != NUMBER.sub("#", b):
            return None
        for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)):
            digits = len(x.split(".")[1])
            if abs(float(x) - float(y)) > 1.01 * 10 ** -digits:
                return None
            ties += x != y
    return ties


def without(lines, patterns):
    return [line for line in lines if not any(re.fullmatch(p, line) or re.fullmatch(p, line.strip()) for p in patterns)]


def expected_lines(text, case, part):
    lines = runner.calls(text)
    if part.title:
        titles = {p.title for p in case.parts}
        start = lines.index(part.title) + 1
        end = start
        while end < len(lines) and lines[end] not in titles and not re.match(r"(program: |(Il|L)egal test )", lines[end]):
            end += 1
        lines = lines[start:end]
    return lines


def as_of_2_10(lines):
    """2.9 prints a tool change with START_CHANGE and the row of the tool table, 2.10 does not."""
    return [re.sub(r"CHANGE_TOOL\([0-9]+\)", "CHANGE_TOOL()", line) for line in lines if "START_CHANGE()" not in line]


def run_part(case, part, options, corpus):
    """The lines printed and what was wrong with the exit code."""
    folder = corpus / "rs274" / PLACE / case.name
    with tempfile.TemporaryDirectory() as own:
        path, setting = folder / part.program, part.setting
        if part.text:   # our main program is elsewhere: the folder of subroutines is named in full
            path = pathlib.Path(own) / part.program
            path.write_text(part.text)
            setting = runner.Setting(setting.tools, setting.ini, setting.parameters, str((folder / setting.search).resolve()))
        run = runner.run_referee(path, setting, 5) if options.referee else runner.run_obrys(
            options.obrys, path, setting, SECONDS)
    if run.code is None:
        return [], f"{part.program}: no end in time"
    if run.code < 0 or run.code > 100:
        return [], f"{part.program}: exit {run.code}: {run.err[:200]}"
    lines = viewed(run.out, case)
    # obrys also says "not fully checked" (exit 3) of runs that come to their end.
    refused = run.code != 0 if options.referee else ": error: " in run.err or "[missing-subprogram]" in run.err
    fault = "" if refused == part.refused else (
        f"{part.program}: exit {run.code}, to be {'refused' if part.refused else 'accepted'}: {run.err.strip()[:200]}")
    return as_of_2_10(lines) if options.referee else lines, fault


def differences(case, options, corpus):
    """Lines to show; none when the case agrees."""
    text = (corpus / "rs274_expected" / PLACE / case.name / "expected").read_text()
    shown = []
    for part in case.parts:
        lines, fault = run_part(case, part, options, corpus)
        wanted = [re.sub(r"-(0\.0+)(?![0-9])", r"\1", line) for line in without(expected_lines(text, case, part), case.drop)]
        shown += [fault] if fault else []
        ties = same_but_ties(wanted, without(lines, case.drop))
        if ties:
            print(f"{case.name}: {ties} numbers differ by one in their last digit")
        if ties is not None:
            continue
        shown += difflib.unified_diff(wanted, without(lines, case.drop), "expected", "printed", lineterm="", n=1)
    return shown


def all_named(corpus):
    """Every expected file has a case or a reason."""
    root = corpus / "rs274_expected" / PLACE
    names = {re.sub(r"(/|\.)expected$", "", p.relative_to(root).as_posix()) for p in root.rglob("*") if p.is_file()}
    listed = {c.name for c in CASES} | set(EXCLUDED) | set(NO_PROGRAM)
    return sorted(names - listed) + sorted(listed - names)


def verdict(case, shown, options):
    """What is wrong with the result, given what is known."""
    known = case.referee if options.referee else KNOWN_FAILURES.get(case.name, "")
    if shown and not known:
        return "fails"
    if not shown and known:
        return "passes, but is listed as a known failure"
    return ""


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("-v", action="store_true", dest="verbose")
    parser.add_argument("--referee", action="store_true")
    return parser.parse_args()


def main():
    options = arguments()
    corpus = options.shared / "corpus"
    if not corpus.is_dir() or (options.referee and not runner.REFEREE_HERE):
        print("skipped: needs ../shared" if not corpus.is_dir() else "skipped: needs rs274 of LinuxCNC")
        return 77
    faults = [f"{name}: neither case nor reason, or no expected file" for name in all_named(corpus)]
    matched = 0
    cases = [c for c in CASES if not options.names or any(n in c.name for n in options.names)]
    for case in cases:
        shown = differences(case, options, corpus)
        matched += not shown
        fault = verdict(case, shown, options)
        if fault:
            faults.append(f"{case.name}: {fault}")
        if shown:
            reason = case.referee if options.referee else KNOWN_FAILURES.get(case.name, "")
            print(f"{case.name}: differs" + (f" (known: {reason})" if reason else ""))
            if options.verbose:
                print("".join(f"    {line}\n" for line in shown[:15]), end="")
    for name, reason in EXCLUDED.items():
        print(f"excluded: {name}: {reason}")
    print("no program at hand: " + " ".join(NO_PROGRAM))
    print(f"{matched} matched / {len(cases)} to be matched / {len(EXCLUDED)} excluded, {len(NO_PROGRAM)} without program")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
