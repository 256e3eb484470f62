total = 0;
for x in [1, 2, 3]: total += x;
for i in 0..3 { total = total * 10 + i; }
print(total);                                // prints: 60123
for a, b in [[1, 2], [3, 4]] { print(a * b); }
// prints: 2
// prints: 12
for x in [] { print("never"); }
for i in 5..4 { print("never"); }
for i in 1..3 { for j in i..3 { if j == 2 { continue; } if i == 3 { break; } print(i, j); } }
// prints: 1 1
// prints: 1 3
// prints: 2 3
print(i, j, x);                              // prints: 3 3 3
xs = [1, 2];
for x in xs { xs += [x]; }                   // the loop runs over the list as it was
print(xs);                                   // prints: [1, 2, 1, 2]
