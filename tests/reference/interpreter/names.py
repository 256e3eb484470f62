"""Finds which names belong to which function or file, and refuses those that are not there."""

from .syntax import (
    Assign, Binary, Block, Call, Change, Comprehension, Conditional, Evaluate, FieldOf, For, FunctionDisplay,
    If, Index, ListDisplay, Name, Param, ProgramError, RecordDeclaration, Return, Unary, While,
)  # fmt: skip


def target_name(target):
    """The variable that an assignment to `x`, `x[i]` or `x.f` changes."""
    while isinstance(target, (Index, FieldOf)):
        target = target.base
    return target


def names_assigned(statements):
    """The names that statements assign as a whole. A change of an element or by `+=` makes no variable."""
    names = set()
    for statement in statements:
        match statement:
            case Assign(targets=targets):
                names.update(target.name for target in targets if isinstance(target, Name))
            case Block(body=body):
                names |= names_assigned(body)
            case If(then=then, otherwise=otherwise):
                names |= names_assigned([then] + ([otherwise] if otherwise else []))
            case For(names=turn_names, body=body):
                names.update(turn_names)
                names |= names_assigned([body])
            case While(body=body):
                names |= names_assigned([body])
            case Param(name=name) | RecordDeclaration(name=name):
                names.add(name)
    return names


class NameChecker:
    """Walks over a file. `scopes` are the sets of names around the current place, the outermost first; the innermost
    function's own names are in `own`."""

    def __init__(self, module, builtins):
        self.scopes = [set(builtins)]
        for imported in module.imports:
            self.scopes[0] |= imported.assigned
        self.own = module.assigned
        self.scopes.append(self.own)
        self.statements(module.body)

    def fail(self, node, message):
        raise ProgramError(node.place, message)

    def statements(self, statements):
        for statement in statements:
            self.statement(statement)

    def statement(self, statement):
        match statement:
            case Assign(targets=targets, values=values):
                self.expressions(values)
                for target in targets:
                    self.target(target)
            case Change(target=target, value=value):
                self.expression(value)
                self.target(target)
            case Evaluate(expression=expression):
                self.expression(expression)
            case Block(body=body):
                self.statements(body)
            case If(condition=condition, then=then, otherwise=otherwise):
                self.expression(condition)
                self.statements([then] + ([otherwise] if otherwise else []))
            case For(items=items, body=body):
                self.expression(items)
                self.statement(body)
            case While(condition=condition, body=body):
                self.expression(condition)
                self.statement(body)
            case Return(values=values):
                self.expressions(values)
            case Param(default=default):
                self.expression(default)
            case RecordDeclaration(parameters=parameters):
                self.function(statement, parameters, [])

    def target(self, target):
        while isinstance(target, (Index, FieldOf)):
            if isinstance(target, Index):
                self.expression(target.index)
            target = target.base
        if target.name in self.own:
            return
        self.name(target)
        self.fail(target, f"{target.name!r} does not belong to this function, which cannot change it")

    def name(self, node):
        if not any(node.name in scope for scope in self.scopes):
            self.fail(node, f"there is no {node.name!r} here")

    def function(self, function, parameters, body):
        function.assigned = names_assigned(body) | {parameter.name for parameter in parameters}
        outer, self.own = self.own, function.assigned
        self.scopes.append(self.own)
        self.expressions([each.default for each in parameters if each.default is not None])
        self.statements(body)
        self.scopes.pop()
        self.own = outer

    def comprehension(self, node):
        before = len(self.scopes)
        for clause in node.clauses:
            self.expression(clause.items)
            self.scopes.append(set(clause.names))
            self.expressions(clause.conditions)
        self.expression(node.element)
        del self.scopes[before:]

    def expressions(self, expressions):
        for expression in expressions:
            self.expression(expression)

    def expression(self, node):
        match node:
            case Name():
                self.name(node)
            case ListDisplay(items=items):
                self.expressions(items)
            case Comprehension():
                self.comprehension(node)
            case Unary(operand=operand):
                self.expression(operand)
            case Binary(left=left, right=right):
                self.expressions([left, right])
            case Conditional(condition=condition, then=then, otherwise=otherwise):
                self.expressions([condition, then, otherwise])
            case Index(base=base, index=index):
                self.expressions([base, index])
            case FieldOf(base=base):
                self.expression(base)
            case Call(callee=callee, arguments=arguments):
                self.expressions([callee] + [argument.value for argument in arguments])
            case FunctionDisplay(parameters=parameters, body=body):
                self.function(node, parameters, body)


def resolve(module, builtins):
    """Sets the names that the file and its functions own. Raises ProgramError at a name that is not there. The
    imported modules have to be resolved already."""
    module.assigned = names_assigned(module.body)
    module.records = {each.name: each for each in module.body if isinstance(each, RecordDeclaration)}
    NameChecker(module, builtins)
