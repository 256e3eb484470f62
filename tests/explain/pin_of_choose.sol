// pin: size=0
size = choose(["small", "large"]);  // conflict: size is "small", by --pin 'size=0'
assert(size == "large");  // conflict: size == "large"
