"""Between the peers' variables and Solitaire's choices.

Each problem has PROBLEM_addresses.py with names(params): the addresses of the choices, and for each the variable that
stands for it.
"""
import importlib.util
from dataclasses import dataclass
from functools import cache

from paths import problem_file


@dataclass(frozen=True)
class Variable:
    array: str
    index: int            # from 1
    scale: int = 1        # the choice's value is so many times the variable's
    there: tuple = ()     # array and index of the variable that is 1 where the choice is there at all


@cache
def load(problem):
    spec = importlib.util.spec_from_file_location(f"{problem}_addresses", problem_file(problem, "_addresses.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def choices(problem, params, values):
    """{address: value} from {array: {index: value}}."""
    return {at: values[variable.array][variable.index] * variable.scale
            for at, variable in load(problem).names(params).items()
            if not variable.there or values[variable.there[0]][variable.there[1]] == 1}


def variables(problem, params, pins):
    """[(array, index, value)] from {address: value}."""
    names = load(problem).names(params)
    pinned = set()
    for at, value in pins.items():
        variable = names[at]
        pinned.add((variable.array, variable.index, int(value) // variable.scale))
        if variable.there:
            pinned.add((*variable.there, 1))
    return sorted(pinned)
