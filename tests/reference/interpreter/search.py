"""Finds all solutions of a program by running all of its executions, depth first."""

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


MOST_STEPS_OF_ALL = 3_000_000


def all_executions(program, params=None, max_executions=2000, max_steps=200_000, max_depth=400, relaxed=False):
    """Runs the program in all of its executions, in which asserts may be broken if it is relaxed. Raises TooMany where they are, or take, more than allowed."""
    results = Results()
    steps = 0
    enumeration = Enumeration()
    while True:
        results.executions += 1
        if results.executions > max_executions or steps > MOST_STEPS_OF_ALL:
            raise TooMany
        execution = Execution(program, enumeration.choose, params or {}, max_steps, max_depth, relaxed)
        try:
            execution.run()
            results.solutions.append(execution)
        except Rejected:
            pass
        except ProgramError as error:
            results.errors.append(error)
        results.floats |= execution.floats
        steps += max_steps - execution.steps_left
        if not enumeration.advance():
            return results
