#!/usr/bin/env python3
"""What once was called clean or wrong: narrow scratches, rapids between two rays, chamfers, fins, clips, a plain pocket. One job each,
with its depth known by formulas.

usage: table.py OBRYS [--keep FOLDER]
"""
import argparse
import pathlib
import sys

import jobs
import stl_parts

STOCK = ((0, 0, -20), (60, 40, 0))
FACED = jobs.box((0, 0, -20), (60, 40, -1))
MILL = {"kind": "end-mill", "diameter": 10.0, "length": 90.0}
DRILL = {"kind": "drill", "diameter": 6.0, "length": 90.0, "point_angle": 118.0}


def pointed(angle):
    return {"kind": "chamfer", "diameter": 10.0, "length": 90.0, "tip_diameter": 0.0, "point_angle": angle}


def change(number):
    return [f"T{number} M6", f"G0 G43 H{number} Z30", "M3 S3000"]


def facing():
    lines = change(1) + ["G0 X-20 Y-4", "G0 Z-1"]
    for n, y in enumerate(range(-4, 48, 4)):
        lines += [f"G1 Y{y}", f"G1 X{-20 if n % 2 else 80}"]
    return lines + ["G0 Z30"]


def scratch(deep, y=17.37, to=19.1):
    return facing() + change(2) + [f"G0 X10 Y{y}", "G0 Z0", f"G1 Z{-1 - deep}", f"G1 X50 Y{to}"]


def trench(thin):
    """The part of two slots side by side, without what stands between them."""
    a, b = 5.0, 25 + thin
    sections = [[(0, -20), (a, -20), (a, -6), (a, -1), (0, -1)], [(a, -20), (b, -20), (b, -6), (a, -6)],
                [(b, -20), (40, -20), (40, -1), (b, -1), (b, -6)]]
    ring = [(0, -20), (a, -20), (b, -20), (40, -20), (40, -1), (b, -1), (b, -6), (a, -6), (a, -1), (0, -1)]
    out = []
    for s in sections:
        for i in range(1, len(s) - 1):
            three = (s[0], s[i], s[i + 1])
            out += [tuple((60.0, *p) for p in three), tuple((0.0, *p) for p in reversed(three))]
    for p, q in zip(ring, ring[1:] + ring[:1]):
        near, far = [(0.0, *p), (0.0, *q)], [(60.0, *p), (60.0, *q)]
        out += [(near[0], far[1], far[0]), (near[0], near[1], far[1])]
    return [tuple(tuple(float(c) for c in v) for v in reversed(t)) for t in out]


def slots(thin):
    return facing() + ["G0 X-20 Y10", "G0 Z-6", "G1 X80", "G0 Z30", f"G0 X-20 Y{20 + thin}", "G0 Z-6", "G1 X80"]


def clip(tolerance, deep):
    clamp = {"box": {"min": [65.0 - deep, 10.0, -20.0], "max": [75.0, 30.0, 5.0]}}
    lines = change(1) + ["G0 X-20 Y5", "G0 Z-1", "G1 X60 Y5", "G1 Y35"]
    return (f"edge of a clamp, {deep} at {tolerance}", lines, [MILL], None, [clamp], tolerance, "clamp-collision", deep)


def pocket():
    side, hole = stl_parts.Rectangle(40, 30), stl_parts.Rectangle(30, 20, 5.0, 0.0, 0.0005)
    part = stl_parts.build((0.0, 0.0), [(side, -20.0), (side, 0.0), (hole, 0.0), (hole, -10.0)], False)
    lines = change(1) + ["G0 X0 Y0", "G0 Z2"]
    for z in (-5, -10):
        lines += [f"G1 X0 Y0 Z{z}"]
        for k in range(1, 8):
            u, v = 25 * k / 7, 15 * k / 7
            lines += [f"G1 X{u:.4f} Y0", f"G1 Y{v:.4f}", f"G1 X{-u:.4f}", f"G1 Y{-v:.4f}", f"G1 X{u:.4f}", "G1 Y0"]
        lines += ["G1 X0 Y0"]
    return lines, part


def rows():
    """(what, lines, tools, part, clamps, tolerance, code of the one finding, its depth)"""
    for tolerance in (0.05, 0.01):
        for angle in (90, 60, 30):
            yield (f"V{angle} scratch at {tolerance}", scratch(0.15), [MILL, pointed(angle)], FACED, [], tolerance, "gouge", 0.15)
    yield "V90 scratch on a ray", scratch(0.03, 20, 20), [MILL, pointed(90)], FACED, [], 0.01, "gouge", 0.03
    yield "drill's point", scratch(0.1, 17.37, 17.9), [MILL, DRILL], FACED, [], 0.01, "gouge", 0.1
    # As deep as the edge lies below the chamfer, at the ring where the cone ends; the tool stands half of the leg in the part.
    chamfer = facing() + change(2) + ["G0 X-10 Y-4.9", "G0 Z-6", "G1 X70"]
    yield "unwanted chamfer", chamfer, [MILL, pointed(90)], FACED, [], 0.01, "gouge", 0.0707
    rapid = facing() + change(2) + ["G0 X10 Y17.37", "G0 Z-1.1", "G1 Z0"]
    yield "rapid between two rays", rapid, [MILL, pointed(90)], None, [], 0.01, "rapid-in-stock", 0.1
    for deep in (0.05, 0.1):
        lines = change(1) + ["G0 X-20 Y-20", "G0 Z-1", f"G1 X-20 Y{deep - 5}", f"G0 X80 Y{deep - 5}"]
        yield f"rapid along the stock, {deep}", lines, [MILL], None, [], 0.01, "rapid-in-stock", deep
    for thin in (0.2, 0.1, 0.05):
        yield f"fin {thin}", slots(thin), [MILL], trench(thin), [], 0.01, "rest-material", 5.0
    for deep in (0.002, 0.02, 0.1):
        for tolerance in (0.01, 0.05):
            yield clip(tolerance, deep)
    lines, part = pocket()
    yield "plain pocket", lines, [{**MILL, "plunges": True}], part, [], 0.01, None, 0.0


def judge(row, options):
    what, lines, tools, part, clamps, tolerance, code, depth = row
    low, high = depth if isinstance(depth, tuple) else (depth, depth)
    stock = ((-40, -30, -20), (40, 30, 0)) if code is None else STOCK
    check = {"tolerance": tolerance, **({} if part else {"scope": "collisions"})}
    with jobs.folder_of(options.keep and pathlib.Path(options.keep) / what.replace(" ", "_")) as folder:
        jobs.write(folder, ["G21 G90 G17 G40 G94", "F800", *lines, "G0 Z30", "M2"], list(enumerate(tools, 1)), stock, part,
                   clamps, check=check)
        picture = folder / "p.svg"
        result = jobs.check(options.obrys, folder, "--force", "--svg", str(picture))
        if "X is a radius" in picture.read_text():
            return "the picture is that of a lathe"
    if result["unchecked"]:
        return f"not checked: {result['unchecked'][0]['message']}"
    if code is None:
        return "" if result["verdict"] == "clean" else f"{result['verdict']}, not clean"
    found = jobs.depths(result, code)
    others = {f["code"] for f in result["findings"]} - {code, "sideways-cut"}
    if len(found) != 1 or others:
        return f"{len(found)} x {code}" + "".join(f", {o}" for o in sorted(others))
    slack = min(tolerance, 0.1 * high)
    return "" if low - slack <= found[0] <= high + slack else f"{code} of {found[0]} instead of {depth}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for row in rows():
        wrong = judge(row, options)
        failed += bool(wrong)
        print(f"{row[0]}: {wrong or 'as it is'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
