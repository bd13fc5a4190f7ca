#!/usr/bin/env python3
"""What a run says of a workpiece whose zero nobody gives must hold wherever the zero lies.

usage: unknown_zero_test.py OBRYS [--count N] [--seed N] [--show]

Random programs of each control mix moves with places of the machine (G28, G53, SUPA, M91 …), zeros that are selected,
written and shifted, and parameters that read where the machine stands. Each is run on a machine with home positions
three times: without a zero, and with two that lie elsewhere. A coordinate that the first run tells as known must be the
same in both others: it cannot depend on what nobody said. What stands behind a block of which the run says that it does
not know its value is left out, and what stands behind G92 where the run says that it takes the zero made there as that of
the stock. Nor is what stands behind a second zero, or behind one that the program writes: the points go on counting from where it
was, and what the program has written is known.
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

MACHINE = """name = "homes"
kind = "mill"
""" + "".join(f'[[axis]]\nname = "{a}"\nmin = -1000\nmax = 1000\nhome = {h}\n' for a, h in zip("XYZ", (7, -3, 11)))

ISO = ["G0 X10. Y20. Z5.", "G1 X15. Y5. F100.", "G1 Z-2. F100.", "G91", "G90", "G28 G91 Z0", "G28 G91 X0 Y0", "G28 Z30.", "G28",
       "G30 G91 Z0", "G53 G0 Z0.", "G53 G0 X-10.", "G53 G0 X-10. Y-20.", "G52 X5. Y1.", "G52 X0. Y0. Z0.", "G92 X1.",
       "G92 Z10.", "G10 L2 P1 X1. Y1.", "G10 L2 P2 X1. Y1. Z1.", "G55", "G54", "#1=#5021", "G0 X#1", "#2=#5043", "G0 Z#2",
       "G0 Z50.", "G0 X0. Y0.", "#3=#5023", "G0 X[#3*0+1.]", "G2 X40. Y25. R40. F50."]
BLOCKS = {
    "fanuc": ISO + ["#5221=3.", "#5241=5.", "G68 X0. Y0. R30.", "G69", "G51.1 X3.", "G50.1 X0.", "G10 G91 L2 P1 Z1.", "G43 H1", "G49"],
    "haas": ISO + ["#5221=3.", "G110", "G68 X0. Y0. R30.", "G69", "G43 H1", "G49", "G28 X5."],
    "linuxcnc": ISO + ["G28.1", "G30.1", "G10 L20 P2 X3 Y1", "#5=[#<_abs_x>]", "G0 X#5", "G92.1", "G92.2",
                       "G92.3", "#6=#5241", "G0 Y#6", "#7=#5161", "G0 Y#7", "G10 L2 P1 R15", "G55", "G54"],
    "sinumerik-840d": ["G0 X10 Y20 Z5", "G1 X15 Y5 F100", "G1 Z-2 F100", "G91", "G90", "G74 Z1=0", "G74 X1=0 Y1=0", "SUPA G0 Z0 D0",
                       "D1", "G53 G0 X-10", "G153 G0 X-10 Y-20", "G75 Z1=0", "TRANS X5 Y1", "TRANS", "ATRANS Z3", "ROT RPL=30",
                       "ROT", "G54", "G55", "G500", "R1=$AA_IM[X]", "G0 X=R1", "R2=$AA_IW[Z]", "G0 Z=R2", "$P_UIFR[1,X,TR]=5",
                       "$P_UIFR[2]=CTRANS(X,1,Y,2,Z,3)", "R3=$P_UIFR[1,Y,TR]", "G0 Y=R3", "G0 Z50", "G0 X0 Y0", "G0 X=IC(4)",
                       "G2 X40 Y25 CR=40 F50"],
    "heidenhain": ["L X+10 Y+20 Z+5 R0 FMAX", "L X+15 Y+5 F100", "L Z-2 F100", "L IX+3 IY-2", "L Z+0 R0 FMAX M91", "L X-10 R0 FMAX M91",
                   "L X-10 Y-20 R0 FMAX M91", "L IZ+4 R0 FMAX", "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+5\nCYCL DEF 7.2 IY+2",
                   "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+30", "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0",
                   "CYCL DEF 247 DATUM SETTING ~\nQ339=+1", "CYCL DEF 247 DATUM SETTING ~\nQ339=+2", "L M140 MB MAX", "L M140 MB 5",
                   "L Z+50 R0 FMAX", "L X+0 Y+0 R0 FMAX", "CC X+0 Y+0\nC X+3 Y+0 DR+ F50", "L Z-5 R0 FMAX M91"],
}
SUFFIX = {"fanuc": "nc", "haas": "nc", "linuxcnc": "ngc", "sinumerik-840d": "mpf", "heidenhain": "h"}
ZEROS = {"heidenhain": ("active_preset", "preset1", "preset2")}
PLACES = (((100, 20, -300), (-40, 7, -250), (3, 2, 1)), ((-31, 444, -123), (55, -66, -77), (9, 99, 999)))


def program(control, rng):
    blocks = [rng.choice(BLOCKS[control]) for _ in range(rng.randint(3, 12))]
    if control == "heidenhain":
        lines = "\n".join(["BEGIN PGM T MM", "TOOL CALL 1 Z S3000", *blocks, "M30", "END PGM T MM"]).split("\n")
        at, out = 0, []
        for line in lines:
            out.append(line if line.startswith("Q") else f"{at} {line}")
            at += not line.startswith("Q")
        return "\n".join(out) + "\n"
    if control == "sinumerik-840d":
        return "\n".join(["G17 G90 G71 G94 G54", "T1 D1 M6", "S3000 M3", *blocks, "M30", ""])
    head = ["G21 G90 G54", "T1 M6", "S3000 M3"]
    lines = [*head, *blocks, "M30"]
    return "\n".join([*(["%", "O0001"] if control != "linuxcnc" else []), *lines, *(["%"] if control != "linuxcnc" else []), ""])


def run(obrys, path, control, machine, known):
    done = subprocess.run([obrys, "run", path, "--control", control, "--machine", machine], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1, 2, 3):
        raise SystemExit(f"{path}: {done.returncode}\n{done.stderr}")
    unsure = [int(m[1]) for m in re.finditer(
        r"^[^:\n]*:(\d+):\d+: (?:.*\[unknown-value\]|note: where the machine stands .* its position becomes .*)$", done.stderr, re.M)]
    ends, zeros = {}, 0
    for line in done.stdout.split("\n"):
        zeros += line.startswith("datum ")
        if zeros > 1 and not known:
            break
        m = re.match(r"(rapid|linear|arc|machine|zero-data|datum-data) (.*) @\d+:(\d+)-", line)
        if not m:
            continue
        words, kind = m[2].split(), m[1]
        if kind in ("rapid", "linear", "arc"):
            words = words[:3]
        ends[(int(m[3]), "move" if kind in ("rapid", "linear", "arc") else kind)] = words
    return ends, min(unsure, default=1 << 30), done.stderr


def same(a, b):
    try:
        return abs(float(a) - float(b)) < 1e-6
    except ValueError:
        return a == b


def differs(text, none, known):
    """The first place where the run without a zero says what does not hold."""
    ends, unsure, _ = none
    written = re.search(r"^(G10 (G91 )?L2 P|#52[24]1|\$P_UIFR\[[12].*=)", text, re.M)
    if written:
        unsure = min(unsure, text[:written.start()].count("\n") + 1)
    for (at, kind), words in ends.items():
        line = text[:at].count("\n") + 1
        if line >= unsure:
            continue
        for other in known:
            there = other[0].get((at, kind))
            if there is None or line >= other[1]:
                continue
            for a, b in zip(words, there):
                if a != "?" and not same(a, b):
                    return f"line {line}: {kind} {' '.join(words)}; with a zero {' '.join(there)}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--show", action="store_true")
    args = parser.parse_args()
    bad = told = unknown = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        none = folder / "none.toml"
        none.write_text(MACHINE)
        for control, suffix in SUFFIX.items():
            zeros = []
            for k, places in enumerate(PLACES):
                where = folder / f"{control}-{k}.toml"
                where.write_text(MACHINE + "[datum]\n" + "".join(
                    f"{z} = {{ x = {v[0]}, y = {v[1]}, z = {v[2]} }}\n" for z, v in zip(ZEROS.get(control, ("G54", "G55")), places)))
                zeros.append(where)
            for k in range(args.count):
                text = program(control, random.Random(f"{args.seed} {control} {k}"))
                path = folder / f"T.{suffix}"
                path.write_text(text)
                result = run(args.obrys, path, control, none, False)
                told += sum(w != "?" for words in result[0].values() for w in words)
                unknown += sum(w == "?" for words in result[0].values() for w in words)
                wrong = differs(text, result, [run(args.obrys, path, control, z, True) for z in zeros])
                if wrong:
                    bad += 1
                    print(f"{control} {k}: {wrong}")
                    if args.show:
                        print(text, result[2], sep="\n")
    print(f"{told} coordinates known, {unknown} not; {bad} programs say what does not hold")
    return 1 if bad or not told or not unknown else 0


if __name__ == "__main__":
    sys.exit(main())
