#!/usr/bin/env python3
"""Writes the bundled models: make_assets.py FOLDER [NAME]...

The same scripts write the same bytes; the files are in the repository, so only who changes a model needs this.
"""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent / "assets"))
from catalogue import SETS  # noqa: E402
from gltf import glb  # noqa: E402

MOST_TRIANGLES = 2000


def main(folder, names):
    written = set()
    for set_name, module in SETS.items():
        for make in module.MODELS:
            model = make()
            if names and model.name not in names:
                continue
            if model.name in written:
                sys.exit(f"make_assets.py: there are two models {model.name}")
            if model.triangles() >= MOST_TRIANGLES:
                sys.exit(f"make_assets.py: {model.name} has {model.triangles()} triangles")
            written.add(model.name)
            (Path(folder) / f"{model.name}.glb").write_bytes(glb(model, set_name))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: make_assets.py FOLDER [NAME]...")
    main(sys.argv[1], set(sys.argv[2:]))
