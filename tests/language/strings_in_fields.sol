x = range(8, 11);                           // The fields of a format fill up texts of chosen values, too.
b = flip();
assert(format("{:3}", x) != " 10");
assert(length(format("{:<6}|", b)) == 7);
assert(format("{:.1}", x) in ["8.0", "11.0"]);
return format("{:3}|{:<6}|{:5.1}", x, b, x);
// expect: "  8|false |  8.0"
// expect: "  8|true  |  8.0"
// expect: " 11|false | 11.0"
// expect: " 11|true  | 11.0"
