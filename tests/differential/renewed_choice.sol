n = 1;
if flip() {
  if flip() { n = 5; for i in 0..2 { n -= 1; } }
}
x = range(0, n);
return x;
