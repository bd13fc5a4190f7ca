#!/usr/bin/env python3
"""What scripts rely on in the JSON of `obrys data`, `cost` and `blade`: keys, sums, exit codes.

usage: cutting_test.py OBRYS
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

COST = """[cost]
utilisation = 0.95
wage = 100
overhead = 500
machine = 850
material = 120
pieces = 1000
batch = 50
set_up = 30
load = 20
scrap = 1
"""
BLADE = """[blade]
length = 80
width = 30
E = 70000
density = 2700
[blank]
root = 9
tip = 3.6
[finished]
thickness = 3
"""


def main():
    obrys, faults = pathlib.Path(sys.argv[1]).resolve(), []

    def run(*words, code=0, folder="."):
        done = subprocess.run([obrys, *words, "--format", "json"], cwd=folder, capture_output=True, text=True)
        if done.returncode != code:
            faults.append(f"{' '.join(words)}: exit code {done.returncode}, not {code}: {done.stderr}")
        return json.loads(done.stdout) if done.stdout else {}

    data = run("data", "--vc", "160", "--diameter", "10", "--teeth", "4", "--fz", "0.05")
    speed = 160000 / (math.pi * 10)
    for key, value in (("n_rpm", speed), ("vf_mm_min", 4 * 0.05 * speed), ("d_eff_mm", 10), ("power_W", None), ("clamped_by", [])):
        same = data[key] == value if not isinstance(value, float) else abs(data[key] - value) < 1e-9 * value
        if not same:
            faults.append(f"data: {key} is {data[key]}, not {value}")
    if run("data", "--vc", "160", "--diameter", "5", "--teeth", "4", "--fz", "0.05", "--machine", "fv25cnc-a")["clamped_by"] != ["spindle.max"]:
        faults.append("data: the machine's highest speed is not said")
    materials = run("data", "--list")["materials"]
    if len(materials) < 30 or not all(m.get("kienzle", {}).get("source") for m in materials):
        faults.append("data --list: a material without its source")

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "shop.toml").write_text(COST)
        (folder / "blade.toml").write_text(BLADE)
        cost = run("cost", "shop.toml", "--time", "166", folder=folder)
        if abs(sum(cost["items"].values()) - cost["per_piece"]) > 1e-9 or abs(cost["per_year"] - 1000 * cost["per_piece"]) > 1e-6:
            faults.append(f"cost: the items do not add up: {cost}")
        if run("cost", "shop.toml", code=3, folder=folder)["per_piece"] is not None:
            faults.append("cost: a price of a time that nobody knows")
        stages = run("blade", "blade.toml", folder=folder)["stages"]
        if [s["finished"] for s in stages] != [0, 0.25, 0.5, 0.75, 1] or not stages[0]["f_Hz"][0] > stages[-1]["f_Hz"][0]:
            faults.append(f"blade: {stages}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
