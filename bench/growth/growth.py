#!/usr/bin/python3
"""Measures how the cost of classic problems grows with their size, and writes a table in Markdown."""
import argparse
import re
import sys
from pathlib import Path

from rows import HERE, rows
from systems import all_systems   # puts the folder of bench/compare on the path

import measure
from fit import exponent

ROOT = HERE.parents[1]


def main():
    options = read_options()
    systems = [system for system in all_systems(options.solitaire)
               if not options.systems or system.name in options.systems.split(",")]
    lines = [f"CPU seconds / MB of one run with at most {options.limit:g} s; `–` is no answer; growth is the exponent of the "
             "size that fits best.", "", "| row | asked | system | " + " | ".join(["sizes and costs", "growth"]) + " |",
             "| --- | --- | --- | --- | --- |"]
    for row in rows():
        if re.search(options.only, row.name):
            lines += table_rows(row, systems, options)
            write(options.output, lines)
    print(f"growth: written to {options.output}", file=sys.stderr)
    return 0


def table_rows(row, systems, options):
    answers = {}
    lines = []
    for system in systems:
        if system.model(row) is None:
            continue
        cells, points = measured(row, system, options, answers)
        growth = exponent(points)
        lines.append(f"| {row.name} | {row.kind} | {system.name} | {', '.join(cells)} | "
                     f"{'' if growth is None else f'{growth:.1f}'} |")
        print(lines[-1], file=sys.stderr, flush=True)
    return lines


def measured(row, system, options, answers):
    """The cells of the sizes in turn, until one has no answer; and (size, CPU seconds) of those that have one."""
    cells, points = [], []
    for size in row.sizes:
        child = measure.run(system.command(row, size), options.limit)
        answer = "" if child.out_of_time else system.answer(row, child)
        if not answer:
            cells.append(f"{size}: –")
            break
        check(row, size, system, answer, answers)
        cells.append(f"{size}: {child.cpu:.3g} / {child.memory / 1e6:.0f}")
        points.append((size, child.cpu))
    return cells, points


def check(row, size, system, answer, answers):
    """Ends the measurement where two systems disagree: then one of them is measured on another problem."""
    if row.kind in ("best", "sample"):
        return
    expected, said_by = answers.setdefault(size, (answer, system.name))
    number = re.search(r"\d+", answer)
    if expected != answer and (not number or number.group() not in expected):
        sys.exit(f"growth: {row.name} of {size}: {system.name} says {answer}, {said_by} says {expected}")


def write(path, lines):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def read_options():
    parser = argparse.ArgumentParser(prog="bin/bench --growth", description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build-bench" / "growth.md",
                        help="the table (build-bench/growth.md)")
    parser.add_argument("--solitaire", default=str(ROOT / "build-bench" / "app" / "solitaire"),
                        help="the program to measure (the one that bin/bench builds)")
    parser.add_argument("--limit", type=float, default=20, help="CPU seconds of one run (20)")
    parser.add_argument("--only", metavar="REGEX", default="", help="only the rows whose names match")
    parser.add_argument("--systems", metavar="NAME,...", help="only these: solitaire, gecode, clasp, z3")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
