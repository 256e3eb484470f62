import "std/bin.sol";
into = pack([3, 2, 2, 1], 2, 4);
return into, loads_of([3, 2, 2, 1], into, 2);
// expect: [[0, 1, 1, 0], [4, 4]]
// expect: [[1, 0, 0, 1], [4, 4]]
