#!/usr/bin/env python3
"""Tools that do not cut at their centre on their way down: straight ramps, helices, ways to and fro, into solid material and into
holes drilled before. What must be found follows from the core's radius b by formulas: within any disc of radius b the tool may
go down by tan(30 degrees) of how far it goes aside. On a straight ramp of angle a that is a > 30 degrees; on a helix of radius r
not below b, pitch asin(b / r) / (2 pi b) > tan(30 degrees); on a narrower one the depth against 2 r.

usage: random_ramps.py OBRYS [--count 200] [--seed 1] [--keep FOLDER]
"""
import argparse
import math
import random as randoms
import sys

import jobs

STEEPEST = math.tan(math.radians(30))


def tool_of(random):
    """(keys of the tool, radius of its core on slants)"""
    d = random.choice([6.0, 8.0, 10.0, 16.0, 25.0])
    kind = random.choice(["end-mill", "bull-nose", "chamfer", "form"])
    keys = {"kind": kind, "diameter": d, "length": 100.0, "plunges": False, "cutting_length": 60.0}
    core = d / 10
    if kind == "bull-nose":
        keys["corner_radius"] = 1.0
    if kind == "chamfer":
        core = round(random.uniform(0.1, 0.4) * d, 3)
        keys.update(tip_diameter=2 * core, point_angle=90.0)
    if kind == "form":
        core = round(random.uniform(0.1, 0.4) * d, 3)
        del keys["diameter"]
        keys["profile"] = [[core, 0.0], [d / 2, 0.4], [d / 2, 60.0]]
    return keys, core


def case_of(random):
    """(lines, tool, whether it is too steep, what)"""
    keys, b = tool_of(random)
    x, y = 40.0, 30.0
    kind = random.choice(["ramp", "helix", "helix", "chords", "to and fro", "drilled", "thread"])
    if kind == "thread":  # down a hole drilled before: under the core lies the thread's ring, which the edges reach on every turn
        d = random.choice([6.0, 8.0, 12.0])
        keys = {"kind": "form", "profile": [[d / 2 - 0.5, 0.0], [d / 2, 0.5], [d / 2, 0.6], [d / 2 - 0.5, 1.1]], "length": 100.0,
                "hole": d + 0.8}
        r, pitch = 1.0, random.choice([1.0, 1.5, 2.0])
        lines = [f"G0 X{x} Y{y}", "G0 Z1", f"G1 X{x + r}"] + [f"G3 X{x + r} Y{y} Z{1 - pitch * (i + 1)} I{-r} J0" for i in range(8)]
        return lines + [f"G1 X{x}"], keys, False, f"thread of {pitch} in a hole of {d + 0.8}"
    lines = [f"G0 X{x} Y{y}", "G0 Z1"]
    depth = round(random.uniform(3 * b, 6 * b), 3)
    if kind == "ramp":
        angle = random.choice([random.uniform(1, 25), random.uniform(35, 88)])
        depth = min(depth, 12 * math.tan(math.radians(angle)))
        aside = (depth + 1) / math.tan(math.radians(angle))
        if random.random() < 0.5:  # in small blocks
            lines += [f"G1 X{x + aside * i / 40:.4f} Z{1 - (depth + 1) * i / 40:.4f}" for i in range(1, 41)]
        else:
            lines.append(f"G1 X{x + aside:.4f} Z{-depth:.4f}")
        found, what = angle > 30, f"ramp of {angle:.1f} degrees"
    elif kind == "to and fro":
        half = random.choice([random.uniform(0.3, 0.8), random.uniform(6, 8)]) * b
        way, z = round(half, 3), 1.0
        lines.append(f"G1 X{x - way:.4f}")
        for i in range(4000):
            if z <= -depth:
                break
            z = max(-depth, z - 2 * half * math.tan(math.radians(3)))
            lines.append(f"G1 X{x + (way if i % 2 == 0 else -way):.4f} Z{z:.4f}")
        found, what = half < b, f"to and fro over {2 * half:.3f}"
    else:
        r = round(b * random.choice([random.uniform(0.1, 0.8), random.uniform(1.05, 3)]), 3)
        pitch = round(min(3.0, random.uniform(0.1, 1.5) * b), 3)
        turns = math.ceil((depth + 1) / pitch)
        depth = turns * pitch - 1
        lines.append(f"G1 X{x + r:.4f}")
        if kind == "chords":
            n = 36
            for i in range(1, turns * n + 1):
                t = 2 * math.pi * i / n
                lines.append(f"G1 X{x + r * math.cos(t):.4f} Y{y + r * math.sin(t):.4f} Z{1 - pitch * i / n:.4f}")
        else:
            lines += [f"G3 X{x + r:.4f} Y{y:.4f} Z{1 - pitch * (i + 1):.4f} I{-r:.4f} J0" for i in range(turns)]
        ratio = depth / (2 * r) if r < b else pitch * math.asin(b / r) / (2 * math.pi * b)
        if abs(ratio / STEEPEST - 1) < 0.2:
            return case_of(random)
        found, what = ratio > STEEPEST, f"{kind}: helix of radius {r}, pitch {pitch}"
        if kind == "drilled":
            found = False
    if kind == "drilled":  # wider than what the core reaches
        hole = 2 * (r + b) + 0.2
        keys["hole"] = hole
    return lines, keys, found, f"{what}, {depth:.3f} deep, core {b}"


def write(folder, lines, keys):
    text, hole = ["G21 G90 G17 G40 G80 G94", "F500"], keys.pop("hole", None)
    if hole:
        text += ["T2 M6", "G0 G43 H2 Z30", "M3 S1000", "G0 X40 Y30", "G0 Z2", "G1 Z-70", "G0 Z30"]
    text += ["T1 M6", "G0 G43 H1 Z30", "M3 S3000", *lines, "G0 Z30", "M2"]
    tools = [(1, keys)]
    if hole:
        tools.append((2, {"kind": "end-mill", "diameter": hole, "length": 120.0, "cutting_length": 100.0}))
    jobs.write(folder, text, tools, ((0, 0, -80), (110, 60, 0)), check={"scope": "collisions", "tolerance": 0.02})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for number in range(options.first, options.first + options.count):
        lines, keys, expected, what = case_of(randoms.Random(f"{options.seed}.{number}"))
        with jobs.folder_of(options.keep) as folder:
            write(folder, lines, keys)
            result = jobs.check(options.obrys, folder)
        found = any(f["code"] == "plunging-cut" for f in result["findings"])
        if result["verdict"] == "none":
            found = result["unchecked"][0]["message"]
        if found != expected:
            failed += 1
            print(f"{number}: {found} where {expected} is right: {keys['kind']}, {what}", flush=True)
    print(f"{options.count} ways down, {failed} judged wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
