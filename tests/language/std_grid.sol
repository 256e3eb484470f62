import "std/grid.sol";
cells = grid_of(3, 2, fun(x, y) { return 10 * y + x; });
print(cells, flat(cells), columns(cells));  // prints: [[0, 1, 2], [10, 11, 12]] [0, 1, 2, 10, 11, 12] [[0, 10], [1, 11], [2, 12]]
print(beside(cells, 0, 0), beside(cells, 1, 1), beside(cells, 0, 0, corners: true));  // prints: [1, 10] [1, 10, 12] [1, 10, 11]
print(window(cells, 1, 0, 2, 2), length(windows(cells, 2, 1)), mirrored(cells));  // prints: [[1, 2], [11, 12]] 4 [[2, 1, 0], [12, 11, 10]]
print(lines([[1, 2], [3, 4]]), symmetric([[1, 1]]), symmetric([[1, 2]]), grid_width(cells), grid_height(cells));  // prints: [[1, 2], [3, 4], [1, 3], [2, 4], [1, 4], [2, 3]] true false 3 2
print([c for x, y, c in each_cell(cells) if x > y], in_rows(flat(cells), 3) == cells, in_rows([], 2), in_rows([1, 2, 3, 4], 1));  // prints: [1, 2, 12] true [] [[1], [2], [3], [4]]
print([turn_to(cells, 1, 0, wanted) for wanted in [1, 2, 11, 0, 10]], turn_to(cells, 1, 1, 1), turn_to([["a", "a"]], 0, 0, "b"));  // prints: [nil, 1, 2, 3, nil] 0 nil
left = fun(x, y) { return x in 0..1 and y == 0; };
print(rounded_cell(0, 0, left));  // prints: [[1, 1], [0.45, 1], [0.13, 0.87], [0, 0.55], [0, 0.45], [0.13, 0.13], [0.45, 0], [1, 0]]
