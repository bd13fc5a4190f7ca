#!/usr/bin/env python3
"""Holds the page's script to its types: tsc over what the build copied. Skipped (77) without node or typescript.

usage: types.py --node NODE --packages FOLDER
"""
import argparse
import pathlib
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser()
    for name in ("node", "packages"):
        parser.add_argument("--" + name, required=True)
    args = parser.parse_args()
    folder = pathlib.Path(args.packages)
    compiler = folder / "node_modules" / "typescript" / "lib" / "tsc.js"
    if not args.node or args.node.endswith("NOTFOUND") or not compiler.is_file() or not (folder / "src").is_dir():
        print("skipped: needs node and the packages of web/ with those for tests (OBRYS_PAGE)")
        return 77
    return subprocess.run([args.node, str(compiler), "--noEmit"], cwd=folder, check=False, timeout=200).returncode


if __name__ == "__main__":
    sys.exit(main())
