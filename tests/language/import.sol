import "parts/shapes.sol";
import "parts/numbers.sol";     // its top level runs once
import "parts/numbers.sol";
s = Square();
s.side += one;
return [area(s), hidden[0], length([])];
// set: unit_size = 4
// expect: [25, 0, "not the builtin"]
// expect: [25, 1, "not the builtin"]
// expect choice: shapes.sol/hidden = 1
