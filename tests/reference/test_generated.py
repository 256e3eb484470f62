#!/usr/bin/env python3
"""Holds generated programs against the reference interpreter.

    python3 tests/reference/test_generated.py SOLITAIRE GENERATOR FIRST-SEED COUNT

Prints what differs, made smaller, and how many programs were compared, refused and skipped, with the reasons.
"""

import sys
from collections import Counter

from comparing import compare_files, kind_of_difference
from deep_stack import run_with_deep_stack
from program_files import generated_programs, show_files
from reducer import reduce


class Tally:
    """Counts the outcomes of comparisons, and prints the programs for which something differs."""

    def __init__(self, solitaire):
        self.solitaire = solitaire
        self.outcomes = Counter()
        self.with_solutions = 0
        self.with_errors = 0
        self.with_imports = 0

    def add(self, seed, files):
        found = compare_files(self.solitaire, files)
        self.outcomes[found.outcome, "" if found.outcome == "different" else found.reason] += 1
        self.with_solutions += bool(found.results.solutions)
        self.with_errors += bool(found.results.errors)
        self.with_imports += len(files) > 1
        if found.outcome == "different":
            self.report(seed, files, found)

    def report(self, seed, files, found):
        def failure(candidate):
            return kind_of_difference(compare_files(self.solitaire, candidate))

        print(f"seed {seed}: {found.reason}")
        smallest = reduce(files, failure)
        print(show_files(smallest), compare_files(self.solitaire, smallest).reason, sep="", flush=True)

    def count(self, outcome):
        return sum(count for (each, _), count in self.outcomes.items() if each == outcome)

    def __str__(self):
        parts = [f"{count} {' '.join(key).strip()}" for key, count in sorted(self.outcomes.items())]
        return (
            f"{sum(self.outcomes.values())} programs: {', '.join(parts)}; {self.with_solutions} with solutions, "
            f"{self.with_errors} with errors, {self.with_imports} with imports"
        )


def main():
    solitaire, generator, first_seed, count = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    tally = Tally(solitaire)
    for seed, files in generated_programs(generator, first_seed, count):
        tally.add(seed, files)
    print(tally)
    # Else the generator has become poor, and the comparison says little.
    rich = tally.count("equal") >= 0.8 * count and tally.with_solutions >= 0.3 * count and tally.with_errors > 0
    return 0 if rich and tally.count("different") == 0 else 1


if __name__ == "__main__":
    run_with_deep_stack(main)
