#!/usr/bin/env python3
"""Random scratches, however narrow, on a finished face: each deeper than the tolerance must be found, with its depth to a tenth of
the tolerance, as one finding of the block that made it; each that is not as deep must not be.

usage: scratches.py OBRYS [--count 40] [--seed 1] [--tolerances 0.05,0.01,0.002]
"""
import argparse
import json
import math
import pathlib
import random as randoms
import subprocess
import sys
import tempfile

import stl_parts

LENGTH, WIDTH, FACE = 60, 40, -1.0


def box(lo, hi):
    corners = [(x, y, z) for z in (lo[2], hi[2]) for x, y in ((lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1]))]
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    return [tuple(corners[i] for i in t) for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]


def facing():
    """The whole face, in rows."""
    lines = ["T1 M6", "G0 G43 H1 Z30", "M3 S3000", "G0 X-20 Y-4", f"G0 Z{FACE}"]
    for n, y in enumerate(range(-4, WIDTH + 8, 4)):
        lines += [f"G1 Y{y}", f"G1 X{-20 if n % 2 else LENGTH + 20}"]
    return lines + ["G0 Z30"]


def write_job(folder, tool, lines, tolerance):
    stl_parts.write(folder / "part.stl", box((0, 0, -20), (LENGTH, WIDTH, FACE)))
    program = ["G21 G90 G17 G40 G94", "F800", *facing(), "T2 M6", "G0 G43 H2 Z30", "M3 S3000", *lines, "G0 Z30", "M2"]
    (folder / "part.ngc").write_text("\n".join(program) + "\n")
    (folder / "part.job.toml").write_text("\n".join([
        'program = "part.ngc"', 'control = "linuxcnc"', 'machine = "mill-generic"',
        "[[tool]]", "number = 1", 'kind = "end-mill"', "diameter = 10.0", "length = 90.0",
        "[[tool]]", "number = 2", "length = 90.0", *tool,
        "[stock]", f"box = {{ min = [0.0, 0.0, -20.0], max = [{LENGTH}.0, {WIDTH}.0, 0.0] }}",
        "[part]", 'file = "part.stl"', "[check]", f"tolerance = {tolerance}"]) + "\n")
    return [n + 1 for n, text in enumerate(program) if text in lines]


def scratch(random, tolerance):
    """Tool, program lines, depth."""
    deep = random.uniform(0.3, 30) * tolerance
    x, y, way, length = random.uniform(5, 55), random.uniform(5, 35), random.uniform(0, 2 * math.pi), random.uniform(0.2, 12)
    to = min(max(x + length * math.cos(way), 3), 57), min(max(y + length * math.sin(way), 3), 37)
    angle = random.choice([30, 60, 90])
    tool = ['kind = "chamfer"', "diameter = 10.0", "tip_diameter = 0.0", f"point_angle = {angle}"]
    lines = [f"G0 X{x:.4f} Y{y:.4f}", "G0 Z0", f"G1 Z{FACE - deep:.6f} F200", f"G1 X{to[0]:.4f} Y{to[1]:.4f} F800"]
    return tool, lines, deep


def judge(obrys, random, tolerance):
    tool, lines, deep = scratch(random, tolerance)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        guilty = write_job(folder, tool, lines, tolerance)
        done = subprocess.run([obrys, "check", "--format", "json", str(folder / "part.job.toml")], capture_output=True, text=True)
    result = json.loads(done.stdout)
    found = result["findings"]
    if deep <= tolerance:
        return f"false alarm at {deep}: {found[0]['message']}" if found else ""
    gouges = [f for f in found if f["code"] == "gouge"]
    if not gouges:
        return f"missed: {deep} deep with {tool[-1]}"
    if len(found) > 1:
        return f"{len(found)} findings of one scratch {deep} deep"
    if abs(gouges[0]["depth_mm"] - deep) > tolerance / 10:
        return f"{gouges[0]['depth_mm']} for a depth of {deep}"
    return "" if gouges[0]["where"]["line"] in guilty else f"blamed line {gouges[0]['where']['line']}, guilty are {guilty}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerances", default="0.05,0.01,0.002")
    options = parser.parse_args()
    failed = 0
    for tolerance in [float(t) for t in options.tolerances.split(",")]:
        complaints = 0
        for number in range(options.count):
            wrong = judge(options.obrys, randoms.Random(f"{options.seed}.{number}"), tolerance)
            if wrong:
                complaints += 1
                print(f"{tolerance} {number}: {wrong}", flush=True)
        print(f"tolerance {tolerance}: {options.count} scratches, {complaints} not judged as they are", flush=True)
        failed += complaints
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
