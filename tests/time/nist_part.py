"""The part of the NIST test bed as Klartext again, from the ISO twin that stands beside its log, and what the log says.

Lengths are inches, F is tenths of an inch a minute, as the control counts in programs in inches.
"""
import bz2
import datetime
import math
import re

CALL = re.compile(r"\(TOOL CALL (\d+) Z S(\d+)\)")
CYCLE_VALUE = re.compile(r"\(\s*Q(\d+)=\s*([+-]?[\d.]+)")
WORD = re.compile(r"([GXYZIJF])([+-]?\d*\.?\d+)")


def is_arc(start, end, centre):
    """False: three decimals of an inch leave nothing of a circle as small as this, and the control would not take it."""
    radii = [math.dist((p["X"], p["Y"]), centre) for p in (start, end)]
    return abs(radii[0] - radii[1]) < min(0.0004, 0.05 * max(radii))


def klartext(twin):
    """The program, and the tools in their order."""
    out, tools = ["BEGIN PGM NIST INCH"], []
    mode, fed, cycle, starts, place = 0, "", [], False, {}
    for raw in twin.splitlines():
        line = raw.strip()
        if called := CALL.match(line):
            out.append(f"TOOL CALL {called[1]} Z S{called[2]}")
            tools.append(int(called[1]))
            starts, cycle, mode = True, [], 0
        elif line.startswith("(CYCL DEF 2") and not line.startswith("(CYCL DEF 247"):
            cycle = [line[1:].rstrip("~) ")]
            out.append("CYCL DEF " + cycle[0].split()[2] + " CYCLE")
        elif cycle and (value := CYCLE_VALUE.match(line)):
            out[-1] += f" Q{value[1]}={value[2]}"
            if line.endswith(")") and not line.rstrip(")").rstrip().endswith("~"):
                out.append("CYCL CALL M3")
                cycle.append("called")
        elif line in ("(M5)", "(M08)", "(M09)", "(M01)"):
            out.append("L " + {"(M5)": "M5", "(M08)": "M8", "(M09)": "M9", "(M01)": "M1"}[line])
        elif line.startswith("(M140 MB MAX)"):
            out.append("L Z+12.594 R0 FMAX")  # where the log has it then
        elif line and not line.startswith("(") and (words := dict(WORD.findall(line))):
            mode = int(words.get("G", mode)) if words.get("G", "0") in ("0", "1", "2", "3") else mode
            if "F" in words:
                fed = words["F"].rstrip(".")
            if not any(k in words for k in "XYZ"):
                continue
            end = "".join(f" {k}{float(words[k]):+.5f}" for k in "XYZ" if k in words and (mode < 2 or k != "Z"))
            start = dict(place)
            place.update({k: float(words[k]) for k in "XYZ" if k in words})
            if mode >= 2 and is_arc(start, place, (float(words["I"]), float(words["J"]))):
                out.append(f"CC X{float(words['I']):+.5f} Y{float(words['J']):+.5f}")
                out.append(f"C{end} DR{'-' if mode == 2 else '+'} R0 F{fed}")
            else:
                if mode >= 2 and "Z" in words:
                    end += f" Z{float(words['Z']):+.5f}"
                out.append(f"L{end} R0 " + ("FMAX" if mode == 0 else f"F{fed}"))
                if starts:
                    out[-1] += " M3"
                if len(cycle) > 1 and mode == 0 and "Z" not in words:
                    out[-1] += " M99"
            starts = False
    out += ["M30", "END PGM NIST INCH"]
    return "\n".join(f"{i} {text}" for i, text in enumerate(out)) + "\n", tools


class Log:
    """Seconds from the start of the run, which nothing interrupts, to its end."""

    begin = datetime.datetime(2016, 3, 22, 12, 47, 33, 478296)
    seconds = 566.859

    def __init__(self, path):
        self.places, self.lines = [], []
        with bz2.open(path, "rt") as file:
            for text in file:
                when, item, value = text.rstrip("\n").split("|", 2)
                t = (datetime.datetime.fromisoformat(when.rstrip("Z")[:26].ljust(26, "0")) - self.begin).total_seconds()
                if not 0 <= t <= self.seconds:
                    continue
                if item == "path_pos":
                    self.places.append((t, tuple(map(float, value.split()))))
                elif item == "line":
                    self.lines.append((t, int(value)))

    def changes(self):
        """When tools are changed: the log's lines (of the Klartext program) of the calls."""
        calls = [(82, 89), (138, 139), (677, 678), (748, 749), (951, 958), (1138, 1145), (1166, 1173), (1194, 1201),
                 (1229, 1230), (1253, 1260), (1277, 1284)]
        found = []
        for (a, line), (b, following) in zip(self.lines, self.lines[1:]):
            if (line, following) in calls:
                found.append((a, b))
        return found

    def spans(self):
        """From the end of each change to the begin of the next."""
        changes = self.changes()
        begins = [0.0] + [b for _, b in changes]
        ends = [a for a, _ in changes] + [self.seconds]
        return list(zip(begins, ends))

    def feed_seconds(self, begin, end, fastest=300.0):
        """Seconds in motion that is no rapid: `fastest` inches a minute."""
        sum_ = 0.0
        for (a, p), (b, q) in zip(self.places, self.places[1:]):
            if begin <= a and b <= end:
                speed = math.dist(p, q) / (b - a) * 60
                if 0.5 < speed <= fastest:
                    sum_ += b - a
        return sum_
