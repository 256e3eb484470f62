param n = 4;
fun subset(n) {
  if n == 0 then return [];
  if flip() then return [n] + subset(n - 1) else return subset(n - 1);
}
return subset(n);
