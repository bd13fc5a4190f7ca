#!/usr/bin/env python3
"""Translates programs of every control for every control and prints how that went, as a table of docs/translations.md.

usage: matrix.py OBRYS --golden FOLDER [--examples FOLDER] [--corpus FOLDER] [--write FILE] [--count N] [--list CLASS]

Of each control N programs are taken at equal distances from the sorted list of those that run without a complaint: the
examples and golden cases, and, where FOLDER is there, programs of the corpus, which nobody here wrote. What `translate`
calls equal is held to the program once more by `compare`, from the files, as near as it says; a difference there is one that was silent,
and the exit code is 1.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import round_trip  # noqa: E402

TIMEOUT = 300
CONTROLS = ("heidenhain-itnc530", "sinumerik-840d", "fanuc", "haas", "linuxcnc", "acramatic-2100", "apt-cl")
TARGETS = ("heidenhain-itnc530", "heidenhain-iso", "sinumerik-840d", "fanuc", "haas", "linuxcnc", "acramatic-2100", "canon")
CORPUS = {"heidenhain-itnc530": ("klartext", ".h"), "sinumerik-840d": ("sinumerik", ".mpf .spf .arc"), "fanuc": ("gcode", ".nc .cnc .tap .txt .eia .ncf"),
          "linuxcnc": ("rs274", ".ngc"), "apt-cl": ("apt", ".apt")}
CLASSES = ("equal", "expanded", "refused", "not compared", "SILENTLY DIFFERENT", "no answer")


def call(obrys, folder, *words):
    return subprocess.run([obrys, *words], cwd=folder, capture_output=True, timeout=TIMEOUT, check=False)


def control_of(obrys, case):
    """Of a program that runs without a complaint; else nothing."""
    try:
        done = call(obrys, case.folder, "translate", case.program, "--to", "canon", "--ledger", "-", "-o", os.devnull, "--force",
                    *case.options)
        run = call(obrys, case.folder, "run", case.program, *case.options)
    except subprocess.TimeoutExpired:
        return None
    said = re.match(r".*\(([a-z0-9-]+)\) -> ", done.stdout.decode("utf-8", "replace"))
    moves = re.search(rb"(?m)^(linear|rapid|arc|thread|spline)", run.stdout)
    return said.group(1) if said and run.returncode == 0 and moves else None


ON_ARCS = 6  # increments' halves: a place on an arc follows from its start, its centre and its end, which are rounded


def compared(obrys, case, told, out, err, times=1):
    """Both files held to each other, each as a job of its own control; the rest of a job and all options are the same."""
    options, options_of = list(case.options), []
    while options:
        word = options.pop(0)
        if word == "--control":
            options.pop(0)
        elif not word.startswith("--control="):
            options_of.append(word)
    taken = re.search(r"note: no machine is named: (\S+) is taken", err)
    if taken and "--machine" not in options_of:
        options_of += ["--machine", taken.group(1)]
    within = re.search(r"within (\S+) mm", err)  # places on arcs follow from rounded words, and it says how near they are
    if within and "--tolerance" not in options_of:
        options_of += ["--tolerance", repr(float(within.group(1)) * times)]
    is_job, jobs = case.program.endswith(".toml"), []
    text = (case.folder / case.program).read_text(encoding="utf-8", errors="replace") if is_job else ""
    named = re.search(r'(?m)^\s*program\s*=\s*"([^"]*)"', text)
    text = re.sub(r"(?m)^\s*(program|control)\s*=.*$", "", text)
    for program, control in ((named.group(1) if named else case.program, told["control"]), (str(out), told["to_control"])):
        # Beside the program: paths of a job are relative to it.
        job = tempfile.NamedTemporaryFile("w", dir=case.folder, suffix=".job.toml", encoding="utf-8", delete=False)
        job.write(f'program = "{program}"\ncontrol = "{control}"\n{text}')
        job.close()
        jobs.append(job.name)
    try:
        return call(obrys, case.folder, "compare", *jobs, "--format", "json", *options_of)
    finally:
        for name in jobs:
            os.unlink(name)


def is_told_stop(said, err):
    """A stop that stops spindle or coolant by itself, with both told again behind it: that is no silent difference."""
    done = {d["aspect"] for d in said["differences"] if d["is_done"]}
    return "a stop while spindle or coolant is on" in err and done <= {"spindle", "coolant"} and said["equal"]["stock"] is not False


def translated(obrys, case, target, folder):
    """How one translation went; (class, what is lost or differs)"""
    out, ledger = folder / ("OUT." + target), folder / "ledger.json"
    done = call(obrys, case.folder, "translate", case.program, "--to", target, "-o", str(out), "--ledger", str(ledger), "--force",
                *case.options)
    err = done.stderr.decode("utf-8", "replace")
    by_name = re.search(r"error: (this post is for mills[^\[]*)", err)
    if by_name and done.returncode == 2:
        return "refused", by_name.group(1).strip()
    if not ledger.exists():
        return "no answer", (err.splitlines() or [f"exit {done.returncode}"])[0]
    told = json.loads(ledger.read_text(encoding="utf-8"))
    lost = [e["what"] for e in told["entries"] if e["fate"] == "lost"]
    if not told["written"]:
        return "refused", lost[0] if lost else "runs otherwise: " + next((l for l in err.splitlines() if "runs-otherwise" in l), "")
    if told["proof"] != "equal":
        return "not compared", (err.splitlines() or [""])[0]
    said = compared(obrys, case, told, out, err)
    if said.returncode == 1 and "counts in increments" in err:
        said = compared(obrys, case, told, out, err, ON_ARCS)
    if said.returncode == 1 and not is_told_stop(json.loads(said.stdout), err):
        first = json.loads(said.stdout)["first_difference"]
        return "SILENTLY DIFFERENT", f"{first['aspect']}: {first['what']}"
    return ("expanded" if told["counts"]["expanded"] else "equal"), ""


def chosen(cases, count):
    return [cases[i * len(cases) // min(count, len(cases))] for i in range(min(count, len(cases)))]


def copied(folder, keep):
    """Jobs are laid beside programs: never into what is not ours."""
    place = keep / re.sub(r"[^A-Za-z0-9.]", "_", str(folder))[-150:]
    if not place.exists():
        subprocess.run(["cp", "-r", str(folder), str(place)], check=True)
    return place


def own_cases(args, keep):
    cases = list(round_trip.golden_cases(args.golden, keep))
    if args.examples:
        for path in sorted(pathlib.Path(args.examples).rglob("*.job.toml")):
            cases.insert(0, round_trip.Case("examples/" + path.parent.name, copied(path.parent, pathlib.Path(keep)), path.name, []))
    return cases


def corpus_cases(args, control, keep):
    name, endings = CORPUS[control]
    root = pathlib.Path(args.corpus) / name
    for path in sorted(root.rglob("*")):
        if path.is_file() and path.suffix.lower() in endings.split():
            yield round_trip.Case(str(path.relative_to(root)), copied(path.parent, keep), path.name, ["--control", control])


def by_control(obrys, cases, pool):
    out = collections.defaultdict(list)
    for case, control in zip(cases, pool.map(lambda c: control_of(obrys, c), cases)):
        if control:
            out[control].append(case)
    return out


def one(obrys, case, target):
    with tempfile.TemporaryDirectory() as folder:
        try:
            return translated(obrys, case, target, pathlib.Path(folder))
        except (subprocess.TimeoutExpired, json.JSONDecodeError) as error:
            return "no answer", type(error).__name__


def table(obrys, sets, pool, listed):
    """Lines of the table, and how many were silently different."""
    lines, silent, reasons = ["| from, programs | " + " | ".join(TARGETS) + " |", "|---" * (len(TARGETS) + 1) + "|"], 0, collections.Counter()
    for control in CONTROLS:
        cases = sets.get(control, [])
        cells = []
        for target in TARGETS:
            results = list(pool.map(lambda case, t=target: one(obrys, case, t), cases))
            counts = collections.Counter(kind for kind, _ in results)
            silent += counts["SILENTLY DIFFERENT"] + counts["no answer"]
            for case, (kind, what) in zip(cases, results):
                if kind == "refused":
                    reasons[re.sub(r"-?\d+(\.\d+)?", "N", what)[:90]] += 1
                if listed == kind or kind in ("SILENTLY DIFFERENT", "no answer"):
                    print(f"{kind}: {case.name} to {target}: {what}", file=sys.stderr)
            cells.append(", ".join(f"{counts[c]} {c}" for c in CLASSES if counts[c]))
        lines.append(f"| {control}, {len(cases)} | " + " | ".join(cells) + " |")
    return lines, silent, reasons


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("obrys")
    parser.add_argument("--golden", required=True)
    parser.add_argument("--examples")
    parser.add_argument("--corpus")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--write")
    parser.add_argument("--list", default="")
    args = parser.parse_args()
    obrys = str(pathlib.Path(args.obrys).resolve())
    text, silent, reasons = [], 0, collections.Counter()
    with tempfile.TemporaryDirectory() as keep, concurrent.futures.ThreadPoolExecutor(2) as pool:
        sources = [("Examples and golden cases", by_control(obrys, own_cases(args, keep), pool))]
        if args.corpus and pathlib.Path(args.corpus).is_dir():
            found = {}
            for control in CORPUS:
                found.update({control: by_control(obrys, list(corpus_cases(args, control, pathlib.Path(keep))), pool)[control]})
            sources.append(("Programs that nobody here wrote", found))
        elif args.corpus:
            print("skipped: the corpus is not there", file=sys.stderr)
        for title, sets in sources:
            lines, wrong, why = table(obrys, {c: chosen(s, args.count) for c, s in sets.items() if s}, pool, args.list)
            text += [f"## {title}", "", *lines, ""]
            silent += wrong
            reasons += why
    text += ["## What was refused, by its first cause", "", "| cause | translations |", "|---|---|"]
    text += [f"| {what.replace('|', '/')} | {count} |" for what, count in reasons.most_common(25)]
    if args.write:
        path = pathlib.Path(args.write)
        head = path.read_text(encoding="utf-8").split("\n## ")[0].rstrip() if path.exists() else "# Translations"
        path.write_text(head + "\n\n" + "\n".join(text) + "\n", encoding="utf-8")
    else:
        print("\n".join(text))
    print(f"{silent} silently different or without an answer", file=sys.stderr)
    return 1 if silent else 0


if __name__ == "__main__":
    sys.exit(main())
