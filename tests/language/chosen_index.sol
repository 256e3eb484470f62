i = range(0, 2);
xs = [10, "b", [3]];
grid = [[1, 2, 3], [4, 5, 6]];
return [xs[i], grid[i % 2][i], "x"];
// expect: [10, 1, "x"]
// expect: ["b", 5, "x"]
// expect: [[3], 3, "x"]
