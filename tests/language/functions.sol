area = fun(w, h) { return w * h; };
fun add(x, y = 10, z = x + y) { return [x, y, z]; }
print(area(2, 3), add(1), add(1, 2), add(1, 2, 3));          // prints: 6 [1, 10, 11] [1, 2, 3] [1, 2, 3]
print(add(1, z: 0), add(y: 5, x: 1), add(z: 1, x: 2));       // prints: [1, 10, 0] [1, 5, 6] [2, 10, 1]
fun counter(start) { step = 2; return fun(n) { return start + step * n; }; }
c, d = counter(10), counter(100);
print(c(1), d(2), counter(0)(5));                            // prints: 12 104 10
fun even(n) { if n == 0 then return true else return odd(n - 1); }
fun odd(n) { if n == 0 then return false else return even(n - 1); }
print(even(10), odd(7), even(3));                            // prints: true true false
fun twice(f, x) { return f(f(x)); }
print(twice(fun(x) { return x * 3; }, 2), twice(reverse, [1, 2]));  // prints: 18 [1, 2]
fun shadow() { area = 5; return area; }                      // its own variable
print(shadow(), area(1, 1));                                 // prints: 5 1
fun late() { return value; }                                 // looked up when it runs
value = 1;
print(late());                                               // prints: 1
value = 2;
print(late(), str(late), str(area), str(length));            // prints: 2 fun late fun area fun length
fun fact(n) { return if n <= 1 then 1 else n * fact(n - 1); }
print(fact(20));                                             // prints: 2432902008176640000
print((fun(x) { return x + 1; })(1), [add][0](0)[1]);        // prints: 2 10
fs = [fun() { return i; } for i in 0..2];
print([f() for f in fs]);                                    // prints: [2, 2, 2]
