// The proof that there is no solution is quick, the reason is not: what is known of it after some seconds is shown.
// $ solve
// status: 1
// says: cannot hold
// says: the list must have such an element
sizes = choose([[2, -2, 2], [1]]);
one = range(1, 1);
n = range(0, 2);
marks = [range(0, 1) for k in 1..one % 4];
for i in 1..one % 2 {
  lids = [if flip() then flip() else false for k, m in zip([one, range(1, 1), i], [[-2, -2, 0], [1, 2]][i % -4])];
}
for i in [nil for k, m in zip(marks, marks)] {
  if n % min(2, max(0, n)) != n + one { sizes = [k for j in 0..1 for k, m in pairs(sizes)]; }
  assert(n <= one);
}
sizes[min(2, max(0, n))] -= max(marks);
assert(sizes[3] == 5);
