// A ';' may be left out before '}' and 'else', after a function's '}', and at the end of the file.
f = fun(x) { return x }
fun g(x) { if x then return 1 else return 2 }
h = fun() { y = 1; return y };
if true { a = 1 } else { a = 2 }
for i in 0..1 { a += i }
assert(f(g(true)) == h());
return a + g(false)
// expect: 4
