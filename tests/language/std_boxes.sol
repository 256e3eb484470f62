import "std/boxes.sol";
low = Box("low", 0, 0, 0, 2, 1, 1);
high = Box("high", range(0, 2), 0, range(0, 2), 1, 1, 1, turn: 1);
site = Box("site", 0, 0, 0, 3, 1, 3);
assert(inside3(high, site) and apart3(low, high) and all_apart3([low, high]));
assert(supported(high, [low]));
return [high.x, high.z], on_top(high, low), touches_top(high, low), z2(high);
// expect: [[2, 0], false, false, 1]
// expect: [[0, 1], true, true, 2]
// expect: [[1, 1], true, true, 2]
