// Dominoes on 4 x 4 squares as an exact cover, where exactly one is said pair by pair.
// $ solve --all
// says: 36 solutions
// says: proved that there is no other
param n = 4;
places = [[y * n + x, y * n + x + 1] for y in 0..n - 1 for x in 0..n - 2] + [[y * n + x, y * n + n + x] for y in 0..n - 2 for x in 0..n - 1];
use = [flip() for p in places];
for square in 0..n * n - 1 {
  covered = [u for u, p in zip(use, places) if square in p];
  assert(any(covered) and all([not (a and b) for a, b in pairs(covered)]));
}
