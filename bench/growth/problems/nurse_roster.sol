// Shifts of n nurses for two weeks: enough of them in each shift, time to rest, and as many wishes as can be.
param n = 8;
days = 14;
off, early, late, night = 0, 1, 2, 3;
need = [0, n / 4, n / 4, n / 6];
shift = [[range(off, night) for d in 1..days] for i in 1..n];
for d in 0..days - 1 { for s in early..night: assert(sum([cond(row[d] == s, 1, 0) for row in shift]) >= need[s], "enough nurses"); }
for row in shift {
  for d in 0..days - 2: assert(row[d] <= row[d + 1] or row[d + 1] == off, "a rest before an earlier shift");
  for d in 0..days - 6: assert(contains([row[k] for k in d..d + 5], off), "at most five days in a row");
  assert(sum([cond(s != off, 1, 0) for s in row]) <= 10, "at most ten shifts");
  assert(sum([cond(s == night, 1, 0) for s in row]) <= 4, "at most four nights");
}
// Each wishes for four days off and two shifts, some of them more than others.
for i in 0..n - 1 {
  for k in 0..3: prefer(shift[i][(i * 5 + k * k * 3) % days] == off, 1 + (i * 7 + k * 3) % 5);
  for k in 0..1: prefer(shift[i][(i * 3 + k * 7 + 1) % days] == 1 + (i + k) % 3, 1 + (i + k) % 3);
}
return [sum([cond(s != off, 1, 0) for s in row]) for row in shift];
