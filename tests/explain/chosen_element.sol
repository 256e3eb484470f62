// No element of the list will do.
size = choose(["small", "medium", "large"]);
assert(size == "huge", "it is huge");  // conflict: size == "huge"
