#!/usr/bin/env python3
"""glTF files of obrys, judged by Khronos' validator: neither errors nor warnings.

usage: gltf_validator_test.py <mesh_samples>

Skipped (77) without node or its package gltf-validator (in a folder named in NODE_PATH: the build fetches it).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

JUDGE = """
const fs = require('fs'), validator = require('gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))
  .then(report => console.log(JSON.stringify(report)));
"""


def main():
    here = pathlib.Path(__file__).parent
    node = shutil.which("node")
    found = node and subprocess.run([node, "-e", "require('gltf-validator')"], cwd=here, check=False,
                                    stderr=subprocess.DEVNULL).returncode == 0
    if not found:
        print("skipped: needs node with the package gltf-validator")
        sys.exit(77)
    failed = False
    with tempfile.TemporaryDirectory(prefix="obrys-mesh") as folder:
        subprocess.run([sys.argv[1], folder], check=True, stdout=subprocess.DEVNULL)
        for file in sorted(pathlib.Path(folder).glob("*.glb")):
            done = subprocess.run([node, "-e", JUDGE, str(file)], cwd=here, check=True, text=True,
                                  stdout=subprocess.PIPE)
            issues = json.loads(done.stdout)["issues"]
            said = [f"{m['code']} {m['message']} {m.get('pointer', '')}" for m in issues["messages"]]
            print(f"{file.name}: {issues['numErrors']} errors, {issues['numWarnings']} warnings", *said, sep="\n  ")
            failed |= issues["numErrors"] + issues["numWarnings"] > 0
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
