#!/usr/bin/env python3
"""Holds generated programs against the reference interpreter for as long as it is told.

    python3 tests/reference/soak.py SOLITAIRE GENERATOR --minutes 60 [--seed FIRST]

Each program that differs is made smaller and printed. Ends with status 1 if there was one.
"""

import argparse
import time

from deep_stack import run_with_deep_stack
from program_files import generated_programs
from test_generated import Tally

BATCH = 100


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("solitaire")
    options.add_argument("generator")
    options.add_argument("--minutes", type=float, default=60)
    options.add_argument("--seed", type=int, default=int(time.time()), help="by default, one of the clock")
    given = options.parse_args()
    end = time.monotonic() + 60 * given.minutes
    tally, seed = Tally(given.solitaire), given.seed
    print(f"seeds from {seed}", flush=True)
    while time.monotonic() < end:
        for _, files in generated_programs(given.generator, seed, BATCH):
            tally.add(seed, files)
            seed += 1
            if time.monotonic() > end:
                break
    print(tally)
    return 1 if tally.count("different") else 0


if __name__ == "__main__":
    run_with_deep_stack(main)
