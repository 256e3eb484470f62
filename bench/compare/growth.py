"""What is measured of Solitaire alone: whether solutions stay cheap, and whether they vary as independent ones do."""
import json
import random
import tempfile
from pathlib import Path
from statistics import median

import measure as processes
from diversity import mean_distance
from paths import problem_file
from rows import SQUARES
from systems import Request, Solitaire

NAME = "solitaire alone"
MANY = 10000
WINDOW = 100
SERIES = [("workspace-1", "workspace", {"groups": 1, "most": 21, "aisle": 2, "chairs": 2}),
          ("workspace-2", "workspace", {"groups": 2, "most": 28, "aisle": 2, "chairs": 2}),
          ("squares", "squares", SQUARES)]


def measure(options):
    solitaire = Solitaire("solitaire", options.solitaire)
    return {"series": [series(solitaire, *one, options) for one in (SERIES[2:] if options.quick else SERIES)],
            "spread": [spread(solitaire, *one) for one in SPREAD],
            "overhead": overhead(solitaire, options)}


def series(solitaire, name, problem, params, options):
    """CPU seconds per solution at the beginning and at the end of many."""
    stamps = (1, 1 + WINDOW, MANY - WINDOW, MANY)
    answer = solitaire.answer(Request(problem, params, "diverse", 1, MANY, 3 * options.limit, stamps))
    found = len(answer.solutions)
    if found < MANY or None in (answer.stamps.get(stamp) for stamp in stamps[:3]):
        return {"name": name, "found": found}
    early = (answer.stamps[stamps[1]] - answer.stamps[1]) / WINDOW
    late = ((answer.stamps[MANY] or answer.cpu) - answer.stamps[MANY - WINDOW]) / WINDOW
    return {"name": name, "found": found, "early": early, "late": late, "memory": answer.memory}


def overhead(solitaire, options):
    """Scenes of workspace-6, and what share of the CPU time the solver does not take."""
    scenes = 20 if options.quick else 100
    with tempfile.TemporaryDirectory() as folder:
        settings = [f"--set={name}={value}" for name, value in OVERHEAD_PARAMS.items()]
        child = processes.run([solitaire.binary, "generate", str(problem_file("workspace", ".sol")), *settings,
                               "-n", str(scenes), "--jobs=1", "--timings", "--quiet", f"--output={folder}"], options.limit)
        manifest = Path(folder) / "workspace-run.json"
        if child.status != 0 or not manifest.exists():
            return {"found": len(list(Path(folder).glob("*.glb")))}
        timings = json.loads(manifest.read_text())["timings"]
    return {"scenes": scenes, "cpu": child.cpu, **timings}


OVERHEAD_PARAMS = {"groups": 6, "most": 56, "aisle": 2, "chairs": 2}


def spread(solitaire, name, problem, params, independent):
    """The mean distance of 100 solutions: Solitaire's own, by --sample uniform, and independent ones."""
    own = [mean_distance(solitaire.answer(Request(problem, params, "diverse", seed, 100)).solutions)
           for seed in (1, 2, 3)]
    sampler = Solitaire("uniform", solitaire.binary, ["--sample=uniform"])
    sampled = sampler.answer(Request(problem, params, "diverse", 1, 100))
    result = {"name": name, "own": median(own)}
    if sampled.refused:
        result["refused"] = sampled.refused
    elif len(sampled.solutions) == 100:
        result["sampled"] = mean_distance(sampled.solutions)
    if independent:
        stream = random.Random(1)
        result["independent"] = mean_distance([independent(stream, params) for _ in range(100)])
    return result


def random_squares(stream, params):
    """By rejection: throw all squares anew until none overlaps another."""
    most = params["grid"] - params["size"]
    while True:
        places = [(stream.randint(0, most), stream.randint(0, most)) for _ in range(params["squares"])]
        if all(abs(a[0] - b[0]) >= params["size"] or abs(a[1] - b[1]) >= params["size"]
               for index, a in enumerate(places) for b in places[:index]):
            return {f"{axis}[{index}]": place[number] for index, place in enumerate(places)
                    for number, axis in enumerate("xy")}


def random_queens(stream, params):
    rows = list(range(params["n"]))
    while True:
        stream.shuffle(rows)
        if all(len({row + sign * column for column, row in enumerate(rows)}) == len(rows) for sign in (1, -1)):
            return {f"row[{column}]": row for column, row in enumerate(rows)}


SPREAD = [("squares", "squares", SQUARES, random_squares), ("queens-8", "queens", {"n": 8}, random_queens),
          ("workspace-1", "workspace", SERIES[0][2], None)]
