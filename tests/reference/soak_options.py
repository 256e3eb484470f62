#!/usr/bin/env python3
"""Holds what generated programs give under random options against the reference interpreter, for as long as it is told.

    python3 tests/reference/soak_options.py SOLITAIRE GENERATOR --minutes 60 [--seed FIRST]

Each program that differs is made smaller and printed. Ends with status 1 if there was one.
"""

import argparse
import random
import subprocess
import tempfile
import time
from collections import Counter

from comparing import Limits, reference_results
from deep_stack import run_with_deep_stack
from interpreter.search import TooMany
from option_checks import CHECKS, Case, NoAnswer, Wrong
from program_files import generated_programs, show_files, write_files
from reducer import reduce

BATCH = 100
LIMITS = Limits(executions=600)


def failure_of(solitaire, files, check, seed):
    """How a check fails on a program: a text, "" if it does not, None if nothing can be said."""
    with tempfile.TemporaryDirectory() as folder:
        script = write_files(files, folder)
        try:
            results = reference_results(script, (), LIMITS)
            if results.errors or not results.solutions:
                return None
            check(Case(solitaire, script, results, random.Random(seed)))
        except (TooMany, NoAnswer):
            return None
        except Wrong as wrong:
            return str(wrong)
        except subprocess.TimeoutExpired:
            return "did not keep its --timeout"
    return ""


def report(solitaire, files, check, seed, reason):
    print(f"seed {seed}: {check.__name__}: {reason}", flush=True)

    def failure(candidate):
        return failure_of(solitaire, candidate, check, seed) and check.__name__

    smallest = reduce(files, failure)
    print(show_files(smallest), failure_of(solitaire, smallest, check, seed), sep="", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("solitaire")
    options.add_argument("generator")
    options.add_argument("--minutes", type=float, default=60)
    options.add_argument("--seed", type=int, default=int(time.time()), help="by default, one of the clock")
    given = options.parse_args()
    end = time.monotonic() + 60 * given.minutes
    tally, seed, failed = Counter(), given.seed, 0
    while time.monotonic() < end:
        for _, files in generated_programs(given.generator, seed, BATCH):
            check = random.Random(seed).choice(CHECKS)
            reason = failure_of(given.solitaire, files, check, seed)
            if reason is not None:
                tally[check.__name__] += 1
            if reason:
                failed += 1
                report(given.solitaire, files, check, seed, reason)
            seed += 1
            if time.monotonic() > end:
                break
    print(f"to seed {seed}: {', '.join(f'{count} {name}' for name, count in sorted(tally.items()))}; {failed} differ")
    return 1 if failed else 0


if __name__ == "__main__":
    run_with_deep_stack(main)
