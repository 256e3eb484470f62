"""What holds of the solutions under each option, said by the reference interpreter's solutions of the program."""

import json
import re
import subprocess
import tempfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import solitaire
from comparing import KNOWN, REFUSALS, Limits, reason_of, reference_results, shown_choices
from interpreter.values import is_number, plain, same

SECONDS = 20
STATUS_OF_MISTAKE, STATUS_OF_LIMIT = 3, 4


@dataclass
class Case:
    """A program that has solutions and no mistakes, and the random decisions about the options."""

    program: str
    script: Path
    results: object
    random: object

    def solutions(self):
        return told_apart(self.results)

    def run(self, command, *options):
        words = [self.program, command, str(self.script), "--timeout", str(SECONDS), *options]
        run = subprocess.run(words, capture_output=True, text=True, timeout=5 * SECONDS, check=False)
        fault = solitaire.FAULT.search(run.stderr)
        if fault or run.returncode < 0:
            raise Wrong(f"{' '.join(options)}: {fault.group() if fault else run.returncode}")
        refused = run.returncode == STATUS_OF_MISTAKE and reason_of(run.stderr, {**REFUSALS, **KNOWN})
        if refused or run.returncode == STATUS_OF_LIMIT:
            raise NoAnswer
        if run.returncode not in (0, 1):
            raise Wrong(f"{' '.join(options)}: {run.stderr}")
        return run

    def solve(self, *options):
        """The solutions in their order, as read from JSON."""
        return [json.loads(line) for line in self.run("solve", "--json", *options).stdout.splitlines()]


class Wrong(Exception):
    """An answer is not right; the message says which."""


class NoAnswer(Exception):
    """A limit came first, or the solver refuses the program as it may."""


def key_of(choices):
    return json.dumps(sorted(choices.items()))


def told_apart(results):
    """One of each set of solutions that differ in auxiliary choices alone, by its other choices."""
    made = [{choice["at"]: choice["value"] for choice in shown_choices(each)} for each in results.solutions]
    return list({key_of(each): each for each in made}.values())


def choices_in(found):
    return {choice["at"]: choice["value"] for choice in found["choices"]}


def compare_choices(found, wanted, options):
    """The solutions found have to be the wanted ones, each once."""
    have, want = Counter(key_of(choices_in(each)) for each in found), Counter(map(key_of, wanted))
    if have != want:
        raise Wrong(f"{' '.join(options)}: too many {list(have - want)[:1]}, missed {list(want - have)[:1]}")


# ---- options that change nothing


def same_solutions(case):
    options = ["--all", "--engine", case.random.choice(["cadical", "z3"]), "--jobs", str(case.random.randint(1, 3)),
               "--diversity", case.random.choice(["low", "normal", "high"]), "--seed", str(case.random.randint(0, 9)),
               *case.random.choice([[], ["--check"]])]  # fmt: skip
    found = case.solve(*options)
    compare_choices(found, case.solutions(), options)


def published_way(case):
    """It need not find all of them."""
    wanted = {key_of(choices) for choices in case.solutions()}
    for found in case.solve("--engine", "thesis", "-n", "20"):
        if key_of(choices_in(found)) not in wanted:
            raise Wrong(f"--engine thesis: no solution {found}")


def uniform(case):
    if any(each.cost is not None for each in case.results.solutions):
        return  # wishes and probabilities do not go together
    options = ["--sample", "uniform", "-n", "2000", "--distinct", "choices"]
    found = case.solve(*options)
    compare_choices(found, case.solutions(), options)


def number(case):
    run = case.run("count", "--json", "--exact")
    if json.loads(run.stdout)["solutions"] != len(case.solutions()):
        raise Wrong(f"count: {run.stdout.strip()} instead of {len(case.solutions())}")


# ---- what makes solutions different


def distinct_values(case):
    found = case.solve("--all", "--distinct", "value")
    values = Counter(json.dumps(solitaire.one_zero(plain(each.returned))) for each in case.results.solutions)
    if len(found) != len(values):
        raise Wrong(f"--distinct value: {len(found)} solutions of {len(values)} values")
    if len({key_of(choices_in(each)) for each in found}) < len(found):
        raise Wrong("--distinct value: a solution comes twice")


def look_of(thing):
    """What a placed thing looks like: all but its name and its extras, which generated programs give no look."""
    shown = {name: plain(value) for name, value in thing.items() if name not in ("name", "extras")}
    shown["at"] = [*map(float, shown.get("at", [])), 0.0, 0.0, 0.0][:3]
    shown["turn"] = shown.get("turn", 0) % 4
    return json.dumps(solitaire.one_zero(shown), sort_keys=True)


def distinct_results(case):
    options = ["--all", "--distinct", "result", *case.random.choice([[], ["--diversity", "normal"]])]
    found = case.solve(*options)
    looks = {json.dumps([solitaire.one_zero(plain(each.value)), sorted(map(look_of, each.placed))])
             for each in case.results.solutions}  # fmt: skip
    if len(found) != len(looks):
        raise Wrong(f"{' '.join(options)}: {len(found)} solutions of {len(looks)} looks")


def distance(a, b):
    addresses = {*a, *b}
    differing = sum(a.get(each) != b.get(each) for each in addresses)
    return differing / len(addresses) if addresses else 0


def far_apart(case):
    least = case.random.choice([0.3, 0.5, 0.8, 1.0])
    found = case.solve("--all", "--min-distance", str(least))
    kept = [choices_in(each) for each in found]
    for i, one in enumerate(kept):
        if any(distance(one, other) < least - 1e-6 for other in kept[:i]):
            raise Wrong(f"--min-distance {least}: {one} is too near")
    for choices in case.solutions():
        if all(distance(choices, other) >= least for other in kept):
            raise Wrong(f"--min-distance {least}: missed {choices}")


# ---- params


def other_param(case):
    """Another value of a param is like another default in the program."""
    source = case.script.read_text(encoding="utf-8")
    params = re.findall(r"^param (\w+) = (-?\d+);$", source, re.MULTILINE)
    if not params:
        return
    name, value = case.random.choice(params)[0], case.random.randint(-2, 4)
    results = reference_results(case.script, [(name, str(value))], Limits(executions=2000))
    if results.errors:
        return
    options = ["--all", "--set", f"{name}={value}"]
    compare_choices(case.solve(*options), told_apart(results), options)


# ---- pins


def pinned_value(execution, address):
    """What a pin says to keep the value of a choice: an element, or its position where the list has no numbers."""
    value, elements = execution.choices[address], execution.chosen_from.get(address)
    if elements is None or (not is_plain(elements[value]) and not any(map(is_number, elements))):
        return value
    return elements[value] if is_plain(elements[value]) else None


def is_plain(value):
    return type(value) in (bool, int, float, str)


def pinned(case):
    """One or two pins or forbidden values of a solution's choices."""
    solutions = case.results.solutions
    if any(each.auxiliary for each in solutions):
        return
    picked, options = case.random.choice(solutions), []
    for address in case.random.sample(sorted(picked.choices), min(len(picked.choices), case.random.randint(1, 2))):
        value, keep = pinned_value(picked, address), case.random.random() < 0.7
        if value is None:
            continue
        options += ["--pin" if keep else "--forbid", f"{address}={json.dumps(value)}"]
        solutions = [each for each in solutions
                     if address not in each.choices or same(pinned_value(each, address), value) is keep]  # fmt: skip
    found = case.solve("--all", *options)
    compare_choices(found, [each.choices for each in solutions], options)


def pinned_by_file(case):
    """All solutions that agree with one found earlier in what --keep names."""
    solutions = case.solutions()
    earlier = case.solve("-n", "1", "--seed", str(case.random.randint(0, 9)))
    if not earlier or not choices_in(earlier[0]):
        return
    picked = choices_in(earlier[0])
    kept = case.random.sample(sorted(picked), case.random.randint(1, len(picked)))
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(json.dumps(earlier[0]))
        file.flush()
        options = ["--pin-file", file.name, *(word for each in kept for word in ("--keep", each))]
        found = case.solve("--all", *options)
    below = [each for each in picked if any(re.match(re.escape(keep) + r"(/|$)", each) for keep in kept)]
    wanted = [each for each in solutions if all(each.get(at, picked[at]) == picked[at] for at in below)]
    compare_choices(found, wanted, options)


# What chooses floats, with values that a pin can give it.
CHOSEN_FLOATS = {
    "uniform(0, 2)": [0, 0.25, 0.5, 1.0],
    "normal(0, 1)": [-1.5, 0, 0.5],
    "exponential(0.5)": [0.5, 2.25],
    "gamma(2, 1)": [0.5, 1.0],
    "beta(2, 3)": [0.25, 0.5],
}
# What may be done with a chosen float. Each line has one choice at most.
USES_OF_FLOAT = [
    'if chosen_float * 3 > 1.0 {{ print("high", chosen_float); }}',
    "assert(chosen_float * range(0, 2) < 0.8);",
    "of_float = range(0, abs(floor(chosen_float * 2)));",
    "if chosen_float == 0.5 {{ halved = flip(); }}",
    "between = if chosen_float < 0.4 then 1 else choose([0, 2]);",
    "fun is_less(limit) {{ return chosen_float + 0.1 < limit; }}\nassert(is_less(0.3) or is_less(range(0, 3)));",
]


def pinned_float(case):
    """A chosen float that is pinned is like a float that the program has."""
    chosen, values = case.random.choice(list(CHOSEN_FLOATS.items()))
    value = case.random.choice(values)
    uses = case.random.sample(USES_OF_FLOAT, case.random.randint(1, 3))
    program = "\n".join(["chosen_float = {};", *uses, case.script.read_text(encoding="utf-8").replace("{", "{{").replace("}", "}}")])
    case.script.write_text(program.format(float(value)), encoding="utf-8")
    results = reference_results(case.script, (), Limits(executions=4000))
    case.script.write_text(program.format(chosen), encoding="utf-8")
    if results.errors:
        return
    options = ["--all", "--pin", f"chosen_float={value}"]
    found = case.solve(*options)
    for each in found:
        each["choices"] = [choice for choice in each["choices"] if choice["at"] != "chosen_float"]
    compare_choices(found, told_apart(results), options)


# ---- the order of solutions


def cheapest_first(case):
    costs = sorted({key_of({c["at"]: c["value"] for c in shown_choices(each)}): each.cost or 0
                    for each in case.results.solutions}.values())  # fmt: skip
    if any(each.auxiliary for each in case.results.solutions):
        return  # a cost may depend on them
    found = case.solve("-n", str(min(4, len(costs))))
    if [each.get("cost", 0) for each in found] != costs[: len(found)]:
        raise Wrong(f"costs {[each.get('cost', 0) for each in found]} instead of {costs[:len(found)]}")


def near_misses(case):
    """Those that break fewest asserts come first, the cheaper ones before others."""
    relaxed = reference_results(case.script, (), Limits(executions=600), relaxed=True)
    if relaxed.errors or not relaxed.solutions:
        return
    best = min((len(each.broken), each.cost or 0) for each in relaxed.solutions)
    found = case.solve("--relax", "-n", "2")
    have = (len(found[0].get("broken", [])), found[0].get("cost", 0)) if found else None
    if have != best:
        raise Wrong(f"--relax: broken asserts and cost are {have} instead of {best}")


# ---- formulas


def proof(case):
    """Once all solutions are found, the clauses that are left cannot be satisfied."""
    with tempfile.TemporaryDirectory() as folder:
        formula = Path(folder) / "left.cnf"
        case.solve("--all", "--formula", str(formula))
        solved = subprocess.run(["cadical", "-q", "-n", str(formula)], capture_output=True, check=False)
        if solved.returncode != 20:
            raise Wrong(f"--formula: cadical ends with {solved.returncode}, not with 20 for unsatisfiable")


# ---- runs that are interrupted


def resumed(case):
    """A run in two parts leaves the files of one in one part."""
    options = ["--quiet", "--seed", str(case.random.randint(0, 9)), "--jobs", str(case.random.randint(1, 2))]
    with tempfile.TemporaryDirectory() as folder:
        if case.random.random() < 0.5:
            case.run("generate", "-n", "2", "-o", f"{folder}/parts", *options)
        else:
            kill_soon(case, ["generate", "-n", "6", "-o", f"{folder}/parts", *options])
        case.run("generate", "-n", "6", "-o", f"{folder}/whole", *options)
        case.run("generate", "-n", "6", "-o", f"{folder}/parts", "--resume", *options)
        whole, parts = files_in(f"{folder}/whole"), files_in(f"{folder}/parts")
        if whole != parts:
            differing = [name for name in {*whole, *parts} if whole.get(name) != parts.get(name)]
            raise Wrong(f"--resume: other files {sorted(differing)}")


def kill_soon(case, words):
    command = [case.program, words[0], str(case.script), *words[1:]]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            process.wait(case.random.uniform(0.005, 0.08))
        except subprocess.TimeoutExpired:
            process.kill()


def files_in(folder):
    return {path.name: path.read_bytes() for path in Path(folder).glob("[!.]*-[0-9]*.*")}


CHECKS = [same_solutions, same_solutions, published_way, uniform, number, distinct_values, distinct_results, far_apart,
          other_param, pinned, pinned, pinned_by_file, pinned_float, cheapest_first, near_misses, proof, resumed]  # fmt: skip
