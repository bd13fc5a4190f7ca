#!/usr/bin/env python3
"""Every job of examples/ as it comes with the sources, at default settings: its verdict is the one stated here.

usage: examples_test.py OBRYS EXAMPLES
"""
import pathlib
import subprocess
import sys

# Exit code and how the first line of the report goes on behind the program's name.
EXPECTED = {
    "fillet/fillet.job.toml": (0, "clean, simulated to 0.005 mm: nothing found"),
    "groove/groove.job.toml": (0, "clean: nothing found"),
    "groove/groove_wrong.job.toml": (1, "10 findings"),
    "plate/plate.job.toml": (0, "clean within the scope \"collisions\""),
    "profile/profile.job.toml": (0, "clean within the scope \"collisions\""),
}


def main():
    obrys, examples = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    jobs = {str(p.relative_to(examples)) for p in examples.glob("*/*.job.toml")}
    faults = [f"{name}: not in the table of this test, or not there" for name in jobs ^ set(EXPECTED)]
    for name in sorted(jobs & set(EXPECTED)):
        code, begins = EXPECTED[name]
        done = subprocess.run([obrys, "check", name], cwd=examples, capture_output=True, text=True, check=False)
        first = done.stdout.split("\n", 1)[0]
        if done.returncode != code or f": {begins}" not in first:
            faults.append(f"{name}: exit {done.returncode}, {first}\n{done.stderr}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
