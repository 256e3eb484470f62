"""Between the peers' variables and Solitaire's choices.

Each problem has PROBLEM_addresses.py with names(params): the addresses of the choices, and for each the array and the
index (from 1) of the variable that stands for it, and a second pair if the choice is only there where that one is 1.
"""
import importlib.util
from functools import cache

from paths import problem_file


@cache
def load(problem):
    spec = importlib.util.spec_from_file_location(f"{problem}_addresses", problem_file(problem, "_addresses.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def choices(problem, params, values):
    """{address: value} from {array: {index: value}}."""
    return {at: values[array][index] for at, (array, index, *there) in load(problem).names(params).items()
            if not there or values[there[0][0]][there[0][1]] == 1}


def variables(problem, params, pins):
    """[(array, index, value)] from {address: value}."""
    names = load(problem).names(params)
    pinned = set()
    for at, value in pins.items():
        array, index, *there = names[at]
        pinned.add((array, index, int(value)))
        pinned.update((*pair, 1) for pair in there)
    return sorted(pinned)
