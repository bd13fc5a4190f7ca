#!/usr/bin/env python3
"""Part 1 of the 2010 thesis (SOUCAST1.H): length of every block, compensated path with tool radius 5, totals, against the
independently computed figures of ../shared.

usage: soucast_test.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing
"""
import collections
import json
import math
import pathlib
import subprocess
import sys
import tempfile

TOLERANCE = 1e-6
FIRST, LAST = 11, 22  # blocks of the contour behind its approach


class Faults(list):
    def near(self, got, want, what):
        if not abs(got - want) <= TOLERANCE:  # also where one is not a number
            self.append(f"{what} is {got}, expected {want}")


class Move:
    """A move in the plane: block, start, end, length, and centre and sweep of an arc."""

    def __init__(self, start, row):
        self.block, self.start, self.end = row["block"], start, (row["x_mm"], row["y_mm"])
        self.depth = row["z_mm"]
        self.centre, self.sweep = row.get("centre_mm"), row.get("sweep_deg")
        if self.centre:
            self.length = math.radians(abs(self.sweep)) * math.dist(self.centre[:2], self.end)
        else:
            self.length = math.dist(start, self.end) if None not in start else math.nan


def moves(obrys, input_file):
    """The feed moves at the milling depth, and the exit code."""
    done = subprocess.run([obrys, "run", str(input_file), "--format", "json"], capture_output=True, text=True, check=False)
    out, at = [], (None, None)
    for row in json.loads(done.stdout):
        move = Move(at, row)
        if row["kind"] != "rapid" and move.length > 0:
            out.append(move)
        at = move.end
    return out, done.returncode


def compare_programmed(obrys, program, expected, faults):
    """Without a tool list the radius is not known: the contour itself is run, and the run says so."""
    got, code = moves(obrys, program)
    if code != 3:
        faults.append(f"the run without a tool ends with exit {code}, expected 3 (not fully checked)")
    lengths = collections.Counter()
    for m in got:
        lengths[m.block] += m.length
    for want in expected["uncompensated"]:
        faults.near(lengths[want["block"]], want["length"], f"programmed length of block {want['block']}")
    total = sum(v for k, v in lengths.items() if FIRST <= k <= LAST)
    faults.near(total, expected["lengths"]["uncomp_contour_11_22"], "programmed contour")
    return total


def compare_compensated(obrys, program, expected, folder, faults):
    job = folder / "part.job.toml"
    job.write_text(f"program = {json.dumps(program.resolve().as_posix())}\n"
                   '[[tool]]\nnumber = 1\nkind = "mill"\nradius = 5.0\n')
    got, code = moves(obrys, job)
    want = expected["compensated_RL_r5"]
    if code != 0:
        faults.append(f"the compensated run ends with exit {code}")
    if len(got) != len(want):
        faults.append(f"{len(got)} compensated moves, expected {len(want)}")
    for m, w in zip(got, want):
        where = f"{w['kind']} of block {w['block']}"
        # The file counts a corner's arc to the block before it, obrys to the one behind it (as SINUMERIK documents it).
        if m.block != w["block"] and w["kind"] != "corner":
            faults.append(f"{where} stands in block {m.block}")
        faults.near(m.length, w["length"], f"length of {where}")
        faults.near(m.depth, -2.5, f"depth of {where}")
        for i in range(2):
            faults.near(m.start[i], w["start"][i], f"start {'XY'[i]} of {where}")
            faults.near(m.end[i], w["end"][i], f"end {'XY'[i]} of {where}")
            if "center" in w and m.centre:
                faults.near(m.centre[i], w["center"][i], f"centre {'XY'[i]} of {where}")
        if ("center" in w) != (m.centre is not None):
            faults.append(f"{where}: arc or line")
        if "sweep_deg" in w and m.sweep is not None:
            faults.near(m.sweep, w["sweep_deg"], f"sweep of {where}")
    total = sum(m.length for m in got if FIRST <= m.block <= LAST)
    faults.near(total, expected["lengths"]["comp_contour_11_22"], "compensated contour")
    return total


JOB = """program = "{program}"
machine = "mill-generic"
[[tool]]
number = 1
kind = "end-mill"
diameter = 10.0
length = 60.0
"""
CUT_LENGTH, CUT_AREA, DEPTH = (279.3, 0.3), (2741.3, 2.0), 2.5  # mm, mm2, mm: of the study, with their tolerances


def compare_milled(obrys, program, work, faults):
    """Way over which new material is removed, and its area at full depth, on the program's own block."""
    job = work / "soucast.job.toml"
    job.write_text(JOB.format(program=program.resolve().as_posix()))
    ran = subprocess.run([obrys, "check", str(job), "--format", "json"], capture_output=True, text=True, check=False, timeout=300)
    m = json.loads(ran.stdout)["milling"]
    length, area = m["contact_length_mm"], (m["before_mm3"] - m["after_mm3"]) / DEPTH
    for got, (wanted, within), what in ((length, CUT_LENGTH, "way in the material"), (area, CUT_AREA, "removed area")):
        if not abs(got - wanted) <= within:
            faults.append(f"{what}: {got:.3f}, expected {wanted} within {within}")
    return length, area


def main():
    obrys, folder = sys.argv[1], pathlib.Path(sys.argv[2]) / "programs/heidenhain"
    if not (folder / "expected").is_dir():
        print("skipped: needs ../shared")
        return 77
    expected = json.loads((folder / "expected/soucast1.json").read_text())
    faults = Faults()
    programmed = compare_programmed(obrys, folder / "SOUCAST1.H", expected, faults)
    with tempfile.TemporaryDirectory() as work:
        compensated = compare_compensated(obrys, folder / "SOUCAST1.H", expected, pathlib.Path(work), faults)
        length, area = compare_milled(obrys, folder / "SOUCAST1.H", pathlib.Path(work), faults)
    print(f"milled: {length:.3f} mm in the material, {area:.1f} mm2 at full depth")
    print(f"contour {programmed:.3f} mm, compensated with radius 5 {compensated:.3f} mm, {len(faults)} faults")
    print("\n".join(faults[:40]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
