x = range(0, 5);
n = 0;
while n < 4 { n += 1; if x == n { continue; } assert(x != n + 1); if x > 3 { break; } }
return [x, n];
