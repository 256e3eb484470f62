"""Runs a program once, with a value for each choice that it meets."""

from .builtins import BUILTINS
from .operators import (
    BINARY, Rejected, condition, element, field_value, ints_from_to, negative, with_element, with_field,
)  # fmt: skip
from .syntax import Argument, FieldOf, Index, Name, Output, ProgramError
from .values import Builtin, BuiltinCall, Closure, Constructor, Record, kind


class Activation:
    """A call that runs: the address of what it does, and the turns of the loops around the current place in it."""

    def __init__(self, path, depth):
        self.path = path
        self.depth = depth
        self.turns = []

    def step(self, label):
        turns = "".join(f"[{turn}]" for turn in self.turns)
        if label == "":
            return "/".join(self.path) + turns
        return "/".join(self.path + [label + turns])

    def inner(self, label):
        return Activation([self.step(label)], self.depth + 1)


class Frame:
    """Variables: those of a call, of a file, or of a comprehension. `owned` are the names that belong here, also while they
    have no value."""

    def __init__(self, owned, parent, activation):
        self.owned = owned
        self.parent = parent
        self.activation = activation
        self.values = {}

    def owner(self, name):
        """The frame that a name belongs to, or the file's where it belongs to none."""
        frame = self
        while name not in frame.owned and frame.parent is not None:
            frame = frame.parent
        return frame


class FileFrame(Frame):
    """The variables of a file's top level."""

    def __init__(self, module, activation):
        super().__init__(module.assigned, None, activation)
        self.module = module


class Returned:
    """What a statement gives that ends its function."""

    def __init__(self, value):
        self.value = value


class Execution:
    """One run. `chooser(domain)` gives the value of the next choice. After `run` there is `value`, `choices`, `printed`,
    `placed`, and `cost`, which is None if no wish was met."""

    def __init__(self, program, chooser, params, max_steps, max_depth, relaxed=False):
        self.program = program
        self.chooser = chooser
        self.params = params
        self.steps_left = max_steps
        self.max_depth = max_depth
        self.frames = {}  # of files that run or have run
        self.value = None
        self.returned = None  # the value before the output
        self.choices = {}
        self.chosen_from = {}  # of each choice of an element, the list
        self.printed = []
        self.unit = 1.0
        self.placed = []
        self.cost = None
        self.output_place = None  # of the output, once it runs
        self.relaxed = relaxed  # whether asserts may be broken
        self.broken = set()  # the addresses of asserts that are broken
        self.in_auxiliary = 0
        self.auxiliary = set()  # the addresses of auxiliary choices
        self.floats = set()  # the places where an operator met a float after a choice

    def run(self):
        """Raises ProgramError or Rejected."""
        main = self.program.main
        self.value = self.returned = self.run_module(main, [])
        if main.body and isinstance(main.body[-1], Output):
            self.run_output(main.body[-1], self.frames[main.file])

    def run_output(self, output, frame):
        self.output_place = output.place
        try:
            result = self.statements(output.body, frame)
        except Rejected as rejected:
            raise ProgramError(output.place, "a solution is not ruled out by its output") from rejected
        if isinstance(result, Returned):
            self.value = result.value

    def run_module(self, module, path):
        frame = FileFrame(module, Activation(path, 0))
        self.frames[module.file] = frame
        result = self.statements(module.body, frame)
        return result.value if isinstance(result, Returned) else None

    # ---- effects

    def not_in_output(self):
        if self.output_place is not None:
            raise ProgramError(self.output_place, "an output makes no choices and has no wishes")

    def choose(self, address, domain):
        self.not_in_output()
        if len(domain) == 0:
            raise Rejected
        if address in self.choices:
            raise AssertionError(f"two choices of one execution share the address {address}")
        value = self.chooser(domain)
        self.choices[address] = value
        if self.in_auxiliary:
            self.auxiliary.add(address)
        return value

    def break_assert(self, address):
        if not self.relaxed or self.output_place is not None:
            raise Rejected
        self.broken.add(address)

    def add_cost(self, cost):
        self.not_in_output()
        self.cost = (self.cost or 0) + cost

    def step(self, place, count=1):
        self.steps_left -= count
        if self.steps_left < 0:
            raise ProgramError(place, "this runs for more than the allowed steps")

    # ---- statements; each gives None, "break", "continue" or a Returned

    def statements(self, statements, frame):
        for statement in statements:
            result = self.statement(statement, frame)
            if result is not None:
                return result
        return None

    def statement(self, statement, frame):
        self.step(statement.place)
        return getattr(self, "run_" + type(statement).__name__)(statement, frame)

    def run_Evaluate(self, statement, frame):
        self.expression(statement.expression, frame)

    def run_Block(self, statement, frame):
        return self.statements(statement.body, frame)

    def run_Output(self, statement, frame):
        pass  # until the program has come to its end

    def run_Auxiliary(self, statement, frame):
        self.in_auxiliary += 1
        self.statements(statement.body, frame)
        self.in_auxiliary -= 1

    def run_If(self, statement, frame):
        if self.condition(statement.condition, frame):
            return self.statement(statement.then, frame)
        return self.statement(statement.otherwise, frame) if statement.otherwise else None

    def run_Assign(self, statement, frame):
        values = [self.expression(value, frame) for value in statement.values]
        if len(statement.targets) > 1 and len(values) == 1:
            values = self.taken_apart(values[0], len(statement.targets), statement.values[0].place)
        elif len(values) != len(statement.targets):
            raise ProgramError(statement.place, "not as many values as variables")
        for target, value in zip(statement.targets, values):
            self.assign(target, value, frame)

    def run_Change(self, statement, frame):
        value = self.expression(statement.value, frame)
        keys = self.keys(statement.target, frame)
        owner, name = self.variable(statement.target, frame)
        old = self.part(owner.values[name], keys)
        self.step(statement.place)
        owner.values[name] = self.changed(
            owner.values[name], keys, BINARY[statement.operator](old, value, statement.place)
        )

    def run_For(self, statement, frame):
        items = self.expression(statement.items, frame)
        if type(items) is not tuple:
            raise ProgramError(statement.items.place, f"{kind(items)} cannot be looped over")
        turns = frame.activation.turns
        for turn, item in enumerate(items):
            self.bind_turn(statement.names, item, frame.owner(statement.names[0]), statement.items.place)
            turns.append(turn)
            result = self.statement(statement.body, frame)
            turns.pop()
            if result == "break":
                break
            if isinstance(result, Returned):
                return result
        return None

    def run_While(self, statement, frame):
        turns = frame.activation.turns
        turns.append(0)
        result = None
        while result is None and self.condition(statement.condition, frame):
            result = self.statement(statement.body, frame)
            result = None if result == "continue" else result
            turns[-1] += 1
            self.step(statement.place)
        turns.pop()
        return None if result == "break" else result

    def run_Leave(self, statement, frame):
        return statement.word

    def run_Return(self, statement, frame):
        values = tuple(self.expression(value, frame) for value in statement.values)
        if len(values) > 1:
            return Returned(values)
        return Returned(values[0] if values else None)

    def run_RecordDeclaration(self, statement, frame):
        frame.values[statement.name] = Constructor(statement, frame)

    def run_Param(self, statement, frame):
        if statement.name in self.params:
            frame.values[statement.name] = self.params[statement.name]
        else:
            frame.values[statement.name] = self.expression(statement.default, frame)

    def run_Import(self, statement, frame):
        module = self.program.modules[statement.file]
        if module.file not in self.frames:
            self.run_module(module, [module.step])

    # ---- assignment

    def taken_apart(self, value, count, place):
        if type(value) is not tuple:
            raise ProgramError(place, f"{kind(value)} cannot be taken apart into {count} variables")
        if len(value) != count:
            raise ProgramError(place, f"a list of {len(value)} cannot be taken apart into {count} variables")
        return value

    def bind_turn(self, names, item, frame, place):
        """Gives the variables of a loop or comprehension their values for a turn."""
        self.step(place)
        values = [item] if len(names) == 1 else self.taken_apart(item, len(names), place)
        frame.values.update(zip(names, values))

    def assign(self, target, value, frame):
        if isinstance(target, Name):
            frame.owner(target.name).values[target.name] = value
            return
        keys = self.keys(target, frame)
        owner, name = self.variable(target, frame)
        owner.values[name] = self.changed(owner.values[name], keys, value)

    def variable(self, target, frame):
        """The frame and the name of the variable that a target changes; it has to have a value."""
        while not isinstance(target, Name):
            target = target.base
        self.eval_Name(target, frame)
        return frame.owner(target.name), target.name

    def keys(self, target, frame):
        """The indices and fields that lead from the variable to what is changed, each with its place."""
        if isinstance(target, Name):
            return []
        keys = self.keys(target.base, frame)
        key = self.expression(target.index, frame) if isinstance(target, Index) else target
        return keys + [(key, target.place)]

    def part(self, value, keys):
        for key, place in keys:
            if isinstance(key, FieldOf):
                value = field_value(value, key.name, place)
            else:
                value = element(value, key, place)
        return value

    def changed(self, base, keys, value):
        """A copy of `base` in which what `keys` lead to is `value`."""
        if not keys:
            return value
        key, place = keys[0]
        inner = self.changed(self.part(base, keys[:1]), keys[1:], value)
        if isinstance(key, FieldOf):
            return with_field(base, key.name, inner, place)
        return with_element(base, key, inner, place)

    # ---- expressions

    def expression(self, node, frame):
        return getattr(self, "eval_" + type(node).__name__)(node, frame)

    def condition(self, node, frame):
        return condition(self.expression(node, frame), node.place)

    def eval_Literal(self, node, frame):
        return node.value

    def eval_Name(self, node, frame):
        owner = frame.owner(node.name)
        values = owner.values if node.name in owner.owned else self.imported_values(owner.module, node.name)
        if node.name not in values:
            raise ProgramError(node.place, f"{node.name!r} has no value yet")
        return values[node.name]

    def imported_values(self, module, name):
        """The variables of the imported file that a name comes from, the last import first; or the builtins."""
        for imported in reversed(module.imports):
            if name in imported.assigned:
                return self.frames[imported.file].values if imported.file in self.frames else {}
        return BUILTINS

    def eval_ListDisplay(self, node, frame):
        items = tuple(self.expression(item, frame) for item in node.items)
        self.step(node.place, len(items))
        return items

    def eval_Comprehension(self, node, frame):
        made = []
        self.collect(node, 0, Frame(set(), frame, frame.activation), made)
        return tuple(made)

    def collect(self, node, depth, frame, made):
        """Runs the clauses from `depth` on, inside of those before."""
        if depth == len(node.clauses):
            made.append(self.expression(node.element, frame))
            return
        clause = node.clauses[depth]
        items = self.expression(clause.items, frame)
        if type(items) is not tuple:
            raise ProgramError(clause.items.place, f"{kind(items)} cannot be looped over")
        frame.owned.update(clause.names)
        for turn, item in enumerate(items):
            frame.activation.turns.append(turn)
            self.bind_turn(clause.names, item, frame, clause.items.place)
            if all(self.condition(each, frame) for each in clause.conditions):
                self.collect(node, depth + 1, frame, made)
            frame.activation.turns.pop()

    def eval_Unary(self, node, frame):
        if node.operator == "not":
            return not self.condition(node.operand, frame)
        return negative(self.expression(node.operand, frame), node.place)

    def eval_Binary(self, node, frame):
        if node.operator in ("and", "or"):
            left = self.condition(node.left, frame)
            decided = left if node.operator == "or" else not left
            return left if decided else self.condition(node.right, frame)
        left = self.expression(node.left, frame)
        right = self.expression(node.right, frame)
        if node.operator == "..":
            ints = ints_from_to(left, right, node.place)
            self.step(node.place, len(ints))
            return tuple(ints)
        if self.choices and (type(left) is float or type(right) is float):
            self.floats.add(node.place)
        return BINARY[node.operator](left, right, node.place)

    def eval_Conditional(self, node, frame):
        chosen = node.then if self.condition(node.condition, frame) else node.otherwise
        return self.expression(chosen, frame)

    def eval_Index(self, node, frame):
        base = self.expression(node.base, frame)
        return element(base, self.expression(node.index, frame), node.place)

    def eval_FieldOf(self, node, frame):
        base = self.expression(node.base, frame)
        return field_value(base, node.name, node.place)

    def eval_FunctionDisplay(self, node, frame):
        return Closure(node, frame)

    # ---- calls

    def eval_Call(self, node, frame):
        self.step(node.place)
        callee = self.expression(node.callee, frame)
        arguments = [(each, self.expression(each.value, frame)) for each in node.arguments]
        return self.call(callee, node, arguments, frame.activation)

    def call_function(self, callee, node, values, activation):
        """A call that a builtin makes, with arguments by position."""
        self.step(node.place)
        return self.call(callee, node, [(Argument(None, node), value) for value in values], activation)

    def call(self, callee, node, arguments, activation):
        if type(callee) is Builtin:
            return self.call_builtin(callee, node, arguments, activation)
        if type(callee) is Closure:
            parameters, name = callee.function.parameters, callee.function.name
        elif type(callee) is Constructor:
            parameters, name = callee.declaration.parameters, callee.declaration.name
        else:
            raise ProgramError(node.place, f"{kind(callee)} cannot be called")
        given = bind(node, name, [parameter.name for parameter in parameters], arguments)
        return self.enter(callee, node, parameters, given, activation)

    def enter(self, callee, node, parameters, given, caller):
        if caller.depth >= self.max_depth:
            raise ProgramError(node.place, "calls nest deeper than allowed")
        activation = caller.inner(node.label)
        function = callee.function if type(callee) is Closure else callee.declaration
        inner = Frame(function.assigned, callee.frame, activation)
        for parameter in parameters:
            if parameter.name in given:
                inner.values[parameter.name] = given[parameter.name]
            elif parameter.default is not None:
                inner.values[parameter.name] = self.expression(parameter.default, inner)
            else:
                raise ProgramError(node.place, f"there is no argument for {parameter.name!r}")
        if type(callee) is Constructor:
            return Record(function, tuple(inner.values[parameter.name] for parameter in parameters))
        result = self.statements(function.body, inner)
        return result.value if isinstance(result, Returned) else None

    def call_builtin(self, callee, node, arguments, activation):
        call = BuiltinCall(node, lambda: activation.step(node.label or callee.name), {}, [], [], activation)
        fixed = [argument for argument in arguments if argument[0].name in (None, *callee.parameters)]
        by_position = [argument for argument in fixed if argument[0].name is None]
        if callee.variadic:
            beyond = by_position[len(callee.parameters) :]
            call.rest = [value for _, value in beyond]
            fixed = [argument for argument in fixed if argument not in beyond]
        if callee.extras:
            call.extras = [(each.name, value) for each, value in arguments if each.name and (each, value) not in fixed]
        else:
            fixed += [argument for argument in arguments if argument[0].name not in (None, *callee.parameters)]
        call.given = bind(node, callee.name, callee.parameters, fixed)
        for parameter in callee.parameters[: callee.required]:
            if parameter not in call.given:
                raise ProgramError(node.place, f"{callee.name!r} needs an argument for {parameter!r}")
        call.places = {each.name: each.value.place for each, _ in arguments if each.name}
        call.places.update(zip(callee.parameters, [each.value.place for each, _ in by_position]))
        return callee.run(self, call)


def bind(node, name, parameters, arguments):
    """The arguments of a call by parameter. Raises ProgramError for one too many, and one that fits no parameter."""
    given = {}
    for position, (argument, value) in enumerate(arguments):
        parameter = argument.name
        if parameter is None:
            if position >= len(parameters):
                raise ProgramError(node.place, f"{name!r} takes {len(parameters)} arguments")
            parameter = parameters[position]
        if parameter not in parameters:
            raise ProgramError(argument.value.place, f"{name!r} has no parameter {parameter!r}")
        if parameter in given:
            raise ProgramError(argument.value.place, f"{parameter!r} is given twice")
        given[parameter] = value
    return given
