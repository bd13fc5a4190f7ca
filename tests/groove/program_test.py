#!/usr/bin/env python3
"""obrys against the oracle on the shipped example: the same moves, and the verdicts that follow from them.

usage: program_test.py <obrys> <examples/groove>
"""
import csv
import io
import json
import pathlib
import subprocess
import sys
import unittest

import shop_floor as floor

OBRYS, FOLDER = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
SETTINGS = ({}, {"R2": 0}, {"R6": 0}, {"R5": 0, "R3": 60}, {"R2": 0, "R5": 0, "R6": 0}, {"R9": 28, "R10": 1}, {"R11": 100},
            {"R2": 0, "R3": 0.7, "R11": 5})


def obrys(command, job, settings, *options):
    sets = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
    done = subprocess.run([OBRYS, command, str(FOLDER / job), *sets, *options], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


class Program(unittest.TestCase):
    def assert_same_moves(self, job, name, settings):
        _, out = obrys("run", job, settings, "--format", "csv")
        rows = [row for row in csv.DictReader(io.StringIO(out)) if row["kind"] in ("rapid", "linear")]
        moves, _ = floor.run(FOLDER, name, settings)
        self.assertEqual(len(rows), len(moves))
        for row, (rapid, x, z, program) in zip(rows, moves):
            self.assertEqual(row["kind"] == "rapid", rapid)
            self.assertAlmostEqual(float(row["x"]), x, delta=1e-6)
            if z is not None:
                self.assertAlmostEqual(float(row["z"]), z, delta=1e-6)
            self.assertEqual(pathlib.Path(row["file"]).stem, program)

    def test_moves(self):
        for settings in SETTINGS:
            with self.subTest(settings):
                self.assert_same_moves("groove.job.toml", "GROOVE_MAIN", settings)
        self.assert_same_moves("groove_wrong.job.toml", "GROOVE_WRONG", {})

    def test_shipped_job_is_clean(self):
        code, out = obrys("check", "groove.job.toml", {}, "--format", "json")
        result = json.loads(out)
        self.assertEqual((code, result["verdict"], result["findings"], result["unchecked"]), (0, "clean", [], []))

    def test_wrong_variant_gouges_as_deep_as_the_oracle_says(self):
        code, out = obrys("check", "groove_wrong.job.toml", {}, "--format", "json")
        result = json.loads(out)
        self.assertEqual((code, result["verdict"]), (1, "findings"))
        depths = [finding["depth_x_mm"] for finding in result["findings"] if finding["code"] == "gouge"]
        moves, r = floor.run(FOLDER, "GROOVE_WRONG")
        surface, finished, _ = floor.contours(r)
        low, high = finished[0][0] - 2 * r[9], finished[3][0] + 2 * r[9]
        part, stock = (floor.with_surface(c, surface, low, high) for c in (finished, []))
        centres, heights, _, _ = floor.machine(moves, r[9], stock, low, high, cell=0.01)
        deepest = max(part.at(z) - height for z, height in zip(centres, heights))
        # One finding may be a single layer's bite, so the deepest is at most the whole depth and more than a layer's.
        self.assertLessEqual(max(depths), deepest + 0.2)
        self.assertGreaterEqual(max(depths), r[11])

    def test_guards_are_alarms(self):
        for settings in ({"R9": 0}, {"R10": 2}, {"R11": 0}, {"R3": 0}, {"R2": -1}, {"R3": 5}, {"R9": 30}):
            with self.subTest(settings):
                code, out = obrys("check", "groove.job.toml", settings, "--format", "json")
                self.assertEqual(code, 1)
                self.assertIn("program-alarm", {finding["code"] for finding in json.loads(out)["findings"]})


if __name__ == "__main__":
    unittest.main()
