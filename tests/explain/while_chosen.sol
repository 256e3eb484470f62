// A loop of chosen length.
n = range(0, 4);
sum = 0;
while n > 0 {
  sum += n;
  n -= 1;
}
assert(sum == 5);  // conflict: sum == 5
