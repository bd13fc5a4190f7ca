#!/usr/bin/env python3
"""Random marks of all kinds of tools, feed and rapid, in three axes and swivelled: scratches, edges and corners taken off, clips of
clamps, rapids in the stock, bumps in slots; and what is left thin or cut through: fins, webs, crests, ribs, narrow
features of the part that nobody cuts; what hides beside other gouges. Each that is deeper than the tolerance must be found, with its
depth to a tenth or the tolerance, at a line that made it; what only touches must not be.

usage: defects.py OBRYS [--count 60] [--first 0] [--seed 1] [--tolerances 0.05,0.01,0.002] [--kinds scratch,edge,…]
                  [--strict] [--keep FOLDER]
Each complaint names its number; --first NUMBER --count 1 --keep FOLDER makes it again and leaves the job.
"""
import argparse
import random as randoms
import sys

import hidden
import jobs
import marks
import rests

KINDS = {**marks.KINDS, **rests.KINDS, **hidden.KINDS}
# What such marks may bring with them, rightly.
BESIDE = {"sideways-cut", "plunging-cut", "edges-too-short"}


def made(kind, seed, number, tolerance):
    random = randoms.Random(f"{seed}.{kind}.{number}")
    while True:
        mark = KINDS[kind](random, tolerance)
        if mark is not None:
            return mark


def wrong_with(mark, result, tolerance, strict):
    if result["verdict"] == "none":
        return result["unchecked"][0]["message"]
    guilty, named = mark.program.guilty()
    found = [f for f in result["findings"] if f["code"] == mark.code]
    others = sorted({f["code"] for f in result["findings"]} - BESIDE - mark.beside - {mark.code})
    out = []
    if not found:
        if mark.depth > 1.001 * mark.least:
            out.append(f"MISSED ({result['verdict']})")
    else:
        depth = max(jobs.depths(result, mark.code))
        if mark.depth == 0:
            out.append(f"FALSE ALARM {depth:.4f}")
        else:
            slack = lambda d: tolerance / 10 if strict else max(tolerance, 0.1 * d)
            if not mark.depth - slack(mark.depth) <= depth <= mark.deepest + slack(mark.deepest):
                out.append(f"DEPTH {depth:.4f}")
            lines = {f["where"]["line"] or 0 for f in found}  # 0: none was named
            if not mark.no_line and (not lines <= named | ({0} if mark.at_faces else set()) or not lines & guilty):
                out.append(f"LINE {sorted(lines)} where {sorted(guilty)} did it")
        if mark.also and not any(abs(d - mark.also) <= max(tolerance, 0.1 * mark.also) for d in jobs.depths(result, mark.code)):
            out.append(f"ALSO MISSED {mark.also:.4f}")
    if others:
        out.append("ALSO " + ", ".join(others))
    # What goes in by less than a ray sees counts as nothing met.
    unchecked = [u["message"][:120] for u in result["unchecked"] if "met the stock" not in u["message"]]
    if unchecked:
        out.append("UNCHECKED " + unchecked[0])
    return "; ".join(out)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=60, help="of each kind, at each tolerance")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--tolerances", default="0.05,0.01,0.002")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--strict", action="store_true", help="depths to a tenth of the tolerance")
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for tolerance in [float(t) for t in options.tolerances.split(",")]:
        for kind in options.kinds.split(","):
            complaints, slowest = 0, 0.0
            for number in range(options.first, options.first + options.count):
                mark = made(kind, options.seed, number, tolerance)
                with jobs.folder_of(options.keep) as folder:
                    mark.program.write(folder, mark.stock, mark.part, mark.clamps, mark.check)
                    began = jobs.used()
                    result = jobs.check(options.obrys, folder)
                    slowest = max(slowest, jobs.used() - began)
                wrong = wrong_with(mark, result, tolerance, options.strict)
                if wrong:
                    complaints += 1
                    print(f"{tolerance} {kind} {number}: {wrong}: {mark.depth:.5f} deep, {mark.what}", flush=True)
            print(f"tolerance {tolerance}, {kind}: {options.count} marks, {complaints} not judged as they are; the slowest took {slowest:.1f} s", flush=True)
            failed += complaints
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
