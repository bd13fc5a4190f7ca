#!/usr/bin/env python3
"""The jobs of ../shared/corpus/cnc through every post: what became of each, as a table.

usage: corpus_test.py OBRYS POSTS SHARED [--table]      exit 77 (skipped) where SHARED is missing

  mapped     written in the target's own words and run again: the same
  expanded   the same, some of it (cycles, planes, zeros) by its moves
  refused    something is not written, or not run again the same: each time with its name and record
  not read   the file itself holds what is not run (probing, coolant through the tool …): each time with its name and record
  no reader  the post's control is none that can be read, so that nothing is compared

None may be silently different: what does not do the same has an error that names a record.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

KINDS = ["mapped", "expanded", "refused", "not read", "no reader"]
# Jobs whose own records are not all run, by what is said of them.
NOT_RUN = {
    "Sub spindle/": "spindle 1 is not run",
    "Probing/": "it probes",
    "Coolant Codes/air": "coolant ",
    "Coolant Codes/suction": "suction",
    "Coolant Codes/through tool": "coolant through the tool",
    "Coolant Codes/flood and through": "coolant through the tool",
    "Drilling/back boring": "back-boring",
    "Drilling/circular mill": "circular-pocket-milling",
    "Drilling/thread mill": "thread-milling",
    "Turning/profile with compensation": "compensation of a turning tool's nose",
}


def call(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=120)
    return done.returncode, done.stdout, done.stderr


def reason_of(job):
    return next((text for part, text in NOT_RUN.items() if part in job), None)


def fate(obrys, path, post, read_back, ledger):
    """What became of the job, and what is wrong with that."""
    ledger.unlink(missing_ok=True)
    code, _, said = call(obrys, "translate", path, "--to", post, "-o", ledger.with_suffix(".out"), "--force", "--accept-loss",
                         "--ledger", ledger)
    errors = [line for line in said.splitlines() if re.search(r": error: .*\[[a-z-]+\]$", line)]
    # A record of the job is named, or the post that is none for such a machine.
    placed = [line for line in errors if re.search(r"(\.cnc:\d+:\d+: error: |\.toml:1:1: error: this post is for mills)", line)]
    job = path.as_posix()
    if reason_of(job) is not None:
        return "not read", [] if code != 0 else ["what its reader did not run is said to be the same"]
    if not read_back:
        return "no reader", [] if code == 3 or placed else [f"exit code {code}"]
    if code == 0:
        entries = json.loads(ledger.read_text(encoding="utf-8"))["entries"]
        expanded = any(e["fate"] != "mapped" for e in entries)
        return ("expanded" if expanded else "mapped"), errors
    return "refused", [] if placed else [f"exit code {code} and no error that names a record: {said[-300:]}"]


def main():
    obrys, posts, shared = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    corpus = shared / "corpus/cnc/Autodesk__cam-posteditor"
    if not corpus.is_dir():
        print(f"skipped: {corpus} is missing")
        return 77
    jobs, faults = sorted(corpus.rglob("*.cnc")), []
    names = sorted(p.stem for p in posts.glob("*.toml") if p.stem != "iso")
    for job in jobs:
        code, _, said = call(obrys, "run", job)
        reason = reason_of(job.as_posix())
        if code != (0 if reason is None else 3) or (reason is not None and reason not in said):
            faults.append(f"{job.relative_to(corpus)}: run says {code}\n{said[-600:]}")
    table = collections.defaultdict(collections.Counter)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        ledger = pathlib.Path(folder) / "ledger.json"
        for job in jobs:
            row = []
            for post in names:
                kind, wrong = fate(obrys, job, post, post != "canon", ledger)
                table[post][kind] += 1
                row.append(kind)
                faults += [f"{job.relative_to(corpus)} by {post}: {w}" for w in wrong]
            rows.append((job.relative_to(corpus).with_suffix(""), row))
    print(f"{'post':24}" + "".join(f"{k:>11}" for k in KINDS))
    for post in names:
        print(f"{post:24}" + "".join(f"{table[post][k]:11}" for k in KINDS))
    if "--table" in sys.argv:
        print("\n" + " " * 44 + " ".join(names))
        for job, row in rows:
            print(f"{str(job):44}" + " ".join(f"{k:{len(n)}}" for n, k in zip(names, row)))
    print("\n".join(faults) or f"{len(jobs)} jobs by {len(names)} posts: none silently different")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
