"""Runs the program under test."""

import json
import re
import subprocess
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

LIBRARY = Path(__file__).resolve().parents[2] / "solitaire"

ERROR = re.compile(r"^(?P<file>[^\n:]+):(?P<line>\d+):\d+: error: (?P<message>.*)$", re.MULTILINE)
FAULT = re.compile(r"^internal error: .*$|.*runtime error: .*|.*AddressSanitizer.*", re.MULTILINE)


@dataclass
class Answer:
    """What a run gave. `solutions` counts solution keys; `errors` are (file, line, message) of mistakes in the program."""

    solutions: Counter = field(default_factory=Counter)
    printed: Counter = field(default_factory=Counter)
    errors: list = field(default_factory=list)
    fault: str = ""  # what no program may cause: a crash or an internal error
    complete: bool = False  # whether it is said that there is no other solution
    stopped: bool = False  # whether a limit came first


def one_zero(value):
    """The value with 0.0 for each -0.0: they are the same number, and either may be the result of `max` or `min`."""
    if isinstance(value, list):
        return [one_zero(each) for each in value]
    if isinstance(value, dict):
        return {name: one_zero(each) for name, each in value.items()}
    return 0.0 if isinstance(value, float) and value == 0 else value


def solution_key(value, cost, choices):
    """A solution as text: equal for equal solutions, whatever the order of choices. True is not 1 here."""
    return json.dumps([sorted((choice["at"], choice["value"]) for choice in choices), one_zero(value), cost or 0])


def printed_lines(lines):
    """How often each line was printed, with one zero as in values."""
    return Counter(re.sub(r"-0\.0(?![0-9])", "0.0", line) for line in lines)


def read_answer(process):
    answer = Answer()
    for line in process.stdout.splitlines():
        found = json.loads(line)
        answer.solutions[solution_key(found["value"], found.get("cost"), found["choices"])] += 1
    for match in ERROR.finditer(process.stderr):
        answer.errors.append((match["file"], int(match["line"]), match["message"]))
    fault = FAULT.search(process.stderr)
    if fault or process.returncode < 0:
        answer.fault = fault.group() if fault else f"ended by signal {-process.returncode}"
    if not answer.errors:
        answer.printed = printed_lines(process.stderr.splitlines())
    answer.complete = process.returncode in (0, 1) and not answer.errors
    answer.stopped = process.returncode == 4
    return answer


def solve(program, script, options=(), seconds=60):
    """All solutions of a script, by `solitaire solve --all`."""
    command = [program, "solve", str(script), "--all", "--json", "--quiet", "--jobs", "1",
               "--timeout", str(seconds), *options]  # fmt: skip
    try:
        return read_answer(subprocess.run(command, capture_output=True, text=True, timeout=2 * seconds + 10))
    except subprocess.TimeoutExpired:
        return Answer(fault="did not keep its --timeout")
