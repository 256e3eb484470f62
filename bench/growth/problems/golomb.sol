// The shortest ruler with n marks on which all distances are different.
param n = 6;
marks = [0] + [range(1, n * n) for i in 2..n];
for i in 0..n - 2: assert(marks[i] < marks[i + 1]);
assert(distinct([marks[j] - marks[i] for i in 0..n - 2 for j in i + 1..n - 1]));
minimize(marks[n - 1]);
return marks[n - 1];
