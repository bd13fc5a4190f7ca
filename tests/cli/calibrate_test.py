#!/usr/bin/env python3
"""`obrys calibrate`: a machine whose runs are known is found again; what the runs cannot show is left alone; bad tables
are refused at their line and column.

usage: calibrate_test.py OBRYS

The runs are those of a machine with other values, as `obrys time` tells them: the fit must come back to these.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

MACHINE = """name = "shop"
kind = "mill"
tool_change_time = 5
[motion]
acceleration = 1000
jerk = 40000
corner = "filter"
block_time = 0
look_ahead = 0
tolerance = 0.01
[origin]
tool_change_time = "assumed"
"motion.acceleration" = "assumed"
"motion.jerk" = "assumed"
"axis.rapid" = "assumed"
[[axis]]
name = "X"
rapid = 20000   # as it says on the door
[[axis]]
name = "Y"
rapid = 20000
[[axis]]
name = "Z"
rapid = 20000
"""
TRUE = {"tool_change_time": 8.5, "motion.acceleration": 2500, "motion.jerk": 25000, "rapid": 30000}

BAD = [
    ("program,seconds\npart.ngc,fast\n", "runs.csv:2:10: ", "'seconds' must be a number, not 'fast'"),
    ("program,seconds\npart.ngc,-3\n", "runs.csv:2:10: ", "'seconds' must be above 0"),
    ("program,seconds\npart.ngc,\n", "runs.csv:2:1: ", "a run without 'seconds'"),
    ("program,seconds\nnone.ngc,12\n", "runs.csv:2:1: ", "none.ngc"),
    ("program,second\npart.ngc,12\n", "runs.csv:1:9: ", "'second' is no column"),
    ("program,seconds\npart.ngc,12,4\n", "runs.csv:2:13: ", "3 values in a table of 2 columns"),
    ("program,seconds\n", "runs.csv:1:1: ", "the table names no run"),
    ("program,seconds,first,last\npart.ngc,12,9,3\n", "runs.csv:2:15: ", "'last' lies before 'first'"),
    ("program,seconds,trace\npart.ngc,,trace.csv\n", "trace.csv:4:1: ", "times must grow"),
]
TRACE = "t,x,y,z\n0,0,0,0\n1,10,0,0\n1,20,0,0\n"


def main():
    obrys, faults = sys.argv[1], []

    def run(*args, cwd):
        return subprocess.run([obrys, *args], capture_output=True, text=True, cwd=cwd, timeout=300)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "shop.toml").write_text(MACHINE)
        made = run("calibrate", "--program", "--to", "linuxcnc", "--size", "600", "-o", "part.ngc", cwd=folder)
        if made.returncode != 0:
            print(made.stderr)
            return 1
        true = MACHINE.replace("= 5\n", f"= {TRUE['tool_change_time']}\n").replace("20000", str(TRUE["rapid"]))
        true = true.replace("acceleration = 1000", f"acceleration = {TRUE['motion.acceleration']}")
        true = true.replace("jerk = 40000", f"jerk = {TRUE['motion.jerk']}")
        (folder / "true.toml").write_text(true)
        told = json.loads(run("time", "part.ngc", "--machine", "true.toml", "--format", "json", cwd=folder).stdout)
        # Part by part, as an operator times them between the optional stops.
        text = (folder / "part.ngc").read_text().splitlines()
        ends = [i for i, line in enumerate(text, 1) if "M1" in line.split()]
        rows, begin = ["program,seconds,first,last"], 1
        for end in ends:
            seconds = sum(line["seconds"] for line in told["by_line"] if begin <= line["line"] <= end)
            rows.append(f"part.ngc,{seconds:.2f},{begin},{end}")
            begin = end + 1
        (folder / "runs.csv").write_text("\n".join(rows) + "\n")
        fitted = run("calibrate", "shop.toml", "runs.csv", "-o", "new.toml", "--format", "json", cwd=folder)
        if fitted.returncode != 0:
            print(fitted.stdout, fitted.stderr)
            return 1
        answer = json.loads(fitted.stdout)
        by_name = {v["name"]: v for v in answer["values"]}
        for key, want in (("motion.acceleration", 2500), ("motion.jerk", 25000), ("axis.rapid", 1.5)):
            got = by_name[key]
            if got["sight"] == "not-seen" or abs(got["after"] / want - 1) > 0.15:
                faults.append(f"{key}: {got} instead of {want}")
        if answer["residual_after"] > 0.01:
            faults.append(f"the residual is {answer['residual_after']}")
        if by_name["motion.spindle_time"]["sight"] != "not-seen":
            faults.append(f"no spindle turns, yet its time is seen: {by_name['motion.spindle_time']}")
        written = tomllib.loads((folder / "new.toml").read_text())
        if abs(written["motion"]["jerk"] / 25000 - 1) > 0.15 or "calibrated from runs.csv" not in written["origin"]["motion.jerk"]:
            faults.append(f"written: {written}")
        if "spindle_time" in written["motion"] or "# as it says on the door" not in (folder / "new.toml").read_text():
            faults.append("what was not seen was written, or a remark is gone")
        again = run("time", "part.ngc", "--machine", "new.toml", "--format", "json", cwd=folder)
        total = json.loads(again.stdout)["total_s"]
        if abs(total / told["total_s"] - 1) > 0.01:
            faults.append(f"the new machine takes {total} s, the true one {told['total_s']} s")
        if run("calibrate", "shop.toml", "runs.csv", "-o", "new.toml", cwd=folder).returncode != 2:
            faults.append("a file that is there was replaced without --force")
        if run("calibrate", "shop.toml", "runs.csv", "-o", "shop.toml", "--force", cwd=folder).returncode != 2:
            faults.append("the machine file itself was replaced")
        (folder / "trace.csv").write_text(TRACE)
        for table, where, what in BAD:
            (folder / "runs.csv").write_text(table)
            bad = run("calibrate", "shop.toml", "runs.csv", cwd=folder)
            if bad.returncode != 2 or where not in bad.stderr or what not in bad.stderr:
                faults.append(f"{table!r}: {bad.returncode} {bad.stderr}")
        # A trace of 200 mm there and back at 30 m/min, every 20 ms: beyond the rapid of the file.
        samples, way = ["t,x,y,z"], [500 * min(t, 0.4, 0.8 - t) if t < 0.8 else 0 for t in (0.02 * i for i in range(41))]
        samples += [f"{0.02 * i:.2f},{x:.4f},0,0" for i, x in enumerate(way)]
        (folder / "trace.csv").write_text("\n".join(samples) + "\n")
        (folder / "rapid.ngc").write_text("G21 G90\nG0 X0 Y0 Z0\nG0 X200\nG0 X0\nM2\n")
        (folder / "runs.csv").write_text("program,seconds,trace\nrapid.ngc,,trace.csv\n")
        told = json.loads(run("calibrate", "shop.toml", "runs.csv", "--format", "json", cwd=folder).stdout)
        rapid = next(v for v in told["values"] if v["name"] == "axis.rapid")
        if rapid["sight"] != "seen" or abs(rapid["after"] / 1.5 - 1) > 0.1 or abs(told["runs"][0]["measured_s"] - 0.8) > 1e-6:
            faults.append(f"the trace shows 30 m/min: {rapid}, {told['runs']}")
        for post in ("fanuc", "heidenhain-itnc530", "heidenhain-iso", "sinumerik-840d", "haas", "linuxcnc"):
            made = run("calibrate", "--program", "--to", post, cwd=folder)
            if made.returncode != 0 or not made.stdout:
                faults.append(f"--to {post}: {made.returncode} {made.stderr}")
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
