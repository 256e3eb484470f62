// A recursion that ends since its argument becomes smaller, as nothing but the remainders say.
fun steps(p) {
  if p <= 0 then return 0;
  return 1 + steps(p % range(0, 4) - 1);
}
return [steps(5), steps(5)];
// expect solutions: 49
// expect: [1, 1]
// expect: [1, 2]
// expect: [2, 1]
// expect: [2, 2]
