// What takes part stands in another file.
import "parts/limits.sol";
w = range(1, 9);
checked(w);
assert(w > 5, "wide");  // conflict: w > 5
