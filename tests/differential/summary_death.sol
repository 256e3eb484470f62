v = range(0, 2);
fun f(a) { assert(a != v); if a > v { return a / (v - 1); } return range(0, v); }
if flip() { v = v + 1; x = f(1); } else { if flip() { x = f(1); } else { v = 0; x = f(1); } }
return [v, x];
