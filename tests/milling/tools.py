"""Random tools of all kinds: the keys of a job, and the bodies they are made of, for formulas and for exact/.

A body is (r0, z0, r1, z1, rounding): the hull of two rings about the axis, grown by a ball; heights from the programmed point.
"""
import math

LENGTH = 90.0
CUTTING = 60.0


class Tool:
    def __init__(self, keys, bodies):
        self.keys = {**keys, "length": max(LENGTH, keys.get("cutting_length", 0.0))}
        self.bodies = bodies

    def reach(self, way):
        """How far any of its points lies along a direction of unit length, seen from the programmed point."""
        aside = math.hypot(way[0], way[1])
        return max(max(z * way[2] + r * aside for r, z in ((b[0], b[1]), (b[2], b[3]))) + b[4] for b in self.bodies)

    def depth(self, p):
        """How deep a place lies in it, seen from the programmed point; negative outside."""
        r = math.hypot(p[0], p[1])
        return max(depth_in_body(b, r, p[2]) for b in self.bodies)

    def scaled(self, k):
        lengths = ("diameter", "length", "tip_diameter", "corner_radius", "cutting_length", "width", "neck_diameter")
        keys = {key: v * k if key in lengths else v for key, v in self.keys.items()}
        if "profile" in keys:
            keys["profile"] = [{key: v * k if key in "xzr" else v for key, v in p.items()} for p in keys["profile"]]
        out = Tool(keys, [tuple(v * k for v in b) for b in self.bodies])
        out.keys["length"] = keys["length"]
        return out

    @property
    def radius(self):
        return max(max(b[0], b[2]) + b[4] for b in self.bodies)


def depth_in_body(body, r, z):
    r0, z0, r1, z1, rounding = body
    size = math.hypot(r1 - r0, z1 - z0)
    if size > 0 and z0 < z < z1:
        inward = ((z - z0) * (r1 - r0) - (r - r0) * (z1 - z0)) / size
        if inward > 0:
            return min(inward, z - z0, z1 - z) + rounding
    away = math.inf
    for ar, az, br, bz in ((r0, z0, r1, z1), (0.0, z0, r0, z0), (0.0, z1, r1, z1)):
        d = (br - ar) ** 2 + (bz - az) ** 2
        t = min(1.0, max(0.0, ((r - ar) * (br - ar) + (z - az) * (bz - az)) / d)) if d > 0 else 0.0
        away = min(away, math.hypot(r - ar - t * (br - ar), z - az - t * (bz - az)))
    return rounding - away


def end_mill(d):
    return Tool({"kind": "end-mill", "diameter": d, "cutting_length": CUTTING}, [(d / 2, 0, d / 2, CUTTING, 0)])


def stepped(d, shank, cutting):
    """An end mill with a shank that is thicker than it."""
    return Tool({"kind": "end-mill", "diameter": d, "cutting_length": cutting, "shank": [{"diameter": shank, "length": 40.0}]},
                [(d / 2, 0, d / 2, cutting, 0), (shank / 2, cutting, shank / 2, cutting + 40.0, 0)])


def ball(d):
    r = d / 2
    return Tool({"kind": "ball", "diameter": d, "cutting_length": CUTTING}, [(0, r, 0, r, r), (r, r, r, CUTTING, 0)])


def bull(d, c):
    r = d / 2
    return Tool({"kind": "bull-nose", "diameter": d, "corner_radius": c, "cutting_length": CUTTING},
                [(r - c, c, r - c, c, c), (r, c, r, CUTTING, 0)])


def cone(kind, d, angle, tip=0.0):
    """chamfer, countersink, drill, centre-drill"""
    r, h = d / 2, (d - tip) / 2 / math.tan(math.radians(angle) / 2)
    keys = {"kind": kind, "diameter": d, "point_angle": angle, "cutting_length": h + CUTTING}
    if kind in ("chamfer", "countersink"):
        keys["tip_diameter"] = tip
        if tip > 0:
            keys["plunges"] = True
    return Tool(keys, [(tip / 2, 0, r, h, 0), (r, h, r, h + CUTTING, 0)])


def t_slot(d, width, neck, corner=0.0):
    r = d / 2
    keys = {"kind": "t-slot", "diameter": d, "width": width, "neck_diameter": neck}
    if corner > 0:
        keys["corner_radius"] = corner
    bodies = [(r - corner, corner, r - corner, width - corner, corner), (neck / 2, width / 2, neck / 2, CUTTING, 0)]
    return Tool(keys, bodies)


def lollipop(d, neck):
    r = d / 2
    top = r + math.sqrt(r * r - neck * neck / 4)
    keys = {"kind": "form", "plunges": True,
            "profile": [{"x": 0.0, "z": 0.0, "r": r}, {"x": neck / 2, "z": top}, {"x": neck / 2, "z": CUTTING}]}
    return Tool(keys, [(0, r, 0, r, r), (neck / 2, r, neck / 2, CUTTING, 0)])


def pointed(random):
    angle = random.choice([20.0, 30.0, 45.0, 60.0, 82.0, 90.0, 120.0])
    return cone(random.choice(["chamfer", "countersink"]), random.choice([6.0, 8.0, 10.0, 12.0]), angle)


def drill(random):
    return cone("drill", random.choice([2.0, 3.3, 5.0, 8.5]), random.choice([90.0, 118.0, 135.0, 140.0]))


def any_tool(random, undercut=False):
    """undercut: also tools that are wider than what carries them."""
    kinds = [
        lambda: end_mill(random.choice([3.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0])),
        lambda: ball(random.choice([2.0, 3.0, 4.0, 6.0, 8.0, 10.0])),
        lambda: bull(*random.choice([(6.0, 0.5), (8.0, 1.0), (10.0, 2.0), (12.0, 1.5), (10.0, 4.0)])),
        lambda: pointed(random),
        lambda: pointed(random),
        lambda: cone("chamfer", 10.0, random.choice([60.0, 90.0, 120.0]), random.choice([0.5, 1.0, 3.0])),
        lambda: drill(random),
    ]
    if undercut:
        kinds += [lambda: t_slot(*random.choice([(12.0, 3.0, 6.0), (16.0, 4.0, 8.0), (20.0, 2.0, 8.0, 0.4), (12.5, 4.0, 6.0, 1.0)])),
                  lambda: lollipop(*random.choice([(6.0, 3.0), (8.0, 4.0), (10.0, 5.0)]))]
    return random.choice(kinds)()
