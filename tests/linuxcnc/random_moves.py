#!/usr/bin/env python3
"""Random programs run alike by obrys and by LinuxCNC's rs274: the same moves and settings in the same order, or the same refusal.

usage: random_moves.py OBRYS [-n COUNT] [--seed N] [--keep FOLDER] [--least PERCENT]      exit 77 (skipped) where rs274 is missing

Beside what random_programs.py mixes these have splines (G5, G5.1, G5.2), compensation in G18 and with arcs, series of cycles with changing words and
modes, o-words within each other, text commands, saved modes, and now and then a word that the line has no use for. Numbers are compared with a
tolerance (a coordinate on the edge of rounding is no difference, nor is -0), messages by themselves: a move that waits for its successor under
compensation prints a message before or after it. Each program that differs is printed with its seed.
"""
import argparse
import collections
import pathlib
import re
import sys
import tempfile

import endpoint
import random_programs
import runner
from random_moves_cases import KNOWN

LINES = 26
TOLERANCE = 1.01e-4   # a unit of the last printed decimal
NUMBER = re.compile(r"-?\d+\.\d+|-?\bnan\b")
TALK = ("COMMENT(", "MESSAGE(", "LOG(", "LOGOPEN(", "LOGCLOSE(")
CYCLES = ((81, "", ""), (82, "P.5", "P.25"), (83, "Q1.5", "Q2"), (73, "Q2", "Q1"), (85, "", ""), (86, "P0", "P.1"), (89, "P1", "P.2"), (84, "", ""))


class Program(random_programs.Program):
    """Lines that are mostly good; `lathe`: the program stays in G18 and compensates there."""

    def __init__(self, seed):
        super().__init__(seed)
        self.words_kept = 0
        self.saved = False
        if self.r.random() < 0.25:
            self.plane = 18
            self.lines.append("G18")

    def near(self, low=1.0, high=9.0):
        return f"{self.r.uniform(low, high):.3f}"

    def spline(self):
        if self.compensated or self.plane != 17:
            return
        kind = self.r.choice((5, 51, 52, 52))
        if kind == 5:
            self.lines.append(f"G5 I{self.number()} J{self.number()} P{self.number()} Q{self.number()} X{self.number()} Y{self.number()}")
            for _ in range(self.r.randint(0, 2)):
                self.lines.append(f"{self.r.choice(('', 'G5 '))}P{self.number()} Q{self.number()} {self.words('XY')}")
        elif kind == 51:
            self.lines.append(f"G5.1 X{self.number()} Y{self.number()} I{self.number()} J{self.number()}")
        else:
            order = self.r.choice(("", " L3", " L4"))
            self.lines.append(f"G5.2 X{self.near()} Y{self.near()} P{self.r.choice((1, 1, 2, .5))}{order}")
            self.lines += [f"X{self.number()} Y{self.number()} P{self.r.choice((1, 1, 1.5))}" for _ in range(self.r.randint(2, 5))]
            self.lines.append("G5.3")
        self.lines += ["G1 " + self.words("XYZ"), "(debug,#5420 #5421 #5422)"]

    def series(self):
        """Cycles that stay active over several lines, with words, modes and offsets that change between them."""
        if self.compensated:
            return
        depth = {17: "Z", 18: "Y", 19: "X"}[self.plane]
        others = "XYZ".replace(depth, "")
        code, first, later = self.r.choice(CYCLES)
        top, bottom = (-1.0, -3.0) if self.incremental else (self.r.uniform(21, 25), self.r.uniform(-30, -21))
        self.lines.append(f"{self.r.choice(('G98 ', 'G99 ', ''))}G{code} {self.words(others)} {depth}{bottom:.3f} R{top:.3f} {first}")
        for _ in range(self.r.randint(1, 4)):
            change = self.r.choice(("", "", f" L{self.r.randint(1, 3)}", f" R{top + self.r.uniform(-3, 3):.2f}", f" {depth}{bottom - 1:.2f}",
                                    " " + later, " G98", " G99", " F50"))
            self.lines.append((self.words(others) + change).strip())
            if self.r.random() < 0.15:
                other, words, _ = self.r.choice(CYCLES)
                self.lines.append(f"G{other} {self.words(others)} {depth}{bottom:.3f} R{top:.3f} {words}")
        self.lines.append(self.r.choice(("G80", "G80", "G0 X1", "G1 Y2")))

    def compensation(self):
        if self.compensated or self.incremental or self.plane == 19:
            return super().compensation()
        first, second, centre = ("X", "Y", "IJ") if self.plane == 17 else ("Z", "X", "KI")
        side = self.r.choice(("41", "42"))
        word = f"G{side}.1 D{self.r.choice((0.5, 1, 2))}" + (f" L{self.r.randint(0, 9)}" if self.plane == 18 and self.r.random() < 0.7 else "")
        self.lines += [f"G0 {first}0 {second}0", word, f"G1 {first}{self.near(5, 9)} {second}{self.near(5, 9)}"]
        turn = 1 if side == "41" else -1
        at = [10.0, 10.0]
        for k in range(self.r.randint(1, 4)):
            at = [at[0] + 10, at[1] + turn * (k - 1) * 5]
            if self.r.random() < 0.3:
                self.lines.append(f"G{self.r.choice((2, 3))} {first}{at[0]:.3f} {second}{at[1]:.3f} R{self.near(15, 25)}")
            elif self.r.random() < 0.2:
                self.lines.append(f"G{self.r.choice((2, 3))} {centre[0]}{self.near(6, 9)} {centre[1]}{self.near(6, 9)}")
            else:
                self.lines.append(f"G1 {first}{at[0]:.3f} {second}{at[1]:.3f}" + (f" F{self.r.randint(50, 200)}" if self.r.random() < .2 else ""))
        self.lines += ["G40", f"G0 {first}0 {second}-20"]
        return None

    def nested(self):
        self.labels += 3
        a, b, c = self.labels, self.labels - 1, self.labels - 2
        r = self.r
        self.lines += r.choice((
            [f"#9={r.randint(0, 4)}", f"o{a} while [#9 GT 0]", f"o{b} if [#9 EQ 2]", "#9=[#9-1]", f"o{a} {r.choice(('continue', 'break'))}" if r.random() < .2 else "G0 X#9",
             f"o{b} elseif [#9 EQ 3]", "G1 Y[#9*2]", f"o{b} else", f"o{a} break" if r.random() < .2 else "G0 Z1", f"o{b} endif", "#9=[#9-1]", f"o{a} endwhile"],
            ["#9=0", f"o{a} do", f"G1 X#9 Y[#9**2]", "#9=[#9+1]", f"o{a} while [#9 LT {r.randint(0, 4)}]"],
            [f"o{a} sub", f"o{b} repeat [#2]", "G91 G1 X#1", f"o{b} endrepeat", "G90", f"o{c} if [#1 GT 2]", f"o{a} return [#1*2]", f"o{c} endif", "#<v>=[#1+#2]",
             "(debug,#<v> #1 #3)", f"o{a} endsub", f"o{a} call [{self.near(0, 5)}] [{r.randint(0, 3)}]", "(debug,#<_value> #<_value_returned>)"]
            if not self.compensated and not self.incremental else ["G4 P0"],
            [f"o<s{a}> sub", "M73", "G91 G20", "G1 X.1 F9", f"o<s{a}> endsub", f"o<s{a}> call"] if not self.compensated else ["M9"],
            ["G4 P0"],
        ))

    def talk(self):
        self.lines.append(self.r.choice((
            "(msg,here)", "(debug,a #5420 b #<_feed>)", "(print,x=#5420)", "; nothing", "(just a comment)", "G0 X1 (msg,behind)", "(debug,%d#1)", "(debug,%f#1 %.2f#2)",
            "(debug,#<_metric> #<_absolute> #<_plane> #<_ccomp>)", "(debug,#5400 #5403 #5410)", "(one)(msg,two)")))

    def keep_modes(self):
        if self.compensated:
            return
        self.lines += self.r.choice((["M70", "G91 G1 X1 F30", "G20", "M72"], ["M70", "G19", "M72", f"G{self.plane}"], ["M71"]))
        self.lines.append("G91" if self.incremental else "G90")

    def slip(self):
        """A word without use, or twice; a code that fights another."""
        self.lines.append(self.r.choice((
            "X5 Y5 I3 J3", "X1 P2", "Y1 L2", "X2 Q1", "Z1 D3", "X1 H1", "X1 R2", "X1 X2", "G0 G1 X1", "G1 X1 K2", "G2 X1", "G0 X1 /Y2", "G90 G91 X1", "M3 M4", "F1 F2",
            "G81 X1", "G0 A1 E2", "G55 G56", "X1 $2", "G43 X1", "G80 X1", "G53 X1", "#1=2 X#1 #1=3", "#31=#32", "#<a>=1", "#5221=4", "X[1", "X1 )", "G4", "G10 L2", "M98", "X#0"))
            if self.r.random() < 0.3 else "M9")

    def text(self):
        kinds = (self.line, self.line, self.arc, self.arc, self.cycle, self.series, self.mode, self.offset, self.value, self.flow, self.compensation,
                 self.spline, self.nested, self.talk, self.keep_modes)
        while len(self.lines) < LINES:
            self.r.choice(kinds)()
            if self.r.random() < 0.01:
                self.slip()
        return "\n".join(self.lines) + "\nM2\n"


def numbers_apart(text):
    return NUMBER.sub("#", text), [float(n) for n in NUMBER.findall(text)]


def same_call(a, b):
    if a == b:
        return True
    (shape, these), (other, those) = numbers_apart(a), numbers_apart(b)
    return shape == other and all(abs(p - q) <= TOLERANCE + 1e-7 * abs(p) or p != p and q != q for p, q in zip(these, those))


def split(calls):
    talk = [c for c in calls if c.split(" ", 1)[-1].lstrip("N. ").startswith(TALK)]
    return [c for c in calls if c not in talk], talk


def first_difference(wanted, printed):
    for k in range(max(len(wanted), len(printed))):
        a, b = (calls[k] if k < len(calls) else "(end)" for calls in (wanted, printed))
        if not same_call(a, b):
            before = wanted[k - 1] if k > 0 else "(begin)"
            return [f"behind {before}", f"  rs274 {a}", f"  obrys {b}"]
    return []


def error_lines(text):
    """The lines obrys complains about; it reads the whole program before it runs it, and may name a later one first."""
    lines = text.splitlines()
    return {lines[k + 1].strip() for k in range(len(lines) - 1) if endpoint.PLACED.match(lines[k])}


def differs(obrys, path, setting=None):
    """What is run or refused in another way; nothing where they agree. And whether the program ran to its end."""
    there, here = runner.run_referee(path, setting), runner.run_obrys(obrys, path, setting)
    if there.code is None:
        return ([] if here.code is None or "[budget]" in here.err else ["rs274 does not end, obrys does"]), False
    if here.code is None or here.code < 0 or here.code > 100:
        return [f"obrys crashes or does not end: exit {here.code} {here.err[-200:]}"], False
    wanted, printed = split(runner.calls(there.out)), split(runner.calls(here.out))
    said = first_difference(wanted[0], printed[0]) or first_difference(wanted[1], printed[1])
    refused = [f"rs274: {there.refused}"] if there.refused else []
    refused += [f"obrys: {endpoint.first_error(here.err)}"] if here.code else []
    if said and "the control feeds along the wrong axes" in here.err and "ARC_FEED" in said[1] and "STRAIGHT_FEED" in said[2]:
        refused.append("obrys: the control feeds along the wrong axes, and a line leads to the arc behind")
    if said:
        return refused + said, False
    if bool(there.refused) != bool(endpoint.refusal(here.err)):
        return refused or ["one ends in another way"], False
    if there.refused and there.refused[1].strip() not in error_lines(here.err):
        return refused, False
    return [], there.code == 0


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("-n", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--least", type=float, default=97.0, help="percent that has to agree")
    return parser.parse_args()


def main():
    options = arguments()
    if not runner.REFEREE_HERE:
        print("skipped: needs rs274 of LinuxCNC")
        return 77
    count = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.seed, options.seed + options.n):
            path = pathlib.Path(options.keep or folder) / f"random{seed}.ngc"
            path.write_text(Program(seed).text())
            said, ran = differs(options.obrys, path)
            count["ran"] += ran
            known = next((why for pattern, why in KNOWN if any(re.search(pattern, s) for s in said)), "")
            count["known" if said and known else "wrong" if said else "agree"] += 1
            if said:
                print(f"seed {seed}:" + (f" known: {known}" if known else "") + "\n    " + "\n    ".join(said))
            elif options.keep:
                path.unlink()
    share = 100.0 * count["agree"] / options.n
    print(f"{count['agree']} of {options.n} programs agree ({share:.2f} %), {count['ran']} of them run to their end; {count['known']} differ as is known, "
          f"{count['wrong']} otherwise (seeds {options.seed} to {options.seed + options.n - 1})")
    return 1 if count["wrong"] or share < options.least else 0


if __name__ == "__main__":
    sys.exit(main())
