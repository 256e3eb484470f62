"""Where things are."""
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PYTHON = "/usr/bin/python3"   # Debian's, which has Debian's z3


def problem_file(problem, ending):
    return HERE / "problems" / problem / f"{problem}{ending}"
