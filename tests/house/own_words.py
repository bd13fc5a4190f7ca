#!/usr/bin/env python3
"""Messages speak the words of the control whose program is read: over all golden cases of a control no word of another one stands in what was said.

usage: own_words.py GOLDEN
"""
import pathlib
import re
import sys

# Words that a control does not have, as they would stand in a message.
FOREIGN = {
    "heidenhain": ["zero offset", r"\bT\d+ D\d", "CR=", "AR=", "DIAMON", "DIAMOF", "GUD", "G4[123]", "G5[4-9]", "G505", "CUT2D", "R parameter", "MD ?[0-9]", r"\$[A-Z]+_", "SPF", "MPF", "O-number", "#[0-9]", "G43 H"],
    "sinumerik": [r"\bDR\b", r"DR[+-]", "FMAX", "LBL", "TOOL CALL", "CYCL DEF", r"\bpreset", r"\bR[LR]\b", "M91", "Q parameter", "BLK FORM", "END PGM", "G43", "#[0-9]", "G10", "datum shift", r"\bPA\b", r"\bPR\b"],
}
SAID = re.compile(r"^(?:\S+:\d+:\d+: )?(?:error|warning|note): (.*)|^  (remedy: .*)")


def messages(text):
    """What obrys said, without the program's own lines, which stand below it."""
    said = text.split("\n--- out\n", 1)[-1] if "\n--- out\n" in text else text.split("\n--- err\n", 1)[-1]
    for line in said.splitlines():
        if m := SAID.match(line):
            yield (m.group(1) or m.group(2)).split(" [")[0]


def quoted(message, text):
    """The message without what it repeats of the program."""
    program = text.split("\n--- out\n", 1)[0].split("\n--- err\n", 1)[0]
    return " ".join(w for w in message.split(" ") if w.strip(",:;.()'\"") not in program)


def main():
    golden, faults = pathlib.Path(sys.argv[1]), []
    for control, foreign in FOREIGN.items():
        count = 0
        for case in sorted((golden / control).glob("*.txt")):
            text = case.read_text(encoding="utf-8")
            for message in messages(text):
                count += 1
                for word in foreign:
                    if re.search(word, quoted(message, text)):
                        faults.append(f"{case.relative_to(golden)}: {word!r} is no word of this control: {message}")
        if count < 100:
            faults.append(f"{control}: only {count} messages read")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
