#!/usr/bin/env python3
"""Random programs of all tools, in three axes and swivelled, lines, arcs and helices: the surface that obrys writes as STL against
the exact one, both ways, by exact/ (a program of its own that shares nothing with src/).

usage: surfaces.py OBRYS EXACT [--count 60] [--first 0] [--seed 1] [--tolerance 0.01] [--times 1] [--plain | --grooves] [--cases S.N,S.N]
                   [--keep FOLDER]
--times: how many tolerances count as beyond. Each complaint names its number; --first NUMBER --count 1 --keep FOLDER makes it again.
"""
import argparse
import math
import random as randoms
import re
import sys

import jobs
import tools
from blocks import Program, Setting

SIZE = 24.0


def swept_line(random, program, at, low):
    """A move to a random place: level, slanting, straight down."""
    kind = random.choice(["level", "level", "level", "slant", "down", "short"])
    x, y, z = (random.uniform(-2, SIZE + 2), random.uniform(-2, SIZE + 2), at[2])
    if random.random() < 0.3:
        x, y = (x, at[1]) if random.random() < 0.5 else (at[0], y)
    if kind == "slant":
        z = random.uniform(low, 0.5)
    if kind == "down":
        x, y, z = at[0], at[1], random.uniform(low, at[2])
    if kind == "short":
        x, y, z = at[0] + random.uniform(-1, 1), at[1] + random.uniform(-1, 1), max(low, at[2] + random.uniform(-0.3, 0.3))
    program.line(tuple(round(v, 4) for v in (x, y, z)))


def swept_arc(random, program, at, low):
    r, way = random.uniform(1, 9), random.uniform(0, 2 * math.pi)
    centre = (round(at[0] + r * math.cos(way), 4), round(at[1] + r * math.sin(way), 4), at[2])
    counter, turn = random.random() < 0.5, random.choice([math.pi / 2, math.pi, random.uniform(0.2, 6), 2 * math.pi])
    u = (at[0] - centre[0], at[1] - centre[1])
    angle = turn if counter else -turn
    to = (centre[0] + u[0] * math.cos(angle) - u[1] * math.sin(angle), centre[1] + u[0] * math.sin(angle) + u[1] * math.cos(angle))
    z = at[2] if random.random() < 0.6 else max(low, at[2] - random.uniform(0.2, 3))
    if turn == 2 * math.pi:
        to = at[:2]
    program.arc((*to, z), centre, counter)


def plain(random):
    """A few straight moves of one round tool, three axes: what held when the stock did not adapt yet."""
    program = Program(Setting())
    program.tool(random.choice([lambda: tools.ball(6.0), lambda: tools.bull(8.0, 1.0), lambda: tools.lollipop(8.0, 4.0)])())
    spot = lambda: tuple(round(random.uniform(4, SIZE - 4), 4) for _ in range(2)) + (-2.0137,)
    program.rapid(spot())
    for _ in range(random.randint(0, 2)):
        program.line(spot())
    program.end()
    return program, ((0.0, 0.0, -12.0), (SIZE, SIZE, 0.0))


def grooves(random):
    """Sharp points alone, shallow, long, across each other: bottoms of grooves, their ends and crossings."""
    setting = Setting.any(random, random.random() < 0.35)
    if not setting.swivels:
        setting = Setting()
    program = Program(setting)
    h = SIZE / 2 if setting.swivels else 0.0
    stock = ((0.0, 0.0, -12.0), (SIZE, SIZE, 0.0)) if not setting.swivels else ((-h, -h, -h), (h, h, h))
    for _ in range(random.choice([1, 1, 2])):
        program.tool(tools.cone(random.choice(["chamfer", "countersink"]), random.choice([4.0, 6.0, 10.0]),
                                random.choice([15.0, 20.0, 20.0, 24.0, 30.0, 40.0])))
        low = h - random.choice([random.uniform(0.02, 0.3), random.uniform(0.3, 3)])
        program.rapid(tuple(round(random.uniform(2, SIZE - 2) - h, 3) for _ in range(2)) + (round(random.uniform(low, h), 4),))
        for _ in range(random.randint(1, 4)):
            (swept_arc if random.random() < 0.3 else swept_line)(random, program, program.at, low)
    program.end()
    return program, stock


def made(random):
    """Program and stock. The tool goes down at least as far as makes a cut; a swivelled stock is cut from above all the same."""
    setting = Setting.any(random, random.random() < 0.35)
    if not setting.swivels:
        setting = Setting()
    program = Program(setting)
    stock = ((0.0, 0.0, -12.0), (SIZE, SIZE, 0.0))
    if setting.swivels:  # an upright box about the point round which it swivels
        h = SIZE / 2
        stock = ((-h, -h, -h), (h, h, h))
    for _ in range(random.choice([1, 1, 2, 3])):
        program.tool(tools.any_tool(random, undercut=True))
        lift = SIZE / 2 if setting.swivels else 0.0
        low = -random.uniform(0.05, 6) + lift
        at = (round(random.uniform(-4, SIZE + 4), 3), round(random.uniform(-4, SIZE + 4), 3), round(random.uniform(low, lift), 4))
        if setting.swivels:
            at = (at[0] - SIZE / 2, at[1] - SIZE / 2, at[2])
        program.rapid(at)
        for _ in range(random.randint(1, 8)):
            (swept_arc if random.random() < 0.3 else swept_line)(random, program, program.at, low)
    program.end()
    return program, stock


def measured(options, program, stock, folder, seed):
    """{what: (mm, place)} and how many places obrys names as not followed, or a complaint"""
    program.write(folder, {"box": {"min": list(stock[0]), "max": list(stock[1])}},
                  check={"scope": "collisions", "tolerance": options.tolerance})
    (folder / "scene.txt").write_text(program.scene(stock))
    stl = folder / "surface.stl"
    result = jobs.check(options.obrys, folder, "--force", "--stl", str(stl))
    if result["verdict"] == "none" or not stl.exists():
        return result["unchecked"][0]["message"] if result["unchecked"] else "no surface"
    done = jobs.bounded([options.exact, str(folder / "scene.txt"), str(stl), "--enough", str(options.tolerance * options.times),
                           "--each", str(options.each), "--most", str(options.most), "--seed", str(seed)])
    found = {m[1]: (float(m[2]), m[3]) for m in re.finditer(r"(\w+) ([\d.e+]+) at (\S+ \S+ \S+), beyond", done.stdout)}
    if len(found) != 3:
        return "exact/: " + done.stderr[-200:] + done.stdout[-200:]
    named = [int(m[1]) for u in result["unchecked"] if (m := re.search(r"too fine in itself .* everywhere: in (\d+) place", u["message"]))]
    named += [int(m[1]) for a in result.get("assumptions", []) if (m := re.search(r"bottom of grooves .*, in (\d+) place", a["message"]))]
    return found, sum(named)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("exact")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--tolerance", type=float, default=0.01)
    parser.add_argument("--times", type=float, default=1.0)
    parser.add_argument("--each", type=int, default=60)
    parser.add_argument("--most", type=int, default=60000)
    parser.add_argument("--plain", action="store_true", help="a few straight moves of round tools")
    parser.add_argument("--grooves", action="store_true", help="shallow moves of sharp points")
    parser.add_argument("--cases", help="these instead: seed.number,seed.number,...")
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed, worst, named, in_vain = 0, {}, 0, 0
    cases = [f"{options.seed}.{n}" for n in range(options.first, options.first + options.count)]
    if options.cases:
        cases = options.cases.split(",")
    for case in cases:
        number = int(case.rsplit(".", 1)[1])
        program, stock = (plain if options.plain else grooves if options.grooves else made)(randoms.Random(case))
        with jobs.folder_of(options.keep) as folder:
            found = measured(options, program, stock, folder, number)
        if isinstance(found, str):
            failed += 1
            print(f"{case}: {found}", flush=True)
            continue
        found, places = found
        beyond = {k: v for k, v in found.items() if v[0] > 1.001 * options.times * options.tolerance}
        for k, v in found.items():
            worst[k] = max(v[0], worst.get(k, 0.0))
        kinds = ", ".join(t.keys["kind"] for t in program.tools)
        if places:
            named, in_vain = named + 1, in_vain + (not beyond)
            print(f"{case}: {places} places named as not followed" + (", in vain" if not beyond else "") + f" ({kinds})", flush=True)
        if beyond:
            failed += not places
            print(f"{case}: " + "; ".join(f"{k} {v[0]:.4f} at {v[1]}" for k, v in beyond.items()) + f" ({kinds})", flush=True)
    print(f"{len(cases)} programs at {options.tolerance}, {failed} with surfaces more than {options.times:g} times that off unsaid, "
          f"{named} with places named as not followed, {in_vain} of these in vain; worst "
          + ", ".join(f"{k} {v:.4f}" for k, v in sorted(worst.items())), flush=True)
    return 1 if failed or in_vain else 0


if __name__ == "__main__":
    sys.exit(main())
