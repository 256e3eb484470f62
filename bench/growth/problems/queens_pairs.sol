// n queens, pair by pair, as one writes it first.
param n = 25;
row = [range(0, n - 1) for i in 1..n];
for i in 0..n - 2 {
  for j in i + 1..n - 1 {
    assert(row[i] != row[j] and row[i] - row[j] != i - j and row[i] - row[j] != j - i);
  }
}
return row;
