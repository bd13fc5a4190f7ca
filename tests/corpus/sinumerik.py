#!/usr/bin/env python3
"""All SINUMERIK programs of the corpus: each is read and checked without crash or hang; prints a table.

usage: sinumerik.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing

A file counts as read fully when the reader has nothing to complain about and no unknown word stands in what was run; as
run to its end when neither an alarm nor a limit ended it.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

ALARMS = {"arithmetic", "type-mismatch", "index-range", "value-range", "duplicate-name", "missing-label", "bad-argument",
          "arc-radius", "program-alarm"}
SECONDS = 60
BUDGET = 2


def check(obrys, path, job):
    """Checks through a job file that ends endless programs soon."""
    job.write_text(f"program = {json.dumps(path.resolve().as_posix())}\n[budget]\nseconds = {BUDGET}\n")
    try:
        done = subprocess.run([obrys, "check", str(job), "--format", "json"], capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, f"{path.name}: no end within {SECONDS} s"
    if done.returncode not in (0, 1, 2, 3):
        return None, f"{path.name}: exit {done.returncode}"
    if done.returncode == 2:
        return {"verdict": "unreadable", "unchecked": [], "findings": []}, None
    return json.loads(done.stdout), None


def word(note):
    """The word a message names first, quotes and "is not run" off."""
    return note["message"].split(" is not ")[0].strip('"')


def main():
    obrys, corpus = sys.argv[1], pathlib.Path(sys.argv[2]) / "corpus/sinumerik"
    if not corpus.is_dir():
        print("skipped: needs ../shared")
        return 77
    faults, verdicts, words = [], collections.Counter(), collections.Counter()
    total = read_fully = ran = no_syntax = made_wrong = 0
    folder = tempfile.TemporaryDirectory()
    job = pathlib.Path(folder.name) / "case.job.toml"
    for path in sorted(p for p in corpus.rglob("*") if p.is_file()):
        result, fault = check(obrys, path, job)
        total += 1
        made_wrong += path.name.startswith("syntax_test")
        if fault:
            faults.append(fault)
            continue
        verdicts[result["verdict"]] += 1
        codes = {n["code"] for n in result["unchecked"]}
        found = {f["code"] for f in result["findings"]}
        no_syntax += not codes & {"syntax", "unclosed"}
        read_fully += not codes & {"syntax", "unclosed", "unknown-word"}
        ran += not found & ALARMS and "budget" not in codes
        words.update({word(n) for n in result["unchecked"] if n["code"] in ("unsupported", "unknown-word")})
    folder.cleanup()
    print(f"{total} files ({made_wrong} of them syntax tests with mistakes made on purpose): {no_syntax} without a syntax "
          f"error, {read_fully} read fully, {ran} run to an end")
    print("verdicts: " + ", ".join(f"{n} {v}" for v, n in verdicts.most_common()))
    print("most frequent words not run (files): " + ", ".join(f"{w} {n}" for w, n in words.most_common(10)))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
