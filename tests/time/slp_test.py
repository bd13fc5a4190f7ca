#!/usr/bin/env python3
"""Profiles of random polylines beside the least time that a sequence of linear programs finds over the same path.

usage: slp_test.py OBRYS [COUNT [SEED]]

The squares of the speeds on a grid are the unknowns; accelerations are linear in them, the limit of jerk over the speed
is convex, so that its tangent keeps each step within what is allowed. Corners and curves are limited by the same rules
(docs/time.md); what is compared is the planning. The reference is within 0.5 %.
Skipped (77) without scipy.
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from scipy.optimize import linprog
    from scipy.sparse import csr_matrix, vstack
except ImportError:
    print("skipped: needs numpy and scipy (python3-scipy)")
    sys.exit(77)

ACCELERATION, JERK, TOLERANCE, FEED = 1000.0, 40000.0, 0.02, 6000.0
MACHINE = f"""name = "reference"
kind = "mill"
[motion]
acceleration = {ACCELERATION:.0f}
jerk = {JERK:.0f}
tolerance = {TOLERANCE}
corner = "filter"
""" + "".join(f'[[axis]]\nname = "{n}"\nrapid = 60000\n' for n in "XYZ")
CELLS = 200
TOO_FAST, TOO_SLOW, USUALLY = -0.01, 0.055, 0.015


def polyline(rnd):
    """Points of lines between 0.3 and 20 mm that turn much or little; rounded as a program has them."""
    at, heading, points = [0.0, 0.0], rnd.uniform(0, 2 * math.pi), [(0.0, 0.0)]
    short = rnd.random() < 0.5
    for _ in range(rnd.randint(3, 14)):
        length = math.exp(rnd.uniform(math.log(0.3), math.log(3 if short else 20)))
        heading += rnd.gauss(0, 0.2) if rnd.random() < 0.6 else rnd.uniform(-2.8, 2.8)
        at = [round(at[0] + length * math.cos(heading), 4), round(at[1] + length * math.sin(heading), 4)]
        points.append(tuple(at))
    return points


def corner_speed(before, here, after):
    u, v = np.subtract(here, before), np.subtract(after, here)
    lu, lv = np.hypot(*u), np.hypot(*v)
    turn = abs(math.atan2(u[0] * v[1] - u[1] * v[0], float(u @ v)))
    mean = (lu + lv) / 2
    if turn < 1e-6:
        return math.inf
    if turn < math.radians(20) and turn * mean / 8 <= TOLERANCE:
        k = turn / mean
        return min(math.sqrt(ACCELERATION / k), (JERK / k**2) ** (1 / 3))
    s = math.sin(turn / 2)
    return min(math.sqrt(1.5 * ACCELERATION * TOLERANCE) / s, (4.5 * JERK * TOLERANCE**2) ** (1 / 3) / s)


def least_time(points):
    """Rest to rest along the points, extrapolated to a grid without end: what is missing halves where cells are twice as
    many (200, 400 and 1000 cells: 3.6, 2.5 and 1.9 % below the profile of six polylines; extrapolated 1.3)."""
    lengths = [math.dist(a, b) for a, b in zip(points, points[1:])]
    ends = np.concatenate([[0], np.cumsum(lengths)])
    coarse = [np.linspace(ends[i], ends[i + 1], max(6, round(CELLS / 2 * n / ends[-1])) + 1)[1:] for i, n in enumerate(lengths)]
    s, b = solve(points, ends, np.concatenate([[0], *coarse]))
    for _ in range(2):  # cells that take the same time each
        times, fine = times_of(s, b), []
        for i in range(len(lengths)):
            from_, to = np.interp([ends[i], ends[i + 1]], s, times)
            n = max(6, round(CELLS * (to - from_) / times[-1]))
            fine.append(np.append(np.interp(np.linspace(from_, to, n + 1)[1:-1], times, s), ends[i + 1]))
        s, b = solve(points, ends, np.concatenate([[0], *fine]))
    once = times_of(s, b)[-1]
    s, b = solve(points, ends, np.sort(np.concatenate([s, (s[1:] + s[:-1]) / 2])))
    return float(2 * times_of(s, b)[-1] - once)


def best_of(points):
    """The programs may end in a valley that is not the deepest: of two grids the better one counts."""
    global CELLS
    found = []
    for CELLS in (150, 220):
        found.append(least_time(points))
    return min(found)


def times_of(s, b):
    v = np.sqrt(b)
    return np.concatenate([[0], np.cumsum(2 * np.diff(s) / (v[1:] + v[:-1]))])


def solve(points, ends, s):
    h = np.diff(s)
    caps = np.full(len(s), (FEED / 60) ** 2)
    for i, at in enumerate(np.searchsorted(s, ends[1:-1] - 1e-12)):
        caps[at] = min(caps[at], corner_speed(points[i], points[i + 1], points[i + 2]) ** 2)
    caps[0] = caps[-1] = 0.0
    # From rest, the jerk alone: the square of the speed behind the first cell.
    for inner, cell in ((1, h[0]), (-2, h[-1])):
        caps[inner] = min(caps[inner], (JERK / 2) ** 2 * (6 * cell / JERK) ** (4 / 3))
    n = len(caps)
    # Acceleration alone is an upper bound; a small part of it keeps the jerk.
    b = caps.copy()
    for i in range(n - 1):
        b[i + 1] = min(b[i + 1], b[i] + 2 * ACCELERATION * h[i])
    for i in range(n - 2, -1, -1):
        b[i] = min(b[i], b[i + 1] + 2 * ACCELERATION * h[i])
    accelerations = np.arange(n - 1)
    a_rows = csr_matrix((np.concatenate([-0.5 / h, 0.5 / h]), (np.concatenate([accelerations] * 2), np.concatenate([accelerations, accelerations + 1]))),
                        shape=(n - 1, n))
    inner = (h[1:] + h[:-1]) / 2
    change = csr_matrix((np.concatenate([-1 / inner, 1 / inner]), (np.concatenate([np.arange(n - 2)] * 2), np.concatenate([np.arange(n - 2), np.arange(1, n - 1)]))),
                        shape=(n - 2, n - 1)) @ a_rows

    def jerk_of(x):
        return np.abs(change @ x) * np.sqrt(x[1:-1])

    smooth = b.copy()
    for _ in range(3 * n // 20):
        smooth[1:-1] = np.minimum(smooth[1:-1], (smooth[:-2] + smooth[2:]) / 2 * 0.5 + smooth[1:-1] * 0.5)
    b = smooth
    worst = jerk_of(b).max()
    if worst > JERK:
        b = b * (JERK / worst) ** (2 / 3) * 0.98

    def seconds(x):
        v = np.sqrt(x)
        return float((2 * h / (v[1:] + v[:-1])).sum())

    best, pick = seconds(b), csr_matrix((np.ones(n - 2), (np.arange(n - 2), np.arange(1, n - 1))), shape=(n - 2, n))
    grow, idle = 1.0, 0
    for _ in range(150):
        v = np.maximum(np.sqrt(b), 1e-9)
        slope = np.zeros(n)
        share = h / (v[1:] + v[:-1]) ** 2
        slope[:-1] += share / v[:-1]
        slope[1:] += share / v[1:]
        inside = b[1:-1]
        limit, tangent = JERK / np.sqrt(inside), -0.5 * JERK / inside**1.5
        # |change x| <= limit + tangent (x - b), for x = b y, each row by its limit: numbers near 1 are solved well.
        rows, right = [], []
        for sign in (1, -1):
            rows.append(((sign * change - pick.multiply(tangent[:, None])).multiply(1 / limit[:, None])).multiply(b[None, :]))
            right.append(1 - tangent * inside / limit)
            rows.append(sign * a_rows.multiply(1 / ACCELERATION).multiply(b[None, :]))
            right.append(np.ones(n - 1))
        most = np.divide(caps, b, out=np.ones(n), where=b > 0)
        bounds = np.stack([np.full(n, 1 / (1 + grow)), np.maximum(np.minimum(most, 1 + grow), 1 / (1 + grow))], axis=1)
        gain = slope * b
        found = linprog(-gain / gain.max(), A_ub=vstack(rows).tocsr(), b_ub=np.concatenate(right), bounds=bounds, method="highs")
        if found.status != 0:
            grow /= 2
            if grow < 0.005:
                break
            continue
        x = np.clip(found.x * b, 0, caps)
        now = seconds(x)
        if now >= best:
            grow /= 2
            if grow < 0.005:
                break
            continue
        idle = idle + 1 if best - now < 1e-5 * best else 0
        b, best, grow = x, now, min(1.0, 1.5 * grow)
        if idle == 3:
            break
    return s, b


def main():
    obrys, count = str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2]) if len(sys.argv) > 2 else 200
    rnd = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 7)
    over, faults = [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "m.toml").write_text(MACHINE)
        for number in range(count):
            points = polyline(rnd)
            text = "G21 G17 G90 G94\nG0 X0 Y0 Z0\n" + "".join(
                f"G1 X{x:.4f} Y{y:.4f}" + (f" F{FEED:.0f}" if i == 0 else "") + "\n" for i, (x, y) in enumerate(points[1:]))
            (folder / "p.ngc").write_text(text + "M2\n")
            run = subprocess.run([obrys, "time", "p.ngc", "--control", "linuxcnc", "--machine", "m.toml", "--format", "json"],
                                 capture_output=True, text=True, cwd=folder)
            seconds = json.loads(run.stdout)["total_s"]
            off = seconds / best_of(points) - 1
            over.append(off)
            if not TOO_FAST <= off <= TOO_SLOW:
                faults.append(f"polyline {number}: {off:+.2%}: {points}")
    over.sort()
    print(f"{count} polylines: {over[0]:+.2%} … {over[-1]:+.2%}, median {over[len(over) // 2]:+.2%}, mean {sum(over) / len(over):+.2%}, "
          f"{sum(o > 0.03 for o in over)} above 3 %")
    if over[len(over) // 2] > USUALLY:
        faults.append("the median is too slow")
    for fault in faults[:10]:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
