#!/usr/bin/env python3
"""Tilted planes between the controls: random 3+2 programs in every control's own words, to every one and back.

usage: planes.py OBRYS MACHINES [--count N] [--seed N] [--show] [--expect FILE]

Each program tilts a few planes whose rotary axes turn to them, mills and drills in them, and ends level. It is written
by hand for HEIDENHAIN, SINUMERIK, FANUC and Haas; all four must do the same, and each translated to each one must be
mapped: nothing lost, nothing different when it is run again, and no plane written by its moves. FILE names those that
are not, one a line, and why; it must hold exactly what is found.
"""
import argparse
import itertools
import math
import pathlib
import random
import subprocess
import sys
import tempfile

DATUM = '\n[datum]\nG54 = { x = -565, y = -315, z = -400 }\n'
POSTS = {"H": "heidenhain-itnc530", "mpf": "sinumerik-840d", "nc": "fanuc", "hnc": "haas"}


def times(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(3)) for c in range(3)] for r in range(3)]


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    m = [[float(r == k) for k in range(3)] for r in range(3)]
    m[u][u] = m[v][v] = c
    m[u][v], m[v][u] = -s, s
    return m


def n(v):
    text = f"{v:.9f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def point(v):
    text = n(v)
    return text if "." in text else text + "."


class Plane:
    """Euler angles ZXZ, in whole degrees, and an origin."""

    def __init__(self, rng):
        self.euler = (rng.choice([-90, -60, 0, 35, 90, 120]), rng.randint(5, 29), rng.choice([-90, -20, 0, 75, 90]))
        self.origin = tuple(float(rng.randint(-20, 20)) for _ in range(3))
        m = times(times(turn(2, self.euler[0]), turn(0, self.euler[1])), turn(2, self.euler[2]))
        y = math.asin(max(-1.0, min(1.0, -m[2][0])))
        self.fixed = tuple(math.degrees(v) for v in (math.atan2(m[2][1], m[2][2]), y, math.atan2(m[1][0], m[0][0])))

    def klartext(self):
        x, y, z = self.origin
        a, b, c = self.euler
        return [f"CYCL DEF 7.0 DATUM SHIFT", f"CYCL DEF 7.1 X{x:+g}", f"CYCL DEF 7.2 Y{y:+g}", f"CYCL DEF 7.3 Z{z:+g}",
                f"PLANE EULER EULPR{a:+g} EULNU{b:+g} EULROT{c:+g} TURN FMAX"]

    def sinumerik(self):
        x, y, z = self.fixed  # about the fixed axes X, Y, Z is Z, Y, X of what has been turned
        return ['CYCLE800(0,"T",0,27,%s,%s,%s,%s,%s,%s,0,0,0,%d)' % (*map(n, self.origin), n(z), n(y), n(x), self.side)]

    def fanuc(self):
        return ["G68.2 X%s Y%s Z%s I%s J%s K%s" % tuple(map(point, (*self.origin, *self.euler))), "G53.1"]

    def haas(self):
        return ["G268 X%s Y%s Z%s I%s J%s K%s Q123" % tuple(map(point, (*self.origin, *self.fixed))), "G253"]

    @property
    def side(self):
        """Of A: from A0 C0 the controls take the position with the shorter way of C, else the greater A."""
        return 1 if abs((self.euler[0] + 360) % 360 - 180) <= 90 else -1


class Program:
    def __init__(self, rng):
        self.planes = [Plane(rng) for _ in range(rng.randint(1, 3))]
        self.paths = [[tuple(round(rng.uniform(-30, 30), 3) for _ in range(2)) for _ in range(3)] for _ in self.planes]

    def iso(self, plane, end, level):
        out = []
        for p, path in zip(self.planes, self.paths):
            out += plane(p) + [f"G0 X{point(path[0][0])} Y{point(path[0][1])} Z80.", "Z2.", "G1 Z-1. F200."]
            out += [f"X{point(x)} Y{point(y)}" for x, y in path[1:]] + ["G0 Z80."] + end + level
        return out

    def text(self, kind):
        if kind == "H":
            lines = ["TOOL CALL 1 Z S3000", "L X+0 Y+0 Z+150 R0 FMAX M3"]
            for p, path in zip(self.planes, self.paths):
                lines += p.klartext() + ["L X%s Y%s Z+80 R0 FMAX" % tuple(f"{v:+g}" for v in path[0]), "L Z+2 FMAX", "L Z-1 F200"]
                lines += ["L X%s Y%s" % (f"{x:+g}", f"{y:+g}") for x, y in path[1:]]
                lines += ["L Z+80 FMAX", "PLANE RESET STAY", "CYCL DEF 7.0 DATUM SHIFT", "CYCL DEF 7.1 X+0", "CYCL DEF 7.2 Y+0",
                          "CYCL DEF 7.3 Z+0", "L A+0 C+0 R0 FMAX", "L X+0 Y+0 Z+150 R0 FMAX"]
            lines += ["M30"]
            lines = ["BEGIN PGM T MM", *lines, "END PGM T MM"]
            return "".join(f"{i} {line}\n" for i, line in enumerate(lines))
        away = ["G0 X0. Y0. Z150."]
        if kind == "mpf":
            body = self.iso(Plane.sinumerik, ["CYCLE800()"], ["G0 A0 C0"] + away)
            return "\n".join(["G71 G90 G17 G54", "T1 D1 M6", "S3000 M3", *away, *body, "M30", ""])
        haas = kind == "hnc"
        body = self.iso(Plane.haas if haas else Plane.fanuc, ["G269" if haas else "G69"], ["G0 A0. C0."] + away)
        return "\n".join(["%", "O0001", "G21 G90 G40 G80 G54", "T1 M6", "S3000 M3", "G43 H1 G0 X0. Y0. Z150.", *body, "M30", "%", ""])


def call(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, timeout=120)
    return done.returncode, done.stdout, done.stderr


def control(kind):
    return ["--control", "haas" if kind == "hnc" else "fanuc"] if kind in ("nc", "hnc") else []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("machines", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--show", action="store_true")
    parser.add_argument("--expect", type=pathlib.Path)
    args = parser.parse_args()
    expected = {}
    if args.expect:
        lines = [line for line in args.expect.read_text().splitlines() if line and not line.startswith("#")]
        expected = dict(line.split(": ", 1) for line in lines)
    bad = done = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        machine = folder / "machine.toml"
        machine.write_text((args.machines / "hermle-u1130.toml").read_text() + DATUM)
        tools = folder / "tools.toml"
        tools.write_text('[[tool]]\nnumber = 1\nkind = "end-mill"\ndiameter = 10\nlength = 100\n')
        for known in (True, False):
            where = ["--machine", machine if known else "hermle-u1130"] + (["--tools", tools] if known else [])
            for k in range(args.count):
                program = Program(random.Random(args.seed * 1000 + k))
                for a, b in itertools.product(POSTS, repeat=2):
                    if known and "H" in (a, b):  # presets of its own, which the machine file does not hold
                        continue
                    path = folder / f"p{k}.{a}"
                    path.write_text(program.text(a))
                    out, ledger = folder / f"q.{b}", folder / "ledger.json"
                    code, _, said = call(args.obrys, "translate", path, *control(a), *where, "--to", POSTS[b], "-o", out, "--force",
                                         "--ledger", ledger)
                    wrong = code != 0 or "coordinates are those of the workpiece" in said or " 0 lost" not in said
                    done += 1
                    name_of_it = f"{args.seed} {k} {'zero' if known else 'no-zero'} {a} {b}"
                    why = expected.pop(name_of_it, None)
                    if wrong and (why is None or why not in said):
                        bad += 1
                        print(f"{name_of_it}: exit {code}")
                        if args.show:
                            print(path.read_text(), said, sep="\n")
                    elif why is not None and not wrong:
                        bad += 1
                        print(f"{name_of_it}: is mapped, and was not to be")
    for name_of_it in expected:
        print(f"{name_of_it}: was not asked for")
    bad += len(expected)
    print(f"{done} translations, {bad} otherwise than expected")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
