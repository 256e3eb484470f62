// Choices in defaults of parameters.
fun desk(w = range(2, 4)) { return w; }  // conflict: desk/w is at most 4; desk#2/w is at most 4
total = desk() + desk();
assert(total == 9);  // conflict: total == 9
