#!/usr/bin/env python3
"""All Klartext programs of the corpus: each is read fully and checked without crash or hang; prints a table.

usage: klartext.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing

A file counts as read fully when the reader has nothing to complain about and no unknown word stands in what was run; as
run to its end when neither an alarm nor a limit ended it. A fault is a file that is not read fully, a crash, a hang.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

NOT_READ = {"syntax", "unknown-word", "unclosed"}
ALARMS = {"arithmetic", "value-range", "missing-label", "arc-radius", "compensation", "program-alarm", "type-mismatch"}
SECONDS, BUDGET = 60, 5


def check(obrys, path, job):
    """Checks through a job file that ends endless programs soon."""
    job.write_text(f"program = {json.dumps(path.resolve().as_posix())}\n[budget]\nseconds = {BUDGET}\n")
    try:
        done = subprocess.run([obrys, "check", str(job), "--format", "json"], capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, f"no end within {SECONDS} s"
    if done.returncode not in (0, 1, 3):
        return None, f"exit {done.returncode}: {done.stderr.decode(errors='replace')[:200]}"
    return json.loads(done.stdout), None


def main():
    obrys, corpus = sys.argv[1], pathlib.Path(sys.argv[2]) / "corpus/klartext"
    if not corpus.is_dir():
        print("skipped: needs ../shared")
        return 77
    faults, words = [], collections.Counter()
    total = read_fully = ran = blocks = moves = 0
    print(f"{'file':58}{'verdict':20}{'blocks':>8}{'moves':>8}  not run, or ended by")
    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder) / "case.job.toml"
        for path in sorted(p for p in corpus.rglob("*") if p.is_file()):
            name = path.relative_to(corpus).as_posix().replace("aamorim1913__AptPostProcessor/tests/", "…/")
            result, fault = check(obrys, path, job)
            total += 1
            if fault:
                faults.append(f"{name}: {fault}")
                continue
            codes = {n["code"] for n in result["unchecked"]}
            found = {f["code"] for f in result["findings"]}
            read_fully += not codes & NOT_READ
            if codes & NOT_READ:
                faults.append(f"{name}: not read fully: " +
                              "; ".join(n["message"] for n in result["unchecked"] if n["code"] in NOT_READ))
            ran += not found & ALARMS and "budget" not in codes
            not_run = collections.Counter(n["message"].split(" is ")[0].strip('"')[:24] for n in result["unchecked"]
                                          if n["code"] in ("unsupported", "unknown-word"))
            words.update(not_run.keys())
            stats = result["stats"]
            blocks, moves = blocks + stats["blocks_executed"], moves + stats["moves"]
            ended = sorted(found & ALARMS) + (["budget"] if "budget" in codes else [])
            print(f"{name:58.57}{result['verdict']:20}{stats['blocks_executed']:8}{stats['moves']:8}  "
                  + ", ".join(sorted(not_run) + ended))
    print(f"{total} files: {read_fully} read fully, {ran} run to their end; {blocks} blocks, {moves} moves")
    print("words not run (files): " + (", ".join(f"{w} {n}" for w, n in words.most_common(10)) or "none"))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
