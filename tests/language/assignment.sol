a, b = 1, 2;
a, b = b, a;
print(a, b);                   // prints: 2 1
fun two() { return 5, 6; }
x, y = two();
z = two();
print(x, y, z);                // prints: 5 6 [5, 6]
xs = [0, 0, 0];
xs[0], xs[2] = 7, 8;
print(xs);                     // prints: [7, 0, 8]
i = 0;
i, xs[i] = 1, 9;               // targets are assigned from left to right
print(i, xs);                  // prints: 1 [7, 9, 8]
record P(x, y);
p = P(1, [2, 3]);
p.x, p.y[1] = p.y[1], p.x;
print(p);                      // prints: P(x: 3, y: [2, 1])
xs[0] += 10;
p.y += [0];
print(xs[0], p.y);             // prints: 17 [2, 1, 0]
s = "a"; s += "b";
print(s);                      // prints: ab
{ inside = 1; }                // blocks make no scope
print(inside);                 // prints: 1
q, r = choose([[1, 2], [3, 4]]);
return q * 10 + r;
// expect: 12
// expect: 34
