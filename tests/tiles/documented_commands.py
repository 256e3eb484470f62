#!/usr/bin/env python3
"""Runs the commands of a page of the documentation one after the other, in a folder of their own.

documented_commands.py PROGRAM PAGE [WORD]...

A command is an indented block that begins with `cat >` or `bin/solitaire`; text is fed to it as it stands on the page. A
block of the language is saved under the name with which a later command calls it. With WORDs, only the blocks that have one of these
are run, and those that write files by `cat`. A command that the page says to be refused has to be refused.
"""

import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r"^    .*\n(?:    .*\n|\n(?=    ))*", re.MULTILINE)
REFUSED = re.compile(r"^is refused", re.MULTILINE)  # what the page says behind a command
ABSENT = ["bin/bench", "config.json"]  # of the reader, or measured elsewhere


def blocks_of(page):
    """Returns the blocks of commands with what stands behind each, in order."""
    found = []
    for block in BLOCK.finditer(page):
        text = "\n".join(line[4:] for line in block.group().rstrip().split("\n"))
        if re.match(r"cat >|bin/solitaire", text) and not any(word in text for word in ABSENT):
            found.append((text, page[block.end() :].lstrip()[:40]))
    return found


def prepare(folder, program, page):
    (folder / "bin").mkdir()
    (folder / "bin/solitaire").symlink_to(Path(program).resolve())
    (folder / "examples").symlink_to(ROOT / "examples")
    for text, behind in re.findall(r"```sol\n(.*?)```(.*?)(?=```|\Z)", page, re.DOTALL):
        called = re.search(r"bin/solitaire \w+ (\w+\.sol)", behind)
        if called:
            (folder / called.group(1)).write_text(text, encoding="utf-8")


def run(folder, text):
    start = time.monotonic()
    done = subprocess.run(["bash", "-ec", text], cwd=folder, capture_output=True, text=True, check=False)
    return done, time.monotonic() - start


def main():
    program, page = sys.argv[1], Path(sys.argv[2]).read_text(encoding="utf-8")
    words = sys.argv[3:]
    ran = wrong = 0
    with tempfile.TemporaryDirectory(prefix="solitaire-commands-") as name:
        folder = Path(name)
        prepare(folder, program, page)
        for text, behind in blocks_of(page):
            if words and not text.startswith("cat >") and not any(word in text for word in words):
                continue
            if words and text.startswith("cat >"):  # the file alone
                text = re.sub(r"^bin/solitaire.*", "", text, flags=re.MULTILINE)
            done, seconds = run(folder, text)
            expected = 1 if REFUSED.match(behind) else 0
            met = done.returncode == expected
            ran, wrong = ran + 1, wrong + (not met)
            print(f"{'ok ' if met else 'NOT'} {seconds:5.1f} s  {text.splitlines()[-1]}", flush=True)
            if not met:
                print(f"status {done.returncode}, not {expected}\n{done.stdout}{done.stderr}")
    if ran == 0:
        sys.exit("the page has no commands")
    sys.exit(1 if wrong else 0)


main()
