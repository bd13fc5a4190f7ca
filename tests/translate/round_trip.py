#!/usr/bin/env python3
"""Writes programs anew for their own control and holds both to each other.

usage: round_trip.py OBRYS [--golden FOLDER] [--programs FOLDER...] [--list CAUSE] [--keep FOLDER] [--only TEXT]

Prints a table: how many are equal, how many make the machine do the same but are said otherwise, and what differs first.
Programs of which the run itself stops or which are not understood are counted apart.
"""
import argparse
import collections
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "golden"))
import run as golden  # noqa: E402

TAKEN = {"--control", "--machine", "--tools", "--search", "--skip", "--set", "--ini", "--var"}
FLAGS = {"--diameter", "--radius"}
TIMEOUT = 60
DONE = ("motion", "feed", "spindle", "coolant", "tool", "events")


def options_of(words):
    """Options that both commands take, and what is left: the inputs."""
    kept, inputs, words = [], [], list(words)
    while words:
        word = words.pop(0)
        if word in TAKEN:
            kept += [word, words.pop(0)]
        elif word.split("=")[0] in TAKEN or word in FLAGS:
            kept.append(word)
        elif word.startswith("-"):
            if word in ("--format", "-o", "--output", "--fail-on", "--baseline", "--scope", "--tolerance", "--html",
                        "--svg", "--stl", "--prints", "--engagement", "--at", "--plan", "--picture", "--gltf", "--3mf",
                        "--projections", "--write-baseline", "--sets", "--map", "--ledger"):
                words.pop(0)
        else:
            inputs.append(word)
    return kept, inputs


class Case:
    def __init__(self, name, folder, program, options):
        self.name, self.folder, self.program, self.options = name, folder, program, options


def suffix_of(text):
    if "BEGIN PGM" in text[:40]:
        return ".H", "heidenhain-itnc530"
    if text.startswith(":\n"):
        return ".nc", "acramatic-2100"
    if text.startswith("G71"):
        return ".MPF", "sinumerik-840d"
    if "G91.1" in text[:60] or text.startswith("%\nG21 G90 G40 G80 G91.1"):
        return ".ngc", "linuxcnc"
    return ".nc", "fanuc"


def round_trip(obrys, case):
    """(class, aspect, what)"""
    def call(*words):
        return subprocess.run([obrys, *words], cwd=case.folder, capture_output=True, timeout=TIMEOUT, check=False)

    options = list(case.options)
    written = call("translate", case.program, "--to", "same", "--accept-loss", *options)
    err = written.stderr.decode("utf-8", "replace")
    if written.returncode == 2:
        lines = [l for l in err.splitlines() if "error" in l] or [err[:80]]
        return "not read", "", lines[0]
    text = written.stdout.decode("utf-8", "replace")
    taken = re.search(r"note: no machine is named: (\S+) is taken|: (lathe-generic|mill-generic) is taken", err)
    is_job = case.program.endswith(".toml")
    if taken and not is_job:
        options += ["--machine", taken.group(1) or taken.group(2)]
    suffix, control = suffix_of(text)
    out = "OBRYS_OUT" + suffix
    (case.folder / out).write_bytes(written.stdout)
    against = out
    if is_job:
        job = (case.folder / case.program).read_text(encoding="utf-8", errors="replace")
        folder = pathlib.Path(case.program).parent
        (case.folder / folder / out).write_bytes(written.stdout)
        job = re.sub(r'(?m)^(\s*program\s*=).*$', rf'\1 "{out}"', job)
        against = str(folder / "obrys_out.job.toml")
        (case.folder / against).write_text(job, encoding="utf-8")
    done = call("compare", case.program, against, "--format", "json", *options)
    said = done.stderr.decode("utf-8", "replace")
    notes = sorted(set(re.findall(r"\[(not-written|written-by-moves)\]", err)))
    if done.returncode == 2:
        return "not read again", "", (said.splitlines() or [""])[0]
    result = json.loads(done.stdout)
    # What is left of the stock is compared where both have one; null: not compared.
    wrong = [a for a, equal in result["equal"].items() if not equal and not (a == "stock" and equal is None)]
    lost = [l for l in err.splitlines() if "[not-written]" in l]
    if not wrong:
        return "equal", "", ""
    if any(a in DONE for a in wrong):
        d = result["differences"]
        d = next(x for x in d if x["aspect"] in DONE)
        own = {"not-written", "written-by-moves", "runs-otherwise", "assumption", "no-effect"}
        of_source = "\n".join(line for line in err.splitlines() if " (as written):" not in line)
        stops = [code for code in re.findall(r": (?:error|warning): .*\[([a-z-]+)\]", of_source) if code not in own]
        # What nobody knows (a coordinate no block has given, a feed of a parameter that is not set) has no words.
        unknown = lost and all(" not known" in line for line in lost)
        kind = "not known" if unknown else "lost, said" if lost else "stops" if stops else "DIFFERS"
        return kind, d["aspect"], d["what"] + (" | " + lost[0] if lost else "")
    d = result["differences"][0]
    return "done the same", d["aspect"] + (" expanded" if notes else ""), d["what"]


def golden_cases(folder, keep):
    for path in sorted(pathlib.Path(folder).rglob("*.txt")):
        sections = golden.parse(path.read_text(encoding="utf-8"))
        words = shlex.split(next(s[1] for s in sections if s[0] == "run"))
        if len(words) < 2 or words[1] not in ("run", "check", "plot") or "--canon" in words:
            continue
        options, inputs = options_of(words[2:])
        if len(inputs) != 1 or inputs[0] == "-":
            continue
        name = str(path.relative_to(folder))
        place = pathlib.Path(keep) / name.replace("/", "_")
        place.mkdir(parents=True, exist_ok=True)
        try:
            golden.lay_out(sections, place)
        except golden.BadCase:
            continue
        yield Case(name, place, inputs[0], options)


PROGRAMS = {".mpf", ".spf", ".h", ".i", ".ngc", ".nc", ".tap", ".cnc", ".min", ".arc"}


def program_cases(folders):
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file() and path.suffix.lower() in PROGRAMS:
                yield Case(str(path), path.parent, path.name, [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("obrys")
    parser.add_argument("--golden")
    parser.add_argument("--programs", nargs="*", default=[])
    parser.add_argument("--list", default="", help="also print the cases of this class or aspect")
    parser.add_argument("--keep")
    parser.add_argument("--only", default="")
    parser.add_argument("--known", help="file of cases that differ, with why: no other one may, and each of them must")
    arguments = parser.parse_args()
    obrys = str(pathlib.Path(arguments.obrys).resolve())
    classes, aspects, cases = collections.Counter(), collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        keep = pathlib.Path(arguments.keep or folder)
        keep.mkdir(parents=True, exist_ok=True)
        todo = list(golden_cases(arguments.golden, keep)) if arguments.golden else []
        for case in program_cases(arguments.programs):
            place = keep / re.sub(r"[^A-Za-z0-9.]", "_", case.name)[-150:]
            if not place.exists():
                subprocess.run(["cp", "-r", str(case.folder), str(place)], check=True)
            todo.append(Case(case.name, place, case.program, case.options))
        for case in todo:
            if arguments.only and arguments.only not in case.name:
                continue
            try:
                kind, aspect, what = round_trip(obrys, case)
            except subprocess.TimeoutExpired:
                kind, aspect, what = "timeout", "", ""
            except json.JSONDecodeError as error:
                kind, aspect, what = "no answer", "", str(error)
            classes[kind] += 1
            aspects[kind, aspect] += 1
            cases.append((kind, aspect, case.name, what))
    for kind, aspect, name, what in cases:
        if arguments.list and arguments.list in (kind, aspect):
            print(f"{kind} [{aspect}] {name}: {what}")
    for (kind, aspect), count in sorted(aspects.items(), key=lambda x: -x[1]):
        print(f"{count:6} {kind} {aspect}")
    equal = classes["equal"] + classes["done the same"]
    comparable = equal + classes["DIFFERS"] + classes["lost, said"]
    print(f"{equal} of {comparable} programs that run without a complaint do the same, written anew: "
          f"{100 * equal / max(comparable, 1):.1f} %; {classes['equal']} say it the same way, too")
    return held_to(arguments.known, cases) if arguments.known else 0


def held_to(known, cases):
    """0 where exactly the known cases differ."""
    reasons = dict(line.split(": ", 1) for line in pathlib.Path(known).read_text(encoding="utf-8").splitlines()
                   if line and not line.startswith("#"))
    differ = {name: what for kind, _, name, what in cases if kind in ("DIFFERS", "not read again", "no answer", "timeout")}
    faults = [f"{name} differs: {what}" for name, what in differ.items() if name not in reasons]
    faults += [f"{name} is said to differ ({why}) and does not" for name, why in reasons.items() if name not in differ]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
