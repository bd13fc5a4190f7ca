#!/usr/bin/env python3
"""Draws the meridian that examples/profile mills: the tip's circle of every pass as `obrys run` reports it.

usage: draw_profile.py <obrys> <examples/profile> > examples/profile/profile.svg
"""
import math
import pathlib
import re
import subprocess
import sys

TIP = 2.0
SCALE, LEFT, TOP = 20.0, 40.0, 30.0  # px a mm; px


def passes(obrys, folder):
    run = subprocess.run([obrys, "run", str(folder / "profile.job.toml")], capture_output=True, text=True, check=False)
    for line in run.stdout.splitlines():
        if line.startswith('cycle contour-train "CYCL DEF 25"'):
            q = {name: float(value) for name, value in re.findall(r'"(Q\d+)" (\S+)', line)}
            yield q["Q3"] + TIP, q["Q1"] + TIP


def surface():
    """The programmed meridian: bevel 20 degrees 6 deep, convex R8 to 0, concave R10 to 45, bevel 45 degrees 5 deep."""
    x, z = 0.0, 0.0
    yield x, z
    a = math.radians(20)
    x, z = x + 6 * math.tan(a), z - 6
    yield x, z
    for radius, first, last in ((8, 20, 0), (-10, 0, 45)):
        cx, cz = x - radius * math.cos(math.radians(first)), z - radius * math.sin(math.radians(first))
        for k in range(1, 21):
            a = math.radians(first + (last - first) * k / 20)
            yield cx + radius * math.cos(a), cz + radius * math.sin(a)
        x, z = cx + radius * math.cos(a), cz + radius * math.sin(a)
    yield x + 5, z - 5


def main():
    obrys, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    px = lambda p: (LEFT + SCALE * (p[0] + 4), TOP - SCALE * p[1])
    points = [px(p) for p in surface()]
    outline = " ".join(f"{x:.2f},{y:.2f}" for x, y in points)
    bottom, side = points[-1][1], LEFT
    width, height = LEFT + SCALE * 18, bottom + 20
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" font-family="sans-serif" font-size="12">')
    print(f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>')
    print(f'<polygon points="{side:.2f},{points[0][1]:.2f} {outline} {side:.2f},{bottom:.2f}" fill="#d8dde3"/>')
    for p in passes(obrys, folder):
        x, y = px(p)
        print(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{SCALE * TIP:.2f}" fill="none" stroke="#2a7" stroke-width="0.6"/>')
    print(f'<polyline points="{outline}" fill="none" stroke="#123" stroke-width="2"/>')
    for x, y in (points[0], points[1], points[21], points[41], points[-1]):
        print(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="4" fill="#c30"/>')
    print(f'<text x="{side + 5:.0f}" y="{TOP + 18:.0f}">surface Q5</text>')
    print("</svg>")


if __name__ == "__main__":
    main()
