#!/usr/bin/env python3
"""Random turning programs, correct by construction (outside, in bores, grooves, face grooves), must be clean; with one fault each it must
be found: on the line at fault, with its amount. Paths and parts come from formulas of their own (profiles.py, cases.py).

usage: random_parts.py OBRYS [--count 300] [--seed N] [--amount 0.03] [--kind K] [--only NUMBER --keep FOLDER]
"""
import argparse
import json
import pathlib
import random as randoms
import subprocess
import sys
import tempfile

import cases


def write_job(folder, case):
    (folder / "PART.MPF").write_text("\n".join(t for t, _ in case.lines) + "\n")
    (folder / "part.job.toml").write_text("\n".join([
        'program = "PART.MPF"', 'machine = "lathe-generic"', "[[tool]]", case.tool, "[stock]", case.stock, "[part]", case.part]) + "\n")


def check(obrys, folder):
    done = subprocess.run([obrys, "check", "--format", "json", str(folder / "part.job.toml")], capture_output=True, text=True, timeout=120)
    try:
        return json.loads(done.stdout)
    except ValueError:
        return {"verdict": "none", "findings": [], "unchecked": [{"message": done.stderr[-600:] + done.stdout[-300:]}]}


def summary(result):
    out = [f"{f['code']} line {f['where']['line']}: {f['message'][:150]}" for f in result["findings"][:4]]
    out += [f"not checked: {u['message'][:300]}" for u in result["unchecked"][:3]]
    return result["verdict"] + "; " + " | ".join(out)


def judge_fault(case, result, amount):
    """Empty where the fault was found as it is; else what is wrong with what was found."""
    guilty = {n + 1 for n, (_, mark) in enumerate(case.lines) if mark}
    found = [f for f in result["findings"] if f["code"] in case.codes]
    if not found:
        return "missed: " + summary(result)
    if case.codes == ("rapid-in-stock",):
        return "" if found[0]["where"]["line"] in guilty else f"blamed {found[0]['where']['line']}, guilty {sorted(guilty)}"
    others = [f for f in result["findings"] if f["code"] not in case.codes]
    if others:
        return f"beside it: {summary({'verdict': '', 'findings': others, 'unchecked': []})}"
    lines = {f["where"]["line"] for f in found}
    if not lines <= guilty:
        return f"blamed line {sorted(lines - guilty)}, guilty are {sorted(guilty)}: {summary(result)}"
    most = max(f["depth_mm"] for f in found)
    if not abs(amount) - 0.0002 < most < abs(amount) * 1.45:
        return f"amount {most} for {amount}: {summary(result)}"
    return ""


def run(options, number):
    kind = options.kind or sorted(cases.MAKERS)[number % len(cases.MAKERS)]
    maker, faults = cases.MAKERS[kind]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        case, tries = None, 0
        while case is None:  # a random profile may leave no room for passes
            key = f"{options.seed}.{number}.{tries}"
            tries += 1
            choose = randoms.Random(key + ".fault")
            fault, sign = choose.choice(faults), choose.choice((-1, 1))
            wrong = cases.finish(maker(randoms.Random(key), sign * options.amount, fault))
            case = cases.finish(maker(randoms.Random(key), 0.0, None)) if wrong is not None else None
        complaints = []
        write_job(folder, case)
        result = check(options.obrys, folder)
        if result["verdict"] != "clean":
            return [f"{number} {kind} correct: {summary(result)}"]
        write_job(folder, wrong)
        what = judge_fault(wrong, check(options.obrys, folder), options.amount)
        if what:
            complaints.append(f"{number} {kind} {fault} {sign * options.amount}: {what}")
        return complaints


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", default=None)
    parser.add_argument("--amount", type=float, default=0.03)
    parser.add_argument("--kind")
    parser.add_argument("--only", type=int)
    parser.add_argument("--keep")
    options = parser.parse_args()
    if options.seed is None:
        options.seed = randoms.SystemRandom().randrange(10 ** 6)
    print(f"seed {options.seed}")
    numbers = range(options.count) if options.only is None else [options.only]
    complaints = [c for n in numbers for c in run(options, n)]
    print("\n".join(complaints))
    print(f"{len(numbers)} programs and their faults: {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
