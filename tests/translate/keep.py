#!/usr/bin/env python3
"""Programs translated by structure (translate --keep) can be called with other values: the groove of examples/groove, and of
SHARED where that is there, to every control, and what was written on to the next one, with 20 sets of values each; RADIUS.H and UKOS.H, which mill along a contour, to
SINUMERIK.

usage: keep.py OBRYS EXAMPLES [SHARED]
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from random import Random

SETS = 20
JOB = """program = "{program}"
control = "{control}"
machine = "lathe-generic"
[defaults]
diameter_programming = false
{more}
[[tool]]
number = 5
name = "grooving insert 3 mm"
kind = "groove"
width = 3.0
corner_radius = 0.0
reference = "left"
"""


def translate(obrys, job, to, out):
    """Sets of values with which both do the same."""
    run = subprocess.run([obrys, "translate", job, "--keep", "--to", to, "--sets", str(SETS), "-o", out, "--force"],
                         capture_output=True, text=True, timeout=600)
    same = len(re.findall(r"^does the same", run.stderr, re.M))
    if run.returncode != 0 or same != SETS + 1:
        print(run.stderr)
        raise SystemExit(f"{job.name} to {to}: {same} of {SETS + 1} sets, exit code {run.returncode}")
    print(f"{job.name} to {to}: the same with {same} sets of values")


def without_cutting_speed(text):
    """Klartext of the iTNC 530 has no constant cutting speed: the spindle turns at 500/min instead."""
    return re.sub(r"G96 S\d+ LIMS=\d+", "G97 S500", text)


def groove(obrys, folder, main, more, name):
    """From the SINUMERIK programs of a folder to all, and back."""
    text = (folder / main).read_text(encoding="latin-1")
    job = folder / f"{name}.toml"
    job.write_text(JOB.format(program=main, control="sinumerik-840d", more=more))
    for to in ("fanuc", "haas"):
        translate(obrys, job, to, folder / f"{name}_{to}.nc")
    (folder / main).write_text(without_cutting_speed(text), encoding="latin-1")
    klartext = folder / f"{name}.H"
    translate(obrys, job, "heidenhain-itnc530", klartext)
    back = folder / f"{name}_back.toml"
    variables = more.replace("R0", "Q0")
    back.write_text(JOB.format(program=klartext.name, control="heidenhain-itnc530", more=variables))
    for to in ("sinumerik-840d", "fanuc"):
        translate(obrys, back, to, folder / f"{name}_back_{to}.txt")


MILL = """program = "{program}"
control = "{control}"
machine = "mill-generic"
[[tool]]
number = 1
kind = "bull-nose"
diameter = 8.0
corner_radius = 3.0
"""


def set_of(program, random):
    """Values for what RADIUS.H and UKOS.H take, round ones among them; Q9 = 0 has the tool table asked."""
    values = {
        "Q0": random.choice([0, 1, 1, 1]), "Q6": random.choice([0, 1, 2]), "Q15": random.choice([1, 0, -1]),
        "Q9": random.choice([0, 4, round(random.uniform(1, 5), 3)]), "Q1": round(random.uniform(-2, 2), 3),
        "Q2": round(random.uniform(-3, 0), 3), "Q10": random.choice([0.5, 1, round(random.uniform(0.1, 2), 3)]),
        "Q5": round(random.uniform(-10, 10), 2), "Q7": round(random.uniform(30, 50), 1),
        "Q11": random.choice([100, 333]), "Q12": random.choice([500, 777])}
    if program.startswith("RADIUS"):
        values["Q8"] = random.choice([-9, round(random.uniform(1, 13), 2), -round(random.uniform(5, 17), 2)])
        ends = sorted([random.choice([-45, 0, 30, 90, round(random.uniform(-90, 90), 1)]), round(random.uniform(-60, 60), 1)])
        values["Q3"], values["Q4"] = ends if values["Q8"] < 0 else ends[::-1]
    else:
        values["Q3"] = random.choice([0, 30, 45, round(random.uniform(-75, 75), 1)])
        values["Q4"] = random.choice([-10, -5, -round(random.uniform(0.5, 12), 2)])
    return values


def profile(obrys, folder, program):
    """RADIUS.H and UKOS.H by structure to SINUMERIK, and compared with random sets of what they take."""
    job = folder / f"{program}_a.toml"
    job.write_text(MILL.format(program=f"HL_{program}.H", control="heidenhain-itnc530"))
    out = folder / f"{program}.MPF"
    translate(obrys, job, "sinumerik-840d", out)
    there = folder / f"{program}_b.toml"
    there.write_text(MILL.format(program=out.name, control="sinumerik-840d"))
    random = Random(13)
    same = alarms = 0
    for _ in range(20 * SETS):
        values = set_of(program, random)
        given = [word for name, value in values.items() for word in ("--set", f"{name}={value}")]
        run = subprocess.run([obrys, "compare", job, there, "--ledger", f"{out}.ledger.json", *given],
                             capture_output=True, text=True, timeout=600)
        if run.returncode == 0:
            same += 1
        elif len(re.findall(r"^\S+: error: ", run.stderr, re.M)) >= 2:
            alarms += 1  # both stop
        else:
            raise SystemExit(f"{program} {values}: {run.returncode}\n{run.stdout}{run.stderr}")
        if same == SETS:
            break
    print(f"{program} to sinumerik-840d: compare finds {same} random sets equal, {alarms} end with an alarm in both")
    if same < SETS:
        raise SystemExit(f"{program}: too few sets that run")


def profiles(obrys, folder, source):
    shutil.copytree(source, folder)
    for name in ("RADIUS", "UKOS"):
        main = (folder / f"HL_{name}.H").read_text(encoding="latin-1")
        (folder / f"HL_{name}_OPR.H").write_text(main.replace(f"PGM {name}", f"PGM {name}_OPR"), encoding="latin-1")
        for program in (name, f"{name}_OPR"):
            profile(obrys, folder, program)


def main():
    obrys, examples = sys.argv[1], pathlib.Path(sys.argv[2])
    shared = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made) / "examples"
        shutil.copytree(examples / "groove", folder)
        groove(obrys, folder, "GROOVE_MAIN.MPF", "", "groove")
        source = shared / "programs" / "groove" if shared else None
        if source is None or not source.is_dir():
            print("the groove of the thesis is not there: left out")
            return
        folder = pathlib.Path(made) / "thesis"
        shutil.copytree(source, folder)
        groove(obrys, folder, "HLAVNI.MPF", "[variables]\nR0 = 180", "thesis")
        job = folder / "linuxcnc.toml"
        job.write_text(JOB.format(program="HLAVNI.MPF", control="sinumerik-840d", more="[variables]\nR0 = 180"))
        translate(obrys, job, "linuxcnc", folder / "thesis.ngc")
        profiles(obrys, pathlib.Path(made) / "profiles", shared / "programs" / "heidenhain")


if __name__ == "__main__":
    main()
