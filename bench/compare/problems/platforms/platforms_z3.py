from itertools import combinations

from z3 import And, Bool, Int, Not, Or

LOGIC = "QF_IDL"


def model(solver, params):
    """A box is its edges along x and along y, all of them variables."""
    platforms, most = params["platforms"], 8 * params["platforms"]
    level = [make_box(solver, f"p{i}", most) for i in range(platforms)]
    ways = [make_box(solver, f"w{i}", most) for i in range(platforms - 1)]
    along_x = [Bool(f"w{i}.along_x") for i in range(platforms - 1)]

    for box in level:
        solver.add([And(high - low >= 3, high - low <= 8) for low, high in box])
    for way, lies, a, b in zip(ways, along_x, level, level[1:]):
        solver.add(Or(Not(lies), leads(way[0], way[1], (a[0], a[1]), (b[0], b[1]))))
        solver.add(Or(lies, leads(way[1], way[0], (a[1], a[0]), (b[1], b[0]))))
    solver.add([apart(a, b, params["gap"]) for a, b in combinations(level, 2)])
    solver.add([apart(a, b, params["beside"]) for a, b in combinations(ways, 2)])
    solver.add([apart(way, box, params["beside"]) for i, way in enumerate(ways) for j, box in enumerate(level)
                if j not in (i, i + 1)])
    for i in range(0, platforms, 2):
        for (low, high), point in zip(level[i], (3 + 6 * i, 8 + 5 * (i % 4))):
            solver.add(low <= point, point <= high)
    lengths = tuple_of_lengths(solver, ways, along_x)
    return {"w": [x2 - x1 for (x1, x2), _ in level], "d": [y2 - y1 for _, (y1, y2) in level],
            "along_x": along_x, "length": lengths,
            "x": [box[0][0] for box in level + ways], "y": [box[1][0] for box in level + ways]}


def make_box(solver, name, most):
    box = [(Int(f"{name}.{axis}1"), Int(f"{name}.{axis}2")) for axis in "xy"]
    solver.add([And(0 <= low, low <= most) for low, _ in box])
    return box


def tuple_of_lengths(solver, ways, along_x):
    """A Bool for each length, since which difference the length is depends on the direction."""
    lengths = []
    for number, (way, lies) in enumerate(zip(ways, along_x)):
        length = tuple(Bool(f"w{number}.length{units}") for units in range(9))
        solver.add([Not(is_it) for is_it in length[:2]])
        solver.add(Or(length[2:]), *[Or(Not(a), Not(b)) for a, b in combinations(length[2:], 2)])
        for units in range(2, 9):
            for case, (long, short) in ((lies, way), (Not(lies), way[::-1])):
                solver.add(Or(Not(case), Not(length[units]), long[1] - long[0] == units))
        for case, (_, short) in ((lies, way), (Not(lies), way[::-1])):
            solver.add(Or(Not(case), short[1] - short[0] == 2))
        lengths.append(length)
    return lengths


def leads(along, across, a, b):
    """From a to b; the first interval of each of these is along the way, the second across it."""
    there = And(a[0][1] - along[0] == 0, along[1] - b[0][0] == 0)
    back = And(b[0][1] - along[0] == 0, along[1] - a[0][0] == 0)
    inside = [And(box[1][0] - across[0] <= 0, across[1] - box[1][1] <= 0) for box in (a, b)]
    return And(Or(there, back), *inside)


def apart(a, b, gap):
    return Or([Or(a_high - b_low <= -gap, b_high - a_low <= -gap)
               for (a_low, a_high), (b_low, b_high) in zip(a, b)])
