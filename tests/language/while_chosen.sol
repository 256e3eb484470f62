n = range(1, 8);
turns = 0;
while n > 1 {
  n = n / 2;
  turns += 1;
  if turns == 2 and flip() { break; }
}
return [n, turns];
// expect: [1, 0]
// expect: [1, 1]
// expect: [1, 1]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [1, 2]
// expect: [2, 2]
// expect: [1, 3]
