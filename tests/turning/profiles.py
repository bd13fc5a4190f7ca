"""Profiles that an insert can turn, the way of its nose about them, and the parts they bound. Own geometry: nothing of the program
under test. Points are (z, x), x a radius. A profile leads to the left and away from the axis; a bore's is the same, mirrored in x.
"""
import math


def add(a, b, k=1.0):
    return (a[0] + k * b[0], a[1] + k * b[1])


def ahead(angle):
    """Direction by its angle from -z towards +x."""
    return (-math.cos(angle), math.sin(angle))


def away(angle):
    """Normal of that direction, away from the part."""
    return (math.sin(angle), math.cos(angle))


class Element:
    """A straight run (angle, length) or an arc from one angle to another: about a centre in the part (convex, radius > 0) or outside
    it (concave, radius < 0)."""

    def __init__(self, start, angle, length=0.0, radius=0.0, to=None):
        self.start, self.angle, self.length, self.radius = start, angle, length, radius
        self.to = angle if to is None else to

    def centre(self):
        return add(self.start, away(self.angle), -self.radius)

    def end(self):
        if self.radius == 0:
            return add(self.start, ahead(self.angle), self.length)
        return add(self.centre(), away(self.to), self.radius)

    def offset(self, by):
        """The same element, `by` farther from the part."""
        return Element(add(self.start, away(self.angle), by), self.angle, self.length,
                       0.0 if self.radius == 0 else self.radius + by, self.to)

    def moved(self, by):
        return Element(add(self.start, by), self.angle, self.length, self.radius, self.to)


def random_profile(random, start, nose, reach):
    """Elements from `start` on: cylinders, cones and faces, fillets of more than the nose in every inner corner, outer corners sharp or
    round. `reach`: how far it may lead away from the axis."""
    angles, lengths, risen = [0.0], [random.uniform(3, 8)], 0.0
    for _ in range(random.randint(2, 6)):
        angle = random.choice([0.0, math.pi / 2, random.uniform(0.1, 1.4), random.uniform(0.1, 0.8)])
        if abs(angle - angles[-1]) < 0.1:
            continue
        length = random.uniform(2.5, 7)
        if risen + length * math.sin(angle) > reach:
            continue
        risen += length * math.sin(angle)
        angles.append(angle)
        lengths.append(length)
    if angles[-1] != 0.0:
        angles.append(0.0)
        lengths.append(random.uniform(3, 6))
    radii = []
    for i in range(len(angles) - 1):
        turn = angles[i + 1] - angles[i]
        room = 0.45 * min(lengths[i], lengths[i + 1]) / math.tan(abs(turn) / 2)
        if turn > 0:  # inner corner
            least = nose * 1.05 + 0.05
            if room < least:
                return random_profile(random, start, nose, reach)
            radii.append(-random.uniform(least, min(room, least + 3)))
        else:
            radii.append(random.choice([0.0, random.uniform(0.2, 1) * min(room, 4.0)]))
    elements, at, cut = [], start, 0.0
    for i, angle in enumerate(angles):
        radius = radii[i] if i < len(radii) else 0.0
        after = abs(radius) * math.tan(abs(angles[i + 1] - angle) / 2) if i < len(radii) else 0.0
        line = Element(at, angle, lengths[i] - cut - after)
        elements.append(line)
        at = line.end()
        if radius != 0:
            elements.append(Element(at, angle, 0.0, radius, angles[i + 1]))
            at = elements[-1].end()
        cut = after
    return elements


def way_about(elements, nose):
    """The way of the nose's centre: elements `nose` away, round sharp corners an arc of the nose."""
    out = []
    for i, e in enumerate(elements):
        before = elements[i - 1].to if i else e.angle
        if before - e.angle > 1e-9:
            out.append(Element(add(e.start, away(before), nose), before, 0.0, nose, e.angle))
        out.append(e.offset(nose))
    return out


def height_at(elements, x):
    """The z at which the way first comes as far as x; None where it does not."""
    for e in elements:
        a, b = e.start, e.end()
        if not min(a[1], b[1]) <= x <= max(a[1], b[1]) or abs(a[1] - b[1]) < 1e-9:
            continue
        if e.radius == 0:
            return a[0] + (x - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        c = e.centre()
        rest = max(0.0, e.radius ** 2 - (x - c[1]) ** 2)
        return c[0] + math.copysign(math.sqrt(rest), e.radius)
    return None


def points_of(elements, mirror=None):
    """Points of the job file. `mirror`: a level about which a bore's profile is mirrored."""
    flip = (lambda x: x) if mirror is None else (lambda x: mirror - x)
    out = []
    for e in elements:
        r = ""
        if e.radius != 0:
            left = (e.radius > 0) == (mirror is None)  # seen along the way, leading left with the part below
            r = f", r = {abs(e.radius) if left else -abs(e.radius):.9f}"
        out.append(f"{{z = {e.start[0]:.9f}, x = {flip(e.start[1]):.9f}{r}}}")
    last = elements[-1].end()
    out.append(f"{{z = {last[0]:.9f}, x = {flip(last[1]):.9f}}}")
    return out
