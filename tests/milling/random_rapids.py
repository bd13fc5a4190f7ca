#!/usr/bin/env python3
"""Rapids into the stock: how deep, against formulas. Straight down and slanting, beside walls of pockets, at the stock's corners,
with flat, round and pointed tools; and rapids that pass a thousandth of a millimetre beside it, which are no finding.

usage: random_rapids.py OBRYS [--count 100] [--seed 1] [--keep FOLDER]
"""
import argparse
import math
import random as randoms
import sys

import jobs

SAFE = 40.0


def tool_of(random):
    kind = random.choice(["end-mill", "ball", "bull-nose", "drill"])
    d = random.choice([3.0, 5.0, 6.0, 10.0, 12.0])
    keys = {"kind": kind, "diameter": d, "length": 90.0, "cutting_length": 60.0}
    if kind == "bull-nose":
        keys["corner_radius"] = 1.0
    return keys


def case_of(random):
    """(lines, tool, depth) of one rapid; depth 0: it meets nothing."""
    tool = tool_of(random)
    r = tool["diameter"] / 2
    x, y, top = round(random.uniform(15, 45), 3), round(random.uniform(12, 28), 3), 0.0
    depth = random.choice([8.0, 5.0, 2.3, round(random.uniform(0.05, 12), 3)])
    lines, kind = [], random.choice(["flat", "flat", "pocket", "corner", "edge", "slanting", "level", "beside"])
    if kind in ("pocket", "edge"):
        tool = {**tool, "kind": "end-mill"}
        tool.pop("corner_radius", None)
    if kind == "pocket":
        floor, half = -round(random.uniform(3, 15), 3), round(random.uniform(r, 2 * r), 3)
        ring = [(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half), (0, 0), (half, 0), (-half, 0)]
        lines += [f"G0 X{x} Y{y}", f"G1 Z{floor}"] + [f"G1 X{x + a:.3f} Y{y + b:.3f}" for a, b in ring] + [f"G0 Z{SAFE}"]
        x, y, top = round(x + random.uniform(-half, half), 3), round(y + random.uniform(-half, half), 3), floor
    if kind == "corner":
        x, y = random.choice([0.0, 60.0]), random.choice([0.0, 40.0])
    if kind == "edge":  # a chip off the side: at its rim as far as it reaches in, else as high as it stands
        over = round(random.uniform(0.02, 0.95) * r, 3)
        x = -round(r - over, 3)
        if abs(over - 0.1 * r) < 0.7:
            over, x = 0.0, -r - 0.001
        depth_found = 0.0 if over == 0 else min(over, depth) if over < 0.1 * r else depth
        return lines + [f"G0 X{x} Y{y}", f"G0 Z{-depth}", f"G0 Z{SAFE}"], tool, depth_found
    if kind == "slanting":
        rise = round(random.uniform(0.3, 2.0), 3)
        back = (depth + 20) / rise
        return [f"G0 X{x - back:.4f} Y{y} Z20.", f"G0 X{x} Y{y} Z{-depth}", f"G0 Z{SAFE}"], tool, depth
    if kind == "level":
        return [f"G0 X-20 Y{y}", f"G0 Z{-depth}", f"G0 X80", f"G0 Z{SAFE}"], tool, depth
    if kind == "beside":
        way = random.choice(["above", "left"])
        if way == "above":
            return [f"G0 X-20 Y{y}", "G0 Z0.001", "G0 X80", f"G0 Z{SAFE}"], tool, 0.0
        return [f"G0 X{-r - 0.001} Y-20", f"G0 Z{-depth}", "G0 Y60", f"G0 Z{SAFE}"], tool, 0.0
    return lines + [f"G0 X{x} Y{y}", f"G0 Z{top - depth:.4f}", f"G0 Z{SAFE}"], tool, depth


def write(folder, lines, tool):
    text = ["G21 G90 G17 G40 G80 G94", "T1 M6", f"G0 G43 H1 Z{SAFE}", "M3 S3000 F800", *lines, "M2"]
    jobs.write(folder, text, [(1, tool)], ((0, 0, -40), (60, 40, 0)), check={"scope": "collisions", "tolerance": 0.01})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for number in range(options.count):
        lines, tool, depth = case_of(randoms.Random(f"{options.seed}.{number}"))
        with jobs.folder_of(options.keep) as folder:
            write(folder, lines, tool)
            result = jobs.check(options.obrys, folder)
        most = max(jobs.depths(result, "rapid-in-stock"), default=0.0 if result["verdict"] != "none" else math.nan)
        if not abs(most - depth) <= max(0.002, 0.002 * depth):
            failed += 1
            print(f"{number}: {most} for {depth}: {tool} {lines[-3:]}", flush=True)
    print(f"{options.count} rapids, {failed} not as deep as they are")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
