#!/usr/bin/env python3
"""Random RS-274 programs print the same canonical calls by obrys and by rs274, or are refused at the same line.

usage: random_programs.py OBRYS [-n COUNT] [--seed N] [--keep FOLDER]      exit 77 (skipped) where rs274 is missing

A program mixes motion, arcs, cycles, offsets, rotation, units, planes, modes, compensation, expressions and subroutines;
its seed is printed where it differs. Tool changes are left out: 2.9 prints them in another way than 2.10, which obrys follows.
"""
import argparse
import difflib
import pathlib
import random
import sys
import tempfile

import endpoint
import runner

LINES = 30


class Program:
    """Writes lines that are mostly good: state is tracked only as far as needed for that."""

    def __init__(self, seed):
        self.r = random.Random(seed)
        self.plane, self.incremental, self.compensated, self.labels = 17, False, False, 100
        self.lines = ["F100", "S500 M3"]

    def number(self, low=-20.0, high=20.0):
        value = f"{self.r.uniform(low, high):.{self.r.choice((0, 1, 3))}f}"
        if self.r.random() < 0.1:
            return f"[{value}+{self.r.randint(0, 3)}*2]"
        if self.r.random() < 0.05:
            return f"#{self.r.randint(1, 5)}"
        return value

    def words(self, letters, least=1):
        chosen = [c for c in letters if self.r.random() < 0.5]
        while len(chosen) < least:
            chosen = sorted({*chosen, self.r.choice(letters)})
        self.r.shuffle(chosen)
        return " ".join(c + self.number() for c in chosen)

    def line(self):
        self.lines.append(f"G{self.r.choice((0, 1, 1))} {self.words('XYZA' if self.r.random() < 0.2 else 'XYZ')}")

    def arc(self):
        first, second, offsets = {17: ("X", "Y", "IJ"), 18: ("X", "Z", "IK"), 19: ("Y", "Z", "JK")}[self.plane]
        code = self.r.choice((2, 3))
        if self.r.random() < 0.4:   # full circle
            self.lines.append(f"G{code} {offsets[0]}{self.r.uniform(2, 9):.3f}" + (" P2" if self.r.random() < 0.2 else ""))
        elif self.r.random() < 0.5:
            reach = "" if self.incremental else "G91 "
            back = "" if self.incremental else " \nG90"
            self.lines += (f"{reach}G{code} {first}{self.r.uniform(-5, 5):.3f} {second}{self.r.uniform(-5, 5):.3f} "
                           f"R{self.r.choice((-1, 1)) * self.r.uniform(8, 20):.3f}{back}").split("\n")
        else:
            a, b = self.r.uniform(1, 9), self.r.uniform(1, 9)
            reach = "" if self.incremental else "G91 "
            self.lines.append(f"{reach}G{code} {first}{2 * a:.3f} {second}{2 * b:.3f} {offsets[0]}{a:.4f} {offsets[1]}{b:.4f}"
                              + (f" {'ZYX'[self.plane - 17]}{self.number()}" if self.r.random() < 0.3 else ""))
            self.lines += [] if self.incremental else ["G90"]

    def cycle(self):
        if self.compensated:
            return
        depth = {17: "Z", 18: "Y", 19: "X"}[self.plane]
        others = "XYZ".replace(depth, "")
        code, extra = self.r.choice(((81, ""), (82, " P.5"), (83, " Q1.5"), (73, " Q2"), (85, ""), (86, " P0"), (89, " P1"), (84, "")))
        top, bottom = (-1.0, -3.0) if self.incremental else (self.r.uniform(21, 25), self.r.uniform(-30, -21))
        repeat = f" L{self.r.randint(1, 3)}" if self.r.random() < 0.3 else ""
        if self.r.random() < 0.3:
            self.lines.append(self.r.choice(("G98", "G99")))
        self.lines.append(f"G{code} {self.words(others)} {depth}{bottom:.3f} R{top:.3f}{extra}{repeat}")
        if self.r.random() < 0.6:
            self.lines.append(self.words(others))
        self.lines.append("G80")

    def mode(self):
        choice = self.r.choice(("G90", "G91", "G17", "G18", "G19", "G20", "G21", "G61", "G64", "G64 P.1", "G91.1", "M8", "M9", "M7",
                                "G93\nG1 X1 F2\nG94\nF50", "M48", "M49", "G4 P.5", "S200", "M4", "M3", "F77"))
        if choice in ("G17", "G18", "G19"):
            if self.compensated:
                return
            self.plane = int(choice[1:])
        if choice in ("G90", "G91"):
            self.incremental = choice == "G91"
        if choice.startswith("G93") and self.compensated:
            return
        self.lines += choice.split("\n")

    def offset(self):
        if self.compensated:
            return
        self.lines.append(self.r.choice((
            f"G10 L2 P{self.r.randint(0, 9)} {self.words('XYZ')}", f"G10 L2 P{self.r.randint(1, 3)} X{self.number()} R{self.number()}",
            f"G10 L20 P{self.r.randint(0, 3)} {self.words('XYZ')}", f"G92 {self.words('XYZA')}", "G92.1", "G92.2", "G92.3",
            f"G52 {self.words('XYZ')}", self.r.choice(("G54", "G55", "G56", "G59.3")), f"G53 G0 {self.words('XYZ')}",
            "G28", f"G28 {self.words('XYZ')}", "G28.1", "G30", "G30.1", "G49", f"G43.1 Z{self.number()}")))
        if self.incremental and self.lines[-1].startswith("G53"):
            self.lines.pop()

    def value(self):
        r = self.r
        self.lines.append(r.choice((
            f"#{r.randint(1, 5)}=[{self.number()}*{r.randint(1, 4)}-SIN[{r.randint(0, 360)}]]",
            f"#{r.randint(1, 5)}=ROUND[{self.number()}]", f"#<n>=[{r.randint(1, 9)} MOD {r.randint(1, 4)}]",
            f"#{r.randint(1, 5)}=[2**{r.randint(0, 4)}/{r.randint(1, 5)}]", "(debug,#1 #2 #3 #5420 #5421 #5422)",
            "(debug,#5221 #5222 #5211 #5212 #5230 #<_x> #<_motion_mode>)", f"#{r.randint(1, 5)}=ATAN[{self.number()}]/[3]",
            f"#{r.randint(1, 5)}=FIX[{self.number()}]")))

    def flow(self):
        self.labels += 1
        n = self.labels
        kind = self.r.choice(("if", "while", "repeat", "sub"))
        inner = f"G0 X[#9+{self.r.randint(0, 5)}]"
        if kind == "if":
            self.lines += [f"o{n} if [#1 GT {self.r.randint(-3, 3)}]", inner, f"o{n} else", "G0 Y1", f"o{n} endif"]
        elif kind == "while":
            self.lines += ["#9=0", f"o{n} while [#9 LT {self.r.randint(0, 3)}]", inner, "#9=[#9+1]", f"o{n} endwhile"]
        elif kind == "repeat":
            self.lines += [f"o{n} repeat [{self.r.randint(0, 3)}]", inner, f"o{n} endrepeat"]
        else:
            self.lines += [f"o{n} sub", "G0 X#1 Y#2", "#1=7", f"o{n} endsub [#1+1]", f"o{n} call [{self.number()}] [2]", "(debug,#1 #<_value>)"]

    def compensation(self):
        if self.compensated:
            self.lines += ["G40", "G0 X0 Y0"]
            self.compensated = False
        elif self.plane == 17 and not self.incremental:
            side = self.r.choice(("41", "42"))
            self.lines += ["G0 X0 Y0", f"G{side}.1 D{self.r.choice((0.5, 1, 2))}", f"G1 X{self.r.uniform(5, 9):.2f} Y{self.r.uniform(5, 9):.2f}"]
            self.compensated = True

    def text(self):
        kinds = (self.line, self.line, self.line, self.arc, self.cycle, self.mode, self.offset, self.value, self.flow, self.compensation)
        while len(self.lines) < LINES:
            self.r.choice(kinds)()
            if self.r.random() < 0.05:
                self.lines[-1] = f"N{self.r.randint(1, 99999)} " + self.lines[-1] if not self.lines[-1].startswith(("o", "N")) else self.lines[-1]
        return "\n".join(self.lines) + "\nM2\n"


def differs(obrys, path):
    """What is printed differently, or refused by one only; nothing when they agree."""
    there, here = runner.run_referee(path), runner.run_obrys(obrys, path)
    wanted, printed = runner.calls(there.out), runner.calls(here.out)
    if wanted != printed:
        said = [f"rs274: {there.refused}"] if there.refused else []
        said += [f"obrys: {endpoint.first_error(here.err)}"] if here.code else []
        return said + list(difflib.unified_diff(wanted, printed, "rs274", "obrys", lineterm="", n=2))[:12]
    if (there.code == 0) != (here.code == 0):
        return [f"rs274 exit {there.code} {there.refused}, obrys exit {here.code} {endpoint.first_error(here.err)}"]
    if there.refused and (endpoint.error_line(here.err) or "").strip() != there.refused[1].strip():
        return [f"rs274 refuses {there.refused}, obrys {endpoint.first_error(here.err)}"]
    return []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("-n", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    if not runner.REFEREE_HERE:
        print("skipped: needs rs274 of LinuxCNC")
        return 77
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.seed, options.seed + options.n):
            path = pathlib.Path(options.keep or folder) / f"random{seed}.ngc"
            path.write_text(Program(seed).text())
            said = differs(options.obrys, path)
            if said:
                wrong += 1
                print(f"seed {seed}:\n    " + "\n    ".join(said))
            elif options.keep:
                path.unlink()
    print(f"{options.n - wrong} of {options.n} programs agree (seeds {options.seed} to {options.seed + options.n - 1})")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
