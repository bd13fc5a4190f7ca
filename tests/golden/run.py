#!/usr/bin/env python3
"""Runs golden cases: one file is one fact. tests/golden/README.md describes the format.

usage: run.py --obrys <program> [--update] <case.txt | folder>...
"""
import argparse
import difflib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

HEADER = re.compile(r"^--- (run|env|in|file|stdin|out|err|written|exit)\b[ \t]*(.*)$")
FLAGS = {"crlf", "cp1252", "bom", "repeat", "hex", "no-newline"}
NO_NEWLINE = "\\ no newline at the end\n"
TIMEOUT = 300  # seconds: a hang; under the sanitizers and beside other tests the slowest case takes more than one minute


class BadCase(Exception):
    pass


def parse(text):
    """Sections in order: [keyword, rest of the header, content]."""
    sections = []
    for line in text.splitlines(keepends=True):
        match = HEADER.match(line.rstrip("\r\n"))
        if match:
            sections.append([match.group(1), match.group(2).strip(), ""])
        elif sections:
            sections[-1][2] += line
        elif line.strip():
            raise BadCase("text before the first section")
    if [s[0] for s in sections].count("run") != 1:
        raise BadCase("a case has exactly one '--- run' section")
    return sections


def content_bytes(content, flags):
    """What a file section puts on disk."""
    if "hex" in flags:
        return bytes.fromhex(content)
    if "repeat" in flags:  # {{text}*1000} stands for a thousand times `text`
        content = re.sub(r"\{\{(.*?)\}\*(\d+)\}", lambda m: m.group(1) * int(m.group(2)), content)
    if "no-newline" in flags:
        content = content.rstrip("\n")
    if "crlf" in flags:
        content = content.replace("\n", "\r\n")
    data = content.encode("cp1252" if "cp1252" in flags else "utf-8")
    return (b"\xef\xbb\xbf" if "bom" in flags else b"") + data


def lay_out(sections, folder):
    """Writes the case's files; returns what goes to stdin."""
    stdin = b""
    for keyword, rest, content in sections:
        words = rest.split()
        if keyword == "file":
            name, flags = words[0], words[1:]
        elif keyword in ("in", "stdin"):
            name, flags = "in", words
        else:
            continue
        unknown = set(flags) - FLAGS
        if unknown:
            raise BadCase(f"unknown flag {' '.join(sorted(unknown))}")
        if keyword == "stdin":
            stdin = content_bytes(content, flags)
            continue
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content_bytes(content, flags))
    return stdin


def shown(data, folder):
    """Output as a case shows it: no path of this machine, every line ended."""
    text = data.decode("utf-8", errors="backslashreplace")
    for path in sorted({str(folder), os.path.realpath(folder)}, key=len, reverse=True):
        text = text.replace("file://" + path, "file://<case>").replace(path, "<case>")
    if text and not text.endswith("\n"):
        text += "\n" + NO_NEWLINE
    return "".join("\\" + line if HEADER.match(line) else line for line in text.splitlines(keepends=True))


def execute(obrys, sections):
    """Runs the command in a fresh folder: (out, err, written files by name, exit code)."""
    command = shlex.split(next(s[1] for s in sections if s[0] == "run"))
    if not command or command[0] != "obrys":
        raise BadCase("the command begins with obrys")
    with tempfile.TemporaryDirectory(prefix="golden") as name:
        folder = pathlib.Path(name) / "case"
        folder.mkdir()
        stdin = lay_out(sections, folder)
        environment = {"PATH": os.environ.get("PATH", ""), "HOME": str(folder), "LC_ALL": "C", "COLUMNS": "100"}
        for setting in [s[1] for s in sections if s[0] == "env"]:
            name, equals, value = setting.partition("=")
            if not name or not equals:
                raise BadCase("env says NAME=value")
            environment[name] = value
        for passed_on in ("ASAN_OPTIONS", "UBSAN_OPTIONS", "LLVM_PROFILE_FILE"):
            if passed_on in os.environ:
                environment[passed_on] = os.environ[passed_on]
        done = subprocess.run([obrys] + command[1:], cwd=folder, input=stdin, capture_output=True, timeout=TIMEOUT,
                              env=environment, check=False)
        written = {}
        for name in [s[1] for s in sections if s[0] == "written"]:
            path = folder / name
            written[name] = shown(path.read_bytes(), folder) if path.is_file() else "no such file\n"
        return shown(done.stdout, folder), shown(done.stderr, folder), written, done.returncode


def render(sections, out, err, written, code):
    """The case's text with these results in place of the ones it has."""
    text = ""
    for keyword, rest, content in sections:
        if keyword not in ("out", "err", "written", "exit"):
            text += f"--- {keyword}{'  ' if keyword == 'run' else ' ' if rest else ''}{rest}\n{content}"
    text += f"--- out\n{out}" if out else ""
    text += f"--- err\n{err}" if err else ""
    text += "".join(f"--- written {name}\n{content}" for name, content in written.items())
    return text + f"--- exit {code}\n"


def run_case(obrys, case, update):
    """True where the case holds (or was rewritten)."""
    before = case.read_text(encoding="utf-8")
    sections = parse(before)
    after = render(sections, *execute(obrys, sections))
    if after == before:
        return True
    if update:
        case.write_text(after, encoding="utf-8")
        print(f"rewritten: {case}")
        return True
    sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), after.splitlines(True),
                                               f"{case.name} (expected)", f"{case.name} (is)"))
    return False


def main():
    parser = argparse.ArgumentParser(description="golden cases")
    parser.add_argument("--obrys", required=True, type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--update", action="store_true", help="rewrite the cases; review the diff before committing")
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    cases = [f for c in arguments.cases for f in (sorted(c.rglob("*.txt")) if c.is_dir() else [c])]
    failed = 0
    for case in cases:
        try:
            holds = run_case(arguments.obrys, case, arguments.update)
        except (BadCase, OSError, ValueError, subprocess.TimeoutExpired) as error:
            print(f"{case}: {error}")
            holds = False
        failed += not holds
    print(f"{len(cases)} cases, {failed} failed")
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
