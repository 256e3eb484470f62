// A name on the right of `and` and `or` is read where control comes to it, whatever it holds on other paths.
a = flip();
b = flip();
n = range(0, 1);
both = a and b;
either = a or b;
mixed = if n == 0 then b else n;  // a bool on one path, an int on the other
late = n == 0 and mixed;
other = n == 1 or mixed;
if a {
  set = b;
}
seen = a and set;
if a { both = both and either; }
assert(both == seen and (n == 0 or b));
return [a, b, n, both, either, late, other];
// expect: [false, false, 0, false, false, false, false]
// expect: [false, true, 0, false, true, true, true]
// expect: [false, true, 1, false, true, false, true]
// expect: [true, false, 0, false, true, false, false]
// expect: [true, true, 0, true, true, true, true]
// expect: [true, true, 1, true, true, false, true]
