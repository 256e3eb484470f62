#!/usr/bin/python3
"""Compares Solitaire with other solvers on the same problems and writes a report in Markdown."""
import argparse
import json
import re
import sys
import time
from dataclasses import asdict
from pathlib import Path

import growth
import report
import selftest
from cells import Cell, measure_cell
from paths import ROOT
from rows import rows
from systems import all_systems


def main():
    options = read_options()
    systems = [system for system in all_systems(options.solitaire)
               if not options.systems or system.name in options.systems.split(",")]
    if options.selftest:
        return selftest.run(systems)
    if options.verify:
        return selftest.verify(chosen_rows(options), systems, options)

    started = time.time()
    cells = kept_cells(options)
    for row in chosen_rows(options):
        for kind in row.kinds:
            for system in systems:
                if (row.name, kind, system.name) not in cells:
                    say(f"{row.name}: {kind}, {system.name}")
                    cells[row.name, kind, system.name] = measure_cell(row, kind, system, systems[0], options)
                    keep(cells, options)
    extras = growth.measure(options) if wanted(growth.NAME, options) else {}
    text = report.write(chosen_rows(options), systems, cells, extras, options, time.time() - started)
    options.output.write_text(text)
    say(f"written to {options.output}")
    return 0


def kept_cells(options):
    path = options.output.with_suffix(".json")
    if not options.resume or not path.exists():
        return {}
    return {tuple(name): Cell(**cell) for name, cell in json.loads(path.read_text())}


def keep(cells, options):
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output.with_suffix(".json"), "w") as file:
        json.dump([[name, asdict(cell)] for name, cell in cells.items()], file, indent=1)


def chosen_rows(options):
    return [row for row in rows() if wanted(row.name, options) and (row.quick or not options.quick)]


def wanted(name, options):
    return not options.only or re.search(options.only, name)


def say(text):
    print(f"compare: {text}", file=sys.stderr, flush=True)


def read_options():
    parser = argparse.ArgumentParser(prog="bin/bench --compare", description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build-bench" / "compare.md",
                        help="the report (build-bench/compare.md)")
    parser.add_argument("--solitaire", default=str(ROOT / "build-bench" / "app" / "solitaire"),
                        help="the program to measure (the one that bin/bench builds)")
    parser.add_argument("--seeds", type=int, help="runs of each cell, with seeds from 1 (5; with --quick 3)")
    parser.add_argument("--limit", type=float, help="CPU seconds of one run (60; with --quick 8)")
    parser.add_argument("--cell-limit", type=float,
                        help="CPU seconds after which a cell gets no further seed (60; with --quick 8)")
    parser.add_argument("--only", metavar="REGEX", help="only the rows whose names match")
    parser.add_argument("--systems", metavar="NAME,...", help="only these: solitaire, thesis, gecode, clasp, z3")
    parser.add_argument("--quick", action="store_true", help="few rows, few seeds, short limits: some minutes")
    parser.add_argument("--resume", action="store_true",
                        help="takes what an earlier run with the same output left in the .json file beside it as measured")
    parser.add_argument("--verify", action="store_true",
                        help="no times: runs ten solutions of each system and row through Solitaire")
    parser.add_argument("--selftest", action="store_true",
                        help="no times: all systems have to find the same set of solutions of tiny problems")
    options = parser.parse_args()
    options.seeds = options.seeds or (3 if options.quick else 5)
    options.limit = options.limit or (8.0 if options.quick else 60.0)
    options.cell_limit = options.cell_limit or options.limit
    return options


if __name__ == "__main__":
    sys.exit(main())
