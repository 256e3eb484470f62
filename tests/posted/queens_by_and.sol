// $ solve --all
// says: 92 solutions
// says: proved that there is no other
param n = 8;
q = [range(0, n - 1) for i in 1..n];
for i in 0..n - 1 { for j in i + 1..n - 1: assert(q[i] != q[j] and abs(q[i] - q[j]) != j - i); }
return q;
