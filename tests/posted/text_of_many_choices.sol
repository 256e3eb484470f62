// $ solve
// says: s[199]
// says: 1 solution
s = "";
for i in 1..200 { s = s + choose(["a", "b"]); }
assert(s != "ab");
return length(s);
