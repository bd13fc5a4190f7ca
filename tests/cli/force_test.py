#!/usr/bin/env python3
"""Forces of simulated cuts are those that another program computed for their engagement
(../shared/spec/oracle/physics/force.json): slots with a helix, walls cut down and up, by `obrys force` of a job each.

usage: force_test.py OBRYS SHARED
"""
import json
import pathlib
import subprocess
import sys
import tempfile

MEAN, PEAK = 0.02, 0.03  # the outermost rays leave open where the edge enters, by half their distance
SPEED = 6000

MATERIAL = """[material.oracle]
linear = {{Ktc = {}, Krc = {}, Kac = {}, Kte = {}, Kre = {}, Kae = {}, source = "force.json"}}
"""
MACHINE = """name = "quick"
kind = "mill"
[motion]
acceleration = 100000
jerk = 100000
corner = "filter"
""" + "".join(f'[[axis]]\nname = "{axis}"\nacceleration = 100000\njerk = 1000000\n' for axis in "XYZ")
JOB = """program = "part.H"
machine = "quick.toml"
material = "oracle"
materials = "oracle.toml"
[check]
scope = "collisions"
[stock]
box = {{min = [0, {right}, -20], max = [100, {left}, 0]}}
[[tool]]
number = 1
kind = "end-mill"
diameter = {D}
cutting_length = 30
length = 100
teeth = {N}
[[cutting]]
tool = 1
helix = {helix_deg}
"""
PROGRAM = """0 BEGIN PGM PART MM
1 TOOL CALL 1 Z S{speed}
2 L X-20 Y+0 Z+50 R0 FMAX M3
3 L Z-{ap} FMAX
4 L X+80 F{feed}
5 L Z+50 FMAX M30
6 END PGM PART MM
"""


def stock(case):
    """Where the material lies across the way: to the right of it where it is cut down."""
    radius = case["D"] / 2
    wall = radius - case["ae"]  # from the way's line
    return {"slot": (-30, 30), "down": (-30, -wall), "up": (wall, 30)}[case["mode"]]


def run(obrys, folder, case, coefficients):
    right, left = stock(case)
    feed = SPEED * case["N"] * case["fz"]
    (folder / "oracle.toml").write_text(MATERIAL.format(*coefficients))
    (folder / "quick.toml").write_text(MACHINE)
    (folder / "part.job.toml").write_text(JOB.format(right=right, left=left, **case))
    (folder / "part.H").write_text(PROGRAM.format(speed=SPEED, ap=case["ap"], feed=feed))
    done = subprocess.run([obrys, "force", "part.job.toml", "--format", "json", "--tolerance", "0.005"], cwd=folder,
                          capture_output=True, text=True)
    if done.returncode != 0:
        return None, f"exit code {done.returncode}: {done.stderr}{done.stdout[:400]}"
    return json.loads(done.stdout), None


def main():
    obrys = pathlib.Path(sys.argv[1]).resolve()
    oracle = pathlib.Path(sys.argv[2]) / "spec" / "oracle" / "physics" / "force.json"
    if not oracle.is_file():
        print("needs", oracle)
        return 77
    told, faults, count = json.loads(oracle.read_text()), [], 0
    for case in told["cylindrical"]:
        if case["fz"] < 0.01:
            continue  # chips below a thousandth of a millimetre have less than the edge's whole force here
        with tempfile.TemporaryDirectory() as folder:
            got, fault = run(obrys, pathlib.Path(folder), case, told["K_used"])
        if fault:
            faults.append(f"{case['name']}: {fault}")
            continue
        count += 1
        sums, most = case["numeric"], got["max"]
        torque = sums["mean_torque_Nmm"] / 1000
        power = torque * 2 * 3.141592653589793 * SPEED / 60
        for what, value, expected, within in (("mean", most["mean_N"], sums["mean_resultant"], MEAN),
                                              ("peak", most["peak_N"], sums["peak"], PEAK),
                                              ("torque", most["torque_Nm"], torque, MEAN),
                                              ("power", most["power_W"], power, MEAN)):
            print(f"{case['name']}: {what} {value:.5g}, {expected:.5g}: {100 * (value / expected - 1):+.2f} %")
            if abs(value / expected - 1) > within:
                faults.append(f"{case['name']}: {what} is {value}, not {expected}")
        if len(got["moves"]) != 1 or got["moves"][0]["deflection_mm"] is not None:
            faults.append(f"{case['name']}: one move cuts, and how far its tool stands out is not known: {got['moves']}")
    print("\n".join(faults))
    return 1 if faults or count < 3 else 0


if __name__ == "__main__":
    sys.exit(main())
