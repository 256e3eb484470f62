import sys
from z3 import Distinct, Int, Solver

n = int(sys.argv[1])
solver = Solver()
xs = [Int(f"x{i}") for i in range(n)]
for x in xs:
    solver.add(x >= 1, x <= n - 1)
solver.add(Distinct(xs))
print(solver.check())
