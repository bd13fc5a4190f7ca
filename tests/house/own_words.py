#!/usr/bin/env python3
"""Messages speak the words of the control whose program is read.

Over all golden cases: no word of another control stands in what was said of a control's program. Over the sources: no
message of a stage that serves one control has a word of another one, and what the stages that serve all of them say
with a control's word has its line for the others in driver/wording.cpp, or stands in `ON_PURPOSE`.

usage: own_words.py GOLDEN [SOURCE]
"""
import pathlib
import re
import sys

# Words that each control's programmers write and read, as they would stand in a message.
KLARTEXT = [r"\bDR\b", r"\bDR[+-]", r"\bR[LR]\b", r"\bFMAX\b", r"\bF ?AUTO\b", r"\bLBL\b", r"TOOL (CALL|DEF)", r"CYCL (DEF|CALL)", r"BLK FORM",
            r"\b(END|BEGIN) PGM", r"Q parameter", r"\bpresets?\b", r"datum shift", r"\bM9[12]\b(?! \()", r"\bCC\b", r"\bAPPR\b", r"\bDEP\b", r"\bPLANE\b",
            r"\bP[AR]\b", r"GLOBAL DEF", r"PATTERN DEF", r"SEL (TABLE|PATTERN)", r"CONTOUR DEF", r"DIN/ISO", r"\bR0\b"]
SIEMENS = [r"\bDIAM(ON|OF|90)\b", r"\bCR=", r"\bAR=", r"\bANG=", r"\bA?(TRANS|ROT|SCALE|MIRROR)\b", r"\bSUPA\b", r"\bLIMS\b", r"\bGOTO[FB]\b", r"\bCYCLE\d",
           r"\bMCALL\b", r"\bGUD\b|global user data", r"\$[A-Z]+_", r"\bMD ?\d", r"\.?\b[SM]PF\b", r"\bCUT2D", r"\bSETMS\b", r"\bSPOS\b", r"R parameter",
           r"\bPROC\b", r"\bM17\b", r"\bRET\b", r"\bRND\b", r"\bG50[05]\b", r"\bG599\b", r"\bCTOL\b", r"\bADIS", r"with T and D\b",
           r"\b(TURN|I1|RP|AP)=", r"\b[AI]C\(", r"\b(NORM|KONT)\b", r"\bDIA[CR]"]
EDGES = [r"\bT\d+ D\d", r"\bT0 D0\b", r"\(D0\)"]
MACRO = [r"\bO-?number", r"(?<!&)#\d", r"parameter \d{4}\b", r"\bO\d{4}\b"]
LINUXCNC = [r"#<", r"\bo-word", r"\bendsub\b", r"LinuxCNC", r"\bG43\.1\b", r"\bG41\.1\b", r"\bG92\.[123]\b"]
G_WORDS = [r"(?<!%)\bG\d+"]
FANUC_CODES = [r"\bT\d{4}\b", r"\bG43 H", r"\bG54\.1\b", r"\bG10\b"]
BITS = [r"\bbit [A-Z0-9]+ of parameter", r"\bparameters? \d{4}\b"]

FOREIGN = {  # ROT, TRANS DATUM and MIRROR IMAGE are HEIDENHAIN's, too
    "heidenhain": [w for w in SIEMENS if "TRANS" not in w] + EDGES + MACRO + LINUXCNC + FANUC_CODES + BITS + ["zero offset"] + G_WORDS,
    "sinumerik": KLARTEXT + MACRO + LINUXCNC + FANUC_CODES + BITS,
    "linuxcnc": KLARTEXT + SIEMENS + EDGES + FANUC_CODES[:1] + FANUC_CODES[2:3] + BITS[:1],
    "fanuc": KLARTEXT + SIEMENS + EDGES + LINUXCNC,
    "haas": KLARTEXT + SIEMENS + EDGES + LINUXCNC + BITS,
    "acramatic": KLARTEXT + [w for w in SIEMENS if not w.startswith(r"\$")] + EDGES + MACRO + LINUXCNC + FANUC_CODES[1:] + BITS,
    "nc-470": KLARTEXT + SIEMENS + EDGES + MACRO + LINUXCNC + FANUC_CODES + BITS,
    "apt": [w for w in KLARTEXT + SIEMENS if "TRANS" not in w] + EDGES + MACRO + LINUXCNC + FANUC_CODES + BITS + G_WORDS,
    "fusion": [w for w in KLARTEXT + SIEMENS if "PLANE" not in w] + EDGES + MACRO + LINUXCNC + FANUC_CODES + BITS + G_WORDS,
}
# Cutter locations have no such words: what the stages for all controls say with them cannot come up, or is seen in
# the golden cases.
BY_CASES_ALONE = ["apt", "acramatic", "fusion", "nc-470"]
# Messages with a word of another control on purpose: how they begin, and why.
ON_PURPOSE = {
    "O1002.nc, line ": "a file that obrys translate writes for the target",
    "Klartext begins with BEGIN PGM, DIN/ISO with": "obrys fmt is given a text that is none of HEIDENHAIN's: what one begins with",
    "[variables] #<_GAP> is no variable of this control": "repeats what the job wrote",
    "parameter number 5000 lies outside R0 to R999": "R0 is the control's first R parameter",
    "G10 to G16 move in polar coordinates": "DIN/ISO's own G codes, in a DIN/ISO program",
    "it is the radius of G02, G03": "DIN/ISO's own G codes, in a DIN/ISO program",
    " mm above and beside the zero)": "the text of the program that obrys calibrate translates",
    "G2 X0 Y0 I": "the same",
    "line 7: cycles first differs at move 2: the other has cycle tap-rigid": "the other program has its own control's words",
}
# Messages of stages for all controls that only programs of these can bring about: how they begin, and which.
OF_ONE = {
    "write G17 again before the next straight move": ["sinumerik"],  # Traits::length_axis_setting
    "program the arc's plane before it": ["sinumerik", "linuxcnc", "fanuc", "haas"],  # HEIDENHAIN: CC, not I J K of the block
    "the circle is in force from a block before": ["linuxcnc", "fanuc", "haas", "sinumerik"],  # modal arcs by letters
    "coordinates without I, J, K and R while G2": ["fanuc"],  # Traits::line_without_centre
    "write G1, or the arc's radius or centre": ["fanuc"],
    "write it in the block of a thread (G33": ["sinumerik"],  # SF=
    "the sense of rotation DR is missing": ["heidenhain"],  # CR and CT alone have one
    "if it is global user data (GUD)": ["sinumerik"],  # NamedVariables::plain
    "the program ends before the LBL 0": ["heidenhain"],  # labels that are called
    "define one with CYCL DEF": ["heidenhain"],  # CYCL CALL
    "position with R0 before": ["heidenhain"],
    " needs the number of a preset": ["heidenhain"],
    "add it to the preset table": ["heidenhain"],
    "the named parameter #<": ["linuxcnc"],  # NamedVariables::in_angles
    "assign it before it is read, or ask with EXISTS": ["linuxcnc"],
    " or #<name>": ["linuxcnc"],
    "the fixed point of G75": ["sinumerik"],
    "the cutting edge position ($TC_DP2) of a": ["sinumerik"],
    "G94 and G95 end the constant": ["sinumerik", "linuxcnc", "fanuc", "haas"],  # G96
    "write G96 behind them": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "L (orientation of a lathe tool)": ["linuxcnc"],  # G41.1 L
    "end radius compensation (R0)": ["heidenhain"],  # a pole outside of the working plane (CC X Z)
    "write G40 before it": ["sinumerik", "linuxcnc", "fanuc", "haas"],  # Traits::compensation_holds_plane, compensation_holds_move
    "G4 says neither": ["sinumerik", "linuxcnc", "fanuc", "haas"],  # cycle 9 of HEIDENHAIN is another statement
    "the dwell of G4": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "behind G80 the axes": ["fanuc", "haas"],
    "write G0 or G1 behind G80": ["fanuc", "haas"],
    "axis words without a motion: G80": ["linuxcnc"],
    "write G0 or G1 before them": ["linuxcnc"],
    "by what the machine's data allow": ["sinumerik"],  # G642 … G645
    "G64 with": ["linuxcnc"],
    "write G64 P": ["linuxcnc"],
    "with CUT2D": ["sinumerik"],
    "write CUT2DF": ["sinumerik"],
    "polar coordinates are for the plane of G17": ["linuxcnc"],
    "write X, Y and Z, or G17": ["linuxcnc"],
    "polar coordinates that add (G91)": ["linuxcnc"],
    "move away from the origin first": ["linuxcnc"],
    "write CC with its coordinates": ["heidenhain"],  # Traits::needs_pole
    "write PR and PA, or L, C or CT": ["heidenhain"],  # LP, CP, CTP
    "only G0 and G1 move in machine": ["linuxcnc", "fanuc", "haas"],  # Traits::refuses_unready
    "write G0 or G1 in the block": ["linuxcnc", "fanuc", "haas"],
    "machine coordinates cannot be incremental": ["linuxcnc", "fanuc", "haas"],
    "write G90 before the block": ["linuxcnc", "fanuc", "haas"],
    " in inverse time mode (G93)": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "write G94 before it": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "radius compensation works in G17 and G18": ["linuxcnc"],
    "add M30; in a subprogram M17": ["sinumerik"],  # Traits::text_may_end
    "write the code it belongs to": ["linuxcnc", "fanuc", "haas"],
    "R turns the system in force": ["linuxcnc"],
    "cancel the shift before (G92.1)": ["linuxcnc"],
    "the spindle keeps the speed that G96": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "which spindle SETMS": ["sinumerik"],
    "): S, M3, M4, M5, G95 and G96": ["sinumerik"],
    "SETMS without a number": ["sinumerik"],
    "F AUTO: TOOL CALL": ["heidenhain"],
    "write F in TOOL CALL": ["heidenhain"],
    "TOOL DEF ": ["heidenhain"],
    " defines no global user data": ["sinumerik"],  # Control::definition_suffixes
    "write SEL TABLE": ["heidenhain"],
    "no tools are given: those of LinuxCNC's": ["linuxcnc"],  # Control::interpreter_tools
    "bit CCV of parameter": ["fanuc"],  # of the table that Haas has another one for
    "bit TOS of parameter": ["fanuc"],  # Traits::length_word_setting
    "bit CCC of parameter": ["fanuc"],  # Traits::outer_corner_setting
    "bit LRP of parameter": ["fanuc"],  # Traits::rapids
    "bit CIR of parameter": ["fanuc"],
    " does not apply: this control begins with radii": ["linuxcnc"],
    "write G7 in the program": ["linuxcnc"],
    "G53 with incremental coordinates": ["fanuc", "haas"],
    "write G90 before it, or absolute coordinates": ["fanuc", "haas"],
    " is one number for tool and offset": ["fanuc", "haas"],
    "bit NAT of parameter": ["fanuc"],  # Traits::angles_from_zero
    "as with bit DPI of parameter": ["fanuc"],
    "C of straight blocks is taken as a chamfer (bit": ["fanuc"],
    "the depth of cut is not programmed: 1 mm": ["fanuc"],
    "the escape is not programmed: 0.5 mm": ["fanuc"],
    "relief and number of passes that are not programmed are taken as 0 and 1 (parameters": ["fanuc"],
    "after a peck the tool goes back by 1 mm": ["fanuc"],
    "what is not programmed is taken as: one finishing pass": ["fanuc"],
    "ANG= with ": ["sinumerik"],  # the table has what follows, too
    " until DIAMOF": ["sinumerik"],  # Traits::has_diameter_words
    ", or write DIAMON": ["sinumerik"],
}
# Stages for all controls whose messages programs of these alone can bring about.
FILES_OF = {
    "interp/setup/assign_system.cpp": ["sinumerik"],
    "interp/cycles/canned.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/cycles/circle_pocket.cpp": ["haas"],
    "interp/setup/compensation_rules.cpp": ["heidenhain"],
    "interp/cycles/contour_cycle.cpp": ["heidenhain"],
    "interp/calls/control_cycle.cpp": ["sinumerik"],
    "interp/cycles/cycle_places.cpp": ["heidenhain"],
    "interp/cycles/cycle_values.cpp": ["heidenhain"],
    "interp/calls/frame_statement.cpp": ["sinumerik"],
    "interp/stream/frame_words.cpp": ["sinumerik"],
    "interp/moves/line_angle.cpp": ["sinumerik", "fanuc", "haas"],
    "interp/setup/offset_numbers.cpp": ["fanuc", "haas"],
    "interp/cycles/pattern.cpp": ["heidenhain"],
    "interp/moves/plane.cpp": ["heidenhain"],
    "interp/setup/set_data.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/setup/tool_against_job.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/flow/special.cpp": ["heidenhain"],
    "interp/moves/approach.cpp": ["heidenhain"],
    "interp/moves/spline.cpp": ["linuxcnc"],
    "interp/calls/surface.cpp": ["fanuc", "haas"],
    "interp/stream/surface_moves.cpp": ["fanuc", "haas"],
    "interp/moves/swivel.cpp": ["heidenhain"],
    "interp/setup/tilted_axes.cpp": ["heidenhain"],
    "interp/moves/thread.cpp": ["sinumerik", "linuxcnc", "fanuc", "haas"],
    "interp/setup/tool_length.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/stream/tool_tip.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/cycles/transform.cpp": ["heidenhain"],
    "interp/setup/shift.cpp": ["heidenhain"],
    "interp/cycles/turned_contour.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/cycles/turning.cpp": ["linuxcnc", "fanuc", "haas"],
    "interp/cycles/turning_definition.cpp": ["linuxcnc", "fanuc", "haas"],
    "read/rs274/o_word.cpp": ["linuxcnc"],
    "read/rs274/structure.cpp": ["linuxcnc"],
    "read/rs274/sub.cpp": ["linuxcnc"],
}
SUFFIXES = {"mpf": "sinumerik", "spf": "sinumerik", "arc": "sinumerik", "h": "heidenhain", "i": "heidenhain", "ngc": "linuxcnc"}
SAID = re.compile(r"^(?:\S+:\d+:\d+: )?(?:error|warning|note): (.*)|^  (?:\S+:\d+:\d+: )?(\S.*) \[[a-z-]+\]$|^ +(remedy: .*)")
LEAST = {"apt": 20, "fusion": 20, "nc-470": 10, "acramatic": 20, "heidenhain": 300, "sinumerik": 300, "fanuc": 300, "linuxcnc": 100, "haas": 30}


def control_of(case, text):
    """The control whose program a case reads; None where it reads none."""
    head = text.split("\n--- out\n", 1)[0]
    if named := re.search(r"--control (nc-470|\w+)", text.splitlines()[0]) or re.search(r"^control = \"(nc-470|\w+)", head, re.M):
        return named.group(1) if named.group(1) in FOREIGN else None
    if read := re.search(r"(?:is read as|named: read as|is: it is read as) (nc-470|\w+)", text):
        return read.group(1)
    for suffix in re.findall(r"^--- file \S+?\.(\w+)", text, re.M) + re.findall(r"^program = \"\S+?\.(\w+)\"", text, re.M):
        if suffix.lower() in SUFFIXES:
            return SUFFIXES[suffix.lower()]
    return case.parent.name if case.parent.name in FOREIGN else None


def messages(text):
    """What obrys said, without the program's own lines, which stand below it."""
    parts = re.split(r"^--- (?:out|err)\b.*\n", text, flags=re.M)[1:]
    for line in "\n".join(parts).splitlines():
        if m := SAID.match(line):
            yield re.sub(r" \[[a-z-]+\]$", "", next(g for g in m.groups() if g))


def quoted(message, text):
    """The message without what it repeats of the program."""
    program = re.split(r"^--- (?:out|err)\b", text, flags=re.M)[0]
    return " ".join(w for w in message.split(" ") if w.strip(",:;.()'\"") not in program)


def on_purpose(message):
    return any(message.removeprefix("remedy: ").startswith(begin) for begin in ON_PURPOSE)


def foreign_in(control, message, iso=False):
    """The first word of another control in a message."""
    if control == "heidenhain":  # what holds for its other way of writing is told as that
        message = re.sub(r"\(?DIN/ISO: [^);]*", "", message)
    for word in FOREIGN[control]:
        if iso and word in G_WORDS:
            continue
        if m := re.search(word, message):
            return m.group(0)
    return None


def check_cases(golden):
    faults, count, unknown = [], dict.fromkeys(FOREIGN, 0), 0
    for case in sorted(golden.rglob("*.txt")):
        text = case.read_text(encoding="utf-8")
        control = control_of(case, text)
        if control is None:
            unknown += 1
            continue
        iso = control == "heidenhain" and "BEGIN PGM" not in text
        for message in messages(text):
            count[control] += 1
            if not on_purpose(message) and (word := foreign_in(control, quoted(message, text), iso)):
                faults.append(f"{case.relative_to(golden)}: {word!r} is no word of {control}: {message}")
    faults += [f"{c}: only {n} messages read" for c, n in count.items() if n < LEAST[c]]
    return faults


LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
PHRASE = re.compile(r'Phrase\{("[^"]*"), ([^{}]*?), ((?:"(?:[^"\\]|\\.)*"\s*)+|\w+)\}')
STAGES = ("interp", "path", "cycles", "check", "cl", "program", "driver")


def joined(literals):
    return "".join(LITERAL.findall(literals))


def literals_of(file):
    """The messages in a source file: literals of at least three words."""
    text = re.sub(r"^\s*(?://|#include).*$|\s//.*$", "", file.read_text(encoding="utf-8"), flags=re.M)
    text = re.sub(r'R"(\w*)\(.*?\)\1"', "", text, flags=re.S)
    for match in LITERALS.finditer(text):
        if joined(match.group(0)).count(" ") >= 2:
            yield joined(match.group(0))


def phrases_of(source):
    """The table of driver/wording.cpp: control, general text, the control's own."""
    text = (source / "driver/wording.cpp").read_text(encoding="utf-8")
    named = {name: joined(value) for name, value in re.findall(r'std::string_view (\w+) =\s*((?:"[^"]*"\s*)+);', text)}
    value = lambda words: joined(words) if '"' in words else named[words.strip()]
    return [(joined(c), value(general), value(own)) for c, general, own in PHRASE.findall(text)]


def controls_of(source, file):
    """The controls whose programs a stage serves."""
    name = file.relative_to(source).as_posix()
    if name in FILES_OF:
        return FILES_OF[name]
    if "/sinumerik/" in name or "/heidenhain/" in name:
        return [name.split("/")[1]]
    if "/rs274/" in name:
        return ["linuxcnc"] if "linuxcnc" in name else ["acramatic"] if "acramatic" in name else ["fanuc", "haas"] if "fanuc" in name else ["linuxcnc", "fanuc"]
    if "/apt/" in name:
        return ["apt"]
    if "/fusion/" in name:
        return ["fusion"]
    return [c for c in FOREIGN if c not in BY_CASES_ALONE]


def check_sources(source):
    faults, phrases = [], phrases_of(source)
    for control, _, own in phrases:
        if word := foreign_in(control, own):
            faults.append(f"driver/wording.cpp: {word!r} is no word of {control}: {own}")
    folders = [*(source / s for s in STAGES), *source.glob("dialect/*"), *source.glob("read/*")]
    for file in sorted(f for folder in folders for f in folder.rglob("*.?pp")):
        if re.search(r"_test\.|testing\.|wording\.cpp|/control\.cpp|/guess\.cpp|_table\.cpp|likelihood", file.as_posix()):
            continue
        iso = bool(re.search(r"/iso|g_codes", file.as_posix()))
        for message in literals_of(file):
            only = next((c for begin, c in OF_ONE.items() if message.startswith(begin)), None)
            for control in only or controls_of(source, file):
                said = message
                for _, general, own in (p for p in phrases if p[0] == control):
                    said = said.replace(general, own)
                if not on_purpose(said) and (word := foreign_in(control, said, iso)):
                    faults.append(f"{file.relative_to(source)}: {word!r} is no word of {control}: {said}")
    return faults


def main():
    faults = check_cases(pathlib.Path(sys.argv[1]))
    if len(sys.argv) > 2:
        faults += check_sources(pathlib.Path(sys.argv[2]))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
