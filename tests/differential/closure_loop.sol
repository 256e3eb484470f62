fs = [];
for i in 0..range(0, 3) { fs += [fun() { return i; }]; if i == range(0, 2) { break; } }
return [f() for f in fs];
