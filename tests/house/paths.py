#!/usr/bin/env python3
"""No project file names a path of one machine, or a host from which packages come.

usage: paths.py <project>
"""
import pathlib
import re
import subprocess
import sys

# Built from pieces, so that this file passes its own test.
ROOTS = ["work", "root", "home", "tmp", "mnt", "Users"]
PATH = re.compile(r"(?<![\w.)}>\]/*-])/(?:" + "|".join(ROOTS) + r")/[\w.]")
HOST = re.compile(r"\b(?:" + "|".join(["deb", "security"]) + r")\.debian\.org|\bpypi\.org|registry\.npmjs\b")
SKIPPED = ("build/", "fuzz/corpus/")


def project_files(project):
    """What git would commit; in an unpacked archive without git, every file outside build."""
    listed = subprocess.run(["git", "-C", str(project), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        return [n for n in listed.stdout.split("\0") if n]
    return [f.relative_to(project).as_posix() for f in project.rglob("*") if f.is_file()]


def main():
    project = pathlib.Path(sys.argv[1])
    complaints, read = [], 0
    for name in sorted(project_files(project)):
        file = project / name
        if name.startswith(SKIPPED) or not file.is_file():
            continue
        read += 1
        for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            for pattern in (PATH, HOST):
                match = pattern.search(line)
                if match:
                    complaints.append(f"{name}:{number}: {match.group()}")
    for complaint in complaints:
        print(complaint)
    print(f"{read} files read, {len(complaints)} complaints")
    return 1 if complaints or not read else 0


if __name__ == "__main__":
    sys.exit(main())
