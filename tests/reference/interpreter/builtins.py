"""The builtins of the manual's table."""

import json
import math
import re
from pathlib import Path

from .operators import BINARY, Rejected, condition, one_zero, within_62_bits
from .syntax import ProgramError
from .values import Builtin, is_number, kind, same, text

ASSETS = Path(__file__).resolve().parents[3] / "assets"
COLOURS = set(
    "white silver gray grey black red maroon orange yellow olive green lime teal cyan blue navy purple pink brown"
    " beige".split()
)


def need(call, parameter, types, wanted):
    """An argument, which has to be of one of these types."""
    value = call.given[parameter]
    if type(value) not in types:
        raise ProgramError(call.place_of(parameter), f"{wanted} is needed here, not {kind(value)}")
    return value


def a_list(call, parameter="list"):
    return need(call, parameter, [tuple], "a list")


def a_number(call, parameter="x"):
    return need(call, parameter, [int, float], "a number")


def items(call, parameter):
    """The elements of a list, or all arguments if there are several."""
    if not call.rest:
        return a_list(call, parameter)
    return (call.given[parameter], *call.rest)


# ---- choices


def choose_range(run, call):
    low, high, step = (call.given.get(name, 1) for name in ("lo", "hi", "step"))
    for parameter, value in (("lo", low), ("hi", high), ("step", step)):
        if type(value) is not int:
            raise ProgramError(call.place_of(parameter), f"a range is made of ints, not of {kind(value)}")
    if step < 1:
        raise ProgramError(call.place_of("step"), "the step of a range is an int from 1")
    return run.choose(call.address(), range(low, high + 1, step))


# Probabilities and weights play no part in what is possible.


def choose_flip(run, call):
    if "probability" in call.given and not 0 <= a_number(call, "probability") <= 1:
        raise ProgramError(call.place_of("probability"), "a probability is a number from 0 to 1")
    return run.choose(call.address(), (False, True))


def choose_element(run, call):
    elements = a_list(call)
    if "weights" in call.given and len(a_list(call, "weights")) != len(elements):
        raise ProgramError(call.place, "'choose' needs as many weights as the list has elements")
    position = run.choose(call.address(), range(len(elements)))
    run.chosen_from[call.address()] = elements
    return elements[position]


def choose_position(run, call):
    return run.choose(call.address(), range(len(a_list(call, "weights"))))


def check(run, call):
    holds = condition(call.given["condition"], call.place_of("condition"))
    if "message" in call.given:
        need(call, "message", [str], "a string")
    if not holds:
        run.break_assert(call.address())


# ---- wishes


def prefer(run, call):
    holds = condition(call.given["condition"], call.place_of("condition"))
    weight = call.given.get("weight", 1)
    if type(weight) is not int or weight < 0:
        raise ProgramError(call.place_of("weight"), "the weight of 'prefer' is an int from 0")
    run.add_cost(0 if holds else weight)


def minimize(run, call):
    run.add_cost(need(call, "x", [int], "an int"))


def maximize(run, call):
    run.add_cost(-need(call, "x", [int], "an int"))


# ---- numbers


def extreme(best):
    def run_extreme(run, call):
        numbers = items(call, "list")
        key = None
        for name, value in call.extras:
            if name != "key":
                raise ProgramError(call.place, f"there is no parameter {name!r}")
            key = value
        if key is not None:
            if not numbers:
                raise Rejected
            by = keys(run, call, key, numbers)
            return numbers[best(range(len(by)), key=lambda i: by[i])]
        for number in numbers:
            if not is_number(number):
                raise ProgramError(call.place, f"numbers are needed here, not {kind(number)}")
        if not numbers:
            raise Rejected
        found = best(numbers)
        return float(found) if any(type(each) is float for each in numbers) else found

    return run_extreme


def floor(run, call):
    number = a_number(call)
    if not math.isfinite(number):
        raise ProgramError(call.place, f"'floor' of {number} has no value")
    return within_62_bits(math.floor(number), call.place)


def power(run, call):
    base, exponent = float(a_number(call, "base")), float(a_number(call, "exponent"))
    try:
        return one_zero(math.pow(base, exponent))
    except OverflowError:
        return -math.inf if base < 0 and exponent % 2 == 1 else math.inf
    except ValueError as error:
        if base == 0:
            return math.copysign(math.inf, base) if exponent % 2 == 1 else math.inf
        raise ProgramError(call.place, f"'pow' of {base} and {exponent} has no value") from error


def exponential(number):
    try:
        return math.exp(number)
    except OverflowError:
        return math.inf


def of_float(function):
    def run_function(run, call):
        number = float(a_number(call))
        try:
            return one_zero(function(number))
        except (ValueError, OverflowError) as error:
            raise ProgramError(call.place, f"this function of {number} has no value") from error

    return run_function


# ---- conditions


def select(run, call):
    chosen = condition(call.given["condition"], call.place_of("condition"))
    return call.given["then" if chosen else "otherwise"]


def quantifier(function):
    def run_quantifier(run, call):
        if not call.given:
            return function([])
        return function([condition(each, call.place) for each in items(call, "conditions")])

    return run_quantifier


# ---- lists


def length(run, call):
    return len(need(call, "list", [tuple, str], "a list"))


def total(run, call):
    result = 0
    for each in a_list(call):
        result = BINARY["+"](result, each, call.place)
    return result


def contains(run, call):
    return any(same(each, call.given["value"]) for each in a_list(call))


def allowed(run, call):
    for row in a_list(call, "table"):
        if type(row) is not tuple or len(row) != 2 or type(row[1]) is not tuple:
            raise ProgramError(call.place, "a row of a table is a value and a list")
    a, b = call.given["a"], call.given["b"]
    known = [others for first, others in call.given["table"] if same(first, a)]
    return bool(known) and all(any(same(each, b) for each in others) for others in known)


def exemplar_rows(run, call):
    """The rows of an exemplar in the program, or of a file of text, whose tiles are named by their characters."""
    exemplar = call.given["exemplar"]
    if type(exemplar) is str:
        lines = (Path(run.program.main.file).parent / exemplar).read_text(encoding="utf-8").split()
        return [tuple(line) for line in lines]
    rows = a_list(call, "exemplar")
    if any(type(row) is not tuple or len(row) != len(rows[0]) for row in rows):
        raise ProgramError(call.place, "the rows of an exemplar are equally long lists")
    return rows


def tile_pairs(run, call):
    tiles = []
    rows = exemplar_rows(run, call)
    for tile in (tile for row in rows for tile in row):
        if not any(same(tile, each) for each in tiles):
            tiles.append(tile)

    def table(neighbours):
        found = [(tile, []) for tile in tiles]
        for first, second in neighbours:
            others = next(others for tile, others in found if same(tile, first))
            if not any(same(each, second) for each in others):
                others.append(second)
        return tuple((tile, tuple(others)) for tile, others in found)

    right = table(pair for row in rows for pair in zip(row, row[1:]))
    below = table(pair for above, under in zip(rows, rows[1:]) for pair in zip(above, under))
    def number(tile):
        return next(at for at, each in enumerate(tiles) if same(tile, each))

    given = call.given["exemplar"] if "exemplar" in call.given else None
    source = given if type(given) is str else tuple(tuple(number(tile) for tile in row) for row in rows)
    return tuple(tiles), right, below, source


def tile_sites(run, call):
    return None


def pairs_of(elements):
    return [(a, b) for i, a in enumerate(elements) for b in elements[i + 1 :]]


def distinct(run, call):
    return not any(same(a, b) for a, b in pairs_of(a_list(call)))


def boxes_apart(run, call):
    gap = call.given.get("gap", 0)
    boxes = a_list(call, "boxes")
    if not is_number(gap):
        raise ProgramError(call.place_of("gap"), f"a gap is a number, not {kind(gap)}")
    for box in boxes:
        if type(box) is not tuple or not box or len(box) != len(boxes[0]):
            raise ProgramError(call.place_of("boxes"), "each box is a list of [low, high], of as many axes as the others")
        for ends in box:
            if type(ends) is not tuple or len(ends) != 2 or not all(is_number(end) for end in ends):
                raise ProgramError(call.place_of("boxes"), "what a box takes along an axis is a list of two numbers")
    return all(
        any(one[1] + gap <= other[0] or other[1] + gap <= one[0] for one, other in zip(a, b)) for a, b in pairs_of(boxes)
    )


def zip_lists(run, call):
    return tuple(zip(a_list(call, "a"), a_list(call, "b")))


def first(run, call):
    if not a_list(call):
        raise Rejected
    return call.given["list"][0]


def last(run, call):
    if not a_list(call):
        raise Rejected
    return call.given["list"][-1]


def count(run, call):
    wanted = call.given.get("value", True)
    return sum(same(each, wanted) for each in a_list(call))


def index_of(run, call):
    for position, each in enumerate(a_list(call)):
        if same(each, call.given["value"]):
            return position
    raise Rejected


def each_with(run, call, function, elements):
    """What a function gives for each element, with the call's turns in the addresses of what it does."""
    results = []
    for turn, each in enumerate(elements):
        call.activation.turns.append(turn)
        results.append(run.call_function(function, call.node, [each], call.activation))
        call.activation.turns.pop()
    return results


def map_list(run, call):
    return tuple(each_with(run, call, call.given["f"], a_list(call)))


def filter_list(run, call):
    kept = each_with(run, call, call.given["f"], a_list(call))
    return tuple(each for each, keep in zip(a_list(call), kept) if condition(keep, call.place))


def keys(run, call, function, elements):
    made = elements if function is None else each_with(run, call, function, elements)
    for key in made:
        if not is_number(key):
            raise ProgramError(call.place, f"numbers are needed here, not {kind(key)}")
    return made


def sort(run, call):
    elements = a_list(call)
    by = keys(run, call, call.given.get("key"), elements)
    return tuple(elements[i] for i in sorted(range(len(elements)), key=lambda i: by[i]))


def others(run, call):
    if not a_list(call):
        raise Rejected
    return call.given["list"][1:]


# ---- text and scenes


def join_texts(run, call):
    return "".join(text(each) for each in (call.given["value"], *call.rest))


FIELD = re.compile(r"\{\{|\}\}|\{(?::([<>]?)(\d{0,2})(?:\.(\d{1,2})f?)?)?\}|[{}]")


def format_text(run, call):
    pattern = need(call, "text", [str], "a format")
    values = list(call.rest)

    def replace(found):
        if found[0] in ("{{", "}}"):
            return found[0][0]
        if found[0] in ("{", "}"):
            raise ProgramError(call.place, "a single brace in a format")
        if not values:
            raise ProgramError(call.place, "a format with more fields than values")
        value = values.pop(0)
        side, width, decimals = found[1], found[2], found[3]
        if decimals is not None and not is_number(value):
            raise ProgramError(call.place, "decimals are for numbers")
        shown = text(value) if decimals is None else f"{value:.{int(decimals)}f}"
        width = int(width or 0)
        return shown.ljust(width) if side == "<" else shown.rjust(width)

    made = FIELD.sub(replace, pattern)
    if values:
        raise ProgramError(call.place, "a format with fewer fields than values")
    return made


def print_line(run, call):
    run.printed.append(" ".join(text(each) for each in call.rest))


def unit(run, call):
    metres = call.given.get("metres")
    if metres is None:
        return run.unit
    if not is_number(metres) or not 0 < metres < math.inf:
        raise ProgramError(call.place, "a unit is a positive number of metres")
    run.unit = float(metres)


def model_facts(call):
    """What the file of a bundled model says about it."""
    name = call.given["asset"]
    if not is_text(name):
        raise ProgramError(call.place, f"the name of a model is a string, not {kind(name)}")
    file = ASSETS / f"{name}.glb"
    if not re.fullmatch("[a-z0-9_]+", name) or not file.exists():
        raise ProgramError(call.place, f"there is no model {name!r}")
    data = file.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    return json.loads(data[20:20 + length])["nodes"][0]["extras"]


def size_of(run, call):
    facts = model_facts(call)
    size = (*facts["footprint"], facts["height"])
    unit = call.given.get("unit")
    if unit is None:
        return tuple(float(length) for length in size)
    if not is_number(unit) or not 0 < unit < math.inf:
        raise ProgramError(call.place, "a unit is a positive number of metres")
    return tuple(math.ceil(length / unit * (1 - 1e-6)) for length in size)


def has_front(run, call):
    return model_facts(call)["front"] != "none"


def is_text(value):
    return type(value) is str


def is_point(value):
    return type(value) is tuple and len(value) in (2, 3) and all(is_number(each) for each in value)


def is_color(value):
    if type(value) is str:
        return value in COLOURS or re.fullmatch("#[0-9a-fA-F]{6}", value) is not None
    return type(value) is tuple and len(value) == 3 and all(is_number(each) and 0 <= each <= 1 for each in value)


PLACE_RULES = {
    "asset": is_text,
    "at": is_point,
    "size": lambda value: is_point(value) and all(each > 0 for each in value),
    "turn": lambda value: type(value) is int,
    "angle": is_number,
    "color": is_color,
    "name": is_text,
}


def place(run, call):
    for parameter, rule in PLACE_RULES.items():
        value = call.given.get(parameter)
        if value is not None and not rule(value):
            raise ProgramError(call.place_of(parameter), f"place: {parameter!r} cannot be {text(value)}")
    if call.given.get("turn") is not None and call.given.get("angle") is not None:
        raise ProgramError(call.place_of("angle"), "place: 'angle' stands beside 'turn'")
    run.placed.append(dict(call.given, extras=call.extras))


def builtin(name, parameters, run, required=None, **more):
    parameters = parameters.split()
    return Builtin(name, parameters, len(parameters) if required is None else required, run, **more)


BUILTINS = {
    each.name: each
    for each in [
        builtin("range", "lo hi step", choose_range, required=2),
        builtin("flip", "probability", choose_flip, required=0),
        builtin("choose", "list weights", choose_element, required=1),
        builtin("categorical", "weights", choose_position),
        builtin("assert", "condition message", check, required=1),
        builtin("prefer", "condition weight", prefer, required=1),
        builtin("minimize", "x", minimize),
        builtin("maximize", "x", maximize),
        builtin("min", "list", extreme(min), variadic=True, extras=True),
        builtin("max", "list", extreme(max), variadic=True, extras=True),
        builtin("abs", "x", lambda run, call: abs(a_number(call))),
        builtin("mod", "a b", lambda run, call: BINARY["%"](call.given["a"], call.given["b"], call.place)),
        builtin("floor", "x", floor),
        builtin("sqrt", "x", of_float(math.sqrt)),
        builtin("sin", "x", of_float(math.sin)),
        builtin("cos", "x", of_float(math.cos)),
        builtin("exp", "x", of_float(exponential)),
        builtin("log", "x", of_float(math.log)),
        builtin("lgamma", "x", of_float(math.lgamma)),
        builtin("pow", "base exponent", power),
        builtin("cond", "condition then otherwise", select),
        builtin("all", "conditions", quantifier(all), required=0, variadic=True),
        builtin("any", "conditions", quantifier(any), required=0, variadic=True),
        builtin("length", "list", length),
        builtin("sum", "list", total),
        builtin("contains", "list value", contains),
        builtin("count", "list value", count, required=1),
        builtin("index_of", "list value", index_of),
        builtin("first", "list", first),
        builtin("last", "list", last),
        builtin("enumerate", "list", lambda run, call: tuple(enumerate(a_list(call)))),
        builtin("sort", "list key", sort, required=1),
        builtin("map", "f list", map_list),
        builtin("filter", "f list", filter_list),
        builtin("distinct", "list", distinct),
        builtin("boxes_apart", "boxes gap", boxes_apart, required=1),
        builtin("pairs", "list", lambda run, call: tuple(pairs_of(a_list(call)))),
        builtin("zip", "a b", zip_lists),
        builtin("reverse", "list", lambda run, call: a_list(call)[::-1]),
        builtin("cons", "first rest", lambda run, call: (call.given["first"], *a_list(call, "rest"))),
        builtin("car", "list", first),
        builtin("cdr", "list", others),
        builtin("null", "list", lambda run, call: not a_list(call)),
        builtin("str", "value", join_texts, variadic=True),
        builtin("format", "text", format_text, variadic=True),
        builtin("print", "", print_line, variadic=True),
        builtin("unit", "metres", unit, required=0),
        builtin("size_of", "asset unit", size_of, required=1),
        builtin("has_front", "asset", has_front),
        builtin("allowed", "table a b", allowed),
        builtin("tile_neighbors", "table a b", allowed),
        builtin("tile_pairs", "exemplar", tile_pairs),
        builtin("tile_sites", "w h source", tile_sites),
        builtin("place", "asset at size turn angle color name", place, required=0, extras=True),
    ]
}
