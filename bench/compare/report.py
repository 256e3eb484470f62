"""Writes what was measured as Markdown."""
import datetime
import os
import platform
import subprocess
from pathlib import Path

SOLITAIRE = "solitaire"
THESIS = "thesis"
DIVERSE_ENOUGH = 0.75
KINDS = {
    "first": ("First solution", "CPU seconds of the whole run: flattening, grounding and starting included"),
    "plain": ("Further different solutions", "CPU milliseconds for each"),
    "diverse": ("Further solutions that differ much",
                "CPU milliseconds for each, in brackets the mean distance that was reached"),
    "all": ("All solutions", "CPU seconds of the whole run"),
}


def write(rows, systems, cells, extras, options, seconds):
    parts = ["# Solitaire beside other solvers\n", heading(systems, options, seconds),
             goals_table(rows, systems, cells, extras)]
    for kind, (title, unit) in KINDS.items():
        chosen = [row for row in rows if kind in row.kinds]
        if chosen:
            parts.append(f"## {title}\n\n{unit}; medians over the seeds.\n\n" + kind_table(kind, chosen, systems, cells))
    parts += [alone_table(rows, systems, cells), memory_table(rows, systems, cells), extras_part(extras),
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
    with_thesis = any(system.name == THESIS for system in systems)
    header = ["", *(system.name for system in systems), "best peer / solitaire"] + [THESIS_RATIO] * with_thesis
    lines = []
    for row in rows:
        entries = [entry(kind, cells[row.name, kind, system.name]) for system in systems]
        lines.append([row.name, *entries, ratio_text(ratio(kind, row, systems, cells))]
                     + [bound_text(thesis_ratio(kind, row, cells))] * with_thesis)
    return table(header, lines)


THESIS_RATIO = f"{THESIS} / {SOLITAIRE}"


def alone_table(rows, systems, cells):
    """First solutions once more, without what the peers do before they solve."""
    lines = []
    for row in [row for row in rows if "first" in row.kinds]:
        found = [cells[row.name, "first", system.name] for system in systems]
        lines.append([row.name, *("n/a" if cell.refused else f"> {cell.limit:g} s" if cell.value is None
                                  else f"{cell.value:.3g}" for cell in found),
                      ratio_text(ratio("first", row, systems, cells, solving_alone))])
    if not lines:
        return ""
    text = ("CPU seconds without flattening, grounding, making or reading the model and starting, but for Solitaire, whose whole "
            "run\nthis still is.")
    return (f"## First solution, the peers' solving alone\n\n{text}\n\n"
            + table(["", *(system.name for system in systems), "best peer / solitaire"], lines))


def entry(kind, cell):
    if cell.refused:
        return "n/a"
    if cell.value is None:
        text = f"> {cell.limit:g} s" if cell.found == 0 else f"{cell.found} in {cell.limit:g} s"
    elif kind in ("first", "all"):
        text = f"{seconds_of(kind, cell):.3g}"
    else:
        text = f"{1000 * cell.value:.3g}"
    if kind == "diverse" and cell.distance is not None:
        text += f" ({cell.distance:.2f})"
    if cell.out_of_time and cell.value is not None:
        text += f", {cell.found} in {cell.limit:g} s"
    if cell.wrong:
        text += f" **{cell.wrong} WRONG**"
    return text


def peers(systems):
    return [system for system in systems if system.name not in (SOLITAIRE, THESIS)]


def seconds_of(kind, cell):
    """What a user waits for: for a first solution, or for all there are, that is the whole run."""
    return cell.whole_value if kind in ("first", "all") else cell.value


def solving_alone(kind, cell):
    return cell.value


def ratio(kind, row, systems, cells, seconds=seconds_of):
    """How many times as long the fastest peer takes. None if that cannot be told."""
    own = cells.get((row.name, kind, SOLITAIRE))
    if own is None or own.value is None:
        return None
    found = [cells[row.name, kind, system.name] for system in peers(systems)]
    times = [seconds(kind, cell) for cell in found if usable(kind, cell)]
    if times:
        return min(times) / seconds(kind, own)
    return float("inf") if any(not cell.refused for cell in found) else None


def thesis_ratio(kind, row, cells):
    """How many times as long the dissertation's way takes, at least, and whether that is all that is known."""
    own, thesis = cells.get((row.name, kind, SOLITAIRE)), cells.get((row.name, kind, THESIS))
    if own is None or own.value is None or thesis is None or thesis.refused:
        return None
    if thesis.value is not None:
        return seconds_of(kind, thesis) / seconds_of(kind, own), False
    return thesis.limit / max(thesis.found, 1) / seconds_of(kind, own), True


def usable(kind, cell):
    if cell.value is None or cell.wrong:
        return False
    return kind != "diverse" or (cell.distance or 0) >= DIVERSE_ENOUGH


def ratio_text(value):
    if value is None:
        return ""
    if value == float("inf"):
        return "none did"
    return f"{value:.2g}" if value < 100 else f"{value:.0f}"


def bound_text(value_and_bound):
    if value_and_bound is None:
        return ""
    value, bound = value_and_bound
    return ("at least " if bound else "") + ratio_text(value)


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
            f"## Outside of the solver, workspace-6\n\n{overhead_text(extras['overhead'])}\n")


def overhead_text(overhead):
    if "cpu" not in overhead:
        return f"Only {overhead['found']} scenes in the time."
    parts = ", ".join(f"{name} {overhead[name]:.2f}" for name in ("explore", "encode", "replay"))
    return (f"`generate` of {overhead['scenes']} scenes takes {overhead['cpu']:.2f} CPU seconds, the solver "
            f"{overhead['solve']:.2f} of them: {100 * share_outside(overhead):.0f} % are spent outside of it. The solver's "
            f"are seconds by the clock, and so are these: {parts}; the rest is mainly reading the program and writing "
            "files.")


def share_outside(overhead):
    return 1 - overhead["solve"] / overhead["cpu"]


def spread_text(one, name):
    return f"{one[name]:.3f}" if name in one else "n/a"


# ---- goals

AGAINST_THESIS = ("workspace-3", "workspace-4", "office-d4-4-4")


def goals_table(rows, systems, cells, extras):
    layouts = [row for row in rows if row.group not in ("tight rooms", "enumeration")]
    tight = [row for row in rows if row.group == "tight rooms"]
    listed = [row for row in rows if row.group == "enumeration"]
    goals = [goal_of_thesis("first solution, against the dissertation's way: 50 times faster", "first", rows, cells),
             goal_of_thesis("further solutions that differ much, against it started anew for each: 50 times faster",
                            "diverse", rows, cells),
             goal_of_ratios("first solution: as fast as the fastest peer", "first", 1, layouts, systems, cells),
             goal_of_ratios("100 further ones that differ much: as fast as the fastest peer", "diverse", 1, layouts,
                            systems, cells),
             goal_of_ratios("tight rooms: within 3 times of the fastest peer", "first", 1 / 3, tight, systems, cells),
             goal_of_ratios("all queens: within 3 times of the fastest peer", "all", 1 / 3, listed, systems, cells),
             goal_of_ratios("10,000 layouts: within 3 times of the fastest peer", "plain", 1 / 3, listed, systems,
                            cells)]
    goals.append(goal_of_distance(rows, cells))
    if extras:
        goals += goals_of_extras(extras)
    return "## Goals\n\n" + table(["goal", "measured", "met?"], [goal for goal in goals if goal])


def goal_of_thesis(title, kind, rows, cells):
    ratios = {row.name: thesis_ratio(kind, row, cells) for row in rows if row.name in AGAINST_THESIS}
    ratios = {name: value for name, value in ratios.items() if value is not None}
    if not ratios:
        return None
    measured = ", ".join(f"{name}: {bound_text(value)}" for name, value in ratios.items())
    return [title, measured, yes(all(value >= 50 for value, _ in ratios.values()))]


def goal_of_ratios(title, kind, least, rows, systems, cells):
    ratios = {row.name: ratio(kind, row, systems, cells) for row in rows if kind in row.kinds}
    ratios = {name: value for name, value in ratios.items() if value is not None}
    unsolved = [row.name for row in rows if kind in row.kinds and (row.name, kind, SOLITAIRE) in cells
                and cells[row.name, kind, SOLITAIRE].value is None]
    if not ratios and not unsolved:
        return None
    met = sum(value >= least for value in ratios.values())
    measured = f"{met} of {len(ratios) + len(unsolved)} rows, twice as fast on {sum(v >= 2 for v in ratios.values())}"
    if unsolved:
        measured += f"; out of time: {', '.join(unsolved)}"
    elif met < len(ratios):
        worst = min(ratios, key=ratios.get)
        measured += f"; worst: {worst}, {ratio_text(1 / ratios[worst])} times the peer's time"
    if kind == "first":
        alone = [ratio(kind, row, systems, cells, solving_alone) for row in rows]
        measured += f"; against the peers' solving alone {sum(value >= least for value in alone if value)} rows"
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


def goals_of_extras(extras):
    goals = []
    ratios = {one["name"]: one["late"] / one["early"] for one in extras["series"] if "late" in one}
    if ratios:
        worst = max(ratios, key=ratios.get)
        goals.append(["the 10,000th solution takes at most 1.5 times as long as the 10th",
                      f"worst: {ratios[worst]:.2f} times, {worst}", yes(ratios[worst] <= 1.5)])
    shares = {one["name"]: one["own"] / one["independent"] for one in extras["spread"] if "independent" in one}
    if shares:
        worst = min(shares, key=shares.get)
        goals.append(["mean distance at least 95 % of that of independent solutions",
                      f"least: {100 * shares[worst]:.0f} %, {worst}", yes(shares[worst] >= 0.95)])
    if "cpu" in extras["overhead"]:
        share = share_outside(extras["overhead"])
        goals.append(["outside of the solver at workspace-6: under 20 %", f"{100 * share:.0f} %", yes(share < 0.2)])
    return goals


def yes(met):
    return "yes" if met else "**no**"


READING = """## How to read this

bench/compare/README.md in the project says how each system is run. In short: Solitaire's figures are of the whole process,
reading and exploring the program included. So are those of the peers for a first solution, of which a second table gives the
solving alone; those for further solutions leave out flattening, grounding, making or reading the model and starting. The ratio
is the fastest peer's time over Solitaire's, so more than 1 means that
Solitaire is faster; for solutions that differ much, only peers count that reach a mean distance of 0.75. "n in t s" is
the time per solution of a run that was cut short. "n/a" is what a system does not do.
"""
