from itertools import combinations

from z3 import Bool, Not, Or

LOGIC = "QF_BV"
DIVERSE = "incremental"


def model(solver, params):
    """A Bool for each square: queen[column][row]."""
    n = params["n"]
    queen = [tuple(Bool(f"q{column}.{row}") for row in range(n)) for column in range(n)]
    squares = [(column, row) for column in range(n) for row in range(n)]
    for column in range(n):
        solver.add(Or(queen[column]))
        solver.add(Or([queen[other][column] for other in range(n)]))
    for (a, b), (c, d) in combinations(squares, 2):
        if a == c or b == d or abs(a - c) == abs(b - d):
            solver.add(Or(Not(queen[a][b]), Not(queen[c][d])))
    return {"row": queen}
