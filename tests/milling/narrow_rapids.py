#!/usr/bin/env python3
"""Rapids that go into the stock between two rays: pointed tools drawn through its top, as it was or faced before, end mills that
clip an upright edge of it, at random places; and the same beside the stock, which are no finding. Depths are known by formulas.

usage: narrow_rapids.py OBRYS [--count 100] [--seed 1] [--tolerance 0.01] [--keep FOLDER]
"""
import argparse
import math
import random as randoms
import sys

import jobs

TOOLS = [(1, {"kind": "countersink", "diameter": 8.0, "point_angle": 90.0, "length": 90.0}),
         (2, {"kind": "drill", "diameter": 6.0, "length": 90.0}),
         (3, {"kind": "end-mill", "diameter": 10.0, "length": 90.0}),
         (4, {"kind": "end-mill", "diameter": 20.0, "length": 90.0})]


def case_of(random):
    """(lines, depth, what); depth 0: no finding"""
    kind = random.choice(["top", "faced", "edge", "edge", "beside", "above"])
    deep = random.choice([0.1, 0.05, round(random.uniform(0.02, 0.2), 3)])
    x, y = round(random.uniform(8, 50), 3), round(random.uniform(8, 30), 3)
    lines, top = ["T1 M6", "G0 G43 H1 Z30", "M3 S3000 F800"], 0.0
    if kind in ("top", "faced", "above"):
        if kind != "top":
            top = -round(random.uniform(0.5, 2), 3)
            lines = ["T4 M6", "G0 G43 H4 Z30", "M3 S3000 F800", "G0 X-15 Y0", f"G1 Z{top}"]
            for i in range(5):
                lines += [f"G1 Y{i * 10}", f"G1 X{75 if i % 2 == 0 else -15}"]
            lines += ["G0 Z30", "T1 M6", "G0 G43 H1 Z30", "M3 S3000 F800"]
        n = random.choice([1, 2])
        lines[-3:] = [f"T{n} M6", f"G0 G43 H{n} Z30", "M3 S3000 F800"]
        z = top - deep if kind != "above" else top + 0.002
        turn, way = random.uniform(0, 2 * math.pi), 6
        lines += [f"G0 X{x} Y{y}", f"G0 Z{z:.4f}", f"G0 X{x + way * math.cos(turn):.4f} Y{y + way * math.sin(turn):.4f}", "G0 Z30"]
        return lines, 0.0 if kind == "above" else deep, f"{kind}, tool {n}"
    # The tool passes an upright edge of the stock askew, its middle so far from it as leaves `deep` of the edge within.
    n = random.choice([3, 4])
    r, turn = (5.0 if n == 3 else 10.0), math.radians(random.uniform(20, 70))
    off = r - deep if kind == "edge" else r + 0.002
    normal = (-math.cos(turn), -math.sin(turn))
    along = (-normal[1], normal[0])
    a = [off * normal[0] - 30 * along[0], off * normal[1] - 30 * along[1]]
    b = [off * normal[0] + 30 * along[0], off * normal[1] + 30 * along[1]]
    lines = [f"T{n} M6", f"G0 G43 H{n} Z30", "M3 S3000 F800", f"G0 X{a[0]:.5f} Y{a[1]:.5f}", f"G0 Z-{round(random.uniform(1, 15), 3)}",
             f"G0 X{b[0]:.5f} Y{b[1]:.5f}", "G0 Z30"]
    return lines, deep if kind == "edge" else 0.0, f"{kind} at {math.degrees(turn):.0f} degrees, tool {n}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerance", type=float, default=0.01)
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for number in range(options.first, options.first + options.count):
        lines, depth, what = case_of(randoms.Random(f"{options.seed}.{number}"))
        with jobs.folder_of(options.keep) as folder:
            jobs.write(folder, ["G21 G90 G17 G40 G80 G94", *lines, "M2"], TOOLS, ((0, 0, -20), (60, 40, 0)),
                       check={"scope": "collisions", "tolerance": options.tolerance})
            result = jobs.check(options.obrys, folder)
        most = max(jobs.depths(result, "rapid-in-stock"), default=0.0 if result["verdict"] != "none" else math.nan)
        wrong = most != 0 if depth == 0 else not abs(most - depth) <= max(options.tolerance, 0.1 * depth) or most == 0
        if wrong:
            failed += 1
            print(f"{number}: {most} for {depth}: {what}", flush=True)
    print(f"{options.count} rapids at a tolerance of {options.tolerance}, {failed} not found as they are")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
