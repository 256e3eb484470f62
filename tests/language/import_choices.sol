import "parts/longer.sol"; import "parts/deeper/longer.sol";     // Files that choose under one name.
length = range(1, 4);
if length > 2 then more = 1 else more = 0;
assert(more == longer);
return length * 10 + width();
// expect: 11
// expect: 12
// expect: 21
// expect: 22
// expect: 33
// expect: 34
// expect: 43
// expect: 44
// expect: 11
// expect: 12
// expect: 21
// expect: 22
// expect: 33
// expect: 34
// expect: 43
// expect: 44
// expect choice: length = 4
// expect choice: longer.sol/length = 4
// expect choice: longer.sol#2/depth = 2
// expect choice: longer.sol#2/length = 5
