#!/usr/bin/env python3
"""Reports how long files and functions are, and fails beyond the limits of CONTRIBUTING.md.

usage: sizes.py <src>

Functions are found by following braces, so the figures are those of clang-formatted code. A function that is only a
table is excepted by a comment holding `sizes: table` in its first three lines.
"""
import collections
import pathlib
import re
import statistics
import sys

FILE_MEDIAN, FILE_P95, FILE_MAX = 120, 300, 350
FUNCTION_P95, FUNCTION_MAX = 35, 80
FOLDER_MAX = 40  # sources without tests: more get a room (ADR 28)
WHOLE_STATE_MAX = 10  # functions of interp that take all of a run's state (ADR 32)
WHOLE_STATE = re.compile(r"^(?! )(?!struct|class)[^;=]*\b(?:Run|RunState)\s*&[^;]*\{", re.M)
NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^()\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|'
    r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.S | re.M)
NOT_A_FUNCTION = re.compile(r"^(?:template\s*<.*>\s*)?(?:typedef\s+)?(?:inline\s+)?(?:namespace|class|struct|enum|union|extern)\b", re.S)


def bare(text):
    """The text without comments, literals and preprocessor lines; every newline stays where it is."""
    def blank(match):
        filler = "0" if match.group()[0] in "R\"'" else " "
        return filler + "\n" * match.group().count("\n")

    return NOISE.sub(blank, text)


def ends_open_initialiser(head):
    """True where a brace behind `head` opens a member initialiser `: a_{…}` and not the function's body."""
    colon = re.search(r"\)[^:?{}]*(?<!:):(?!:)(.*)$", head, re.S)
    return bool(colon) and bool(re.search(r"[\w>]\s*$", colon.group(1))) and not re.search(r"\)\s*$", head)


def matching(text, at):
    """Index of the brace that closes the one at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return len(text) - 1


def functions(text):
    """(first line, last line, name) of each function body of a file, lambdas counted with their function."""
    code, found, start, i, parens = bare(text), [], 0, 0, 0
    while i < len(code):
        c = code[i]
        if c in "()":
            parens += 1 if c == "(" else -1
        elif c == ";" and parens == 0 or c == "}":
            start = i + 1
        elif c == "{":
            head = re.sub(r"^\s*(?:public|private|protected)\s*:", "", code[start:i]).strip()
            opens_function = "(" in head and parens == 0 and not NOT_A_FUNCTION.match(head) and not head.endswith("=")
            if parens > 0 or (opens_function and ends_open_initialiser(head)):
                i = matching(code, i)
            elif opens_function or (head and not NOT_A_FUNCTION.match(head)):
                end = matching(code, i)
                if opens_function:
                    first = code.count("\n", 0, start + len(code[start:i]) - len(code[start:i].lstrip())) + 1
                    name = re.search(r"([~\w:]+|operator\S+)\s*\(", head)
                    found.append((first, code.count("\n", 0, end) + 1, name.group(1) if name else "?"))
                i = end
                start = end + 1
            else:
                start = i + 1
        i += 1
    return found


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0


def main():
    src = pathlib.Path(sys.argv[1])
    files, lengths, complaints = {}, [], []
    for file in sorted(f for f in src.rglob("*") if f.suffix in (".hpp", ".cpp")):
        text = file.read_text(encoding="utf-8")
        lines = text.splitlines()
        name = file.relative_to(src).as_posix()
        files[name] = len(lines)
        for first, last, function in functions(text):
            if any("sizes: table" in line for line in lines[first - 1:first + 2]):
                continue
            lengths.append((last - first + 1, f"{name}:{first} {function}"))
    lines_of = list(files.values())
    longest = max(lengths, default=(0, ""))
    figures = [("file median", statistics.median(lines_of), FILE_MEDIAN), ("file p95", percentile(lines_of, 0.95), FILE_P95),
               ("file longest", max(lines_of), FILE_MAX),
               ("function p95", percentile([n for n, _ in lengths], 0.95), FUNCTION_P95),
               ("function longest", longest[0], FUNCTION_MAX)]
    print(f"{len(files)} files, {sum(lines_of)} lines, {len(lengths)} functions; longest function {longest[1]}")
    for what, value, limit in figures:
        print(f"{what:17} {value:6g} lines, limit {limit}")
        if value > limit:
            complaints.append(f"{what} is {value:g} lines, over {limit}")
    sources = [n for n in files if n.endswith(".cpp") and not n.endswith("_test.cpp")]
    folder, most = max(collections.Counter(n.rpartition("/")[0] for n in sources).items(), key=lambda f: f[1])
    whole = sum(len(WHOLE_STATE.findall(bare((src / n).read_text(encoding="utf-8")))) for n in sources if n.startswith("interp/"))
    for what, value, limit in (("sources of " + folder, most, FOLDER_MAX), ("functions of interp with the whole state", whole, WHOLE_STATE_MAX)):
        print(f"{what}: {value}, limit {limit}")
        if value > limit:
            complaints.append(f"{what}: {value}, over {limit}")
    complaints += [f"{name}: {n} lines, over {FILE_MAX}" for name, n in files.items() if n > FILE_MAX]
    complaints += [f"{where}: {n} lines, over {FUNCTION_MAX}" for n, where in lengths if n > FUNCTION_MAX]
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
