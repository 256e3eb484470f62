from itertools import combinations

from z3 import And, Not, Or, Xor

from layout_z3 import Differences, Layout, make_box

LOGIC = Differences.logic



def joined(layout, a, b):
    """Two boxes of one size, so their extents along the shared edge are equal where their turns agree."""
    same_x, same_y = layout.equal(a.x, 0, b.x), layout.equal(a.y, 0, b.y)
    beside = Or(layout.meets(a.x, a.across, b.x), layout.meets(b.x, b.across, a.x))
    behind = Or(layout.meets(a.y, a.deep, b.y), layout.meets(b.y, b.deep, a.y))
    return And(Not(Xor(a.turn[0], b.turn[0])), Or(And(beside, same_y), And(behind, same_x)))


def model(solver, params):
    numbers = Differences(solver)
    layout = Layout(numbers)
    groups, most = params["groups"], params["most"]
    seats = [(6, 3)] + [(2, 2)] * params["chairs"]
    sizes = [(6, 3)] * 2 + seats * 2
    width, depth = numbers.number("width", 8, most), numbers.number("depth", 8, most)
    members = [[make_box(numbers, f"g{g}.{i}", w, d, most) for i, (w, d) in enumerate(sizes)] for g in range(groups)]
    walled = [make_box(numbers, f"s{i}", 4, 1, most) for i in range(groups)] + [make_box(numbers, "board", 7, 2, most)]
    things = sum(members, []) + walled

    solver.add([layout.inside(o, width, depth) for o in things])
    solver.add([layout.flush(o, width, depth) for o in walled])
    for group in members:
        solver.add(joined(layout, *group[:2]))
        for table in (0, 1):
            first = 2 + table * len(seats)
            solver.add([layout.facing(seat, group[table]) for seat in group[first:first + len(seats)]])
    team = {id(o): number for number, group in enumerate(members) for o in group}
    for a, b in combinations(things, 2):
        between_groups = id(a) in team and id(b) in team and team[id(a)] != team[id(b)]
        solver.add(layout.apart(a, b, params["aisle"] if between_groups else 0))
    return {"room": [width, depth], "turn": [o.turn for o in things], "x": [o.x for o in things],
            "y": [o.y for o in things]}
