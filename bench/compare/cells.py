"""A cell of the tables: one system, one row, one kind of request, over several seeds."""
from dataclasses import dataclass, field
from statistics import median

from diversity import mean_distance
from systems import Request

ENOUGH = 10    # further solutions of a run, for a time per solution to mean anything
RESOLUTION = 0.001   # seconds: no run can be told from one that takes less
CHECKED = 2    # solutions of each cell that Solitaire runs again


@dataclass
class Cell:
    seconds: list = field(default_factory=list)      # per solution, without preparation
    whole: list = field(default_factory=list)        # of a first solution, preparation and start included
    distances: list = field(default_factory=list)
    memory: int = 0
    found: int = 0              # the fewest solutions of a run
    limit: float = 0.0
    out_of_time: bool = False
    refused: str = ""
    wrong: int = 0              # solutions that Solitaire did not accept

    @property
    def value(self):
        return median(self.seconds) if self.seconds else None

    @property
    def whole_value(self):
        return median(self.whole) if self.whole else None

    @property
    def distance(self):
        return median(self.distances) if self.distances else None


def measure_cell(row, kind, system, checker, options):
    cell = Cell(limit=options.limit)
    spent = 0.0
    for seed in range(1, options.seeds + 1):
        answer = system.answer(Request(row.problem, row.params, kind, seed, count_of(row, kind), options.limit))
        if answer.refused:
            cell.refused = answer.refused
            return cell
        add(cell, answer, kind, row)
        if seed == 1 and kind != "all":
            cell.wrong = count_wrong(checker, row, answer.solutions[:CHECKED], options)
        spent += answer.cpu
        if answer.out_of_time or spent > options.cell_limit:
            break
    return cell


def count_of(row, kind):
    return {"first": 1, "all": 0}.get(kind, row.count + 1)


def add(cell, answer, kind, row):
    number = len(answer.solutions)
    cell.found = min(cell.found or number, number)
    cell.memory = max(cell.memory, answer.memory)
    cell.out_of_time = cell.out_of_time or answer.out_of_time
    if kind in ("first", "all"):
        if not answer.out_of_time:
            cell.seconds.append(max(answer.solving, RESOLUTION))
            cell.whole.append(answer.preparation + answer.cpu)
    elif number > ENOUGH:
        cell.seconds.append(max(answer.further, RESOLUTION) / max(number - 1, 1))
    if kind == "diverse" and number > 1:
        cell.distances.append(mean_distance(answer.solutions))


def count_wrong(checker, row, solutions, options):
    if not hasattr(checker, "accepts"):
        return 0
    return sum(not checker.accepts(row.problem, row.params, solution, options.limit) for solution in solutions)
