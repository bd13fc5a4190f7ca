#!/usr/bin/env python3
"""Interpreting, side by side with LinuxCNC's rs274 (package linuxcnc-uspace) in one run: medians of seconds and the ratio.

usage: compare_rs274.py OBRYS [--passes 250000] [--blocks 1000000] [--repeat 5]

Both programs of a pair move alike: a zig-zag surface of straight G1 blocks, and a WHILE loop of four statements with SIN
and COS. obrys interprets to a counting sink (run --quiet), rs274 prints its canonical calls to the null device, which is
the least it does. Without rs274 only obrys is measured.
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
import time


def surface(blocks, head, tail):
    rnd = random.Random(1)
    yield head
    x, y, step = 0.0, 0.0, 1
    for _ in range(blocks):
        x += step * 0.3 * (0.5 + rnd.random())
        if not 0 <= x <= 150:
            x, y, step = min(max(x, 0.0), 150.0), y + 0.05, -step
        z = -4.0 + 2.0 * math.sin(x * 0.12) * math.cos(y * 0.09) + 0.7 * math.sin(x * 0.41 + y * 0.23)
        yield f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f}\n"
    yield tail


def write_programs(folder, blocks, passes):
    nc = folder / "surface.ngc"
    with open(nc, "w", encoding="ascii") as f:
        f.writelines(surface(blocks, "G21 G17 G90 G94\nS12000 M3\nF2400\n", "M5\nM2\n"))
    mpf = folder / "SURFACE.MPF"
    with open(mpf, "w", encoding="ascii") as f:
        f.writelines(surface(blocks, "G71 G17 G90 G94\nS12000 M3\nF2400\n", "M5\nM30\n"))
    loop_nc = folder / "loop.ngc"
    loop_nc.write_text(f"G21 G17 G90 G94\nS8000 M3\nF1000.\n#1=0\n#2=0\nO100 while [#1 LT {passes}]\n#2=[#1*0.36]\n"
                       "G1 X[50*COS[#2]] Y[50*SIN[#2]] Z[-#1/100000]\n#1=[#1+1]\nO100 endwhile\nM5\nM2\n")
    loop_mpf = folder / "LOOP.MPF"
    loop_mpf.write_text(f"G71 G17 G90 G94\nS8000 M3\nF1000.\nR1=0\nR2=0\nWHILE R1<{passes}\nR2=R1*0.36\n"
                        "G1 X=50*COS(R2) Y=50*SIN(R2) Z=-R1/100000\nR1=R1+1\nENDWHILE\nM5\nM30\n")
    return [(f"{blocks} straight G1 blocks", mpf, nc), (f"{passes} passes x 4 statements", loop_mpf, loop_nc)]


def run(command):
    """Seconds and peak memory in MB of one run (a forked child starts with what this script holds: some 10 MB)."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status not in (0, 256):
        sys.exit(f"{command[0]} failed")
    return time.monotonic() - start, usage.ru_maxrss / 1024


def measure(commands, repeat):
    """Runs the commands in turn, so that both meet the same noise."""
    results = [[run(c) for c in commands] for _ in range(repeat)]
    return [(statistics.median(r[i][0] for r in results), max(r[i][1] for r in results)) for i in range(len(commands))]


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
    with tempfile.TemporaryDirectory() as folder:
        for name, mpf, ngc in write_programs(pathlib.Path(folder), a.blocks, a.passes):
            commands = [[a.obrys, "run", "--quiet", str(mpf)]] + ([[rs274, "-g", str(ngc)]] if rs274 else [])
            results = measure(commands, a.repeat)
            line = f"{name}: obrys {results[0][0]:.3f} s, {results[0][1]:.0f} MB"
            if rs274:
                line += f"; rs274 {results[1][0]:.3f} s, {results[1][1]:.0f} MB; factor {results[1][0] / results[0][0]:.1f}"
            print(line, flush=True)


if __name__ == "__main__":
    main()
