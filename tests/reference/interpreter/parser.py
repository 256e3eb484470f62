"""Makes the syntax tree of a .sol file, by recursive descent."""

from .lexer import tokens_of
from .syntax import (
    Argument, Assign, Auxiliary, Binary, Block, Call, Change, Clause, Comprehension, Conditional, Evaluate, FieldOf, For,
    FunctionDisplay, If, Import, Index, Leave, ListDisplay, Literal, Name, Output, Param, Parameter, ProgramError,
    RecordDeclaration, Return, Unary, While,
)  # fmt: skip

COMPARISONS = ("==", "!=", "<", "<=", ">", ">=", "in")
CHANGES = ("+=", "-=", "*=", "/=", "%=")
CONSTANTS = {"true": True, "false": False, "nil": None}


class Parser:
    def __init__(self, text, file):
        self.tokens = tokens_of(text, file)
        self.at = 0
        self.end_of_function = -1  # the index of the token after the last function's closing brace
        self.loops = 0  # around the current place, in its function

    # ---- tokens

    @property
    def token(self):
        return self.tokens[self.at]

    @property
    def place(self):
        return self.token.place

    def sees(self, *kinds):
        return self.token.kind in kinds

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def accept(self, kind):
        if not self.sees(kind):
            return False
        self.at += 1
        return True

    def expect(self, kind):
        if not self.sees(kind):
            raise ProgramError(self.error_place(kind), f"expected {kind!r}, found {self.token.value!r}")
        return self.take()

    def error_place(self, kind):
        """A missing ';' is reported behind the statement, anything else where it should stand."""
        return self.tokens[self.at - 1].place if kind == ";" and self.at > 0 else self.place

    # ---- statements

    def file(self):
        body = []
        while not self.sees("end"):
            body.append(self.statement(top_level=True))
        return body

    def statement(self, top_level=False):
        forms = {"if": self.if_statement, "for": self.for_statement, "while": self.while_statement,
                 "{": self.block, "break": self.leave, "continue": self.leave, "return": self.returning,
                 "record": self.record, "param": self.param, "import": self.importing}  # fmt: skip
        word = self.token.kind
        if word in ("record", "param", "import") and not top_level:
            raise ProgramError(self.place, f"a {word} stands at the top level of a file")
        if word in forms:
            return forms[word]()
        if word == "name" and self.token.value == "output" and self.tokens[self.at + 1].kind == "{":
            return self.output(top_level)
        if word == "name" and self.token.value == "aux" and self.tokens[self.at + 1].kind == "name":
            place = self.take().place
            return Auxiliary(place, [self.simple_statement()])
        if word == "fun" and self.tokens[self.at + 1].kind == "name":
            return self.function_statement()
        return self.simple_statement()

    def output(self, top_level):
        place = self.take().place
        body = self.block().body
        if not top_level or not self.sees("end"):
            raise ProgramError(place, "the output stands at the end of the script")
        return Output(place, body)

    def end_statement(self):
        if self.accept(";") or self.sees("}", "else", "end") or self.at == self.end_of_function:
            return
        self.expect(";")

    def block(self):
        place = self.expect("{").place
        body = []
        while not self.sees("}", "end"):
            body.append(self.statement())
        self.expect("}")
        return Block(place, body)

    def if_statement(self):
        place = self.take().place
        condition = self.expression()
        if self.sees("{"):
            then = self.block()
        else:
            self.accept(":")
            self.expect("then")
            then = self.statement()
        otherwise = None
        if self.accept("else"):
            self.accept(":")
            otherwise = self.statement()
        return If(place, condition, then, otherwise)

    def loop_body(self):
        if not self.sees("{"):
            self.expect(":")
        self.loops += 1
        body = self.statement()
        self.loops -= 1
        return body

    def for_statement(self):
        place = self.take().place
        names = self.names()
        self.expect("in")
        items = self.expression()
        return For(place, names, items, self.loop_body())

    def while_statement(self):
        place = self.take().place
        condition = self.expression()
        return While(place, condition, self.loop_body())

    def names(self):
        names = [self.expect("name").value]
        while self.accept(","):
            names.append(self.expect("name").value)
        return names

    def leave(self):
        token = self.take()
        if self.loops == 0:
            raise ProgramError(token.place, f"there is no loop around this {token.kind}")
        self.end_statement()
        return Leave(token.place, token.kind)

    def returning(self):
        place = self.take().place
        values = [] if self.sees(";", "}", "else", "end") else self.expressions()
        self.end_statement()
        return Return(place, values)

    def record(self):
        place = self.take().place
        name = self.expect("name").value
        parameters = self.parameters()
        self.end_statement()
        return RecordDeclaration(place, name, parameters)

    def param(self):
        place = self.take().place
        name = self.expect("name").value
        self.expect("=")
        default = self.expression()
        self.end_statement()
        return Param(place, name, default)

    def importing(self):
        place = self.take().place
        path = self.expect("string").value
        self.end_statement()
        return Import(place, path)

    def function_statement(self):
        place = self.take().place
        name = self.take()
        function = self.function(place, name.value)
        self.accept(";")
        return Assign(place, [Name(name.place, name.value)], [function])

    def simple_statement(self):
        place = self.place
        first = self.expressions()
        if self.accept("="):
            self.check_targets(first)
            statement = Assign(place, first, self.expressions())
            if len(first) == 1 and len(statement.values) > 1:
                raise ProgramError(place, "one variable, but several values")
            self.name_functions(statement)
        elif self.sees(*CHANGES):
            sign = self.take()
            self.check_targets(first)
            if len(first) > 1:
                raise ProgramError(sign.place, "this changes one variable by one value")
            statement = Change(place, first[0], sign.kind[0], self.expression())
        elif len(first) > 1:
            raise ProgramError(place, "expected '='")
        else:
            statement = Evaluate(place, first[0])
        self.end_statement()
        return statement

    def name_functions(self, statement):
        """A function that is assigned to a variable is called after it, as one of `fun f(x)` is."""
        for target, value in zip(statement.targets, statement.values):
            if isinstance(target, Name) and isinstance(value, FunctionDisplay):
                value.name = target.name

    def check_targets(self, targets):
        for target in targets:
            while isinstance(target, (Index, FieldOf)):
                target = target.base
            if not isinstance(target, Name):
                raise ProgramError(target.place, "this cannot be assigned")

    # ---- functions

    def function(self, place, name=""):
        outer_loops, self.loops = self.loops, 0
        parameters = self.parameters()
        body = self.block().body
        self.loops = outer_loops
        self.end_of_function = self.at
        return FunctionDisplay(place, parameters, body, name)

    def parameters(self):
        self.expect("(")
        parameters = []
        while not self.sees(")"):
            token = self.expect("name")
            default = self.expression() if self.accept("=") else None
            if any(each.name == token.value for each in parameters):
                raise ProgramError(token.place, f"two parameters are called {token.value!r}")
            if default is None and parameters and parameters[-1].default is not None:
                raise ProgramError(token.place, f"{token.value!r} stands behind a parameter with a default")
            parameters.append(Parameter(token.value, default, token.place))
            if not self.accept(","):
                break
        self.expect(")")
        return parameters

    # ---- expressions, from the loosest to the tightest

    def expressions(self):
        values = [self.expression()]
        while self.accept(","):
            values.append(self.expression())
        return values

    def expression(self):
        if not self.sees("if"):
            return self.disjunction()
        place = self.take().place
        condition = self.expression()
        self.accept(":")
        self.expect("then")
        then = self.expression()
        self.expect("else")
        self.accept(":")
        return Conditional(place, condition, then, self.expression())

    def chain(self, signs, operand):
        left = operand()
        while self.sees(*signs):
            sign = self.take().kind
            left = Binary(left.place, sign, left, operand())
        return left

    def disjunction(self):
        return self.chain(["or"], self.conjunction)

    def conjunction(self):
        return self.chain(["and"], self.negation)

    def negation(self):
        if not self.sees("not"):
            return self.comparison()
        place = self.take().place
        return Unary(place, "not", self.negation())

    def comparison(self):
        left = self.span()
        negated = self.sees("not") and self.tokens[self.at + 1].kind == "in"
        if negated:
            self.take()
        elif not self.sees(*COMPARISONS):
            return left
        sign = self.take().kind
        whole = Binary(left.place, sign, left, self.span())
        if self.sees(*COMPARISONS, "not"):
            raise ProgramError(self.place, "comparisons do not chain")
        return Unary(left.place, "not", whole) if negated else whole

    def span(self):
        return self.chain([".."], self.sum)

    def sum(self):
        return self.chain(["+", "-"], self.product)

    def product(self):
        return self.chain(["*", "/", "%"], self.signed)

    def signed(self):
        if not self.sees("-"):
            return self.postfix()
        place = self.take().place
        return Unary(place, "-", self.signed())

    def postfix(self):
        value = self.primary()
        while True:
            if self.sees("("):
                value = Call(value.place, value, self.arguments())
            elif self.accept("["):
                value = Index(value.place, value, self.expression())
                self.expect("]")
            elif self.accept("."):
                name = self.expect("name")
                value = FieldOf(name.place, value, name.value)
            else:
                return value

    def arguments(self):
        self.expect("(")
        arguments = []
        while not self.sees(")"):
            name, place = None, self.place
            if self.sees("name") and self.tokens[self.at + 1].kind == ":":
                name = self.take().value
                self.take()
            elif arguments and arguments[-1].name is not None:
                raise ProgramError(place, "an argument by position stands behind a named one")
            arguments.append(Argument(name, self.expression()))
            if not self.accept(","):
                break
        self.expect(")")
        return arguments

    def primary(self):
        token = self.take()
        if token.kind in ("int", "float", "string"):
            return Literal(token.place, token.value)
        if token.kind in CONSTANTS:
            return Literal(token.place, CONSTANTS[token.kind])
        if token.kind == "name":
            return Name(token.place, token.value)
        if token.kind == "fun":
            return self.function(token.place)
        if token.kind == "(":
            value = self.expression()
            self.expect(")")
            return value
        if token.kind == "[":
            return self.list_display(token.place)
        raise ProgramError(token.place, f"expected an expression, found {token.value!r}")

    def list_display(self, place):
        items = []
        while not self.sees("]"):
            items.append(self.expression())
            if len(items) == 1 and self.sees("for"):
                return self.comprehension(place, items[0])
            if not self.accept(","):
                break
        self.expect("]")
        return ListDisplay(place, items)

    def comprehension(self, place, element):
        clauses = []
        while self.accept("for"):
            names = self.names()
            self.expect("in")
            clauses.append(Clause(names, self.disjunction(), []))
            while self.accept("if"):
                clauses[-1].conditions.append(self.disjunction())
        self.expect("]")
        return Comprehension(place, element, clauses)


def parse(text, file):
    """The statements of a file. Raises ProgramError at the first thing that is no program."""
    return Parser(text, file).file()


def parse_expression(text, file):
    """A text that is one expression."""
    parser = Parser(text, file)
    value = parser.expression()
    parser.expect("end")
    return value
