// Every solution prints what its own execution prints, symbols are known by then.
x = range(3, 4);
assert(x == 4);
print("x is", x, [x], str(x) + "!", x * 0.5);   // prints: x is 4 [4] 4! 2.0
