// What cannot be seen is not gone through.
// $ solve --all --distinct result
// says: 4 solutions
// says: proved that there is no other
lamp = range(0, 3);
cable = [range(0, 9) for i in 1..8];
assert(sum(cable) == 30 + lamp);
place("lamp", at: [lamp, 0]);
