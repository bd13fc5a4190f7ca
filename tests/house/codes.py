#!/usr/bin/env python3
"""Every diagnostic code is documented, and produced by at least one golden case.

usage: codes.py <project>

Codes come from the table in src/base/codes.hpp; docs/diagnostics.md names each at the start of a heading or table row;
a golden case produces one by printing `[code]`, or `"code": "…"` / `"ruleId": "…"` in JSON. tests/house/codes_pending.txt
lists codes whose case is still to be written; a code that no longer belongs there is a failure too.
"""
import pathlib
import re
import sys


def declared(text):
    constants = dict(re.findall(r'string_view\s+(\w+)\s*=\s*"([^"]+)"', text))
    listed = re.findall(r"Code\{codes::(\w+)\s*,", text)
    return constants, {constants[name] for name in listed if name in constants}


def produced(golden):
    found = set()
    for file in sorted(golden.rglob("*.txt")):
        shown = re.split(r"^--- (?:out|err)[^\n]*\n", file.read_text(encoding="utf-8"), flags=re.M)[1:]
        for section in shown:
            section = re.split(r"^--- ", section, flags=re.M)[0]
            found.update(re.findall(r"\[([a-z]+(?:-[a-z]+)*)\]", section))
            found.update(re.findall(r'"(?:code|ruleId)":\s*"([a-z-]+)"', section))
    return found


def main():
    project = pathlib.Path(sys.argv[1])
    constants, table = declared((project / "src/base/codes.hpp").read_text())
    page = project / "docs/diagnostics.md"
    documented = set(re.findall(r"^(?:#+|\|)\s*`([a-z-]+)`", page.read_text(), re.M)) if page.is_file() else set()
    pending_file = project / "tests/house/codes_pending.txt"
    pending = set(pending_file.read_text().split()) if pending_file.is_file() else set()
    made = produced(project / "tests/golden")

    complaints = [f"{c}: declared, but not in all_codes" for c in sorted(set(constants.values()) - table)]
    complaints += [f"{c}: not documented in docs/diagnostics.md" for c in sorted(table - documented)]
    rows = re.findall(r"^\| `([a-z-]+)` \|", page.read_text(), re.M) if page.is_file() else []
    complaints += [f"{c}: {rows.count(c)} rows in docs/diagnostics.md" for c in sorted(set(rows)) if rows.count(c) > 1]
    complaints += [f"{c}: documented, but no such code" for c in sorted(documented - table)]
    complaints += [f"{c}: no golden case produces it" for c in sorted(table - made - pending)]
    complaints += [f"{c}: pending, but no longer missing" for c in sorted(pending & made | pending - table)]
    for complaint in complaints:
        print(complaint)
    print(f"{len(table)} codes, {len(table & documented)} documented, {len(table & made)} produced, {len(pending)} pending")
    return 1 if complaints or not table else 0


if __name__ == "__main__":
    sys.exit(main())
