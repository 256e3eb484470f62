// Two files choose under one name; a pin names one of them.
// pin: width.sol/size=2
import "parts/width.sol";
inner = width();
size = range(1, 4);
assert(inner > 2);  // conflict: inner > 2
