"""The interpreter tests of LinuxCNC with expected canonical calls: how each was called, and which cannot be held to them.

Facts from the repository LinuxCNC/linuxcnc, tests/interp/*/test.sh and the files beside (tool tables, ini files), as of
the version whose expected outputs stand in the corpus (2.10~pre, spring 2026). A view says what test.sh did to the output:
"plain" nothing (the counter in front is not compared), "fields" drops the first field and joins the rest by one blank.
"""
import dataclasses

from own_programs import OWN
from runner import Setting


@dataclasses.dataclass
class Part:
    """One call of the interpreter and the expected lines it is held to (all lines, or those below a title)."""
    program: str
    setting: Setting = dataclasses.field(default_factory=Setting)
    title: str = ""           # line of the expected file that the part's lines follow
    refused: bool = False     # rs274 stops with an error
    text: str = ""            # our own program, where the corpus has none or the subroutines only; `program` is its name
    place: str = "rs274"      # folder of the corpus
    nth: int = 0              # the how manieth run of the expected file, from 1; 0: the file holds one


@dataclasses.dataclass
class Case:
    name: str
    parts: tuple
    view: str = "plain"
    only: str = ""            # test.sh keeps lines with this word
    no_minus_zero: bool = False   # test.sh turns -0.0000 into 0.0000
    own_words: bool = False   # our own program: texts are compared by their numbers only
    drop: tuple = ()          # expected lines of stderr, or about files we do not have: regular expressions
    referee: str = ""         # why the installed rs274 (2.9.0~pre1) itself differs from the expected file


def one(name, program, view="fields", setting=None, **more):
    refused = more.pop("refused", False)
    return Case(name, (Part(program, setting or Setting(), refused=refused),), view, **more)


def same(name, program, view="fields"):
    return one(name, program, view)


CAM_TOOLS = ((1, 1, "Z0.5 D0.0625"), (2, 2, "Z0.7 D0.125"), (3, 3, "Z0.5 D0.25"), (4, 4, "Z0.7 D1.0"), (32, 32, "Z0.5 D0.0"))
ZERO_TOOL = Setting(tools=((1, 1, "X0 Y0 Z0"),))
NO_FANUC = Setting(ini={"RS274NGC": {"DISABLE_FANUC_STYLE_SUB": 1}})
WITH_FANUC = Setting(ini={"RS274NGC": {"DISABLE_FANUC_STYLE_SUB": 0}})
SUBS = Setting(search="subs")
STDERR = (r"executing",)

CYCLES = [same(f"{cycle}/{plane}/{retract}", f"{plane}-{retract}-{cycle}.ngc")
          for cycle in ("g81", "g84") for plane in ("g17", "g18", "g19") for retract in ("g98", "g99")]

LEGAL = ("m2", "m02", "m30", "percent")
ILLEGAL = ("end-main-with-eof", "no-m30-before-osub", "sub-after-percent")

CASES = CYCLES + [
    one("abort-hot-comment", "test.ngc", "plain", Setting(ini={"RS274NGC": {"FEATURES": 4}, "A": {"VALUE": "3.14"}}),
        refused=True, drop=STDERR + (r" MixedCase param42=20\.000000.*", r" *\(abort, MixedCase.*")),
    one("cam-nisley", "cam.ngc", "fields", Setting(tools=CAM_TOOLS)),
    same("crazy-paths", "test.ngc"),
    same("do-while-break", "test.ngc"),
    same("flowsnake", "flowsnake.ngc"),
    one("g10/g10-l1-l10", "test.ngc", "fields", ZERO_TOOL, no_minus_zero=True),
    one("g10/g10-l11", "test.ngc", "fields", ZERO_TOOL),
    same("g10/g10-l2-while-active", "test.ngc"),
    one("g10/g10-l20-while-active", "test.ngc", no_minus_zero=True),
    one("g10/g10-with-g92", "test.ngc", no_minus_zero=True),
    one("g71-endless-loop", "g71-endless-loop.ngc",
        referee="2.9 never ends here (G71 with a wrong contour)"),
    one("g71-endless-loop2", "g71-endless-loop2.ngc"),
    one("g71-endless-loop_2", "g71-endless-loop_2.ngc", referee="2.9 never ends here (G71 with a wrong contour)"),
    same("g71-with-g70", "g71-with-g70.ngc"),
    same("inside-corners", "test.ngc"),
    same("inverse-time-with-comp", "inverse.ngc"),
    same("m98m99/02-variables", "test.ngc"),
    Case("m98m99/09-disable-fanuc-subs", (
        Part("test-rs274ngc.ngc", WITH_FANUC, "program: rs274ngc; INI: fanuc"),
        Part("test-rs274ngc.ngc", NO_FANUC, "program: rs274ngc; INI: NO fanuc"),
        Part("test-rs274ngc.ngc", Setting(), "program: rs274ngc; INI: (none)")), "plain", drop=STDERR),
    Case("m98m99/11-main-program-oword",
         tuple(Part(f"test-legal-end-main-with-{t}.ngc", title=f"Legal test end-main-with-{t}:") for t in LEGAL) +
         tuple(Part(f"test-illegal-{t}.ngc", title=f"Illegal test {t}:", refused=True) for t in ILLEGAL), "fields"),
    # The expected file is older than ON_RESET; its counterpart in a running LinuxCNC is not part of it.
    one("m98m99/12-M99-endless-main-program", "test.ngc", drop=(r"N\.* ON_RESET\(\)",)),
    same("m98m99/14-o-expression-call", "test.ngc", "plain"),
    one("machine-coord-params", "test.ngc", only="MESSAGE", no_minus_zero=True,
        referee="2.9 has no #5021 to #5029"),
    Case("nested-sub-error", (Part("main.ngc", SUBS, refused=True, text="o<nested> call [1] [2] [3]\nM2\n"),), "plain",
         drop=(r'N\.* COMMENT\("Test: .*',), referee="2.9 accepts a sub within a called sub"),
    Case("nested-sub-in-file-error",
         (Part("main.ngc", SUBS, refused=True, text="o<sequential> call [7] [8] [9]\nM2\n"),), "plain",
         drop=(r'N\.* COMMENT\("Test: .*',), referee="2.9 finds a numbered sub behind the called one in the same file"),
    same("oword-bug315", "test.ngc"),
    same("oword-bug315-p2", "test.ngc"),
    same("return-value", "test.ngc"),
    one("rotation/abs-pts", "test.ngc", only="MESSAGE"),
    one("rotation/g53", "g53.ngc", "plain", no_minus_zero=True),
    Case("sub-call-from-sub", (Part("main.ngc", SUBS, text="o<caller> call [1] [2] [3]\nM2\n"),), "fields",
         drop=(r'N\.* COMMENT\("Test: .*',)),
    same("subs-follow-main", "test.ngc"),
]

G92_WAS_ON = {5210: 2.0, **{n: 1.0 for n in range(5211, 5220)}}
THREE_RUNS = tuple(Part("main.ngc", Setting(parameters=G92_WAS_ON, ini=ini), text=OWN["g52/g92-offset-persistence"], nth=n)
                   for n, ini in ((1, {"RS274NGC": {"DISABLE_G92_PERSISTENCE": 0}}), (2, {}),
                                  (3, {"RS274NGC": {"DISABLE_G92_PERSISTENCE": 1}})))
PLACE = Setting(ini={"RS274NGC": {"FEATURES": 12}, "PLACE": {"X": 10, "Y": 20, "Z": 30}})
TOOL_2, TOOL_4 = Setting(tools=((2, 2, "Z0.1"),)), Setting(tools=((4, 4, "Z0.7"),))


def own(name, setting=None, view="fields", **more):
    refused = more.pop("refused", False)
    part = Part("main.ngc", setting or Setting(), refused=refused, text=OWN[name])
    return Case(name, (part,), view, own_words=True, **more)


SPECIAL = {
    "g52/g52-g92-interaction": {"view": "plain"},
    "g52/g92-offset-persistence": None,
    "g72-facing": {"setting": TOOL_2}, "g72-missing-iteration": {"setting": TOOL_2}, "g76": {"setting": TOOL_4},
    "iniparam": {"setting": PLACE, "view": "plain", "refused": True},
    "iniparam-failassign": {"setting": PLACE, "view": "plain", "refused": True, "drop": (r"#<_ini.*",)},
    "m19": {"setting": Setting(ini={"RS274NGC": {"FEATURES": 0}})},
    "m98m99/03-error-M98-no-P-word": {"view": "plain", "refused": True},
    "m98m99/04-M98-but-no-sub": {"view": "plain", "refused": True},
    "rotation/g28": {"view": "plain"},
}
SPECIAL.update({name: {"view": "plain"} for name in OWN if name.startswith("good/")})
CASES += [own(name, **(SPECIAL.get(name) or {})) for name in OWN if name != "g52/g92-offset-persistence"]
CASES.append(Case("m98m99/05-M98-loops", (Part("test.ngc", place="fanuc_macro"),), "fields"))
CASES.append(Case("g52/g92-offset-persistence", THREE_RUNS, "plain", own_words=True,
                  referee="2.9 keeps G92 at M30 where its persistence is off"))

# Expected files without a case, and why.
EXCLUDED = {
    "value-returned": "subroutines in Python",
    "python-self": "subroutines in Python",
    "pymove": "subroutines in Python",
    "sequence-number": "M400 remapped; its main program is not at hand",
    "oword-unwind": "only the subroutine is at hand, not the main program",
    "compile": "a C++ program that links the interpreter, no NC program",
    "plug/absolute": "another interpreter, loaded as a plug-in",
}
NO_PROGRAM = {
    "g64-r-planner": "G64 R, of 2.10, that we have no other source for",
    "m98m99/13-named-program": "its program is named by its file",
}

# Cases that obrys does not match yet: name -> reason. One that passes is an error, so that the list stays true.
KNOWN_FAILURES = {
    "nested-sub-error": "a sub within a sub, or behind one in its file, is run as 2.9 does",
    "nested-sub-in-file-error": "a sub within a sub, or behind one in its file, is run as 2.9 does",
    "g76": "G76 is not run",
    "iniparam-failassign": "a configuration value is assigned",
    "m98m99/03-error-M98-no-P-word": "M98 without P does nothing",
    "m19": "M19 is not run",
    "good/good-arc.medium.imperial.center-format.ngc": "arc tolerance is the narrower one",
    "good/good-arc.medium.metric.center-format.ngc": "arc tolerance is the narrower one",
    "m98m99/05-M98-loops": "R of repeated incremental cycles climbs",
    "g52/g92-offset-persistence": "G92 of the parameter file is not in force at the start",
}
