#!/usr/bin/env python3
"""3MF files of obrys, taken apart by zipfile and ElementTree and held against the facts their maker prints.

usage: three_mf_test.py <mesh_samples>
"""
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
import zipfile

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
MODEL_TYPE = "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"


def expect(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def volume(vertices, triangles):
    total = 0.0
    for t in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertices[i] for i in t)
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6


def open_model(path):
    """The model part, found as the packaging rules say: from the relations' target and its content type."""
    with zipfile.ZipFile(path) as package:
        expect(package.testzip() is None, f"{path.name}: checksums")
        types = {e.get("Extension"): e.get("ContentType") for e in ET.fromstring(package.read("[Content_Types].xml"))}
        relation = ET.fromstring(package.read("_rels/.rels"))[0]
        expect(relation.get("Type") == "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel", "relation")
        target = relation.get("Target").lstrip("/")
        expect(types.get(target.rsplit(".", 1)[1]) == MODEL_TYPE, "content type of the model")
        return ET.fromstring(package.read(target))


def check_colours(model, mesh, colours):
    bases = model.findall(f"{CORE}resources/{CORE}basematerials/{CORE}base")
    expect(len(bases) == colours, f"{colours} base materials")
    used = {}
    for triangle in mesh.iter(f"{CORE}triangle"):
        if triangle.get("pid"):
            expect(triangle.get("pid") == "1", "a triangle names the material group")
        colour = bases[int(triangle.get("p1", "0"))].get("displaycolor")
        used[colour] = used.get(colour, 0) + 1
    expect(used == {"#28A03C": 360, "#C81E28": 40 * 2 * 19, "#0950FF": 12}, f"triangles by colour: {used}")


def check(path, vertices, triangles, colours, size):
    model = open_model(path)
    expect(model.get("unit") == "millimeter", "unit")
    items = model.findall(f"{CORE}build/{CORE}item")
    objects = {o.get("id"): o for o in model.findall(f"{CORE}resources/{CORE}object")}
    if triangles == 0:
        expect(not items and not objects, "nothing holds no object")
        return
    mesh = objects[items[0].get("objectid")].find(f"{CORE}mesh")
    points = [tuple(float(v.get(c)) for c in "xyz") for v in mesh.iter(f"{CORE}vertex")]
    corners = [tuple(int(t.get(c)) for c in ("v1", "v2", "v3")) for t in mesh.iter(f"{CORE}triangle")]
    expect(len(points) == vertices and len(corners) == triangles, f"{path.name}: numbers")
    expect(all(len(set(t)) == 3 for t in corners), "three different corners")
    expect(abs(volume(points, corners) - size) < 1e-3, f"volume {volume(points, corners)}, not {size}")
    if colours:
        check_colours(model, mesh, colours)


def main():
    with tempfile.TemporaryDirectory(prefix="obrys-mesh") as folder:
        facts = subprocess.run([sys.argv[1], folder], check=True, text=True, stdout=subprocess.PIPE).stdout
        for line in facts.splitlines():
            name, vertices, triangles, colours, size = line.split()
            check(pathlib.Path(folder) / f"{name}.3mf", int(vertices), int(triangles), int(colours), float(size))
            print(f"ok: {name}.3mf")


if __name__ == "__main__":
    main()
