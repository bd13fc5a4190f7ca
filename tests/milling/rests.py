"""Random programs that leave something thin, or cut something thin through: fins, webs, crests on floors and walls, ribs, slots and
engravings of the part that nobody cuts. How far
it stands out of the part is known by formulas. Every maker takes (random, tolerance) and gives a Mark, or None.
"""
import math

import jobs
import marks
import tools
from blocks import Program, Setting, extruded


def width_of(random, tolerance):
    return tolerance * math.exp(random.uniform(math.log(0.2), math.log(30)))


def begin(random):
    return Program(Setting.any(random, random.random() < 0.35))


def mark_of(program, stock, part, code, depth, tolerance, what):
    program.end()
    mark = marks.Mark(program, stock, code, depth, what)
    mark.part, mark.least = part, tolerance
    mark.check = {"tolerance": tolerance, "gouge": tolerance, "rest_material": tolerance}
    return mark


def pass_along(program, x, z, half=30.0, mark=""):
    program.rapid((x, -half, z))
    program.line((x, half, z), mark=mark)


def fin(random, tolerance):
    """Two slots side by side with a little left between them, where the part has one wide slot."""
    program, thin, d = begin(random), width_of(random, tolerance), random.choice([4.0, 6.0, 8.0])
    depth = round(random.uniform(1, 0.9 * d), 3)
    lo, hi = (-20.0, -12.0, -12.0), (20.0, 12.0, 0.0)
    program.tool(tools.end_mill(d))
    x = d / 2 + thin / 2
    pass_along(program, -x, -depth, mark="*")
    pass_along(program, x, -depth, mark="*")
    side = d + thin / 2
    part = extruded([(lo[0], lo[2]), (hi[0], lo[2]), (hi[0], 0.0), (side, 0.0), (side, -depth), (-side, -depth), (-side, 0.0),
                     (lo[0], 0.0)], lo[1], hi[1])
    return mark_of(program, (lo, hi), part, "rest-material", depth, tolerance, f"fin {thin:.5f} thin, end mill {d}")


def web(random, tolerance):
    """A T-slot cutter that leaves the roof, where the part has an open slot."""
    program, thin = begin(random), width_of(random, tolerance)
    d, width, neck = random.choice([(12.0, 3.0, 6.0), (16.0, 4.0, 8.0), (20.0, 5.0, 8.0)])
    lo, hi = (-20.0, -12.0, -14.0), (20.0, 12.0, 0.0)
    program.tool(tools.t_slot(d, width, neck))
    floor = -width - thin
    pass_along(program, 0.0, floor, mark="*")
    r = d / 2
    part = extruded([(lo[0], lo[2]), (hi[0], lo[2]), (hi[0], 0.0), (r, 0.0), (r, floor), (-r, floor), (-r, 0.0), (lo[0], 0.0)], lo[1], hi[1])
    mark = mark_of(program, (lo, hi), part, "rest-material", min(-floor, r - neck / 2), tolerance, f"web {thin:.5f} thin, T-slot {d}")
    mark.beside = mark.beside | {"holder-in-stock"}  # the neck runs through it, and takes nothing
    mark.deepest = max(mark.depth, min(-floor, r))
    return mark


def crests(random, tolerance):
    """Rows of a ball, as far apart as leaves crests of a wanted height."""
    program, high, r = begin(random), width_of(random, tolerance), random.choice([3.0, 5.0, 8.0])
    high = min(high, 0.95)  # the stock is 1 mm higher
    apart = 2 * math.sqrt(2 * r * high - high * high)
    half = min(10.0, 20 * apart)
    lo, hi = (-half, -8.0, -8.0), (half, 8.0, 0.0)
    program.tool(tools.ball(2 * r))
    n = math.ceil(half / apart) + 1
    x0 = random.uniform(-0.5, 0.5) * apart
    for k in range(-n, n + 1):
        pass_along(program, x0 + k * apart, -1.0, 20.0, mark="*")
    return mark_of(program, (lo, hi), jobs.box(lo, (half, 8.0, -1.0)), "rest-material", high, tolerance, f"crests of a ball {2 * r}")


def plunges(random, tolerance):
    """A wall made by plunging side by side."""
    program, high, d = begin(random), width_of(random, tolerance), random.choice([6.0, 10.0, 16.0])
    r = d / 2
    apart = 2 * math.sqrt(2 * r * high - high * high)
    half = min(12.0, 12 * apart)
    lo, hi = (-half, -2.0, -10.0), (half, 10.0, 0.0)
    program.tool(tools.end_mill(d))
    n = math.ceil(half / apart) + 1
    for k in range(-n, n + 1):
        program.rapid((k * apart, -r, 2.0))
        program.line((k * apart, -r, -11.0), mark="*")
        program.line((k * apart, -r, 2.0), rapid=True)
    return mark_of(program, (lo, hi), jobs.box((-half, 0.0, -10.0), hi), "rest-material", high, tolerance, f"plunges of an end mill {d}")


def rib(random, tolerance):
    """A thin wall of the part that a tool goes through."""
    program, thin = begin(random), width_of(random, tolerance)
    lo, hi, high = (-20.0, -12.0, -10.0), (20.0, 12.0, 0.0), round(random.uniform(3, 8), 3)
    tool = tools.any_tool(random)
    program.tool(tool)
    part = extruded([(lo[0], lo[2]), (hi[0], lo[2]), (hi[0], 0.0), (thin / 2, 0.0), (thin / 2, high), (-thin / 2, high), (-thin / 2, 0.0),
                     (lo[0], 0.0)], lo[1], hi[1])
    y, z, way = random.uniform(-4, 4), random.uniform(0.2, 0.3 * high), random.uniform(-0.6, 0.6)
    program.rapid((-17.0, y - 17 * way, z))
    program.line((17.0, y + 17 * way, z), mark="*")
    return mark_of(program, part, part, "gouge", thin, tolerance, f"rib {thin:.5f} thin, {tool.keys}")


def bump(random, tolerance):
    """A slot as wide as its tool, open or with a roof, in which the tool touches all round; at one place it goes aside by a
    little, on a way from very short to long."""
    program, depth = begin(random), marks.depth_of(random, tolerance)
    roof, half = random.random() < 0.4, random.choice([0.02, 0.3, 2.0, 5.0])
    d, width, neck, corner = random.choice([(12.0, 3.0, 6.0, 0.0), (16.0, 4.0, 8.0, 0.5)])
    r, floor = d / 2, -9.0
    tool = tools.t_slot(d, width, neck, corner) if roof else tools.end_mill(d)
    lo, hi = (-20.0, -12.0, -16.0), (20.0, 12.0, 0.0)
    top = [(lo[0], lo[2]), (hi[0], lo[2]), (hi[0], 0.0)]
    if roof:
        n = neck / 2 + 1.0  # the slot that carries the neck is wider and there before
        top += [(n, 0.0), (n, floor + width), (r, floor + width), (r, floor), (-r, floor), (-r, floor + width), (-n, floor + width), (-n, 0.0)]
        if corner > 0:  # the corners that the cutter leaves are round
            return None
    else:
        top += [(r, 0.0), (r, floor), (-r, floor), (-r, 0.0)]
    part = extruded(top + [(lo[0], 0.0)], lo[1], hi[1])
    program.tool(tool)
    way = random.choice([(1, 0), (-1, 0), (0, -1)] + ([(0, 1)] if roof else []))
    y = random.uniform(-5, 5)
    program.rapid((0.0, -30.0, floor))
    program.line((0.0, y - half, floor))
    program.line((way[0] * depth, y, floor + way[1] * depth), mark="*")
    program.line((0.0, y + half, floor), mark="*")
    program.line((0.0, 30.0, floor))
    whole = not roof and random.random() < 0.5
    mark = mark_of(program, (lo, hi) if whole else part, part, "gouge", depth, tolerance, f"bump of {half} towards {way} with {tool.keys}")
    if whole and way[1] == 0:
        mark.beside = {"rest-material"}  # on the wall across
    if roof and depth > 0.999:  # as far as the neck stands off its slot
        mark.beside = mark.beside | {"holder-in-stock"}
    return mark


def uncut(random, tolerance):
    """A slot, an engraving or a hole of the part, narrower than the tools are, that nobody cuts."""
    program, kind, d = begin(random), random.choice(["slot", "slot", "engraving", "hole"]), random.choice([6.0, 10.0, 16.0, 50.0])
    # A gap deeper than three tolerances counts however narrow; one as wide as a tenth of the tolerance is none.
    width = tolerance * math.exp(random.uniform(math.log(0.3), math.log(30)))
    lo, hi, top, x = (-10.0, -6.0, -8.0), (10.0, 6.0, 0.0), -1.0, round(random.uniform(-3, 3), 4)
    depth = round(random.uniform(0.5, 5), 3)
    if kind == "engraving":
        width = max(width, 8 * tolerance)
        depth = width / 2 * random.choice([0.8, 1.0, 2.0])
    if kind == "hole":  # square, as deep as it is
        part = block_with_hole(lo, hi, top, x, random.uniform(-2, 2), width, depth)
    else:
        cut = [(x + width / 2, top), (x, top - depth), (x - width / 2, top)] if kind == "engraving" else [
            (x + width / 2, top), (x + width / 2, top - depth), (x - width / 2, top - depth), (x - width / 2, top)]
        part = extruded([(lo[0], lo[2]), (hi[0], lo[2]), (hi[0], top), *cut, (lo[0], top)], lo[1], hi[1])
    program.tool(tools.end_mill(d))
    rows = math.ceil(20 / d) + 1
    for k in range(rows + 1):
        pass_along(program, -10 + 20 * k / rows, top, 40.0, mark="*")
    mark = mark_of(program, (lo, hi), part, "rest-material", depth, tolerance, f"{kind} {width:.5f} wide that nobody cuts, end mill {d}")
    mark.at_faces = kind != "hole"
    if kind == "engraving":  # seen by chance it is as high as material stands off the part
        mark.depth = depth * math.sin(math.atan2(width / 2, depth))
        mark.deepest = depth
    return mark


def block_with_hole(lo, hi, top, x, y, width, depth):
    ring = lambda x0, y0, x1, y1, z: [(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)]
    foot, rim = ring(lo[0], lo[1], hi[0], hi[1], lo[2]), ring(lo[0], lo[1], hi[0], hi[1], top)
    h = width / 2
    mouth, floor = ring(x - h, y - h, x + h, y + h, top), ring(x - h, y - h, x + h, y + h, top - depth)
    out = []
    for k in range(4):
        n = (k + 1) % 4
        for a, b, c, d in ((foot[k], foot[n], rim[n], rim[k]), (rim[k], rim[n], mouth[n], mouth[k]), (mouth[k], mouth[n], floor[n], floor[k])):
            out += [(a, b, c), (a, c, d)]
    for a, b, c, d in (floor, foot[::-1]):
        out += [(a, b, c), (a, c, d)]
    return out


def rapid_through(random, tolerance):
    """A rapid through what two slots have left between them."""
    program, thin, d = begin(random), width_of(random, tolerance), random.choice([4.0, 6.0, 8.0])
    depth, deep = round(random.uniform(2, 4), 3), round(random.uniform(0.5, 1.5), 3)
    lo, hi = (-20.0, -12.0, -12.0), (20.0, 12.0, 0.0)
    program.tool(tools.end_mill(d))
    x = d / 2 + thin / 2
    pass_along(program, -x, -depth)
    pass_along(program, x, -depth)
    program.rapid((-x, random.uniform(-5, 5), -deep))
    program.line((x, program.at[1], -deep), rapid=True, mark="*")
    mark = mark_of(program, (lo, hi), None, "rapid-in-stock", deep, tolerance, f"fin {thin:.5f} thin, {deep} deep, end mill {d}")
    mark.check = {"scope": "collisions", "tolerance": tolerance}
    return mark


KINDS = {"bump": bump, "rapid-fin": rapid_through, "fin": fin, "web": web, "uncut": uncut, "crests": crests, "plunges": plunges, "rib": rib}
