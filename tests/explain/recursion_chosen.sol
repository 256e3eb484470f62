// Every depth that could be chosen.
// by solvers: an n below zero is a mistake, since down() does not end
fun down(n) {
  if n == 0 then return 0;
  return 1 + down(n - 1);
}
depth = down(range(0, 5));  // conflict: range is at least 0; range is at most 5
assert(depth > 2 and depth % 3 == 2 and depth != 5);  // conflict: depth > 2; depth % 3 == 2; depth != 5
