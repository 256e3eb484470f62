"""Checks the models, not the times: do all systems solve the same problems?"""
import sys

from rows import TINY
from systems import Request


def run(systems):
    """On tiny problems each system finds the same set of solutions."""
    failed = False
    for problem, params in TINY:
        sets = {}
        for system in systems:
            answer = system.answer(Request(problem, params, "all", limit=300))
            if answer.refused:
                print(f"{problem} {params}: {system.name} does not take part: {answer.refused}")
                continue
            sets[system.name] = {tuple(sorted(solution.items())) for solution in answer.solutions}
            if answer.out_of_time or len(sets[system.name]) != len(answer.solutions):
                print(f"{problem} {params}: {system.name} did not finish, or found a solution twice")
                failed = True
        counts = ", ".join(f"{name} {len(found)}" for name, found in sets.items())
        same = len(set(map(frozenset, sets.values()))) == 1
        print(f"{problem} {params}: {'the same' if same else 'DIFFERENT'} solutions: {counts}", flush=True)
        failed = failed or not same
    return 1 if failed else 0


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
