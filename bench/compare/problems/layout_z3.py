"""Boxes on a floor plan for Z3, as solitaire/std/layout.sol defines them.

A model says "a + k <= b" and "a + k == b" only, with the cases of turned boxes spelled out, so that it can be stated
over bit-vectors of the least width as well as in integer difference logic.
"""
from dataclasses import dataclass

from z3 import And, BitVec, Bool, Int, Not, Or, ULE


class Differences:
    logic = "QF_IDL"

    def __init__(self, solver):
        self.solver = solver

    def number(self, name, low, high):
        number = Int(name)
        self.solver.add(low <= number, number <= high)
        return number

    def at_most(self, a, k, b):
        return a - b <= -k if not isinstance(b, int) else a <= b - k

    def equal(self, a, k, b):
        return a - b == -k if not isinstance(b, int) else a == b - k


class Bits:
    logic = "QF_BV"

    def __init__(self, solver, most):
        self.solver = solver
        self.width = most.bit_length()

    def number(self, name, low, high):
        number = BitVec(name, self.width)
        self.solver.add(ULE(low, number) if low > 0 else True, ULE(number, high))
        return number

    def at_most(self, a, k, b):
        return ULE(a + k, b) if k >= 0 else ULE(a, b - k)

    def equal(self, a, k, b):
        return a + k == b


@dataclass
class Box:
    x: object
    y: object
    across: list  # (condition, extent along x), one of which holds
    deep: list    # the same along y
    turn: list    # two Bools, the lower bit first


def make_box(numbers, name, w, d, most):
    x, y = (numbers.number(f"{name}.{axis}", 0, most) for axis in "xy")
    turn = [Bool(f"{name}.turn0"), Bool(f"{name}.turn1")]
    if w == d:
        return Box(x, y, [(True, w)], [(True, w)], turn)
    lies, stands = Not(turn[0]), turn[0]
    return Box(x, y, [(lies, w), (stands, d)], [(lies, d), (stands, w)], turn)


def by_case(cases, condition):
    return Or([And(case, condition(extent)) for case, extent in cases])


class Layout:
    def __init__(self, numbers):
        self.at_most = numbers.at_most
        self.equal = numbers.equal

    def ends_before(self, start, extents, gap, other):
        return by_case(extents, lambda extent: self.at_most(start, extent + gap, other))

    def meets(self, start, extents, other):
        return by_case(extents, lambda extent: self.equal(start, extent, other))

    def apart(self, a, b, gap=0):
        return Or(self.ends_before(a.x, a.across, gap, b.x), self.ends_before(b.x, b.across, gap, a.x),
                  self.ends_before(a.y, a.deep, gap, b.y), self.ends_before(b.y, b.deep, gap, a.y))

    def inside(self, a, width, depth):
        return And(self.ends_before(a.x, a.across, 0, width), self.ends_before(a.y, a.deep, 0, depth))

    def within(self, a, a_extents, b, b_extents):
        """The interval from a lies in the one from b."""
        return And(self.at_most(b, 0, a),
                   Or([And(one, other, self.at_most(a, size - space, b))
                       for one, size in a_extents for other, space in b_extents]))

    def facing(self, a, b):
        along_x = self.within(a.x, a.across, b.x, b.across)
        along_y = self.within(a.y, a.deep, b.y, b.deep)
        return self.by_turn(a.turn, And(along_x, self.meets(b.y, b.deep, a.y)),
                            And(along_y, self.meets(a.x, a.across, b.x)),
                            And(along_x, self.meets(a.y, a.deep, b.y)),
                            And(along_y, self.meets(b.x, b.across, a.x)))

    def flush(self, a, width, depth):
        return self.by_turn(a.turn, self.meets(a.y, a.deep, depth), self.equal(a.x, 0, 0),
                            self.equal(a.y, 0, 0), self.meets(a.x, a.across, width))

    @staticmethod
    def by_turn(turn, *conditions):
        return And([Or(turn[0] if number % 2 == 0 else Not(turn[0]), turn[1] if number < 2 else Not(turn[1]), condition)
                    for number, condition in enumerate(conditions)])
