import "std/bin.sol";                // What functions of the library make by each other is named after what it is for.
bins = pack_into_few([1, 2], 3);
return bins;
// expect solutions: 5
// expect: [0, 0]
// expect: [0, 0]
// expect: [0, 1]
// expect: [1, 0]
// expect: [1, 1]
// expect choice: bins/used = 2
// expect choice: bins/into/into[1] = 1
