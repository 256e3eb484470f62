// Each level decides whether there is another; asserts bound it.
fun chain(n) {
  assert(n <= 4);
  if flip() then return n;
  return chain(n + 1);
}
return chain(0);
// expect: 0
// expect: 1
// expect: 2
// expect: 3
// expect: 4
// expect choice: chain/chain/chain/flip = true
