// only the solver: a distance has as many values as there are cells
// Every way to open five of six cells in two rows: which hang together, how far they are, what is reached.
import "std/graph.sol";
on = [flip() for i in 1..6];
assert(count(on) == 5);
graph = grid_graph(3, 2);
far = distances(graph, on, [i == 0 for i in 0..5]);
return connected(graph, on), far, reached(graph, on, 0)[5], reachable(graph, on, 2, 3, most: 2);
// expect: [true, [6, 6, 6, 6, 6, 6], false, false]
// expect: [true, [0, 6, 4, 1, 2, 3], true, false]
// expect: [true, [0, 1, 6, 1, 2, 3], true, false]
// expect: [true, [0, 1, 2, 6, 2, 3], true, false]
// expect: [true, [0, 1, 2, 1, 6, 3], true, false]
// expect: [true, [0, 1, 2, 1, 2, 6], false, false]
