// An office as a distribution: 32 things in a room, each anywhere and turned or not, and 546 wishes about them. Each that is not
// met weighs exp(-10): nothing stands in anything else, all stand inside, and chairs and sofas stand at their tables.
groups = 3;
most = 39;            // the last place, of both coordinates
weight = 10;

record Thing(x, y, w, d);
fun thing(long, short) {
  x, y, turned = range(0, most), range(0, most), flip();
  return Thing(x, y, cond(turned, short, long), cond(turned, long, short));
}

fun apart(a, b) {
  return a.x + a.w <= b.x or b.x + b.w <= a.x or a.y + a.d <= b.y or b.y + b.d <= a.y;
}
fun near(a, b, far) {
  return a.x <= b.x + b.w + far and b.x <= a.x + a.w + far and a.y <= b.y + b.d + far and b.y <= a.y + a.d + far;
}

wide, deep = range(20, 40), range(20, 40);
things = [];
for g in 1..groups {
  tables = [thing(6, 3) for i in 1..2];
  seats = [thing(2, 2) for i in 1..4] + [thing(6, 3) for i in 1..2];
  for i, seat in enumerate(seats): prefer(near(seat, tables[i % 2], 1), weight);
  things = things + tables + seats;
}
things = things + [thing(4, 1) for i in 1..8];         // shelves
for o in things: prefer(o.x + o.w <= wide and o.y + o.d <= deep, weight);
for a, b in pairs(things): prefer(apart(a, b), weight);
return wide, deep;
