"""How each system is run. Every system answers the same requests:

first    one solution, as fast as it can
plain    many different solutions, as fast as it can
diverse  many solutions that differ much from each other (see diversity.py)
all      all solutions
"""
import json
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

import measure
from addresses import choices, variables
from paths import HERE, PYTHON, problem_file


@dataclass
class Request:
    problem: str
    params: dict
    kind: str
    seed: int = 1
    count: int = 0             # how many solutions; 0 is all
    limit: float = 60.0        # CPU seconds
    stamp_at: tuple = ()       # of which solutions to take the time
    pins: dict = field(default_factory=dict)   # {address: value}, which has to hold, too


@dataclass
class Answer:
    solutions: list = field(default_factory=list)   # {address: value}
    cpu: float = 0.0           # CPU seconds of the processes that solve
    start: float = 0.0         # of that, what is not solving: starting, reading the prepared model
    further: float = 0.0       # of that, what came after the first solution
    preparation: float = 0.0   # not of that: flattening, grounding
    memory: int = 0
    stamps: dict = field(default_factory=dict)
    out_of_time: bool = False
    refused: str = ""          # why the system does not do this

    @property
    def solving(self):
        return max(self.cpu - self.start, 0.0)


def complaint(child):
    lines = [line for line in child.errors.splitlines() if line.strip() and not line.startswith("Warning")]
    return lines[0] if lines else f"exit status {child.status}"


def further_cpu(child, count):
    """CPU seconds from the first to the last solution that came."""
    if not child.stamps.get(1):
        return 0.0
    return (child.stamps.get(count) or child.cpu) - child.stamps[1]


def said_version(command, pattern):
    child = subprocess.run(command, capture_output=True, text=True)
    return re.search(pattern, child.stdout + child.stderr).group(1)


class Solitaire:
    """The program as its users run it, but with one job, so that CPU seconds say how long it takes."""

    def __init__(self, name, binary, arguments=()):
        self.name = name
        self.binary = binary
        self.arguments = list(arguments)

    def version(self):
        return subprocess.run([self.binary, "--version"], capture_output=True, text=True).stdout.strip()

    def solve(self, request, *arguments, wanted=None):
        settings = [f"--set={name}={json.dumps(value)}" for name, value in request.params.items()]
        settings += [f"--pin={at}={json.dumps(value)}" for at, value in request.pins.items()]
        command = [self.binary, "solve", str(problem_file(request.problem, ".sol")), "--json", "--quiet", "--jobs=1",
                   f"--seed={request.seed}", *settings, *self.arguments, *arguments]
        return measure.run(command, request.limit, wanted, stamp_at=request.stamp_at)

    def answer(self, request):
        if request.kind == "all":
            child = self.solve(request, "--all")
        elif request.kind == "plain":
            child = self.solve(request, "-n", str(request.count), "--diversity=low", wanted=request.count)
        else:
            child = self.solve(request, "-n", str(request.count), wanted=request.count)
        if child.status in (2, 3):
            return Answer(refused=complaint(child))
        solutions = [{choice["at"]: choice["value"] for choice in json.loads(line)["choices"]} for line in child.lines]
        return Answer(solutions, child.cpu, further=further_cpu(child, len(solutions)), memory=child.memory,
                      stamps=child.stamps, out_of_time=child.out_of_time)

    def accepts(self, problem, params, solution, limit):
        """Whether these choices, all of them, are a solution."""
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump({"choices": [{"at": at, "value": value} for at, value in solution.items()]}, file)
            file.flush()
            child = self.solve(Request(problem, params, "first", limit=limit), "--pin-file", file.name, "-n", "1")
            if child.status != 0:
                return False
            return {choice["at"] for choice in json.loads(child.lines[0])["choices"]} == set(solution)


class Restarted:
    """Another system, run anew with a fresh seed for each diverse solution, of which there may be fewer than asked for."""

    def __init__(self, system, most=None):
        self.system = system
        self.most = most
        self.name = system.name
        self.version = system.version

    def answer(self, request):
        if request.kind != "diverse":
            return self.system.answer(request)
        total = Answer()
        seen = set()
        attempt = 0
        count = min(request.count, self.most or request.count)
        while len(total.solutions) < count and attempt < 3 * count:
            one = self.system.answer(Request(request.problem, request.params, "diverse",
                                             1000 * request.seed + attempt, 1, request.limit - total.solving))
            attempt += 1
            if one.refused:
                return one
            had_some = bool(total.solutions)
            add_up(total, one, had_some)
            for solution in one.solutions:
                key = tuple(sorted(solution.items()))
                if key not in seen:
                    seen.add(key)
                    total.solutions.append(solution)
            if one.out_of_time or total.solving >= request.limit - 1 or not one.solutions:
                total.out_of_time = len(total.solutions) < count
                break
        return total


def add_up(total, one, is_further):
    total.cpu += one.cpu
    total.start += one.start
    total.preparation = one.preparation
    total.memory = max(total.memory, one.memory)
    if is_further:
        total.further += one.cpu - one.start


class Peer:
    """What the peers have in common: a model that is prepared once, and CPU seconds that starting takes."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        self.prepared = {}
        self.starts = {}

    def prepare(self, request):
        """The prepared model's file and the CPU seconds that preparing took."""
        key = (request.problem, *sorted(request.params.items()), *request.pins.items(), self.variant(request))
        if key not in self.prepared:
            path = str(Path(self.folder.name) / f"{len(self.prepared)}")
            child = measure.run(self.preparing(request, path), request.limit)
            if child.status != 0 or child.out_of_time:
                self.prepared[key] = None, child.cpu, "" if child.out_of_time else complaint(child)
            else:
                if not os.path.exists(path):
                    Path(path).write_text("".join(child.lines))
                self.prepared[key] = path, child.cpu, ""
        return self.prepared[key]

    def variant(self, request):
        return ""

    def start_cpu(self, path, *arguments):
        """The CPU seconds of a run that does not come to solving anything: the median of several."""
        if path not in self.starts:
            self.starts[path] = median(measure.run(self.solving(path, *arguments), 60).cpu for _ in range(5))
        return self.starts[path]


class Gecode(Peer):
    """MiniZinc's FlatZinc, run by Gecode. Where a model's search is random, it restarts after some failures.

    Further solutions near the first one come by backtracking, for which a search must not restart: it is begun anew,
    with another seed, until one gets anywhere. Solutions that differ come from a fresh seed for each.
    """
    name = "gecode"
    FAILURES = {"workspace": 250}   # before a search begins anew; for others 1000: found best by trial

    def failures(self, request):
        return str(self.FAILURES.get(request.problem, 1000))

    def restarts(self, request):
        return ["-r", str(request.seed), "-restart", "luby", "-restart-scale", self.failures(request)]

    def version(self):
        minizinc = said_version(["minizinc", "--version"], r"version (\S+)")
        return f"MiniZinc {minizinc}, Gecode {said_version(['fzn-gecode', '--help'], 'Version: (.*)')}"

    def variant(self, request):
        return request.kind == "all"

    def preparing(self, request, path):
        pinned = str(path) + ".pins.mzn"
        Path(pinned).write_text("".join(f"constraint {array}[{index}] = {value};\n" for array, index, value
                                        in variables(request.problem, request.params, request.pins)))
        data = {**request.params, "random": request.kind != "all"}
        text = "".join(f"{name} = {json.dumps(value)};" for name, value in data.items())
        return ["minizinc", "--compile", "--solver", "gecode", "--no-output-ozn", "--fzn", path,
                str(problem_file(request.problem, ".mzn")), pinned, "-D", text]

    def solving(self, path, *arguments):
        return ["fzn-gecode", *arguments, path]

    def answer(self, request):
        path, preparation, why = self.prepare(request)
        if not path:
            return Answer(preparation=preparation, out_of_time=True, refused=why)
        total = Answer(preparation=preparation)
        if request.kind == "all":
            self.search(total, request, path, "-n", "0")
        elif request.kind == "plain":
            self.hunt(total, request, path)
        else:
            self.search(total, request, path, "-n", "1", *self.restarts(request))
        return total

    def hunt(self, total, request, path):
        """Begins anew until a search comes to a solution soon, and then lets that search go on."""
        attempt = 0
        while not total.solutions and not total.out_of_time:
            attempt += 1
            seed = str(1000 * request.seed + attempt)
            self.search(total, request, path, "-n", "1", "-r", seed, "-fail", self.failures(request))
        if not total.out_of_time:
            total.solutions = []
            self.search(total, request, path, "-n", str(request.count), "-r", seed)

    def search(self, total, request, path, *arguments):
        left = request.limit - total.solving
        if left < 0.5:
            total.out_of_time = True
            return
        child = measure.run(self.solving(path, "-s", *arguments), left, request.count or None,
                            lambda line: line.startswith("----------"), request.stamp_at, ends_itself=True)
        total.cpu += child.cpu
        total.memory = max(total.memory, child.memory)
        total.start += self.start_of(child, path)
        values = flatzinc_values(child.lines)
        total.solutions += [choices(request.problem, request.params, solution) for solution in values]
        total.further += further_cpu(child, len(values))
        total.stamps = child.stamps
        total.out_of_time = child.out_of_time

    def start_of(self, child, path):
        """What it did not spend on solving, by its own account; a run that was stopped gives none, and is compared with
        one that reads the model and stops at the root."""
        solving = [float(line.partition("=")[2]) for line in child.lines if line.startswith("%%%mzn-stat: solveTime=")]
        return max(child.cpu - solving[0], 0.0) if solving else self.start_cpu(path, "-node", "1")


def flatzinc_values(lines):
    """Solutions as {array: {index from 1: value}}."""
    solutions = []
    current = {}
    for line in lines:
        if line.startswith("----------"):
            solutions.append(current)
            current = {}
            continue
        name, equals, right = line.partition(" = ")
        if not equals:
            continue
        elements = re.findall(r"-?\d+|true|false", right.rpartition("[")[2])
        current[name] = {index: number(element) for index, element in enumerate(elements, 1)}
    return solutions


def number(text):
    return {"true": 1, "false": 0}[text] if text in ("true", "false") else int(text)


class Clasp(Peer):
    """gringo grounds once, clasp solves. Solutions that differ come from random signs and a restart after each."""
    name = "clasp"
    COMMON = ["--configuration=handy", "--sat-prepro=0"]
    RANDOM = ["--sign-def=rnd", "--save-progress=0", "--enum-mode=record", "--restart-on-model"]

    def version(self):
        return ", ".join(f"{tool} {said_version([tool, '--version'], 'version (.*)')}" for tool in ("gringo", "clasp"))

    def preparing(self, request, path):
        constants = [word for name, value in request.params.items()
                     for word in ("-c", f"{name}={int(value)}")]
        pinned = str(path) + ".pins.lp"
        Path(pinned).write_text("".join(f":- not {array}({index},{value}).\n" for array, index, value
                                        in variables(request.problem, request.params, request.pins)))
        return ["gringo", *constants, str(problem_file(request.problem, ".lp")), pinned]

    def empty(self):
        """A program of nothing. Reading the ground program is part of clasp's solving: it simplifies while it reads."""
        path = Path(self.folder.name) / "empty"
        path.write_text("asp 1 0 0\n0\n")
        return str(path)

    def solving(self, path, *arguments):
        # Lines leave clasp as they come only if it is told to.
        return ["stdbuf", "-oL", "clasp", "-V0", "-q0", *arguments, path]

    def answer(self, request):
        path, preparation, why = self.prepare(request)
        if not path:
            return Answer(preparation=preparation, out_of_time=True, refused=why)
        arguments = {"first": ["-n", "1", *self.COMMON],
                     "plain": ["-n", str(request.count), *self.COMMON],
                     "diverse": ["-n", str(request.count), *self.COMMON, *self.RANDOM],
                     "all": ["-n", "0"]}[request.kind]
        child = measure.run(self.solving(path, f"--seed={request.seed}", *arguments), request.limit,
                            request.count or None, is_model, request.stamp_at)
        solutions = [choices(request.problem, request.params, atoms(line)) for line in child.lines if is_model(line)]
        return Answer(solutions, child.cpu, self.start_cpu(self.empty()), further_cpu(child, len(solutions)), preparation,
                      child.memory, child.stamps, child.out_of_time)


def is_model(line):
    return "(" in line


def atoms(line):
    values = {}
    for name, index, value in re.findall(r"(\w+)\((\d+),(-?\d+)\)", line):
        values.setdefault(name, {})[int(index)] = int(value)
    return values


class Z3(Peer):
    """Z3 by its Python interface; z3_runner.py makes the model and takes the times."""
    name = "z3"

    def version(self):
        code = "import z3; print('Z3', z3.get_version_string())"
        return subprocess.run([PYTHON, "-c", code], capture_output=True, text=True).stdout.strip()

    def answer(self, request):
        command = [PYTHON, str(HERE / "z3_runner.py"), request.problem, json.dumps(request.params), request.kind,
                   str(request.seed), str(request.count),
                   json.dumps(variables(request.problem, request.params, request.pins))]
        child = measure.run(command, request.limit, request.count or None, lambda line: "values" in line)
        reports = [json.loads(line) for line in child.lines]
        if child.status == 1:
            return Answer(refused=child.errors.splitlines()[-1])
        solved = [report for report in reports if "values" in report]
        solutions = [choices(request.problem, request.params,
                             {name: dict(enumerate(values, 1)) for name, values in report["values"].items()})
                     for report in solved]
        start = reports[0]["start"] if reports else child.cpu
        further = solved[-1]["cpu"] - solved[0]["cpu"] if solved else 0.0
        done = len(solutions) >= (request.count or float("inf")) or any("end" in report for report in reports)
        return Answer(solutions, child.cpu, start, further, 0.0, child.memory,
                      {index: report["cpu"] for index, report in enumerate(solved, 1)}, not done)


def all_systems(binary):
    return [Solitaire("solitaire", binary), Restarted(Solitaire("thesis", binary, ["--engine=thesis"]), most=21),
            Restarted(Gecode()), Clasp(), Z3()]
