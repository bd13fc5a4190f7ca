#!/usr/bin/env python3
"""LinuxCNC's interpreter tests: does `obrys run --canon` print the expected canonical calls?

usage: canon.py OBRYS SHARED [-v] [--referee] [NAME...]      exit 77 (skipped) where SHARED is missing

Compared are all lines of standard output: same calls, same order, coordinates as printed; only the counter in front of a line
is left out. With --referee LinuxCNC's own rs274 is held to the files, which tests this comparison; OBRYS may be "-" then.
"""
import dataclasses
import difflib
import pathlib
import re
import sys
import tempfile

import endpoint
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
    if case.no_minus_zero:
        lines = [line.replace("-0.0000", "0.0000") for line in lines]
    return lines


def unsigned_zeros(lines):
    """A coordinate of zero has no sign worth comparing."""
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


def numbers_only(lines):
    """Calls as they are; of what the program says the numbers. For programs of our own, whose words are ours."""
    kept = []
    for line in lines:
        call = re.match(r" ?N\S* *([A-Z_0-9.]+)\(", line)
        if call and call[1] not in ("COMMENT", "MESSAGE") or "interpreter: " in line:
            kept.append(line)
        elif not call or call[1] == "MESSAGE":
            numbers = re.findall(r"-?[0-9]+\.[0-9]{4,}", line)
            kept += [f"says {' '.join(numbers)}"] if numbers else []
    return kept


def without(lines, patterns):
    return [line for line in lines if not any(re.fullmatch(p, line) or re.fullmatch(p, line.strip()) for p in patterns)]


def expected_lines(text, case, part):
    lines = runner.calls(text)
    if part.nth:
        starts = [n for n, line in enumerate(lines[:-1]) if "USE_LENGTH_UNITS" in line and "SET_G5X_OFFSET" in lines[n + 1]] + [None]
        lines = lines[starts[part.nth - 1]:starts[part.nth]]
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
    folder = corpus / part.place / PLACE / case.name
    with tempfile.TemporaryDirectory() as own:
        path, setting = folder / part.program, part.setting
        if part.text:   # our program is elsewhere: the folder of subroutines is named in full
            path = pathlib.Path(own) / part.program
            path.write_text(part.text)
            if setting.search:
                setting = dataclasses.replace(setting, search=str((folder / setting.search).resolve()))
        run = runner.run_referee(path, setting, 5) if options.referee else runner.run_obrys(
            options.obrys, path, setting, SECONDS)
    if run.code is None:
        return [], f"{part.program}: no end in time"
    if run.code < 0 or run.code > 100:
        return [], f"{part.program}: exit {run.code}: {run.err[:200]}"
    lines = viewed(run.out, case)
    # obrys also says "not fully checked" (exit 3) of runs that come to their end.
    refused = run.code != 0 if options.referee else endpoint.refusal(run.err) is not None
    wanted = "refused" if part.refused else "accepted"
    fault = "" if refused == part.refused else (
        f"{part.program}: exit {run.code}, to be {wanted}: {run.refused or endpoint.first_error(run.err)}")
    return as_of_2_10(lines) if options.referee else lines, fault


def differences(case, options, corpus):
    """Lines to show, none when the case agrees; and how many numbers differ in their last digit or in the sign of zero."""
    expected = corpus / "rs274_expected" / PLACE / f"{case.name}{'.' if case.name.endswith('.ngc') else '/'}expected"
    text = expected.read_text()
    shown, loose = [], 0
    for part in case.parts:
        lines, fault = run_part(case, part, options, corpus)
        lines, wanted = without(lines, case.drop), without(expected_lines(text, case, part), case.drop)
        if case.own_words:
            wanted, lines = numbers_only(wanted), numbers_only(lines)
        shown += [fault] if fault else []
        ties = None if options.referee else same_but_ties(unsigned_zeros(wanted), unsigned_zeros(lines))
        if ties is None:
            shown += difflib.unified_diff(wanted, lines, "expected", "printed", lineterm="", n=1)
        else:
            loose += max(ties, sum(a != b for a, b in zip(wanted, lines)))
    return shown, loose


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


def main():
    options = runner.arguments("--referee")
    corpus = options.shared / "corpus"
    if not corpus.is_dir() or (options.referee and not runner.REFEREE_HERE):
        print("skipped: needs ../shared" if not corpus.is_dir() else "skipped: needs rs274 of LinuxCNC")
        return 77
    faults = [f"{name}: neither case nor reason, or no expected file" for name in all_named(corpus)]
    matched = exact = 0
    cases = [c for c in CASES if not options.names or any(n in c.name for n in options.names)]
    for case in cases:
        shown, loose = differences(case, options, corpus)
        matched += not shown
        exact += not shown and not loose
        if loose and not shown:
            print(f"{case.name}: {loose} numbers differ by one in their last digit, or by the sign of zero")
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
    for name, reason in NO_PROGRAM.items():
        print(f"no program at hand: {name}: {reason}")
    print(f"{matched} matched / {len(cases)} to be matched / {len(EXCLUDED)} excluded, {len(NO_PROGRAM)} without program")
    print(f"to the last digit and sign of zero: {exact}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
