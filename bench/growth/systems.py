"""How each system is called, and how its answer is read. A peer takes part in a row that has a model for it."""
import json
import re
import shlex
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "compare"))
from paths import PYTHON  # noqa: E402


class Solitaire:
    name = "solitaire"

    def __init__(self, binary):
        self.binary = binary

    def model(self, row):
        return row.file(".sol")

    def command(self, row, size):
        sets = [f"--set={name}={json.dumps(value)}" for name, value in row.values(size).items()]
        if row.kind == "count":
            return [self.binary, "count", str(self.model(row)), "--exact", *sets]
        asked = {"all": ["--all"]}.get(row.kind, ["-n", str(row.count(size) if row.count else 1)])
        return [self.binary, "solve", str(self.model(row)), "--json", "--quiet", "--jobs=1", "--seed=1", *asked,
                *sets, *self.further(row, size)]

    def further(self, row, size):
        if row.arguments == ("--pin-file",):
            return ["--pin-file", pins_of(size)]
        return row.arguments

    def answer(self, row, child):
        if row.kind == "count":
            return "".join(child.lines).strip().splitlines()[-1] if child.status == 0 else ""
        if row.kind == "none":
            return "none" if child.status == 1 else ""
        if row.kind in ("all", "sample"):
            return str(len(child.lines)) if child.status == 0 else ""
        if row.kind == "best":
            return str(json.loads(child.lines[-1]).get("value")) if child.status == 0 and child.lines else ""
        return "solution" if child.status == 0 and child.lines else ""


def pins_of(size):
    """A file of solutions that pins each of so many choices."""
    path = Path(tempfile.gettempdir()) / f"solitaire-growth-pins-{size}.json"
    path.write_text(json.dumps({"choices": [{"at": f"xs[{i}]", "value": i % 10} for i in range(size)]}))
    return str(path)


def model_of_peer(row, ending):
    """Peers draw no samples."""
    return None if row.kind == "sample" else row.file(ending)


class Gecode:
    name = "gecode"

    def model(self, row):
        return model_of_peer(row, ".mzn")

    def command(self, row, size):
        asked = ["-a"] if row.kind in ("all", "count") else []
        data = " ".join(f"{name} = {json.dumps(value)};" for name, value in row.values(size).items())
        return ["minizinc", "--solver", "gecode", *asked, str(self.model(row)), "-D", data]

    def answer(self, row, child):
        text = "".join(child.lines)
        solutions = text.count("----------")
        if "UNSATISFIABLE" in text:
            return "none"
        if row.kind in ("all", "count"):
            return str(solutions) if "==========" in text else ""
        if row.kind == "best" and "==========" not in text:
            return ""
        return "solution" if solutions else ""


class Clasp:
    name = "clasp"

    def model(self, row):
        return model_of_peer(row, ".lp")

    def command(self, row, size):
        constants = " ".join(f"-c {name}={json.dumps(value)}" for name, value in row.values(size).items())
        asked = "-n 0 -q" if row.kind in ("all", "count", "best") else "-n 1"
        return ["bash", "-c", f"gringo {constants} {shlex.quote(str(self.model(row)))} | clasp {asked}"]

    def answer(self, row, child):
        text = "".join(child.lines)
        if "UNSATISFIABLE" in text:
            return "none"
        if row.kind in ("all", "count"):
            found = re.search(r"Models\s*:\s*(\d+)\s*$", text, re.MULTILINE)
            return found.group(1) if found and "TIME LIMIT" not in text else ""
        if row.kind == "best":
            return "solution" if "OPTIMUM FOUND" in text else ""
        return "solution" if "SATISFIABLE" in text else ""


class Z3:
    name = "z3"

    def model(self, row):
        return row.file("_z3.py") if row.file(".sol").parent.name == "problems" else None

    def command(self, row, size):
        return [PYTHON, str(self.model(row)), str(size)]

    def answer(self, row, child):
        return {"sat": "solution", "unsat": "none"}.get("".join(child.lines).strip(), "")


def all_systems(binary):
    return [Solitaire(binary), Gecode(), Clasp(), Z3()]
