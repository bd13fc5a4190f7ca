#!/usr/bin/env python3
"""SARIF of obrys: what code hosts need of it, and the standard's own schema.

usage: sarif_test.py rules|schema <obrys> <examples>

`schema` holds the logs to sarif-subset.schema.json, the standard's objects as far as obrys writes them, by a checker of its
own; and to the standard's whole schema where that is at hand: sarif-schema-2.1.0.json (OASIS), named in
OBRYS_SARIF_SCHEMA, in a folder of NODE_PATH or beside the repository, by python's jsonschema.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import json_schema

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
            if not rule["help"]["text"] or not re.match(r"(https?|file)://.*#" + rule["id"] + "$", rule["helpUri"]):
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


# The properties that SARIF 2.1.0 (OASIS, chapter 3) gives its objects, of those that obrys writes: (required, others).
OBJECTS = {
    "log": ("version runs", "$schema"),
    "run": ("tool", "results invocations originalUriBaseIds columnKind properties"),
    "tool": ("driver", ""),
    "driver": ("name", "version rules"),
    "rule": ("id", "shortDescription help helpUri defaultConfiguration"),
    "invocation": ("executionSuccessful", "toolExecutionNotifications"),
    "result": ("message", "ruleId ruleIndex level locations codeFlows relatedLocations occurrenceCount partialFingerprints "
                          "baselineState properties"),
    "location": ("", "id physicalLocation message"),
    "physicalLocation": ("artifactLocation", "region"),
    "artifactLocation": ("", "uri uriBaseId description"),
    "region": ("startLine startColumn endLine endColumn", "snippet"),
}


def shape(kind, thing, where):
    required, others = (set(words.split()) for words in OBJECTS[kind])
    if not required <= set(thing) <= required | others:
        yield f"{where}: {kind} has {sorted(thing)}"


def location_shapes(location):
    yield from shape("location", location, "")
    physical = location["physicalLocation"]
    yield from shape("physicalLocation", physical, "")
    yield from shape("artifactLocation", physical["artifactLocation"], "")
    if "region" in physical:
        region = physical["region"]
        yield from shape("region", region, "")
        numbers = [region[k] for k in ("startLine", "startColumn", "endLine", "endColumn")]
        if min(numbers) < 1 or numbers[:2] > numbers[2:]:
            yield f"region {numbers}"


def shapes(log):
    yield from shape("log", log, "")
    for run in log["runs"]:
        yield from shape("run", run, "")
        yield from shape("tool", run["tool"], "")
        yield from shape("driver", run["tool"]["driver"], "")
        for rule in run["tool"]["driver"]["rules"]:
            yield from shape("rule", rule, rule["id"])
        for invocation in run["invocations"]:
            yield from shape("invocation", invocation, "")
        for base in run.get("originalUriBaseIds", {}).values():
            yield from shape("artifactLocation", base, "")
            if not base.get("uri", "file:///").startswith("file:///") or not base.get("uri", "/").endswith("/"):
                yield f"base {base}"
        for r in run["results"]:
            yield from shape("result", r, r["ruleId"])
            if r["level"] not in ("error", "warning", "note") or not r["message"]["text"] or r["occurrenceCount"] < 1:
                yield f"result {r['ruleId']}"
            if r.get("baselineState", "new") not in ("new", "unchanged"):
                yield f"baselineState {r['baselineState']}"
            flows = [step["location"] for flow in r.get("codeFlows", []) for thread in flow["threadFlows"] for step in thread["locations"]]
            for location in [*r["locations"], *r.get("relatedLocations", []), *flows]:
                yield from location_shapes(location)


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


def judges_at_hand():
    own = json.loads((pathlib.Path(__file__).resolve().parent / "sarif-subset.schema.json").read_text(encoding="utf-8"))
    yield lambda log: json_schema.faults(own, log)
    schema = find_schema()
    try:
        import jsonschema  # pylint: disable=import-outside-toplevel
    except ImportError:
        jsonschema = None
    if schema is None or jsonschema is None:
        print(f"not held to the whole schema: needs {NAME} (OBRYS_SARIF_SCHEMA names it) and python's jsonschema")
        return
    judge = jsonschema.Draft7Validator(json.loads(schema.read_text(encoding="utf-8")))
    yield lambda log: (f"{list(e.absolute_path)} {e.message}" for e in judge.iter_errors(log))


def main():
    what, obrys, examples = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve()), pathlib.Path(sys.argv[3]).resolve()
    failed = False
    if what == "rules":
        for words, log in logs(obrys, examples):
            inputs = [w for i, w in enumerate(words) if not w.startswith("-") and (i == 0 or not words[i - 1].startswith("-"))]
            if len(log["runs"]) != len(inputs):
                print(words, f"{len(log['runs'])} runs")
                failed = True
            for problem in [*shapes(log), *problems(log)]:
                print(words, problem)
                failed = True
        return 1 if failed else 0
    judges = list(judges_at_hand())
    for words, log in logs(obrys, examples):
        for judge in judges:
            for fault in judge(log):
                print(words, fault)
                failed = True
    spoilt = {"version": "2.1.0", "runs": [{"tool": {"driver": {"name": "x"}}, "results": [{"level": "bad"}]}]}
    if len(list(judges[0](spoilt))) != 2:
        print("the checker does not see what is wrong")
        failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
