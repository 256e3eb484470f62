s, m = range(1, 9), range(1, 9);
e, n, d, o, r, y = [range(0, 9) for i in 1..6];
assert(distinct([s, e, n, d, m, o, r, y]));
fun number(digits) {
  value = 0;
  for digit in digits: value = 10 * value + digit;
  return value;
}
assert(number([s, e, n, d]) + number([m, o, r, e]) == number([m, o, n, e, y]));
return number([s, e, n, d]), number([m, o, r, e]);
