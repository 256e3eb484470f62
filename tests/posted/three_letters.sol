// Of 17,576 words of three letters one is this.
// $ solve --all
// says: solution 1: "owl"
// says: 1 solution
// says: proved that there is no other
letters = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
           "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z"];
word = choose(letters) + choose(letters) + choose(letters);
assert(word == "owl");
return word;
