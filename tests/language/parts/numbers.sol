one = 1;
fun length(x) { return "not the builtin"; }
