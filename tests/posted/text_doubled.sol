// A text of one choice that is joined to itself again and again.
// $ solve --all
// says: solution 1: "a
// says: "bbbbbbbbbbbbbbbb"
// says: "b!b!b!b!b!b!b!b!b!b!b!b!b!b!b!b!"
// says: 4 solutions
// says: proved that there is no other
s = choose(["a", "b"]);
if flip() { s = s + "!"; }
for i in 1..4 { s = s + s; }
return s;
