#!/usr/bin/env python3
"""What scripts rely on in the JSON of `obrys time`: causes, tools and lines each add up to the total, of every example.

usage: time_test.py OBRYS EXAMPLES
"""
import json
import pathlib
import subprocess
import sys

EXACT = 1e-9  # s


def faults_of(job, told):
    total = told["total_s"]
    sums = {
        "causes": sum(told["causes"].values()),
        "tools": sum(t["seconds"] for t in told["tools"]),
        "by_line": sum(line["seconds"] for line in told["by_line"]),
        "causes of by_line": sum(sum(line["causes"].values()) for line in told["by_line"]),
    }
    faults = [f"{job}: {name} are {value} s of {total} s" for name, value in sums.items() if abs(value - total) > EXACT]
    if total <= 0 or told["moves"] == 0:
        faults.append(f"{job}: {told['moves']} moves take {total} s")
    low, high = told["range_s"]
    if not low <= total <= high:
        faults.append(f"{job}: {total} s do not lie between {low} and {high}")
    if [line["seconds"] for line in told["by_line"]] != sorted((line["seconds"] for line in told["by_line"]), reverse=True):
        faults.append(f"{job}: the slowest line is not the first")
    if not told["assumed"]:
        faults.append(f"{job}: nothing is assumed of a machine that says nothing of its jerk")
    return faults


def main():
    obrys, examples = sys.argv[1], pathlib.Path(sys.argv[2])
    faults, jobs = [], sorted(examples.glob("*/*.job.toml"))
    for job in jobs:
        run = subprocess.run([obrys, "time", job, "--format", "json"], capture_output=True, text=True)
        if run.returncode not in (0, 1, 3):
            faults.append(f"{job}: exit code {run.returncode}: {run.stderr}")
            continue
        faults += faults_of(job.name, json.loads(run.stdout))
    for fault in faults:
        print(fault)
    print(f"{len(jobs)} jobs, {len(faults)} faults")
    return 1 if faults or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
