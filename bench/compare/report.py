"""Writes what was measured as Markdown."""
import datetime
import os
import platform
import subprocess
from pathlib import Path

SOLITAIRE = "solitaire"
DIVERSE_ENOUGH = 0.75
KINDS = {
    "first": ("First solution", "CPU seconds"),
    "plain": ("Further different solutions", "CPU milliseconds for each"),
    "diverse": ("Further solutions that differ much",
                "CPU milliseconds for each, in brackets the mean distance that was reached"),
    "all": ("All solutions", "CPU seconds"),
}


def write(rows, systems, cells, extras, options, seconds):
    parts = ["# Solitaire beside other solvers\n", heading(systems, options, seconds),
             goals_table(rows, systems, cells, extras)]
    for kind, (title, unit) in KINDS.items():
        chosen = [row for row in rows if kind in row.kinds]
        if chosen:
            parts.append(f"## {title}\n\n{unit}; medians over the seeds.\n\n" + kind_table(kind, chosen, systems, cells))
    parts += [preparation_table(rows, systems, cells), memory_table(rows, systems, cells), extras_part(extras),
              READING]
    return "\n".join(part for part in parts if part)


# ---- the heading

def heading(systems, options, seconds):
    lines = [f"- date: {datetime.date.today()}", f"- machine: {cpu_model()}, {os.cpu_count()} cores, {memory_size()}, "
             f"{system_name()}"]
    lines += [f"- {system.name}: {version(system)}" for system in systems]
    lines.append(f"- seeds: 1 to {options.seeds}; at most {options.limit:g} CPU seconds a run, and no further seed "
                 f"after {options.cell_limit:g} CPU seconds")
    lines.append(f"- took {seconds / 60:.0f} minutes; load of the machine at the end {os.getloadavg()[0]:.1f}")
    return "\n".join(lines) + "\n"


def version(system):
    try:
        return system.version()
    except (OSError, AttributeError):
        return "not installed"


def cpu_model():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return platform.machine()


def memory_size():
    kilobytes = int(Path("/proc/meminfo").read_text().split()[1])
    return f"{kilobytes / 1e6:.0f} GB"


def system_name():
    command = ". /etc/os-release && echo $PRETTY_NAME"
    return subprocess.run(["sh", "-c", command], capture_output=True, text=True).stdout.strip()


# ---- tables

def table(header, lines):
    rows = [header, ["---"] * len(header), *lines]
    return "\n".join("| " + " | ".join(str(entry) for entry in row) + " |" for row in rows) + "\n"


def kind_table(kind, rows, systems, cells):
    header = ["", *(system.name for system in systems), "best peer / solitaire"]
    lines = []
    for row in rows:
        entries = [entry(kind, cells[row.name, kind, system.name]) for system in systems]
        lines.append([row.name, *entries, ratio_text(ratio(kind, row, systems, cells))])
    return table(header, lines)


def entry(kind, cell):
    if cell.refused:
        return "n/a"
    if cell.value is None:
        text = f"> {cell.limit:g} s" if cell.found == 0 else f"{cell.found} in {cell.limit:g} s"
    elif kind in ("first", "all"):
        text = f"{cell.value:.3g}"
    else:
        text = f"{1000 * cell.value:.3g}"
    if kind == "diverse" and cell.distance is not None:
        text += f" ({cell.distance:.2f})"
    if cell.out_of_time and cell.value is not None:
        text += f", {cell.found} in {cell.limit:g} s"
    if cell.wrong:
        text += f" **{cell.wrong} WRONG**"
    return text


def ratio(kind, row, systems, cells):
    """How many times as long the fastest peer takes. None if one of the two has no figure."""
    own = cells.get((row.name, kind, SOLITAIRE))
    if own is None or own.value is None:
        return None
    peers = [cells[row.name, kind, system.name] for system in systems if system.name not in (SOLITAIRE, "thesis")]
    times = [cell.value for cell in peers if usable(kind, cell)]
    if not times:
        limits = [cell.limit for cell in peers if not cell.refused and cell.value is None]
        return float("inf") if limits else None
    return min(times) / own.value if own.value else None


def usable(kind, cell):
    if cell.value is None or cell.wrong:
        return False
    return kind != "diverse" or (cell.distance or 0) >= DIVERSE_ENOUGH


def ratio_text(value):
    if value is None:
        return ""
    if value == float("inf"):
        return "no peer"
    return f"{value:.2g}" if value < 100 else f"{value:.0f}"


def preparation_table(rows, systems, cells):
    peers = [system for system in systems if system.name not in (SOLITAIRE, "thesis")]
    lines = []
    for row in rows:
        kind = "first" if "first" in row.kinds else row.kinds[0]
        found = [cells[row.name, kind, system.name] for system in peers]
        lines.append([row.name, *("n/a" if cell.refused else f"{cell.prepared:.2g}" for cell in found)])
    if not peers or not lines:
        return ""
    text = "CPU seconds for flattening, grounding or making the model, and for starting. The tables above leave this out."
    return f"## What the peers prepare\n\n{text}\n\n" + table(["", *(peer.name for peer in peers)], lines)


def memory_table(rows, systems, cells):
    lines = []
    for row in rows:
        kind = "diverse" if "diverse" in row.kinds else row.kinds[0]
        found = [cells[row.name, kind, system.name] for system in systems]
        lines.append([row.name, *("n/a" if cell.refused else f"{cell.memory / 1e6:.0f}" for cell in found)])
    text = "Megabytes at the peak of the solving process, while it finds further solutions."
    return f"## Memory\n\n{text}\n\n" + table(["", *(system.name for system in systems)], lines)


# ---- Solitaire alone

def extras_part(extras):
    if not extras:
        return ""
    lines = []
    for one in extras["series"]:
        if "late" in one:
            lines.append([one["name"], f"{1000 * one['early']:.3g}", f"{1000 * one['late']:.3g}",
                          f"{one['late'] / one['early']:.2f}", f"{one['memory'] / 1e6:.0f}"])
        else:
            lines.append([one["name"], f"only {one['found']} in the time", "", "", ""])
    series = table(["", "ms each, 2nd to 101st", "ms each, the last 100 of 10,000", "ratio", "MB"], lines)
    lines = [[one["name"], f"{one['own']:.3f}", spread_text(one, "sampled"), spread_text(one, "independent")]
             for one in extras["spread"]]
    spread = table(["", "solitaire", "--sample uniform", "independent (rejection)"], lines)
    return (f"## Ten thousand solutions\n\n{series}\n## Mean distance of 100 solutions\n\n{spread}\n"
            "## Outside of the solver, workspace-6\n\nn/a: the command line does not tell yet.\n")


def spread_text(one, name):
    return f"{one[name]:.3f}" if name in one else "n/a"


# ---- goals

def goals_table(rows, systems, cells, extras):
    goals = [goal_of_ratios(title, kind, rows, systems, cells)
             for kind, title in (("first", "first solution as fast as the fastest peer's"),
                                 ("plain", "further solutions as fast as the fastest peer's"),
                                 ("diverse", "solutions that differ much as fast as the fastest peer's"),
                                 ("all", "all solutions as fast as the fastest peer"))]
    goals.append(goal_of_distance(rows, cells))
    goals.append(goal_of_memory(rows, systems, cells))
    if extras:
        goals += goals_of_extras(extras)
    return "## Goals\n\n" + table(["goal", "measured", "met?"], [goal for goal in goals if goal])


def goal_of_ratios(title, kind, rows, systems, cells):
    ratios = {row.name: ratio(kind, row, systems, cells) for row in rows if kind in row.kinds}
    ratios = {name: value for name, value in ratios.items() if value is not None}
    unsolved = [row.name for row in rows if kind in row.kinds and (row.name, kind, SOLITAIRE) in cells
                and cells[row.name, kind, SOLITAIRE].value is None]
    if not ratios and not unsolved:
        return None
    met = sum(value >= 1 for value in ratios.values())
    measured = f"{met} of {len(ratios) + len(unsolved)} rows"
    if unsolved:
        measured += f"; out of time: {', '.join(unsolved)}"
    elif met < len(ratios):
        worst = min(ratios, key=ratios.get)
        measured += f"; worst: {worst}, {ratio_text(1 / ratios[worst])} times the peer's time"
    return [title, measured, yes(met == len(ratios) + len(unsolved))]


def goal_of_distance(rows, cells):
    distances = {row.name: cells[row.name, "diverse", SOLITAIRE].distance for row in rows
                 if "diverse" in row.kinds and (row.name, "diverse", SOLITAIRE) in cells}
    distances = {name: value for name, value in distances.items() if value is not None}
    if not distances:
        return None
    worst = min(distances, key=distances.get)
    return [f"mean distance at least {DIVERSE_ENOUGH}", f"least: {distances[worst]:.2f}, {worst}",
            yes(distances[worst] >= DIVERSE_ENOUGH)]


def goal_of_memory(rows, systems, cells):
    ratios = {}
    for row in rows:
        kind = "diverse" if "diverse" in row.kinds else row.kinds[0]
        own = cells.get((row.name, kind, SOLITAIRE))
        peers = [cells[row.name, kind, system.name].memory for system in systems
                 if system.name not in (SOLITAIRE, "thesis") and cells[row.name, kind, system.name].memory]
        if own and own.memory and peers:
            ratios[row.name] = own.memory / min(peers)
    if not ratios:
        return None
    worst = max(ratios, key=ratios.get)
    return ["memory at most twice the most frugal peer's", f"worst: {ratios[worst]:.2g} times, {worst}",
            yes(ratios[worst] <= 2)]


def goals_of_extras(extras):
    goals = []
    ratios = {one["name"]: one["late"] / one["early"] for one in extras["series"] if "late" in one}
    if ratios:
        worst = max(ratios, key=ratios.get)
        goals.append(["the 10,000th solution takes at most twice the time of the 10th",
                      f"worst: {ratios[worst]:.2f} times, {worst}", yes(ratios[worst] <= 2)])
    shares = {one["name"]: one["own"] / one["independent"] for one in extras["spread"] if "independent" in one}
    if shares:
        worst = min(shares, key=shares.get)
        goals.append(["mean distance at least 95 % of that of independent solutions",
                      f"least: {100 * shares[worst]:.0f} %, {worst}", yes(shares[worst] >= 0.95)])
    return goals


def yes(met):
    return "yes" if met else "**no**"


READING = """## How to read this

bench/compare/README.md in the project says how each system is run. In short: Solitaire's figures are of the whole process,
reading and exploring the program included. Those of the peers leave out flattening, grounding, making the model and
starting, which favours the peers. The ratio is the fastest peer's time over Solitaire's, so more than 1 means that
Solitaire is faster; for solutions that differ much, only peers count that reach a mean distance of 0.75. "n in t s" is
the time per solution of a run that was cut short. "n/a" is what a system does not do.
"""
