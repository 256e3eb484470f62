record Circle(r);
record Box(w, h);
fun shape() { if flip() then return Circle(range(1, 2)) else return Box(1, range(1, 2)); }
fun area(s) { return if s == Circle(1) then 3 else if s == Circle(2) then 12 else s.w * s.h; }
s = shape();
return [s, area(s)];
// expect: [Circle(r: 1), 3]
// expect: [Circle(r: 2), 12]
// expect: [Box(w: 1, h: 1), 1]
// expect: [Box(w: 1, h: 2), 2]
// expect choice: shape/r = 1
// expect choice: shape/h = 2
