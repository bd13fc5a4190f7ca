"""Random turning jobs, correct by construction, and one fault each."""
import math

import profiles
from profiles import Element, add, away


class Case:
    def __init__(self, tool, stock, part, keys=""):
        self.tool, self.stock, self.part, self.keys = tool, stock, part, keys
        self.lines = []  # text, guilty
        self.amount, self.codes = 0.0, ()

    def line(self, text, guilty=False):
        self.lines.append((f"N{10 * len(self.lines) + 10} {text}", guilty))


def word(z, x):
    return f"X{2 * x + 0.0:.5f} Z{z:.5f}"


class Turner:
    """Writes moves of a nose's centre as moves of the programmed point. `flip`: level about which x is mirrored (bores)."""

    def __init__(self, case, nose, flip=None):
        self.case, self.nose, self.flip = case, nose, flip

    def point(self, c):
        x = c[1] - self.nose
        return word(c[0] - self.nose, x if self.flip is None else self.flip - x)

    def rapid(self, c, guilty=False):
        self.case.line("G0 " + self.point(c), guilty)

    def feed(self, c, guilty=False):
        self.case.line("G1 " + self.point(c), guilty)

    def element(self, e, backwards=False, guilty=False):
        end = e.start if backwards else e.end()
        if e.radius == 0:
            return self.feed(end, guilty)
        left = (e.radius > 0) != backwards  # counter-clockwise as drawn: z right, x up
        if self.flip is not None:
            left = not left
        # In G18 the third axis looks at the (z, x) plane from behind: G2 is counter-clockwise as drawn with z right, x up.
        self.case.line(f"{'G3' if left else 'G2'} {self.point(end)} CR={abs(e.radius):.5f}", guilty)


def faulty(way, random, amount):
    """The way with one element moved by `amount` along its normal, joined by short straight runs; and which elements those are."""
    chosen = [i for i, e in enumerate(way) if e.radius == 0 and e.length > 1.5]
    i = random.choice(chosen)
    by = tuple(amount * v for v in away(way[i].angle))
    e = way[i].moved(by)
    joints = [Jog(way[i].start, e.start), e, Jog(e.end(), way[i].end())]
    return way[:i] + joints + way[i + 1:], {i, i + 1, i + 2, i + 3}


class Jog(Element):
    def __init__(self, a, b):
        super().__init__(a, 0.0)
        self.b = b

    def end(self):
        return self.b


def contour(case, random, elements, nose, flip, start_x, deep, amount, fault):
    """Roughing in passes from start_x (the stock's side) and one finishing cut. `deep`: greatest depth of a pass."""
    turner = Turner(case, nose, flip)
    way = profiles.way_about(elements, nose)
    rough = [e.offset(0.3) for e in profiles.way_about(elements, nose)]
    first, clear = rough[0].start, start_x + 2 + nose
    level, guilty_rapid = start_x, fault == "rapid"
    passes = []
    while level - deep > first[1] - nose + 0.05:
        level -= random.uniform(0.6, 1) * deep
        stop = profiles.height_at(rough, level + nose)
        passes.append((level + nose, rough[-1].end()[0] if stop is None else stop))
    passes = [p for p in passes if p[1] < first[0] - 0.5]
    wrong = random.randrange(len(passes)) if guilty_rapid and passes else -1
    turner.rapid((2 + nose, clear))
    for k, (x, z) in enumerate(passes):
        turner.rapid((2 + nose, x))
        (turner.rapid if k == wrong else turner.feed)((z, x), k == wrong)
        turner.feed((z + 0.5, x + 0.5))
        turner.rapid((2 + nose, x + 0.5))
    if flip is None:
        turner.rapid((2 + nose, clear))
    guilty = set()
    if fault == "contour":
        way, guilty = faulty(way, random, amount)
    case.codes = {"contour": ("gouge",) if amount < 0 else ("rest-material",), "rapid": ("rapid-in-stock",)}.get(fault, ())
    if wrong < 0 and fault == "rapid":
        return False
    enter, leave = add(way[0].start, (2 + nose, 0)), way[-1].end()
    if flip is None and random.random() < 0.4:  # from the left to the right
        turner.rapid((leave[0], clear))
        turner.feed(leave)
        for i in range(len(way) - 1, -1, -1):
            turner.element(way[i], True, i in guilty)
        turner.feed(enter)
        turner.rapid((enter[0], clear))
    else:
        turner.rapid((enter[0], clear if flip is None else enter[1]))
        turner.rapid(enter)
        turner.feed(way[0].start)
        for i, e in enumerate(way):
            turner.element(e, False, i in guilty)
        turner.rapid((leave[0], clear if flip is None else leave[1] + 0.3))
    turner.rapid((60, clear if flip is None else leave[1] + 0.3))
    return True


def head(case, tool, text):
    case.line(f"G18 G90 G95 F0.1 ; {text}")
    case.line(f"T{tool} D1")
    case.line("G97 S1000 M4")


def outside(random, amount=0.0, fault=None):
    nose = random.choice([0.2, 0.4, 0.8, 1.2])
    x0 = random.uniform(5, 25)
    elements = profiles.random_profile(random, (0.0, x0), nose, 18)
    end = elements[-1].end()
    radius = end[1] + random.uniform(0.5, 3)
    case = Case(f'number = 1\nkind = "turning"\nnose_radius = {nose}\norientation = 3\nedge_length = 30.0',
                f"bar = {{ diameter = {2 * radius:.9f}, z_min = {end[0]:.9f}, z_max = 0.5 }}",
                "profile = [ " + ", ".join(profiles.points_of(elements)) + " ]")
    head(case, 1, "outside")
    case.line(f"G0 X{2 * radius + 4:.5f} Z0")
    case.line(f"G1 X{-2 * nose:.5f}")
    case.line("G0 Z2")
    return case if contour(case, random, elements, nose, None, radius, random.uniform(1, 3), amount, fault) else None


def bore(random, amount=0.0, fault=None):
    nose = random.choice([0.2, 0.4, 0.8])
    elements = profiles.random_profile(random, (0.0, 5.0), nose, 12)
    end = elements[-1].end()
    flip = end[1] + random.uniform(6, 12)  # the radius at height 0
    inner = flip - end[1] - random.uniform(0.5, 2)
    outer = flip + 6
    room = 2 * inner - 1.5
    case = Case(f'number = 2\nkind = "turning"\nnose_radius = {nose}\norientation = 2\nedge_length = {max(2.0, 0.6 * room):.3f}\n'
                f"holder = {{ bar = {0.4 * room:.3f}, f = {0.3 * room:.3f}, overhang = 80.0 }}",
                f"tube = {{ outer_diameter = {2 * outer:.9f}, inner_diameter = {2 * inner:.9f}, z_min = {end[0]:.9f}, z_max = 0 }}",
                "closed = true\nprofile = [ " + ", ".join(profiles.points_of(elements, flip)) +
                f", {{z = {end[0]:.9f}, x = {outer:.9f}}}, {{z = 0, x = {outer:.9f}}} ]")
    head(case, 2, "bore")
    return case if contour(case, random, elements, nose, flip, flip - inner, random.uniform(0.8, 2), amount, fault) else None


def groove(random, amount=0.0, fault=None, face=False):
    """A groove with flanks square or slanting, its bottom's corners as the blade's."""
    blade, corner = random.choice([2.0, 3.0, 4.0]), random.choice([0.1, 0.2, 0.4])
    width, depth = blade + random.uniform(0.5, 12), random.uniform(2, 8)
    left, right = (random.choice([0.0, random.uniform(0.05, 0.6)]) for _ in range(2))  # angles against square
    top = random.uniform(15, 40)
    at = -random.uniform(3, 10) - width - 12 if not face else random.uniform(5, 10)
    bottom = top - depth
    # Everything along (u, v): u along the groove's width, v out of the material. Outside u is z and v is x; on a face u is x, v is z.
    level = 0.0 if face else top
    low = level - depth
    dl, dr = depth * math.tan(left), depth * math.tan(right)
    u0, u1 = at, at + width + dl + dr  # edges at the surface
    place = (lambda u, v: (v, u)) if face else (lambda u, v: (u, v))
    text = lambda u, v, r="": "{{z = {:.9f}, x = {:.9f}{}}}".format(*place(u, v), r)
    tl = corner * math.tan((math.pi / 2 - left) / 2)
    tr = corner * math.tan((math.pi / 2 - right) / 2)
    # As drawn from left to right: down the left flank, its round corner, the bottom, the right one. On a face everything is mirrored.
    sign = -1 if face else 1
    l0 = (u0 + dl - tl * math.sin(left), low + tl * math.cos(left))
    r1 = (u1 - dr + tr * math.sin(right), low + tr * math.cos(right))
    chain = [text(u0, level), text(*l0, f", r = {sign * corner}"), text(u0 + dl + tl, low), text(u1 - dr - tr, low, f", r = {sign * corner}"),
             text(*r1), text(u1, level)]
    if face:
        stock = f"bar = {{ diameter = {2 * (u1 + 5):.9f}, z_min = -30, z_max = 0 }}"
        part = f"closed = true\nprofile = [ {text(0, -30)}, {text(0, 0)}, " + ", ".join(chain) + f", {text(u1 + 5, 0)}, {text(u1 + 5, -30)} ]"
    else:
        stock = f"bar = {{ diameter = {2 * top:.9f}, z_min = {u0 - 10:.9f}, z_max = 0 }}"
        part = f"profile = [ {text(u0 - 10, level)}, " + ", ".join(chain) + f", {text(0, level)} ]"
    case = Case(f'number = 3\nkind = "groove"\nwidth = {blade}\ncorner_radius = {corner}\ncutting_depth = 15.0\ndirection = "{"face" if face else "out"}"\n'
                + ("" if face else f"holder = {{ z = [-6.0, {blade + 6}], x = [{depth + 0.5:.3f}, 80.0] }}"), stock, part)
    head(case, 3, "face groove" if face else "groove")
    go = lambda g, u, v, guilty=False: case.line(f"G{g} " + word(*place(u, v)), guilty)
    clear = level + 2
    case.line("G0 " + (word(*place(u0, clear)) if not face else word(clear, u0)))
    # Plunges 0.2 mm off flanks and bottom, then both flanks from above with the bottom halves.
    span0, span1 = u0 + dl + tl + 0.2, u1 - dr - tr - 0.2 - blade
    plunges = [u0 + dl + max(tl, 0.2), u1 - dr - max(tr, 0.2) - blade] if span1 <= span0 else []
    if not plunges:
        n = max(1, math.ceil((span1 - span0) / (0.8 * blade)))
        plunges = [span0 + (span1 - span0) * i / n for i in range(n + 1)]
    wrong = random.randrange(len(plunges)) if fault == "rapid" else -1
    for k, u in enumerate(plunges):
        go(0, u, clear)
        go(0 if k == wrong else 1, u, low + 0.2, k == wrong)
        go(0, u, clear)
    shift = {"bottom": amount, "left": amount, "right": amount}.get(fault, 0.0)
    sl, sr, sb = ((shift if fault == k else 0.0) for k in ("left", "right", "bottom"))
    # The corner's centre stands `corner` off flank and bottom: the sharp corner of the blade from the circle's centre.
    cl = (u0 + dl + tl, low + corner)  # centre of the left round corner
    cr = (u1 - dr - tr, low + corner)
    middle = 0.5 * (cl[0] + cr[0])
    along = lambda angle, s: (-s * math.sin(angle), s * math.cos(angle))
    shift_l = (sl / math.cos(left), 0.0)
    shift_r = (-sr / math.cos(right), 0.0)
    up = (depth + 1.5) / math.cos(max(left, right))
    tip = lambda c: (c[0] - corner, c[1] - corner)  # left corner's programmed point
    tip_right = lambda c: (c[0] + corner - blade, c[1] - corner)
    a = add(add(cl, along(left, up)), shift_l)
    go(0, *tip((a[0], max(a[1], clear + corner))))
    go(0, *tip(a))
    go(1, *tip(add(add(cl, along(left, sb / math.cos(left))), shift_l)), fault in ("left", "bottom"))
    end_l = min(max(middle - blade / 2, cl[0]), cr[0] + 2 * corner - blade)
    end_l = max(end_l, cl[0])
    go(1, *tip((end_l, cl[1] + sb)), fault == "bottom")
    go(0, *tip((end_l, clear + corner)))
    b = add(add(cr, along(-right, up)), shift_r)
    go(0, *tip_right((b[0], max(b[1], clear + corner))))
    go(0, *tip_right(b))
    go(1, *tip_right(add(add(cr, along(-right, sb / math.cos(right))), shift_r)), fault in ("right", "bottom"))
    # Until it stands where the left half ended.
    go(1, tip((end_l, 0))[0], low + sb, fault == "bottom")
    go(0, tip((end_l, 0))[0], clear)
    case.codes = {"rapid": ("rapid-in-stock",), None: ()}.get(fault, ("gouge",) if amount < 0 else ("rest-material",))
    case.line("G0 " + (word(60, top + 20)))
    return case


def face_groove(random, amount=0.0, fault=None):
    return groove(random, amount, fault, True)


def finish(case):
    if case is not None:
        case.line("M30")
    return case


MAKERS = {"outside": (outside, ("contour", "contour", "rapid")), "bore": (bore, ("contour", "contour", "rapid")),
          "groove": (groove, ("bottom", "left", "right", "rapid")), "face": (face_groove, ("bottom", "left", "right", "rapid"))}
