#!/usr/bin/env python3
"""No message names a word that the control of its program does not have: all messages that golden cases of FANUC, Haas
and LinuxCNC programs print are held to a list of other controls' words."""

import pathlib
import re
import sys

# SINUMERIK's, then HEIDENHAIN's; none of them is a word of an RS-274 control.
FOREIGN = re.compile(
    r"\b(?:CR=|AR=|TURN=|I1=|RP=|AP=|AC\(|IC\(|DIAMON|DIAMOF|DIAM90|SUPA|TRANS|ATRANS|AROT|CYCLE\d+|ANG=|GOTOF|GOTOB|MCALL|"
    r"CUT2DF?|NORM|KONT|G500|\$TC_DP\d*|\$P_\w+|"
    r"DR[+-]?(?= |\b)|RL|RR|R0|M91|M92|TOOL CALL|TOOL DEF|CYCL DEF|CYCL CALL|BLK FORM|LBL|FMAX|F AUTO|PLANE [A-Z]+|FN \d+|"
    r"TOOL\.T)(?![\w])|\b(?:CR|AR)=|\bT0\b"
)
# What a comparison quotes of the other program, which has its own control's words.
QUOTED = re.compile(r"(?<=the other has )[^\[]*")
MESSAGE = re.compile(r"^(?:[^:]*:\d+:\d+: |  )?(?:error|warning|note): |^\s+remedy: |^  \S+:\d+:\d+: ")
CONTROL = re.compile(r"--control (?:fanuc|haas|linuxcnc)|^control = \"(?:fanuc|haas|linuxcnc)\"|^--- file \S+\.ngc", re.M)


def messages(text):
    """The lines that tell something, without what they quote from the program."""
    section = ""
    for line in text.splitlines():
        if line.startswith("--- "):
            section = line.split()[1]
        elif section in ("out", "err") and MESSAGE.match(line):
            yield line


def main(root):
    found = 0
    for path in sorted(root.joinpath("tests", "golden").rglob("*.txt")):
        text = path.read_text(encoding="utf-8", errors="replace")
        if not CONTROL.search(text):
            continue
        source = text.split("--- out")[0]
        for line in messages(text):
            for hit in FOREIGN.finditer(QUOTED.sub("", line)):
                word = hit.group(0)
                if word in source:  # the program's own
                    continue
                print(f"{path.relative_to(root)}: {word!r} in: {line.strip()}")
                found += 1
    print(f"{found} foreign words")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2]))
