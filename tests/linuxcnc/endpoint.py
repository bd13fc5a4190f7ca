"""Where printed canonical calls leave the machine, and what obrys' first error says."""
import math
import pathlib
import re

CALL = re.compile(r"^ *\d+ N\S* *([A-Z0-9_]+)\((.*)\)$")
PLANES = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "XZ": (2, 0, 1)}
STRAIGHT = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE", "RIGID_TAP")


class Machine:
    """Program coordinates and what lies between them and the machine, in mm and degrees."""

    def __init__(self):
        self.unit, self.plane, self.rotation = 1.0, "XY", 0.0
        self.at, self.g5x, self.g92, self.tool = [0.0] * 6, [0.0] * 6, [0.0] * 6, [0.0] * 6

    def metric(self, values):
        return [v * self.unit if i < 3 else v for i, v in enumerate(values)] + [0.0] * (6 - len(values))

    def position(self):
        x, y = self.at[0] + self.g92[0], self.at[1] + self.g92[1]
        c, s = math.cos(math.radians(self.rotation)), math.sin(math.radians(self.rotation))
        turned = [x * c - y * s, x * s + y * c] + [a + g for a, g in zip(self.at[2:], self.g92[2:])]
        return [t + g + l for t, g, l in zip(turned, self.g5x, self.tool)]

    def place(self, machine):
        """The program coordinates of a machine position: an offset that changes does not move the machine."""
        x, y, *rest = [m - g - l for m, g, l in zip(machine, self.g5x, self.tool)]
        c, s = math.cos(math.radians(-self.rotation)), math.sin(math.radians(-self.rotation))
        turned = [x * c - y * s, x * s + y * c, *rest]
        self.at = [t - g for t, g in zip(turned, self.g92)]

    def arc(self, v):
        first, second, third = PLANES[self.plane]
        x = [0.0] * 3
        x[first], x[second], x[third] = v[0], v[1], v[5]
        self.at = self.metric(x + v[6:9])

    def take(self, name, text):
        numbers = [float(n) for n in re.findall(r"-?[0-9]+\.[0-9]+|-?\b(?:nan|inf)\b|-?\b[0-9]+\b", text)]
        before = self.position()
        if name == "USE_LENGTH_UNITS":
            self.unit = 25.4 if "INCH" in text else 1.0
        elif name == "SELECT_PLANE":
            self.plane = text[-2:] if text[-2:] in PLANES else self.plane
        elif name in STRAIGHT:
            kept = self.at[len(numbers):]
            self.at = self.metric(numbers)[:len(numbers)] + kept
        elif name == "ARC_FEED":
            self.arc(numbers)
        elif name in ("SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "USE_TOOL_LENGTH_OFFSET"):
            self.offset(name, numbers)
            self.place(before)

    def offset(self, name, numbers):
        if name == "SET_G5X_OFFSET":
            self.g5x = self.metric(numbers[1:7])
        elif name == "SET_G92_OFFSET":
            self.g92 = self.metric(numbers[:6])
        elif name == "SET_XY_ROTATION":
            self.rotation = numbers[0]
        else:
            self.tool = self.metric(numbers[:6])


def end_point(text):
    """Machine position behind the last call; NURBS calls count by the straight or arc calls around them."""
    machine = Machine()
    for line in text.splitlines():
        found = CALL.match(line)
        if found and found[1] not in ("COMMENT", "MESSAGE", "LOG"):
            machine.take(found[1], found[2])
    return machine.position()


def close(a, b, tolerance):
    return all(abs(p - q) <= tolerance for p, q in zip(a, b))


def shown(point):
    return "(" + " ".join(f"{v:.4f}" for v in point) + ")"


PLACED = re.compile(r"^(.*?):(\d+):\d+: (error|warning): (.*)$", re.M)
# obrys goes on behind these and ends "not fully checked" (exit 3), where LinuxCNC refuses the program.
AS_REFUSED = ("[missing-subprogram]", "[unclosed]")


def refusal(text):
    """What obrys refuses: the first error, or else what it says of a missing subprogram or end. None: nothing."""
    found = list(PLACED.finditer(text))
    errors = [f for f in found if f[3] == "error"]
    others = [f for f in found if f[4].endswith(AS_REFUSED)]
    return (errors + others)[0] if errors or others else None


def first_error(text):
    found = refusal(text) or PLACED.search(text)
    return f"{pathlib.PurePath(found[1]).name}:{found[2]}: {found[4]}" if found else text.strip()[-160:]


def error_line(text):
    """Text of the line that is refused; obrys prints it below the message."""
    found = refusal(text)
    if not found:
        return None
    below = text[found.end():].splitlines()[1:2]
    return below[0] if below else None
