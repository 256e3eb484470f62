import sys
from z3 import Int, Solver

n = int(sys.argv[1])
solver = Solver()
xs = [Int(f"x{i}") for i in range(n)]
for x in xs:
    solver.add(x >= 0, x <= 9)
for a, b in zip(xs, xs[1:]):
    solver.add(a != b)
print(solver.check())
