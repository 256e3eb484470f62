"""What the operators do with values. Ints are exact and end at 62 bits."""

import math

from .lexer import LARGEST_INT
from .syntax import ProgramError
from .values import Record, is_number, kind, same


class Rejected(Exception):
    """This execution is no solution: an assert failed, or what the manual counts like one."""


def finite(value, operands, place):
    """An exp or pow of something large is infinite, and so may be what is computed with it."""
    if math.isnan(value):
        raise ProgramError(place, "this has no value")
    if math.isinf(value) and all(map(math.isfinite, operands)):
        raise ProgramError(place, "this float grows past the largest one")
    return one_zero(value)


def one_zero(value):
    """The language has no -0.0."""
    return value + 0.0


def within_62_bits(value, place):
    if abs(value) > LARGEST_INT:
        raise ProgramError(place, "this int grows past 62 bits")
    return value


def mismatch(sign, left, right, place):
    return ProgramError(place, f"{sign!r} does not go with {kind(left)} and {kind(right)}")


def add(left, right, place):
    if type(left) is type(right) and type(left) in (tuple, str):
        return left + right
    return arithmetic("+", left, right, place, lambda a, b: a + b)


def arithmetic(sign, left, right, place, of_numbers):
    if not is_number(left) or not is_number(right):
        raise mismatch(sign, left, right, place)
    result = of_numbers(left, right)
    return within_62_bits(result, place) if type(result) is int else finite(result, (left, right), place)


def divide(left, right, place):
    def quotient(a, b):
        if b == 0:
            raise Rejected
        return a // b if type(a) is int and type(b) is int else a / b

    return arithmetic("/", left, right, place, quotient)


def remainder(left, right, place):
    if type(left) is not int or type(right) is not int:
        raise mismatch("%", left, right, place)
    if right == 0:
        raise Rejected
    return left % right


def compare(sign, left, right, place):
    if not is_number(left) or not is_number(right):
        raise ProgramError(place, f"{sign!r} compares numbers, here are {kind(left)} and {kind(right)}")
    return {"<": left < right, "<=": left <= right, ">": left > right, ">=": left >= right}[sign]


def ints_from_to(left, right, place):
    if type(left) is not int or type(right) is not int:
        raise ProgramError(place, f"'..' needs two ints, here are {kind(left)} and {kind(right)}")
    return range(left, right + 1)


def is_in(value, items, place):
    if type(items) is not tuple:
        raise ProgramError(place, f"'in' needs a list, not {kind(items)}")
    return any(same(each, value) for each in items)


BINARY = {
    "+": add,
    "-": lambda a, b, place: arithmetic("-", a, b, place, lambda x, y: x - y),
    "*": lambda a, b, place: arithmetic("*", a, b, place, lambda x, y: x * y),
    "/": divide,
    "%": remainder,
    "==": lambda a, b, place: same(a, b),
    "!=": lambda a, b, place: not same(a, b),
    "<": lambda a, b, place: compare("<", a, b, place),
    "<=": lambda a, b, place: compare("<=", a, b, place),
    ">": lambda a, b, place: compare(">", a, b, place),
    ">=": lambda a, b, place: compare(">=", a, b, place),
    "in": is_in,
}


def condition(value, place):
    """The value, if it is a bool."""
    if type(value) is not bool:
        raise ProgramError(place, f"a condition is true or false, not {kind(value)}")
    return value


def negative(value, place):
    if not is_number(value):
        raise ProgramError(place, f"'-' does not go with {kind(value)}")
    return 0 - value  # 0.0 and not -0.0 for 0.0


def element(base, index, place):
    """base[index]. An index outside of the list rules the execution out. A list of indices gives a list."""
    if type(base) is tuple and type(index) is tuple:
        return tuple(element(base, each, place) for each in index)
    check_index(base, index, place)
    return base[index]


def with_element(base, index, value, place):
    check_index(base, index, place)
    return base[:index] + (value,) + base[index + 1 :]


def check_index(base, index, place):
    if type(base) is not tuple:
        raise ProgramError(place, f"{kind(base)} has no elements")
    if type(index) is not int:
        raise ProgramError(place, f"an index is an int, not {kind(index)}")
    if not 0 <= index < len(base):
        raise Rejected


def field_position(base, name, place):
    position = base.position(name) if type(base) is Record else None
    if position is None:
        raise ProgramError(place, f"{kind(base)} has no field {name!r}")
    return position


def field_value(base, name, place):
    position = field_position(base, name, place)
    return base.fields[position]


def with_field(base, name, value, place):
    position = field_position(base, name, place)
    return Record(base.declaration, with_element(base.fields, position, value, place))
