// A river from corner to corner that never touches itself.
param n = 8;
steps = 4 * n + 2 * (n / 4);
px = [range(0, n - 1) for i in 0..steps];
py = [range(0, n - 1) for i in 0..steps];
assert(px[0] == 0 and py[0] == 0 and px[steps] == n - 1 and py[steps] == n - 1);
for i in 0..steps - 1 { assert(abs(px[i + 1] - px[i]) + abs(py[i + 1] - py[i]) == 1); }
for i in 0..steps { for j in 0..i - 2 { assert(abs(px[i] - px[j]) + abs(py[i] - py[j]) > 1); } }
return n;
