#!/usr/bin/env python3
"""obrys check --at MOVE writes the workpiece as the program had left it, had it ended with that move.

usage: at_move_test.py <obrys>
"""
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

OBRYS = None
JOB = """program = "{}"
control = "linuxcnc"
machine = "mill-generic"
[[tool]]
number = 1
kind = "end-mill"
diameter = 8.0
length = 60.0
[[tool]]
number = 2
kind = "ball"
diameter = 6.0
length = 60.0
[stock]
box = {{ min = [0.0, 0.0, -15.0], max = [40.0, 30.0, 0.0] }}
[check]
scope = "collisions"
tolerance = 0.05
"""
HEAD = ["G21 G90 G17 G40 G80 G94", "F800", "T1 M6", "G43 H1", "M3 S3000", "G54 G0 X-10 Y5 Z5"]


def moves(count):
    """Lines with one move each."""
    chance = random.Random(5)
    lines = ["G0 Z-3"]
    for _ in range(count):
        lines.append(f"G1 X{chance.uniform(-5, 45):.3f} Y{chance.uniform(-5, 35):.3f} Z{chance.uniform(-9, -2):.3f}")
    return lines


class AtMove(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def check(self, lines, *options):
        (self.at / "p.ngc").write_text("\n".join(HEAD + lines + ["M2"]) + "\n")
        (self.at / "p.toml").write_text(JOB.format("p.ngc"))
        return subprocess.run([OBRYS, "check", self.at / "p.toml", "--force", *options], capture_output=True, text=True)

    def surface(self, lines, *options):
        file = self.at / "s.stl"
        file.unlink(missing_ok=True)
        self.check(lines, "--stl", file, *options)
        return file.read_bytes()

    def test_surface_is_that_of_the_shorter_program(self):
        """Move 0 is the rapid of HEAD, 1 the one down, 2 the first feed; one tool changed on the way changes nothing."""
        lines = moves(14)
        lines[8:8] = ["T2 M6", "G43 H2"]
        for made in (2, 5, 7, 9, 14):
            kept = made if made <= 7 else made + 2
            with self.subTest(made=made):
                self.assertEqual(self.surface(lines, "--at", str(made)), self.surface(lines[:kept]))

    def test_before_the_first_cut_it_is_the_stock(self):
        self.assertEqual(self.surface(moves(3), "--at", "0"), self.surface([]))

    def test_what_cannot_be_is_refused(self):
        beyond = self.check(moves(3), "--stl", self.at / "s.stl", "--at", "5")
        self.assertEqual(beyond.returncode, 2)
        self.assertIn("the program makes 5 moves, numbered from 0", beyond.stderr)
        self.assertFalse((self.at / "s.stl").exists())
        for wrong in ("", "1.5", "x", "999999999999999999999"):
            with self.subTest(wrong=wrong):
                said = self.check(moves(3), "--stl", self.at / "s.stl", "--at", wrong)
                self.assertEqual(said.returncode, 2)
                self.assertIn("must be the number of a move", said.stderr)
        alone = self.check(moves(3), "--at", "2")
        self.assertEqual(alone.returncode, 2)
        self.assertIn("--stl", alone.stderr)


if __name__ == "__main__":
    OBRYS = sys.argv.pop(1)
    unittest.main()
