#!/usr/bin/env python3
"""Staircases for NC 470 against the figures of the 1984 thesis in ../shared, and measured by arithmetic of its own.

usage: thesis_test.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

NEAR = 1e-6  # mm
RADIUS = 25.0

JOB = """program = "PART.MPF"
control = "sinumerik-840d"
machine = "mill-generic"
[[tool]]
number = 1
kind = "end-mill"
diameter = 50.0
length = 100.0
"""
POST = """extends = "nc-470"
[staircase]
roughness = {}
[numbers]
length = {{ decimals = 9 }}
"""


def call(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=300)
    return done.returncode, done.stdout, done.stderr


def contour_of(v):
    """Elements from the matrix of the thesis: (from, to, centre or None, sweep). Arcs turn as the tangent goes on."""
    at, heading, elements = (v[3], v[4]), None, []
    for phi, x, y in zip(v[5::3], v[6::3], v[7::3]):
        if phi == 0:
            to = (x, y)
            elements.append((at, to, None, 0))
            heading = math.atan2(to[1] - at[1], to[0] - at[0])
        else:
            out = math.atan2(at[1] - y, at[0] - x)
            turn = lambda sign: abs(math.remainder(out + sign * math.pi / 2 - heading, 2 * math.pi))
            sign = 1 if turn(1) < turn(-1) else -1
            radius, sweep = math.hypot(at[0] - x, at[1] - y), sign * math.radians(phi)
            to = (x + radius * math.cos(out + sweep), y + radius * math.sin(out + sweep))
            elements.append((at, to, (x, y), sweep))
            heading = out + sweep + sign * math.pi / 2
        at = to
    return elements


def program_of(v, elements):
    lines = ["G17 G90 G54 G71", "T1 D1 M6", "S300 M3", f"G0 X{v[0]} Y{v[1]}", f"G0 Z{v[2]}", "G1 Z-5 F200"]
    lines.append(f"G42 G1 X{v[3]} Y{v[4]}")
    for start, end, centre, sweep in elements:
        place = f"X={end[0]!r} Y={end[1]!r}"
        if centre is None:
            lines.append(f"G1 {place}")
        else:
            lines.append(f"G{3 if sweep > 0 else 2} {place} I={centre[0] - start[0]!r} J={centre[1] - start[1]!r}")
    lines += ["G40 G1 X-80 Y-40", "G0 Z50", "M30"]
    return "\n".join(lines) + "\n"


def way_of(text):
    """Where each block leads in the plane while the tool is down."""
    at, way = {"X": None, "Y": None, "Z": None}, []
    for line in text.splitlines():
        for letter, number in re.findall(r"([XYZ])(-?[\d.]+)", line):
            at[letter] = float(number)
        if None not in at.values() and at["Z"] < 0:
            way.append((at["X"], at["Y"]))
    return way


def near(a, b, tolerance=NEAR):
    return math.hypot(a[0] - b[0], a[1] - b[1]) <= tolerance


def distance(p, way):
    """Of a point from a way along the axes: each piece is a box."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(way, way[1:]):
        x = min(max(p[0], min(ax, bx)), max(ax, bx))
        y = min(max(p[1], min(ay, by)), max(ay, by))
        best = min(best, math.hypot(p[0] - x, p[1] - y))
    return best


def samples(element, count):
    """Points of the contour with the unit vector to its right, where the tool is."""
    start, end, centre, sweep = element
    for k in range(count + 1):
        t = k / count
        if centre is None:
            length = math.hypot(end[0] - start[0], end[1] - start[1])
            tangent = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
            p = (start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1]))
        else:
            a = math.atan2(start[1] - centre[1], start[0] - centre[0]) + t * sweep
            radius, sign = math.hypot(start[0] - centre[0], start[1] - centre[1]), math.copysign(1, sweep)
            p = (centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a))
            tangent = (-sign * math.sin(a), sign * math.cos(a))
        yield p, (tangent[1], -tangent[0])


def measure(way, elements, ridge, faults, name):
    """It never cuts into the contour, and covers what lies higher above it than the ridge."""
    for number, element in enumerate(elements, 1):
        for p, n in samples(element, 120):
            if distance(p, way) < RADIUS - NEAR:
                faults.append(f"{name}: cuts {RADIUS - distance(p, way):g} mm into row {number} at {p}")
                break
            high = (p[0] + (ridge + NEAR) * n[0], p[1] + (ridge + NEAR) * n[1])
            if distance(high, way) > RADIUS + NEAR:
                faults.append(f"{name}: leaves more than {ridge:g} mm on row {number} at {p}")
                break


def visits(way, points):
    """The points in their order."""
    rest = iter(way)
    return all(any(near(p, q) for q in rest) for p in points)


def places_on(way, element, side):
    """Different places of the way on the equidistant of an element, without those in line of its centre (quadrants)."""
    start, end, centre, sweep = element
    found = set()
    for p in way:
        if centre is None:
            length = math.hypot(end[0] - start[0], end[1] - start[1])
            u = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
            along = (p[0] - start[0]) * u[0] + (p[1] - start[1]) * u[1]
            across = (p[0] - start[0]) * u[1] - (p[1] - start[1]) * u[0]
            on = abs(across - side) < NEAR and -NEAR < along < length + NEAR
        else:
            radius = math.hypot(start[0] - centre[0], start[1] - centre[1]) + side * math.copysign(1, sweep)
            a = math.atan2(p[1] - centre[1], p[0] - centre[0]) - math.atan2(start[1] - centre[1], start[0] - centre[0])
            turn = a * math.copysign(1, sweep) % (2 * math.pi)
            on = abs(math.hypot(p[0] - centre[0], p[1] - centre[1]) - radius) < NEAR and \
                min(turn, 2 * math.pi - turn if turn > 6.28 else turn) <= abs(sweep) + 1e-7
        if on:
            found.add((round(p[0], 5), round(p[1], 5)))
    return len(found)


def check_equidistants(obrys, job, table, faults):
    code, text, errors = call(obrys, "run", job, "--format", "csv")
    if code != 0:
        faults.append(f"run: exit code {code}\n{errors}")
        return
    ends = [(float(r["x"]), float(r["y"])) for r in csv.DictReader(text.splitlines()) if r["x"] and r["y"]]
    for row in table:
        a, b = (float(row["XNASZA"]), float(row["YNASZA"])), (float(row["XNASKO"]), float(row["YNASKO"]))
        if not any(near(p, a) and near(q, b) for p, q in zip(ends, ends[1:])):
            faults.append(f"equidistant of row {row['row']}: no move from {a} to {b}")


def check_arc_ends(obrys, folder, cases, faults):
    """Ends of arcs given by centre and angle: turned about the centre."""
    lines, expected = ["G17 G90 G54 G71", "F100"], []
    for case in cases:
        start = [-100 * f(math.radians(case["alfa"])) for f in (math.cos, math.sin)]
        for g, name in ((3, "ccw"), (2, "cw")):
            lines += [f"G0 X{start[0]:.12f} Y{start[1]:.12f} Z0",
                      f"G{g} I{-start[0]:.12f} J{-start[1]:.12f} AR={case['phi']}"]
            expected.append(case[name])
    program = folder / "ARCS.MPF"
    program.write_text("\n".join(lines + ["M30"]) + "\n", encoding="utf-8")
    code, text, errors = call(obrys, "run", program, "--control", "sinumerik-840d", "--machine", "mill-generic",
                              "--format", "csv")
    ends = [(float(r["x"]), float(r["y"])) for r in csv.DictReader(text.splitlines()) if r["kind"] == "arc"]
    if code != 0 or len(ends) != len(expected) or not all(near(p, q) for p, q in zip(ends, expected)):
        faults.append(f"ends of arcs: exit code {code}, {ends} instead of {expected}\n{errors}")


def check_staircase(obrys, folder, job, roughness, faults):
    """The way in the plane that the post writes for a roughness."""
    post, out = folder / "mine.toml", folder / "out.nc"
    post.write_text(POST.format(float(roughness)), encoding="utf-8")
    code, _, errors = call(obrys, "translate", job, "--to", post, "-o", out, "--force")
    if code != 0 or "does the same" not in errors:
        faults.append(f"translate: exit code {code}\n{errors}")
    said = re.search(r"ridges on the contour at most ([\d.e-]+) mm", errors)
    if not said or float(said.group(1)) > roughness + 5e-5:
        faults.append(f"the ridges are not said: {errors}")
    way = way_of(out.read_text(encoding="utf-8"))
    if any(a[0] != b[0] and a[1] != b[1] for a, b in zip(way, way[1:])):
        faults.append("a block moves two axes")
    return way


def main():
    obrys, shared = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    oracle = shared / "programs/fortran1984"
    if not oracle.exists():
        print(f"skipped: {oracle} is missing")
        return 77
    load = lambda name: json.loads((oracle / name).read_text(encoding="utf-8"))
    matrix, stairs = load("example_input.json"), load("expected_staircase.json")
    with open(oracle / "expected_table.csv", encoding="utf-8", newline="") as file:
        table = [row for row in csv.DictReader(file) if row["variant"] == "correct_geometry"]
    elements, faults = contour_of(matrix["V1"]), []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "PART.MPF").write_text(program_of(matrix["V1"], elements), encoding="utf-8")
        job = folder / "PART.job.toml"
        job.write_text(JOB, encoding="utf-8")
        check_equidistants(obrys, job, table, faults)
        check_arc_ends(obrys, folder, load("arc_endpoint_formula_check.json"), faults)
        way = check_staircase(obrys, folder, job, matrix["DRS_mm"], faults)
        for row, expected in stairs["rows"].items():
            if not visits(way, expected["centre_points"]):
                faults.append(f"staircase of row {row}: not all places of the thesis' figures are visited in order")
        measure(way, elements, matrix["DRS_mm"], faults, "Rz 4")
        for ra, counts in stairs["Ra_table"].items():
            way = check_staircase(obrys, folder, job, counts["Rz_mm"], faults)
            for row, key, extra in ((7, "line_steps", 1), (2, "outer_R100_steps", None), (4, "inner_R80_steps", 1)):
                steps = counts[key.replace("R100_steps", "steps").replace("R80_steps", "steps")]
                # Outside, the way touches at the quadrant, too, where no step ends there.
                wanted = steps + (extra if extra is not None else 1 + steps % 2)
                found = places_on(way, elements[row - 1], RADIUS)
                if found != wanted:
                    faults.append(f"Ra {ra}: {found} places on row {row}, not {wanted}")
            if ra == "12.5":
                measure(way, elements, counts["Rz_mm"], faults, f"Ra {ra}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
