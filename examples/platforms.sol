// Shows: a level of platforms, each of which can be jumped to from the one before; coins, and gaps to fall into.
param platforms = 8;
param jump = 3;      // how far
param up = 2;        // and how high

record Platform(x, y, w);
fun next(before) {
  return Platform(before.x + before.w + range(1, jump), range(0, 6), range(1, 3));
}
level = [Platform(0, 1, 2)];
for i in 2..platforms {
  p = next(last(level));
  before = last(level);
  assert(p.y - before.y <= up, "not too high");
  assert(p.y != before.y, "never flat");
  assert(p.x - before.x - before.w < jump or p.y <= before.y, "the longest jumps go down");
  level = level + [p];
}
rises = [b.y > a.y for a, b in zip(level, cdr(level))];
assert(count(rises) in 3..platforms - 3, "up and down");
assert(max(level, key: fun(p) { return p.y; }).y == 6, "somewhere at the top");
coins = [flip() for p in level];
assert(count(coins) == 3 and not first(coins));
for a, b in zip(coins, cdr(coins)): assert(not (a and b), "coins are not beside each other");

output {
  for i, p in enumerate(level) {
    place("floating_platform", at: [p.x, 0, p.y], size: [p.w, 1, 0.5]);
    if i % 3 == 1 then place("cloud", at: [p.x, 2.5, 7.4 + i % 2], scale: 0.9);
  }
  for x in 0..last(level).x + last(level).w: place("gap_tile", at: [x, 0, -1.3]);
  for x, size in [[0, 1.6], [9, 1.1], [17, 1.7], [24, 1.2]] {
    if x < last(level).x then place("hill", at: [x, 1.6, -1.3], scale: size);
  }
  place("hero", at: [0.7, 0.3, 1.5], turn: 1);
  for p, coin in zip(level, coins) {
    if coin then place("coin", at: [p.x + p.w / 2.0 - 0.3, 0.45, p.y + 0.8]);
  }
  end = last(level);
  place("goal_flag", at: [end.x + end.w - 0.9, 0.2, end.y + 0.5]);
}
