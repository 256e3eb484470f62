// A string that choices decide about is a list of parts, until something looks at what it says.
parts = ["a", "bc"];
word = choose(parts) + choose(parts);
if flip() { word = word + "!"; }
word = word + word;
assert(word != "aaaa");
assert(length(word) < 9);
other = choose(["abc", "x"]) + choose(["!", ""]);
assert(other + other == word);                  // sizes that differ
return [word, str(other), other == word, word == "abc!abc!"];
// expect: ["abcabc", "abc", false, false]
// expect: ["abc!abc!", "abc!", false, true]
