// Whichever furniture is chosen, its depth leaves no way through.
depth = choose([2, 3]);
kind = if depth == 2 then "bench" else "table";
way = 5 - 2 * depth;
assert(way >= 2, "a way between the rows");  // conflict: way >= 2
if kind == "bench" then assert(depth > 1);
