// pin: size=0
size = choose(["small", "large"]);  // conflict: size is 0, by --pin 'size=0'
assert(size == "large");  // conflict: size == "large"
