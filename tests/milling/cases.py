"""Random jobs: a program, its tools and stock, and the rings of the part that it makes when nothing is wrong with it.

Every maker takes (random, sagitta, fault, amount) and gives a Case; with a fault one thing of the program or of its tool is
wrong by `amount` mm, the lines that are to blame carry the mark "*", those that may be named beside them "+", and
`expected` says by formulas what is then to be found. None: this fault cannot be made here, or leaves too little.
"""
import math
import re

from stl_parts import Circle, Rectangle

SAFE = 30.0


class Case:
    def __init__(self, box, centre):
        self.box, self.centre = box, centre
        self.tools, self.lines, self.rings = [], [], []
        self.through = False
        self.tip = None
        self.expected = {}  # mm by the finding's code
        self.optional = set()  # codes that may be found or not

    def expect(self, gouge=0.0, rest=0.0):
        for code, amount in (("gouge", gouge), ("rest-material", rest)):
            if amount > 0:
                self.expected[code] = max(amount, self.expected.get(code, 0.0))

    def scaled(self, k):
        """The same, smaller: what a fine tolerance can be checked on in a short time."""
        shrink = lambda m: m.group(1) + mm(float(m.group(2)) * k)
        self.lines = [(re.sub(r"([XYZIJKRQ])(-?[0-9.]+)", shrink, t), mark) for t, mark in self.lines]
        self.box = tuple(v * k for v in self.box)
        lengths = ("diameter", "length", "pitch", "tip_diameter")
        self.tools = [(n, {key: v * k if key in lengths else v for key, v in keys.items()}) for n, keys in self.tools]
        self.expected = {code: v * k for code, v in self.expected.items()}
        return self

    def tool(self, number, **keys):
        keys.setdefault("length", 90.0)
        self.tools.append((number, keys))

    def change(self, number, rotation="M3 S3000"):
        self.put(f"T{number} M6", f"G0 G43 H{number} Z{SAFE:g}", rotation)

    def put(self, *texts, mark=""):
        self.lines += [(text, mark) for text in texts]

    def block(self, outline_of_top):
        """The rings of the block's lower face and side; the top one is at outline_of_top."""
        x0, y0, z0, x1, y1, _ = self.box
        a, b = (x1 - x0) / 2, (y1 - y0) / 2
        side = Rectangle(a, b, dx=(x0 + x1) / 2 - self.centre[0], dy=(y0 + y1) / 2 - self.centre[1])
        self.rings = [(side, z0), (side, outline_of_top)]
        return side


def mm(v):
    return f"{v:.6f}".rstrip("0").rstrip(".") if v else "0"


def pick(random, low, high):
    """Now a round number, now one of three decimals."""
    step = random.choice([1.0, 0.5, 0.5, 0.001])
    return round(math.floor(random.uniform(low, high) / step) * step, 3)


def begin(random, size=None, height=None):
    sx, sy = size or (pick(random, 40, 70), pick(random, 36, 56))
    h = height or pick(random, 12, 25)
    x0, y0 = random.choice([(0.0, 0.0), (-sx / 2, -sy / 2), (pick(random, -20, 20), pick(random, -20, 20))])
    top = random.choice([0.0, 0.0, 0.0, pick(random, -3, 20)])
    case = Case((x0, y0, top - h, x0 + sx, y0 + sy, top), (0, 0))
    case.put("G21 G90 G17 G40 G80 G94", "F800")
    return case, top, (x0 + sx / 2, y0 + sy / 2)


def layers(random, top, depth, most):
    n = math.ceil(depth / most)
    return [top - round(depth * (i + 1) / n, 3) if i + 1 < n else top - depth for i in range(n)]


class Frame:
    """Turns and moves the feature's own coordinates."""

    def __init__(self, centre, turn):
        self.c, self.cos, self.sin = centre, math.cos(turn), math.sin(turn)
        if turn == 0:
            self.cos, self.sin = 1.0, 0.0

    def xy(self, x, y):
        return f"X{mm(self.c[0] + x * self.cos - y * self.sin)} Y{mm(self.c[1] + x * self.sin + y * self.cos)}"


def crest(length, radius, amount):
    """What stays between two places of a tool so far apart, on a wall that it leaves by `amount` between them."""
    if length <= 0:
        return 0.0
    half = min(length / 2, radius)
    return min(amount, radius - math.sqrt(radius * radius - half * half))


def contour(frame, a, b, r, sign=1, wrong=None, amount=0.0, lengths=None):
    """Lines around a rectangle, counter-clockwise from the middle of its right side, or (sign -1) clockwise; corners are arcs of
    radius r. Of side number `wrong` the second half lies `amount` farther out. Gives [(text, mark)]."""
    corners = [(a, b), (-a, b), (-a, -b), (a, -b)]
    if sign < 0:
        corners = [(a, -b), (-a, -b), (-a, b), (a, b)]
    out, at = [], (a, 0.0)
    for i in range(5):
        cx, cy = corners[i % 4]
        along = (0, sign * 1) if i % 4 == 0 else (-1, 0) if i % 4 == 1 else (0, -sign * 1) if i % 4 == 2 else (1, 0)
        outwards = (sign * along[1], -sign * along[0])
        end = (cx - along[0] * r, cy - along[1] * r) if i < 4 else (a, 0.0)
        if wrong == i and i < 4:
            mid = ((at[0] + end[0]) / 2, (at[1] + end[1]) / 2)
            off = (amount * outwards[0], amount * outwards[1])
            if lengths is not None:
                lengths.append((end[0] - mid[0]) * along[0] + (end[1] - mid[1]) * along[1] - 2)
            out.append(("G1 " + frame.xy(*mid), ""))
            out.append(("G1 " + frame.xy(mid[0] + off[0], mid[1] + off[1]), "*"))
            out.append(("G1 " + frame.xy(end[0] - 2 * along[0] + off[0], end[1] - 2 * along[1] + off[1]), "*"))
            out.append(("G1 " + frame.xy(end[0] - 2 * along[0], end[1] - 2 * along[1]), "*"))
        out.append(("G1 " + frame.xy(*end), ""))
        at = end
        if i < 4 and r > 0:
            nxt = (0, sign * 1) if (i + 1) % 4 == 0 else (-1, 0) if (i + 1) % 4 == 1 else (0, -sign * 1) if (i + 1) % 4 == 2 else (1, 0)
            to = (cx + nxt[0] * r, cy + nxt[1] * r)
            middle = (cx - along[0] * r + nxt[0] * r, cy - along[1] * r + nxt[1] * r)
            i_, j_ = middle[0] - at[0], middle[1] - at[1]
            i_, j_ = i_ * frame.cos - j_ * frame.sin, i_ * frame.sin + j_ * frame.cos
            out.append((f"G{3 if sign > 0 else 2} {frame.xy(*to)} I{mm(i_)} J{mm(j_)}", ""))
            at = to
    return out


def rectangular_pocket(random, sagitta, fault, amount):
    case, top, middle = begin(random)
    d = random.choice([5.0, 6.0, 8.0, 10.0])
    r = d / 2
    x0, y0, z0, x1, y1, _ = case.box
    turn = random.choice([0, 0, 0, math.radians(random.choice([90, 30, 45, 12.345]))])
    room = min(x1 - x0, y1 - y0) / 2 - 3 if turn else None
    a = pick(random, d + 1, (room or (x1 - x0) / 2 - 3) * (0.7 if turn else 1))
    b = pick(random, d + 1, (room or (y1 - y0) / 2 - 3) * (0.7 if turn else 1))
    corner = r if random.random() < 0.5 else min(round(r + random.choice([0.5, 1, 2.5]), 3), a - 0.5, b - 0.5)
    depth = pick(random, 3, min(12, top - z0 - 1))
    case.centre = middle
    case.tool(1, kind="end-mill", diameter=d)
    if random.random() < 0.5:
        case.tool(7, kind="drill", diameter=random.choice([1.0, 2.5, 3.3]))  # never used: it sets how far rays lie apart
    frame = Frame(middle, turn)
    case.change(1)
    levels, lengths = layers(random, top, depth, d), []
    case.put("G0 " + frame.xy(0, 0), f"G0 Z{mm(top + 2)}")
    for n, z in enumerate(levels):
        last = n + 1 == len(levels)
        floor = "*" if last and fault == "floor" else ""
        level = z - (amount if floor else 0)
        case.put(f"G1 Z{mm(level)}", mark=floor)
        steps = max(1, math.ceil((min(a, b) - r) / (0.45 * d)))  # the first ring still meets the middle
        for k in range(1, steps + 1):
            in_by = (min(a, b) - r) * (1 - k / steps) + 0.2
            sa, sb = a - r - in_by, b - r - in_by
            case.put("G1 " + frame.xy(sa, 0), mark=floor)
            case.lines += [(t, floor) for t, _ in contour(frame, sa, sb, max(0.0, corner - r - in_by))]
        wrong = int(fault[4]) if last and fault and fault.startswith("wall") else None
        case.put("G1 " + frame.xy(a - r, 0), mark=floor)
        path = contour(frame, a - r, b - r, max(0.0, corner - r), 1, wrong, amount, lengths)
        case.lines += [(t, floor or m) for t, m in path]
        case.put("G1 " + frame.xy(0, 0), mark=floor)
    case.put(f"G0 Z{mm(top + SAFE)}")
    if fault:
        left = crest(lengths[0], r, -amount) if lengths else -amount
        case.expect(gouge=amount, rest=left)
        if amount < 0 and left < 30 * sagitta:
            return None
    case.block(top)
    hole = Rectangle(a, b, corner, turn, sagitta)
    case.rings += [(hole, top), (hole, top - depth)]
    return case


def boss(random, sagitta, fault, amount):
    case, top, middle = begin(random)
    x0, y0, z0, x1, y1, _ = case.box
    d = random.choice([6.0, 10.0, 12.0])
    r = d / 2
    half = min(x1 - x0, y1 - y0) / 2
    round_one = random.random() < 0.5
    a = pick(random, 5, half - 6)
    b = a if round_one else pick(random, 5, half - 6)
    corner = a if round_one else round(random.uniform(0.5, min(a, b) - 1), 1)
    if round_one and fault and fault.startswith("wall"):
        return None
    depth = pick(random, 2, min(9, top - z0 - 2))
    case.centre = middle
    case.tool(2, kind="end-mill", diameter=d)
    case.change(2)
    frame = Frame(middle, 0)
    far = math.hypot((x1 - x0) / 2, (y1 - y0) / 2)
    levels, lengths = layers(random, top, depth, d), []
    case.put(f"G0 {frame.xy(far + d, 0)}", f"G0 Z{mm(top + 2)}")
    for n, z in enumerate(levels):
        last = n + 1 == len(levels)
        floor = "*" if last and fault == "floor" else ""
        case.put(f"G1 Z{mm(z - (amount if floor else 0))}", mark=floor)
        out_by = max(far - a, far - b)
        while out_by > 0:
            out_by = max(0.0, out_by - 0.7 * d)
            wrong = int(fault[4]) if last and out_by == 0 and fault and fault.startswith("wall") else None
            ring = 0.2 if 0 < out_by < 0.2 else out_by
            case.put("G1 " + frame.xy(a + r + ring, 0), mark=floor)
            sign = random.choice([1, -1])
            path = contour(frame, a + r + ring, b + r + ring, corner + r + ring, sign, wrong, amount, lengths)
            if round_one:
                g = 3 if sign > 0 else 2
                path = [(f"G{g} {frame.xy(a + r + ring, 0)} I{mm(-(a + r + ring))} J0", "")]
            case.lines += [(t, floor or m) for t, m in path]
        case.put(f"G1 {frame.xy(far + d, 0)}", mark=floor)
    case.put(f"G0 Z{mm(top + SAFE)}")
    if fault == "floor":
        case.expect(gouge=amount, rest=-amount)
    elif fault:
        left = crest(lengths[0], r, amount)
        case.expect(gouge=-amount, rest=left)
        if amount > 0 and left < 30 * sagitta:
            return None
    case.block(top - depth)
    stud = Circle(a, sagitta) if round_one else Rectangle(a, b, corner, 0, sagitta)
    case.rings += [(stud, top - depth), (stud, top)]
    return case


def at_hole(random):
    case, top, middle = begin(random, height=pick(random, 14, 24))
    x, y = round(middle[0] + pick(random, -6, 6), 3), round(middle[1] + pick(random, -6, 6), 3)
    case.centre = (x, y)
    return case, top, x, y


def drilled(case, number, x, y, top, z, mark="", cycle="G81"):
    extra = " Q3" if cycle in ("G83", "G73") else " P0.2" if cycle == "G82" else ""
    case.put(f"G0 Z{mm(top + 5)}", f"G98 {cycle} X{mm(x)} Y{mm(y)} Z{mm(z)} R{mm(top + 1)}{extra} F200", mark=mark)
    case.put("G80", f"G0 Z{mm(top + SAFE)}")


def hole(random, sagitta, fault, amount):
    case, top, x, y = at_hole(random)
    z0 = case.box[2]
    d = random.choice([3.0, 4.0, 5.5, 6.8, 8.5, 10.2, 12.0])
    point = d / 2 / math.tan(math.radians(59))
    through = random.random() < 0.4 and fault != "floor"
    case.tool(3, kind="drill", diameter=round(d + (2 * amount if fault == "tool" else 0), 3))
    case.change(3)
    case.block(top)
    z = z0 - point - 1 if through else pick(random, z0 + point + 3, top - point - 2)
    shift = amount if fault == "place" else 0
    deeper = amount / math.sin(math.radians(59)) if fault == "floor" else 0  # so much as its cone shows normal to itself
    drilled(case, 3, x + shift, y, top, round(z - deeper, 6), "*" if fault else "", random.choice(["G81", "G83", "G73", "G82"]))
    case.expect(gouge=amount, rest=amount if fault == "place" else -amount)
    bore = Circle(d / 2, sagitta)
    if through:
        case.rings += [(bore, top), (bore, z0)]
        case.through = True
    else:
        case.rings += [(bore, top), (bore, z + point)]
        case.tip = z
    return case


TAPS = [(4, 0.7, 3.3), (5, 0.8, 4.2), (6, 1, 5), (8, 1.25, 6.8), (10, 1.5, 8.5), (12, 1.75, 10.2)]


def expect_beside_thread(case, drill, tap, shown, shift, through):
    """Radii. Both walls of the hole against that of the part, of which the thread's depth does not count."""
    depth = shown - drill
    left = lambda off: off - min(max(off, min(0.0, depth)), max(0.0, depth))
    case.expect(gouge=-left(depth - shift), rest=left(shown - max(drill - shift, tap)))
    if not through and shift:
        case.expect(gouge=shift, rest=shift)
    elif shift:  # what the tap leaves of a wall that is not round is within what its thread may show
        case.optional.add("rest-material")


def tapped(random, sagitta, fault, amount):
    """The part shows the drilled hole, the thread's inner or its outer diameter."""
    case, top, x, y = at_hole(random)
    z0 = case.box[2]
    size, pitch, core = random.choice(TAPS)
    point = core / 2 / math.tan(math.radians(59))
    through = random.random() < 0.4
    case.tool(4, kind="drill", diameter=core)
    case.tool(5, kind="tap", diameter=float(size), pitch=pitch)
    z = z0 - point - 1 if through else pick(random, z0 + 2, z0 + 4)
    end = z0 - 2 if through else math.ceil(z + point + 2 * pitch)
    shift = amount if fault == "place" else 0
    case.change(4)
    drilled(case, 4, x + shift, y, top, z, "*" if shift else "", random.choice(["G81", "G83"]))
    case.change(5, "M3 S300")
    case.put(f"G0 X{mm(x)} Y{mm(y)}", f"G0 Z{mm(top + 3)}", f"G33.1 Z{mm(end)} K{mm(pitch)}", f"G0 Z{mm(top + SAFE)}",
             mark="+" if shift else "")
    case.block(top)
    shown = random.choice([core, core, size - 1.0825 * pitch, size])
    expect_beside_thread(case, core / 2, max(size - 1.0825 * pitch, 0.5 * size) / 2, shown / 2, shift, through)
    bore, thread = Circle(core / 2, sagitta), Circle(shown / 2, sagitta)
    if through:
        case.rings += [(thread, top), (thread, z0)]
        case.through = True
    else:
        case.rings += [(thread, top), (thread, end), (bore, end), (bore, z + point)]
        case.tip = z
        if shown == core:
            case.rings = case.rings[:-3] + [(bore, z + point)]
    return case


def reamed(random, sagitta, fault, amount):
    case, top, x, y = at_hole(random)
    z0 = case.box[2]
    d, before = random.choice([(10.0, 9.8), (8.0, 7.8), (6.0, 5.8), (12.0, 11.75)])
    point = before / 2 / math.tan(math.radians(59))
    case.tool(4, kind="drill", diameter=before)
    case.tool(6, kind="reamer", diameter=round(d + (2 * amount if fault == "tool" else 0), 3))
    through = random.random() < 0.5
    z = z0 - point - 1 if through else pick(random, z0 + 2, z0 + 4)
    end = z0 - 1.0 if through else math.ceil(z + point + 1.5)
    case.change(4)
    drilled(case, 4, x, y, top, z)
    case.change(6, "M3 S300")
    drilled(case, 6, x + (amount if fault == "place" else 0), y, top, end, "*" if fault else "", random.choice(["G85", "G82"]))
    case.expect(gouge=amount, rest=min(amount, (d - before) / 2) if fault == "place" else 0)
    case.block(top)
    wide, narrow = Circle(d / 2, sagitta), Circle(before / 2, sagitta)
    if through:
        case.rings += [(wide, top), (wide, z0)]
        case.through = True
    else:
        case.rings += [(wide, top), (wide, end), (narrow, end), (narrow, z + point)]
        case.tip = z
    return case


def helix_bore(random, sagitta, fault, amount):
    """A bore milled by full turns, down to a flat floor or through."""
    case, top, x, y = at_hole(random)
    z0 = case.box[2]
    d = random.choice([6.0, 8.0, 10.0])
    wide = round(d * random.uniform(1.3, 1.9), random.choice([0, 1, 3]))
    way = (wide - d) / 2
    through = random.random() < 0.4 and fault != "floor"
    z = z0 - 1 if through else pick(random, z0 + 2, top - 4)
    case.tool(8, kind="end-mill", diameter=d, plunges=random.choice([True, False]))
    case.change(8)
    off = amount if fault == "tool" else 0
    mark = "*" if fault else ""
    case.put(f"G0 X{mm(x)} Y{mm(y)}", f"G0 Z{mm(top + 1)}", f"G1 X{mm(x + way + off)}")
    turns = max(1, math.ceil((top + 1 - z) / 1.5))
    deeper = amount if fault == "floor" else 0
    g = random.choice([2, 3])
    if random.random() < 0.5:
        case.put(f"G{g} X{mm(x + way + off)} Y{mm(y)} Z{mm(z - deeper)} I{mm(-way - off)} J0 P{turns}", mark=mark)
    else:
        for n in range(1, turns + 1):
            down = z - deeper if n == turns else round(top + 1 - (top + 1 - z) * n / turns, 3)
            case.put(f"G{g} X{mm(x + way + off)} Y{mm(y)} Z{mm(down)} I{mm(-way - off)} J0", mark=mark)
    case.put(f"G{g} X{mm(x + way + off)} Y{mm(y)} I{mm(-way - off)} J0", f"G1 X{mm(x)} Y{mm(y)}", mark=mark)
    case.put(f"G0 Z{mm(top + SAFE)}")
    case.expect(gouge=amount, rest=-amount)
    case.block(top)
    bore = Circle(wide / 2, sagitta)
    case.rings += [(bore, top), (bore, z0 if through else z)]
    case.through = through
    return case


def countersunk(random, sagitta, fault, amount):
    case, top, x, y = at_hole(random)
    z0 = case.box[2]
    d = random.choice([5.0, 6.8, 8.5])
    point = d / 2 / math.tan(math.radians(59))
    tool = 16.0
    wide = round(d + random.choice([1.0, 2.0, 3.2]), 3)
    tip = random.choice([0.0, 2.0])
    case.tool(4, kind="drill", diameter=d)
    case.tool(9, kind="countersink", diameter=tool, tip_diameter=tip)
    case.change(4)
    drilled(case, 4, x, y, top, z0 - point - 1)
    case.change(9, "M3 S500")
    deeper = amount * math.sqrt(2) if fault == "floor" else 0
    z = top - (wide - tip) / 2 - deeper
    drilled(case, 9, x, y, top, z, "*" if fault else "", "G82")
    case.expect(gouge=amount, rest=-amount)
    case.block(top)
    sunk, bore = Circle(wide / 2, sagitta), Circle(d / 2, sagitta)
    case.rings += [(sunk, top), (bore, top - (wide - d) / 2), (bore, z0)]
    case.through = True
    return case


MAKERS = {
    "pocket": (rectangular_pocket, ["floor", "wall0", "wall1", "wall2", "wall3"]),
    "boss": (boss, ["floor", "wall0", "wall1", "wall2", "wall3"]),
    "hole": (hole, ["place", "floor", "tool"]),
    "tapped": (tapped, ["place"]),
    "reamed": (reamed, ["place", "tool"]),
    "helix": (helix_bore, ["floor", "tool"]),
    "countersunk": (countersunk, ["floor"]),
}
