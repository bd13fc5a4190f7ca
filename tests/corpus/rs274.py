#!/usr/bin/env python3
"""All RS-274 and Fanuc programs of the corpus: each is read and checked without crash or hang; prints a table.

usage: rs274.py OBRYS SHARED [-v]      exit 77 (skipped) where SHARED is missing

A program runs to its end, or to an error with a place (many of these programs are subroutines without an end, or meant for a
machine with other axes: tests/linuxcnc/end_points.py says which of them LinuxCNC itself refuses), or over words that are
named as not run. A fault is a crash, a hang, or an end without a word why.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

PLACES = ("rs274", "fanuc_macro", "gcode")


def control_of(name):
    """The programs of "gcode" are of many controls: found from their text."""
    if "LinuxCNC" in name or name.startswith("rs274/"):
        return "linuxcnc"
    return "fanuc" if name.startswith("fanuc_macro/") else ""


ALARMS = {"arithmetic", "value-range", "missing-label", "missing-subprogram", "arc-radius", "compensation", "program-alarm",
          "type-mismatch", "syntax", "undefined-name"}
NOT_READ = {"syntax", "unknown-word", "unclosed"}
SECONDS, BUDGET = 60, 5


def check(obrys, path, control, job):
    """Checks through a job file that ends endless programs soon: (result, fault)."""
    lines = [f"program = {json.dumps(path.resolve().as_posix())}"]
    lines += [f'control = "{control}"'] if control else []
    job.write_text("\n".join(lines) + f"\n[budget]\nseconds = {BUDGET}\n")
    try:
        done = subprocess.run([obrys, "check", str(job), "--format", "json"], capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, f"no end within {SECONDS} s"
    if done.returncode not in (0, 1, 3):
        return None, f"exit {done.returncode}: {done.stderr.decode(errors='replace').strip()[:200]}"
    return json.loads(done.stdout), None


def line_of(name, result):
    """How it ended, the words not run, and the line of the table."""
    errors = [f for f in result["findings"] if f["code"] in ALARMS]
    codes = {n["code"] for n in result["unchecked"]}
    words = collections.Counter(n["message"].split(" is ")[0].strip('"')[:24] for n in result["unchecked"]
                                if n["code"] in ("unsupported", "unknown-word"))
    if "budget" in codes:
        ended = "endless"
    elif errors:
        ended = "alarm"
    elif codes & NOT_READ:
        ended = "not read fully"
    else:
        ended = "words not run" if words else "to its end"
    stats = result["stats"]
    why = [f"{errors[0]['code']}: {errors[0]['message'][:60]}"] if errors else []
    return ended, words, (f"{name:70.69}{ended:16}{stats['blocks_executed']:8}{stats['moves']:8}  "
                          + ", ".join(sorted(words)[:6] + why))


def main():
    obrys, corpus, verbose = sys.argv[1], pathlib.Path(sys.argv[2]) / "corpus", "-v" in sys.argv
    if not corpus.is_dir():
        print("skipped: needs ../shared")
        return 77
    faults, words, ends = [], collections.Counter(), collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder) / "case.job.toml"
        for place in PLACES:
            for path in sorted(p for p in (corpus / place).rglob("*") if p.is_file()):
                name = path.relative_to(corpus).as_posix()
                result, fault = check(obrys, path, control_of(name), job)
                name = name.replace("LinuxCNC__linuxcnc", "…")
                if fault:
                    faults.append(f"{name}: {fault}")
                    ends[place]["crash or hang"] += 1
                    continue
                ended, not_run, line = line_of(name, result)
                ends[place][ended] += 1
                words.update(not_run.keys())
                if verbose or ended in ("alarm", "endless", "not read fully"):
                    print(line)
    for place, counts in ends.items():
        print(f"{place}: {sum(counts.values())} programs: " + ", ".join(f"{e} {n}" for e, n in counts.most_common()))
    print("words not run (programs): " + (", ".join(f"{w} {n}" for w, n in words.most_common(20)) or "none"))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
