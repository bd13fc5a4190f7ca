#!/usr/bin/env python3
"""Large and small: a workpiece of 2000 x 1500 x 800 mm at a tolerance of 0.01, one of 1 mm at 0.0005, coordinates at 10 000 mm,
programs and parts in inches. Each with a pocket that is right and must be clean, then with scratches three tolerances deep,
which must be found with their depth at their line.

usage: extremes.py OBRYS [--only small,far,inch,large] [--keep FOLDER]
"""
import argparse
import math
import sys
import time

import jobs
import stl_parts
import tools

NUMBER = "{:.7f}"


class Extreme:
    """A block with a pocket, scaled and shifted; the pocket's corners have the radius of its tool."""

    def __init__(self, size, tolerance, shift=(0.0, 0.0, 0.0), unit=1.0):
        self.size, self.tolerance, self.shift, self.unit = size, tolerance, shift, unit
        k = min(size)
        self.d, self.depth = 0.2 * k, 0.1 * k
        self.a, self.b = 0.3 * size[0], 0.3 * size[1]  # half sides

    def word(self, x, y, z):
        return " ".join(w + NUMBER.format((v + s) / self.unit) for w, v, s in zip("XYZ", (x, y, z), self.shift))

    def lines(self, scratches):
        """In the frame whose zero is the middle of the top. Returns the lines, and those that scratch by number."""
        a, b, r, safe = self.a, self.b, self.d / 2, 0.2 * min(self.size)
        guilty, out = [], [("G20" if self.unit > 1 else "G21") + " G90 G17 G40 G80 G94", "F20" if self.unit > 1 else "F500"]

        def go(x, y, z, rapid=False, mark=False):
            out.append(f"G{0 if rapid else 1} {self.word(x, y, z)}")
            if mark:
                guilty.append(len(out))

        def tool(n):
            out.extend([f"T{n} M6", f"G0 G43 H{n} Z{NUMBER.format((safe + self.shift[2]) / self.unit)}", "M3 S3000"])

        tool(1)
        go(0, 0, safe, True)
        levels = math.ceil(self.depth / self.d)
        for level in range(1, levels + 1):
            z = -self.depth * level / levels
            go(0, 0, z)
            rings = math.ceil((min(a, b) - r) / (0.4 * self.d))
            for k in range(1, rings + 1):
                inset = (min(a, b) - r) * (1 - k / rings)
                u, v = a - r - inset, b - r - inset
                for x, y in ((u, 0), (u, v), (-u, v), (-u, -v), (u, -v), (u, 0)):
                    go(x, y, z)
            go(0, 0, z)
        go(0, 0, safe, True)
        if scratches:
            tool(2)
            deep = 3 * self.tolerance
            go(-0.1 * self.size[0], 0.013 * self.size[1], safe, True)
            go(-0.1 * self.size[0], 0.013 * self.size[1], -self.depth + deep, True)
            for x, y, z in ((-0.1, 0.013, -self.depth - deep), (0.11, 0.047, -self.depth - deep), (0.11, 0.047, safe)):
                go(x * self.size[0], y * self.size[1], z, mark=True)
            go(0.4 * self.size[0], -0.1 * self.size[1], safe, True)
            for x, y, z in ((0.4, -0.1, -deep), (0.41, 0.1, -deep), (0.41, 0.1, safe)):
                go(x * self.size[0], y * self.size[1], z, mark=True)
        out.append("M2")
        return out, guilty

    def part(self):
        side = stl_parts.Rectangle(self.size[0] / 2, self.size[1] / 2)
        hole = stl_parts.Rectangle(self.a, self.b, self.d / 2, 0.0, self.tolerance / 20)
        triangles = stl_parts.build((0.0, 0.0), [(side, -self.size[2]), (side, 0.0), (hole, 0.0), (hole, -self.depth)], False)
        return [tuple(tuple(v + s for v, s in zip(p, self.shift)) for p in t) for t in triangles]

    def write(self, folder, scratches):
        lines, guilty = self.lines(scratches)
        low = tuple(s - v / 2 if i < 2 else s - v for i, (v, s) in enumerate(zip(self.size, self.shift)))
        high = tuple(s + v / 2 if i < 2 else s for i, (v, s) in enumerate(zip(self.size, self.shift)))
        mill, point = tools.end_mill(self.d), tools.cone("chamfer", 0.1 * min(self.size), 60.0)
        reach = 2 * min(self.size)
        for t in (mill, point):
            t.keys.update(length=2 * reach, cutting_length=reach)
        jobs.write(folder, lines, [(1, mill.keys), (2, point.keys)], (low, high), self.part(),
                   check={"tolerance": self.tolerance, "gouge": self.tolerance, "rest_material": self.tolerance})
        return guilty


CASES = {
    "small": Extreme((1.0, 1.2, 0.8), 0.0005),
    "far": Extreme((60.0, 50.0, 30.0), 0.01, (10000.0, -10000.0, 5000.0)),
    "inch": Extreme((60.0, 50.0, 30.0), 0.01, (0.0, 0.0, 0.0), 25.4),
    "large": Extreme((2000.0, 1500.0, 800.0), 0.01),
}


def judge(case, options):
    wrong = []
    for scratches in (False, True):
        with jobs.folder_of(options.keep) as folder:
            guilty = case.write(folder, scratches)
            result = jobs.check(options.obrys, folder)
        if result["verdict"] in ("none", "not-fully-checked") and result["unchecked"]:
            wrong.append("not checked: " + "; ".join(u["message"][:200] for u in result["unchecked"][:3]))
            if result["verdict"] == "none":
                continue
        gouges = [f for f in result["findings"] if f["code"] == "gouge"]
        others = [f for f in result["findings"] if f["code"] not in ("gouge", "plunging-cut")]
        if others:
            wrong.append(f"{len(others)} x {others[0]['code']}: {others[0]['message'][:120]}")
        if not scratches:
            if gouges:
                wrong.append(f"false alarm: {gouges[0]['message'][:120]}")
            continue
        if len(gouges) != 2:
            wrong.append(f"{len(gouges)} scratches found, 2 were made")
        for g in gouges:
            if abs(g["depth_mm"] - 3 * case.tolerance) > case.tolerance / 5:
                wrong.append(f"{g['depth_mm']} deep, not {3 * case.tolerance}")
            if g["where"]["line"] not in guilty:
                wrong.append(f"line {g['where']['line']} blamed, {guilty} did it")
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--only", default=",".join(CASES))
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for name in options.only.split(","):
        began = time.monotonic()
        wrong = judge(CASES[name], options)
        failed += len(wrong)
        print(f"{name}: {'as it is' if not wrong else ' | '.join(wrong)} ({time.monotonic() - began:.1f} s)", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
