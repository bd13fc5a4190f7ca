#!/usr/bin/env python3
"""A hollow fillet along a contour, held to a part that is made from the drawing (examples/fillet/fillet_part.py).

usage: fillet_test.py OBRYS EXAMPLES            our program: as it is, finer and coarser, and without its last pass
       fillet_test.py OBRYS EXAMPLES SHARED     HL_RADIUS.H as printed, which leaves out the pass at 90 degrees; then its
                                                main program with our RADIUS.H. Exit 77 (skipped) where SHARED is missing
"""
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ARC, TIP = 9.0, 4.0          # radius of the section (Q8 = -9) and of the tool's tip (Q9)
CENTRES = ARC - TIP          # radius on which the tip's centre stands
ACCURACY = 0.001             # of the part's chords


def passes(step):
    """Angle between two passes, degrees (examples/profile/README.md)."""
    return 90 / int(1 + (ARC - 7 / 8 * TIP) * math.pi / 2 / step)


def scallop_bound(step):
    """What Q10 allows at most (examples/profile/README.md)."""
    chord = step * CENTRES / (ARC - 7 / 8 * TIP) * math.sqrt(ARC / CENTRES)
    return TIP - math.sqrt(TIP * TIP - chord * chord / 4)


def ridge(angle):
    """Height of the ridge between two passes so many degrees apart: where their tip circles cross, below the arc."""
    half = math.radians(angle) / 2
    return ARC - CENTRES * math.cos(half) - math.sqrt(TIP * TIP - (CENTRES * math.sin(half)) ** 2)


def missing_pass(angle):
    """What is left on the step where the last pass is so many degrees before the end."""
    return CENTRES * (1 - math.cos(math.radians(angle)))


class Runs:
    def __init__(self, obrys):
        self.obrys, self.faults = obrys, []

    def need(self, good, what):
        if not good:
            self.faults.append(what)

    def near(self, got, want, by, what):
        self.need(abs(got - want) <= by, f"{what} is {got:.5f}, expected {want:.5f} within {by}")

    def check(self, job, *more):
        done = subprocess.run([self.obrys, "check", str(job), "--format", "json", *more], capture_output=True, text=True,
                              check=False, timeout=1500)
        result = json.loads(done.stdout)
        result["exit"] = done.returncode
        return result

    def finished(self, job, step, tolerance, *more):
        """No gouge, and ridges as high as they must be, not above what Q10 allows."""
        r = self.check(job, *more)
        m, bound, exact = r["milling"], scallop_bound(step), ridge(passes(step))
        print(f"{job.name} Q10={step}: {r['verdict']}, gouge {m['largest_gouge_mm']:.4f}, excess {m['largest_excess_mm']:.4f}, "
              f"ridges {exact:.4f}, bound {bound:.4f}")
        self.need(exact <= bound, f"Q10={step}: the ridges are higher than the bound")
        self.need(m["largest_gouge_mm"] <= tolerance + ACCURACY, f"Q10={step}: gouge {m['largest_gouge_mm']}")
        self.need(m["largest_excess_mm"] <= bound + tolerance, f"Q10={step}: excess {m['largest_excess_mm']}, bound {bound}")
        self.near(m["largest_excess_mm"], exact, tolerance + ACCURACY, f"Q10={step}: height of the ridges")
        return r

    def rest(self, r, height, tolerance, elements, stack):
        """One finding as high as expected that names the contour's elements and the calls; elements: block, text."""
        found = [f for f in r["findings"] if f["code"] == "rest-material"]
        self.need(r["exit"] == 1 and len(found) == 1 and len(r["findings"]) == 1,
                  f"exit {r['exit']}, findings {[f['message'] for f in r['findings']]}")
        if not found:
            return
        f = found[0]
        print(f"  {f['message']}")
        self.near(f["height_mm"], height, tolerance, "height of what is left")
        self.need("along this contour element" in f["message"], f"no element in: {f['message']}")
        places = [f["where"]] + [x["where"] for x in f.get("related", [])]
        named = sorted((pathlib.Path(p["file"]).name, p["block"], p["text"].split(maxsplit=1)[1]) for p in places)
        self.need(named == sorted(elements), f"elements {named}, expected {elements}")
        calls = [(pathlib.Path(s["file"]).name, s["block"]) for s in f["where"]["stack"]]
        self.need(calls == stack, f"called from {calls}, expected {stack}")


def import_part(examples):
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(examples / "fillet"))
    import fillet_part
    return fillet_part


def our_program(runs, examples, work):
    shutil.copytree(examples, work / "examples")
    job = work / "examples/fillet/fillet.job.toml"
    import_part(examples).write(job.with_name("fillet.stl"), import_part(examples).Drawing(), ACCURACY)
    r = runs.finished(job, 1, 0.005)
    runs.need(r["verdict"] == "clean" and r["exit"] == 0, f"verdict {r['verdict']} {r['findings']}")
    r = runs.finished(job, 2.5, 0.005, "--set", "Q10=2.5")
    runs.need(r["verdict"] == "findings", f"Q10=2.5: verdict {r['verdict']}")
    elements = [("FILLET.H", 27, "L X+30"), ("FILLET.H", 28, "CR X+50 Y+35 R+20 DR+"), ("FILLET.H", 29, "L Y+90")]
    runs.rest(runs.check(job, "--set", "Q6=2"), missing_pass(passes(1)), 0.005, elements, [("RADIUS.H", 109), ("FILLET.H", 23)])


PRINTED_JOB = """program = "{program}"
machine = "mill-generic"
[[tool]]
number = 1
kind = "bull-nose"
diameter = 16.0
corner_radius = {tip}
length = 80.0
[stock]
box = {{ min = {low}, max = {high} }}
[part]
file = "part.stl"
[check]
gouge = {tolerance}
rest_material = {rest}
tolerance = {tolerance}
"""


def printed_program(runs, examples, shared, work):
    """The block is the part of the plate in which the contour X20 Y20, X80, Y80 has no ends. It begins 4 mm below Q5, where
    the section turns about the contour's sharp corner with a radius of 0.9 mm: roundings thinner than the distance of the
    simulation's rays (0.13 mm) come out as edges, up to 0.4 of their radius too far out."""
    folder, part, tolerance = shared / "programs/heidenhain", import_part(examples), 0.002
    d = part.Drawing(radius=ARC, low=(30.0, 9.0, -95.0), high=(91.0, 70.0, -87.0), below=4.0, wall_y=20.0, wall_x=80.0, round=0.0)
    part.write(work / "part.stl", d, ACCURACY / 2)
    shutil.copy(folder / "HL_RADIUS.H", work / "OURS.H")
    shutil.copy(examples / "profile/RADIUS.H", work)
    values = {"tip": TIP, "low": list(d.low), "high": list(d.high), "tolerance": tolerance, "rest": scallop_bound(0.5) + tolerance}
    for name, program in (("ours", "OURS.H"), ("printed", folder / "HL_RADIUS.H")):
        path = os.path.relpath(program, work) if name == "printed" else program
        (work / f"{name}.job.toml").write_text(PRINTED_JOB.format(program=path, **values))
    r = runs.finished(work / "ours.job.toml", 0.5, tolerance)
    runs.need(r["verdict"] == "clean", f"our RADIUS.H: {r['verdict']} {[f['message'] for f in r['findings']]}")
    r = runs.check(work / "printed.job.toml")
    print(f"as printed: {r['verdict']}")
    elements = [("HL_RADIUS.H", 26, "L X+80"), ("HL_RADIUS.H", 27, "L Y+80")]
    calls = [("RADIUS.H", 91), ("RADIUS.H", 109), ("HL_RADIUS.H", 22)]  # CYCL CALL in LBL 2, CALL LBL 2, CALL PGM
    runs.rest(r, missing_pass(passes(0.5)), tolerance, elements, calls)


def main():
    runs, examples = Runs(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    shared = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 else None
    if shared is not None and not (shared / "programs/heidenhain").is_dir():
        print("skipped: needs ../shared")
        return 77
    with tempfile.TemporaryDirectory() as name:
        if shared is None:
            our_program(runs, examples, pathlib.Path(name))
        else:
            printed_program(runs, examples, shared, pathlib.Path(name))
    for fault in runs.faults:
        print(fault)
    return 1 if runs.faults else 0


if __name__ == "__main__":
    sys.exit(main())
