#!/usr/bin/env python3
"""Checks that tools/make_assets.py writes the bundled models, that none of them is inside out, and that docs/models.md
lists them.

test_assets.py SOURCE_FOLDER. What it finds wrong is printed; then it fails.
"""
import json
import math
import struct
import subprocess
import sys
import tempfile
from pathlib import Path


def read_glb(file):
    data = file.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def numbers(document, binary, index):
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    kind, width = {5126: ("f", 4), 5123: ("H", 2)}[accessor["componentType"]]
    parts = {"VEC3": 3, "SCALAR": 1}[accessor["type"]]
    flat = struct.unpack_from(f"<{accessor['count'] * parts}{kind}", binary, view["byteOffset"])
    assert accessor["count"] * parts * width <= view["byteLength"]
    return [flat[i:i + parts] for i in range(0, len(flat), parts)] if parts > 1 else list(flat)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def times_around(point, triangles):
    """How often closed surfaces wind around a point: 1 inside of a solid, 0 outside, -1 inside of one that is turned
    inside out (van Oosterom and Strackee, 1983)."""
    total = 0
    for corners in triangles:
        a, b, c = (minus(corner, point) for corner in corners)
        la, lb, lc = math.sqrt(dot(a, a)), math.sqrt(dot(b, b)), math.sqrt(dot(c, c))
        below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
        total += math.atan2(dot(a, cross(b, c)), below)
    return total / (2 * math.pi)


def triangles_of(file):
    document, binary = read_glb(file)
    triangles = []
    for primitive in document["meshes"][0]["primitives"]:
        points = numbers(document, binary, primitive["attributes"]["POSITION"])
        indices = numbers(document, binary, primitive["indices"])
        triangles += [[points[k] for k in indices[i:i + 3]] for i in range(0, len(indices), 3)]
    return triangles


def row(file):
    """The row of the model in docs/models.md."""
    extras = read_glb(file)[0]["nodes"][0]["extras"]
    digits = 4 if extras["set"] == "bricks" else 2
    size = " × ".join(f"{length:.{digits}f}" for length in (*extras["footprint"], extras["height"]))
    front = "yes" if extras["front"] != "none" else ""
    return f"| `{file.stem}` | {size} | {front} | {'keeps its proportions' if 'keeps_proportions' in extras else ''} |"


def inside_out(triangles):
    """Returns a place where some solid is inside out, looking just behind and before some triangles."""
    for corners in triangles[::max(1, len(triangles) // 6)]:
        out = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        length = math.sqrt(dot(out, out))
        middle = [sum(axis) / 3 for axis in zip(*corners)]
        reach = 1e-4 * math.sqrt(length)
        for side in (-1, 1):
            point = [a + side * reach * b / length for a, b in zip(middle, out)]
            if times_around(point, triangles) < -0.2:
                return point
    return None


def main(source):
    faults, bundled = [], sorted((source / "assets").glob("*.glb"))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, source / "tools/make_assets.py", folder], check=True)
        made = {file.name: file.read_bytes() for file in Path(folder).iterdir()}
    for file in bundled:
        if made.pop(file.name, b"") != file.read_bytes():
            faults.append(f"{file.name}: tools/make_assets.py writes something else")
        if place := inside_out(triangles_of(file)):
            faults.append(f"{file.name}: a solid at {place} is inside out")
    faults += [f"{name}: is missing in assets/" for name in made]
    listed = [line for line in (source / "docs/models.md").read_text().splitlines() if line.startswith("| `")]
    rows = [row(file) for file in bundled]
    faults += [f"docs/models.md: {line}" for line in sorted(set(rows) ^ set(listed))]
    for fault in faults:
        print(fault)
    print(f"{len(bundled)} models")
    return 1 if faults or not bundled else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
