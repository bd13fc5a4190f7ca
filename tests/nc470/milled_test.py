#!/usr/bin/env python3
"""Staircases for NC 470 milled: what they cut into the part, and what they leave on it, by the milling simulation.

usage: milled_test.py OBRYS
"""
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

RADIUS, DEPTH = 10.0, 8.0
NEAR = 0.004  # mm: the simulation's tolerance, the part's chords and half a unit of the words together

# Counter-clockwise about the part: (end, centre, sense of the arc); convex and concave arcs, slopes of every quadrant.
START = (10.0, 0.0)
CONTOUR = [((55.0, 6.0), None, 0), ((70.0, 21.0), (55.0, 21.0), 1), ((66.0, 50.0), None, 0),
           ((40.0, 62.0), None, 0), ((10.0, 62.0), (25.0, 73.5), -1), ((-6.0, 40.0), None, 0), ((10.0, 0.0), None, 0)]


def call(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=500)
    return done.returncode, done.stdout, done.stderr


def corners(chord):
    """The contour as a polygon whose chords leave it by less than `chord`, on the part's side of outer arcs."""
    at, points = START, [START]
    for end, centre, sense in CONTOUR:
        if centre is not None:
            radius = math.hypot(at[0] - centre[0], at[1] - centre[1])
            a, b = (math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in (at, end))
            sweep = (b - a) * sense % (2 * math.pi) * sense
            count = math.ceil(abs(sweep) / (2 * math.acos(1 - chord / radius)))
            points += [(centre[0] + radius * math.cos(a + sweep * k / count),
                        centre[1] + radius * math.sin(a + sweep * k / count)) for k in range(1, count)]
        points.append(end)
        at = end
    return points[:-1]


def triangles(polygon):
    """Ears of a simple polygon that runs counter-clockwise."""
    rest, out = list(range(len(polygon))), []
    cross = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    while len(rest) > 3:
        for i, b in enumerate(rest):
            a, c = rest[i - 1], rest[(i + 1) % len(rest)]
            pa, pb, pc = polygon[a], polygon[b], polygon[c]
            if cross(pa, pb, pc) <= 0:
                continue
            inside = lambda p: cross(pa, pb, p) >= 0 and cross(pb, pc, p) >= 0 and cross(pc, pa, p) >= 0
            if not any(inside(polygon[k]) for k in rest if k not in (a, b, c)):
                out.append((a, b, c))
                rest.pop(i)
                break
    return out + [tuple(rest)]


def write_stl(path, polygon):
    faces = []
    for a, b, c in triangles(polygon):
        faces.append([(*polygon[k], 0.0) for k in (a, b, c)])
        faces.append([(*polygon[k], -DEPTH) for k in (a, c, b)])
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        faces.append([(*p, -DEPTH), (*q, -DEPTH), (*q, 0.0)])
        faces.append([(*p, -DEPTH), (*q, 0.0), (*p, 0.0)])
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(faces)))
        for face in faces:
            file.write(struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *p) for p in face) + b"\0\0")


def program():
    lines = ["G17 G90 G54 G71", "T1 D1 M6", "S900 M3", "G0 X10 Y-40", "G0 Z5", f"G1 Z{-DEPTH - 1:g} F200",
             "G42 G1 X10 Y0"]
    at = START
    for end, centre, sense in CONTOUR:
        if centre is None:
            lines.append(f"G1 X{end[0]} Y{end[1]}")
        else:
            lines.append(f"G{3 if sense > 0 else 2} X{end[0]} Y{end[1]} I={centre[0] - at[0]} J={centre[1] - at[1]}")
        at = end
    return "\n".join(lines + ["G40 G1 X-40 Y-30", "G0 Z50", "M30"]) + "\n"


TOOL = """machine = "mill-generic"
[[tool]]
number = 1
kind = "end-mill"
diameter = 20.0
length = 80.0
cutting_length = 40.0
"""


def check(obrys, folder, roughness, rest):
    """Findings of the written program, where up to `rest` mm may stand on the part."""
    job = folder / "written.job.toml"
    job.write_text(f'program = "out.nc"\ncontrol = "nc-470"\n{TOOL}[stock]\nbox = {{ min = [-9.0, -3.0, {-DEPTH}], '
                   f'max = [73.0, 65.0, 0.0] }}\n[part]\nfile = "part.stl"\n[check]\nscope = "part"\ngouge = {NEAR}\n'
                   f'rest_material = {rest}\ntolerance = 0.002\n', encoding="utf-8")
    code, text, errors = call(obrys, "check", job)
    return code, text + errors


def main():
    obrys, faults = pathlib.Path(sys.argv[1]).resolve(), []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_stl(folder / "part.stl", corners(0.0005))
        (folder / "PART.MPF").write_text(program(), encoding="utf-8")
        (folder / "PART.job.toml").write_text(f'program = "PART.MPF"\ncontrol = "sinumerik-840d"\n{TOOL}',
                                              encoding="utf-8")
        for roughness in (0.4, 0.05):
            (folder / "mine.toml").write_text(f'extends = "nc-470"\n[staircase]\nroughness = {roughness}\n',
                                              encoding="utf-8")
            code, _, said = call(obrys, "translate", folder / "PART.job.toml", "--to", folder / "mine.toml", "-o",
                                 folder / "out.nc", "--force")
            ridge = re.search(r"ridges on the contour at most ([\d.]+) mm", said)
            if code != 0 or ridge is None:
                faults.append(f"translate: exit code {code}\n{said}")
                continue
            code, text = check(obrys, folder, roughness, roughness + NEAR)
            if code != 0:
                faults.append(f"Rz {roughness}: exit code {code}\n{text}")
            # It is no accident: what stands there is found where less is allowed.
            code, text = check(obrys, folder, roughness, 0.6 * float(ridge.group(1)))
            if code != 1 or "rest-material" not in text or "gouge" in text:
                faults.append(f"Rz {roughness}, half of it allowed: exit code {code}\n{text}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
