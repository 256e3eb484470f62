// A line of 100 magnets, each of which hates to point another way than its neighbour.
param n = 100;
param coupling = 10.0;
spin = [flip() for i in 1..n];
unequal = 0;
for i in 0..n - 2 {
  differs = spin[i] != spin[i + 1];
  factor(cond(differs, -coupling, 0.0));
  unequal += cond(differs, 1, 0);
}
return unequal;
