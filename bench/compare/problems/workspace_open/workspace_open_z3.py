from itertools import combinations

from z3 import And, Bool, Not, Or

from layout_z3 import Differences, Layout, make_box

LOGIC = Differences.logic
SIZES = {"tables": (6, 3), "chairs": (2, 2), "sofas": (6, 3)}
LEAST = {"tables": 1, "chairs": 2, "sofas": 1}


def model(solver, params):
    numbers = Differences(solver)
    layout = Layout(numbers)
    most = 24 + 10 * params["most_groups"]
    room = [numbers.number(name, 12, most) for name in ("width", "depth")]
    used = [Bool(f"used{g}") for g in range(params["most_groups"])]
    solver.add(used[0], *[Or(Not(later), earlier) for earlier, later in zip(used, used[1:])])
    groups = [make_group(solver, numbers, layout, f"g{g}", group_used, params, most)
              for g, group_used in enumerate(used)]
    things = [[o for kind in SIZES for o in group[kind]] for group in groups]
    for group in things:
        solver.add([Or(Not(o.there), layout.inside(o, *room)) for o in group])
        solver.add([apart(layout, a, b, 0) for a, b in combinations(group, 2)])
    for these, those in combinations(things, 2):
        solver.add([apart(layout, a, b, params["aisle"]) for a in these for b in those])
    slots = [o for group in things for o in group]
    return {"groups": [count(used)], "used": used, "room": room,
            **{kind: [count([o.there for o in group[kind]]) for group in groups] for kind in SIZES},
            "there": [o.there for o in slots], "turn": [o.turn for o in slots],
            "x": [o.x for o in slots], "y": [o.y for o in slots]}


def make_group(solver, numbers, layout, name, used, params, most):
    slots = {"tables": params["most_tables"], "chairs": params["most_tables"] + 1, "sofas": 3}
    group = {kind: [make_slot(solver, numbers, f"{name}.{kind}{i}", *SIZES[kind], most) for i in range(slots[kind])]
             for kind in SIZES}
    for kind, things in group.items():
        for i, o in enumerate(things):
            if i < LEAST[kind]:
                solver.add(o.there == used)
            else:
                solver.add(Or(Not(o.there), things[i - 1].there))
    tables = group["tables"]
    solver.add([Or(Not(table.there), chair.there) for table, chair in zip(tables, group["chairs"][1:])])
    for below, above in zip(tables, tables[1:]):
        together = And(layout.meets(below.y, below.deep, above.y), layout.equal(below.x, 0, above.x),
                       below.turn[0] == above.turn[0], below.turn[1] == above.turn[1])
        solver.add(Or(Not(above.there), together))
    for seat in group["chairs"] + group["sofas"]:
        solver.add(Or(Not(seat.there), *[And(table.there, layout.facing(seat, table)) for table in tables]))
    return group


def make_slot(solver, numbers, name, w, d, most):
    box = make_box(numbers, name, w, d, most)
    box.there = Bool(f"{name}.there")
    solver.add(Or(box.there, And(box.x == 0, box.y == 0, Not(box.turn[0]), Not(box.turn[1]))))
    return box


def count(there):
    """As many Bools: which number it is of those that are there, one after the other."""
    return (And([Not(one) for one in there]),
            *(And(one, Not(after)) for one, after in zip(there, there[1:])), there[-1])


def apart(layout, a, b, gap):
    return Or(Not(a.there), Not(b.there), layout.apart(a, b, gap))
