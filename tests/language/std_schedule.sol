import "std/schedule.sol";
a, b = task("a", 2, 0, 4), task("b", 1, 0, 4);
tasks = [a, b];
assert(cumulative(tasks, [1, 1], 1));
print(in_turn(tasks), end_of_all(tasks) <= 4);
print(in_each_window([true, false, false, true], 3, 1, 1), in_each_window([true, true, false], 2, 0, 1));
print(at_most_in_a_row([true, true, false, true], 2), at_most_in_a_row([true, true, false, true], 1));
shifts = roster(2, 3, 2);
assert(fair(shifts, 3) and shifts_of(shifts, 0) == 2);
return a.start, b.start, shifts;
// expect solutions: 12
// expect: [0, 2, [[0, 1], [0, 2]]]
// expect: [2, 0, [[0, 2], [0, 1]]]
