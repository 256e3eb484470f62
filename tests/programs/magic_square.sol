cells = [range(1, 9) for i in 1..9];
assert(distinct(cells));
lines = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [0, 3, 6], [1, 4, 7], [2, 5, 8], [0, 4, 8], [2, 4, 6]];
for line in lines: assert(sum([cells[i] for i in line]) == 15);
return cells;
