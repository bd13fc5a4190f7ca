"""What the scripts of this folder share: writing a job, having obrys check it, and a box as a mesh."""
import argparse
import contextlib
import json
import pathlib
import resource
import signal
import subprocess
import tempfile

import stl_parts


def toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {toml(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    return str(value)


def box(lo, hi):
    """Triangles of an upright box, facing outwards."""
    corners = [(x, y, z) for z in (lo[2], hi[2]) for x, y in ((lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1]))]
    faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    return [tuple(corners[i] for i in t) for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]


def write(folder, lines, tools, stock, part=None, clamps=(), machine="mill-generic", control="linuxcnc", check=None, more=(), tables=()):
    """A job p.job.toml in `folder`. tools: [(number, keys)]; stock: (lo, hi) or keys; part: triangles; clamps: [keys];
    check: keys of [check]; more: lines for the top of the job, tables: for its end."""
    (folder / "p.ngc").write_text("\n".join(lines) + "\n")
    text = ['program = "p.ngc"', f'control = "{control}"', f'machine = "{machine}"', *more]
    for number, keys in tools:
        text += ["[[tool]]", f"number = {number}"] + [f"{k} = {toml(v)}" for k, v in keys.items()]
    if not isinstance(stock, dict):
        stock = {"box": {"min": list(stock[0]), "max": list(stock[1])}}
    text += ["[stock]"] + [f"{k} = {toml(v)}" for k, v in stock.items()]
    if part is not None:
        stl_parts.write(folder / "part.stl", part)
        text += ["[part]", 'file = "part.stl"']
    for keys in clamps:
        text += ["[[clamp]]"] + [f"{k} = {toml(v)}" for k, v in keys.items()]
    text += ["[check]"] + [f"{k} = {toml(v)}" for k, v in (check or {}).items()]
    text += tables
    (folder / "p.job.toml").write_text("\n".join(text) + "\n")


class Bound(argparse.Action):
    """--seconds: of the processor, not of the clock, so that a busy machine changes no result."""

    most = 600

    def __call__(self, parser, options, value, option=None):
        Bound.most = value


def add_bound(parser):
    parser.add_argument("--seconds", type=int, action=Bound, help="of the processor for one program, then it counts as not judged")


def bounded(command):
    """Runs it for no more than so many seconds of the processor."""
    most = Bound.most
    return subprocess.run(command, capture_output=True, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most + 5)))


def used():
    """Seconds of the processor that all programs took so far."""
    use = resource.getrusage(resource.RUSAGE_CHILDREN)
    return use.ru_utime + use.ru_stime


def check(obrys, folder, *arguments):
    """The result as docs/report-json.md says; one that nothing was checked where there is none."""
    done = bounded([obrys, "check", "--format", "json", *arguments, str(folder / "p.job.toml")])
    if done.returncode == -signal.SIGXCPU:
        return {"verdict": "none", "findings": [], "unchecked": [{"message": f"took more than {Bound.most} s of the processor"}]}
    try:
        return json.loads(done.stdout)
    except ValueError:
        return {"verdict": "none", "findings": [], "unchecked": [{"message": f"exit code {done.returncode}: {done.stderr[-300:]}"}]}


def depths(result, *codes):
    return [f.get("depth_mm", f.get("height_mm", 0.0)) for f in result["findings"] if f["code"] in codes]


@contextlib.contextmanager
def folder_of(keep):
    """A folder for one job: `keep` where it is given, else one that goes again."""
    if keep:
        pathlib.Path(keep).mkdir(parents=True, exist_ok=True)
        yield pathlib.Path(keep)
        return
    with tempfile.TemporaryDirectory() as name:
        yield pathlib.Path(name)
