"""Gouges that lie beside something shallow, larger or earlier: a rib among very many triangles within moves whose floor is a hair
too deep, the same with a tap beside it, an edge after hundreds of moves that are deeper elsewhere, and stock that lacks a layer
of the part under a skim cut. Every maker takes (random, tolerance) and gives a Mark.
"""
import marks
import tools
from blocks import Program, Setting


class Tap:
    keys = {"kind": "tap", "diameter": 6.0, "pitch": 1.0, "length": 90.0}


def steps(xs, ys, height, low):
    """Triangles of a body over a grid, flat below; heights at the corners."""
    out = []
    top = lambda i, j: (xs[i], ys[j], height(xs[i], ys[j]))
    foot = lambda i, j: (xs[i], ys[j], low)
    n, m = len(xs) - 1, len(ys) - 1
    quad = lambda a, b, c, d: out.extend([(a, b, c), (a, c, d)])
    for i in range(n):
        for j in range(m):
            quad(top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1))
            quad(foot(i, j), foot(i, j + 1), foot(i + 1, j + 1), foot(i + 1, j))
        quad(foot(i, 0), foot(i + 1, 0), top(i + 1, 0), top(i, 0))
        quad(foot(i + 1, m), foot(i, m), top(i, m), top(i + 1, m))
    for j in range(m):
        quad(foot(0, j + 1), foot(0, j), top(0, j), top(0, j + 1))
        quad(foot(n, j), foot(n, j + 1), top(n, j + 1), top(n, j))
    return out


def grid(lo, hi, step, *more):
    n = round((hi - lo) / step)
    return sorted({round(lo + (hi - lo) * i / n, 6) for i in range(n + 1)} | {round(v, 6) for v in more})


def mark_of(program, stock, part, depth, tolerance, what):
    program.end()
    mark = marks.Mark(program, stock, "gouge", depth, what)
    mark.part, mark.least = part, tolerance
    mark.check = {"tolerance": tolerance, "gouge": tolerance, "rest_material": 5.0}
    return mark


def face(program, z, ys, half):
    for y in ys:
        program.rapid((-half, y, z))
        program.line((half, y, z), mark="*")


def rib(random, tolerance, tap=False):
    """A rib that is cut off by rows along x, in a floor of small triangles that is up to a hair too deep."""
    program = Program(Setting.any(random, False))
    thin, hair = random.uniform(0.4, 1.0), random.uniform(0.5, 0.98) * tolerance
    x, step, eps = random.uniform(-6.0, 6.0), random.choice([0.3, 0.5]), 0.001
    high = 2 * thin
    xs = grid(-10.0, 10.0, step, x, x + eps, x + thin - eps, x + thin)
    ys = grid(-8.0, 8.0, step, -4.0, -4.0 + eps, 4.0 - eps, 4.0)
    on = lambda u, v: x + eps / 2 < u < x + thin - eps / 2 and -4.0 + eps / 2 < v < 4.0 - eps / 2
    part = steps(xs, ys, lambda u, v: 0.0 if on(u, v) else -high, -10.0)
    program.tool(tools.end_mill(8.0))
    face(program, -high - hair, (-7.0, 0.0, 7.0), 20.0)
    if tap:
        program.tools.append(Tap)
        program.lines += [(t, "") for t in (f"T{len(program.tools)} M6", f"G0 G43 H{len(program.tools)} Z30", "M3 S500",
                                            "G0 X-60 Y-60", "G0 Z5", "G33.1 Z-5 K1", "G0 Z30")]
    return mark_of(program, ((-10.0, -8.0, -10.0), (10.0, 8.0, 0.0)), part, thin, tolerance, f"rib {thin:.4f} thin, floor {hair:.5f} too deep")


def many(random, tolerance):
    """An edge taken off after more than 400 moves that are deeper elsewhere: the deepest is theirs; both are said."""
    program = Program(Setting.any(random, False))
    deep = random.uniform(0.3, 0.6)
    program.tool(tools.end_mill(6.0))
    program.rapid((-14.0, -4.0, 3.0))
    program.line((-14.0, -4.0, -deep), mark="*")
    for row in range(9):
        for i in range(1, 49):
            x = 0.15 * (i if row % 2 == 0 else 48 - i)
            program.line((-14.0 + x, -4.0 + 0.3 * row, -deep), mark="*")
    off = random.uniform(0.4, 0.8) * deep
    program.rapid((23.0 - off, -20.0, -5.0))
    program.line((23.0 - off, 20.0, -5.0), mark="*")
    part = steps([-20.0, 20.0], [-10.0, 10.0], lambda u, v: 0.0, -10.0)
    mark = mark_of(program, ((-20.0, -10.0, -10.0), (20.0, 10.0, 0.0)), part, deep, tolerance, f"{deep:.4f} deep, a wall by {off:.4f}")
    mark.also = off
    return mark


def lacking(random, tolerance):
    """Stock without the part's uppermost layer, of which a cut takes less than is allowed."""
    program = Program(Setting.any(random, False))
    lack, skim = random.uniform(0.2, 2.0), random.uniform(0.2, 0.9) * tolerance
    program.tool(tools.end_mill(8.0))
    face(program, -lack - skim, (-7.0, 0.0, 7.0), 20.0)
    part = steps([-10.0, 10.0], [-8.0, 8.0], lambda u, v: 0.0, -10.0)
    mark = mark_of(program, ((-10.0, -8.0, -10.0), (10.0, 8.0, -lack)), part, lack, tolerance, f"stock {lack:.4f} too small, skimmed by {skim:.5f}")
    mark.no_line = True
    return mark


KINDS = {"many-triangles": rib, "tap-beside": lambda random, tolerance: rib(random, tolerance, True), "many-moves": many,
         "lacking-stock": lacking}
