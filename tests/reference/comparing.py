"""Holds the solutions that `solitaire` finds against those of the reference interpreter."""

import json
import re
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import solitaire
from interpreter.modules import load_program, param_values
from interpreter.search import Results, TooMany, all_executions
from interpreter.syntax import ProgramError
from interpreter.values import plain
from program_files import write_files

# What the solver may refuse though no execution comes to a mistake, by the manual: name -> a part of the message.
REFUSALS = {
    "float": "depends on a float that depends on choices",
    "62 bits": "past 62 bits",
    "text": "the program looks at what it says",
    "long range": "4096",
}
# What is known to be wrong today: name -> a part of the message. Each is left out of the comparison, and counted.
KNOWN = {}
STEPS_LIMIT = "this runs for more than"


@dataclass
class Limits:
    """Of one program. The solver gets more steps than the interpreter, since the two count differently."""

    executions: int = 1500
    steps: int = 20_000
    depth: int = 40
    seconds: int = 20


@dataclass
class Comparison:
    """`outcome` is equal, different, refused, known or skipped; `reason` says which refusal, or what differs."""

    outcome: str
    reason: str = ""
    results: Results = field(default_factory=Results)  # the interpreter's, unless they were too many


def shown_choices(execution):
    """The choices of an execution that are not auxiliary."""
    return [{"at": at, "value": value} for at, value in execution.choices.items() if at not in execution.auxiliary]


def reference_keys(results):
    return Counter(
        solitaire.solution_key(plain(each.value), each.cost, shown_choices(each)) for each in results.solutions
    )


def choices_of(key):
    """What of a solution's key its choices are. Of solutions that differ in auxiliary choices alone, one is enough."""
    return json.dumps(json.loads(key)[0])


def reason_of(message, table):
    return next((name for name, part in table.items() if part in message), None)


class Comparer:
    """Compares the results of one program."""

    def __init__(self, results, answer):
        self.results = results
        self.answer = answer
        self.expected = reference_keys(results)
        self.errors = {(Path(error.place.file).name, error.place.line) for error in results.errors}

    def result(self, outcome, reason=""):
        return Comparison(outcome, reason, self.results)

    def compare(self):
        if self.answer.fault:
            return self.result("different", self.answer.fault)
        wrong = [key for key in self.answer.solutions if key not in self.expected]
        if wrong:
            return self.result("different", f"no solution: {wrong[0]}")
        twice = [key for key, count in self.answer.solutions.items() if count > 1]
        if twice:
            return self.result("different", f"found twice: {twice[0]}")
        if self.answer.errors:
            return self.compare_error(*self.answer.errors[0])
        if self.answer.stopped:
            return self.result("skipped", "no answer in time")
        return self.compare_complete()

    def compare_error(self, file, line, message):
        place = (Path(file).name, line)
        if place in self.errors:
            return self.result("equal")
        known = reason_of(message, KNOWN)
        if known:
            return self.result("known", known)
        refusal = reason_of(message, REFUSALS)
        if refusal == "float" and not self.results.floats:
            return self.result("refused", "float that no execution has")
        if refusal:
            return self.result("refused", refusal)
        return self.result("different", f"no execution comes to this error: {file}:{line}: {message}")

    def compare_complete(self):
        if self.results.errors:
            return self.result("different", f"missed the error {self.results.errors[0]}")
        found = {choices_of(key) for key in self.answer.solutions}
        if len(found) < len(self.answer.solutions):
            return self.result("different", "two solutions differ in nothing but auxiliary choices")
        missed = [key for key in self.expected if choices_of(key) not in found]
        if missed:
            return self.result("different", f"missed {missed[0]}")
        if any(each.auxiliary for each in self.results.solutions):
            return self.result("equal")  # what is printed can depend on them
        printed = solitaire.printed_lines(line for each in self.results.solutions for line in each.printed)
        if printed != self.answer.printed:
            differing = (printed - self.answer.printed) + (self.answer.printed - printed)
            return self.result("different", f"printed otherwise: {next(iter(differing))}")
        return self.result("equal")


def compare(program, script, settings=(), limits=None):
    """Compares on a script. `settings` are pairs of a param's name and its text."""
    limits = limits or Limits()
    options = [word for name, text in settings for word in ("--set", f"{name}={text}")]
    options += ["--max-steps", str(10 * limits.steps), "--max-depth", str(limits.depth)]
    try:
        results = reference_results(script, settings, limits)
    except TooMany:
        return Comparison("skipped", "too many executions")
    if any(STEPS_LIMIT in error.message for error in results.errors):
        return Comparison("skipped", "runs for long")
    return Comparer(results, solitaire.solve(program, script, options, limits.seconds)).compare()


def reference_results(script, settings, limits, relaxed=False):
    """What the interpreter finds; a program that cannot be loaded has one error and no executions."""
    try:
        program = load_program(script, [solitaire.LIBRARY])
        params = param_values(program, settings)
    except ProgramError as error:
        return Results(errors=[error])
    return all_executions(program, params, limits.executions, limits.steps, limits.depth, relaxed)


def compare_files(program, files, settings=(), limits=None):
    """Compares on a program that is given as a dict of files, the script first."""
    with tempfile.TemporaryDirectory() as folder:
        return compare(program, write_files(files, folder), settings, limits)


def kind_of_difference(comparison):
    """What differs, without what names and numbers change; "" if nothing differs."""
    if comparison.outcome != "different":
        return ""
    return re.split(r"[\[\"0-9{/]", comparison.reason, maxsplit=1)[0]
