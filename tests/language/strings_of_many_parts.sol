// only the solver: there are 2^300 executions
word = "";
other = "";
wanted = "";
for i in 1..100 {
  word = word + choose(["a", "b"]);
  other = choose(["a", "b"]) + other;
  wanted = wanted + choose([["a", "b"], ["b", "a"]])[i % 2];
}
assert(word == other);
assert(word != "ab");
assert(length(word) == 100);
assert(all([word != w for w in ["", "b", wanted + "a"]]));
same = "";
for i in 1..25 { same = same + "aaba"; }
assert(word == same and wanted == other);
s = choose(["a", "b"]);
if flip() { s = s + "!"; }
for i in 1..4 { s = s + s; }
assert(s != same and length(s) > 20);
return word == same, length(s);
// expect: [true, 32]
// expect: [true, 32]
