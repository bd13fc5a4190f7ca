#!/usr/bin/env python3
"""SARIF of obrys: what code hosts need of it, and the standard's own schema.

usage: sarif_test.py rules|schema <obrys> <examples>

`schema` takes sarif-schema-2.1.0.json (OASIS) from the file named in OBRYS_SARIF_SCHEMA, from a folder of NODE_PATH or
from beside the repository, and python's jsonschema; it is skipped (77) where one of them is missing.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM = "N10 FOO\nN20 G0 X10 Z5\nN30 G1 X20 F0.1\nN40 SETAL(65000)\nN50 M30\n"
NAME = "sarif-schema-2.1.0.json"


def logs(obrys, examples):
    """SARIF logs of all kinds of results."""
    groove = str(examples / "groove" / "groove_wrong.job.toml")
    with tempfile.TemporaryDirectory(prefix="obrys-sarif") as folder:
        (pathlib.Path(folder) / "a b.MPF").write_text(PROGRAM, encoding="utf-8")
        calls = (["a b.MPF"], ["a b.MPF", "no such.MPF"], [groove], [groove, "--all"], [groove, "--write-baseline", "k"],
                 [groove, "--baseline", "k"])
        for words in calls:
            done = subprocess.run([obrys, "check", *words, "--format", "sarif"], cwd=folder, capture_output=True, text=True, check=False)
            yield words, json.loads(done.stdout)


def problems(log):
    for run in log["runs"]:
        rules = run["tool"]["driver"]["rules"]
        for rule in rules:
            if not rule["help"]["text"] or not re.match(r"[a-z]+:", rule["helpUri"]):
                yield f"rule {rule['id']} has no help"
        for r in run["results"]:
            if rules[r["ruleIndex"]]["id"] != r["ruleId"]:
                yield "ruleIndex"
            if not r["locations"]:
                yield f"{r['ruleId']} has no location"
            for at in r["locations"]:
                place = at["physicalLocation"]["artifactLocation"]
                if place["uri"].startswith("/") or " " in place["uri"]:
                    yield f"uri {place['uri']}"
                if not place["uri"].startswith("file:") and place.get("uriBaseId") not in run["originalUriBaseIds"]:
                    yield f"{place['uri']} has no base"
            if not all(r["partialFingerprints"].values()):
                yield f"{r['ruleId']} has no fingerprint"
        prints = [json.dumps(r["partialFingerprints"]) for r in run["results"] if "move" not in r.get("properties", {})]
        if len(prints) != len(set(prints)):
            yield "fingerprints are not unique"


def find_schema():
    here = pathlib.Path(__file__).resolve()
    folders = [pathlib.Path(p) for p in os.environ.get("NODE_PATH", "").split(os.pathsep) if p]
    named = os.environ.get("OBRYS_SARIF_SCHEMA")
    if named:
        return pathlib.Path(named)
    for folder in [*folders, here.parents[2].parent / "shared"]:
        for found in folder.rglob(NAME):
            return found
    return None


def main():
    what, obrys, examples = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve()), pathlib.Path(sys.argv[3]).resolve()
    failed = False
    if what == "rules":
        for words, log in logs(obrys, examples):
            for problem in problems(log):
                print(words, problem)
                failed = True
        return 1 if failed else 0
    schema = find_schema()
    try:
        import jsonschema  # pylint: disable=import-outside-toplevel
    except ImportError:
        jsonschema = None
    if schema is None or jsonschema is None:
        print(f"skipped: needs {NAME} (OBRYS_SARIF_SCHEMA names it) and python's jsonschema")
        return 77
    judge = jsonschema.Draft7Validator(json.loads(schema.read_text(encoding="utf-8")))
    for words, log in logs(obrys, examples):
        for error in judge.iter_errors(log):
            print(words, list(error.absolute_path), error.message)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
