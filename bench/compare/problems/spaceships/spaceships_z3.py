from z3 import And, Bool, Int, Not, Or

LOGIC = "QF_IDL"

# Of each type the boxes, as offset and size along each axis. Those of one box are cut in two.
SHAPES = [
    [((0, 3), (0, 4), (0, 2)), ((3, 3), (0, 4), (0, 2))],     # hull
    [((0, 2), (0, 5), (0, 1)), ((0, 2), (5, 5), (0, 1))],     # wing
    [((0, 4), (0, 2), (0, 1)), ((4, 4), (0, 2), (0, 1))],     # keel
    [((0, 2), (0, 2), (0, 2)), ((2, 2), (0, 2), (0, 2))],     # engine
    [((0, 2), (0, 2), (0, 3)), ((-1, 4), (-1, 4), (3, 1))],   # tower
    [((0, 2), (0, 2), (0, 2)), ((2, 4), (0, 2), (0, 1))],     # bracket
]


def model(solver, params):
    """The edges of the boxes are variables that the type ties to the structure's place."""
    hull = [[(start, start + size) for start, size in box] for box in SHAPES[0]]
    ship = [hull]
    arrays = {name: [] for name in ("x", "y", "z", "kind")}
    for i in range(params["structures"]):
        boxes = make_structure(solver, f"s{i}", params["reach"], arrays)
        others = [other for earlier in ship for other in earlier]
        solver.add(Or([connected(a, b) for a in boxes for b in others]))
        solver.add([apart(a, b) for a in boxes for b in others])
        ship.append(boxes)
    return arrays


def make_structure(solver, name, reach, arrays):
    place = [Int(f"{name}.{axis}") for axis in "xyz"]
    solver.add([And(-reach <= axis, axis <= reach) for axis in place])
    types = tuple(Bool(f"{name}.type{number}") for number in range(len(SHAPES)))
    solver.add(Or(types), *[Or(Not(a), Not(b)) for i, a in enumerate(types) for b in types[:i]])
    boxes = [[(Int(f"{name}.{box}.{axis}.low"), Int(f"{name}.{box}.{axis}.high")) for axis in range(3)]
             for box in range(2)]
    for is_type, shape in zip(types, SHAPES):
        for box, extents in zip(boxes, shape):
            for (low, high), at, (start, size) in zip(box, place, extents):
                solver.add(Or(Not(is_type), low - at == start), Or(Not(is_type), high - at == start + size))
    for axis, at in zip("xyz", place):
        arrays[axis].append(at)
    arrays["kind"].append(types)
    return boxes


def connected(a, b):
    (a_low, a_high), (b_low, b_high) = a[2], b[2]
    along = [And(before(a_start, b_end, 1), before(b_start, a_end, 1))
             for (a_start, a_end), (b_start, b_end) in zip(a[:2], b[:2])]
    return And(Or(equal(a_high, b_low), equal(b_high, a_low)), *along)


def apart(a, b):
    return Or([Or(before(a_high, b_low, 0), before(b_high, a_low, 0))
               for (a_low, a_high), (b_low, b_high) in zip(a, b)])


def before(a, b, k):
    """a + k <= b, where one of them may be an int."""
    if isinstance(a, int):
        return b >= a + k
    return a <= b - k if isinstance(b, int) else a - b <= -k


def equal(a, b):
    if isinstance(a, int):
        a, b = b, a
    return a == b if isinstance(b, int) else a - b == 0
