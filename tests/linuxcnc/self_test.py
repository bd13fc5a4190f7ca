#!/usr/bin/env python3
"""What the LinuxCNC comparisons count on: end points from calls, places of errors, views of the output."""
import math
import unittest

import canon
import cases
import endpoint
import runner

FRAME = "   {} N..... {}\n"


def printed(*calls):
    return "".join(FRAME.format(n, c) for n, c in enumerate(calls, 1))


class EndPoint(unittest.TestCase):
    def near(self, calls, wanted):
        got = endpoint.end_point(printed(*calls))
        self.assertTrue(endpoint.close(got, wanted, 1e-9), f"{got} {wanted}")

    def test_straight_and_arc(self):
        self.near(["STRAIGHT_TRAVERSE(1.0000, 2.0000, -3.0000, 4.0000, 0.0000, 0.0000)"], [1, 2, -3, 4, 0, 0])
        self.near(["SELECT_PLANE(CANON_PLANE_XZ)", "ARC_FEED(5.0000, 6.0000, 0.0000, 0.0000, -1, 7.0000, 0.0000, 8.0000, 9.0000)"],
                  [6, 7, 5, 0, 8, 9])

    def test_inches_and_offsets(self):
        self.near(["USE_LENGTH_UNITS(CANON_UNITS_INCHES)", "SET_G5X_OFFSET(2, 1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)",
                   "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)", "USE_LENGTH_UNITS(CANON_UNITS_MM)"],
                  [50.8, 0, 0, 0, 0, 0])

    def test_an_offset_does_not_move(self):
        self.near(["STRAIGHT_FEED(1.0000, 2.0000, 0.0000, 0.0000, 0.0000, 0.0000)", "SET_XY_ROTATION(30.0000)",
                   "SET_G92_OFFSET(-5.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)",
                   "USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 12.9794, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)"],
                  [1, 2, 0, 0, 0, 0])

    def test_rotation_turns_what_follows(self):
        self.near(["SET_G5X_OFFSET(1, 10.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)", "SET_XY_ROTATION(30.0000)",
                   "STRAIGHT_FEED(2.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)"], [10 + math.sqrt(3), 1, 0, 0, 0, 0])

    def test_difference_is_seen(self):
        self.assertFalse(endpoint.close([0, 0, 0], [0, 0.0002, 0], 1e-4))


class Texts(unittest.TestCase):
    def test_first_error(self):
        text = "dir/a.ngc:3:4: warning: w\n  x\ndir/a.ngc:7:1: error: bad [arc-radius]\n  G2 X1\n  ^~\n"
        self.assertEqual(endpoint.first_error(text), "a.ngc:7: bad [arc-radius]")
        self.assertEqual(endpoint.error_line(text), "  G2 X1")

    def test_views(self):
        text = '    7 N10    MESSAGE("a  b")\n print 1\n'
        self.assertEqual(canon.viewed(text, cases.same("x", "y", "plain")), ['N10    MESSAGE("a  b")', " print 1"])
        self.assertEqual(canon.viewed(text, cases.same("x", "y")), [' N10 MESSAGE("a b")', " 1"])

    def test_refusal(self):
        run = runner.Run(1, "", "executing\nBad character 'u' used\nG0 U1\n")
        self.assertEqual(run.refused, ("Bad character 'u' used", "G0 U1"))


if __name__ == "__main__":
    unittest.main()
