#!/usr/bin/env python3
"""Checks the includes of all sources against the picture of docs/architecture.md.

check_includes.py SOURCE_FOLDER

A folder includes only those that it may use, and no two units include each other, neither at once nor through others. A
unit is a header together with the sources of its name. Prints what is wrong and exits with 1, or with 0.
"""

import re
import sys
from pathlib import Path

BELOW_ENGINES = {"base", "tracegraph", "solitaire", "smt", "kernel"}

# What each folder may include beside itself. The longest name that fits a path counts.
ALLOWED = {
    "base": set(),
    "tracegraph": {"base"},
    "solitaire": {"base", "tracegraph"},
    "smt": {"base", "tracegraph"},
    "kernel": {"base", "tracegraph"},
    "scene": {"base"},
    "engines": BELOW_ENGINES,
    "engines/tile_maps": BELOW_ENGINES | {"engines", "engines/tiles"},
    "engines/tiles": {"base", "tracegraph", "smt", "engines"},
    "library": BELOW_ENGINES | {"engines", "engines/tiles", "engines/tile_maps", "scene"},
    "app": {"library", "engines/tiles", "scene", "base"},
}
# Programs beside the product: they may include anything, but form no circles.
FREE = ("tests", "bench", "tools")

INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


def folder_of(path):
    fitting = [name for name in ALLOWED if path.startswith(name + "/")]
    return max(fitting, key=len) if fitting else None


def includes_of(root):
    """The project's own includes of each source and header, by path from the root."""
    found = {}
    for top in sorted({name.split("/")[0] for name in ALLOWED} | set(FREE)):
        for file in sorted((root / top).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            texts = INCLUDE.findall(file.read_text(encoding="utf-8"))
            found[file.relative_to(root).as_posix()] = [path for path in map(lambda t: resolved(root, file, t), texts) if path]
    return found


def resolved(root, file, text):
    """The path from the root of what a file includes; nothing for what is not the project's."""
    for start in (root, root / "library" / "include", file.parent):
        if (start / text).is_file():
            return (start / text).resolve().relative_to(root.resolve()).as_posix()
    return None


def wrong_arrows(includes):
    for path, included in includes.items():
        folder = folder_of(path)
        if folder is None:
            continue
        for other in included:
            to = folder_of(other)
            if to != folder and to not in ALLOWED[folder]:
                yield f"{path} includes {other}, but {folder}/ may not use {to}/"


def unit_of(path):
    return path.rsplit(".", 1)[0]


def unit_graph(includes):
    graph = {}
    for path, included in includes.items():
        graph.setdefault(unit_of(path), set()).update(unit_of(other) for other in included)
    for unit, others in graph.items():
        others.discard(unit)
    return graph


def circles(graph):
    """Groups of units that all include each other, by Tarjan's algorithm for strongly connected components."""
    number, lowest, stack, on_stack = {}, {}, [], set()
    found = []

    def visit(unit):
        number[unit] = lowest[unit] = len(number)
        stack.append(unit)
        on_stack.add(unit)
        for other in sorted(graph.get(unit, ())):
            if other not in number:
                visit(other)
                lowest[unit] = min(lowest[unit], lowest[other])
            elif other in on_stack:
                lowest[unit] = min(lowest[unit], number[other])
        if lowest[unit] != number[unit]:
            return
        group = []
        while not group or group[-1] != unit:
            group.append(stack.pop())
            on_stack.discard(group[-1])
        if len(group) > 1:
            found.append(sorted(group))

    sys.setrecursionlimit(10000)
    for unit in sorted(graph):
        if unit not in number:
            visit(unit)
    return found


def main():
    root = Path(sys.argv[1])
    includes = includes_of(root)
    if not includes:
        sys.exit(f"there are no sources in {root}")
    complaints = list(wrong_arrows(includes))
    complaints += ["these units include each other: " + ", ".join(group) for group in circles(unit_graph(includes))]
    print("\n".join(complaints) or f"{len(includes)} files include each other as docs/architecture.md says")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
