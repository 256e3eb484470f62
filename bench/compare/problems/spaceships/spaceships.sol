// Spaceships of bricks: each structure, of one of several types, sits on an earlier one or under it, and none intersects
// another.
param structures = 6;
param reach = 20;

record Box(x, y, z, w, d, h);

fun hull(x, y, z) { return [Box(x, y, z, 6, 4, 2)]; }
fun wing(x, y, z) { return [Box(x, y, z, 2, 10, 1)]; }
fun keel(x, y, z) { return [Box(x, y, z, 8, 2, 1)]; }
fun engine(x, y, z) { return [Box(x, y, z, 4, 2, 2)]; }
fun tower(x, y, z) { return [Box(x, y, z, 2, 2, 3), Box(x - 1, y - 1, z + 3, 4, 4, 1)]; }
fun bracket(x, y, z) { return [Box(x, y, z, 2, 2, 2), Box(x + 2, y, z, 4, 2, 1)]; }

fun structure() {
  x = range(-reach, reach);
  y = range(-reach, reach);
  z = range(-reach, reach);
  type = choose([hull, wing, keel, engine, tower, bracket]);
  return type(x, y, z);
}

fun apart(a, b) {
  return a.x + a.w <= b.x or b.x + b.w <= a.x or a.y + a.d <= b.y or b.y + b.d <= a.y
      or a.z + a.h <= b.z or b.z + b.h <= a.z;
}

// One box sits on the other, with at least one stud in it.
fun connected(a, b) {
  return (a.z + a.h == b.z or b.z + b.h == a.z) and a.x < b.x + b.w and b.x < a.x + a.w and a.y < b.y + b.d
      and b.y < a.y + a.d;
}

ship = [hull(0, 0, 0)];
for i in 1..structures {
  next = structure();
  assert(any([connected(a, b) for a in next for other in ship for b in other]), "it holds to an earlier one");
  for other in ship {
    for a in next { for b in other: assert(apart(a, b), "none intersects another"); }
  }
  ship = ship + [next];
}
