#!/usr/bin/env python3
"""What scripts rely on in the JSON of `obrys time`: causes, tools and lines each add up to the total, of every example.

usage: time_test.py OBRYS EXAMPLES
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

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
    if not told["values"] or any(not value["origin"] for value in told["values"]):
        faults.append(f"{job}: a value has no origin: {told['values']}")
    if {value["name"] for value in told["assumed"]} - {value["name"] for value in told["values"]}:
        faults.append(f"{job}: something is assumed that is no value")
    if not told["assumed"]:
        faults.append(f"{job}: nothing is assumed of a machine that says nothing of its jerk")
    return faults


def faults_of_plot(obrys, job):
    """The plot is XML, its speeds end where the time does, and the ten slowest lines are named."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "time.svg"
        run = subprocess.run([obrys, "time", job, "--svg", file, "--format", "json"], capture_output=True, text=True)
        told = json.loads(run.stdout)
        root = xml.etree.ElementTree.fromstring(file.read_text())
        texts = [t.text or "" for t in root.iter("{http://www.w3.org/2000/svg}text")]
        named = [t for t in texts if any(f":{line['line']}: " in t for line in told["by_line"][:10])]
        paths = [p.get("d") for p in root.iter("{http://www.w3.org/2000/svg}path") if p.get("class") in ("speed", "line")]
        faults = [] if len(paths) == 2 else [f"{job}: {len(paths)} curves"]
        for d in paths:  # both curves come to the right end of their box
            if max(float(x) for x in re.findall(r"[HL](\d+\.\d)", d)) < 979:
                faults.append(f"{job}: a curve ends early")
        if len(named) < min(10, len(told["by_line"])):
            faults.append(f"{job}: {len(named)} lines are named")
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
    faults += faults_of_plot(obrys, jobs[0])
    for fault in faults:
        print(fault)
    print(f"{len(jobs)} jobs, {len(faults)} faults")
    return 1 if faults or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
