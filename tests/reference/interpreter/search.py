"""Finds all solutions of a program by running all of its executions, depth first."""

import random
from dataclasses import dataclass, field

from .evaluator import Execution
from .operators import Rejected
from .syntax import ProgramError


class TooMany(Exception):
    """There are more executions than allowed."""


@dataclass
class Results:
    solutions: list = field(default_factory=list)  # Executions
    errors: list = field(default_factory=list)  # ProgramErrors, one for each execution that comes to one
    executions: int = 0
    floats: set = field(default_factory=set)  # the places where some execution met a float after a choice


class Enumeration:
    """Goes through the values of choices like an odometer: the last choice that an execution met turns first."""

    def __init__(self):
        self.trail = []  # (domain, position) for each choice of the execution
        self.met = 0

    def choose(self, domain):
        if self.met == len(self.trail):
            self.trail.append((domain, 0))
        domain, position = self.trail[self.met]
        self.met += 1
        return domain[position]

    def advance(self):
        """Turns to the next execution; False if there is none."""
        self.met = 0
        while self.trail:
            domain, position = self.trail.pop()
            if position + 1 < len(domain):
                self.trail.append((domain, position + 1))
                return True
        return False


class Sampling:
    """Makes each choice at random. The product of the numbers of values is the number of executions on the average (Knuth,
    "Estimating the efficiency of backtrack programs", 1975)."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.product = 1

    def choose(self, domain):
        self.product *= len(domain)
        return domain[self.random.randrange(len(domain))]


SAMPLES = 4


def estimated_executions(run):
    samples = [Sampling(seed) for seed in range(SAMPLES)]
    for sample in samples:
        run(sample.choose)
    return sum(sample.product for sample in samples) / SAMPLES


MOST_STEPS_OF_ALL = 3_000_000
# By Markov's inequality, no more than one in so many programs is taken for too large that is not.
SURE = 1000


def all_executions(program, params=None, max_executions=2000, max_steps=200_000, max_depth=400, relaxed=False):
    """Runs the program in all of its executions, in which asserts may be broken if it is relaxed. Raises TooMany where they
    are, or take, more than allowed, and at once where that is all but certain."""

    def run(choose):
        execution = Execution(program, choose, params or {}, max_steps, max_depth, relaxed)
        try:
            execution.run()
            return execution, None
        except (Rejected, ProgramError) as end:
            return execution, end

    if estimated_executions(run) > SURE * max_executions:
        raise TooMany
    results = Results()
    steps = 0
    enumeration = Enumeration()
    while True:
        results.executions += 1
        if results.executions > max_executions or steps > MOST_STEPS_OF_ALL:
            raise TooMany
        execution, end = run(enumeration.choose)
        if end is None:
            results.solutions.append(execution)
        elif isinstance(end, ProgramError):
            results.errors.append(end)
        results.floats |= execution.floats
        steps += max_steps - execution.steps_left
        if not enumeration.advance():
            return results
