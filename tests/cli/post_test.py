#!/usr/bin/env python3
"""obrys post: what it begins loads cleanly, every shipped post can be tried out, and what is read back otherwise is what
is known to be.

usage: post_test.py OBRYS
"""
import json
import pathlib
import subprocess
import sys
import tempfile

# What the controls read otherwise than it was written, with why. Nothing else may, and each of these must.
KNOWN = json.loads((pathlib.Path(__file__).parent / "post_known.json").read_text(encoding="utf-8"))


def call(obrys, *words, cwd=None):
    return subprocess.run([obrys, "post", *words], capture_output=True, text=True, cwd=cwd, check=False, timeout=120)


def main():
    obrys = str(pathlib.Path(sys.argv[1]).resolve())
    faults = []
    posts = json.loads(call(obrys, "list", "--format", "json").stdout)["posts"]
    with tempfile.TemporaryDirectory() as folder:
        for post in posts:
            name = post["name"]
            file = f"{name}.toml"
            made = call(obrys, "new", "Mine", "--extends", name, "-o", file, cwd=folder)
            if made.returncode != 0:
                faults.append(f"new --extends {name}: {made.stderr}")
            if call(obrys, "new", "Mine", "-o", file, cwd=folder).returncode != 2:
                faults.append(f"new wrote over {file}")
            if name == "canon":
                continue
            shipped = call(obrys, "check", name, "--format", "json")
            own = call(obrys, "check", file, "--format", "json", cwd=folder)
            if shipped.returncode == 2 or own.returncode != shipped.returncode:
                faults.append(f"check {name}: {shipped.returncode} {shipped.stderr}, own {own.returncode} {own.stderr}")
                continue
            result, mine = json.loads(shipped.stdout), json.loads(own.stdout)
            if result["samples"] != mine["samples"]:
                faults.append(f"check {name}: a post that changes nothing does not do the same")
            found = {s["name"] for s in result["samples"] if s["read_back"] in ("differs", "unclear")}
            known = set(KNOWN.get(name, {}))
            faults += [f"{name}: {sample} is read back otherwise" for sample in sorted(found - known)]
            faults += [f"{name}: {sample} is said to be read back otherwise and is not" for sample in sorted(known - found)]
            expected = 3 if not result["has_reader"] or result["unclear"] else 1 if result["differs"] else 0
            if shipped.returncode != expected:
                faults.append(f"check {name}: exit code {shipped.returncode}, not {expected}")
            page = call(obrys, "preview", name, "--format", "html")
            if page.returncode != 0 or "<h2>motion.linear</h2>" not in page.stdout or "http" in page.stdout:
                faults.append(f"preview {name}: {page.returncode} {page.stderr}")
    print("\n".join(faults))
    return 1 if faults or len(posts) < 11 else 0


if __name__ == "__main__":
    sys.exit(main())
