// Each of n nurses works at most four of seven days, and the days together ask for more turns than that: no solution.
param n = 8;
days = 7;
need = (4 * n) / days + 1;
works = [[flip() for d in 1..days] for i in 1..n];
for w in works: assert(sum([cond(x, 1, 0) for x in w]) <= 4, "at most four days");
for d in 0..days - 1: assert(sum([cond(w[d], 1, 0) for w in works]) >= need, "enough nurses");
return need;
