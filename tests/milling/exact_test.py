#!/usr/bin/env python3
"""The reference itself: surfaces made from formulas lie on what it says is exact, and where they do not, it says by how much.

usage: exact_test.py EXACT
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import stl_parts
import tools
from blocks import Program, Setting, extruded

LO, HI = (-20.0, -15.0, -12.0), (20.0, 15.0, 0.0)


def slotted(floor, y0=LO[1], y1=HI[1], fins=((-3.0, 3.0),)):
    """A block with slots along y between the given x."""
    top = [(LO[0], LO[2]), (HI[0], LO[2]), (HI[0], HI[2])]
    for a, b in sorted(fins, reverse=True):
        top += [(b, 0.0), (b, floor), (a, floor), (a, 0.0)]
    return extruded(top + [(LO[0], 0.0)], y0, y1)


def slot_program(*xs, floor=-5.0, d=6.0, setting=Setting()):
    program = Program(setting)
    program.tool(tools.end_mill(d))
    for x in xs:
        program.rapid((x, -30.0, floor))
        program.line((x, 30.0, floor))
    program.end()
    return program


def bored(outline, z, tip=None):
    """A block with a hole of that outline down to z."""
    side = stl_parts.Rectangle(HI[0], HI[1])
    rings = [(side, LO[2]), (side, 0.0), (outline, 0.0), (outline, z)]
    return stl_parts.cone_end((0.0, 0.0), rings, tip) if tip is not None else stl_parts.build((0.0, 0.0), rings, False)


def cases():
    """(what, program, triangles, bounds of what is found: within, outside, missing)"""
    zero, fine = (0, 2e-6), 1e-4
    plain = slot_program(0.0)
    yield "slot", plain, slotted(-5.0), (zero, zero, zero)
    yield "slot too deep", plain, slotted(-5.02), ((0.0199, 0.0201), zero, (0.0199, 0.0201))
    yield "slot too shallow", plain, slotted(-4.98), (zero, (0.0199, 0.0201), (0.0199, 0.0201))
    fin = slot_program(-3.05, 3.05)
    yield "fin", fin, slotted(-5.0, fins=((-6.05, -0.05), (0.05, 6.05))), (zero, zero, zero)
    yield "fin lost", fin, slotted(-5.0, fins=((-6.05, 6.05),)), ((0, 0.06), zero, (4.7, 5.0))
    down = Program(Setting())
    down.tool(tools.cone("drill", 8.0, 118.0))
    down.rapid((0.0, 0.0, 5.0))
    down.line((0.0, 0.0, -7.0))
    down.end()
    circle, point = stl_parts.Circle(4.0, fine), 4 / math.tan(math.radians(59))
    off = (0, 1.1 * fine)
    yield "drilled", down, bored(circle, -7.0 + point, -7.0), (off, off, off)
    yield "drilled too deep", down, bored(circle, -7.1 + point, -7.1), ((0.099, 0.1001), off, (0.08, 0.0862))
    helix = Program(Setting())
    helix.tool(tools.end_mill(6.0))
    helix.rapid((1.5, 0.0, 0.0))
    for z in (-2.0, -4.0, -5.5):
        helix.arc((1.5, 0.0, z), (0.0, 0.0, z), True)
    helix.arc((1.5, 0.0, -5.5), (0.0, 0.0, -5.5), True)
    helix.line((0.0, 0.0, -5.5))
    helix.end()
    yield "helix", helix, bored(stl_parts.Circle(4.5, fine), -5.5), (off, off, off)
    # A ridge of 20 degrees between two grooves whose tip is drawn 0.012 too high: seen from there each face is 0.002 away.
    ridge = Program(Setting())
    ridge.tool(tools.cone("chamfer", 4.0, 20.0))
    slope = math.tan(math.radians(10))
    for x in (-0.3, 0.3):
        ridge.rapid((x, -30.0, -4.0))
        ridge.line((x, 30.0, -4.0))
    ridge.end()
    tip = -4.0 + 0.3 / slope
    for over, bound in ((0.0, zero), (0.012, (0.0119, 0.0121))):
        section = [(LO[0], LO[2]), (HI[0], LO[2]), (HI[0], 0.0), (0.3 + 4 * slope, 0.0), (0.3, -4.0), (0.012 * slope, tip - 0.012),
                   (0.0, tip + over), (-0.012 * slope, tip - 0.012), (-0.3, -4.0), (-0.3 - 4 * slope, 0.0), (LO[0], 0.0)]
        yield f"ridge {over}", ridge, extruded(section, LO[1], HI[1]), (zero, bound, (0, over / 2 + 2e-6))
    pit = Program(Setting())
    pit.tool(tools.ball(8.0))
    pit.rapid((0.0, 0.0, 5.0))
    pit.line((0.0, 0.0, -3.0))
    pit.end()
    side = stl_parts.Rectangle(HI[0], HI[1])
    n = 100
    rings = [(stl_parts.Circle(4 * math.cos(a), fine), 1 - 4 * math.sin(a)) for a in
             (math.asin(0.25) + (math.pi / 2 - math.asin(0.25)) * i / n for i in range(n))]
    yield "ball", pit, stl_parts.cone_end((0.0, 0.0), [(side, LO[2]), (side, 0.0), *rings], -3.0), ((0, 3 * fine),) * 3


def main():
    exact, failed, number = sys.argv[1], 0, 0
    for what, program, triangles, bounds in cases():
        number += 1
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "scene.txt").write_text(program.scene((LO, HI)))
            stl_parts.write(folder / "s.stl", triangles)
            done = subprocess.run([exact, str(folder / "scene.txt"), str(folder / "s.stl"), "--enough", "0.01"], capture_output=True,
                                  text=True, timeout=300)
        found = [float(v) for v in re.findall(r"^(?:within|outside|missing) (\S+)", done.stdout, re.M)]
        if len(found) != 3 or not all(lo <= v <= hi for v, (lo, hi) in zip(found, bounds)):
            failed += 1
            print(f"{what}: within, outside, missing {found} where {bounds} is right; {done.stderr}")
    print(f"{number} surfaces, {failed} not measured as they are")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
