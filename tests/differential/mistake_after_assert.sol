x = range(0, 3);
for i in 0..3 { assert(x != i or i < 2); if x == i { y = i; } }
return y;
