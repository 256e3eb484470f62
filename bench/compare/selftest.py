"""Checks the models, not the times: do all systems solve the same problems?"""
import random
import sys

from rows import TINY
from systems import Request


def run(systems):
    """With most choices pinned, or in tiny problems, each system finds the same set of solutions."""
    failed = False
    for problem, params, free in TINY:
        for seed in (1, 2, 3):
            pins = some_pins(systems[0], problem, params, free, seed)
            failed = not agree(systems, problem, params, pins) or failed
            if not pins:
                break
    return 1 if failed else 0


def some_pins(solitaire, problem, params, free, seed):
    """A solution's choices but for so many of them; none if all are free."""
    if free is None:
        return {}
    solution = solitaire.answer(Request(problem, params, "diverse", seed, 1)).solutions[0]
    left_free = set(random.Random(seed).sample(sorted(solution), free))
    return {at: value for at, value in solution.items() if at not in left_free}


def agree(systems, problem, params, pins):
    sets = {}
    title = f"{problem} {params}" + (f", {len(pins)} choices pinned" if pins else "")
    for system in systems:
        answer = system.answer(Request(problem, params, "all", limit=300, pins=pins))
        if answer.refused:
            print(f"{title}: {system.name} does not take part: {answer.refused}")
            continue
        sets[system.name] = {tuple(sorted(solution.items())) for solution in answer.solutions}
        if answer.out_of_time or len(sets[system.name]) != len(answer.solutions):
            print(f"{title}: {system.name} did not finish, or found a solution twice")
            return False
    same = len(set(map(frozenset, sets.values()))) == 1
    counts = ", ".join(f"{name} {len(found)}" for name, found in sets.items())
    print(f"{title}: {'the same' if same else 'DIFFERENT'} solutions: {counts}", flush=True)
    return same


def verify(rows, systems, options):
    """Solitaire runs solutions of the others, all choices pinned, and has to accept each."""
    checker, *others = systems
    if not hasattr(checker, "accepts"):
        sys.exit("--verify needs solitaire among the systems")
    failed = False
    for row in rows:
        for system in others:
            kind = "diverse" if "diverse" in row.kinds else "plain"
            answer = system.answer(Request(row.problem, row.params, kind, 1, 10, options.limit))
            right = [checker.accepts(row.problem, row.params, solution, options.limit) for solution in answer.solutions]
            print(f"{row.name}: {system.name}: {sum(right)} of {len(right)} accepted"
                  + (f" ({answer.refused})" if answer.refused else ""), flush=True)
            failed = failed or not all(right)
    return 1 if failed else 0
