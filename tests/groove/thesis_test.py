#!/usr/bin/env python3
"""The 2015 thesis' grooving program against the independently computed moves, events and path lengths of ../shared.

usage: thesis_test.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

CASES = [("kod1", "groove", {}), ("zp_R3_150", "groove", {"R3": 150}), ("both_R3_80", "groove", {"R3": 80}),
         ("kod1__fixed2", "groove_corrected", {}), ("zp_R3_150__fixed2", "groove_corrected", {"R3": 150}),
         ("both_R3_80__fixed2", "groove_corrected", {"R3": 80})]


def profile(points):
    inner = ", ".join(f"{{z = {p['Z']:.9f}, x = {p['X']:.9f}}}" for p in points)
    return f"profile = [ {{z = 0.0, x = 106.0}}, {inner}, {{z = 300.0, x = 226.0}} ]"


def job_text(program, expected):
    p = expected["points_by_line_intersection"]
    return "\n".join([
        f'program = "{program}"', 'control = "sinumerik-840d"', 'machine = "lathe-generic"',
        "[defaults]", "diameter_programming = false",
        "[[tool]]", "number = 5", 'kind = "groove"', "width = 3.0", "corner_radius = 0.0", 'reference = "left"',
        "[stock]", "profile = [ {z = 0.0, x = 106.0}, {z = 300.0, x = 226.0} ]",
        "[part]", profile([p["C1"], p["BL"], p["BR"], p["P"]]),
        "[allowance]", profile([p["R"], p["S"], p["T"], p["U"]]),
        # The main program reads R0 before anything sets it; the expected moves are those of a control that holds 0 there.
        "[variables]", "R0 = 0", ""])


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


class Case:
    def __init__(self, obrys, shared, name, folder, settings, job):
        self.name, self.faults = name, []
        self.expected = json.loads((shared / "groove/expected" / f"{name}.json").read_text())
        with open(shared / "groove/expected" / f"{name}_moves.csv", newline="") as f:
            self.moves = list(csv.DictReader(f))
        program = (shared / folder / "HLAVNI.MPF").resolve()
        job.write_text(job_text(program.as_posix(), self.expected))
        sets = [w for k, v in settings.items() for w in ("--set", f"{k}={v}")]
        self.csv = run([obrys, "run", str(job), "--format", "csv", *sets])
        self.check = run([obrys, "check", str(job), "--format", "json", "--all", *sets])

    def expect(self, condition, text):
        if not condition:
            self.faults.append(f"{self.name}: {text}")

    def near(self, got, want, tolerance, what):
        self.expect(abs(got - want) <= tolerance, f"{what} is {got}, expected {want} within {tolerance}")

    def compare_moves(self):
        rows = list(csv.DictReader(self.csv[1].splitlines()))
        self.expect(len(rows) == len(self.moves), f"{len(rows)} moves, expected {len(self.moves)}")
        for want, got in zip(self.moves, rows):
            where = f"move {want['i']}"
            self.expect(got["kind"] == {"G0": "rapid", "G1": "linear"}[want["g"]], where + " kind")
            self.expect(pathlib.Path(got["file"]).stem == want["prog"] and got["line"] == want["line"], where + " line")
            self.expect(got["block"] == want["block"], where + " block number")
            for mine, theirs in (("x", "X"), ("z", "Z")):
                if want[theirs]:
                    self.near(float(got[mine]), float(want[theirs]), 1e-6, f"{where} {theirs}")
                else:
                    self.expect(got[mine] == "", f"{where} {theirs} is not known yet")

    def compare_findings(self):
        result = json.loads(self.check[1])
        events = self.expected["events"]
        self.expect(self.check[0] == (1 if events else 0), f"exit {self.check[0]}")
        self.expect(result["verdict"] == ("findings" if events else "clean"), f"verdict {result['verdict']}")
        self.near(result["stats"]["feed_length_mm"], self.expected["length_G1_mm"], 1e-5, "feed length")
        self.near(result["stats"]["rapid_length_mm"], self.expected["length_G0_mm"], 1e-5, "rapid length")
        by_code = {}
        for f in result["findings"]:
            for move in f["moves"]:
                by_code[(f["code"], move["move"])] = move
        lines = {(pathlib.Path(f["where"]["file"]).stem, f["where"]["line"]) for f in result["findings"] if f["code"] != "rest-material"}
        self.expect(lines == {(e["prog"], e["line"]) for e in events}, f"findings on {sorted(lines)}")
        for e in events:
            self.compare_event(e, by_code)

    def compare_event(self, e, by_code):
        for code, depth, area in (("gouge", "below_final_contour_mm", "final_area_mm2"), ("rapid-in-stock", "rapid_depth_mm", "rapid_area_mm2")):
            f = by_code.get((code, e["i"]))
            self.expect((f is not None) == (e[depth] > 0), f"{code} of move {e['i']}")
            if f is None:
                continue
            self.near(f["depth_x_mm"], e[depth], 0.1, f"{code} depth of move {e['i']}")
            # The oracle's cells are 0.01 mm wide: on either side of a cut it may be half a cell off.
            self.near(f["area_mm2"], e[area], max(0.01 * e[area], 0.005 * e[depth], 0.02), f"{code} area of move {e['i']}")


def compare_points(obrys, shared, job):
    """R, S, T, U of kod1 as the program computes them, at the end of a run that changes only R12 and R13."""
    expected = json.loads((shared / "groove/expected/kod1.json").read_text())
    _, out, _ = run([obrys, "run", str(job), "--parameters"])
    r = {k: float(v) for k, v in (line.split("=") for line in out.splitlines())}
    points = {"R": ("R23", "R24"), "S": ("R25", "R26"), "T": ("R14", "R15"), "U": ("R16", "R17")}
    faults = []
    for name, (x, z) in points.items():
        for key, axis in ((x, "X"), (z, "Z")):
            want = expected["points_program"][name][axis]
            if abs(r[key] - want) > 1e-9:
                faults.append(f"point {name} {axis}: {r[key]}, expected {want}")
    return faults


def main():
    obrys, shared = sys.argv[1], pathlib.Path(sys.argv[2]) / "programs"
    if not (shared / "groove/expected").is_dir():
        print("skipped: needs ../shared")
        return 77
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder) / "case.job.toml"
        for name, sub, settings in CASES:
            case = Case(obrys, shared, name, sub, settings, job)
            case.compare_moves()
            case.compare_findings()
            faults += case.faults
            if name == "kod1":
                faults += compare_points(obrys, shared, job)
            print(f"{name}: {len(case.moves)} moves, {len(case.expected['events'])} events, {len(case.faults)} faults")
    print("\n".join(faults[:40]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
