#!/usr/bin/env python3
"""The article's RADIUS and UKOS programs (as printed, and *_OPR corrected) against the independently computed calls of
../shared: depth and allowance of every call of cycle 25, end values of the parameters, and what bad input is answered.

usage: radius_ukos_test.py OBRYS SHARED      exit 77 (skipped) where SHARED is missing
"""
import json
import pathlib
import subprocess
import sys
import tempfile

TOLERANCE = 1e-9
# How often the printed programs call the cycle can depend on the last bit of a sum: where the file lists comparisons of
# nearly equal numbers, it gives the count of exact comparison and that of one with a tolerance.
CYCLE = 'cycle contour-train "CYCL DEF 25" '


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    return done.returncode, done.stdout, done.stderr


def main_program(program, values):
    """A program that sets the parameters and calls `program`; its contour is an open one."""
    lines = ["BEGIN PGM HL MM", "TOOL CALL 1 Z S3000", "L Z+100 R0 FMAX M3", "CYCL DEF 14.0 OBRYS",
             "CYCL DEF 14.1 LBL OBRYSU 1"]
    lines += [f"Q{k[1:]} = {v}".replace("= -", "= - ") for k, v in values.items()]
    lines += [f"CALL PGM {program}", "L Z+100 R0 FMAX M30", "LBL 1", "L X+20 Y+20 RR", "L X+80", "L Y+80", "LBL 0",
              "END PGM HL MM"]
    return "".join(f"{i} {line}\n" for i, line in enumerate(lines))


def calls(stream):
    """What each call of the cycle was called with."""
    found = []
    for line in stream.splitlines():
        if line.startswith(CYCLE):
            words = line.split(" written ", 1)[1].split()
            found.append({k.strip('"'): float(v) for k, v in zip(words[::2], words[1::2]) if k.startswith('"')})
    return found


class Case:
    def __init__(self, obrys, folder, work, name, expected):
        self.name, self.want, self.faults = name, expected, []
        main = work / "HL.H"
        main.write_text(main_program(expected["pgm"], expected["input"]))
        command = [obrys, "run", str(main), "--search", str(folder)]
        self.code, out, self.messages = run(command)
        self.calls = calls(out)
        end = run(command + ["--parameters"])[1]
        self.end = {k: float(v) for k, v in (line.split("=") for line in end.splitlines() if "=" in line)}

    def near(self, got, want, what):
        if got is None or not abs(got - want) <= TOLERANCE:
            self.faults.append(f"{self.name}: {what} is {got}, expected {want}")

    def compare(self):
        counts = {self.want["n_cycl_call_if_EQU_tolerance_1e_9"]}
        if self.want["near_equal"]:
            counts.add(self.want["n_cycl_call"])
        if len(self.calls) not in counts:
            self.faults.append(f"{self.name}: {len(self.calls)} calls, expected {sorted(counts)}")
        passes = self.want["passes"]
        if len(self.calls) == len(passes):
            for i, (got, want) in enumerate(zip(self.calls, passes)):
                for key in ("Q1", "Q3", "Q15"):
                    self.near(got.get(key), want[key], f"{key} of call {i + 1}")
        else:  # a pass too many or too few near the end: those made are among the expected ones
            for i, got in enumerate(self.calls):
                if not any(abs(got["Q1"] - w["Q1"]) <= TOLERANCE and abs(got["Q3"] - w["Q3"]) <= TOLERANCE for w in passes):
                    self.faults.append(f"{self.name}: call {i + 1} at depth {got['Q1']} is none of the expected ones")
        for key, value in self.want["end"].items():
            self.near(self.end.get(key), value, f"end value of {key}")
        return self.faults


# Bad input: values against those of the article, and the operator's text that the program then stops with. The texts stand
# as comments behind STOP in the programs.
PAPER = {"Q0": 1, "Q1": 0, "Q2": 0, "Q3": 0, "Q4": 90, "Q5": -83, "Q6": 1, "Q7": 50, "Q8": -9, "Q9": 4, "Q10": 0.5,
         "Q11": 200, "Q12": 800, "Q15": 1}
BAD = [("RADIUS", {"Q10": 0}, "Prisuv nesmi byt nulovy"), ("RADIUS", {"Q3": 91}, "Odklon tecny smi byt jen"),
       ("RADIUS", {"Q3": -91}, "Odklon tecny smi byt jen"), ("RADIUS", {"Q4": 90.001}, "Odklon tecny smi byt jen"),
       ("RADIUS", {"Q9": 10}, "Radius spicek frezy je vetsi"),
       ("RADIUS", {"Q8": 9}, "Vypukly radius musi mit pocatecni uhel vetsi"),
       ("RADIUS", {"Q3": 50, "Q4": 40}, "radius musi mit pocatecni uhel mensi"), ("RADIUS_OPR", {"Q10": 0}, "Prisuv nesmi byt nulovy"),
       ("UKOS", {"Q10": 0}, "Prisuv nesmi byt nulovy"), ("UKOS_OPR", {"Q3": 95}, "Odklon tecny smi byt jen"),
       ("UKOS", {"Q6": 0, "Q4": -10}, "ani prvniho bodu ukosu")]


def bad_input(obrys, folder, work):
    faults = []
    for program, changes, text in BAD:
        main = work / "HL.H"
        main.write_text(main_program(program, {**PAPER, **changes}))
        code, out, _ = run([obrys, "run", str(main), "--search", str(folder)])
        shown = [line for line in out.splitlines() if line.startswith("message ")]
        if not any(text in line for line in shown):
            faults.append(f"{program} with {changes}: exit {code}, messages {shown}, expected '{text}'")
        if calls(out):
            faults.append(f"{program} with {changes}: the cycle is called all the same")
    return faults


def bottom_of_the_arc(obrys, folder):
    """As printed, RADIUS asks for the arc sine of a height: Q6=0 ends in block 68."""
    code, out, _ = run([obrys, "check", str(folder / "HL_RADIUS.H"), "--set", "Q6=0", "--format", "json"])
    found = [f for f in json.loads(out)["findings"] if f["code"] == "arithmetic"]
    if len(found) != 1:
        return [f"check with Q6=0: exit {code}, {len(found)} arithmetic findings"]
    where, message = found[0]["where"], found[0]["message"]
    good = where["block"] == 68 and pathlib.Path(where["file"]).name == "RADIUS.H" and "ASIN" in message
    return [] if good else [f"check with Q6=0: {where} {message}"]


def main():
    obrys, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve() / "programs/heidenhain"
    if not (folder / "expected").is_dir():
        print("skipped: needs ../shared")
        return 77
    faults = []
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        for case, expected in json.loads((folder / "expected/radius_ukos.json").read_text()).items():
            c = Case(obrys, folder, work, case, expected)
            found = c.compare()
            faults += found
            print(f"{case}: {len(c.calls)} calls, {len(found)} faults")
        faults += bad_input(obrys, folder, work)
        print(f"{len(BAD)} cases of bad input")
    faults += bottom_of_the_arc(obrys, folder)
    print("\n".join(faults[:40]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
