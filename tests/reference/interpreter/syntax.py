"""The syntax tree of a .sol program: a class for each form, without behaviour."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Place:
    """Where something stands in the text. Lines count from 1."""

    file: str
    line: int


class ProgramError(Exception):
    """The program is wrong: it can not be read, or an execution comes to a mistake at `place`."""

    def __init__(self, place, message):
        super().__init__(f"{place.file}:{place.line}: {message}")
        self.place = place
        self.message = message


@dataclass(eq=False)
class Node:
    place: Place


# ---- expressions


@dataclass(eq=False)
class Literal(Node):
    value: object


@dataclass(eq=False)
class Name(Node):
    name: str


@dataclass(eq=False)
class ListDisplay(Node):
    items: list


@dataclass(eq=False)
class Clause:
    """`for a, b in items if c if d` of a comprehension."""

    names: list
    items: Node
    conditions: list


@dataclass(eq=False)
class Comprehension(Node):
    element: Node
    clauses: list


@dataclass(eq=False)
class Unary(Node):
    """`-x` or `not x`."""

    operator: str
    operand: Node


@dataclass(eq=False)
class Binary(Node):
    """An operator of two operands, `and`, `or` and `..` among them."""

    operator: str
    left: Node
    right: Node


@dataclass(eq=False)
class Conditional(Node):
    """`if c then a else b` as an expression."""

    condition: Node
    then: Node
    otherwise: Node


@dataclass(eq=False)
class Index(Node):
    base: Node
    index: Node


@dataclass(eq=False)
class FieldOf(Node):
    base: Node
    name: str


@dataclass(eq=False)
class Argument:
    name: str | None
    value: Node


@dataclass(eq=False)
class Call(Node):
    callee: Node
    arguments: list
    label: str = ""  # the step of an address that this call is, set by labels.py


@dataclass(eq=False)
class Parameter:
    name: str
    default: Node | None
    place: Place


@dataclass(eq=False)
class FunctionDisplay(Node):
    """`fun(x) { … }`; `assigned` are the names that belong to the function, set by names.py."""

    parameters: list
    body: list
    name: str = ""
    assigned: set = field(default_factory=set)


# ---- statements


@dataclass(eq=False)
class Assign(Node):
    """`x, y = e, f`: the targets are Name, Index or FieldOf."""

    targets: list
    values: list


@dataclass(eq=False)
class Change(Node):
    """`x += e` and its like; `operator` is without the `=`."""

    target: Node
    operator: str
    value: Node


@dataclass(eq=False)
class Evaluate(Node):
    expression: Node


@dataclass(eq=False)
class Block(Node):
    body: list


@dataclass(eq=False)
class Output(Block):
    """What runs at the end of every solution."""


@dataclass(eq=False)
class Auxiliary(Block):
    """A statement whose choices are auxiliary."""


@dataclass(eq=False)
class If(Node):
    condition: Node
    then: Node
    otherwise: Node | None


@dataclass(eq=False)
class For(Node):
    names: list
    items: Node
    body: Node


@dataclass(eq=False)
class While(Node):
    condition: Node
    body: Node


@dataclass(eq=False)
class Leave(Node):
    """`break` or `continue`."""

    word: str


@dataclass(eq=False)
class Return(Node):
    values: list


@dataclass(eq=False)
class RecordDeclaration(Node):
    name: str
    parameters: list
    assigned: set = field(default_factory=set)


@dataclass(eq=False)
class Param(Node):
    name: str
    default: Node


@dataclass(eq=False)
class Import(Node):
    path: str
    file: str = ""  # the file that the path leads to, set by modules.py


# ---- files


@dataclass(eq=False)
class Module:
    """A file: its statements and the names that its top level assigns."""

    file: str
    step: str  # of the addresses of what its top level does, if it is imported
    body: list
    library: bool = False  # whether the file belongs to the language's own library
    assigned: set = field(default_factory=set)
    records: dict = field(default_factory=dict)  # name -> RecordDeclaration
    steps: dict = field(default_factory=dict)  # name of a function -> names that its calls have in addresses
    imports: list = field(default_factory=list)  # Modules, in the order of their import statements
