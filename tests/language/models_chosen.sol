// A chosen model has a chosen size.
// expect: ["sofa", 4, 2]
// expect: ["table", 3, 2]
kind = choose(["sofa", "chair", "table"]);
w, d, h = size_of(kind, 0.5);
assert(w * d >= 4 and has_front(kind) == (kind == "sofa"));
return [kind, w, d];
