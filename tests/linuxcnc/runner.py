"""Runs one program by obrys or by LinuxCNC's stand-alone interpreter, under the same conditions.

A case's tool table, ini values and parameters are data; they are written to a temporary folder that both get.
"""
import argparse
import dataclasses
import os
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile

REFEREE = shutil.which("rs274") or "/usr/bin/rs274"
REFEREE_HERE = os.access(REFEREE, os.X_OK)
OUTPUT_LIMIT = 400 << 20  # bytes: an endless program must not fill the disk


@dataclasses.dataclass
class Setting:
    """What the machine knows before the program: the files LinuxCNC would read."""
    tools: tuple = ()         # (number, pocket, "Z0.5 D0.25"), a row each; values in inch, as rs274's machine counts
    ini: dict = dataclasses.field(default_factory=dict)   # section -> {name: value}
    parameters: dict = dataclasses.field(default_factory=dict)   # number -> value
    search: str = ""          # folder of subroutines, beside the program


@dataclasses.dataclass
class Run:
    """Exit code (None: no end within the time, or endless output), what was printed, what was said about errors."""
    code: int | None
    out: str
    err: str

    @property
    def refused(self):
        """The line, as text, that rs274 stopped at, and its message; None when it ran to an end."""
        lines = self.err.splitlines()
        if self.code == 0 or self.code is None or "executing" not in lines:
            return None
        lines = lines[lines.index("executing") + 1:]
        return (lines[0], lines[1] if len(lines) > 1 else "") if lines else None


def write_setting(setting, folder, program):
    """The files of the setting as (tools, ini, parameters) paths, None where there is none."""
    folder = pathlib.Path(folder)
    tools = ini = parameters = None
    if setting.tools:
        tools = folder / "case.tbl"
        tools.write_text("".join(f"T{number} P{pocket} {words} ;\n" for number, pocket, words in setting.tools))
    sections = {name: dict(values) for name, values in setting.ini.items()}
    if setting.search:
        sections.setdefault("RS274NGC", {})["SUBROUTINE_PATH"] = str(pathlib.Path(program).parent / setting.search)
    if sections:
        ini = folder / "case.ini"
        ini.write_text("".join(f"[{name}]\n" + "".join(f"{k} = {v}\n" for k, v in values.items()) + "\n"
                               for name, values in sections.items()))
    if setting.parameters:
        parameters = folder / "case.var"
        parameters.write_text("".join(f"{n}\t{v:.6f}\n" for n, v in sorted(setting.parameters.items())))
    return tools, ini, parameters


def limited():
    resource.setrlimit(resource.RLIMIT_FSIZE, (OUTPUT_LIMIT, OUTPUT_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def execute(command, home, seconds, cwd=None):
    """Output goes through a file, so that an endless program meets the limit and not our memory."""
    environment = dict(os.environ, HOME=str(home), LC_ALL="C")
    with tempfile.TemporaryFile(dir=home) as out, tempfile.TemporaryFile(dir=home) as err:
        try:
            code = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err, env=environment, cwd=cwd,
                                  timeout=seconds, check=False, preexec_fn=limited).returncode
        except subprocess.TimeoutExpired:
            code = None
        if out.seek(0, os.SEEK_END) >= OUTPUT_LIMIT:
            code = None
        out.seek(max(0, out.tell() - (32 << 20)) if code is None else 0)
        err.seek(0)
        return Run(code, out.read().decode(errors="replace"), err.read(1 << 20).decode(errors="replace"))


def run_referee(program, setting=None, seconds=20, options=()):
    """rs274 gets a home of its own: it maps $HOME/.tool.mmap, and two of them in one home disturb each other."""
    setting = setting or Setting()
    with tempfile.TemporaryDirectory() as folder:
        tools, ini, parameters = write_setting(setting, folder, program)
        command = [REFEREE, "-g", *options]
        for flag, path in (("-t", tools), ("-i", ini), ("-v", parameters)):
            command += [flag, str(path)] if path else []
        # It looks for subroutines in the folder of the program as it is called: hence cwd.
        path = pathlib.Path(program).resolve()
        return execute([*command, str(path)], folder, seconds, path.parent)


def run_obrys(obrys, program, setting=None, seconds=20, options=()):
    setting = setting or Setting()
    with tempfile.TemporaryDirectory() as folder:
        tools, ini, parameters = write_setting(setting, folder, program)
        command = [str(pathlib.Path(obrys).resolve()), "run", "--canon", "--control", "linuxcnc", *options]
        for flag, path in (("--tools", tools), ("--ini", ini), ("--var", parameters)):
            command += [flag, str(path)] if path else []
        path = pathlib.Path(program).resolve()
        if setting.search:
            command += ["--search", str(path.parent / setting.search)]
        return execute([*command, str(path)], folder, seconds, path.parent)


COUNTER = re.compile(r"^ *[0-9]+ (?=N)")


def calls(text):
    """The printed lines without the counter in front; blank runs and signs of zero stay as they are."""
    return [COUNTER.sub("", line) for line in text.splitlines()]


def arguments(flag):
    """What the checks against the corpus are called with; `flag`: an option of the check's own."""
    parser = argparse.ArgumentParser()
    parser.add_argument("obrys")
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("-v", action="store_true", dest="verbose")
    parser.add_argument(flag, action="store_true")
    return parser.parse_intermixed_args()
