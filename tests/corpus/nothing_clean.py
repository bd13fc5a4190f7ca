#!/usr/bin/env python3
"""Real programs that cut nothing, or that depend on what only the machine holds, are never called clean.

usage: nothing_clean.py OBRYS SHARED [-v]      exit 77 (skipped) where SHARED is missing

1. All programs of the corpus: one of which no feed move is run (setup files, subprograms alone, definitions) is not clean.
   There are such programs: where too few are found, the corpus was not read and nothing was tested.
2. Grinding programs of a SINUMERIK: global user data that they name are defined beside them, without values, as the
   machine's definition files do; what they hold is not known, so that no program is clean.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PLACES = ("sinumerik", "klartext", "rs274", "fanuc_macro", "gcode")
GRINDING = "sinumerik/zhituaishangc__Programing_NC"
SECONDS, BUDGET, PASSES = 60, 2, 8
FEWEST_IDLE, FEWEST_GRINDING = 300, 100  # 390 and 120 were found when this was written
KEY = re.compile(r'\[variables\] of the job: "?([A-Z_]\w*)(\[[^\]]*\])?"? = ')


def run(obrys, lines, folder):
    """Checks the motion alone, so that no missing stock or tool list keeps a program from being clean, through a job file
    that ends endless programs soon; the result, or None where nothing could be read."""
    job = folder / "case.job.toml"
    job.write_text("\n".join(lines) + f'\n[check]\nscope = "motion"\n[budget]\nseconds = {BUDGET}\n', encoding="utf-8")
    done = subprocess.run([obrys, "check", str(job), "--format", "json"], capture_output=True, timeout=SECONDS, check=False)
    if done.returncode not in (0, 1, 3):
        return None
    return json.loads(done.stdout)


def program_line(path):
    return f"program = {json.dumps(path.resolve().as_posix())}"


def without_moves(obrys, corpus, folder):
    """(programs without a feed move, those of them that are clean)."""
    idle, clean = 0, []
    for place in PLACES:
        for path in sorted(p for p in (corpus / place).rglob("*") if p.is_file()):
            result = run(obrys, [program_line(path)], folder)
            if result is None or result["stats"]["feed_moves"] > 0:
                continue
            idle += 1
            if result["verdict"] == "clean":
                clean.append(path.relative_to(corpus).as_posix())
    return idle, clean


def definition(name, rank):
    return f"DEF CHAN REAL {name}" + ("" if rank == 0 else "[" + ",".join(["200"] * rank) + "]")


def grinding(obrys, corpus, folder):
    """(programs, those that are clean, user data that were defined for them)."""
    programs = sorted(p for p in (corpus / GRINDING).rglob("*") if p.suffix.upper() in (".SPF", ".MPF"))
    search = sorted({p.parent for p in programs}) + [folder]
    head = "search = " + json.dumps([p.resolve().as_posix() for p in search])
    known, verdicts = {}, {}
    for path in programs:
        for _ in range(PASSES):
            (folder / "GUD4.DEF").write_text("\n".join(definition(n, r) for n, r in known.items()) + "\nM17\n")
            result = run(obrys, [program_line(path), 'control = "sinumerik-840d"', head], folder)
            if result is None:
                break
            named = [KEY.search(n.get("remedy", "")) for n in result["unchecked"] if n["code"] == "undefined-name"]
            new = {m[1]: (m[2] or "").count(",") + 1 if m[2] else 0 for m in named if m and m[1] not in known}
            verdicts[path] = result["verdict"]
            if not new:
                break
            known.update(new)
    return programs, [p.relative_to(corpus).as_posix() for p, v in verdicts.items() if v == "clean"], known


def told(obrys, folder):
    """The control group: a program that asks for user data is clean as soon as the job says what they hold, and only then."""
    (folder / "GUD4.DEF").write_text("DEF CHAN REAL MY_DEPTH\nM17\n")
    (folder / "ASKS.MPF").write_text("G17 G71 G90 G94\nT1 M6\nD1\nS1000 M3\nG0 X0 Y0 Z50\nG1 Z=MY_DEPTH F100\nG0 Z50\nM30\n")
    head = [program_line(folder / "ASKS.MPF"), 'control = "sinumerik-840d"', 'machine = "mill-generic"']
    return [run(obrys, head + more, folder)["verdict"] for more in ([], ["[variables]", "MY_DEPTH = 5.0"])]


def main():
    obrys, corpus = sys.argv[1], pathlib.Path(sys.argv[2]) / "corpus"
    if not corpus.is_dir():
        print("skipped: needs ../shared")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        idle, clean = without_moves(obrys, corpus, folder)
        programs, ground, known = grinding(obrys, corpus, folder)
        verdicts = told(obrys, folder)
    print(f"{idle} programs make no feed move: {len(clean)} clean")
    print(f"{len(programs)} grinding programs with {len(known)} user data without values: {len(ground)} clean")
    print(f"a program without and with its user data: {', '.join(verdicts)}")
    print("\n".join(clean + ground))
    found = idle >= FEWEST_IDLE and len(programs) >= FEWEST_GRINDING and bool(known)
    if not found:
        print(f"fewer than {FEWEST_IDLE} and {FEWEST_GRINDING} programs, or no user data: the corpus was not read")
    return 1 if clean or ground or not found or verdicts != ["not-fully-checked", "clean"] else 0


if __name__ == "__main__":
    sys.exit(main())
