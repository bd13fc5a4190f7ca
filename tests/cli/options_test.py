#!/usr/bin/env python3
"""Every option that a command takes stands in the manual page and in docs/command-line.md, and no other one does;
the machines of the folder beside DOCS are named wherever shipped ones are listed.

usage: options_test.py OBRYS DOCS
"""
import pathlib
import re
import subprocess
import sys

OPTION = re.compile(r"(?<![\w-])--?[a-z0-9][a-z0-9-]*")
EVERYWHERE = {"-h", "--help", "--help-all", "--version"}


def taken(obrys, command):
    text = subprocess.run([obrys, *command.split(), "--help"], capture_output=True, text=True, check=True).stdout
    found = set()
    for line in text.split("\n"):
        if re.match(r"\s+-", line):  # what it takes stands in the first column, its description behind two blanks
            found |= set(OPTION.findall(re.split(r"\s{2,}", line.strip())[0]))
    return found - EVERYWHERE


def main():
    obrys, docs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    all_taken = set().union(*(taken(obrys, command) for command in ("check", "run", "plot", "fmt", "translate", "compare", "sheet", "time", "make", "calibrate", "data", "cost", "blade", "force",
                                                             "post list", "post new", "post check", "post preview")))
    faults = [] if len(all_taken) > 30 else [f"only {len(all_taken)} options were found in the help texts"]
    for name, begins in (("obrys.1.in", r"\.BI? \"(.*)"), ("command-line.md", r"\| (`-[^|]*)")):
        text = (docs / name).read_text(encoding="utf-8").replace("\\-", "-").replace("\\fR, \\fB", ", ")
        said = {option for entry in re.findall(begins, text) for option in OPTION.findall(entry)} - EVERYWHERE
        faults += [f"{name} does not say {option}" for option in sorted(all_taken - said)]
        faults += [f"{name} says {option}, which no command takes" for option in sorted(said - all_taken)]
    machines = ", ".join(sorted(file.stem for file in (docs.parent / "machines").glob("*.toml")))
    for name in ("obrys.1.in", "command-line.md", "job-file.md", "machine-file.md"):
        text = (docs / name).read_text(encoding="utf-8").replace("`", "").replace("\\-", "-")
        lists = re.findall(r"shipped (?:machine|name) \(([^)]*)\)", text)
        faults += [f"{name} names as shipped machines {said}, not {machines}" for said in lists if said != machines]
        faults += [f"{name} does not name the machine {m}" for m in machines.split(", ") if m not in text]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
