#!/usr/bin/env python3
"""Sees to it that the tests notice what is wrong with an engine: builds them once from a copy of the tree in which faults can
be switched on, runs them with one fault after the other, and expects them to fail.

    tests/mutants/run.py ENGINE BUILD_FOLDER [--only TEXT] [CMAKE_OPTION...]

ENGINE is `sampling`, `solving` or `counting`, a file of this folder with a table of faults; TEXT stands in the names of
those to try. The folder is made if it is not there, and kept for the next time; it serves all engines. Ends with status 1 if a
mutant is not noticed.
"""
import argparse
import os
import pathlib
import subprocess
import sys

import counting
import sampling
import solving

ENGINES = {"sampling": sampling, "solving": solving, "counting": counting}
MUTANTS = [mutant for engine in ENGINES.values() for mutant in engine.MUTANTS]

SWITCH = """#ifndef SOLITAIRE_FAULTY
#define SOLITAIRE_FAULTY
#include <cstdlib>
inline bool faulty(int number) {
  static const char* const chosen = std::getenv("SOLITAIRE_MUTANT");
  return chosen != nullptr && std::atoi(chosen) == number;
}
#endif
"""


def with_faults(name, text):
    """The text of a file in which the environment switches its faults on, each by its number."""
    changed = text
    for number, mutant in enumerate(MUTANTS, 1):
        if mutant.file == name:
            assert changed.count(mutant.old) == 1, f"{name} does not have this once: {mutant.old}"
            changed = changed.replace(mutant.old, mutant.new.replace("FAULTY", f"faulty({number})"))
    return text if changed == text else SWITCH + changed


def copy_tree(source, folder):
    """Writes those of the tree's files alone that differ, so that little is built anew, and removes those that it has no more."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z"], check=True, capture_output=True).stdout
    names = {name for name in listed.decode().split("\0") if name and (source / name).is_file()}
    for path in folder.rglob("*"):
        if path.is_file() and str(path.relative_to(folder)) not in names:
            path.unlink()
    for name in names:
        content = (source / name).read_bytes()
        if any(mutant.file == name for mutant in MUTANTS):
            content = with_faults(name, content.decode()).encode()
        path = folder / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            path.chmod((source / name).stat().st_mode)


def tests_pass(program, names="*", number=0):
    command = [program, "--abort-after=1", f"--test-case={names}"]
    environment = {**os.environ, "SOLITAIRE_MUTANT": str(number)}
    try:
        tests = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=1800)
    except subprocess.TimeoutExpired:
        return False
    return tests.returncode == 0


def build_tests(source, build, program, options):
    copy_tree(source, build / "source")
    if not (build / "build.ninja").exists():
        configure = ["cmake", "-S", build / "source", "-B", build, "-G", "Ninja", "-DSOLITAIRE_TESTS=ON", *options]
        subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", build, program.name], check=True, stdout=subprocess.DEVNULL)


def main():
    reader = argparse.ArgumentParser(usage=__doc__)
    reader.add_argument("engine", choices=ENGINES)
    reader.add_argument("build", type=lambda path: pathlib.Path(path).resolve())
    reader.add_argument("--only", default="")
    arguments, options = reader.parse_known_args()
    engine = ENGINES[arguments.engine]
    program = arguments.build / "tests" / engine.TESTS
    build_tests(pathlib.Path(__file__).resolve().parents[2], arguments.build, program, options)
    missed = 0
    for number, mutant in enumerate(MUTANTS, 1):
        if mutant not in engine.MUTANTS or arguments.only not in mutant.what:
            continue
        noticed = not tests_pass(program, mutant.tests, number)
        print("noticed:" if noticed else "NOT NOTICED:", mutant.what, flush=True)
        missed += not noticed
    if not tests_pass(program, ",".join({mutant.tests for mutant in engine.MUTANTS})):
        sys.exit("the tests fail without a mutant")
    sys.exit(missed > 0)


if __name__ == "__main__":
    main()
