n, steps = 27, 0;
while n != 1 {
  if n % 2 == 0 then n /= 2 else n = 3 * n + 1;
  steps += 1;
}
print(steps);                                // prints: 111
while true { n += 1; if n > 5 { break } }
while (n > 0) { n -= 2; if n % 4 == 0 { continue; } steps += 1; }
print(n, steps);                             // prints: 0 112
