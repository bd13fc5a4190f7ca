#!/usr/bin/env python3
"""Random programs of o-words one in another: obrys makes the moves that LinuxCNC makes.

usage: o_words.py OBRYS [-n COUNT] [--seed N] [--keep FOLDER]

LinuxCNC pairs its o-words while it runs: it reads line by line, looks for a label while it skips, and remembers a break, a continue and the passes left
of a repeat past the loop they belong to. `Control` does the same over the few words these programs have. Where rs274 is installed it is asked, too:
a program where `Control` and rs274 part is a fault of `Control`.
"""
import argparse
import pathlib
import random
import re
import sys
import tempfile

import endpoint
import runner

MOVE = re.compile(r"STRAIGHT_TRAVERSE\((-?[0-9.]+), (-?[0-9.]+)")
O_LINE = re.compile(r"o(\d+) (\w+)(?: \[(.*)\])?$")
OPENERS = ("if", "while", "repeat", "do")
MOST_LINES = 4000     # that a run may read
LEVELS = 10           # calls in each other


class Refused(Exception):
    pass


class Endless(Exception):
    pass


class Control:
    """LinuxCNC's interpreter of o-words, line by line."""

    def __init__(self, text):
        self.lines = text.splitlines()
        self.values, self.moves = {}, []
        self.at, self.skip, self.to_sub, self.defining = 0, None, None, None
        self.broke = self.passed = self.executed_if = False
        self.seen = {}       # name -> [word, line, passes left or None]
        self.calls = []      # (name, line to return to)

    def value(self, text):
        python = re.sub(r"#(\d+)", lambda m: f"({self.values.get(m[1], 0)})", text)
        for word, sign in (("LT", "<"), ("EQ", "=="), ("GT", ">")):
            python = python.replace(f" {word} ", f" {sign} ")
        return float(eval(python, {"__builtins__": {}}))  # of our own making: numbers, + - and comparisons

    def run(self):
        for _ in range(MOST_LINES):
            if self.at >= len(self.lines):
                raise Refused("end of file")
            line, self.at = self.lines[self.at], self.at + 1
            found = O_LINE.match(line)
            if found:
                self.o_line(self.at - 1, *found.groups())
            elif self.skip is None and self.plain(line):
                return
        raise Endless

    def plain(self, line):
        """True where it ends the program."""
        if line.startswith("#"):
            name, text = line[1:].split("=")
            self.values[name] = self.value(text.strip("[]"))
        elif line.startswith("G0"):
            x, y = re.match(r"G0 X(\d+) Y\[(.*)\]", line).groups()
            self.moves.append((float(x), self.value(y)))
        return line == "M2"

    def o_line(self, at, label, word, condition):
        if word in ("sub", "endsub", "call", "return"):
            return self.program_word(at, label, word)
        if self.defining is not None:
            return None
        name = f"{self.calls[-1][0] if self.calls else ''}#{label}"
        if self.skip not in (None, name) or self.to_sub is not None:
            return None
        known = self.seen.get(name)
        if word in OPENERS:
            closes_do = word == "while" and known is not None and known[0] == "do"
            if known is not None and known[1] != at and word != "do" and not closes_do:
                raise Refused("duplicate label")
            known = self.seen.setdefault(name, [word, at, None])
        elif known is None:
            raise Refused("undefined label")
        return getattr(self, word + "_")(name, known, condition)

    def program_word(self, at, label, word):
        if word == "sub":
            if self.defining is not None:
                raise Refused("nested sub")
            if self.skip not in (None, label):
                return
            if self.skip is not None or not self.calls:
                if label in self.seen:
                    raise Refused("defined already")
                self.seen[label] = [word, at, None]
            self.to_sub = None
            self.skip = None if self.calls else label
            self.defining = None if self.calls else label
        elif word == "call":
            if self.skip is None and self.defining is None:
                self.call(label)
        elif self.skip in (None, label) and self.to_sub is None:
            if not self.calls and self.defining is None:
                raise Refused("not in a sub")
            if self.calls:
                if word == "endsub":
                    self.skip = None
                self.at = self.calls.pop()[1]
            elif word == "endsub":
                self.skip = self.defining = None

    def call(self, label):
        self.calls.append((label, self.at))
        if len(self.calls) >= LEVELS:
            raise Refused("too many levels")
        if label in self.seen:
            self.at = self.seen[label][1]
        else:
            self.skip = self.to_sub = label

    def if_(self, name, _known, condition):
        self.executed_if = self.value(condition) != 0
        self.skip = None if self.executed_if else name

    def elseif_(self, name, _known, condition):
        if self.executed_if:
            self.skip = name
        elif self.value(condition) != 0:
            self.skip, self.executed_if = None, True

    def else_(self, name, _known, _condition):
        self.skip = name if self.executed_if else None
        self.executed_if = True

    def endif_(self, _name, _known, _condition):
        self.skip, self.executed_if = None, True

    def do_(self, _name, _known, _condition):
        self.skip = None

    def while_(self, name, known, condition):
        self.skip = None
        holds = self.value(condition) != 0
        if known[0] == "while":
            self.skip = None if holds else name
        elif holds and not self.broke:
            self.at = known[1]
        else:
            self.broke = False

    def repeat_(self, name, known, condition):
        self.skip = None
        if known[2] is None:
            known[2] = round(self.value(condition))
        if known[2] > 0:
            known[2] -= 1
        else:
            self.skip, known[2] = name, None

    def break_(self, name, known, _condition):
        if known[0] not in ("while", "do"):
            raise Refused("no loop of break")
        self.skip, self.broke = name, True

    def continue_(self, name, known, _condition):
        if known[0] not in ("while", "do"):
            raise Refused("no loop of continue")
        if self.skip is None:
            self.skip, self.passed = name, True

    def endwhile_(self, _name, known, _condition):
        if self.skip is None or self.passed:
            self.passed = self.passed and self.skip is None
            self.at = known[1]
        self.skip = None

    endrepeat_ = endwhile_


class Program:
    """Lines of o-words in each other that come to an end: every loop counts a parameter of its own."""

    def __init__(self, seed):
        self.r = random.Random(seed)
        self.parameters, self.moves, self.left = 100, 0, self.r.randint(8, 30)
        self.labels, self.subs, self.others = 0, [10 * n for n in range(1, self.r.randint(1, 4))], []

    def move(self):
        self.moves += 1
        return f"G0 X{self.moves} Y[#{self.r.randint(101, max(101, self.parameters))}]"

    def label(self):
        """Now and then one that a structure of another branch has had."""
        if self.others and self.r.random() < 0.2:
            return self.others.pop()
        self.labels += 1
        return 100 + self.labels

    def body(self, depth, sub, loops):
        lines = [self.move()]
        for _ in range(self.r.randint(0, 3)):
            lines += self.statement(depth, sub, loops)
        return lines

    def condition(self, limit=3):
        return f"[#{self.r.randint(101, max(101, self.parameters))} {self.r.choice(('LT', 'EQ', 'GT'))} {self.r.randint(0, limit)}]"

    def leave(self, sub, loops):
        kinds = ([f"o{sub} return"] if sub else []) + [f"o{loop} {word}" for loop in loops for word in ("break", "continue")]
        return [self.r.choice(kinds)] if kinds else [self.move()]

    def statement(self, depth, sub, loops):
        self.left -= 1
        if self.left < 0 or depth > 4:
            return [self.move()]
        kind = self.r.choice(("move", "if", "if", "leave", "while", "do", "repeat", "call"))
        if kind == "move":
            return [self.move()]
        if kind == "leave":
            n = self.label()
            inner = self.leave(sub, loops)
            return [f"o{n} if {self.condition()}", *inner, f"o{n} endif"]
        if kind == "call":
            allowed = [s for s in self.subs if s > sub or self.r.random() < 0.1]
            return [f"o{self.r.choice(allowed)} call"] if allowed else [self.move()]
        return getattr(self, kind)(depth + 1, sub, loops)

    def __getattr__(self, name):
        return {"if": self.branches, "while": self.while_, "do": self.do, "repeat": self.repeat}[name]

    def branches(self, depth, sub, loops):
        n, had = self.label(), self.labels
        lines = [f"o{n} if {self.condition()}", *self.body(depth, sub, loops)]
        if self.r.random() < 0.3:
            lines += [f"o{n} elseif {self.condition()}", *self.body(depth, sub, loops)]
        if self.r.random() < 0.5:
            taken = list(range(101 + had, 101 + self.labels)) if self.r.random() < 0.3 else []
            kept, self.others = self.others, [t for t in taken if f"o{t} " in " ".join(lines)]
            lines += [f"o{n} else", *self.body(depth, sub, loops)]
            self.others = kept
        return [*lines, f"o{n} endif"]

    def counted(self):
        self.parameters += 1
        return self.parameters

    def while_(self, depth, sub, loops):
        n, p = self.label(), self.counted()
        reset = [f"#{p}=0"] if self.r.random() < 0.8 else []
        return [*reset, f"o{n} while [#{p} LT {self.r.randint(0, 3)}]", f"#{p}=[#{p}+1]", *self.body(depth, sub, loops + [n]), f"o{n} endwhile"]

    def do(self, depth, sub, loops):
        n, p = self.label(), self.counted()
        return [f"#{p}=0", f"o{n} do", f"#{p}=[#{p}+1]", *self.body(depth, sub, loops + [n]), f"o{n} while [#{p} LT {self.r.randint(0, 4)}]"]

    def repeat(self, depth, sub, loops):
        n = self.label()
        return [f"o{n} repeat [{self.r.randint(0, 3)}]", *self.body(depth, sub, loops), f"o{n} endrepeat"]

    def sub(self, n):
        self.labels, self.left, outer = 0, self.r.randint(3, 10), self.labels
        lines = [f"o{n} sub", *self.body(1, n, []), f"o{n} endsub"]
        self.labels = outer
        return lines

    def text(self):
        defined = [self.sub(n) for n in self.subs]
        self.left = self.r.randint(8, 30)
        main = [line for _ in range(5) for line in self.body(0, 0, [])]
        above = [s for s in defined if self.r.random() < 0.7]
        below = [s for s in defined if s not in above]
        start = [f"#{p}=0" for p in range(101, self.parameters + 1)]
        return "\n".join([*start, *(line for s in above for line in s), *main, "M2", *(line for s in below for line in s)]) + "\n"


def by_rules(text):
    """Moves, and whether the control refuses a line; None: no end in sight."""
    control = Control(text)
    try:
        control.run()
    except Refused:
        return control.moves, True
    except Endless:
        return None
    return control.moves, False


def moves(text):
    return [(float(x), float(y)) for x, y in MOVE.findall(text)]


def first_difference(a, b):
    k = next((k for k, (p, q) in enumerate(zip(a, b)) if p != q), min(len(a), len(b)))
    return f"move {k + 1}: {a[k:k + 3]} and {b[k:k + 3]}"


def compare(obrys, path, counts):
    wanted = by_rules(path.read_text())
    if wanted is None:
        counts["endless"] += 1
        return ""
    counts["refused"] += wanted[1]
    if runner.REFEREE_HERE:
        there = runner.run_referee(path)
        if (moves(there.out), bool(there.refused)) != wanted:
            return f"rs274 does not follow the rules of this test: {there.refused} {first_difference(moves(there.out), wanted[0])}"
    here = runner.run_obrys(obrys, path)
    got = moves(here.out), bool(endpoint.refusal(here.err))
    counts["said"] += "[unsupported]" in here.err
    if got[1] != wanted[1]:
        return f"refused by {'LinuxCNC' if wanted[1] else 'obrys'} alone: {endpoint.first_error(here.err)}"
    return first_difference(got[0], wanted[0]) if got[0] != wanted[0] else ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("-n", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    wrong, counts = 0, {"endless": 0, "refused": 0, "said": 0}
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.seed, options.seed + options.n):
            path = pathlib.Path(options.keep or folder) / f"o_words{seed}.ngc"
            path.write_text(Program(seed).text())
            said = compare(options.obrys, path, counts)
            wrong += bool(said)
            if said:
                print(f"seed {seed}: {said}")
            elif options.keep:
                path.unlink()
    print(f"{options.n - wrong} of {options.n} programs agree; LinuxCNC refuses {counts['refused']}, {counts['endless']} do not end, obrys says of "
          f"{counts['said']} that LinuxCNC remembers a loop")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
