record Point(a, b, c = 1);
v0 = flip();
v1 = flip();
v2 = (if distinct([0]) then [3, 0] else []);
fun f3(q4, q5, q6 = v2) {
  if null(v2) { return q4; }
  return (if null(choose([q5, q6])) then -1 else range(q4 % 3, 2, 2));
}
v7 = Point(2, [3]);
fun f8(q9) {
  return v2;
}
assert(true);
v10 = ((str(4) + "bc") + str(f3(q4: 4, q5: v2)));
if distinct(v2) {
  v10 = v10;
  for i11 in (if all([u12 < 2 for u12 in v2]) then [4, -1, 4] else [-1, 0]) {
    assert(v0 or (range(3 % 3, 2) > abs(4)));
    k13 = v7.a % 4;
    while k13 > 0 and (v1 or v1) {
      k13 -= 1;
      i11 += i11;
      v7.a = i11;
      v2 = (if true then [i11 for u14 in v2 if v0 for u15 in v2 if v0] else choose([v2, v2]));
    }
  }
}
fun f16(q17) {
  return Point(f3(q17, v2), v2).c;
}
assert((-1 > (2 + 0)));
fun f18(q19, q20, q21 = [3 for u22 in v2 if v0]) {
  if flip() {
    v23 = (((if v1 then "a" else v10) + v10) + str(f16(q19)));
  }
  return (min(q19, q19) - min(-2, q20));
}
v7.c = f16((3 - 2));
assert((0 + 1 * (if v0 then 1 else 0) + 2 * (if v1 then 1 else 0) + 3 * (sum(v2) + length(v2)) + 4 * (v7.a + v7.c + sum(v7.b))) % 4 != 2);
return [v0, v1, v2, v7, v10];
