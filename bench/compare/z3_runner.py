"""Solves a problem's Z3 model: z3_runner.py PROBLEM PARAMS KIND SEED COUNT PINS. Prints a JSON object a line.

A model's module says by LOGIC what it is stated in, by DIVERSE how solutions that differ are cheapest to get:

incremental  one solver with random phases and values
fresh        the same, but a new solver for each solution
"""
import importlib
import json
import sys
import time
from pathlib import Path

import z3

PROBLEMS = Path(__file__).resolve().parent / "problems"


def main(problem, params, kind, seed, count, pins):
    sys.path[:0] = [str(PROBLEMS), str(PROBLEMS / problem)]
    model = importlib.import_module(f"{problem}_z3")
    how = getattr(model, "DIVERSE", "fresh")
    if kind == "diverse":
        for name, value in (("sat.phase", "random"), ("smt.phase_selection", 5),
                            ("smt.arith.random_initial_value", True)):
            z3.set_param(name, value)
    collected = z3.Solver()
    variables = model.model(collected, params)
    collected.add([equals(variables[array][index - 1], value) for array, index, value in pins])
    flat = [value for array in variables.values() for value in array]

    def new_solver(seed):
        z3.set_param("sat.random_seed", seed)
        z3.set_param("smt.random_seed", seed)
        solver = z3.SolverFor(model.LOGIC)
        solver.add(collected.assertions())
        return solver

    solver = new_solver(seed)
    start = time.process_time()
    say(preparation=start)
    found = 0
    blocked = []
    while not count or found < count:
        if kind == "diverse" and how == "fresh" and found:
            solver = new_solver(1000 * seed + found)
            solver.add(blocked)
        if solver.check() != z3.sat:
            say(end=str(solver.check()))
            return
        answer = solver.model()
        found += 1
        blocked.append(z3.Or([literal for value in flat for literal in different(value, answer)]))
        solver.add(blocked[-1])
        say(values={name: [plain(value, answer) for value in array] for name, array in variables.items()},
            cpu=time.process_time() - start)


def plain(value, answer):
    """An int; of a list of Bools the number whose bits they are, the lowest first; of a tuple the one that is true."""
    if isinstance(value, list):
        return sum(plain(bit, answer) << place for place, bit in enumerate(value))
    if isinstance(value, tuple):
        return next((place for place, bit in enumerate(value) if plain(bit, answer)), -1)
    value = answer.eval(value, model_completion=True)
    return int(value.as_long()) if hasattr(value, "as_long") else int(bool(value))


def equals(value, number):
    if isinstance(value, list):
        return z3.And([bit == bool(number >> place & 1) for place, bit in enumerate(value)])
    if isinstance(value, tuple):
        return value[number]
    return value == (bool(number) if z3.is_bool(value) else number)


def different(value, answer):
    """Literals, one of which holds where the value is another one."""
    if isinstance(value, list):
        return [bit != answer.eval(bit, model_completion=True) for bit in value]
    if isinstance(value, tuple):
        place = plain(value, answer)
        return [z3.Not(value[place])] if place >= 0 else list(value)
    return [value != answer.eval(value, model_completion=True)]


def say(**report):
    print(json.dumps(report), flush=True)


if __name__ == "__main__":
    problem, params, kind, seed, count, pins = sys.argv[1:]
    main(problem, json.loads(params), kind, int(seed), int(count), json.loads(pins))
