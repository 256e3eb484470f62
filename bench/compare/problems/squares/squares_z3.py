from itertools import combinations

from z3 import BitVec, Or, ULE

LOGIC = "QF_BV"
DIVERSE = "incremental"


def model(solver, params):
    size, most = params["size"], params["grid"] - params["size"]
    width = params["grid"].bit_length()
    x, y = ([BitVec(f"{axis}{i}", width) for i in range(params["squares"])] for axis in "xy")
    solver.add([ULE(place, most) for place in x + y])
    for i, j in combinations(range(params["squares"]), 2):
        solver.add(Or([ULE(axis[a] + size, axis[b]) for axis in (x, y) for a, b in ((i, j), (j, i))]))
    return {"x": x, "y": y}
