#!/usr/bin/env python3
"""Interpreting, side by side with LinuxCNC's rs274 (package linuxcnc-uspace) in one run: medians of processor seconds, peaks of memory, ratios.

usage: compare_rs274.py OBRYS [--passes 250000] [--blocks 1000000] [--repeat 5]

Two rows move alike in three languages: a zig-zag surface of straight blocks, and a loop of four statements with SIN and COS, as
SINUMERIK (WHILE), as Klartext (LBL, FN 12, GOTO) and as RS274. Three more are RS-274 programs that both read: those that
../shared/bench/gen_rs274.py writes. obrys interprets to a counting sink (run --quiet), rs274 prints its canonical calls to the null
device, which is the least it does. What is missing is said: without rs274 only obrys is measured.
"""
import argparse
import math
import os
import pathlib
import random
import shutil
import statistics
import subprocess
import sys
import tempfile


def surface(blocks):
    """Points of a zig-zag surface."""
    rnd = random.Random(1)
    x, y, step = 0.0, 0.0, 1
    for _ in range(blocks):
        x += step * 0.3 * (0.5 + rnd.random())
        if not 0 <= x <= 150:
            x, y, step = min(max(x, 0.0), 150.0), y + 0.05, -step
        yield x, y, -4.0 + 2.0 * math.sin(x * 0.12) * math.cos(y * 0.09) + 0.7 * math.sin(x * 0.41 + y * 0.23)


def write_surface(path, blocks, head, block, tail):
    with open(path, "w", encoding="ascii") as f:
        f.write(head)
        f.writelines(block(i, *p) for i, p in enumerate(surface(blocks)))
        f.write(tail)
    return path


def iso(_, x, y, z):
    return f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f}\n"


def klartext(i, x, y, z):
    return f"{i + 3} L X{x:+.3f} Y{y:+.3f} Z{z:+.3f}\n"


def write_programs(folder, blocks, passes):
    mpf = write_surface(folder / "SURFACE.MPF", blocks, "G71 G17 G90 G94\nS12000 M3\nF2400\n", iso, "M5\nM30\n")
    h = write_surface(folder / "SURFACE.H", blocks, "0 BEGIN PGM SURFACE MM\n1 TOOL CALL 1 Z S12000\n2 L F2400 M3\n", klartext,
                      f"{blocks + 3} L M30\n{blocks + 4} END PGM SURFACE MM\n")
    nc = write_surface(folder / "surface.ngc", blocks, "G21 G17 G90 G94\nS12000 M3\nF2400\n", iso, "M5\nM2\n")
    loop_nc = folder / "loop.ngc"
    loop_nc.write_text(f"G21 G17 G90 G94\nS8000 M3\nF1000.\n#1=0\n#2=0\nO100 while [#1 LT {passes}]\n#2=[#1*0.36]\n"
                       "G1 X[50*COS[#2]] Y[50*SIN[#2]] Z[-#1/100000]\n#1=[#1+1]\nO100 endwhile\nM5\nM2\n")
    loop_mpf = folder / "LOOP.MPF"
    loop_mpf.write_text(f"G71 G17 G90 G94\nS8000 M3\nF1000.\nR1=0\nR2=0\nWHILE R1<{passes}\nR2=R1*0.36\n"
                        "G1 X=50*COS(R2) Y=50*SIN(R2) Z=-R1/100000\nR1=R1+1\nENDWHILE\nM5\nM30\n")
    loop_h = folder / "LOOP.H"
    loop_h.write_text("0 BEGIN PGM LOOP MM\n1 TOOL CALL 1 Z S8000\n2 L F1000 M3\n3 Q1 = 0\n4 LBL 1\n5 Q2 = Q1 * 0.36\n"
                      "6 Q3 = 50 * COS Q2\n7 Q4 = 50 * SIN Q2\n8 Q5 = - Q1 / 100000\n9 L X+Q3 Y+Q4 Z+Q5\n10 Q1 = Q1 + 1\n"
                      f"11 FN 12: IF +Q1 LT +{passes} GOTO LBL 1\n12 L M30\n13 END PGM LOOP MM\n")
    return [(f"{blocks} straight blocks", mpf, h, nc), (f"{passes} passes of a loop", loop_mpf, loop_h, loop_nc)]


def write_rs274_programs(folder):
    """The generator's programs and what obrys is to be called with; empty where there is no generator."""
    generator = pathlib.Path(__file__).resolve().parents[2] / "shared" / "bench" / "gen_rs274.py"
    if not generator.is_file():
        print("skipped: a_surface_1M.ngc, b_arcs_200k.ngc, c_while_1M.ngc (no ../shared/bench/gen_rs274.py)")
        return []
    subprocess.run([sys.executable, str(generator), str(folder)], check=True)
    names = ("a_surface_1M", "b_arcs_200k", "c_while_1M")
    return [(name, folder / f"{name}.ngc") for name in names]


def write_tool_tables(folder):
    """The same end mill of 6 mm for both: rs274 without configuration is an inch machine, obrys counts in mm."""
    ours, theirs = folder / "mm.tbl", folder / "inch.tbl"
    ours.write_text("T1 P1 D6 Z50\n")
    theirs.write_text("T1 P1 D0.23622 Z1.9685\n")
    return str(ours), str(theirs)


def run(command):
    """Seconds of the processor and peak memory in MB of one run (a forked child starts with what this script holds: some 10 MB).

    Both programs have one thread and wait for nothing, so these are the seconds of a machine that does nothing else.
    """
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 1, 3):  # 3: run to its end; how its tool was set is not said
        sys.exit(f"{command[0]} failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def measure(commands, repeat):
    """Runs the commands in turn, so that both meet the same noise."""
    results = [[run(c) for c in commands] for _ in range(repeat)]
    return [(statistics.median(r[i][0] for r in results), max(r[i][1] for r in results)) for i in range(len(commands))]


def show(name, columns, results, referee):
    """One line; `referee`: the last column is rs274, which the others are held against."""
    parts = []
    for i, (column, (seconds, memory)) in enumerate(zip(columns, results)):
        factor = f", factor {results[-1][0] / seconds:.1f}" if referee and i + 1 < len(results) else ""
        parts.append(f"{column} {seconds:.3f} s, {memory:.0f} MB{factor}")
    print(f"{name}: " + "; ".join(parts), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("obrys")
    parser.add_argument("--passes", type=int, default=250_000)
    parser.add_argument("--blocks", type=int, default=1_000_000)
    parser.add_argument("--repeat", type=int, default=5)
    a = parser.parse_args()
    rs274 = shutil.which("rs274")
    if rs274 is None:
        print("rs274 is not installed (package linuxcnc-uspace): obrys alone is measured")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run_obrys = [a.obrys, "run", "--quiet"]
        for row, mpf, h, ngc in write_programs(folder, a.blocks, a.passes):
            commands = [[*run_obrys, str(p)] for p in (mpf, h)] + ([[rs274, "-g", str(ngc)]] if rs274 else [])
            show(row, ("SINUMERIK", "Klartext", "rs274"), measure(commands, a.repeat), rs274)
        for row, ngc in write_rs274_programs(folder):
            ours, theirs = write_tool_tables(folder)
            commands = [[*run_obrys, "--control", "linuxcnc", "--tools", ours, str(ngc)]]
            commands += [[rs274, "-g", "-t", theirs, str(ngc)]] if rs274 else []
            show(row, ("obrys", "rs274"), measure(commands, a.repeat), rs274)


if __name__ == "__main__":
    main()
