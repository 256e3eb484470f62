// Turns, breaks and continues that depend on choices.
n = range(0, 3);
skip = range(1, 2);
sum = 0;
seen = [];
for i in 1..n {
  if i == skip { continue; }
  sum += i;
  seen += [i];
  if sum > 3 { break; }
}
return [n, skip, sum, seen];
// expect: [0, 1, 0, []]
// expect: [0, 2, 0, []]
// expect: [1, 1, 0, []]
// expect: [1, 2, 1, [1]]
// expect: [2, 1, 2, [2]]
// expect: [2, 2, 1, [1]]
// expect: [3, 1, 5, [2, 3]]
// expect: [3, 2, 4, [1, 3]]
