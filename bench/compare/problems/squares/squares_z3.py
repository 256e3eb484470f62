from itertools import combinations

from z3 import And, Int, Or

LOGIC = "QF_IDL"


def diverse(params):
    return "incremental"


def model(solver, params):
    size, most = params["size"], params["grid"] - params["size"]
    x, y = ([Int(f"{axis}{i}") for i in range(params["squares"])] for axis in "xy")
    solver.add([And(0 <= place, place <= most) for place in x + y])
    for i, j in combinations(range(params["squares"]), 2):
        solver.add(Or([axis[a] - axis[b] <= -size for axis in (x, y) for a, b in ((i, j), (j, i))]))
    return {"x": x, "y": y}
