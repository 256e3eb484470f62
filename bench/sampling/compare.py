#!/usr/bin/env python3
"""Steps and effective draws per second of `solitaire sample`, beside hand-written C++.

    python3 bench/sampling/compare.py build/app/solitaire build/bench/sampling_twins

Runs each model with both engines, one chain, in turns, and takes the best of three runs. Prints a table in Markdown. The
hand-written programs are in bench/sampling/twins.cpp; "rescoring" computes the whole density for each step, "incremental" only
what changes.
"""

import json
import subprocess
import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "sampling"
# How many draws each engine makes: so many that a run takes about a second.
MODELS = {
    "ising": (4000, 40),
    "regression": (20000, 400),
    "rats": (2000, 10),
    "mixture": (20000, 200),
    "infinite_mixture": (10000, 100),
    "lda": (400, 4),
    "hdp": (2000, 60),
    "citations": (10000, 200),
    "sum_or_product": (20000, 4000),
    "polynomial": (8000, 800),
}
ROUNDS = 3


def sample(program, model, engine, draws, seed):
    command = [program, "sample", EXAMPLES / f"{model}.sol", "--engine", engine, "--chains", "1", "--jobs", "1"]
    command += ["-n", str(draws), "--warmup", str(draws // 4), "--seed", str(seed), "--json", "-q"]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def least_effective_rate(summary):
    """The fewest effective draws a second, over the numbers that vary."""
    sizes = [each["ess_bulk"] for each in summary["parameters"] if each["ess_bulk"] is not None]
    seconds = summary["steps"] / summary["steps_per_second"]
    return min(sizes, default=0) / seconds


def best(summaries):
    return max(each["steps_per_second"] for each in summaries), max(map(least_effective_rate, summaries))


def twin_rates(program):
    run = subprocess.run([program], capture_output=True, text=True, check=True)
    rates = {}
    for line in run.stdout.splitlines():
        model, kind, rate, _ = line.split()
        rates[model, kind] = float(rate)
    return rates


def rate(number):
    return f"{number:,.0f}".replace(",", " ") if number >= 10 else f"{number:.1f}"


def main():
    program, twins = sys.argv[1], twin_rates(sys.argv[2])
    print("| model | shred, steps/s | lightweight, steps/s | shred, ESS/s | lightweight, ESS/s | C++ rescoring | C++ incremental |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for model, (many, few) in MODELS.items():
        runs = {"shred": [], "lightweight": []}
        for seed in range(ROUNDS):
            runs["shred"].append(sample(program, model, "shred", many, seed))
            runs["lightweight"].append(sample(program, model, "lightweight", few, seed))
        fast, slow = best(runs["shred"]), best(runs["lightweight"])
        by_hand = [twins.get((model, kind)) for kind in ("rescoring", "incremental")]
        cells = [rate(fast[0]), rate(slow[0]), rate(fast[1]), rate(slow[1])]
        cells += ["" if each is None else rate(each) for each in by_hand]
        print(f"| {model} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
