#!/usr/bin/env python3
"""Writes programs anew for their own control and holds both to each other.

usage: round_trip.py OBRYS [--golden FOLDER] [--examples FOLDER] [--programs FOLDER...] [--list CAUSE] [--keep FOLDER]
                     [--only TEXT] [--write FILE]

Prints a table: how many are equal, how many make the machine do the same but are said otherwise, and what differs first.
Programs that run without a complaint and move the machine are counted apart from those of which the run itself stops or
which are not understood, and from those that move nothing. --write puts that into FILE, as docs/round-trips.md.
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

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent.parent / "golden"), str(pathlib.Path(__file__).resolve().parent)]
import run as golden  # noqa: E402
import round_trip_table  # noqa: E402

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


class Outcome:
    def __init__(self, name, kind, aspect, what, control="", code=0, moves=0):
        self.name, self.kind, self.aspect, self.what = name, kind, aspect, what
        self.control, self.code, self.moves = control, code, moves


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
    """What came of it; an answer that is not there raises."""
    def call(*words):
        return subprocess.run([obrys, *words], cwd=case.folder, capture_output=True, timeout=TIMEOUT, check=False)

    options = list(case.options)
    run = call("run", case.program, *options)
    moves = len(re.findall(rb"(?m)^(?:rapid|linear|arc|spline|thread) ", run.stdout))
    kind, aspect, what, control = written_anew(call, case, options)
    return Outcome(case.name, kind, aspect, what, control, run.returncode, moves)


def written_anew(call, case, options):
    """(class, aspect, what, control)"""
    written = call("translate", case.program, "--to", "same", "--accept-loss", *options)
    err = written.stderr.decode("utf-8", "replace")
    if written.returncode == 2:
        lines = [l for l in err.splitlines() if "error" in l] or [err[:80]]
        return "not read", "", lines[0], ""
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
    # A control that counts in increments rounds what is written; translate says how near it then is.
    near = re.search(r"within ([0-9.e-]+) mm \(the control counts in increments", err)
    done = call("compare", case.program, against, "--format", "json", *options,
                *(["--tolerance", near.group(1)] if near else []))
    said = done.stderr.decode("utf-8", "replace")
    notes = sorted(set(re.findall(r"\[(not-written|written-by-moves)\]", err)))
    if done.returncode == 2:
        return "not read again", "", (said.splitlines() or [""])[0], control
    result = json.loads(done.stdout)
    # What is left of the stock is compared where both have one; null: not compared.
    wrong = [a for a, equal in result["equal"].items() if not equal and not (a == "stock" and equal is None)]
    lost = [l for l in err.splitlines() if "[not-written]" in l]
    if not wrong:
        return "equal", "", "", control
    if any(a in DONE for a in wrong):
        d = result["differences"]
        d = next(x for x in d if x["aspect"] in DONE)
        own = {"not-written", "written-by-moves", "runs-otherwise", "assumption", "no-effect"}
        of_source = "\n".join(line for line in err.splitlines() if " (as written):" not in line)
        stops = [code for code in re.findall(r": (?:error|warning): .*\[([a-z-]+)\]", of_source) if code not in own]
        # What nobody knows (a coordinate no block has given, a feed of a parameter that is not set) has no words.
        unknown = lost and all(" not known" in line for line in lost)
        otherwise = "DIFFERS" if d["is_done"] else "done the same"
        kind = "not known" if unknown else "lost, said" if lost else "stops" if stops else otherwise
        return kind, d["aspect"], d["what"] + (" | " + lost[0] if lost else ""), control
    d = result["differences"][0]
    return "done the same", d["aspect"] + (" expanded" if notes else ""), d["what"], control


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


OWN, OTHERS = "Examples and golden cases", "Programs that nobody here wrote"


def program_cases(folders):
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file() and path.suffix.lower() in PROGRAMS:
                name = pathlib.Path(folder).name + "/" + str(path.relative_to(folder))
                yield Case(name, path.parent, path.name, [])


def example_cases(folder):
    for path in sorted(pathlib.Path(folder).rglob("*")):
        job = path.name.endswith(".job.toml")
        if path.is_file() and (path.suffix.lower() in PROGRAMS or job):
            yield Case("examples/" + str(path.relative_to(folder)), path.parent, path.name, [])


def outcome(obrys, case):
    try:
        return round_trip(obrys, case)
    except subprocess.TimeoutExpired:
        return Outcome(case.name, "timeout", "", "")
    except json.JSONDecodeError as error:
        return Outcome(case.name, "no answer", "", str(error))


def copied_cases(cases, keep):
    """Of folders that nothing may be written into."""
    for case in cases:
        place = keep / re.sub(r"[^A-Za-z0-9.]", "_", case.name)[-150:]
        if not place.exists():
            subprocess.run(["cp", "-r", str(case.folder), str(place)], check=True)
        yield Case(case.name, place, case.program, case.options)


SAME = ("equal", "done the same")


def summary(outcomes):
    """(programs that run and move, of these equal, done the same)"""
    run = [o for o in outcomes if o.code == 0 and o.moves > 0 and o.kind != round_trip_table.NOT_READ]
    return len(run), sum(o.kind == "equal" for o in run), sum(o.kind == "done the same" for o in run)


def share(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("obrys")
    parser.add_argument("--golden")
    parser.add_argument("--examples")
    parser.add_argument("--programs", nargs="*", default=[])
    parser.add_argument("--list", default="", help="also print the cases of this class or aspect")
    parser.add_argument("--keep")
    parser.add_argument("--only", default="")
    parser.add_argument("--write", help="file of the tables")
    parser.add_argument("--known", help="file of cases that differ, with why: no other one may, and each of them must")
    parser.add_argument("--classes", help="file of the class of every golden and example: each has to be in that one")
    parser.add_argument("--write-classes", help="writes that file")
    parser.add_argument("--page", help="docs/round-trips.md: its shares have to be those that are measured")
    arguments = parser.parse_args()
    obrys = str(pathlib.Path(arguments.obrys).resolve())
    groups = {}
    with tempfile.TemporaryDirectory() as folder:
        keep = pathlib.Path(arguments.keep or folder)
        keep.mkdir(parents=True, exist_ok=True)
        goldens = list(golden_cases(arguments.golden, keep)) if arguments.golden else []
        examples = list(copied_cases(example_cases(arguments.examples), keep)) if arguments.examples else []
        groups[OWN] = goldens + examples
        groups[OTHERS] = list(copied_cases(program_cases(arguments.programs), keep))
        for name, cases in groups.items():
            groups[name] = [outcome(obrys, c) for c in cases if not arguments.only or arguments.only in c.name]
    outcomes = [o for group in groups.values() for o in group]
    for o in outcomes:
        if arguments.list and arguments.list in (o.kind, o.aspect):
            print(f"{o.kind} [{o.aspect}] {o.name}: {o.what}")
    for (kind, aspect), count in collections.Counter((o.kind, o.aspect) for o in outcomes).most_common():
        print(f"{count:6} {kind} {aspect}")
    for name, group in groups.items():
        total, equal, same = summary(group)
        if total:
            print(f"{name}: {total} programs run without a complaint and move; written anew {equal} are equal, every record: "
                  f"{share(equal, total)}; {equal + same} do the same: {share(equal + same, total)}")
    if arguments.write:
        pathlib.Path(arguments.write).write_text(round_trip_table.page(groups, known_reasons(arguments.known)), encoding="utf-8")
    if arguments.write_classes:
        pathlib.Path(arguments.write_classes).write_text(written_classes(groups[OWN]), encoding="utf-8")
    faults = held_to(arguments.known, outcomes) if arguments.known else []
    if arguments.classes:
        faults += held_to_classes(arguments.classes, groups[OWN], whole=not arguments.only)
    if arguments.page:
        faults += held_to_page(arguments.page, {OWN: groups[OWN]})
    print("\n".join(faults))
    return 1 if faults else 0


def known_reasons(path):
    if not path:
        return {}
    return dict(line.split(": ", 1) for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines()
                if line and not line.startswith("#"))


def classes_in(path):
    """{case: class} as they are written down; cases that are equal and run without a complaint stand there, too."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    return dict(line.rsplit(": ", 1) for line in lines if line and not line.startswith("#"))


CLASSES_HEAD = """# What becomes of every golden that is written anew for its own control. round_trip.py holds exactly these: a case
# that becomes worse is a fault, and one that becomes better is written down anew (--write-classes).
"""


def class_name(o):
    return f"{o.kind} in {o.aspect.split()[0]}" if o.aspect else o.kind


def written_classes(outcomes):
    return CLASSES_HEAD + "".join(f"{o.name}: {class_name(o)}\n" for o in sorted(outcomes, key=lambda o: o.name))


def held_to_classes(path, outcomes, whole):
    """What is not as it is written down; `whole`: cases that are written down have to be there."""
    wanted, found = classes_in(path), {o.name: o for o in outcomes}
    faults = [f"{name}: {class_name(o)}; written down: {wanted.get(name, 'nothing')} ({o.what})"
              for name, o in found.items() if class_name(o) != wanted.get(name)]
    return faults + [f"{name} is written down and is no case" for name in wanted if whole and name not in found]


def shares_in(page):
    """The two shares of each group of a page of tables: {title: (equal, same, of)}"""
    found = re.findall(r"(?m)^## (.*)$|^Of (\d+) programs that run and move, (\d+) are equal .* and (\d+) do the same", page)
    out, title = {}, ""
    for heading, of, equal, same in found:
        title = heading or title
        if of:
            out[title] = (int(equal), int(same), int(of))
    return out


def held_to_page(path, groups):
    """The shares of the page are those that were measured, of every group that was."""
    shown = shares_in(pathlib.Path(path).read_text(encoding="utf-8"))
    faults = []
    for title, group in groups.items():
        total, equal, same = summary(group)
        if total and shown.get(title) != (equal, equal + same, total):
            faults.append(f"{path}: {title}: {shown.get(title)}; measured {(equal, equal + same, total)}")
    return faults


def held_to(known, outcomes):
    """0 where exactly the known cases differ."""
    reasons = known_reasons(known)
    differ = {o.name: o.what for o in outcomes if o.kind in ("DIFFERS", "not read again", "no answer", "timeout")}
    faults = [f"{name} differs: {what}" for name, what in differ.items() if name not in reasons]
    there = {o.name for o in outcomes}
    return faults + [f"{name} is said to differ ({why}) and does not" for name, why in reasons.items()
                     if name not in differ and (name in there or name.endswith(".txt"))]


if __name__ == "__main__":
    sys.exit(main())
