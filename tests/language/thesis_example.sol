// Section 4.2.2.
F = fun(x) {
    if (mod(x,2) == 0) then return 10 else return -5;
}
n = F(range(0,4)) + F(range(0,1));
assert(n > 0);
return n;
// expect solutions: 8
// expect: 5
// expect: 20
