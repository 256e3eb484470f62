// pin: lid=true
lid = flip();  // conflict: lid is true, by --pin 'lid=true'
size = choose(["small", "large"]);
assert(size == "large" or not lid);  // conflict: size == "large" or not lid
assert(size == "small");  // conflict: size == "small"
