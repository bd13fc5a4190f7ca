#!/usr/bin/env python3
"""Programs translated by structure (translate --keep) can be called with other values: the groove of examples/groove, and of
SHARED where that is there, to every control, and what was written on to the next one, with 20 sets of values each.

usage: keep.py OBRYS EXAMPLES [SHARED]
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

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


if __name__ == "__main__":
    main()
