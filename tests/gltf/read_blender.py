"""blender --background --python-exit-code 1 --python read_blender.py -- FILE.glb...: imports the files and says where Blender
finds other nodes, meshes or extras than they have."""

import json
import sys

import bpy
import numpy

numpy.bool = bool  # Debian 12's Blender asks for it, and its NumPy no longer has it

EPSILON = 1e-6


def document_of(file):
    with open(file, "rb") as opened:
        data = opened.read()
    return json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])


def plain(value):
    """A custom property as the JSON that it was."""
    if hasattr(value, "to_dict"):
        return {name: plain(each) for name, each in value.to_dict().items()}
    if hasattr(value, "to_list"):
        return [plain(each) for each in value.to_list()]
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    if isinstance(value, dict):
        return {name: plain(each) for name, each in value.items()}
    return value


def equal(a, b):
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(equal(a[name], b[name]) for name in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(equal, a, b))
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return abs(a - b) <= EPSILON * max(1, abs(a))
    return a == b


def faults(file):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=file)
    document = document_of(file)
    if len(bpy.data.meshes) != len(document["meshes"]):
        yield f"{len(bpy.data.meshes)} meshes, not {len(document['meshes'])}"
    for node in document["nodes"]:
        found = bpy.data.objects.get(node["name"])
        if found is None:
            yield f"no object {node['name']!r}"
        elif not equal({name: plain(value) for name, value in found.items()}, node.get("extras", {})):
            yield f"other extras of {node['name']!r}: {dict(found.items())}"


found = [f"{file}: {fault}" for file in sys.argv[sys.argv.index("--") + 1:] for fault in faults(file)]
print("\n".join(found + [f"{len(found)} faults"]))
if found:
    sys.exit(1)
