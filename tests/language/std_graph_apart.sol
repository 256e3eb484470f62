// only the solver: a distance has as many values as there are cells
// Cells that do not hang together, paths and trees: each comes once.
import "std/graph.sol";
on = [flip() for i in 1..4];
assert(not connected(graph_of(4, [[0, 1], [1, 2], [2, 3]]), on));
ways = path(grid_graph(2, 2), 0, 3);
above = tree(graph_of(3, [[0, 1], [1, 2], [0, 2]]), 1);
return on, ways, above;
// expect solutions: 30
// expect: [[true, false, true, false], [true, true, false, true], [1, 1, 1]]
// expect: [[true, false, true, true], [true, false, true, true], [2, 1, 1]]
