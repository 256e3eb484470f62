#!/usr/bin/env python3
"""The reference interpreter: all solutions of a .sol program, a line of JSON each, as `solitaire solve --all --json` has
them but in another order.

    python3 tests/reference/interpret.py FILE.sol [--set NAME=VALUE]... [--max-executions N]
"""

import argparse
import json
import sys

from deep_stack import run_with_deep_stack
from interpreter.modules import load_program, param_values
from interpreter.search import TooMany, all_executions
from interpreter.syntax import ProgramError
from interpreter.values import plain
from solitaire import LIBRARY


def as_json(execution):
    choices = [{"at": at, "value": value} for at, value in execution.choices.items()]
    return {"value": plain(execution.value), "cost": execution.cost, "choices": choices}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("file")
    options.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    options.add_argument("--max-executions", type=int, default=100_000)
    given = options.parse_args()
    try:
        program = load_program(given.file, [LIBRARY])
        params = param_values(program, [setting.split("=", 1) for setting in given.set])
        results = all_executions(program, params, given.max_executions)
    except (ProgramError, TooMany) as error:
        sys.exit(f"{type(error).__name__} {error}")
    for execution in results.solutions:
        for line in execution.printed:
            print(line, file=sys.stderr)
        print(json.dumps(as_json(execution)))
    for error in results.errors:
        print("error:", error, file=sys.stderr)


if __name__ == "__main__":
    run_with_deep_stack(main)
