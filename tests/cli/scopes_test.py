#!/usr/bin/env python3
"""A narrower scope finds nothing that a wider one does not: the findings of "motion" and "collisions" are among those
of "all", by code and place, for every job of the golden cases.

usage: scopes_test.py OBRYS GOLDEN [FOLDER...]
"""
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

SCOPES = ["motion", "collisions", "all"]
SECONDS = 300


def findings(obrys, folder, job, scope):
    """(code, file, line) of every finding; nothing where the job cannot be checked."""
    command = [obrys, "check", job, "--scope", scope, "--format", "json"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False)
    if done.returncode not in (0, 1, 3):
        return None
    found = set()
    report = json.loads(done.stdout)
    for program in report if isinstance(report, list) else report.get("programs", [report]):
        for f in program["findings"]:
            found.add((f["code"], f["where"]["file"], f["where"]["line"]))
    return found


def jobs_of(sections):
    """The jobs that `obrys check` is called with."""
    words = shlex.split(next(s[1] for s in sections if s[0] == "run"))[1:]
    return [w for w in words[1:] if w.endswith(".toml")] if words[:1] == ["check"] else []


def faults_of(golden, obrys, case):
    """How many jobs were compared, and what a narrower scope alone finds in them."""
    sections = golden.parse(case.read_text(encoding="utf-8"))
    compared, faults = 0, []
    for job in jobs_of(sections):
        with tempfile.TemporaryDirectory(prefix="scopes") as name:
            golden.lay_out(sections, pathlib.Path(name))
            by_scope = {s: findings(obrys, name, job, s) for s in SCOPES}
        if None in by_scope.values():
            continue
        compared += 1
        faults += [f"{case} {job}: {narrow} finds {extra}, all does not"
                   for narrow in SCOPES[:-1] for extra in sorted(by_scope[narrow] - by_scope["all"], key=str)]
    return compared, faults


def main():
    obrys, root = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    sys.path.insert(0, str(root))
    import run as golden  # the cases' own reader
    folders = [root / f for f in sys.argv[3:]] or [root]
    jobs, faults = 0, []
    for case in sorted(c for f in folders for c in f.rglob("*.txt")):
        checked, found = faults_of(golden, obrys, case)
        jobs += checked
        faults += found
    print("\n".join(faults))
    print(f"{jobs} jobs, {len(faults)} findings of a narrower scope alone")
    return 1 if faults or jobs == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
