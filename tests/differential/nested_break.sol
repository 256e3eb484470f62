n = 0;
for i in 0..2 {
  for j in 0..2 {
    if flip() { break; }
    n += 1;
    if n == 3 { continue; }
    n += 2;
  }
  if n > 6 { break; }
  assert(n != 4);
}
return n;
