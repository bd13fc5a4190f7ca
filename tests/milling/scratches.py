#!/usr/bin/env python3
"""Random scratches, however narrow, on a finished face: each deeper than the tolerance must be found, with its depth to a tenth of
the tolerance, as one finding of the block that made it; each that is not as deep must not be.

usage: scratches.py OBRYS [--count 40] [--seed 1] [--tolerances 0.05,0.01,0.002]
"""
import argparse
import math
import random as randoms
import sys

import jobs

LENGTH, WIDTH, FACE = 60, 40, -1.0


def facing():
    """The whole face, in rows."""
    lines = ["T1 M6", "G0 G43 H1 Z30", "M3 S3000", "G0 X-20 Y-4", f"G0 Z{FACE}"]
    for n, y in enumerate(range(-4, WIDTH + 8, 4)):
        lines += [f"G1 Y{y}", f"G1 X{-20 if n % 2 else LENGTH + 20}"]
    return lines + ["G0 Z30"]


def write_job(folder, tool, lines, tolerance):
    program = ["G21 G90 G17 G40 G94", "F800", *facing(), "T2 M6", "G0 G43 H2 Z30", "M3 S3000", *lines, "G0 Z30", "M2"]
    tools = [(1, {"kind": "end-mill", "diameter": 10.0, "length": 90.0}), (2, tool)]
    jobs.write(folder, program, tools, ((0, 0, -20), (LENGTH, WIDTH, 0)), jobs.box((0, 0, -20), (LENGTH, WIDTH, FACE)),
               check={"tolerance": tolerance})
    return [n + 1 for n, text in enumerate(program) if text in lines]


def scratch(random, tolerance):
    """Tool, program lines, depth."""
    deep = random.uniform(0.3, 30) * tolerance
    x, y, way, length = random.uniform(5, 55), random.uniform(5, 35), random.uniform(0, 2 * math.pi), random.uniform(0.2, 12)
    to = min(max(x + length * math.cos(way), 3), 57), min(max(y + length * math.sin(way), 3), 37)
    angle = random.choice([30, 60, 90])
    tool = {"kind": "chamfer", "diameter": 10.0, "length": 90.0, "tip_diameter": 0.0, "point_angle": angle}
    lines = [f"G0 X{x:.4f} Y{y:.4f}", "G0 Z0", f"G1 Z{FACE - deep:.6f} F200", f"G1 X{to[0]:.4f} Y{to[1]:.4f} F800"]
    return tool, lines, deep


def judge(obrys, random, tolerance):
    tool, lines, deep = scratch(random, tolerance)
    with jobs.folder_of(None) as folder:
        guilty = write_job(folder, tool, lines, tolerance)
        result = jobs.check(obrys, folder)
    found = result["findings"]
    if result["verdict"] == "none" or result["unchecked"]:
        return f"not checked: {result['unchecked'][0]['message']}"
    if deep <= tolerance:
        return f"false alarm at {deep}: {found[0]['message']}" if found else ""
    gouges = [f for f in found if f["code"] == "gouge"]
    if not gouges:
        return f"missed: {deep} deep with a point of {tool['point_angle']} degrees"
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
    jobs.add_bound(parser)
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
