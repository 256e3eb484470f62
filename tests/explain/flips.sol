// Bools.
lid, handle = flip(), flip();
assert(lid or handle);  // conflict: lid or handle
assert(not lid, "no lid");  // conflict: not lid
assert(not handle, "no handle");  // conflict: not handle
