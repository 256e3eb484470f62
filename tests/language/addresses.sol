// The readable forms of addresses: calls, turns, what a choice is for, and counts where a name comes twice.
record Obj(kind, x);
fun make_table() {
  rot = range(4, 4);
  x, y = range(0, 0), range(3, 3);
  t = Obj("table", range(1, 1));
  t.x = range(2, 2);
  return t;
}
fun room(n) {
  for i in 1..2 { t = make_table(); }
  return range(n, n) == n;
}
for wing in 0..1 { for floor in 0..0 { ok = room(5) and room(6); } }
a = flip() or flip();
b = [range(7, 7), range(8, 8)];
area = fun() { return range(9, 9); };
area();
area();
(fun() { return range(10, 10); })();
fun pick() { kind = choose([1]); return range(11, 11) + kind; }
c = max(range(12, 12), pick());
d = [range(i, i) for i in 13..14 if range(15, 15) > i];
place("chair", at: [range(16, 16), 0], size: [1, 1]);
// expect solutions: 3
// expect choice: room[0][0]/make_table[0]/rot = 4
// expect choice: room[1][0]/make_table[1]/rot = 4
// expect choice: room#2[1][0]/make_table[0]/rot = 4
// expect choice: room[0][0]/make_table[1]/x = 0
// expect choice: room[0][0]/make_table[1]/y = 3
// expect choice: room[0][0]/make_table[1]/t.x = 1
// expect choice: room[0][0]/make_table[1]/t.x#2 = 2
// expect choice: room[0][0]/range = 5
// expect choice: a = false
// expect choice: a#2 = true
// expect choice: b = 7
// expect choice: b#2 = 8
// expect choice: area/range = 9
// expect choice: area#2/range = 9
// expect choice: call/range = 10
// expect choice: range = 12
// expect choice: pick/kind = 0
// expect choice: pick/range = 11
// expect choice: d#2[0] = 13
// expect choice: d#2[1] = 14
// expect choice: d[1] = 15
// expect choice: at = 16
