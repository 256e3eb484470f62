// A program without a return, or a return without a value, has the value nil.
x = flip();
if x { return; }
fun f() { }
assert(f() == nil);
// expect: nil
// expect: nil
