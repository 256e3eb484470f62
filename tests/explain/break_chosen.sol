// Where a loop ends.
for i in 0..3 {
  if range(0, 1) == 1 then break;
  assert(i < 3);
}
assert(i == 3 and i < 2 + i % 3);  // conflict: i == 3; i < 2 + i % 3
