// Lists whose length is chosen, made into pairs of pairs a chosen number of times.
// $ solve --all
// says: 42 solutions
// says: proved that there is no other
n = range(1, 3);
c = [range(0, 1) for k in 1..n];
w = range(0, 2);
while w > 0 {
  w -= 1;
  c = [a for k, l in pairs(c) for a, b in pairs(c)];
}
return length(c);
