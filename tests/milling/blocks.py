"""Bodies and programs in a frame of their own, and how they stand in the workpiece: turned about the tool's axis (so that no
face lies along a ray) and, on a machine with two rotary axes, swivelled.
"""
import math
import random as randoms

import jobs

MACHINE = """name = "two rotary axes"
kind = "mill"
chain = ["B", "A", "X", "Y", "Z"]
[[axis]]
name = "X"
[[axis]]
name = "Y"
[[axis]]
name = "Z"
[[axis]]
name = "A"
rotary = true
centre = [0.0, 0.0, 0.0]
[[axis]]
name = "B"
rotary = true
centre = [0.0, 0.0, 0.0]
"""
SAFE = 150.0


def add(a, b, k=1.0):
    return tuple(x + k * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    n = math.sqrt(dot(a, a))
    return tuple(x / n for x in a)


def turn(p, axis, degrees):
    """Counter-clockwise about x (0), y (1) or z (2)."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    q = list(p)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    q[i], q[j] = c * p[i] - s * p[j], s * p[i] + c * p[j]
    return tuple(q)


class Setting:
    """From the own frame to that of the program (turned by `about`) and on to the workpiece (swivelled by a and b)."""

    def __init__(self, about=0.0, a=0.0, b=0.0):
        self.about, self.a, self.b = about, a, b

    @staticmethod
    def any(random, five):
        about = random.choice([0.0, 0.0, 90.0, 45.0, round(random.uniform(-180, 180), 3)])
        if not five:
            return Setting(about)
        a, b = random.choice([(30.0, 0.0), (-45.0, 0.0), (0.0, 60.0), (random.uniform(-70, 70), random.uniform(-70, 70))])
        return Setting(about, round(a, 3), round(b, 3))

    def program(self, p):
        return turn(p, 2, self.about)

    def work(self, p):
        return turn(turn(self.program(p), 0, self.a), 1, self.b)

    def mesh(self, triangles):
        return [tuple(self.work(p) for p in t) for t in triangles]

    @property
    def plain(self):
        return self.about == 0 and not self.swivels

    @property
    def swivels(self):
        return self.a != 0 or self.b != 0


def swivelling(folder):
    """What a job needs for the machine with two rotary axes."""
    (folder / "five.toml").write_text(MACHINE)
    return {"machine": "five.toml", "tables": ["[datum]", "G54 = { x = 0.0, y = 0.0, z = 0.0 }"]}


def number(v):
    return f"{v:.6f}".rstrip("0").rstrip(".") if abs(v) >= 5e-7 else "0"


class Program:
    """Lines with marks, and the same moves for exact/. Marks: "*" to blame, "+" may be named."""

    def __init__(self, setting, inch=False):
        self.setting, self.unit = setting, 25.4 if inch else 1.0
        self.lines, self.moves, self.tools = [], [], []
        self.at = None
        self.put(("G20" if inch else "G21") + " G90 G17 G40 G80 G94", "F40" if inch else "F800")

    def put(self, *texts, mark=""):
        self.lines += [(t, mark) for t in texts]

    def tool(self, tool):
        if self.at is not None:
            self.line((*self.at[:2], SAFE), rapid=True)
        self.tools.append(tool)
        n = len(self.tools)
        self.put(f"T{n} M6", f"G0 G43 H{n} Z{number(SAFE / self.unit)}", "M3 S3000")
        if self.setting.swivels and n == 1:
            self.put(f"G54 G0 A{number(self.setting.a)} B{number(self.setting.b)}")

    def words(self, p):
        return " ".join(w + number(v / self.unit) for w, v in zip("XYZ", self.setting.program(p)))

    def line(self, p, rapid=False, mark=""):
        self.put(f"G{0 if rapid else 1} {self.words(p)}", mark=mark)
        if self.at is not None:
            self.moves.append(("line", len(self.tools) - 1, self.at, p))
        self.at = p

    def rapid(self, p):
        """Over a safe height."""
        if self.at is not None:
            self.line((*self.at[:2], SAFE), rapid=True)
        self.line((*p[:2], SAFE), rapid=True)
        self.line(p, rapid=True)

    def arc(self, p, centre, counter, mark=""):
        i, j, _ = add(self.setting.program(centre), self.setting.program(self.at), -1)
        self.put(f"G{3 if counter else 2} {self.words(p)} I{number(i / self.unit)} J{number(j / self.unit)}", mark=mark)
        u, v = add(self.at, centre, -1), add(p, centre, -1)
        sweep = math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])
        if counter and sweep <= 1e-9:
            sweep += 2 * math.pi
        if not counter and sweep >= -1e-9:
            sweep -= 2 * math.pi
        self.moves.append(("arc", len(self.tools) - 1, self.at, p, (*centre[:2], self.at[2]), sweep))
        self.at = p

    def end(self):
        self.line((*self.at[:2], SAFE), rapid=True)
        self.put("M2")

    def guilty(self):
        """Line numbers to blame, and those that may be named."""
        return ({n + 1 for n, (_, m) in enumerate(self.lines) if m == "*"}, {n + 1 for n, (_, m) in enumerate(self.lines) if m})

    def write(self, folder, stock, part=None, clamps=(), check=None, **more):
        """stock: a box (lo, hi) in the own frame, or triangles; part and clamps: triangles."""
        import stl_parts
        s = self.setting
        if isinstance(stock, tuple) and not s.plain:
            stock = jobs.box(*stock)
        if not isinstance(stock, tuple) and not isinstance(stock, dict):
            stl_parts.write(folder / "stock.stl", s.mesh(stock))
            stock = {"file": "stock.stl"}
        fixtures = []
        for n, clamp in enumerate(clamps):
            if isinstance(clamp, dict):
                fixtures.append({"name": f"clamp {n}", **clamp})
                continue
            stl_parts.write(folder / f"clamp{n}.stl", s.mesh(clamp))
            fixtures.append({"name": f"clamp {n}", "file": f"clamp{n}.stl"})
        if s.swivels:
            more = {**more, **swivelling(folder)}
        jobs.write(folder, [t for t, _ in self.lines], [(n + 1, t.keys) for n, t in enumerate(self.tools)], stock,
                   s.mesh(part) if part is not None else None, fixtures, check=check, **more)

    def scene(self, stock):
        """For exact/, in the workpiece's frame; the stock an upright box there. The neck of a T-slot cutter does not cut."""
        text = ["box " + " ".join(repr(v) for p in stock for v in p)]
        for t in self.tools:
            text += ["tool"] + ["body " + " ".join(repr(float(v)) for v in b) for b in t.bodies[:1 if t.keys["kind"] == "t-slot" else None]]
        say = lambda p: " ".join(repr(v) for v in self.setting.work(p))
        for kind, tool, a, b, *arc in self.moves:
            text.append(f"{kind} {tool} {say((0.0, 0.0, 1.0))} {say(a)} {say(b)}"
                        + (f" {say(arc[0])} {say((0.0, 0.0, 1.0))} {arc[1]!r}" if arc else ""))
        return "\n".join(text) + "\n"


def planes_meet(a, b, c):
    """Where three planes (normal, distance) meet."""
    n = cross(b[0], c[0])
    k = dot(a[0], n)
    p = add(add(tuple(a[1] * v for v in n), cross(c[0], a[0]), b[1]), cross(a[0], b[0]), c[1])
    return tuple(v / k for v in p)


class Block:
    """A body with six flat faces: 0 its top, 1 … 4 its sides round about, 5 its bottom."""

    def __init__(self, planes):
        self.planes = planes
        sides = [(planes[1 + i], planes[1 + (i + 1) % 4]) for i in range(4)]
        self.low = [planes_meet(planes[5], a, b) for a, b in sides]   # corner i lies between the sides i and i + 1
        self.high = [planes_meet(planes[0], a, b) for a, b in sides]

    @staticmethod
    def any(random, slanted):
        """About 50 x 40 x 25, its top about z 0; with slanted faces or upright ones."""
        lean = lambda most: math.radians(random.uniform(-most, most)) if slanted and random.random() < 0.6 else 0.0
        x, y = random.uniform(20, 30), random.uniform(16, 24)
        planes = []
        t, way = abs(lean(40)), random.uniform(0, 2 * math.pi)
        planes.append(((math.sin(t) * math.cos(way), math.sin(t) * math.sin(way), math.cos(t)), 0.0))
        for (nx, ny), far in (((1, 0), x), ((0, 1), y), ((-1, 0), x), ((0, -1), y)):
            t = lean(25)
            planes.append(((nx * math.cos(t), ny * math.cos(t), math.sin(t)), far * math.cos(t)))
        planes.append(((0.0, 0.0, -1.0), random.uniform(30, 40)))
        block = Block(planes)
        # A top that leans far may cut through the bottom: such a body crosses itself.
        inside = all(dot(n, p) < d + 1e-6 for n, d in planes for p in block.low + block.high)
        return block if inside else Block.any(random, slanted)

    def triangles(self):
        a, b = self.low, self.high
        out = [(a[0], a[2], a[1]), (a[0], a[3], a[2]), (b[0], b[1], b[2]), (b[0], b[2], b[3])]
        for i in range(4):
            j = (i + 1) % 4
            out += [(a[i], a[j], b[j]), (a[i], b[j], b[i])]
        return out

    def box(self):
        return tuple(min(p[k] for p in self.low + self.high) for k in range(3)), \
            tuple(max(p[k] for p in self.low + self.high) for k in range(3))

    def face_at(self, face, u, v):
        """A place on the top or a side, u and v 0 … 1."""
        if face == 0:
            q = self.high
        else:  # side i lies between the corners i - 1 and i, counted from 1
            i, j = (face - 2) % 4, (face - 1) % 4
            q = [self.low[i], self.low[j], self.high[j], self.high[i]]
        low, high = add(q[0], add(q[1], q[0], -1), u), add(q[3], add(q[2], q[3], -1), u)
        return add(low, add(high, low, -1), v)


def extruded(outline, y0, y1):
    """Triangles of an outline (x, z), seen along y counter-clockwise in (x, z), from y0 to y1."""
    out, n = [], len(outline)
    ring = lambda y: [(x, y, z) for x, z in outline]
    a, b = ring(y0), ring(y1)
    for i in range(n):
        j = (i + 1) % n
        out += [(a[i], a[j], b[j]), (a[i], b[j], b[i])]
    out = [(p, r, q) for p, q, r in out]
    area = lambda p, q, r: (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    left = list(range(n))
    while len(left) > 2:  # ears
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            p, q, r = outline[i], outline[j], outline[m]
            others = [outline[o] for o in left if o not in (i, j, m)]
            if area(p, q, r) > 0 and not any(area(p, q, o) >= 0 and area(q, r, o) >= 0 and area(r, p, o) >= 0 for o in others):
                out += [(a[i], a[j], a[m]), (b[i], b[m], b[j])]
                left.pop(k)
                break
        else:
            raise AssertionError("outline crosses itself")
    return out


def volume(triangles):
    return sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6


def self_test():
    random = randoms.Random(1)
    for _ in range(100):
        b = Block.any(random, True)
        assert volume(b.triangles()) > 0
        for face in range(5):
            n, d = b.planes[face]
            assert abs(dot(n, b.face_at(face, random.random(), random.random())) - d) < 1e-9
    assert abs(volume(extruded([(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)], 0, 2)) - 16) < 1e-9


if __name__ == "__main__":
    self_test()
