#!/usr/bin/env python3
"""Holds the scripts of the tests, and the programs in the documentation, against the reference interpreter.

    python3 tests/reference/test_scripts.py SOLITAIRE

Also checks what the comments of tests/language/ and of the documentation's programs say about values, numbers of solutions and
placed things against the interpreter alone, so that both sides cannot go wrong together.
"""

import json
import re
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from comparing import Limits, compare, shown_choices
from deep_stack import run_with_deep_stack
from interpreter.values import text
from program_files import settings_in, write_files

SOURCE = Path(__file__).resolve().parents[2]
LIMITS = Limits(executions=1500, steps=50_000, depth=400, seconds=3)

# So many scripts and programs have to be compared in full; the others are too large to run every execution.
LEAST_EQUAL = 200


@dataclass
class Script:
    name: str
    path: Path
    source: str


def test_scripts():
    for folder in ("language", "differential", "programs", "explain"):
        for path in sorted((SOURCE / "tests" / folder).glob("*.sol")):
            yield Script(f"{folder}/{path.name}", path, path.read_text(encoding="utf-8"))


def documented_programs(folder):
    """The programs of the pages. Those with `file=NAME` can be imported by later ones of their page."""
    for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]:
        page_folder = Path(folder) / page.stem
        page_text = page.read_text(encoding="utf-8")
        for match in re.finditer(r"^```sol(.*?)\n(.*?)^```", page_text, re.MULTILINE | re.DOTALL):
            fence, source = match.group(1).strip(), match.group(2)
            if fence.startswith(("norun", "samples")):
                continue
            line = page_text.count("\n", 0, match.start()) + 2
            name = fence.removeprefix("file=") if fence.startswith("file=") else f"line{line}.sol"
            yield Script(f"{page.name}:{line}", write_files({name: source}, page_folder), source)


def expected(script, kind):
    return [match.strip() for match in re.findall(rf"// {kind}: ?(.*)", script.source)]


def told_apart(solutions):
    """One of each set of solutions that differ in auxiliary choices alone."""
    return list({json.dumps(shown_choices(each)): each for each in solutions}.values())


def unmet_expectations(script, results):
    """What the script's comments say and the interpreter does not."""
    solutions = told_apart(results.solutions)
    values = Counter(text(each.value, inside=True) for each in solutions)
    if script.path.parent.name == "language" and "expect" in script.source:
        wanted = Counter(expected(script, "expect"))
        if wanted - values or (values - wanted and not expected(script, "expect solutions")):
            yield f"values {dict(values)}"
    wanted = set(expected(script, "value"))
    if wanted and wanted != set(values):
        yield f"values {dict(values)}"
    for number in expected(script, "solutions") + expected(script, "expect solutions"):
        if len(solutions) != int(number):
            yield f"{len(solutions)} solutions"
    for number in expected(script, "places"):
        if any(len(each.placed) != int(number) for each in results.solutions):
            yield "another number of placed things"
    if expected(script, "error") and not results.errors:
        yield "no error"


def failures(solitaire, script, tally):
    settings = settings_in(script.source)
    found = compare(solitaire, script.path, settings, LIMITS)
    tally[f"{found.outcome} {found.reason if found.outcome in ('skipped', 'refused', 'known') else ''}".strip()] += 1
    if found.outcome == "different":
        yield found.reason
    if found.outcome == "equal":
        yield from unmet_expectations(script, found.results)


def main():
    tally, failed = Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for script in [*test_scripts(), *documented_programs(folder)]:
            reasons = list(failures(sys.argv[1], script, tally))
            if reasons:
                failed += 1
                print(f"{script.name}: {'; '.join(reasons)}", flush=True)
    print(", ".join(f"{count} {outcome}" for outcome, count in sorted(tally.items())))
    return 1 if failed or tally["equal"] < LEAST_EQUAL else 0


if __name__ == "__main__":
    run_with_deep_stack(main)
