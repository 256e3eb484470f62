// Texts of chosen values may be shown and returned; the engine refuses to look at them, rather than to guess.
x = range(0, 3);
s = str([x, "a"]);
place("box", at: [0, 0], name: s + "!");
if x == 2 { s = "two"; }
print(s);
return [s, str(x), str(x) == "2", length(str(x * 5))];
