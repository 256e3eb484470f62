a = [[1, 2], [3]];
b = a;
b[0][0] = 9;
inner = a[1];
inner[0] = 7;
print(a, b, inner);            // prints: [[1, 2], [3]] [[9, 2], [3]] [7]
record P(x, list);
p = P(1, [1]);
q = p;
q.x = 2;
q.list[0] = 5;
q.list += [6];
print(p, q);                   // prints: P(x: 1, list: [1]) P(x: 2, list: [5, 6])
fun change(xs) { xs[0] = 100; return xs; }
xs = [1, 2];
print(change(xs), xs);         // prints: [100, 2] [1, 2]
many = [xs, xs];
many[0][1] = 50;
print(many, xs);               // prints: [[1, 50], [1, 2]] [1, 2]
for x in many { x[0] = 0; }
print(many);                   // prints: [[1, 50], [1, 2]]
c = many;
many[1] = many;                // a copy of itself, no circle
print(many, c);                // prints: [[1, 50], [[1, 50], [1, 2]]] [[1, 50], [1, 2]]
keep = fun() { return xs; };
xs[0] = 33;
print(keep()[0]);              // prints: 33
