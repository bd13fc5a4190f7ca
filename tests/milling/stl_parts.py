"""Finished parts as STL, made from formulas alone: closed surfaces of rings about an upright line.

A ring is an outline (convex, seen along z, around the line) at a height. A part is a sequence of rings, each joined to the
next one by a strip; it begins and ends in a point, or closes upon itself (a part with a hole through it). Rings are listed
outwards up the side, inwards over the top, down the inside: then all triangles face outwards.
"""
import math
import struct


def arc_angles(radius, sagitta):
    """Angles of a full turn whose chords leave the circle by at most the sagitta."""
    n = max(16, math.ceil(math.pi / math.acos(1 - min(0.5, sagitta / radius))))
    return [2 * math.pi * i / n for i in range(n)]


class Circle:
    def __init__(self, radius, sagitta):
        self.radius = radius
        self.angles = arc_angles(radius, sagitta)

    def reach(self, angle):
        return self.radius


class Rectangle:
    """Half sides a and b, corners of a radius (0: sharp), turned by `turn`, its middle (dx, dy) beside the line."""

    def __init__(self, a, b, corner=0.0, turn=0.0, sagitta=0.0005, dx=0.0, dy=0.0):
        self.a, self.b, self.corner, self.turn, self.dx, self.dy = a, b, corner, turn, dx, dy
        self.angles = []
        turned = arc_angles(corner, sagitta) if corner > 0 else []
        for sx, sy, start in ((1, 1, 0), (-1, 1, 1), (-1, -1, 2), (1, -1, 3)):
            mx, my = sx * (a - corner), sy * (b - corner)
            quarter = [t for t in turned if t <= math.pi / 2] + [math.pi / 2, 0.0] if corner > 0 else [0.0]
            for t in quarter:
                t += start * math.pi / 2
                x, y = mx + corner * math.cos(t) + dx, my + corner * math.sin(t) + dy
                self.angles.append(math.atan2(y, x) + turn)

    def reach(self, angle):
        c, s = math.cos(angle - self.turn), math.sin(angle - self.turn)
        x_side = self.dx + math.copysign(self.a, c)
        y_side = self.dy + math.copysign(self.b, s)
        t = min(x_side / c if abs(c) > 1e-15 else math.inf, y_side / s if abs(s) > 1e-15 else math.inf)
        if self.corner == 0:
            return t
        mx, my = self.dx + math.copysign(self.a - self.corner, c), self.dy + math.copysign(self.b - self.corner, s)
        if (t * c - mx) * c <= 0 or (t * s - my) * s <= 0:
            return t
        along = c * mx + s * my
        return along + math.sqrt(max(0.0, self.corner ** 2 - mx * mx - my * my + along * along))


def build(centre, rings, through):
    """Triangles of the rings [(outline, z)]; `through`: the last ring is joined to the first one, else both ends are capped."""
    angles = sorted({round(a % (2 * math.pi), 12) for outline, _ in rings for a in outline.angles})
    kept = []
    for a in angles:
        if not kept or a - kept[-1] > 1e-9:
            kept.append(a)
    loops = []
    for outline, z in rings:
        loop = []
        for a in kept:
            r = outline.reach(a)
            loop.append((centre[0] + r * math.cos(a), centre[1] + r * math.sin(a), z))
        loops.append(loop)
    triangles = []
    n = len(kept)
    if not through:
        for loop, first in ((loops[0], True), (loops[-1], False)):
            tip = (centre[0], centre[1], loop[0][2])
            for i in range(n):
                a, b = loop[i], loop[(i + 1) % n]
                triangles.append((tip, b, a) if first else (a, b, tip))
    pairs = list(zip(loops, loops[1:])) + ([(loops[-1], loops[0])] if through else [])
    for low, high in pairs:
        for i in range(n):
            a, b, c, d = low[i], low[(i + 1) % n], high[(i + 1) % n], high[i]
            triangles.append((a, b, c))
            triangles.append((a, c, d))
    return triangles


def cone_end(centre, rings, tip_z):
    """As `build`, but the last ring ends in a point below it (a drill's cone)."""
    triangles = build(centre, rings, False)
    n_cap = sum(1 for t in triangles if t[2] == (centre[0], centre[1], rings[-1][1]) or t[0] == (centre[0], centre[1], rings[-1][1]))
    moved = []
    for t in triangles:
        moved.append(tuple((p[0], p[1], tip_z) if p == (centre[0], centre[1], rings[-1][1]) else p for p in t))
    assert n_cap > 0
    return moved


def write(path, triangles):
    with open(path, "wb") as f:
        f.write(b"made from formulas".ljust(80, b" "))
        f.write(struct.pack("<I", len(triangles)))
        for t in triangles:
            f.write(struct.pack("<12fH", 0, 0, 0, *t[0], *t[1], *t[2], 0))
