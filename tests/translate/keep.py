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
    for to, suffix in (("fanuc", "nc"), ("haas", "nc"), ("linuxcnc", "ngc")):
        translate(obrys, job, to, folder / f"{name}_{to}.{suffix}")
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


def goldens(obrys, folder):
    """The programs of the goldens, with more sets of values."""
    source = pathlib.Path(__file__).parent.parent / "golden" / "translate"
    for golden in sorted(source.glob("keep-*.txt")):
        sections = re.split(r"^--- (\w+)[ \t]*(.*)\n", golden.read_text(encoding="utf-8"), flags=re.M)[1:]
        parts = list(zip(sections[::3], sections[1::3], sections[2::3]))
        if "exit" in [kind for kind, _, _ in parts] and ("exit", "0", "") not in parts:
            continue
        here = folder / golden.stem
        here.mkdir(parents=True)
        for kind, name, text in parts:
            if kind == "file":
                (here / name).write_text(text, encoding="utf-8")
        command = [word for word in parts[0][1].split()[1:]]
        if "--sets" in command:
            del command[command.index("--sets"):command.index("--sets") + 2]
        run = subprocess.run([obrys, *command, "--sets", str(SETS)], capture_output=True, text=True, timeout=600, cwd=here)
        same = len(re.findall(r"^does the same", run.stderr, re.M))
        if run.returncode != 0 or same not in (1, SETS + 1):
            raise SystemExit(f"{golden.name}: {same} of {SETS + 1} sets, exit code {run.returncode}\n{run.stderr}")
        print(f"{golden.stem}: the same with {same} sets of values")


class RandomKlartext:
    """Blocks of what is translated between controls, one behind the other, by parameters Q1 to Q3."""

    def __init__(self, random, corners, scales):
        self.random, self.lines, self.label, self.corners, self.scales = random, [], 0, corners, scales

    def value(self):
        return self.random.choice(["+Q1", "+Q2", "-Q1", f"{self.random.uniform(-9, 9):+.2f}"])

    def corner(self):
        corner = self.random.choice([["RND R1.5"], ["CHF 1"], ["RND RQ3"], []])
        self.lines += ["L X+0 Y+0", "L X+30", *corner, "L Y+40", *corner, "L IX-20 IY+10"]

    def arc(self):
        sense = self.random.choice("+-")
        self.lines += ["L X+Q1 Y+0", f"CC X+Q1 Y+Q2", "Q9 = Q2 * 2", f"C X+Q1 Y+Q9 DR{sense}"]

    def frame(self):
        self.lines += ["CYCL DEF 7.0 DATUM SHIFT", f"CYCL DEF 7.1 X{self.value()}", f"CYCL DEF 7.2 Y{self.value()}"]
        if self.random.random() < 0.6:
            self.lines += ["CYCL DEF 10.0 ROTATION", f"CYCL DEF 10.1 ROT{self.value()}"]
        self.random.choice([self.corner if self.corners else self.arc, self.arc, self.drill])()
        if self.random.random() < 0.5:
            self.lines += ["CYCL DEF 7.0 DATUM SHIFT", f"CYCL DEF 7.1 X{self.value()}", "L X+1 Y+2"]
        self.lines += ["CYCL DEF 10.0 ROTATION", "CYCL DEF 10.1 ROT+0", "CYCL DEF 7.0 DATUM SHIFT", "CYCL DEF 7.1 X+0",
                       "CYCL DEF 7.2 Y+0"]

    def scaling(self):
        mirror = self.random.choice(["X", "Y", "X Y"])
        self.lines += ["CYCL DEF 8.0 MIRROR IMAGE", f"CYCL DEF 8.1 {mirror}", "CYCL DEF 11.0 SCALING",
                       "CYCL DEF 11.1 SCL 0.75", "L X+3 Y+4", "L X+Q1", "CYCL DEF 8.0 MIRROR IMAGE", "CYCL DEF 8.1",
                       "CYCL DEF 11.0 SCALING", "CYCL DEF 11.1 SCL 1"]

    def drill(self):
        self.lines += ["L Z+50 FMAX", f"CYCL DEF 200 DRILLING Q200=2 Q201=-Q1 Q206=150 Q202={self.random.choice(['3', '+Q2', '99'])} "
                       f"Q210={self.random.choice([0, 0.2])} Q203=-5 Q204={self.random.choice([0, 20])} Q211=0.1",
                       "L X+Q1 Y+Q2 FMAX M99", "L X-5 FMAX M99", "L Z+40 FMAX", "L Z+3 F500"]

    def loop(self, depth):
        self.label += 2
        begin, end = self.label - 1, self.label
        counter = f"Q{20 + self.label}"
        self.lines += [f"{counter} = 0", f"LBL {begin}"]
        if self.random.random() < 0.5:
            self.lines.append(f"FN 11: IF +Q1 GT {self.value()} GOTO LBL {end}")
        self.blocks(depth + 1)
        self.lines += [f"{counter} = {counter} + 1", f"FN 12: IF +{counter} LT +3 GOTO LBL {begin}", f"LBL {end}"]

    def branch(self, depth):
        self.label += 2
        other, end = self.label - 1, self.label
        self.lines.append(f"FN 11: IF {self.value()} GT +Q2 GOTO LBL {other}")
        self.blocks(depth + 1)
        self.lines += [f"FN 9: IF +0 EQU +0 GOTO LBL {end}", f"LBL {other}"]
        self.blocks(depth + 1)
        self.lines.append(f"LBL {end}")

    def blocks(self, depth):
        for _ in range(self.random.randint(1, 3)):
            kinds = [self.arc, self.frame, self.drill] + ([self.corner] if self.corners else []) + ([self.scaling] if self.scales else [])
            if depth < 2:
                kinds += [lambda: self.loop(depth), lambda: self.branch(depth)]
            self.random.choice(kinds)()
            self.lines.append(f"L X{self.value()} Y{self.value()} F500")

    def text(self):
        self.lines = ["TOOL CALL 1 Z S3000", "Q1 = 12.5", "Q2 = 7.25", "Q3 = 1.25", "L X+0 Y+0 Z+50 R0 FMAX M3",
                      "L Z+3 F500"]
        self.blocks(0)
        self.lines += ["L Z+50 FMAX", "M30"]
        lines = ["BEGIN PGM RANDOM MM", *self.lines, "END PGM RANDOM MM"]
        return "".join(f"{n} {line}\n" for n, line in enumerate(lines))


def random_programs(obrys, folder):
    folder.mkdir()
    for seed in range(25):
        for to in ("sinumerik-840d", "fanuc", "linuxcnc"):
            program = RandomKlartext(Random(seed), to != "linuxcnc", to == "sinumerik-840d").text()
            if to == "linuxcnc":  # it cannot turn its axes
                program = re.sub(r"\d+ CYCL DEF 10\..*\n", "", program)
            (folder / "RANDOM.H").write_text(program)
            run = subprocess.run([obrys, "translate", "RANDOM.H", "--keep", "--to", to, "--sets", "4", "--machine",
                                  "mill-generic", "-o", f"{to}.out", "--force"], capture_output=True, text=True,
                                 timeout=600, cwd=folder)
            if run.returncode != 0:
                raise SystemExit(f"random program {seed} to {to}: exit code {run.returncode}\n{program}{run.stderr}")
    print("25 random programs do the same on each of three controls, with 5 sets of values")


def main():
    obrys, examples = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    shared = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as made:
        goldens(obrys, pathlib.Path(made) / "goldens")
        random_programs(obrys, pathlib.Path(made) / "random")
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
