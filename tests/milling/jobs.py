"""What the scripts of this folder share: writing a job, having obrys check it, and a box as a mesh."""
import contextlib
import json
import pathlib
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


def check(obrys, folder, *arguments, timeout=600):
    """The result as docs/report-json.md says; one that nothing was checked where there is none."""
    done = subprocess.run([obrys, "check", "--format", "json", *arguments, str(folder / "p.job.toml")], capture_output=True,
                          text=True, timeout=timeout)
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
