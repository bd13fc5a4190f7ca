#!/usr/bin/env python3
"""Random correct programs against parts made from formulas must be clean; with one fault each they must be found, on the line at
fault. The parts (stl_parts.py) know nothing of the simulation.

usage: random_parts.py OBRYS [--count 200] [--seed 1] [--tolerances 0.05,0.01,0.002] [--amount 0.03] [--kind K] [--swivel]
                       [--keep FOLDER]
A fault must be larger than the tolerance to be seen: at a tolerance of 0.02 or more it is three times the tolerance. Below 0.005
the parts are a quarter of the size; --scale says another. --swivel: on a machine with two rotary axes, each case swivelled. What is found of a fault must be what formulas say of it: its code or
codes, their amounts within the tolerance or a fifth, and the line.
"""
import argparse
import random as randoms
import sys

import blocks
import cases
import jobs
import stl_parts

FINDINGS = ("gouge", "rest-material")


def write_job(folder, case, tolerance, scale, setting):
    triangles = (stl_parts.cone_end(case.centre, case.rings, case.tip) if case.tip is not None
                 else stl_parts.build(case.centre, case.rings, case.through))
    case.scaled(scale)
    part = [tuple(tuple(v * scale for v in p) for p in t) for t in triangles]
    stock, more = (case.box[:3], case.box[3:]), {}
    if setting is not None:
        first = next(i for i, (t, _) in enumerate(case.lines) if " G43 " in t)  # where the tool stands is not known before
        case.lines[first] = (case.lines[first][0] + f" A{setting.a} B{setting.b}", case.lines[first][1])
        part = setting.mesh(part)
        stl_parts.write(folder / "stock.stl", setting.mesh(jobs.box(*stock)))
        stock, more = {"file": "stock.stl"}, blocks.swivelling(folder)
    jobs.write(folder, [*(t for t, _ in case.lines), "M2"], case.tools, stock, part,
               check={"tolerance": tolerance, "gouge": tolerance, "rest_material": tolerance}, **more)


def summary(result):
    out = [f"{f['code']} line {f['where']['line']}: {f['message'][:110]}" for f in result["findings"][:4]]
    out += [f"not checked: {u['message'][:140]}" for u in result["unchecked"][:3]]
    return result["verdict"] + "; " + " | ".join(out)


def judge_fault(case, result, tolerance):
    """Empty where the fault was found as it is; else what is wrong with what was found."""
    guilty = {n + 1 for n, (_, mark) in enumerate(case.lines) if mark == "*"}
    named = guilty | {n + 1 for n, (_, mark) in enumerate(case.lines) if mark}
    found = [f for f in result["findings"] if f["code"] in FINDINGS]
    wrong = []
    for code in FINDINGS:
        amounts = [f.get("depth_mm", f.get("height_mm", 0)) for f in found if f["code"] == code]
        expected = case.expected.get(code, 0.0)
        if not amounts and expected > 1.05 * tolerance and code not in case.optional:
            wrong.append(f"{code} of {expected:.4f} missed")
        if amounts and expected < 0.95 * tolerance:
            wrong.append(f"{code} of {max(amounts):.4f} where there is {expected:.4f}")
        elif amounts and abs(max(amounts) - expected) > max(tolerance, 0.2 * expected):
            wrong.append(f"{code} of {expected:.4f} said to be {max(amounts):.4f}")
    lines = {f["where"]["line"] for f in found}
    if not lines <= named or (lines and not lines & guilty):
        wrong.append(f"blamed line {sorted(lines)}, guilty are {sorted(guilty)}")
    return "; ".join(wrong)


def run(options, tolerance, number):
    random = randoms.Random(f"{options.seed}.{number}")
    kind = options.kind or sorted(cases.MAKERS)[number % len(cases.MAKERS)]
    maker, faults = cases.MAKERS[kind]
    seed = random.random()
    setting = blocks.Setting(0.0, round(random.uniform(-60, 60), 3), round(random.uniform(-60, 60), 3)) if options.swivel else None
    size = options.amount if tolerance < 0.02 else 3 * tolerance
    scale = options.scale or (0.25 if tolerance < 0.005 else 1.0)
    complaints = []
    with jobs.folder_of(options.keep) as folder:
        case = maker(randoms.Random(seed), tolerance / 20 / scale, None, 0.0)
        write_job(folder, case, tolerance, scale, setting)
        result = jobs.check(options.obrys, folder)
        if result["verdict"] != "clean":
            complaints.append(f"{tolerance} {number} {kind} correct: {summary(result)}")
        fault = random.choice(faults)
        amount = size if fault in ("tool", "place") or random.random() < 0.5 else -size
        case = maker(randoms.Random(seed), tolerance / 20 / scale, fault, amount / scale)
        if case is None:
            case = maker(randoms.Random(seed), tolerance / 20 / scale, "floor", amount / scale)
            fault = "floor"
        write_job(folder, case, tolerance, scale, setting)
        result = jobs.check(options.obrys, folder)
        wrong = judge_fault(case, result, tolerance)
        if wrong:
            complaints.append(f"{tolerance} {number} {kind} {fault} {amount}: {wrong}; {summary(result)}")
    return complaints


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tolerances", default="0.05,0.01,0.002")
    parser.add_argument("--amount", type=float, default=0.03)
    parser.add_argument("--scale", type=float)
    parser.add_argument("--kind")
    parser.add_argument("--swivel", action="store_true")
    parser.add_argument("--keep")
    jobs.add_bound(parser)
    options = parser.parse_args()
    failed = 0
    for tolerance in [float(t) for t in options.tolerances.split(",")]:
        all_complaints = []
        for number in range(options.first, options.first + options.count):
            complaints = run(options, tolerance, number)
            for c in complaints:
                print(c, flush=True)
            all_complaints += complaints
        false = sum(" correct: " in c for c in all_complaints)
        print(f"tolerance {tolerance}: {options.count} correct programs, {false} not clean; {options.count} faults, "
              f"{len(all_complaints) - false} not found as they are", flush=True)
        failed += len(all_complaints)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
