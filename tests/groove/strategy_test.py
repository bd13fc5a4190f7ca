#!/usr/bin/env python3
"""The shipped grooving subprogram leaves exactly the allowance, over many parameter sets; its guards stop bad ones.

usage: strategy_test.py <examples/groove>
"""
import difflib
import pathlib
import random
import re
import sys
import unittest

import shop_floor as floor

FOLDER = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else "examples/groove")


def cut(settings, name="GROOVE_MAIN"):
    """Runs the program: deepest gouge, highest rest, rapids in stock, least clearance, moves, parameters."""
    moves, r = floor.run(FOLDER, name, settings)
    surface, finished, rough = floor.contours(r)
    low, high = rough[0][0] - r[9] - 5.0317, finished[3][0] + r[9] + 5.0171
    want = floor.with_surface(rough, surface, low, high)
    stock = floor.with_surface([], surface, low, high)
    centres, heights, crashes, clearance = floor.machine(moves, r[9], stock, low, high)
    differences = [height - want.at(z) for z, height in zip(centres, heights)]
    return -min(differences), max(differences), crashes, clearance, moves, r


class Strategy(unittest.TestCase):
    def assert_clean(self, settings):
        gouge, rest, crashes, clearance, moves, r = cut(settings)
        self.assertLess(gouge, 1e-6, settings)
        self.assertLess(rest, 1e-6, settings)
        self.assertEqual(crashes, [], settings)
        self.assertGreaterEqual(clearance, r[30] - 1e-9, settings)
        self.assertEqual(min(x for _, x, _, _ in moves), r[0] - r[3] + r[7], settings)
        return moves

    def test_as_shipped(self):
        self.assert_clean({})

    def test_corner_cases(self):
        for settings in ({"R2": 0}, {"R6": 0}, {"R5": 0}, {"R2": 0, "R5": 0, "R6": 0}, {"R7": 0, "R8": 0},
                         {"R2": 0, "R3": 0.7, "R11": 5}, {"R2": 0, "R3": 1.2, "R4": 4, "R11": 10, "R5": 45, "R6": 45},
                         {"R9": 28.9}, {"R9": 28.9, "R10": 1}, {"R10": 1}, {"R10": 0.05, "R11": 9}, {"R11": 100},
                         {"R2": 0.001}, {"R2": 60, "R3": 90, "R4": 6, "R5": 10}, {"R3": 150, "R11": 7}, {"R30": 0.1},
                         {"R2": 0, "R5": 80, "R6": 80, "R3": 3}, {"R2": 5, "R6": 80, "R3": 10}, {"R3": 13.2}):
            with self.subTest(settings):
                self.assert_clean(settings)

    def test_random_sets(self):
        seed = random.SystemRandom().randrange(2**32)
        rng, refused = random.Random(seed), 0
        for _ in range(120):
            settings = {"R0": rng.uniform(20, 300), "R1": rng.uniform(-50, 300), "R2": rng.choice([0, rng.uniform(0, 40)]),
                        "R3": rng.uniform(0.5, 20), "R4": rng.uniform(2, 40), "R5": rng.choice([0, rng.uniform(0, 45)]),
                        "R6": rng.choice([0, rng.uniform(0, 45)]), "R7": rng.choice([0, rng.uniform(0, 0.4)]),
                        "R8": rng.choice([0, rng.uniform(0, 0.6)]), "R9": rng.uniform(0.5, 8),
                        "R10": rng.uniform(0.1, 1), "R11": rng.uniform(0.5, 6), "R30": rng.uniform(0.2, 3)}
            with self.subTest(settings, seed=seed):
                try:
                    self.assert_clean(settings)
                except floor.Alarm as alarm:
                    self.assertIn(alarm.args[0], (65006, 65007))
                    refused += 1
        self.assertLess(refused, 100)

    def test_guards(self):
        for settings, number in (({"R9": 0}, 65001), ({"R9": -3}, 65001), ({"R10": 0}, 65002), ({"R10": 1.01}, 65002),
                                 ({"R11": 0}, 65003), ({"R30": 0}, 65003), ({"R3": 0}, 65004), ({"R3": -1}, 65004),
                                 ({"R3": 0.4}, 65004), ({"R8": -0.1}, 65004), ({"R2": -1}, 65005), ({"R5": 90}, 65005),
                                 ({"R6": 90}, 65005), ({"R2": 80, "R5": 10}, 65005), ({"R3": 5}, 65006), ({"R9": 30}, 65007)):
            with self.subTest(settings):
                with self.assertRaises(floor.Alarm) as raised:
                    cut(settings)
                self.assertEqual(raised.exception.args[0], number)
                self.assertRegex(raised.exception.args[1], "^GROOVE: .*R" + next(iter(settings))[1:] if number < 65006 else "^GROOVE: ")

    def test_wrong_variant_gouges(self):
        gouge, _, crashes, _, _, _ = cut({}, "GROOVE_WRONG")
        self.assertGreater(gouge, 10)
        self.assertTrue(crashes)

    def test_wrong_variant_differs_by_the_width_only(self):
        right, wrong = ((FOLDER / name).read_text().splitlines() for name in ("GROOVE.SPF", "GROOVE_BAD.SPF"))
        changed = [line[2:] for line in difflib.ndiff(right, wrong) if line[0] in "+-" and not line[2:].startswith(";")]
        self.assertEqual(changed, ["PROC GROOVE SAVE DISPLOF", "PROC GROOVE_BAD SAVE DISPLOF",
                                   "  N450 ZTO=ZBR+(XNEW-XBOT)*TFIRST-R9", "  N450 ZTO=ZBR+(XNEW-XBOT)*TFIRST"])

    def test_job_holds_the_contours(self):
        _, r = floor.run(FOLDER)
        _, finished, rough = floor.contours(r)
        for job in ("groove.job.toml", "groove_wrong.job.toml"):
            text = (FOLDER / job).read_text()
            for section, corners in (("part", finished), ("allowance", rough)):
                block = re.search(rf"^\[{section}\]\n(.*?)(?=^\[|\Z)", text, re.S | re.M).group(1)
                points = [(float(z), float(x)) for z, x in re.findall(r"z = ([\d.]+), x = ([\d.]+)", block)][1:-1]
                self.assertEqual(len(points), 4)
                for (z, x), (z_job, x_job) in zip(corners, points):
                    self.assertAlmostEqual(z, z_job, delta=1e-9)
                    self.assertAlmostEqual(x, x_job, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
