"""An oracle for examples/groove that shares nothing with obrys: it runs the few SINUMERIK words those programs use by
rewriting them as Python, and keeps the stock as a height over z, exact at the centre of each cell.
"""
import math
import pathlib
import re


class Alarm(Exception):
    """SETAL, with its number and the message before it."""


RAD = math.pi / 180
FUNCTIONS = {"TAN": lambda a: math.tan(a * RAD), "COS": lambda a: math.cos(a * RAD), "MINVAL": min, "MAXVAL": max}


def expression(text):
    text = re.sub(r"\bR(\d+)\b", r"r[\1]", text)
    text = re.sub(r"\bOR\b", "or", re.sub(r"\bAND\b", "and", text))
    return text


def statement(line, folder):
    """One block as Python: (text, indentation before it, indentation after it)."""
    flow = re.match(r"(IF|WHILE)\b(.*)$", line)
    jump = re.match(r"IF\b(.*)\bGOTOF (\w+)$", line)
    if jump:
        return f"if {expression(jump.group(1))}: raise Jump('{jump.group(2)}')", 0, 0
    if flow:
        return f"{flow.group(1).lower()} {expression(flow.group(2))}:", 0, 1
    if line in ("ELSE", "ENDIF", "ENDWHILE"):
        return ("else:", -1, 1) if line == "ELSE" else ("pass", 0, -1)
    call = re.match(r"(GROOVE\w*)(\(.*\))?$", line)
    if call:
        return f"call('{call.group(1)}', {expression((call.group(2) or '()')[1:-1])})", 0, 0
    words = re.findall(r"([A-Z]\w*)(?:=([^= ]+(?:\([^=]*\))?)(?= |$))?", line)
    assigned = re.findall(r"(\w+)=(.+?)(?=\s+\w+=|$)", line)
    if words and words[0][0] in ("G0", "G1"):
        targets = ", ".join(f"{name.lower()}={expression(value)}" for name, value in assigned)
        return f"move({words[0][0] == 'G0'}, {targets})", 0, 0
    if assigned and words[0][0] not in ("G96",):
        return "; ".join(f"{expression(name)} = {expression(value)}" for name, value in assigned), 0, 0
    return "pass", 0, 0


def compile_program(name, folder):
    """A Python function of a program: (parameter names, source, alarm texts by label)."""
    suffix = ".MPF" if name.endswith("_MAIN") or name.endswith("_WRONG") else ".SPF"
    parameters, body, alarms, depth, label = [], ["pass"], {}, 1, None
    for raw in (pathlib.Path(folder) / (name + suffix)).read_text().splitlines():
        line = re.sub(r"^N\d+\s+", "", raw.split(";")[0].strip()).strip()
        head = re.match(r"PROC \w+(?:\((.*?)\))?", line)
        if head:
            parameters = re.findall(r"REAL (\w+)", head.group(1) or "")
        elif line.endswith(":"):
            label = line[:-1]
            alarms[label] = [0, ""]
        elif label and line.startswith("MSG"):
            alarms[label][1] = line[5:-2]
        elif label and line.startswith("SETAL"):
            alarms[label][0] = int(line[6:-1])
        elif line and not label and not re.match(r"(DEF|EXTERN|M17|M30)\b", line):
            text, before, after = statement(line, folder)
            depth += before
            body.append(" " * depth + text)
            depth += after
    assert depth == 1, name
    return parameters, "def program(" + ", ".join(parameters) + "):\n " + "\n".join(body), alarms


class Jump(Exception):
    pass


def run(folder, name="GROOVE_MAIN", settings=None):
    """Moves (rapid, x, z, program) of a program; `settings` replaces constant assignments of R parameters."""
    moves, position, r, compiled = [], {"x": None, "z": None}, {}, {}

    class Parameters(dict):
        def __setitem__(self, number, value):
            super().__setitem__(number, (settings or {}).get(f"R{number}", value))

    r = Parameters()

    def call(program, *arguments):
        if program not in compiled:
            compiled[program] = compile_program(program, folder)
        parameters, source, alarms = compiled[program]
        scope = {"r": r, "call": call, "Jump": Jump, "move": lambda rapid, **to: move(program, rapid, **to), **FUNCTIONS}
        exec(source, scope)  # our own example programs only
        try:
            scope["program"](*arguments)
        except Jump as jump:
            raise Alarm(*alarms[str(jump)]) from None

    def move(program, rapid, **to):
        position.update(to)
        moves.append((rapid, position["x"], position["z"], program))

    call(name)
    return moves, dict(r)


class Contour:
    """A chain of (z, x) points with rising z; `at` gives x."""

    def __init__(self, points):
        self.points = points

    def at(self, z):
        for (z0, x0), (z1, x1) in zip(self.points, self.points[1:]):
            if z <= z1:
                return x0 + (x1 - x0) * (z - z0) / (z1 - z0) if z1 > z0 else min(x0, x1)
        return self.points[-1][1]


def meet(p, direction_p, q, direction_q):
    """Where two lines cross."""
    det = direction_p[0] * direction_q[1] - direction_p[1] * direction_q[0]
    t = ((q[0] - p[0]) * direction_q[1] - (q[1] - p[1]) * direction_q[0]) / det
    return p[0] + t * direction_p[0], p[1] + t * direction_p[1]


def contours(r):
    """Surface, finished groove and groove with allowance as line intersections, from the parameters' meaning alone."""
    surface = ((r[1], r[0]), (math.cos(r[2] * RAD), math.sin(r[2] * RAD)))
    right = (-math.sin(r[5] * RAD), -math.cos(r[5] * RAD))    # down the right flank
    left = (-math.sin(r[6] * RAD), math.cos(r[6] * RAD))      # up the left flank
    start = (r[1], r[0])
    bottom_right = meet(start, right, (0, r[0] - r[3]), (1, 0))
    bottom_left = (bottom_right[0] - r[4], bottom_right[1])
    top_left = meet(bottom_left, left, *surface)
    on_right = (start[0] - r[8] * math.cos(r[5] * RAD), start[1] + r[8] * math.sin(r[5] * RAD))
    on_left = (bottom_left[0] + r[8] * math.cos(r[6] * RAD), bottom_left[1] + r[8] * math.sin(r[6] * RAD))
    level = ((0, r[0] - r[3] + r[7]), (1, 0))
    finished = [top_left, bottom_left, bottom_right, start]
    rough = [meet(on_left, left, *surface), meet(on_left, left, *level), meet(on_right, right, *level),
             meet(on_right, right, *surface)]
    return surface, finished, rough


def with_surface(groove, surface, low, high):
    """The groove's corners, continued along the surface on both sides."""
    (z0, x0), (dz, dx) = surface
    at = lambda z: x0 + (z - z0) * dx / dz
    return Contour([(low, at(low)), *groove, (high, at(high))])


def swept_height(z, a, b, width):
    """Lowest x of the blade's edge above z during a move of its left corner from a to b; None where it stays beside."""
    (za, xa), (zb, xb) = a, b
    low, high = z - width, z                      # left corner positions that cover z
    if za == zb:
        return min(xa, xb) if low <= za <= high else None
    t0, t1 = sorted(((low - za) / (zb - za), (high - za) / (zb - za)))
    t0, t1 = max(0.0, t0), min(1.0, t1)
    return min(xa + (xb - xa) * t0, xa + (xb - xa) * t1) if t0 <= t1 else None


def machine(moves, width, stock, low, high, cell=0.05):
    """Cuts the stock: cell centres, heights left, rapids that removed material (move number, depth), and the least
    distance of a rapid sideways above the stock."""
    count = round((high - low) / cell)
    centres = [low + (i + 0.5) * cell for i in range(count)]
    heights = [stock.at(z) for z in centres]
    crashes, clearance, before = [], math.inf, None
    for number, (rapid, x, z, _) in enumerate(moves):
        if before is not None and None not in (x, z, *before):
            first = max(0, int((min(z, before[0]) - low) / cell) - 1)
            last = min(count, int((max(z, before[0]) + width - low) / cell) + 2)
            for i in range(first, last):
                x_tool = swept_height(centres[i], before, (z, x), width)
                if x_tool is not None and rapid and x == before[1] and z != before[0]:
                    clearance = min(clearance, x_tool - heights[i])
                if x_tool is not None and x_tool < heights[i]:
                    if rapid and x_tool < heights[i] - 1e-6:
                        crashes.append((number, heights[i] - x_tool))
                    heights[i] = x_tool
        before = (z, x)
    return centres, heights, crashes, clearance
