#!/usr/bin/env python3
"""Steps and effective draws per second of `solitaire sample`, beside programs written by hand, WebPPL, JAGS and Stan.

    python3 bench/sampling/compare.py BUILD [--rounds N] [MODEL...]

BUILD is the folder of a release build with SOLITAIRE_BENCH. Each model is measured in rounds, in which everything runs once, one
after the other; of five rounds, or N, the best counts. So a disturbance of the machine meets all alike; seconds are those of the
processor, not of the clock. Prints a table in Markdown, a row when its model is done, and then what is asked of the ratios beside
what they are. Takes about eight minutes in all.

- Solitaire: one chain of each engine. Its seconds contain everything: reading the program, the warm-up, the summary. "slices"
  are Metropolis steps by compiled slices alone, as the programs by hand make them (bench/sampling/figures.cpp), and
  "interpreted" the same without machine code; not of models whose choices come and go. Two more models, platform and workspace,
  are layouts (bench/sampling/layouts/).
- By hand: bench/sampling/twins/, in C++; "rescoring" computes the whole density for each step, "incremental" what changes.
- WebPPL (`npm install webppl@0.9.15` in bench/sampling/webppl): steps of its kernel MH, of the models in that folder, without
  its start.
- JAGS (the command `jags`): the models of bench/sampling/jags/, with its start and warm-up, and effective draws by the same
  estimate as Solitaire's.
- Stan (the R package `rstan`): the models of bench/sampling/stan/, with effective draws by that estimate. Its seconds are of
  the warm-up and the draws alone: to compile a model takes most of a minute, which is done before the first round.

What is not installed is left out.
"""

import argparse
import functools
import json
import math
import re
import resource
import shutil
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "examples" / "sampling"
LAYOUTS = HERE / "layouts"
TWIN_SECONDS = 0.3
# How many draws shred and lightweight make, and how many steps WebPPL: a second's work, or less.
MODELS = {
    "ising": (10000, 40, 3000),
    "regression": (200000, 400, 5000),
    "rats": (20000, 10, 2000),
    "mixture": (50000, 200, 10000),
    "infinite_mixture": (30000, 100, 0),
    "lda": (8000, 4, 1000),
    "hdp": (20000, 60, 0),
    "citations": (50000, 200, 0),
    "sum_or_product": (50000, 4000, 30000),
    "polynomial": (50000, 800, 20000),
    "platform": (20000, 400, 0),
    "workspace": (200, 2, 0),
}
JAGS_DRAWS = {"regression": 20000, "rats": 10000, "lda": 2000}
STAN_DRAWS = {"regression": 4000, "rats": 4000, "lda": 400}
MONITORED = {"regression": ["intercept", "slope"], "rats": ["alpha_c", "beta_c", "tau"], "lda": ["high_share", "low_share"]}
OPEN = ["polynomial"]  # models whose choices come and go


def script_of(model):
    example = EXAMPLES / f"{model}.sol"
    return example if example.exists() else LAYOUTS / f"{model}.sol"


def data_of(model):
    """The lists of numbers that the example's text has, by name."""
    text = script_of(model).read_text()
    text = re.sub(r"//.*", "", text)
    found = re.findall(r"^(\w+) = (\[[-\d.,\s\[\]]*\]);", text, re.MULTILINE)
    return {name: json.loads(numbers) for name, numbers in found}


def timed(command, folder=None):
    """What the command prints, and the seconds that it computes."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return run.stdout, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


# ---- Solitaire and programs written by hand


def solitaire(program, model, engine, draws, seed):
    command = [program, "sample", script_of(model), "--engine", engine, "--chains", "1", "--jobs", "1"]
    command += ["-n", str(draws), "--warmup", str(draws // 4), "--seed", str(seed), "--json", "-q"]
    printed, seconds = timed(command)
    summary = json.loads(printed)
    sizes = [each["ess_bulk"] for each in summary["parameters"] if each["ess_bulk"] is not None]
    return {"steps": summary["steps"] / seconds, "ess": min(sizes, default=0) / seconds}


def by_slices(program, model, seed, *how):
    command = [program, str(TWIN_SECONDS), model, str(seed + 1), *how]
    printed = subprocess.run(command, capture_output=True, text=True, check=True)
    return {"steps": float(printed.stdout)}


def first_draw(program, model, seed):
    """How long it takes to read, trace and begin, in milliseconds."""
    command = [program, "sample", script_of(model), "--chains", "1", "--jobs", "1", "-n", "1", "--warmup", "0"]
    return {"ms": 1000 * timed([*command, "--seed", str(seed), "--json", "-q"])[1]}


def costs(program, model):
    """How many runs of the program tracing and slicing takes, alone and with the forms along all choices, and how many
    microseconds it takes to compile an operation."""
    printed = subprocess.run([program, "costs", model], capture_output=True, text=True, check=True).stdout
    return dict(zip(["runs", "runs with forms", "us"], map(float, printed.split())))


def by_hand(program, model, kind, seed):
    command = [program, str(seed + 1), str(TWIN_SECONDS), f"{model} {kind}"]
    line = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    return {"steps": float(line[2])} if line else {}


# ---- WebPPL


def webppl_command():
    local = HERE / "webppl" / "node_modules" / ".bin" / "webppl"
    return str(local) if local.exists() else shutil.which("webppl")


@functools.cache
def webppl_start(model):
    """The seconds until the first sample."""
    return min(webppl_seconds(model, 1) for _ in range(2))


def webppl(model, steps):
    return {"steps": steps / (webppl_seconds(model, steps) - webppl_start(model))}


def webppl_seconds(model, samples):
    text = (HERE / "webppl" / f"{model}.wppl").read_text()
    data = data_of(model)
    if model == "regression":
        points = data["points"]
        data = {"x": [x for x, _ in points], "y": [y for _, y in points]}
    program = f"var data = {json.dumps(data)};\n{text}\n"
    program += f"var result = Infer({{method: 'MCMC', kernel: 'MH', samples: {samples}, model: model}});\n'done'\n"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "model.wppl"
        file.write_text(program)
        return timed([webppl_command(), file])[1]


# ---- JAGS


def autocovariance(values, lag):
    return sum(a * b for a, b in zip(values, values[lag:])) / len(values)


def effective_size(values):
    """By sums of pairs of autocorrelations as long as these are positive and do not grow (Geyer 1992)."""
    mean = sum(values) / len(values)
    rest = [each - mean for each in values]
    variance = autocovariance(rest, 0)
    total, last, lag = 0.0, math.inf, 0
    while lag + 1 < len(rest):
        pair = min(last, (autocovariance(rest, lag) + autocovariance(rest, lag + 1)) / variance)
        if pair <= 0:
            break
        total, last, lag = total + pair, pair, lag + 2
    return len(values) / max(2 * total - 1, 1 / math.log10(len(values)))


def r_dump(name, value):
    """A list, or a list of lists as a matrix, which R keeps column by column."""
    if not isinstance(value[0], list):
        return f"`{name}` <- c({', '.join(map(str, value))})\n"
    columns = ", ".join(str(row[j]) for j in range(len(value[0])) for row in value)
    return f"`{name}` <- structure(c({columns}), .Dim = c({len(value)}, {len(value[0])}))\n"


def jags_data(model):
    data = data_of(model)
    if model == "regression":
        return {"x": [x for x, _ in data["points"]], "y": [y for _, y in data["points"]]}
    if model == "rats":
        return {"y": data["weights"]}
    return {"words": [[word + 1 for word in row] for row in data["documents"]], "ones": [1] * 4, "two": [1] * 2}


def jags(model, seed):
    draws = JAGS_DRAWS[model]
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "data.R").write_text("".join(r_dump(*each) for each in jags_data(model).items()))
        (work / "start.R").write_text(f'".RNG.name" <- "base::Mersenne-Twister"\n".RNG.seed" <- {seed + 1}\n')
        script = [f'model in "{HERE / "jags" / model}.bug"', 'data in "data.R"', "compile", 'parameters in "start.R"']
        script += ["initialize", f"update {draws // 4}"] + [f"monitor {name}" for name in MONITORED[model]]
        script += [f"update {draws}", "coda *", "exit"]
        (work / "run.cmd").write_text("\n".join(script) + "\n")
        seconds = timed(["jags", "run.cmd"], work)[1]
        values = [float(line.split()[1]) for line in (work / "CODAchain1.txt").read_text().splitlines()]
    monitored = [values[i : i + draws] for i in range(0, len(values), draws)]
    return {"ess": min(map(effective_size, monitored)) / seconds}


# ---- Stan


@functools.cache
def has_stan():
    found = shutil.which("Rscript") and subprocess.run(["Rscript", "-e", "library(rstan)"], capture_output=True, check=False)
    return bool(found) and found.returncode == 0


def stan(model, seed, compiled):
    draws = STAN_DRAWS[model]
    data = {name: value for name, value in jags_data(model).items() if name not in ("ones", "two")}
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "data.R").write_text("".join(r_dump(*each) for each in data.items()))
        command = ["Rscript", HERE / "stan" / "run.R", HERE / "stan" / f"{model}.stan", compiled / f"{model}.rds"]
        command += [work / "data.R", str(draws), str(seed + 1), work / "draws.csv", *MONITORED[model]]
        seconds = float(timed(command)[0].split()[-1])
        rows = [line.split(",") for line in (work / "draws.csv").read_text().splitlines()]
    return {"ess": min(effective_size([float(row[i]) for row in rows]) for i in range(len(rows[0]))) / seconds}


# ---- the tables

COSTS = ["ms", "runs", "runs with forms", "us"]  # which are better where they are smaller


def runners(build, compiled, model):
    program, twins = build / "app" / "solitaire", build / "bench" / "sampling_twins"
    many, few, webppl_steps = MODELS[model]
    found = {
        "shred": lambda seed: solitaire(program, model, "shred", many, seed),
        "lightweight": lambda seed: solitaire(program, model, "lightweight", few, seed),
        "incremental": lambda seed: by_hand(twins, model, "incremental", seed),
        "rescoring": lambda seed: by_hand(twins, model, "rescoring", seed),
        "first": lambda seed: first_draw(program, model, seed),
        "costs": lambda seed: costs(build / "bench" / "sampling_figures", model),
    }
    if model not in OPEN:
        found["slices"] = lambda seed: by_slices(build / "bench" / "sampling_figures", model, seed)
        found["interpreted"] = lambda seed: by_slices(build / "bench" / "sampling_figures", model, seed, "interpreted")
    if webppl_command() and webppl_steps:
        found["webppl"] = lambda seed: webppl(model, webppl_steps)
    if shutil.which("jags") and model in JAGS_DRAWS:
        found["jags"] = lambda seed: jags(model, seed)
    if model in STAN_DRAWS and has_stan():
        stan(model, 0, compiled)
        found["stan"] = lambda seed: stan(model, seed, compiled)
    return found


def best_of_rounds(runs, rounds):
    best = {}
    for seed in range(rounds):
        for name, run in runs.items():
            for what, rate in run(seed).items():
                better = min if what in COSTS else max
                best[name, what] = better(rate, best.get((name, what), rate))
    return best


COLUMNS = {
    "shred, steps/s": ("shred", "steps"),
    "lightweight": ("lightweight", "steps"),
    "slices": ("slices", "steps"),
    "interpreted": ("interpreted", "steps"),
    "C++ incremental": ("incremental", "steps"),
    "C++ rescoring": ("rescoring", "steps"),
    "WebPPL MH": ("webppl", "steps"),
    "shred, ESS/s": ("shred", "ess"),
    "lightweight, ESS/s": ("lightweight", "ess"),
    "JAGS, ESS/s": ("jags", "ess"),
    "Stan, ESS/s": ("stan", "ess"),
    "tracing, slicing and forms, runs": ("costs", "runs with forms"),
}


# What is asked: a row, the two that are compared, or one, and for each model the least ratio, or the most of a cost.
COMPILED, INTERPRETED = ("slices", "steps"), ("interpreted", "steps")
INCREMENTAL, RESCORING = ("incremental", "steps"), ("rescoring", "steps")
CLOSED = [model for model in MODELS if model not in OPEN]
ASKED = [
    ("compiled / incremental by hand", COMPILED, INCREMENTAL, {"rats": 0.8, "lda": 0.8, "ising": 0.5, "platform": 0.65}),
    ("compiled / rescoring by hand", COMPILED, RESCORING, {"rats": 2.5, "lda": 6, "regression": 0.7, "workspace": 0.8}),
    ("shred / reversible jumps by hand", ("shred", "steps"), RESCORING, {"polynomial": 0.7}),
    ("interpreted / incremental by hand", INTERPRETED, INCREMENTAL, {"ising": 0.4, "platform": 0.35, "rats": 0.3, "lda": 0.45}),
    ("interpreted / running again", INTERPRETED, ("lightweight", "steps"), {model: 100 for model in CLOSED}),
    ("compiled / WebPPL", COMPILED, ("webppl", "steps"), {model: 200 for model in CLOSED if MODELS[model][2]}),
    ("ESS/s / JAGS", ("shred", "ess"), ("jags", "ess"), {"rats": 0.8, "lda": 2, "regression": 1.5}),
    ("ESS/s / Stan", ("shred", "ess"), ("stan", "ess"), {"rats": 3}),
    ("tracing and slicing, runs", ("costs", "runs"), None, {model: 20 for model in MODELS}),
    ("compiling, µs for an operation", ("costs", "us"), None, {model: 0.5 for model in MODELS}),
    ("model to first draw, ms", ("first", "ms"), None, {model: 50 for model in MODELS}),
]


def compared(best, first, second):
    """Nothing where one of the two was not measured."""
    if first not in best or (second and second not in best):
        return None
    return best[first] / best[second] if second else best[first]


def print_asked(measured):
    print("\n| | model | asked | measured | |\n| --- | --- | --- | --- | --- |")
    for what, first, second, bounds in ASKED:
        for model, bound in bounds.items():
            found = compared(measured.get(model, {}), first, second)
            if found is None:
                continue
            passes = found <= bound if first[1] in COSTS else found >= bound
            print(f"| {what} | {model} | {bound} | {found:.3g} | {'pass' if passes else 'FAIL'} |")


def shown(rate):
    if rate is None:
        return ""
    return f"{rate:,.0f}".replace(",", " ") if rate >= 10 else f"{rate:.1f}"


def main():
    parser = argparse.ArgumentParser(description="see the top of this file")
    parser.add_argument("build", type=Path)
    parser.add_argument("models", nargs="*", metavar="MODEL", default=list(MODELS))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--compiled", type=Path, metavar="FOLDER", help="keeps Stan's compiled models for the next time")
    asked = parser.parse_intermixed_args()
    print("| model | " + " | ".join(COLUMNS) + " |")
    print("| --- " * (len(COLUMNS) + 1) + "|")
    measured = {}
    with tempfile.TemporaryDirectory() as passing:
        for model in asked.models:
            best = best_of_rounds(runners(asked.build, asked.compiled or Path(passing), model), asked.rounds)
            measured[model] = best
            print(f"| {model} | " + " | ".join(shown(best.get(key)) for key in COLUMNS.values()) + " |", flush=True)
    print_asked(measured)


if __name__ == "__main__":
    main()
