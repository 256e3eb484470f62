"""Programs as dicts of file names and texts, the script first."""

import json
import re
import subprocess
from pathlib import Path


def write_files(files, folder):
    """Writes a program's files; gives the path of the script."""
    for name, text in files.items():
        path = Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return Path(folder) / next(iter(files))


def show_files(files):
    """The files as one text; the names of all but a single one stand above their texts."""
    if len(files) == 1:
        return next(iter(files.values()))
    return "\n".join(f"// file: {name}\n{text}" for name, text in files.items())


def generated_programs(generator, first_seed, count):
    """(seed, files) of each generated program, by the program tests/reference/generated_programs.cpp."""
    run = subprocess.run([generator, str(first_seed), str(count)], capture_output=True, text=True, check=True)
    for line in run.stdout.splitlines():
        program = json.loads(line)
        yield program["seed"], {each["name"]: each["text"] for each in program["files"]}


def settings_in(text):
    """The params that comments `// set: NAME=VALUE` of a script set, as pairs of texts."""
    return [(match[1], match[2].strip()) for match in re.finditer(r"// set: (\w+) ?= ?(.*)", text)]
