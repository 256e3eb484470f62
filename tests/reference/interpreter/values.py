"""The values of the language. Nothing changes in place: an assignment to an element makes a new list or record.

An int is a Python int, a bool a bool, a float a float, a string a str, a list a tuple, and nil is None.
"""

from dataclasses import dataclass, field

from .syntax import FunctionDisplay, RecordDeclaration


@dataclass(frozen=True, eq=False)
class Record:
    declaration: RecordDeclaration
    fields: tuple  # the values, in the order of the declaration

    def position(self, name):
        """The position of a field, or None."""
        names = [parameter.name for parameter in self.declaration.parameters]
        return names.index(name) if name in names else None


@dataclass(frozen=True, eq=False)
class Closure:
    function: FunctionDisplay
    frame: object


@dataclass(frozen=True, eq=False)
class Constructor:
    declaration: RecordDeclaration
    frame: object


@dataclass(frozen=True, eq=False)
class Builtin:
    """A builtin function. `run` takes the evaluator and a BuiltinCall."""

    name: str
    parameters: list
    required: int
    run: object
    variadic: bool = False  # takes more by position
    extras: bool = False  # takes more by name


@dataclass
class BuiltinCall:
    """The arguments of a builtin, and where they stand."""

    node: object
    address: object  # a function that makes the address, for choices and things that are placed
    given: dict  # by parameter
    rest: list
    extras: list
    activation: object = None  # the call that the builtin is called in
    places: dict = field(default_factory=dict)

    @property
    def place(self):
        return self.node.place

    def place_of(self, parameter):
        return self.places.get(parameter, self.place)


KINDS = {int: "an int", bool: "a bool", float: "a float", str: "a string", tuple: "a list", Record: "a record",
         Closure: "a function", Constructor: "a function", Builtin: "a function", type(None): "nil"}  # fmt: skip


def kind(value):
    return KINDS[type(value)]


def is_number(value):
    return type(value) in (int, float)


def same(a, b):
    """What `==` says."""
    if is_number(a) and is_number(b):
        return a == b  # Python compares an int and a float exactly
    if type(a) is not type(b):
        return False
    if type(a) is tuple:
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    if type(a) is Record:
        return a.declaration is b.declaration and same(a.fields, b.fields)
    if type(a) is Closure:
        return a.function is b.function and a.frame is b.frame
    if type(a) is Constructor:
        return a.declaration is b.declaration
    return a is b if type(a) is Builtin else a == b


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'


def function_text(value):
    if type(value) is Constructor:
        return "record " + value.declaration.name
    name = value.name if type(value) is Builtin else value.function.name
    return f"fun {name}".rstrip()


def text(value, inside=False):
    """What `str` and `print` make of a value. A string stands in quotes inside of a list or record."""
    if type(value) is bool:
        return "true" if value else "false"
    if value is None:
        return "nil"
    if type(value) is str:
        return quoted(value) if inside else value
    if type(value) is tuple:
        return "[" + ", ".join(text(each, True) for each in value) + "]"
    if type(value) is Record:
        names = [parameter.name for parameter in value.declaration.parameters]
        fields = [f"{name}: {text(each, True)}" for name, each in zip(names, value.fields)]
        return f"{value.declaration.name}({', '.join(fields)})"
    return repr(value) if is_number(value) else function_text(value)


def plain(value):
    """A value as JSON has it: lists, dicts, numbers, strings, bools and None."""
    if type(value) is tuple:
        return [plain(each) for each in value]
    if type(value) is Record:
        return {p.name: plain(each) for p, each in zip(value.declaration.parameters, value.fields)}
    if type(value) in (Closure, Constructor, Builtin):
        return function_text(value)
    return value
