#!/usr/bin/env python3
"""Writes the finished part of FILLET.H as an STL, from its drawing alone: the arc of the section, swept along the contour.

usage: fillet_part.py OUT.stl [accuracy]      mm that chords may leave arcs, 0.001

Seen from above the part is laid out in stations along the contour, each a ray square to it. Along a ray the height is
that of the section: the rim, the arc with its centre beside the contour at the height of the rim, the step as deep as the
arc's radius, out to the edge of the block. The body is what lies below that, down to its bottom.
"""
import dataclasses
import math
import struct
import sys


@dataclasses.dataclass
class Drawing:
    """Millimetres. The contour runs from the left edge at y = wall_y, turns left by an arc and goes up at x = wall_x."""
    radius: float = 9.0                       # of the section
    low: tuple = (0.0, 5.0, -15.0)            # the block
    high: tuple = (60.0, 60.0, 0.0)           # its upper side is the rim, or lies so far below it:
    below: float = 0.0
    wall_y: float = 15.0
    wall_x: float = 50.0
    round: float = 20.0                       # of the arc between the walls; 0: a sharp corner, about which the section turns


def steps(radius, angle, accuracy):
    return max(1, math.ceil(angle / math.sqrt(8 * accuracy / radius)))


def stations(d, accuracy):
    """Points of the contour with the direction away from the part."""
    out = [((d.low[0], d.wall_y), (0.0, -1.0))]
    centre = (d.wall_x - d.round, d.wall_y + d.round)
    n = 2 * steps(d.round + d.radius, math.pi / 4, accuracy)      # even: the ray in the middle meets the block's corner
    for i in range(n + 1):
        a = -math.pi / 2 + i * math.pi / 2 / n
        out.append(((centre[0] + d.round * math.cos(a), centre[1] + d.round * math.sin(a)), (math.cos(a), math.sin(a))))
    return out + [((d.wall_x, d.high[1]), (1.0, 0.0))]


def to_edge(d, p, way):
    """How far the block reaches from p."""
    along_x = (d.high[0] - p[0]) / way[0] if way[0] > 1e-12 else math.inf
    along_y = (d.low[1] - p[1]) / way[1] if way[1] < -1e-12 else math.inf
    return min(along_x, along_y)


def rows(d, accuracy):
    """(distance from the contour, height) of the section's arc."""
    first = math.asin(d.below / d.radius)
    n = steps(d.radius, math.pi / 2 - first, accuracy)
    angles = [first + j * (math.pi / 2 - first) / n for j in range(n + 1)]
    return [(d.radius - d.radius * math.cos(a), d.high[2] + d.below - d.radius * math.sin(a)) for a in angles]


def top(d, accuracy):
    """Triangles of the upper side, counter-clockwise seen from above, and its rim in that sense."""
    section, triangles, grid = rows(d, accuracy), [], []
    for p, way in stations(d, accuracy):
        far = to_edge(d, p, way)
        section_and_step = section + [(far, section[-1][1])]
        grid.append([(p[0] + x * way[0], p[1] + x * way[1], z) for x, z in section_and_step])
    for a, b in zip(grid, grid[1:]):                              # outwards to the right of the way along the contour
        for j in range(len(a) - 1):
            triangles += [(a[j], a[j + 1], b[j + 1]), (a[j], b[j + 1], b[j])]
    corner = (d.low[0], d.high[1], d.high[2])                     # the rim's face is convex: a fan
    triangles += [(corner, a[0], b[0]) for a, b in zip(grid, grid[1:])]
    return triangles, [corner] + grid[0] + [ray[-1] for ray in grid[1:]] + grid[-1][-2::-1]


def body(d, accuracy):
    triangles, outline = top(d, accuracy)
    below = [(x, y, d.low[2]) for x, y, _ in outline]
    middle = ((d.low[0] + d.high[0]) / 2, (d.low[1] + d.high[1]) / 2, d.low[2])
    for i, a in enumerate(outline):
        k = (i + 1) % len(outline)
        triangles += [(a, below[i], below[k]), (a, below[k], outline[k]), (middle, below[k], below[i])]
    return [t for t in triangles if len(set(t)) == 3]


def write(path, d, accuracy=0.001):
    triangles = body(d, accuracy)
    with open(path, "wb") as out:
        out.write(b"hollow fillet along a contour".ljust(80) + struct.pack("<I", len(triangles)))
        for t in triangles:
            out.write(struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *p) for p in t) + b"\0\0")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        sys.exit("usage: fillet_part.py FILE.stl [ACCURACY in mm, 0.001]")
    write(sys.argv[1], Drawing(), float(sys.argv[2]) if len(sys.argv) > 2 else 0.001)
