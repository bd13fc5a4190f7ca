"""Random marks of tools in bodies with flat faces: scratches, edges and corners taken off, at a depth known by formulas.

Every maker takes (random, tolerance) and gives a Mark, or None where what was drawn cannot be made. The tool stands with the
farthest of its points a wanted depth beyond a plane: of a face, or of one that cuts an edge or a corner off. The block is
convex, so nothing of the tool lies deeper in it than that.
"""
import math

import tools
from blocks import Block, Program, Setting, add, cross, dot, unit

LIFT = 3.0  # mm beside what is marked
STRAIGHT = ["line", "line", "dip", "touch", "steps"]


class Mark:
    def __init__(self, program, stock, code, depth, what):
        self.program, self.stock, self.code, self.depth, self.what = program, stock, code, depth, what
        self.part, self.clamps = None, []
        self.check = {}
        self.beside = set()   # codes of findings that belong to it
        self.deepest = depth  # depths up to this one are right, too
        self.at_faces = False  # it ends at faces that no move has cut, so no line need be named there
        self.least = 0.0      # depths above it must be found
        self.also = 0.0       # depth of another one
        self.no_line = False  # no block is to blame


def depth_of(random, tolerance):
    """Now and then it only touches."""
    return 0.0 if random.random() < 0.12 else tolerance * math.exp(random.uniform(math.log(0.2), math.log(30)))


def contact(random, tool, out):
    """Where on the tool its farthest point against a direction `out` lies, seen from the programmed point; and whether the
    tool is smooth there, no tip and no rim."""
    aside = math.hypot(out[0], out[1])
    rings = [(-z * out[2] + r * aside + b[4], r, z, b) for b in tool.bodies for r, z in ((b[0], b[1]), (b[2], b[3]))]
    most = max(v for v, _, _, _ in rings)
    ties = [(r, z, b) for v, r, z, b in rings if v > most - 1e-9]
    k = random.random()
    r, z, b = ties[0]
    smooth = b[4] > 0
    if len(ties) > 1 and ties[1][2] is b:
        r, z = ties[0][0] + k * (ties[1][0] - ties[0][0]), ties[0][1] + k * 0.5 * (ties[1][1] - ties[0][1])
        smooth = True
    if aside < 1e-9:
        way = random.uniform(0, 2 * math.pi)
        return (k * r * math.cos(way), k * r * math.sin(way), z - b[4] * out[2]), smooth or r > 1
    flat = (-out[0] / aside, -out[1] / aside)
    return (r * flat[0] - b[4] * out[0], r * flat[1] - b[4] * out[1], z - b[4] * out[2]), smooth


def stand(tool, at, out, offset, depth):
    """The programmed point, so that the tool's farthest point lies `depth` beyond the plane through `at`."""
    lift = dot(at, out) + tool.reach(tuple(-v for v in out)) - depth
    c = add(at, offset, -1)
    return add(c, out, lift - dot(c, out))


def come(program, at, out, rapid):
    """To a place a little off the surface, without meeting the block."""
    if out[2] >= -1e-9:
        program.rapid(at)
        return
    flat = unit((out[0], out[1], 0.0))
    far = add(at, flat, 120.0)
    program.rapid(far)
    program.line(at, rapid=True)


def leave(program, out):
    at = add(program.at, out, LIFT)
    program.line(at)
    if out[2] < -1e-9:
        program.line(add(at, unit((out[0], out[1], 0.0)), 120.0), rapid=True)


def motion(random, program, spots, depth, out, rapid, kinds):
    """Between programmed points of equal depth: how the mark is drawn. `spots` gives the point at a share of the way."""
    a, b = spots(0.0), spots(1.0)
    kind = random.choice(kinds)
    up = lambda p, far=LIFT: add(p, out, far)
    start = up(a)
    come(program, start, out, rapid)
    feed = dict(rapid=rapid)
    if kind == "line":
        program.line(a, mark="*", **feed)
        program.line(b, mark="*", **feed)
        program.line(up(b), mark="*", **feed)
    elif kind == "touch":
        program.line(a, mark="*", **feed)
        program.line(up(a), mark="*", **feed)
    elif kind == "dip":
        program.line(up(a, depth + 0.5), **feed)
        program.line(spots(0.5), mark="*", **feed)
        program.line(up(b, depth + 0.5), mark="*", **feed)
    elif kind == "steps":
        n = random.randint(4, 12)
        deep = random.randint(1, n - 1)
        for i in range(n + 1):
            program.line(up(spots(i / n), 0.0 if i == deep else depth + 0.3), mark="*" if i in (deep, deep + 1) else "", **feed)
    else:
        middle = spots(0.5)
        half = add(a, middle, -1)
        to = add(middle, (half[1], -half[0], half[2])) if random.random() < 0.5 else add(middle, half, -1)
        if kind == "helix":
            program.line(up(a, depth + 0.5))
            program.arc(to, (*middle[:2], program.at[2]), True, mark="*")
        else:
            program.line(a, mark="*")
            program.arc(to, middle, random.random() < 0.5, mark="*")
        program.line(up(program.at), mark="*")
    leave(program, out)
    return kind


def begin(random):
    return Program(Setting.any(random, random.random() < 0.4), inch=random.random() < 0.1)


ELSEWHERE = ((-120.0, -10.0, -30.0), (-100.0, 10.0, 0.0))  # a small stock far from all else, where clamps alone are judged


def begin_with(random, program, tool, code):
    """The tool in the spindle, before that an honest cut where clamps alone are judged; whether the mark is made by rapid."""
    if code == "clamp-collision":
        program.tool(tools.end_mill(10.0))
        program.rapid((-150.0, 0.0, -1.0))
        program.line((-90.0, 0.0, -1.0))
    program.tool(tool)
    return code == "rapid-in-stock" or (code == "clamp-collision" and random.random() < 0.5)


def finish(tolerance, program, block, slanted, code, depth, what):
    """What is marked is the part, the stock or a clamp."""
    body = block.triangles() if slanted or not program.setting.plain else block.box()
    if code == "clamp-collision":
        mark = Mark(program, ELSEWHERE, code, depth, what)
        mark.clamps = [block.triangles()]
        mark.check, mark.least = {"scope": "collisions"}, 0.001
    else:
        mark = Mark(program, body, code, depth, what)
        mark.least = tolerance
        if code == "gouge":
            mark.part = block.triangles()
        else:
            mark.check = {"scope": "collisions"}
    mark.check["tolerance"] = tolerance
    return mark


def scratch(random, tolerance, code="gouge"):
    """A tool that goes past a flat face."""
    slanted = random.random() < 0.5
    block, depth = Block.any(random, slanted), depth_of(random, tolerance)
    program = begin(random)
    face = random.choice([0, 0, 0, 1, 2, 3, 4])
    out = block.planes[face][0]
    tool = tools.any_tool(random, undercut=True)
    if code == "clamp-collision" and random.random() < 0.25:
        tool = tools.stepped(*random.choice([(6.0, 10.0, 8.0), (4.0, 6.0, 5.0)]))
    if out[2] < -1e-9 and not tool.keys["kind"] in ("t-slot", "form"):
        return None
    rapid = begin_with(random, program, tool, code)
    offset, _ = contact(random, tool, out)
    if tool.keys["kind"] in ("t-slot", "form") and offset[2] > tool.bodies[0][3] + tool.bodies[0][4] + 1e-9:
        return None  # its neck, which does not cut
    u0, v0, u1, v1 = (random.uniform(0.25, 0.75) for _ in range(4))
    ends = block.face_at(face, u0, v0), block.face_at(face, u1, v1)
    short = min(1.0, random.uniform(0.2, 14) / max(0.2, math.dist(*ends)))
    spots = lambda t: stand(tool, add(ends[0], add(ends[1], ends[0], -1), t * short), out, offset, depth)
    level = abs(out[2] - 1) < 1e-12 and not rapid
    kind = motion(random, program, spots, depth, out, rapid, STRAIGHT + (["arc", "helix"] if level else []))
    program.end()
    mark = finish(tolerance, program, block, slanted, code, depth, f"{kind} on face {face} with {tool.keys}")
    if code == "rapid-in-stock":  # along the tool's axis it may stand higher
        mark.deepest = math.inf if depth > 0.08 * tool.radius else depth / max(out[2], 0.2)
    return mark


def smooth_direction(random, tool, normals, along):
    """A direction between the normals of the faces of an edge (across `along`) or a corner, in which the tool is smooth."""
    for _ in range(60):
        k = [random.uniform(0.2, 1) for _ in normals]
        m = unit(tuple(sum(w * n[i] for w, n in zip(k, normals)) for i in range(3)))
        kind = tool.keys["kind"]
        if kind == "end-mill":
            lift = 0.0
        elif kind in ("chamfer", "countersink", "drill"):
            b = tool.bodies[0]
            lift = (b[2] - b[0]) / math.hypot(b[2] - b[0], b[3] - b[1])
        elif kind in ("ball", "bull-nose"):
            lift = None if m[2] > 0.1 else 0.1
        else:
            return None
        if lift is not None:
            level = math.sqrt(1 - lift * lift)
            if along is None:
                flat = unit((m[0], m[1], 0.0))
                m = (level * flat[0], level * flat[1], lift)
            else:  # across the edge: of both solutions the nearer one
                size = math.hypot(along[0], along[1])
                if size * level < abs(lift * along[2]) + 1e-9:
                    continue
                middle = math.atan2(along[1], along[0])
                half = math.acos(-lift * along[2] / (level * size))
                m = max(((level * math.cos(middle + s * half), level * math.sin(middle + s * half), lift) for s in (1, -1)),
                        key=lambda v: dot(v, m))
        weights = weights_of(m, normals, along)
        if min(weights) > 0.2 and sum(weights) < 1.9:  # of flatter cuts only a part of the depth is promised
            return m
    return None


def weights_of(m, normals, along):
    """Of which weights of the normals it is the sum; that of all is how much deeper the edge lies in the tool than it in the body."""
    rows = list(normals) + ([along] if along is not None else [])
    c = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])]
    k = dot(rows[0], c[0])
    return [dot(m, c[i]) / k for i in range(len(normals))]


def edge(random, tolerance, code="gouge"):
    """An edge or a corner taken off: an unwanted chamfer, a clip."""
    slanted = random.random() < 0.5
    block, depth = Block.any(random, slanted), depth_of(random, tolerance)
    program = begin(random)
    tool = tools.any_tool(random)
    i = random.randrange(4)
    a, b = 1 + i, 1 + (i + 1) % 4
    where = random.choice(["upright", "upper", "upper", "corner"])
    if where == "upright":
        faces, ends = (a, b), (block.low[i], block.high[i])
    elif where == "upper":
        faces, ends = (0, b), (block.high[i], block.high[(i + 1) % 4])
    else:
        faces, ends = (0, a, b), (block.high[i], block.high[i])
    along = unit(add(ends[1], ends[0], -1)) if where != "corner" else None
    out = smooth_direction(random, tool, [block.planes[f][0] for f in faces], along)
    if out is None:
        return None
    offset, smooth = contact(random, tool, out)
    if not smooth or 2 * depth > tool.radius:
        return None
    rapid = begin_with(random, program, tool, code)
    place = add(ends[0], add(ends[1], ends[0], -1), random.uniform(0.3, 0.7))
    if where == "upright" and tool.keys["kind"] == "end-mill":  # its end lies below the top, its shaft runs along the edge
        offset = (*offset[:2], max(offset[2], 3.0))
    # Across the edge the place is met in the middle of the way.
    lengthwise = where == "upper" and random.random() < 0.5
    way = along if lengthwise else unit(cross(out, along or unit((random.uniform(-1, 1), random.uniform(-1, 1), 0.9))))
    length = random.uniform(1, 10 if lengthwise else 20)
    spots = lambda s: add(stand(tool, place, out, offset, depth), way, (s - 0.5) * length)
    if tool.depth(add(place, spots(0.5), -1)) < 0.999 * depth - 1e-9:
        return None  # another of its faces is nearer
    kind = motion(random, program, spots, depth, out, rapid, STRAIGHT if lengthwise else ["line", "dip"])
    program.end()
    mark = finish(tolerance, program, block, slanted, code, depth, f"{kind} at {where} edge with {tool.keys}")
    if code == "rapid-in-stock":  # along the tool's axis it may stand higher
        mark.deepest = math.inf if depth > 0.08 * tool.radius else depth / max(out[2], 0.15)
    return mark


KINDS = {
    "scratch": scratch,
    "edge": edge,
    "rapid": lambda random, tolerance: scratch(random, tolerance, "rapid-in-stock"),
    "rapid-edge": lambda random, tolerance: edge(random, tolerance, "rapid-in-stock"),
    "clamp": lambda random, tolerance: scratch(random, tolerance, "clamp-collision"),
    "clamp-edge": lambda random, tolerance: edge(random, tolerance, "clamp-collision"),
}
