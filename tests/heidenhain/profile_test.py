#!/usr/bin/env python3
"""examples/profile against geometry computed here: pass counts, tangency, scallops, end values, joints, messages.

usage: profile_test.py <obrys> <examples/profile>

Nothing of the programs' formulas is used but what their heads promise: the meridian (distance from the contour, height
above the surface), the tip's circle with its centre at (Q3 + Q9, Q1 + Q9), and the number of steps n.
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

OBRYS, FOLDER = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
TOLERANCE = 1e-9
COMMON = {"Q0": 1, "Q1": 0, "Q2": 0, "Q5": 0, "Q6": 1, "Q7": 50, "Q8": 0, "Q9": 2, "Q10": 0.5, "Q11": 200, "Q12": 800,
          "Q15": 1}
CONVEX = [{"Q8": 8, "Q3": 90, "Q4": 0}, {"Q8": 8, "Q3": 20, "Q4": 0}, {"Q8": 0.5, "Q3": 60, "Q4": 10},
          {"Q8": 30, "Q3": 89, "Q4": 30, "Q1": 1.5, "Q2": -3}]
CONCAVE = [{"Q8": -9, "Q3": 0, "Q4": 90, "Q9": 4}, {"Q8": -10, "Q3": 0, "Q4": 45}, {"Q8": -5, "Q3": 10, "Q4": 80, "Q9": 4.9},
           {"Q8": -40, "Q3": 5, "Q4": 25, "Q1": -2, "Q2": -7}]
OVERHANG = [{"Q8": 6, "Q3": 30, "Q4": -60}, {"Q8": 6, "Q3": -10, "Q4": -45}, {"Q8": -12, "Q3": -70, "Q4": 40},
            {"Q8": -8, "Q3": -60, "Q4": -20, "Q6": 1}]
BEVELS = [{"Q3": 30, "Q4": -10}, {"Q3": 0, "Q4": -4}, {"Q3": 75, "Q4": -3}, {"Q3": -20, "Q4": -12, "Q1": 3, "Q2": -1},
          {"Q3": -60, "Q4": -9, "Q9": 0.5}]


def number(value):
    text = f"{abs(value):.12f}".rstrip("0").rstrip(".")
    return ("- " if value < 0 else "") + text


def assignments(values):
    return [f"{name} = {number(value)}" for name, value in values.items()]


class Shop:
    """A folder with the two subprograms and main programs made for the case."""

    def __init__(self):
        self.kept = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.kept.name)
        for name in ("RADIUS.H", "BEVEL.H", "TOOL.T"):
            (self.folder / name).write_bytes((FOLDER / name).read_bytes())

    def obrys(self, lines, *options):
        main = ["BEGIN PGM MAIN MM", "TOOL CALL 1 Z S1000", "L Z+100 R0 FMAX M3", "CYCL DEF 14.0 CONTOUR", "CYCL DEF 14.1 CONTOUR LABEL 1",
                *lines, "L Z+100 R0 FMAX M30", "LBL 1", "L X+0 Y+0 RR", "L X+100", "LBL 0", "END PGM MAIN MM"]
        (self.folder / "MAIN.H").write_text("\n".join(f"{i} {line}" for i, line in enumerate(main)) + "\n", encoding="ascii")
        (self.folder / "main.job.toml").write_text('program = "MAIN.H"\ntool_files = ["TOOL.T"]\n', encoding="ascii")
        done = subprocess.run([OBRYS, "run", str(self.folder / "main.job.toml"), *options], capture_output=True, text=True, check=False)
        return done.stdout

    def passes(self, lines):
        """The calls of cycle 25 with their parameters; None in the list separates the sections (markers Q5)."""
        return [{q: float(v) for q, v in re.findall(r'"(Q\d+)" (\S+)', line)}
                for line in self.obrys(lines).splitlines() if line.startswith('cycle contour-train "CYCL DEF 25"')]

    def end(self, lines):
        return dict((name, float(value)) for name, value in
                    (line.split("=") for line in self.obrys(lines, "--parameters").splitlines()) if value != "?")

    def message(self, lines):
        found = re.search(r'^message "(.*)"', self.obrys(lines), re.M)
        return found and found.group(1)


SHOP = Shop()


class Section:
    """What a section must be, from its parameters alone."""

    def __init__(self, program, case):
        self.program, self.q = program, {**COMMON, **case}
        q = self.q
        self.start = (q["Q1"], q["Q2"])
        self.first = math.radians(q["Q3"])
        self.tip = q["Q9"]
        if program == "RADIUS":
            self.last = self.last_angle()
            self.length = abs(q["Q8"] + 7 / 8 * self.tip) * abs(self.last - self.first)
        else:
            self.length = self.slope()
        self.steps = {int(1 + max(0, self.length / q["Q10"] + e)) for e in (-1e-9, 1e-9)}

    def lines(self):
        return [*assignments(self.q), f"CALL PGM {self.program}"]

    def normal(self, angle):
        return math.cos(angle), math.sin(angle)

    def centre(self):
        """Of the arc: from the start point against the direction that points away from the part."""
        n = self.normal(self.first)
        return self.start[0] - self.q["Q8"] * n[0], self.start[1] - self.q["Q8"] * n[1]

    def programmed_end(self):
        if self.program == "RADIUS":
            c, n = self.centre(), self.normal(math.radians(self.q["Q4"]))
            return c[0] + self.q["Q8"] * n[0], c[1] + self.q["Q8"] * n[1]
        return self.start[0] - self.q["Q4"] * math.tan(self.first), self.start[1] + self.q["Q4"]

    def bottom(self, angle):
        """Height of the tip's lowest point when it touches the arc at `angle`."""
        return self.centre()[1] + (self.q["Q8"] + self.tip) * math.sin(angle) - self.tip

    def last_angle(self):
        goal = math.radians(self.q["Q4"])
        if self.q["Q6"] > 0:
            return goal
        # The tip sinks steadily from the first angle to the last: where is it as deep as the end point?
        depth = self.programmed_end()[1]
        high, low = self.first, goal
        for _ in range(200):
            middle = (high + low) / 2
            high, low = (middle, low) if self.bottom(middle) > depth else (high, middle)
        return (high + low) / 2

    def slope(self):
        fall = -self.q["Q4"] - (self.tip * (1 - math.sin(self.first)) if self.q["Q6"] == 0 else 0)
        return fall / math.cos(self.first)

    def end(self):
        """Point of contact and angle (degrees) of the last pass."""
        if self.program == "BEVEL":
            n = self.normal(self.first)
            return self.start[0] + self.length * n[1], self.start[1] - self.length * n[0], math.degrees(self.first)
        c, n = self.centre(), self.normal(self.last)
        return c[0] + self.q["Q8"] * n[0], c[1] + self.q["Q8"] * n[1], math.degrees(self.last)

    def off(self, centre):
        """How far the tip's circle lies off the surface: 0 touches, negative cuts in; and where it touches."""
        if self.program == "BEVEL":
            n = self.normal(self.first)
            d = centre[0] - self.start[0], centre[1] - self.start[1]
            return d[0] * n[0] + d[1] * n[1] - self.tip, d[0] * n[1] - d[1] * n[0]
        c, r = self.centre(), self.q["Q8"]
        d = centre[0] - c[0], centre[1] - c[1]
        distance = math.hypot(*d)
        if r > 0:
            return distance - (r + self.tip), math.atan2(d[1], d[0])
        return (-r - self.tip) - distance, math.atan2(-d[1], -d[0])

    def scallop(self, a, b):
        """Height of what two neighbouring passes leave between them."""
        half = math.dist(a, b) / 2
        reach = math.sqrt(max(0, self.tip ** 2 - half ** 2))
        if self.program == "BEVEL":
            return self.tip - reach
        r = self.q["Q8"]
        apart = math.sqrt((r + self.tip) ** 2 - half ** 2)
        return (apart - reach) - r if r > 0 else -r - (apart + reach)

    def bound(self):
        """Of the scallop, from the step Q10 alone: README."""
        step = self.q["Q10"]
        if self.program == "RADIUS":
            step *= abs(self.q["Q8"] + self.tip) / abs(self.q["Q8"] + 7 / 8 * self.tip)
            if self.q["Q8"] < 0:
                step *= math.sqrt(self.q["Q8"] / (self.q["Q8"] + self.tip))
        return self.tip - math.sqrt(max(0, self.tip ** 2 - step ** 2 / 4))


class Profile(unittest.TestCase):
    def assert_passes(self, section, passes):
        q, last = section.q, 0 if section.q["Q6"] == 2 else 1
        self.assertIn(len(passes) - last, section.steps)
        n = len(passes) - last
        centres = [(p["Q3"] + section.tip, p["Q1"] + section.tip) for p in passes]
        for k, centre in enumerate(centres):
            off, where = section.off(centre)
            self.assertLess(abs(off), TOLERANCE, (k, q))
            if section.program == "BEVEL":
                self.assertAlmostEqual(where, section.length * k / n, delta=TOLERANCE)
            else:
                self.assertAlmostEqual(where, section.first + (section.last - section.first) * k / n, delta=1e-7)
            if section.q["Q6"] == 0:
                self.assertGreaterEqual(centre[1] - section.tip, section.programmed_end()[1] - TOLERANCE)
        for a, b in zip(centres, centres[1:]):
            self.assertLessEqual(section.scallop(a, b), section.bound() + TOLERANCE)
        if section.q["Q6"] == 0:
            self.assertAlmostEqual(passes[-1]["Q1"], section.programmed_end()[1], delta=TOLERANCE)

    def assert_end(self, section, end):
        x, z, angle = section.end()
        # With Q6 = 0 both sides search the angle from a height, which hardly changes where the arc is level.
        for got, expected, loose in ((end["Q1"], x, 1e-6), (end["Q2"], z, 1e-6), (end["Q3"], angle, 1e-5)):
            self.assertAlmostEqual(got, expected, delta=loose if section.q["Q6"] == 0 else TOLERANCE)
        for name in ("Q0", "Q4", "Q5", "Q6", "Q7", "Q8", "Q9", "Q10", "Q11", "Q12", "Q15"):
            self.assertEqual(end[name], section.q[name])

    def sections(self):
        for case in CONVEX + CONCAVE + OVERHANG:
            for choice in (0, 1, 2):
                yield "RADIUS", {**case, "Q6": choice}
        for case in BEVELS:
            for choice in (0, 1, 2):
                yield "BEVEL", {**case, "Q6": choice}

    @staticmethod
    def possible(program, case):
        """False where the tip reaches below the end point wherever it touches (Q6 = 0)."""
        if case["Q6"] > 0:
            return True
        if program == "BEVEL":
            return Section(program, case).slope() >= 0
        s = Section(program, {**case, "Q6": 1})
        return s.bottom(s.first) >= s.programmed_end()[1]

    def test_every_section_touches_and_ends_where_it_should(self):
        ran = 0
        for program, case in self.sections():
            with self.subTest(program, **case):
                if not self.possible(program, case):
                    s = Section(program, {**case, "Q6": 1})
                    message = SHOP.message([*assignments({**s.q, "Q6": 0}), f"CALL PGM {program}"])
                    self.assertRegex(message or "", "tip .* is too large")
                    continue
                section = Section(program, case)
                self.assert_passes(section, SHOP.passes(section.lines()))
                self.assert_end(section, SHOP.end(section.lines()))
                ran += 1
        self.assertGreaterEqual(ran, 40)

    def test_every_step_from_0_01_to_2(self):
        for program, case in (("RADIUS", {**CONVEX[1]}), ("RADIUS", {**CONCAVE[0]}), ("RADIUS", {**OVERHANG[2]}),
                              ("BEVEL", {**BEVELS[0]}), ("BEVEL", {**BEVELS[3]})):
            for choice in (0, 1, 2):
                if not self.possible(program, {**case, "Q6": choice}):
                    continue
                self.assert_steps(program, {**case, "Q6": choice})

    def assert_steps(self, program, case):
        """All steps in one main program; the clearance height Q7 marks which of them a pass belongs to."""
        sections, lines = {}, []
        for i in range(1, 201):
            section = Section(program, {**case, "Q10": i / 100, "Q7": 100 + i})
            sections[100 + i] = section
            lines += section.lines()
        found = {mark: [] for mark in sections}
        for p in SHOP.passes(lines):
            found[p["Q7"]].append(p)
        for mark, section in sections.items():
            with self.subTest(program, **section.q):
                self.assert_passes(section, found[mark])

    def test_compute_only_moves_nothing(self):
        for program, case in (("RADIUS", CONVEX[0]), ("BEVEL", BEVELS[0])):
            section = Section(program, {**case, "Q0": 0})
            self.assertEqual(SHOP.passes(section.lines()), [])
            self.assertNotIn("rapid ? ? 50", SHOP.obrys(section.lines()))
            self.assert_end(section, SHOP.end(section.lines()))

    def test_to_and_fro(self):
        for given, expected in ((1, {1}), (-1, {-1}), (0, {1, -1})):
            passes = SHOP.passes(Section("BEVEL", {**BEVELS[0], "Q15": given}).lines())
            self.assertEqual({p["Q15"] for p in passes}, expected)
            if given == 0:
                self.assertTrue(all(a["Q15"] == -b["Q15"] for a, b in zip(passes, passes[1:])))

    def test_a_tip_that_fills_the_arc_mills_it_in_one_pass(self):
        for choice, count in ((0, 1), (1, 1), (2, 0)):
            lines = [*assignments({**COMMON, "Q8": -4, "Q9": 4, "Q3": 0, "Q4": 90, "Q6": choice}), "CALL PGM RADIUS"]
            passes = SHOP.passes(lines)
            self.assertEqual(len(passes), count)
            for p in passes:
                self.assertAlmostEqual(math.hypot(p["Q3"] + 4 - 4, p["Q1"] + 4), 0, delta=TOLERANCE)
            end = SHOP.end(lines)
            self.assertAlmostEqual(end["Q1"], 4, delta=TOLERANCE)
            self.assertAlmostEqual(end["Q2"], -4, delta=TOLERANCE)

    def test_wrong_input_stops_with_a_message(self):
        arc, slope = {**CONVEX[0]}, {**BEVELS[0]}
        for program, case, words in (
                ("RADIUS", {**arc, "Q10": 0}, "Q10 must be positive"), ("RADIUS", {**arc, "Q10": -1}, "Q10 must be positive"),
                ("RADIUS", {**arc, "Q3": 91}, "between -90 and"), ("RADIUS", {**arc, "Q4": -90.5}, "between -90 and"),
                ("RADIUS", {**arc, "Q3": 0, "Q4": 90}, "convex arc needs"), ("RADIUS", {**arc, "Q8": -8}, "concave arc needs"),
                ("RADIUS", {**arc, "Q8": 0}, "must not be zero"), ("RADIUS", {**arc, "Q6": 3}, "0, 1 or 2"),
                ("RADIUS", {"Q8": -3, "Q3": 0, "Q4": 90, "Q9": 4}, "larger than the concave radius"),
                ("RADIUS", {"Q8": 3, "Q3": 10, "Q4": 0, "Q6": 0, "Q9": 4}, "too large"),
                ("BEVEL", {**slope, "Q10": 0}, "Q10 must be positive"), ("BEVEL", {**slope, "Q3": 90}, "inside -90"),
                ("BEVEL", {**slope, "Q4": 0}, "must be negative"), ("BEVEL", {**slope, "Q6": -1}, "0, 1 or 2"),
                ("BEVEL", {**slope, "Q3": 0, "Q4": -1, "Q6": 0}, "too large")):
            with self.subTest(program, **case):
                lines = [*assignments({**COMMON, **case}), f"CALL PGM {program}"]
                self.assertIn(words, SHOP.message(lines) or "")
                self.assertEqual(SHOP.passes(lines), [])

    def test_shipped_profile_is_continuous_in_point_and_tangent(self):
        main = (FOLDER / "PROFILE.H").read_text(encoding="ascii")
        values, sections, at = dict(COMMON), [], None
        for line in main.splitlines():
            line = re.sub(r"^\d+ ", "", line).split(";")[0].strip()
            if found := re.fullmatch(r"(Q\d+) = (- )?([\d.]+)", line):
                values[found.group(1)] = float(found.group(3)) * (-1 if found.group(2) else 1)
            elif found := re.fullmatch(r"CALL PGM (\w+)", line):
                section = Section(found.group(1), {**values, **(at or {})})
                x, z, angle = section.end()
                at = {"Q1": x, "Q2": z, "Q3": angle}
                sections.append(section)
        self.assertEqual([s.program for s in sections], ["BEVEL", "RADIUS", "RADIUS", "BEVEL"])
        done = subprocess.run([OBRYS, "run", str(FOLDER / "profile.job.toml")], capture_output=True, text=True, check=False)
        passes = [{q: float(v) for q, v in re.findall(r'"(Q\d+)" (\S+)', line)}
                  for line in done.stdout.splitlines() if line.startswith('cycle contour-train "CYCL DEF 25"')]
        self.assertNotIn("message", done.stdout)
        for section in sections:
            n = min(section.steps)
            count = n if section.q["Q6"] == 2 else n + 1
            self.assert_passes(section, passes[:count])
            passes = passes[count:]
        self.assertEqual(passes, [])
        drawn = subprocess.run([sys.executable, pathlib.Path(__file__).with_name("draw_profile.py"), OBRYS, FOLDER],
                               capture_output=True, text=True, check=True)
        self.assertEqual(drawn.stdout, (FOLDER / "profile.svg").read_text(encoding="utf-8"))
        # Where one section ends the next one begins, its first pass being the last one left out.
        for a, b in zip(sections, sections[1:]):
            self.assertAlmostEqual(math.dist(a.programmed_end(), b.start), 0, delta=TOLERANCE)
            self.assertAlmostEqual(math.degrees(a.last) if a.program == "RADIUS" else a.q["Q3"], b.q["Q3"], delta=TOLERANCE)


if __name__ == "__main__":
    unittest.main()
