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

for p in level: place("platform", at: [p.x, 0, p.y], size: [p.w, 2, 0.5], color: "green");
output {
  for p, coin in zip(level, coins) {
    if coin then place("sphere", at: [p.x + p.w / 2.0 - 0.25, 0.75, p.y + 0.8], size: [0.5, 0.5, 0.5], color: "yellow");
  }
  end = last(level);
  place("flag", at: [end.x, 0.9, end.y + 0.5], size: [0.1, 0.1, 2], color: "red");
}
