// A level of platforms and walkways: each platform is joined to the next by a walkway, the others are well away from it,
// and every second platform lies at a given point.
import "std/layout.sol";

param platforms = 5;
param gap = 3;       // between platforms
param beside = 1;    // between a walkway and what it does not join

most = 8 * platforms;

fun make_platform() {
  w, d = range(3, 8), range(3, 8);
  x, y = range(0, most), range(0, most);
  return Rect(x, y, w, d);
}

// A walkway, 2 wide, from the edge of one to the edge of the other, as long as it takes.
fun make_walkway(a, b) {
  along_x = flip();
  length = range(2, 8);
  x, y = range(0, most), range(0, most);
  way = Rect(x, y, cond(along_x, length, 2), cond(along_x, 2, length));
  assert(if along_x then leads_x(a, way, b) or leads_x(b, way, a) else leads_y(a, way, b) or leads_y(b, way, a));
  return way;
}

fun leads_x(a, way, b) {
  return x2(a) == x1(way) and x2(way) == x1(b) and within_y(way, a) and within_y(way, b);
}

fun leads_y(a, way, b) {
  return y2(a) == y1(way) and y2(way) == y1(b) and within_x(way, a) and within_x(way, b);
}

fun within_x(a, b) { return x1(b) <= x1(a) and x2(a) <= x2(b); }
fun within_y(a, b) { return y1(b) <= y1(a) and y2(a) <= y2(b); }

all_platforms = [make_platform() for i in 1..platforms];
walkways = [make_walkway(all_platforms[i], all_platforms[i + 1]) for i in 0..platforms - 2];

assert(all_apart(all_platforms, gap));
assert(all_apart(walkways, beside));
for i in 0..platforms - 2 {
  for j in 0..platforms - 1 {
    if j < i or j > i + 1 then assert(apart(walkways[i], all_platforms[j], beside));
  }
}
for i in 0..platforms - 1 {
  if i % 2 == 0 then assert(inside(Rect(3 + 6 * i, 8 + 5 * (i % 4), 0, 0), all_platforms[i]), "it is at its point");
}
