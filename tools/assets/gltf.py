"""Writes a model as a .glb: the same model gives the same bytes everywhere.

Coordinates are rounded before they become 32-bit floats, for the sines of processors differ in the last bit.
"""
import json
import struct


def _linear(part):
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


def _material(surface):
    color = [round(_linear(part), 6) for part in surface.color]
    material = {"name": surface.name,
                "pbrMetallicRoughness": {"baseColorFactor": color + [surface.opacity],
                                         "metallicFactor": surface.metallic, "roughnessFactor": surface.roughness}}
    if surface.glow:
        material["emissiveFactor"] = [round(part * surface.glow, 6) for part in color]
    if surface.opacity < 1:
        material["alphaMode"] = "BLEND"
    return material


class _Buffer:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, data, accessor, target):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), "target": target})
        self.bytes += data
        self.accessors.append({"bufferView": len(self.views) - 1, **accessor})
        return len(self.accessors) - 1

    def vectors(self, points, with_bounds):
        data = b"".join(struct.pack("<3f", *point) for point in points)
        accessor = {"componentType": 5126, "count": len(points), "type": "VEC3"}
        if with_bounds:
            numbers = list(struct.iter_unpack("<3f", data))
            accessor.update({"min": [min(axis) for axis in zip(*numbers)], "max": [max(axis) for axis in zip(*numbers)]})
        return self.add(data, accessor, 34962)

    def indices(self, indices):
        accessor = {"componentType": 5123, "count": len(indices), "type": "SCALAR"}
        return self.add(struct.pack(f"<{len(indices)}H", *indices), accessor, 34963)


def _extras(model, set_name):
    low, high = model.box()
    size = [round(b - a, 4) for a, b in zip(low, high)]
    extras = {"footprint": [size[0], size[2]], "height": size[1], "front": model.front, "set": set_name}
    if model.keeps_proportions:
        extras["keeps_proportions"] = True
    if model.role:
        extras["role"] = model.role
    return extras


def _padded(data, filler):
    return data + filler * (-len(data) % 4)


def _shared(part):
    """The corners of a part without repetition, and the triangles' indices of them."""
    numbers = {}
    order = [numbers.setdefault((_rounded(point, 6), _rounded(normal, 5)), len(numbers))
             for point, normal in zip(part.positions, part.normals)]
    return list(numbers), [order[index] for index in part.indices]


def _rounded(vector, digits):
    return tuple(round(part, digits) + 0.0 for part in vector)


def glb(model, set_name):
    model.centered()
    buffer, primitives = _Buffer(), []
    for number, part in enumerate(model.parts):
        corners, indices = _shared(part)
        attributes = {"POSITION": buffer.vectors([point for point, _ in corners], True),
                      "NORMAL": buffer.vectors([normal for _, normal in corners], False)}
        primitives.append({"attributes": attributes, "indices": buffer.indices(indices), "material": number})
    document = {
        "asset": {"generator": "Solitaire", "version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": model.name, "mesh": 0, "extras": _extras(model, set_name)}],
        "meshes": [{"name": model.name, "primitives": primitives}],
        "materials": [_material(part.surface) for part in model.parts],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(_padded(buffer.bytes, b"\0"))}],
    }
    text = _padded(json.dumps(document, separators=(",", ":")).encode(), b" ")
    data = _padded(buffer.bytes, b"\0")
    length = 12 + 8 + len(text) + 8 + len(data)
    return (struct.pack("<4sII", b"glTF", 2, length) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(data), b"BIN\0") + data)
