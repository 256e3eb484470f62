// A word of n chosen letters, which must not be one word.
param n = 3;
letters = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
           "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z"];
word = "";
for i in 1..n { word = word + choose(letters); }
assert(word != "abc");
return word;
