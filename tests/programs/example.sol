F = fun(x) {
    if (mod(x,2) == 0) then return 10 else return -5;
}
n = F(range(0,4)) + F(range(0,1));
assert(n > 0);
return n;
