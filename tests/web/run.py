#!/usr/bin/env python3
"""Opens the milling page in a real browser: makes the sample's page, then runs page.mjs on it.

usage: run.py --sample PROGRAM --node NODE --chromium CHROMIUM --packages FOLDER --out FOLDER

Ends with 77 (skipped) and a line that says why where the browser, node or its packages are missing.
"""
import argparse
import pathlib
import subprocess
import sys

SKIPPED = 77


def skip(why):
    print("skipped:", why)
    return SKIPPED


def main():
    parser = argparse.ArgumentParser()
    for name in ("sample", "node", "chromium", "packages", "out"):
        parser.add_argument("--" + name, required=True)
    args = parser.parse_args()
    if not args.node or args.node.endswith("NOTFOUND"):
        return skip("needs node")
    if not args.chromium or args.chromium.endswith("NOTFOUND"):
        return skip("needs chromium")
    if not (pathlib.Path(args.packages) / "node_modules" / "playwright-core").is_dir():
        return skip("needs the packages of web/ with those for tests (OBRYS_PAGE)")
    page, empty = pathlib.Path(args.out) / "sample.html", pathlib.Path(args.out) / "empty.html"
    for call in ([args.sample, str(page)], [args.sample, str(empty), "0", "0", "0"]):
        made = subprocess.run(call, check=False, timeout=120)
        if made.returncode != 0:
            return made.returncode
    script = pathlib.Path(__file__).with_name("page.mjs")
    run = subprocess.run([args.node, str(script), str(page), str(empty), args.chromium, args.packages, args.out], check=False, timeout=850)
    return 0 if run.returncode == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
