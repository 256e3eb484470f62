from itertools import combinations

from z3 import And, Bool, If, Not, Or

from layout_z3 import Box, Differences, Layout

LOGIC = Differences.logic


def model(solver, params):
    """Lengths are in units of the grid."""
    numbers = Differences(solver)
    layout = Layout(numbers)
    halls, offices, most = params["halls"], params["offices"], 5 * params["halls"] + 8
    turned_first = Bool("turned_first")
    building, lengths = [], []
    for i in range(halls):
        along_y = turned_first if i % 2 == 0 else Not(turned_first)
        hall, length = make_hall(numbers, f"hall{i}", along_y, most)
        building.append(hall)
        lengths.append(length)
    rows = [make_group(numbers, f"group{g}", offices, most) for g in range(params["groups"])]
    rooms = [office for row in rows for office in row]

    for (i, a), (j, b) in combinations(enumerate(building), 2):
        neighbours = j == i + 1 or (params["ring"] and halls > 2 and i == 0 and j == halls - 1)
        solver.add(touching(layout, a, b) if neighbours else layout.apart(a, b, 2))
    for g, row in enumerate(rows):
        solver.add([layout.facing(office, building[g % halls]) for office in row])
        for a, b in zip(row, row[1:]):
            turned = a.turn[0]
            solver.add(Or(Not(turned), layout.meets(a.y, a.deep, b.y)), Or(turned, layout.meets(a.x, a.across, b.x)))
    solver.add([layout.apart(a, b) for a, b in combinations(building + rooms, 2)])
    solver.add([layout.inside(o, most, most) for o in building + rooms])
    return {"turned_first": [turned_first], "long": lengths, "group_turn": [row[0].turn for row in rows],
            "large": [office.large for office in rooms], "x": [o.x for o in building + rooms],
            "y": [o.y for o in building + rooms]}


def make_place(numbers, name, most):
    return [numbers.number(f"{name}.{axis}", 0, most) for axis in "xy"]


def make_hall(numbers, name, along_y, most):
    """The end is a variable of its own, so that no sum of two variables is needed, and the length is as many Bools."""
    x, y = make_place(numbers, name, most)
    length = tuple(Bool(f"{name}.long{units}") for units in range(11))
    numbers.solver.add([Not(is_it) for is_it in length[:4]])
    numbers.solver.add(Or(length[4:]), *[Or(Not(a), Not(b)) for a, b in combinations(length[4:], 2)])
    across = [(along_y, 1)] + [(And(Not(along_y), is_it), units) for units, is_it in enumerate(length) if units >= 4]
    deep = [(Not(along_y), 1)] + [(And(along_y, is_it), units) for units, is_it in enumerate(length) if units >= 4]
    return Box(x, y, across, deep, []), length


def make_group(numbers, name, offices, most):
    turn = [Bool(f"{name}.turn0"), Bool(f"{name}.turn1")]
    row = []
    for i in range(offices):
        x, y = make_place(numbers, f"{name}.{i}", most)
        large = Bool(f"{name}.{i}.large")
        wide, turned = [(Not(large), 1), (large, 2)], turn[0]
        across = [(turned, 2)] + [(And(Not(turned), case), extent) for case, extent in wide]
        deep = [(Not(turned), 2)] + [(And(turned, case), extent) for case, extent in wide]
        office = Box(x, y, across, deep, turn)
        office.large = large
        row.append(office)
    return row


def touching(layout, a, b):
    beside = Or(layout.meets(a.x, a.across, b.x), layout.meets(b.x, b.across, a.x))
    behind = Or(layout.meets(a.y, a.deep, b.y), layout.meets(b.y, b.deep, a.y))
    return Or(And(beside, overlap(layout, a.y, a.deep, b.y, b.deep)),
              And(behind, overlap(layout, a.x, a.across, b.x, b.across)))


def overlap(layout, a, a_extents, b, b_extents):
    return And(Or([And(case, layout.at_most(b, 1 - extent, a)) for case, extent in a_extents]),
               Or([And(case, layout.at_most(a, 1 - extent, b)) for case, extent in b_extents]))
