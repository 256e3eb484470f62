// A hall of odd length on a grid of even lengths.
grid = 2;
halls = [[range(0, 4, grid), range(2, 4, grid)] for i in 1..2];
// conflict: halls[0] is one of the steps of its range; halls[1] is one of the steps of its range
// conflict: halls#2[0] is one of the steps of its range
for x, length in halls: assert(x + length <= 7);
assert(halls[0][0] + halls[0][1] == halls[1][0] + 3, "the second hall begins inside of the first");
// conflict: halls[0][0] + halls[0][1] == halls[1][0] + 3
