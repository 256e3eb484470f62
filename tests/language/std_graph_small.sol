// Three nodes in a row: what is there hangs together, or does not.
import "std/graph.sol";
on = [flip() for i in 0..2];
return on, connected(graph_of(3, [[0, 1], [1, 2]]), on);
// expect: [[false, false, false], true]
// expect: [[true, false, false], true]
// expect: [[false, true, false], true]
// expect: [[false, false, true], true]
// expect: [[true, true, false], true]
// expect: [[false, true, true], true]
// expect: [[true, false, true], false]
// expect: [[true, true, true], true]
