"""Names the calls of a program as steps of addresses, by the rules of the manual's chapter on addresses.

A choice is named after what it is for, any other call after its function, and `#2`, `#3` … tell the uses of a name in one
function apart. They are counted in the order of evaluation: arguments before their call, values before the variable's
index, and the `for`s and `if`s of a comprehension before its element.
"""

from collections import Counter

from .syntax import (
    Assign, Binary, Block, Call, Change, Comprehension, Conditional, Evaluate, FieldOf, For, FunctionDisplay,
    If, Index, ListDisplay, Name, Param, RecordDeclaration, Return, Unary, While,
)  # fmt: skip

CHOICES = ("range", "flip", "choose", "categorical")
NAMED_AFTER_PURPOSE = (*CHOICES, "map", "filter")
CALLING = ("sort", "min", "max")  # builtins that call functions, which may choose


class Labeller:
    """Labels one function or the top level of a file; each function in it gets a Labeller of its own."""

    def __init__(self, module, builtins, hidden):
        self.module = module
        self.builtins = builtins
        self.hidden = hidden  # names of the functions around, which hide the file's records and the builtins
        self.uses = Counter()
        self.names = set()  # of all calls that got a label, and of those in functions whose calls got none
        self.parameters = set()  # of the function
        self.parameter_calls = []
        self.results = []  # calls whose results the function returns, by themselves or as elements of a list
        self.is_function = False

    # ---- what a name stands for

    def is_builtin(self, name):
        modules = [self.module] + self.module.imports
        return name in self.builtins and name not in self.hidden and not any(name in m.assigned for m in modules)

    def record_called(self, callee):
        """The declaration of the record that is made by a call of this name, or None."""
        if not isinstance(callee, Name) or callee.name in self.hidden:
            return None
        for module in [self.module] + self.module.imports[::-1]:
            if callee.name in module.assigned:
                return module.records.get(callee.name)
        return None

    # ---- labels

    def use(self, name):
        self.uses[name] += 1
        self.names.add(name)
        count = self.uses[name]
        return name if count == 1 else f"{name}#{count}"

    def sides(self, walk, nodes):
        """Walks the sides of an `if`. They exclude each other, so each counts on from what stands before it; and what
        follows the `if` excludes the sides that return."""
        before, most = self.uses, Counter(self.uses)
        for node in nodes:
            self.uses = Counter(before)
            walk(node)
            if not always_returns(node):
                most |= self.uses
        self.uses = most

    def call(self, node, purpose):
        callee = node.callee
        self.expression(callee, purpose)
        record = self.record_called(callee)
        for position, argument in enumerate(node.arguments):
            name = argument.name
            if name is None and record is not None and position < len(record.parameters):
                name = record.parameters[position].name
            if name is not None and record is not None and purpose is not None:
                name = f"{purpose}.{name}"
            self.expression(argument.value, name)
        if isinstance(callee, Name) and self.is_builtin(callee.name):
            if callee.name in NAMED_AFTER_PURPOSE:
                node.label = self.use(purpose or callee.name)
            elif callee.name in CALLING:
                node.label = self.use(callee.name)
        elif self.module.library and isinstance(callee, Name) and callee.name in self.parameters:
            self.parameter_calls.append(node)
        elif isinstance(callee, Name) and purpose and record is None and self.is_of_library(callee.name):
            node.label = self.use(purpose)
        elif not purpose and self.is_wrapper(node):
            node.label = ""
        else:
            node.label = self.use(callee.name if isinstance(callee, (Name, FieldOf)) else "call")

    def is_of_library(self, name):
        """Whether a name means a function that a file of the library brings."""
        module = self.module_of(name)
        return module is not None and module.library

    def module_of(self, name):
        """The file at whose top level the name is assigned, or None."""
        if name in self.hidden:
            return None
        for module in [self.module] + self.module.imports[::-1]:
            if name in module.assigned:
                return module
        return None

    def is_wrapper(self, node):
        """Whether the function returns what a function of the library made, so that it needs no step: if nothing that
        comes before has the address of what is in it."""
        callee = node.callee
        if not any(node is result for result in self.results) or not isinstance(callee, Name):
            return False
        if not self.is_of_library(callee.name):
            return False
        names = self.module_of(callee.name).steps.get(callee.name)
        if names is None or self.uses[""] or any(self.uses[name] for name in names):
            return False
        self.uses[""] = 1
        self.names |= names
        return True

    def note_results(self, node):
        match node:
            case Call():
                self.results.append(node)
            case Comprehension(element=element):
                self.note_results(element)
            case Conditional(then=then, otherwise=otherwise):
                self.note_results(then)
                self.note_results(otherwise)

    def finish(self):
        """The only call of what a function of the library was given makes no step: its label stays empty."""
        for node in self.parameter_calls:
            node.label = "" if len(self.parameter_calls) == 1 else self.use(node.callee.name)

    def function(self, parameters, body, assigned):
        inner = Labeller(self.module, self.builtins, self.hidden | assigned)
        for parameter in parameters:
            inner.expression(parameter.default, parameter.name)
        inner.parameters = {parameter.name for parameter in parameters}
        inner.is_function = True
        inner.statements(body)
        inner.finish()
        return inner.names

    # ---- walking; `purpose` is what a choice at this place would be for, or None

    def expressions(self, nodes, purpose):
        for node in nodes:
            self.expression(node, purpose)

    def expression(self, node, purpose):
        match node:
            case ListDisplay(items=items):
                self.expressions(items, purpose)
            case Comprehension(element=element, clauses=clauses):
                self.comprehension(element, clauses, purpose)
            case Unary(operand=operand):
                self.expression(operand, purpose)
            case Binary(left=left, right=right):
                self.expressions([left, right], purpose)
            case Conditional(condition=condition, then=then, otherwise=otherwise):
                self.expression(condition, purpose)
                self.sides(lambda side: self.expression(side, purpose), [then, otherwise])
            case Index(base=base, index=index):
                self.expressions([base, index], purpose)
            case FieldOf(base=base):
                self.expression(base, purpose)
            case Call():
                self.call(node, purpose)
            case FunctionDisplay(parameters=parameters, body=body, name=name, assigned=assigned):
                names = self.function(parameters, body, assigned)
                if not self.is_function:
                    self.module.steps.setdefault(name, names)

    def comprehension(self, element, clauses, purpose):
        outer = self.hidden
        for clause in clauses:
            self.expression(clause.items, purpose)
            self.hidden = self.hidden | set(clause.names)
            self.expressions(clause.conditions, purpose)
        self.expression(element, purpose)
        self.hidden = outer

    def statements(self, statements):
        for statement in statements:
            self.statement(statement)

    def statement(self, statement):
        match statement:
            case Assign(targets=targets, values=values):
                self.assignment(targets, values)
            case Change(target=target, value=value):
                self.assignment([target], [value])
            case Evaluate(expression=expression):
                self.expression(expression, None)
            case Block(body=body):
                self.statements(body)
            case If(condition=condition, then=then, otherwise=otherwise):
                self.expression(condition, None)
                self.sides(self.statement, [then, otherwise])
            case For(items=items, body=body):
                self.expression(items, None)
                self.statement(body)
            case While(condition=condition, body=body):
                self.expression(condition, None)
                self.statement(body)
            case Return(values=values):
                if self.is_function and len(values) == 1:
                    self.note_results(values[0])
                self.expressions(values, None)
            case Param(name=name, default=default):
                self.expression(default, name)
            case RecordDeclaration(parameters=parameters, assigned=assigned):
                self.function(parameters, [], assigned)

    def assignment(self, targets, values):
        for target, value in zip(targets, values):
            self.expression(value, purpose_of(target))
        self.expressions(values[len(targets) :], None)
        for target in targets:
            self.indices(target)

    def indices(self, target):
        """The index expressions of a target, from the variable outwards."""
        if isinstance(target, (Index, FieldOf)):
            self.indices(target.base)
        if isinstance(target, Index):
            self.expression(target.index, None)


def always_returns(statement):
    match statement:
        case Return():
            return True
        case Block(body=body):
            return any(always_returns(each) for each in body)
        case If(then=then, otherwise=otherwise):
            return always_returns(then) and always_returns(otherwise)
    return False


def purpose_of(target):
    """What an assigned choice is for: the variable, or its field."""
    if isinstance(target, Index):
        return purpose_of(target.base)
    return f"{purpose_of(target.base)}.{target.name}" if isinstance(target, FieldOf) else target.name


def label(module, builtins):
    """Sets the label of every call of the file. The file has to be resolved already."""
    Labeller(module, builtins, set()).statements(module.body)
