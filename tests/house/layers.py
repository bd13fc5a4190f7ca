#!/usr/bin/env python3
"""Holds every #include of the house to the folders' declared uses.

usage: layers.py <layers.txt> <src>

layers.txt has a line "folder: used used ..." for each folder, bottom to top (CMake writes it). Complains, with file and
line, about an include of a folder that is not declared, of a file that does not exist, and of a file in no folder.
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def read_layers(path):
    """The declared uses of each folder, and complaints about their order."""
    uses, complaints = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip():
            continue
        folder, _, rest = line.partition(":")
        for used in rest.split():
            if used not in uses:
                complaints.append(f"{path.name}:{number}: {folder} uses {used}, which does not stand below it")
        uses[folder.strip()] = rest.split()
    return uses, complaints


def folder_of(file, uses):
    """The folder of the house in which a file (path relative to src) stands; None where there is none."""
    parent = file.parent.as_posix()
    return parent if parent in uses else None


def check_file(file, src, uses):
    relative = file.relative_to(src)
    home = folder_of(relative, uses)
    if home is None:
        return [f"{relative}:1: stands in no declared folder"]
    complaints = []
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quoted, angled = match.groups()
        target = quoted or angled
        folder = folder_of(pathlib.PurePosixPath(target), uses)
        where = f"{relative}:{number}:"
        if quoted and "/" not in target and (file.parent / target).is_file():
            continue  # a neighbour
        if quoted and not (src / target).is_file():
            complaints.append(f'{where} "{target}" does not exist (includes are written from src)')
        elif angled and folder:
            complaints.append(f'{where} <{target}> is our own: write "{target}"')
        elif folder and folder != home and folder not in uses[home]:
            complaints.append(f"{where} {home} includes {target}, but does not declare that it uses {folder}")
    return complaints


def main():
    layers, src = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    uses, complaints = read_layers(layers)
    files = sorted(f for f in src.rglob("*") if f.suffix in (".hpp", ".cpp", ".inc"))
    for file in files:
        complaints += check_file(file, src, uses)
    for complaint in complaints:
        print(complaint)
    print(f"{len(files)} files in {len(uses)} folders, {len(complaints)} complaints")
    return 1 if complaints or not files else 0


if __name__ == "__main__":
    sys.exit(main())
