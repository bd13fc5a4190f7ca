#!/usr/bin/env python3
"""`obrys check` with bodies from STEP files: what it leaves of the plate example is the plate that Open CASCADE makes.

usage: job_test.py <obrys> <step_samples> <project>
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

OBRYS, SAMPLES, PROJECT = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
PLATE = PROJECT / "examples/plate"


class Job(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="obrys-step")
        self.folder = pathlib.Path(self.scratch.name)
        (self.folder / "PLATE.H").write_bytes((PLATE / "PLATE.H").read_bytes())

    def tearDown(self):
        self.scratch.cleanup()

    def step(self, shape, unit, name="part.step"):
        made = subprocess.run([SAMPLES, shape, unit], check=True, capture_output=True)
        (self.folder / name).write_bytes(made.stdout)

    def check(self, more, exit_code):
        # The shipped job is judged within a scope of its own; here the part counts.
        job = (PLATE / "plate.job.toml").read_text(encoding="utf-8").replace('scope = "collisions"', 'scope = "all"') + more
        (self.folder / "plate.job.toml").write_text(job, encoding="utf-8")
        done = subprocess.run([OBRYS, "check", "plate.job.toml", "--format", "json"], cwd=self.folder, capture_output=True,
                              text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, exit_code, done.stdout + done.stderr)
        return done.stderr if exit_code == 2 else json.loads(done.stdout)

    def test_the_plate_is_what_the_program_leaves(self):
        for unit, name in (("MM", "part.step"), ("INCH", "PART.STP")):
            self.step("plate", unit, name)
            result = self.check(f'[part]\nfile = "{name}"\n', 0)
            self.assertEqual(result["findings"], [])

    def test_a_part_that_stands_elsewhere_is_cut_into(self):
        self.step("plate", "MM")
        result = self.check('[part]\nfile = "part.step"\noffset = [0.0, 0.0, 0.5]\n', 1)
        self.assertIn("gouge", {f["code"] for f in result["findings"]})

    def test_a_stock_of_step(self):
        self.step("block", "MM")
        result = self.check('[stock]\nfile = "part.step"\n[part]\nfile = "part.step"\noffset = [0.0, 0.0, -30.0]\n', 1)
        self.assertIn("rest-material", {f["code"] for f in result["findings"]})

    def test_a_clamp_of_bodies_that_touch(self):
        self.step("touching", "MM", "clamp.step")
        result = self.check('[[clamp]]\nname = "from step"\nfile = "clamp.step"\noffset = [30.0, 0.0, -9.0]\n', 3)  # no part
        self.assertTrue(any("from step" in json.dumps(f) for f in result["findings"]), result["findings"])
        self.assertNotIn("mesh-not-closed", json.dumps(result))

    def test_a_part_of_bodies_that_touch_is_not_compared(self):
        self.step("touching", "MM")
        self.assertIn("mesh-not-closed", json.dumps(self.check('[part]\nfile = "part.step"\n', 3)))

    def test_surfaces_are_refused(self):
        self.step("shell", "MM")
        said = self.check('[part]\nfile = "part.step"\n', 2)
        self.assertIn("plate.job.toml:33:8: error: part.step: ", said)
        self.assertIn("[mesh-file]", said)
        self.assertIn("no solid", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
