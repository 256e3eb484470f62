// Sections 4.1.1 and 4.1.2: accessors of edges, the facing constraint, and a table chosen for all chairs.
record Obj(kind, width, height, rot, x, y);
x1 = fun(o) { return o.x; }
x2 = fun(o) { return o.x + o.width; }
y1 = fun(o) { return o.y; }
y2 = fun(o) { return o.y + o.height; }
facing = fun(c, t) {
  assert(c.rot != 0 or y2(c) == y1(t));
  assert(c.rot != 2 or y1(c) == y2(t));
  assert(c.rot % 2 == 0);
  assert(x1(t) <= x1(c) and x2(c) <= x2(t));
}
tables = [Obj("table", 2, 1, 0, 0, 1), Obj("table", 2, 1, 0, 4, 1)];
chairs = [Obj("chair", 1, 1, range(0, 3), range(0, 5), range(0, 2)) for i in 1..2];
chair_table_facing = fun(chairs) {
    t = tables[range(0,1)];
    for c in chairs:
        facing(c, t);
}
chair_table_facing(chairs);
assert(distinct([[c.x, c.y] for c in chairs]));
return length(chairs);
// expect solutions: 24
