// Sides of different shape, with variables that only one of them assigns.
n = range(0, 2);
kind = "none";
if n == 1 then kind = [1];
else if n == 2 { kind = 2; size = 7; }
text = if n == 0 then "zero" else n;
if n == 2 then text = size;
return [kind, text];
// expect: ["none", "zero"]
// expect: [[1], 1]
// expect: [2, 7]
