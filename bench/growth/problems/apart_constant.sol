// n boxes at constant places, none of which overlaps another. Nothing is chosen: this is what the library's rule costs.
import "std/layout.sol";
param n = 1000;
boxes = [Rect(3 * (i % 100), 3 * (i / 100), 2, 2) for i in 0..n - 1];
assert(all_apart(boxes));
return n;
