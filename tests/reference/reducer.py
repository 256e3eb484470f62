#!/usr/bin/env python3
"""Makes a program that fails smaller, line by line, as long as it fails in the same way.

    python3 tests/reference/reducer.py FILE.sol... -- COMMAND

runs COMMAND with the path of the first file, in a folder of its own with the others; its last line of output, up to the first
digit, quote or bracket, is how it fails, and nothing is no failure. For example, COMMAND can be
`build/tests/differential_soak --check`. Prints the smallest program.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from program_files import show_files, write_files


def indentation(line):
    return len(line) - len(line.lstrip(" "))


def end_of_block(lines, at):
    """The index behind the line that closes the block which line `at` opens."""
    end = at + 1
    while end < len(lines) and indentation(lines[end]) > indentation(lines[at]):
        end += 1
    return min(end + 1, len(lines))


def smaller_at(lines, at):
    """What can be left out from a line on: the line, or its block with or without what is in it."""
    if not lines[at].endswith("{"):
        return [lines[:at] + lines[at + 1 :]]
    end = end_of_block(lines, at)
    return [lines[:at] + lines[end:], lines[:at] + lines[at + 1 : end - 1] + lines[end:]]


def smaller_file(files, name, failure, wanted):
    """The files without one more part of a file, or None if every part is needed."""
    lines = files[name].splitlines()
    for at in reversed(range(len(lines))):
        for candidate in smaller_at(lines, at):
            smaller = dict(files, **{name: "".join(line + "\n" for line in candidate)})
            if failure(smaller) == wanted:
                return smaller
    return None


def reduce(files, failure):
    """The smallest files, a dict of names and texts, for which `failure(files)` is what it is for the given ones."""
    wanted = failure(files)
    for name in list(files)[1:]:
        rest = {each: text for each, text in files.items() if each != name}
        if failure(rest) == wanted:
            files = rest
    for name in files:
        while (smaller := smaller_file(files, name, failure, wanted)) is not None:
            files = smaller
    return files


def failure_of_command(command):
    def failure(files):
        with tempfile.TemporaryDirectory() as folder:
            script = write_files(files, folder)
            run = subprocess.run([*command, str(script)], capture_output=True, text=True, check=False)
        lines = run.stdout.splitlines() or [""]
        return re.split(r"[\[\"0-9{/]", lines[-1], maxsplit=1)[0] if run.returncode else ""

    return failure


def main():
    if "--" not in sys.argv:
        sys.exit(__doc__)
    end = sys.argv.index("--")
    files = {Path(path).name: Path(path).read_text(encoding="utf-8") for path in sys.argv[1:end]}
    failure = failure_of_command(sys.argv[end + 1 :])
    if not failure(files):
        sys.exit("the command does not fail on these files")
    print(show_files(reduce(files, failure)))


if __name__ == "__main__":
    main()
